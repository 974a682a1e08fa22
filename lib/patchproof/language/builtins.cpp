#include <patchproof/language/builtins.hpp>

#include <algorithm>
#include <functional>

#include <patchproof/language/builtin_call.hpp>
#include <patchproof/language/builtin_splines.hpp>
#include <patchproof/language/nearest_name.hpp>

namespace patchproof {

namespace {

using syntax::Expression;
using Call = BuiltinCall;

Term elementary(const Call& call, Operation operation) {
  return call.construct().elementary(operation, call.scalar(0, "this argument"), call.span());
}

Term determinant(const Call& call) {
  constexpr int most = 12;
  std::vector<Term> entries;
  int size = 0;
  if (call.count() == 1) {
    const Term matrix = call.matrix(0);
    const Type& type = matrix.type();
    if (type.rows != type.columns || !type.inner->is_scalar())
      throw Fault{call.span(), "only square matrices of scalars have a determinant, this is a " +
                                   to_text(type)};
    if (type.rows > most) throw Fault{call.span(), "a determinant has at most 12 rows"};
    return call.construct().make(Operation::determinant, Type::scalar(), {matrix}, {}, call.span());
  }
  size = static_cast<int>(call.count());
  std::vector<std::vector<Term>> rows;
  for (std::size_t k = 0; k < call.count(); ++k) {
    const Term point = call.value(k);
    if (!point.type().is_point() || point.type().dimension != size)
      throw Fault{point.span(), "det of " + std::to_string(size) + " rows needs points in R^" +
                                    std::to_string(size) + ", this is a " + to_text(point.type())};
    rows.emplace_back();
    for (int c = 0; c < size; ++c)
      rows.back().push_back(call.construct().component(point, c, point.span()));
  }
  const Term matrix = call.construct().matrix(call.scope, std::move(rows), call.span());
  return call.construct().make(Operation::determinant, Type::scalar(), {matrix}, {}, call.span());
}

Term of_two_points(const Call& call, Operation operation) {
  const Term a = call.value(0);
  const Term b = call.value(1);
  for (const Term& point : {a, b}) {
    if (!point.type().is_point())
      throw Fault{point.span(), "a point is needed here, not a " + to_text(point.type())};
    if (point.type().dimension == Type::any_dimension)
      throw Fault{point.span(), "products of points need a known dimension",
                  "declare the dimension: 'point P in R^3', 'curve C(u) in R^3'"};
  }
  if (!(a.type() == b.type()))
    throw Fault{call.span(), "both points need one dimension, and these are a " +
                                 to_text(a.type()) + " and a " + to_text(b.type())};
  if (operation == Operation::cross && a.type().dimension != 3)
    throw Fault{call.span(), "the vector product exists in R^3 only"};
  const Type type = operation == Operation::dot ? Type::scalar() : a.type();
  return call.construct().make(operation, type, {a, b}, {}, call.span());
}

Term transpose(const Call& call) {
  const Term matrix = call.matrix(0);
  const Type& type = matrix.type();
  return call.construct().make(Operation::transpose,
                               Type::matrix(type.columns, type.rows, *type.inner), {matrix}, {},
                               call.span());
}

// A sum or a product: the first argument for every combination of the running indices.
Term running(const Call& call, bool sum) {
  const std::vector<syntax::Binder> binders = call.binders(1);
  std::vector<Term> terms;
  for (const std::vector<int>& values : call.elaborator.combinations(binders, call.scope)) {
    call.elaborator.workshop().count_term(call.span());
    const Scope inner = Elaborator::bound(call.scope, binders, values);
    const Expression& term = *call.expression.arguments[0].value;
    terms.push_back(call.elaborator.expression(term, inner));
    if (!sum && !call.construct().value(inner, terms.back()).type().is_scalar())
      throw Fault{term.span, "the factors of a product have to be scalars, and this is a " +
                                 to_text(terms.back().type())};
  }
  const std::string signs(terms.size(), sum ? '+' : '*');
  return sum ? call.construct().sum(call.scope, std::move(terms), signs, call.span())
             : call.construct().product(call.scope, std::move(terms), signs, call.span());
}

Term net(const Call& call) {
  const std::vector<syntax::Binder> binders = call.binders(1);
  return net_of(*call.expression.arguments[0].value, binders, call.span(), call.scope,
                call.elaborator);
}

Term extent(const Call& call, bool rows) {
  const Term matrix = call.matrix(0);
  const Type& type = matrix.type();
  return number_term(rows ? type.rows : type.columns, call.span());
}

Term part(const Call& call, bool row) {
  const Term matrix = call.matrix(0);
  const Type& type = matrix.type();
  const int at = call.whole(1, "an index");
  std::vector<Term> entries;
  const int count = row ? type.columns : type.rows;
  for (int k = 0; k < count; ++k)
    entries.push_back(call.construct().entry(
        matrix, type.list ? std::vector<int>{row ? at : k} : row ? std::vector{at, k} : std::vector{k, at},
        call.span()));
  return call.construct().list(std::move(entries), call.span());
}

Term bernstein(const Call& call) {
  constexpr int highest = 400;
  const int degree = call.whole(0, "a degree");
  const int index = call.whole(1, "the index of a Bernstein polynomial");
  if (degree < 0 || degree > highest)
    throw Fault{call.span(), "a degree has to lie between 0 and " + std::to_string(highest)};
  // The usual convention; it makes sums over products of Bernstein polynomials short.
  if (index < 0 || index > degree) return number_term(0, call.span());
  return call.construct().make(Operation::bernstein, Type::scalar(),
                               {call.scalar(2, "the argument of a Bernstein polynomial")},
                               Indices{degree, index}, call.span());
}

Term binomial(const Call& call) {
  const int n = call.whole(0, "the upper number");
  const int k = call.whole(1, "the lower number");
  if (n < 0 || n > 400)
    throw Fault{call.span(),
                "the upper number of a binomial coefficient has to lie between 0 and 400"};
  Integer result = k < 0 || k > n ? 0 : 1;
  for (int i = 1; i <= std::min(k, n - k); ++i) result = result * (n - i + 1) / i;
  return number_term(Rational{result}, call.span());
}

// A list of control points makes a curve, a net a patch: two definitions of the prelude.
Term bezier(const Call& call) {
  const Term points = call.matrix(0);
  const Type& type = points.type();
  const bool curve = type.list || type.rows == 1 || type.columns == 1;
  Expression inner = call.expression;
  auto callee = std::make_shared<Expression>(*call.expression.operands.front());
  callee->text += curve ? "_curve" : "_patch";
  inner.operands.front() = callee;
  return call.elaborator.expression(inner, Scope{&call.scope});
}

// A rational curve or patch: as many weights as points.
Term rational_bezier(const Call& call) {
  const Term points = call.matrix(0);
  const Term weights = call.matrix(1);
  const auto count = [](const Type& t) { return t.rows * t.columns; };
  if (!weights.type().inner->is_scalar())
    throw Fault{weights.span(), "weights are numbers, this is a " + to_text(weights.type())};
  const bool curve = points.type().rows == 1 || points.type().columns == 1;
  const bool fit = curve ? count(points.type()) == count(weights.type()) &&
                               (weights.type().rows == 1 || weights.type().columns == 1)
                         : points.type().rows == weights.type().rows &&
                               points.type().columns == weights.type().columns;
  if (!fit)
    throw Fault{weights.span(), "each point has one weight: a " + to_text(weights.type()) +
                                    " does not fit a " + to_text(points.type())};
  const bool all_zero = weights.operation() == Operation::matrix &&
                        std::all_of(weights.children().begin(), weights.children().end(), is_zero);
  if (all_zero) throw Fault{weights.span(), "all weights are 0: there is no curve or patch"};
  return bezier(call);
}

// As a value: there is none.
Term whole_spline(const Call& call) {
  const std::string& name = call.expression.operands.front()->text;
  throw Fault{call.span(), "'" + name + "' gives a spline, which is made of pieces",
              "segment(" + name + "(…), 0) is its first piece; spline T = " + name +
                  "(…) gives it a name"};
}

struct Builtin {
  std::string name;
  std::string usage;
  std::size_t fewest;
  std::size_t most;
  std::function<Term(const Call&)> value;
};

const std::vector<Builtin>& builtins() {
  constexpr std::size_t many = 99;
  const auto spline = [](Term (*handler)(const Expression&, const Scope&, Elaborator&)) {
    return [handler](const Call& c) { return handler(c.expression, c.scope, c.elaborator); };
  };
  static const std::vector<Builtin> table{
      {"sin", "sin(x)", 1, 1, [](const Call& c) { return elementary(c, Operation::sine); }},
      {"cos", "cos(x)", 1, 1, [](const Call& c) { return elementary(c, Operation::cosine); }},
      {"exp", "exp(x)", 1, 1, [](const Call& c) { return elementary(c, Operation::exponential); }},
      {"sqrt", "sqrt(x)", 1, 1, [](const Call& c) { return elementary(c, Operation::square_root); }},
      {"det", "det(M) or det(a, b, c)", 1, 12, determinant},
      {"dot", "dot(a, b)", 2, 2, [](const Call& c) { return of_two_points(c, Operation::dot); }},
      {"cross", "cross(a, b)", 2, 2, [](const Call& c) { return of_two_points(c, Operation::cross); }},
      {"transpose", "transpose(M)", 1, 1, transpose},
      {"diff", "diff(r, u, 2, v)", 2, many, derivative_of},
      {"sum", "sum(b[i]*x^i, i in 0..3)", 2, many, [](const Call& c) { return running(c, true); }},
      {"product", "product(t - a[i], i in 0..3)", 2, many,
       [](const Call& c) { return running(c, false); }},
      {"integral", "integral(f(u), u in [0, 1])", 2, many, integral_of},
      {"net", "net(c[i,0], i in 0..3, j in 0..3)", 2, 3, net},
      {"rows", "rows(M)", 1, 1, [](const Call& c) { return extent(c, true); }},
      {"columns", "columns(M)", 1, 1, [](const Call& c) { return extent(c, false); }},
      {"row", "row(M, i)", 2, 2, [](const Call& c) { return part(c, true); }},
      {"column", "column(M, j)", 2, 2, [](const Call& c) { return part(c, false); }},
      {"bernstein", "bernstein(n, i, t)", 3, 3, bernstein},
      {"binomial", "binomial(n, k)", 2, 2, binomial},
      {"bezier", "bezier(b)", 1, 1, bezier},
      {"rational_bezier", "rational_bezier(b, w)", 2, 2, rational_bezier},
      {"segment", "segment(T, i) or segment(T, i, j)", 2, 3, spline(segment)},
      {"bezier_net", "bezier_net(T)", 1, 1, spline(bezier_net)},
      {"bezier_weights", "bezier_weights(T)", 1, 1, spline(bezier_weights)},
      {"control_points", "control_points(T)", 1, 1, spline(control_points)},
      {"weights", "weights(T)", 1, 1, spline(weights)},
      {"knots", "knots(T) or knots(T, u)", 1, 2, spline(knots)},
      {"greville", "greville(T) or greville(T, u)", 1, 2, spline(greville)},
      {"insert_knot", "insert_knot(T, t) or insert_knot(T, u, t)", 2, 3, whole_spline},
      {"elevate_degree", "elevate_degree(T) or elevate_degree(T, u)", 1, 2, whole_spline},
  };
  return table;
}

const Builtin* find(const std::string& name) {
  const auto& table = builtins();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Builtin& b) { return b.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

bool is_builtin(const std::string& name) { return find(name) != nullptr; }

std::vector<std::string> builtin_names() {
  std::vector<std::string> result{"pi"};
  for (const Builtin& builtin : builtins()) result.push_back(builtin.name);
  return result;
}

std::string builtin_usage(const std::string& name) { return find(name)->usage; }

void require_arguments(const std::string& name, const syntax::Expression& call) {
  const Builtin& builtin = *find(name);
  const std::size_t count = call.arguments.size();
  if (count < builtin.fewest || count > builtin.most)
    throw Fault{call.span, "'" + name + "' cannot take " + std::to_string(count) + " argument" +
                               (count == 1 ? "" : "s"),
                builtin.usage};
  if (!call.arguments.front().value)
    throw Fault{call.span, "a running index comes after the term it runs in", builtin.usage};
}

Term builtin_call(const std::string& name, const syntax::Expression& call, const Scope& scope,
                  Elaborator& elaborator) {
  require_arguments(name, call);
  return find(name)->value({call, scope, elaborator});
}

}  // namespace patchproof
