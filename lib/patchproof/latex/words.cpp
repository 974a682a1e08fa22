#include <patchproof/latex/words.hpp>

#include <algorithm>
#include <array>

namespace patchproof {

namespace {

constexpr std::size_t language_count = 5;

struct Entry {
  Word word;
  /// English, Czech, Slovak, Slovenian, Russian.
  std::array<std::string, language_count> texts;
};

using enum Word;

// One line per word. A test looks that the order is that of Word, and that nothing is missing.
const std::vector<Entry>& table() {
  static const std::vector<Entry> entries{
      {book_title,
       {"Surface patches: statements and proofs", "Pláty ploch: tvrzení a důkazy",
        "Pláty plôch: tvrdenia a dôkazy", "Krpe ploskev: trditve in dokazi",
        "Порции поверхностей: утверждения и доказательства"}},
      {given, {"Given", "Dáno", "Dané", "Dano", "Дано"}},
      {definitions, {"Definitions", "Definice", "Definície", "Definicije", "Определения"}},
      {assumptions, {"Assumptions", "Předpoklady", "Predpoklady", "Predpostavke", "Предположения"}},
      {claim, {"Claim", "Tvrzení", "Tvrdenie", "Trditev", "Утверждение"}},
      {derivation, {"Derivation", "Odvození", "Odvodenie", "Izpeljava", "Вывод"}},
      {erratum, {"Erratum", "Oprava", "Oprava", "Popravek", "Опечатка"}},
      {errata, {"Errata", "Opravy", "Opravy", "Popravki", "Опечатки"}},
      {printed, {"Printed", "Vytištěno", "Vytlačené", "Natisnjeno", "Напечатано"}},
      {corrected, {"Correct", "Správně", "Správne", "Pravilno", "Следует читать"}},
      {note, {"Note", "Poznámka", "Poznámka", "Opomba", "Примечание"}},
      {verdicts, {"Verdicts", "Výsledky", "Výsledky", "Izidi", "Результаты проверки"}},
      {subject, {"Subject", "Téma", "Téma", "Tema", "Тема"}},
      {count, {"Claims", "Tvrzení", "Tvrdenia", "Trditve", "Утверждения"}},
      {total, {"Total", "Celkem", "Spolu", "Skupaj", "Всего"}},
      {source, {"Source", "Zdroj", "Zdroj", "Vir", "Источник"}},
      {section, {"section", "oddíl", "časť", "razdelek", "раздел"}},
      {example_values,
       {"example values for all that is left open", "ukázkové hodnoty pro vše, co je volné",
        "ukážkové hodnoty pre všetko, čo je voľné", "primerne vrednosti za vse, kar je prosto",
        "примерные значения для всего, что не задано"}},
      {assumed_later,
       {"assumed only after this claim", "předpokládá se až za tímto tvrzením",
        "predpokladá sa až za týmto tvrdením", "predpostavljeno šele po tej trditvi",
        "предполагается только после этого утверждения"}},
      {page, {"p.", "str.", "s.", "str.", "с."}},
      {by_machine,
       {"Every step was decided with exact arithmetic by",
        "Každý krok byl rozhodnut v přesné aritmetice programem",
        "Každý krok bol rozhodnutý v presnej aritmetike programom",
        "Vsak korak je v točni aritmetiki preveril program",
        "Каждый шаг проверен в точной арифметике программой"}},
      {point, {"point", "bod", "bod", "točka", "точка"}},
      {points, {"points", "body", "body", "točke", "точки"}},
      {scalar, {"number", "číslo", "číslo", "število", "число"}},
      {scalars, {"numbers", "čísla", "čísla", "števila", "числа"}},
      {parameter, {"parameter", "parametr", "parameter", "parameter", "параметр"}},
      {parameters, {"parameters", "parametry", "parametre", "parametri", "параметры"}},
      {curve, {"curve", "křivka", "krivka", "krivulja", "кривая"}},
      {curves, {"curves", "křivky", "krivky", "krivulje", "кривые"}},
      {patch, {"patch", "plát", "plát", "krpa", "порция поверхности"}},
      {patches, {"patches", "pláty", "pláty", "krpe", "порции поверхностей"}},
      {volume, {"volume", "těleso", "teleso", "telo", "тело"}},
      {volumes, {"volumes", "tělesa", "telesá", "telesa", "тела"}},
      {function, {"function", "funkce", "funkcia", "funkcija", "функция"}},
      {functions, {"functions", "funkce", "funkcie", "funkcije", "функции"}},
      {matrix, {"matrix", "matice", "matica", "matrika", "матрица"}},
      {matrices, {"matrices", "matice", "matice", "matrike", "матрицы"}},
      {by_definition,
       {"By definition", "Podle definice", "Podľa definície", "Po definiciji", "По определению"}},
      {we_compute, {"We compute", "Počítáme", "Počítame", "Računamo", "Вычисляем"}},
      {it_must_hold,
       {"It must hold that", "Musí platit", "Musí platiť", "Veljati mora", "Должно выполняться"}},
      {hence, {"Hence", "Odtud", "Odtiaľ", "Od tod", "Отсюда"}},
      {check, {"Check", "Zkouška", "Skúška", "Preizkus", "Проверка"}},
      {counterexample,
       {"Counterexample", "Protipříklad", "Kontrapríklad", "Protiprimer", "Контрпример"}},
      {variation,
       {"The difference of the two values is", "Rozdíl obou hodnot je", "Rozdiel oboch hodnôt je",
        "Razlika obeh vrednosti je", "Разность двух значений равна"}},
      {find, {"Find", "Hledáme", "Hľadáme", "Iščemo", "Найти"}},
      {such_that, {"such that", "tak, aby", "tak, aby", "tako da velja", "такие, что"}},
      {says_the_author,
       {"The stated solution is", "Uvedené řešení je", "Uvedené riešenie je", "Navedena rešitev je",
        "Указанное решение:"}},
      {no_solution,
       {"It is claimed that there is no solution.", "Tvrdí se, že řešení neexistuje.",
        "Tvrdí sa, že riešenie neexistuje.", "Trditev je, da rešitev ne obstaja.",
        "Утверждается, что решения нет."}},
      {left_open,
       {"Arbitrary:", "Libovolné zůstávají", "Ľubovoľné zostávajú", "Poljubni ostanejo",
        "Произвольными остаются"}},
      {minimizes,
       {"has the least value of the functional among all",
        "má nejmenší hodnotu funkcionálu mezi všemi",
        "má najmenšiu hodnotu funkcionálu medzi všetkými",
        "ima najmanjšo vrednost funkcionala med vsemi",
        "доставляет наименьшее значение функционала среди всех"}},
      {where, {"with", "pro které", "pre ktoré", "za katere velja", "для которых"}},
      {using_results, {"using", "s použitím", "s použitím", "z uporabo", "с использованием"}},
      {under_conditions,
       {"provided that", "za podmínky", "za podmienky", "pod pogojem", "при условии"}},
      {difference,
       {"left side minus right side", "levá strana minus pravá strana",
        "ľavá strana mínus pravá strana", "leva stran minus desna stran",
        "левая часть минус правая часть"}},
      {left_side, {"left side", "levá strana", "ľavá strana", "leva stran", "левая часть"}},
      {right_side, {"right side", "pravá strana", "pravá strana", "desna stran", "правая часть"}},
      {all_others_zero,
       {"everything else is 0", "vše ostatní je 0", "všetko ostatné je 0", "vse drugo je 0",
        "всё остальное равно 0"}},
      {any_values,
       {"any values", "libovolné hodnoty", "ľubovoľné hodnoty", "poljubne vrednosti",
        "любые значения"}},
      {assumptions_used,
       {"Assumptions used", "Použité předpoklady", "Použité predpoklady",
        "Uporabljene predpostavke", "Использованные предположения"}},
      {free_unknowns,
       {"Not determined:", "Neurčené zůstávají", "Neurčené zostávajú", "Nedoločeni ostanejo",
        "Неопределёнными остаются"}},
      {reason, {"Reason", "Důvod", "Dôvod", "Razlog", "Причина"}},
      {expected,
       {"The author expects", "Autor očekává", "Autor očakáva", "Avtor pričakuje",
        "Автор ожидает"}},
      {further_instances,
       {"Further instances, decided in the same way", "Další případy, rozhodnuté stejně",
        "Ďalšie prípady, rozhodnuté rovnako", "Nadaljnji primeri, obravnavani enako",
        "Остальные случаи, рассмотренные так же"}},
      {reason_definition, {"definition of", "definice", "definícia", "definicija", "определение"}},
      {reason_derivative, {"derivatives", "derivace", "derivácie", "odvodi", "производные"}},
      {reason_arithmetic, {"arithmetic", "úprava", "úprava", "poenostavitev", "преобразование"}},
      {reason_assumption,
       {"assumption", "předpoklad", "predpoklad", "predpostavka", "предположение"}},
      {reason_derived, {"by", "podle", "podľa", "po", "согласно"}},
      {reason_collected,
       {"expanded and collected", "roznásobeno a sečteno", "roznásobené a sčítané",
        "razvito in urejeno", "раскрыто и приведено"}},
      {reason_value,
       {"values put in", "dosazení hodnot", "dosadenie hodnôt", "vstavljene vrednosti",
        "подстановка значений"}},
      {reason_integration,
       {"integration", "integrace", "integrovanie", "integriranje", "интегрирование"}},
      {proved, {"proved", "dokázáno", "dokázané", "dokazano", "доказано"}},
      {proved_if,
       {"proved if", "dokázáno za podmínky", "dokázané za podmienky", "dokazano pod pogojem",
        "доказано при условии"}},
      {refuted, {"refuted", "vyvráceno", "vyvrátené", "ovrženo", "опровергнуто"}},
      {vacuous,
       {"contradictory assumptions", "předpoklady si odporují", "predpoklady si odporujú",
        "predpostavke so protislovne", "предположения противоречивы"}},
      {underdetermined,
       {"underdetermined", "není určeno jednoznačně", "nie je určené jednoznačne",
        "ni enolično določeno", "определено неоднозначно"}},
      {inconsistent, {"no solution", "nemá řešení", "nemá riešenie", "ni rešitve", "нет решения"}},
      {unknown,
       {"unknown: not decided", "neznámo: nerozhodnuto", "neznáme: nerozhodnuté",
        "neznano: ni odločeno", "неизвестно: не решено"}},
      {error, {"has no meaning", "nemá smysl", "nemá zmysel", "nima pomena", "не имеет смысла"}},
      {internal,
       {"fault of the program", "chyba programu", "chyba programu", "napaka programa",
        "ошибка программы"}},
      {both_engines,
       {"both engines", "oba výpočetní systémy", "oba výpočtové systémy", "oba računska sistema",
        "обе системы"}},
      {kernel_only, {"kernel only", "jen jádro", "len jadro", "samo jedro", "только ядро"}},
      {certified, {"certified by Rocq", "ověřeno v Rocq", "overené v Rocq", "overjeno z Rocqom",
                   "проверено в Rocq"}},
  };
  return entries;
}

constexpr std::array<Language, language_count> languages{
    Language::english, Language::czech, Language::slovak, Language::slovenian, Language::russian};

std::size_t index_of(Language language) { return static_cast<std::size_t>(language); }

}  // namespace

const std::string& word(Word word, Language language) {
  return table().at(static_cast<std::size_t>(word)).texts.at(index_of(language));
}

const std::vector<std::string>& language_codes() {
  static const std::vector<std::string> codes{"en", "cs", "sk", "sl", "ru"};
  return codes;
}

std::optional<Language> language_of(std::string_view code) {
  const auto& codes = language_codes();
  const auto found = std::find(codes.begin(), codes.end(), code);
  if (found == codes.end()) return std::nullopt;
  return languages.at(static_cast<std::size_t>(found - codes.begin()));
}

std::string code_of(Language language) { return language_codes().at(index_of(language)); }

std::string babel_name(Language language) {
  static const std::array<std::string, language_count> names{"english", "czech", "slovak",
                                                             "slovene", "russian"};
  return names.at(index_of(language));
}

Word word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
      return proved;
    case Verdict::proved_if:
      return proved_if;
    case Verdict::refuted:
      return refuted;
    case Verdict::vacuous:
      return vacuous;
    case Verdict::underdetermined:
      return underdetermined;
    case Verdict::inconsistent:
      return inconsistent;
    case Verdict::unknown:
      return unknown;
    case Verdict::error:
      return error;
    default:
      return internal;
  }
}

Word word_of(Expectation expectation) {
  switch (expectation) {
    case Expectation::prove:
      return proved;
    case Expectation::refute:
      return refuted;
    case Expectation::open:
      return unknown;
    default:
      return inconsistent;
  }
}

}  // namespace patchproof
