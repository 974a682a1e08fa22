// Files and cases:
//
//   file = { include STRING | definition | case }
//   case = case NAME { "." NAME } { statement } end

#include <map>

#include <patchproof/language/grammar.hpp>
#include <patchproof/language/keywords.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/language/parser.hpp>

namespace patchproof {
namespace {

using grammar::statement;
using syntax::Case;
using syntax::Statement;

/// The labels of one case, each with the line of its statement.
using Labels = std::map<std::string, std::uint32_t>;

syntax::Name path(TokenStream& stream) {
  syntax::Name result = stream.any_word("a name for the case");
  while (stream.accept(".")) {
    // Parts after the first may be numbers: cz.twist.00.
    if (stream.is(Token::Kind::number)) {
      result.text += "." + std::string(stream.text());
      stream.advance();
    } else {
      result.text += "." + stream.any_word("a name after '.'").text;
    }
  }
  result.span = stream.span_from(result.span.begin);
  return result;
}

void read_statement(TokenStream& stream, Case& result, Labels& labels) {
  const std::uint32_t line = stream.token().line;
  std::optional<Statement> read = statement(stream, stream.text());
  if (!read) return;
  if (read->label) {
    const std::string& label = read->label->text;
    const auto [first, is_new] = labels.emplace(label, line);
    if (!is_new) {
      stream.report(read->keyword, "label '" + label + "' used twice (first on line " +
                                       std::to_string(first->second) + ")");
    }
  }
  result.statements.push_back(std::move(*read));
}

/// Something that begins no statement. Returns whether it is a misspelt `end`.
bool refuse_statement(TokenStream& stream) {
  const Token found = stream.token();
  if (found.kind == Token::Kind::bad) {
    stream.skip_to_statement();
    return false;
  }
  std::vector<std::string> known = statement_keywords();
  known.insert(known.end(), inner_keywords().begin(), inner_keywords().end());
  const std::string near =
      found.kind == Token::Kind::name ? nearest_name(stream.text(), known) : "";
  const bool is_inner = is_inner_keyword(near);
  const std::string help =
      near.empty() || near == stream.text() ? "" : "did you mean '" + near + "'?";
  stream.report(stream.span(found), "expected a statement, found " + shown(stream, found), help);
  if (near == "end" && stream.token(1).first_on_line) {
    stream.advance();
    return true;
  }
  if (near.empty() || near == "end" || is_inner) {
    stream.skip_to_statement();
    return false;
  }
  // Read as what was meant, so that an erratum takes its own 'end' with it.
  const bool was_silent = stream.silent;
  stream.silent = true;
  statement(stream, near);
  stream.silent = was_silent;
  return false;
}

/// Statements up to `end`. Returns whether there is one.
bool read_statements(TokenStream& stream, Case& result) {
  Labels labels;
  while (true) {
    if (!stream.at_statement()) {
      if (refuse_statement(stream)) return true;
    } else if (stream.is("end")) {
      stream.advance();
      return true;
    } else if (stream.is("include")) {
      stream.report(stream.span(stream.token()), "'include' does not belong in a case",
                    "write it before the first case");
      stream.advance();
      stream.skip_to_statement();
    } else if (stream.at_file_item()) {
      return false;
    } else {
      read_statement(stream, result, labels);
    }
  }
}

Case read_case(TokenStream& stream) {
  const Token keyword = stream.token();
  Case result;
  stream.variables.clear();
  stream.advance();
  try {
    result.name = path(stream);
    stream.expect_end_of_statement();
  } catch (const SyntaxError&) {
    stream.skip_to_statement();
  }
  if (!read_statements(stream, result) && !stream.saw_inline_end()) {
    const std::string name = result.name.text.empty() ? "case" : "case '" + result.name.text + "'";
    stream.report(stream.span(keyword), name + " has no 'end'");
  }
  result.span = stream.span_from(keyword.begin);
  return result;
}

/// An `include`, a definition or a case, read as if `keyword` came next.
void read_item(TokenStream& stream, std::string_view keyword, syntax::File& file) {
  const Token first = stream.token();
  try {
    if (keyword == "case") {
      file.cases.push_back(read_case(stream));
    } else if (keyword == "define") {
      file.definitions.push_back(grammar::definition(stream));
    } else {
      stream.advance();
      std::string included = stream.quoted_text();
      file.includes.push_back({std::move(included), stream.span_from(first.begin)});
    }
    stream.expect_end_of_statement();
  } catch (const SyntaxError&) {
    stream.skip_to_file_item();
  }
}

/// Something that begins neither a case nor a definition.
void refuse_item(TokenStream& stream, syntax::File& file) {
  const Token found = stream.token();
  if (found.kind == Token::Kind::bad) {
    stream.skip_to_file_item();
    return;
  }
  const bool is_name = found.kind == Token::Kind::name;
  const std::string near = is_name ? nearest_name(stream.text(), file_keywords()) : "";
  std::string help;
  if (stream.at_statement()) {
    help = "statements stand between 'case NAME' and 'end'";
  } else if (!near.empty()) {
    help = "did you mean '" + near + "'?";
  }
  stream.report(stream.span(found),
                "expected 'case', 'define' or 'include', found " + shown(stream, found), help);
  if (near.empty() || stream.at_statement()) {
    stream.skip_to_file_item();
  } else {
    read_item(stream, near, file);
  }
}

}  // namespace

Parsed parse(std::shared_ptr<const SourceText> source) {
  Parsed result;
  result.file.source = source;
  Lexed lexed = tokens_of(source);
  result.diagnostics = std::move(lexed.diagnostics);
  if (!lexed.readable) return result;
  TokenStream stream(source, lexed.tokens);
  while (!stream.at_end()) {
    if (stream.at_file_item()) {
      read_item(stream, std::string(stream.text()), result.file);
    } else {
      refuse_item(stream, result.file);
    }
  }
  for (Diagnostic& diagnostic : stream.take_diagnostics()) {
    result.diagnostics.push_back(std::move(diagnostic));
  }
  result.diagnostics = in_order(std::move(result.diagnostics));
  return result;
}

}  // namespace patchproof
