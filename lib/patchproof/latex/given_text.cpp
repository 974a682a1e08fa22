#include <patchproof/latex/given_text.hpp>

#include <cctype>
#include <map>
#include <optional>
#include <utility>

#include <patchproof/latex/line_breaks.hpp>
#include <patchproof/latex/prose.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

/// The word for one, and for several.
using Nouns = std::pair<Word, Word>;

Nouns nouns_of(const Declaration& declaration) {
  static const std::map<std::string, Nouns> table{
      {"point", {Word::point, Word::points}},        {"scalar", {Word::scalar, Word::scalars}},
      {"curve", {Word::curve, Word::curves}},        {"patch", {Word::patch, Word::patches}},
      {"volume", {Word::volume, Word::volumes}},     {"matrix", {Word::matrix, Word::matrices}},
      {"param", {Word::parameter, Word::parameters}}};
  const bool function = declaration.keyword == "scalar" && declaration.term.type().is_function();
  if (function) return {Word::function, Word::functions};
  const auto found = table.find(declaration.keyword);
  return found == table.end() ? Nouns{Word::function, Word::functions} : found->second;
}

const ParameterRange* range_of(const Case& given, const Symbol& parameter) {
  for (const Claim& claim : given.claims)
    for (const ParameterRange& range : goal_of(claim).ranges)
      if (range.parameter->ordinal == parameter.ordinal) return &range;
  return nullptr;
}

std::vector<std::string> indices_of(const Term& entry) {
  std::vector<std::string> indices;
  if (entry.operation() != Operation::symbol) return indices;
  const std::string& name = entry.symbol()->name;
  std::size_t at = name.find('[');
  while (at != std::string::npos && at + 1 < name.size()) {
    const std::size_t end = name.find_first_of(",]", at + 1);
    indices.push_back(name.substr(at + 1, end - at - 1));
    at = end;
  }
  return indices;
}

// V_{ij}, i, j = 0, ..., 3
std::string array_text(const std::string& name, const Term& array, const Wording& wording) {
  const auto first = indices_of(array.children().front());
  const auto last = indices_of(array.children().back());
  LatexName letters = latex_name(name, wording.names.notation);
  const std::string index = first.size() < 2 ? "i" : "ij";
  letters.index += (letters.index.empty() ? "" : ",") + index;
  std::string text = "$" + letters.text() + "$";
  const auto range = [&](std::size_t k) {
    return first.at(k) == last.at(k) ? first.at(k)
           : std::stol(last.at(k)) == std::stol(first.at(k)) + 1
               ? first.at(k) + ",\\," + last.at(k)
               : first.at(k) + ",\\dots," + last.at(k);
  };
  if (first.size() == 1) return text + " ($i=" + range(0) + "$)";
  if (range(0) == range(1)) return text + " ($i,j=" + range(0) + "$)";
  return text + " ($i=" + range(0) + "$; $j=" + range(1) + "$)";
}

std::string space_text(const Type& type) {
  const Type& value = type.is_function() || type.is_matrix() ? *type.inner : type;
  if (!value.is_point() || value.dimension == Type::any_dimension) return "";
  return "\\mathbf{R}^{" + std::to_string(value.dimension) + "}";
}

std::string entry_text(const Case& given, const Declaration& declaration, const Wording& wording) {
  const Term& term = declaration.term;
  if (term.operation() == Operation::matrix && !indices_of(term.children().front()).empty())
    return array_text(declaration.name, term, wording);
  if (term.operation() == Operation::lambda) {
    // Of a given degree: its coefficients are what is given.
    std::string text = latex_name(declaration.name, wording.names.notation).text() + "(";
    for (const SymbolPointer& formal : term.formals())
      text += (text.back() == '(' ? "" : ",") +
              latex_name(formal->name, wording.names.notation).text();
    return "$" + text + ")$";
  }
  if (term.operation() != Operation::symbol)
    return "$" + latex_name(declaration.name, wording.names.notation).text() + "$";
  const Symbol& symbol = *term.symbol();
  std::string text = symbol_text(symbol, wording);
  const std::string space = space_text(term.type());
  const bool smooth = symbol.role == Symbol::Role::function && symbol.smoothness > 0;
  if (smooth)
    text += " \\in C^{" + std::to_string(symbol.smoothness) + "}" +
            (space.empty() ? "" : "(" + space + ")");
  else if (!space.empty())
    text += " \\in " + space;
  if (declaration.keyword == "param")
    if (const ParameterRange* range = range_of(given, symbol))
      text += " \\in [" + to_latex(range->lower, wording.names) + "," +
              to_latex(range->upper, wording.names) + "]";
  return "$" + text + "$";
}

}  // namespace

