#include <patchproof/repair/line.hpp>

#include <patchproof/language/lexer.hpp>
#include <patchproof/language/parser.hpp>

namespace patchproof {

namespace {

// A statement is read inside of a case.
const std::string before = "case a\n  prove a: ";
const std::string after = "\nend\n";

}  // namespace

std::size_t Line::begin_of(const Span& span) { return span.begin - before.size(); }
std::size_t Line::end_of(const Span& span) { return span.end - before.size(); }

std::string Line::text_of(const Span& span) const {
  return text.substr(begin_of(span), span.end - span.begin);
}

std::optional<Line> line_of(const std::string& text) {
  const auto source = std::make_shared<const SourceText>(SourceText{"", before + text + after});
  const Parsed parsed = parse(source);
  if (!parsed.diagnostics.empty() || parsed.file.cases.size() != 1) return std::nullopt;
  const std::vector<syntax::Statement>& statements = parsed.file.cases.front().statements;
  if (statements.size() != 1) return std::nullopt;
  const syntax::Proposition& proposition = statements.front().proposition;
  if (Line::begin_of(proposition.span) != 0 || Line::end_of(proposition.span) != text.size())
    return std::nullopt;
  return Line{text, proposition};
}

std::string in_one_line(const Span& span) {
  const auto source = std::make_shared<const SourceText>(
      SourceText{"", span.source->text.substr(span.begin, span.end - span.begin)});
  std::string result;
  std::size_t end = 0;
  for (const Token& token : tokens_of(source).tokens) {
    if (token.kind == Token::Kind::end) break;
    if (!result.empty() && token.begin > end) result += ' ';
    result += source->text.substr(token.begin, token.end - token.begin);
    end = token.end;
  }
  return result;
}

}  // namespace patchproof
