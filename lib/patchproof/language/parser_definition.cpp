// Definitions:
//
//   define NAME [ "(" formals ")" ] ":" type { title | source | quote | let } "=" expression end
//   formals = NAME {, NAME} ":" type {, formals}

#include <patchproof/language/grammar.hpp>
#include <patchproof/language/keywords.hpp>
#include <patchproof/language/nearest_name.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Definition;
using syntax::FormalType;
using Kind = FormalType::Kind;

FormalType type(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  FormalType result;
  if (stream.accept("scalar")) {
    result.kind = stream.accept("function") ? Kind::scalar_function : Kind::scalar;
  } else if (stream.accept("point")) {
    result.kind = Kind::point;
  } else if (stream.is("curve") || stream.is("patch") || stream.is("volume")) {
    result.kind = stream.is("curve") ? Kind::curve : stream.is("patch") ? Kind::patch : Kind::volume;
    stream.any_word("a type");
    const std::size_t open = stream.token().begin;
    result.parameters = formal_parameters(stream);
    const std::size_t needed = result.kind == Kind::curve ? 1 : result.kind == Kind::patch ? 2 : 3;
    if (result.parameters.size() != needed) {
      stream.fail(stream.span_from(open), needed == 1   ? "a curve has one parameter"
                                          : needed == 2 ? "a patch has two parameters"
                                                        : "a volume has three parameters");
    }
  } else if (stream.accept("net")) {
    result.kind = Kind::net;
  } else if (stream.accept("matrix")) {
    result.kind = Kind::matrix;
  } else if (stream.accept("list")) {
    result.kind = Kind::list;
  } else if (stream.accept("spline")) {
    result.kind = Kind::spline;
  } else {
    std::string help =
        did_you_mean(stream.text(), {"scalar", "point", "curve", "patch", "volume", "net", "matrix",
                                     "list", "spline"});
    if (help.empty()) {
      help =
          "types are scalar, scalar function, point, curve(u), patch(u, v), volume(u, v, w), net, "
          "matrix, list and spline";
    }
    stream.fail_expected("a type", std::move(help));
  }
  result.span = stream.span_from(begin);
  return result;
}

void formals(TokenStream& stream, Definition& definition) {
  do {
    std::vector<syntax::Name> names = stream.names();
    stream.expect(":");
    const FormalType common = type(stream);
    for (syntax::Name& name : names) {
      if (common.kind == Kind::scalar) stream.variables.insert(name.text);
      definition.formals.push_back({std::move(name), common});
    }
  } while (stream.accept(","));
}

void head(TokenStream& stream, Definition& definition) {
  definition.name = stream.name("a name for the definition");
  if (stream.accept("(") && !stream.accept(")")) {
    formals(stream, definition);
    if (!stream.accept(")")) stream.fail_expected("',' or ')'");
  }
  if (!stream.is(":")) stream.fail_expected("':' and the type of the result");
  stream.advance();
  definition.result = type(stream);
  if (!stream.is("=")) stream.expect_end_of_statement();
}

bool belongs_here(std::string_view keyword) {
  return keyword == "title" || keyword == "source" || keyword == "quote" || keyword == "let";
}

/// Everything between the head and the value.
/// @throws SyntaxError after the first mistake.
void statements(TokenStream& stream, Definition& definition) {
  while (stream.at_statement() && !stream.at_file_item() && !stream.is("end")) {
    const Token keyword = stream.token();
    const bool belongs = belongs_here(stream.text());
    if (!belongs) {
      stream.report(stream.span(keyword),
                    shown(stream, keyword) + " does not belong in a definition");
      stream.silent = true;
    }
    std::optional<syntax::Statement> read = statement(stream, stream.text(keyword));
    stream.silent = false;
    if (!belongs || !read) throw SyntaxError{};
    definition.statements.push_back(std::move(*read));
  }
}

void value(TokenStream& stream, Definition& definition) {
  if (!stream.is("=") && stream.is(Token::Kind::name) && !stream.at_statement()) {
    std::vector<std::string> known{"title", "source", "quote", "let", "end"};
    stream.fail_expected("a statement or '='", did_you_mean(stream.text(), known));
  }
  if (!stream.is("=")) stream.fail_expected("'=' and the value");
  stream.advance();
  definition.value = expression(stream);
  stream.expect_end_of_statement();
  if (!stream.at_statement()) stream.fail_expected("'end'");
}

/// After a mistake: past all statements of the definition.
void skip_to_end(TokenStream& stream) {
  stream.skip_to_statement();
  while (!stream.at_file_item() && !stream.is("end")) {
    stream.advance();
    stream.skip_to_statement();
  }
}

}  // namespace

Definition definition(TokenStream& stream) {
  const Token keyword = stream.token();
  Definition result;
  stream.variables.clear();
  stream.advance();
  try {
    head(stream, result);
    statements(stream, result);
    value(stream, result);
    if (!stream.is("end") && !stream.at_file_item()) {
      stream.fail(stream.span(stream.token()),
                  shown(stream, stream.token()) + " does not belong behind the value");
    }
  } catch (const SyntaxError&) {
    skip_to_end(stream);
  }
  if (stream.is("end") && stream.at_statement()) {
    stream.advance();
  } else if (!stream.saw_inline_end()) {
    stream.report(stream.span(keyword), "definition '" + result.name.text + "' has no 'end'");
  }
  result.span = stream.span_from(keyword.begin);
  return result;
}

}  // namespace patchproof::grammar