const Goal& goal_of(const Claim& claim) {
  if (const auto* derive = std::get_if<DeriveClaim>(&claim.kind)) return derive->goal.goal;
  if (const auto* minimum = std::get_if<MinimumClaim>(&claim.kind)) return minimum->goal.goal;
  return std::get<IdentityClaim>(claim.kind).goal;
}

std::string given_text(const Case& given, const Wording& wording) {
  // In the order of the text; what is of one kind is said together.
  std::vector<std::pair<Nouns, std::vector<std::string>>> groups;
  std::optional<std::string> instance;
  for (const Declaration& declaration : given.declarations) {
    if (!instance) instance = declaration.instance;
    if (!declaration.given || declaration.instance != *instance) continue;
    const Nouns nouns = nouns_of(declaration);
    std::vector<std::string>* group = nullptr;
    for (auto& [known, entries] : groups)
      if (known == nouns) group = &entries;
    if (group == nullptr) group = &groups.emplace_back(nouns, std::vector<std::string>{}).second;
    group->push_back(entry_text(given, declaration, wording));
  }
  if (groups.empty()) return "";
  std::string text = "\\ppheading{" + wording(Word::given);
  if (!instance->empty()) text += " \\textmd{\\ppname{" + latex_escaped(*instance) + "}}";
  text += "}\n";
  for (const auto& [nouns, entries] : groups) {
    // An array is several.
    const bool several = entries.size() > 1 || entries.front().find("($i") != std::string::npos;
    text += "\\ppitem{" + wording(several ? nouns.second : nouns.first) + " ";
    for (std::size_t k = 0; k < entries.size(); ++k) text += (k > 0 ? ", " : "") + entries[k];
    text += "}\n";
  }
  return text;
}

std::string assumptions_text(const Case& given, const Wording& wording) {
  std::string text;
  for (const WrittenAssumption& written : given.assumptions) {
    // Claims above an assumption do not know of it.
    const Goal* goal = nullptr;
    for (const Claim& claim : given.claims)
      if (goal == nullptr && goal_of(claim).assumptions.size() >= written.first + written.count)
        goal = &goal_of(claim);
    if (goal == nullptr) continue;
    std::vector<Statement> statements;
    for (std::size_t k = 0; k < written.count; ++k)
      statements.push_back(goal->assumptions[written.first + k].statement);
    if (!written.label.empty())
      text += "\\pptext{\\pplabel{" + latex_escaped(written.label) + "}}\n";
    text += relations_text(statements, wording);
    if (!written.note.empty())
      text += "\\pptext{" + wording(Word::note) + ": " + prose(written.note) + "}\n";
  }
  if (text.empty()) return "";
  return "\\ppheading{" + wording(Word::assumptions) + "}\n" + text;
}

std::string later_assumptions_text(const Case& given, const Claim& claim,
                                   const Wording& wording) {
  std::string labels;
  for (std::size_t k = 0; k < given.assumptions.size(); ++k) {
    const WrittenAssumption& written = given.assumptions[k];
    if (goal_of(claim).assumptions.size() >= written.first + written.count) continue;
    const std::string name = written.label.empty() ? std::to_string(k + 1) : written.label;
    labels += (labels.empty() ? "" : ", ") + std::string{"\\pplabel{"} + latex_escaped(name) + "}";
  }
  if (labels.empty()) return "";
  return "\\pptext{(" + wording(Word::assumed_later) + ": " + labels + ")}\n";
}

std::string title_text(const Case& given, Language language) {
  const auto own = given.translated_titles.find(code_of(language));
  if (own != given.translated_titles.end()) return prose(own->second);
  return prose(given.title.empty() ? given.name : given.title);
}

}  // namespace patchproof
