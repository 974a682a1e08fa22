// One statement of a case: what is said about the case here, declarations and claims elsewhere.
//
//   title STRING [ lang NAME ] | quote STRING | tags NAME {, NAME} | show ( expression | joint )
//   source STRING { lang NAME | section STRING | page ( NUMBER | STRING ) }
//   notation ( NAME = STRING {, NAME = STRING} | derivatives ( subscript | superscript | fraction ) )
//   limit ( time | memory | terms | steps ) NUMBER [ s | ms | MB | GB ]

#include <algorithm>
#include <array>
#include <utility>

#include <patchproof/language/grammar.hpp>
#include <patchproof/language/nearest_name.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Statement;
using Kind = Statement::Kind;

Kind kind_of(std::string_view keyword) {
  static constexpr std::array<std::pair<std::string_view, Kind>, 24> table{{
      {"title", Kind::title},   {"source", Kind::source}, {"quote", Kind::quote},
      {"tags", Kind::tags},     {"limit", Kind::limit},   {"notation", Kind::notation},
      {"param", Kind::parameter},
      {"scalar", Kind::scalar}, {"point", Kind::point},   {"curve", Kind::curve},
      {"patch", Kind::patch},   {"volume", Kind::volume}, {"matrix", Kind::matrix}, {"net", Kind::net},
      {"spline", Kind::spline}, {"let", Kind::let},       {"assume", Kind::assume},
      {"family", Kind::family}, {"prove", Kind::prove},   {"refute", Kind::refute},
      {"open", Kind::open},     {"derive", Kind::derive}, {"erratum", Kind::erratum},
      {"show", Kind::show},
  }};
  for (const auto& [word, kind] : table) {
    if (word == keyword) return kind;
  }
  return Kind::title;  // not reached: the caller has looked the keyword up
}

void source_of_case(TokenStream& stream, Statement& statement) {
  statement.text = stream.quoted_text();
  while (true) {
    const Token& word = stream.token();
    const bool is_second = (stream.is("lang") && statement.language) ||
                           (stream.is("section") && statement.section) ||
                           (stream.is("page") && statement.page);
    if (is_second) stream.fail(stream.span(word), shown(stream, word) + " given twice");
    if (stream.accept("lang")) {
      statement.language = stream.any_word("a language");
    } else if (stream.accept("section")) {
      statement.section = stream.quoted_text();
    } else if (stream.accept("page")) {
      if (stream.is(Token::Kind::number)) {
        statement.page = std::string(stream.text());
        stream.advance();
      } else {
        statement.page = stream.quoted_text();
      }
    } else {
      return;
    }
  }
}

void notation(TokenStream& stream, Statement& statement) {
  if (stream.accept("derivatives")) {
    const std::vector<std::string> styles{"subscript", "superscript", "fraction"};
    const bool known = std::any_of(styles.begin(), styles.end(),
                                   [&](const std::string& style) { return stream.is(style); });
    if (!known) {
      stream.fail_expected("'subscript', 'superscript' or 'fraction'",
                           did_you_mean(stream.text(), styles));
    }
    statement.derivative_style = stream.any_word("a style");
    return;
  }
  do {
    syntax::Notation entry;
    entry.name = stream.any_word("a name");
    stream.expect("=");
    entry.span = stream.span(stream.token());
    entry.latex = stream.quoted_text();
    ++entry.span.begin;
    --entry.span.end;
    statement.notations.push_back(std::move(entry));
  } while (stream.accept(","));
}

void limit(TokenStream& stream, Statement& statement) {
  const bool is_time = stream.is("time");
  const bool is_memory = stream.is("memory");
  if (!is_time && !is_memory && !stream.is("terms") && !stream.is("steps")) {
    stream.fail_expected("'time', 'memory', 'terms' or 'steps'",
                         did_you_mean(stream.text(), {"time", "memory", "terms", "steps"}));
  }
  statement.limit_kind = stream.any_word("a limit");
  if (!stream.is(Token::Kind::number)) stream.fail_expected("a number");
  statement.limit_value = number_from_text(stream.text());
  stream.advance();
  if (stream.token().first_on_line) return;
  const bool is_unit = (is_time && (stream.is("s") || stream.is("ms"))) ||
                       (is_memory && (stream.is("MB") || stream.is("GB")));
  if (is_unit) {
    statement.limit_unit = stream.any_word("a unit");
  } else if (is_time || is_memory) {
    stream.fail_expected(is_time ? "'s' or 'ms'" : "'MB' or 'GB'");
  }
}

void contents(TokenStream& stream, Statement& statement) {
  switch (statement.kind) {
    case Kind::title:
      statement.text = stream.quoted_text();
      if (stream.accept("lang")) statement.language = stream.any_word("a language");
      return;
    case Kind::quote:
      statement.text = stream.quoted_text();
      return;
    case Kind::source:
      return source_of_case(stream, statement);
    case Kind::tags:
      do {
        statement.tags.push_back(stream.any_word("a tag"));
      } while (stream.accept(","));
      return;
    case Kind::notation:
      return notation(stream, statement);
    case Kind::limit:
      return limit(stream, statement);
    case Kind::show:
      return show(stream, statement);
    case Kind::assume:
      return assumption(stream, statement);
    case Kind::prove:
    case Kind::refute:
    case Kind::open:
    case Kind::derive:
    case Kind::erratum:
      return claim(stream, statement);
    default:
      return declaration(stream, statement);
  }
}

}  // namespace

std::optional<Statement> statement(TokenStream& stream, std::string_view keyword) {
  Statement result;
  result.kind = kind_of(keyword);
  result.keyword = stream.span(stream.token());
  // Until an erratum has had its 'end', the next one belongs to it and not to the case.
  bool is_closed = result.kind != Kind::erratum;
  try {
    stream.count_statement();
    stream.advance();
    contents(stream, result);
    is_closed = true;
    result.span = stream.span_from(result.keyword.begin);
    stream.expect_end_of_statement();
  } catch (const SyntaxError&) {
    stream.skip_to_statement();
    if (!is_closed && stream.is("end")) stream.advance();
    return std::nullopt;
  }
  return result;
}

}  // namespace patchproof::grammar
