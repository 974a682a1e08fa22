#include <patchproof/language/builtin_splines.hpp>

#include <patchproof/language/spline_changes.hpp>

namespace patchproof {

namespace {

int span_number(const Spline& spline, std::size_t direction, long wanted, const Span& span) {
  const std::vector<int> spans = spans_of(spline.knots[direction], spline.degrees[direction]);
  if (wanted < 0 || wanted >= static_cast<long>(spans.size()))
    throw Fault{span, "this spline has the segments 0.." + std::to_string(spans.size() - 1) +
                          " in this direction, not " + std::to_string(wanted)};
  return spans[static_cast<std::size_t>(wanted)];
}

// The basis functions span-degree, …, span on one interval, at the local parameter t.
std::vector<Term> basis(const Spline& spline, std::size_t direction, int span, const Term& t,
                        Elaborator& elaborator, const Span& where) {
  const Knots& knots = spline.knots[direction];
  const int degree = spline.degrees[direction];
  Construction& construct = elaborator.construct();
  if (are_numbers(knots)) {
    std::vector<Term> result;
    const std::vector<Rational> numbers = numbers_of(knots);
    for (int i = span - degree; i <= span; ++i)
      result.push_back(construct.make(Operation::bspline_basis, Type::scalar(), {t},
                                      BasisFunction{degree, i, span, numbers}, where));
    return result;
  }
  KnotArithmetic arithmetic{construct, where};
  const Term rest = construct.sum(Scope{}, {number_term(1, where), t}, "+-", where);
  const Term x = arithmetic.sum(arithmetic.product(rest, knots[static_cast<std::size_t>(span)]),
                                arithmetic.product(t, knots[static_cast<std::size_t>(span) + 1]));
  return blossom(knots, degree, span, std::vector<Term>(static_cast<std::size_t>(degree), x),
                 elaborator.workshop(), construct, where);
}

// The value of one piece at local parameters.
Term piece(const Spline& spline, const std::vector<int>& spans, const std::vector<Term>& t,
           Elaborator& elaborator, const Span& where) {
  Construction& construct = elaborator.construct();
  std::vector<std::vector<Term>> bases;
  for (std::size_t k = 0; k < spans.size(); ++k)
    bases.push_back(basis(spline, k, spans[k], t[k], elaborator, where));
  const auto total = [&](bool weights_only) {
    std::vector<Term> parts;
    const auto add = [&](std::vector<Term> factors, const std::vector<int>& index) {
      if (spline.weights) factors.push_back(construct.entry(spline.weights, index, where));
      if (!weights_only) factors.push_back(construct.entry(spline.control_points, index, where));
      const std::string signs(factors.size(), '*');
      parts.push_back(construct.product(Scope{}, std::move(factors), signs, where));
    };
    for (int i = 0; i <= spline.degrees[0]; ++i) {
      const int row = spans[0] - spline.degrees[0] + i;
      const Term& first = bases[0][static_cast<std::size_t>(i)];
      if (spans.size() == 1) {
        add({first}, {row});
        continue;
      }
      for (int j = 0; j <= spline.degrees[1]; ++j)
        add({first, bases[1][static_cast<std::size_t>(j)]},
            {row, spans[1] - spline.degrees[1] + j});
    }
    const std::string signs(parts.size(), '+');
    return construct.sum(Scope{}, std::move(parts), signs, where);
  };
  const Term value = total(false);
  return spline.weights ? construct.product(Scope{}, {value, total(true)}, "*/", where) : value;
}

std::string usage(const std::string& name, const char* arguments, const char* surface_arguments) {
  return name + "(" + arguments + ") of a curve, " + name + "(" + surface_arguments +
         ") of a surface";
}

}  // namespace

std::size_t direction_of(const Spline& spline, const syntax::Expression& call, std::size_t others,
                         const char* arguments, const char* surface_arguments) {
  const std::string& name = call.operands.front()->text;
  const std::string help = usage(name, arguments, surface_arguments);
  if (spline.directions() == 1) {
    if (call.arguments.size() != 1 + others)
      throw Fault{call.span, "a spline curve has one direction, which is not named", help};
    return 0;
  }
  if (call.arguments.size() != 2 + others)
    throw Fault{call.span, "a spline surface has two directions, u and v", help};
  const syntax::ExpressionPointer& direction = call.arguments[1].value;
  const bool named = direction && direction->kind == syntax::Expression::Kind::name;
  if (named && direction->text == "u") return 0;
  if (named && direction->text == "v") return 1;
  throw Fault{direction ? direction->span : call.span, "a direction is u or v", help};
}

// How the call is written, with running indices as the numbers they are.
std::string written_call(const std::string& name, const syntax::Expression& call,
                         const std::vector<long>& numbers) {
  const Span& span = call.arguments[0].value->span;
  std::string text = name + "(" + span.source->text.substr(span.begin, span.end - span.begin);
  for (const long number : numbers) text += ", " + std::to_string(number);
  return text + ")";
}

Term segment(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  Construction& construct = elaborator.construct();
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  const std::size_t directions = spline.directions();
  if (call.arguments.size() != directions + 1)
    throw Fault{call.span,
                directions == 1 ? "a spline curve has one segment number"
                                : "a spline surface has two segment numbers",
                directions == 1 ? "segment(T, i)" : "segment(T, i, j)"};
  std::vector<int> spans;
  std::vector<long> numbers;
  for (std::size_t k = 0; k < directions; ++k) {
    if (!call.arguments[k + 1].value) throw Fault{call.span, "a segment number cannot run"};
    const Term number = elaborator.expression(*call.arguments[k + 1].value, scope);
    numbers.push_back(construct.whole_number(number, "a segment number"));
    spans.push_back(span_number(spline, k, numbers.back(), call.span));
  }
  const std::vector<std::string> names =
      directions == 1 ? std::vector<std::string>{"t"} : std::vector<std::string>{"u", "v"};
  const Term function = construct.function(names, call.span, [&](const std::vector<Term>& t) {
    return piece(spline, spans, t, elaborator, call.span);
  });
  return construct.definition(written_call("segment", call, numbers), function, {}, call.span);
}

Term bezier_net(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  return elaborator.construct().definition(
      written_call("bezier_net", call, {}), bezier_form(spline, elaborator, call.span).points(), {},
      call.span);
}

Term bezier_weights(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  if (!spline.weights) throw Fault{call.span, "this spline has no weights"};
  return elaborator.construct().definition(
      written_call("bezier_weights", call, {}), bezier_form(spline, elaborator, call.span).weights(),
      {}, call.span);
}

Term control_points(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  return elaborator.spline(*call.arguments[0].value, scope).control_points;
}

Term weights(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  if (!spline.weights)
    throw Fault{call.span, "this spline has no weights",
                "spline T = bspline(d, degree 2, weights w, clamped uniform)"};
  return spline.weights;
}

Term knots(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  const std::size_t k = direction_of(spline, call, 0, "T", "T, u");
  return elaborator.construct().list(spline.knots[k], call.span);
}

Term greville(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  const Spline spline = elaborator.spline(*call.arguments[0].value, scope);
  const std::size_t k = direction_of(spline, call, 0, "T", "T, u");
  KnotArithmetic arithmetic{elaborator.construct(), call.span};
  const Term share = number_term(Rational{1, spline.degrees[k]}, call.span);
  std::vector<Term> abscissae;
  for (int i = 0; i < spline.extent(k); ++i) {
    Term total = number_term(0, call.span);
    for (int j = 1; j <= spline.degrees[k]; ++j)
      total = arithmetic.sum(total, spline.knots[k][static_cast<std::size_t>(i + j)]);
    abscissae.push_back(arithmetic.product(share, total));
  }
  return elaborator.construct().list(std::move(abscissae), call.span);
}

}  // namespace patchproof
