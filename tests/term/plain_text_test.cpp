#include <patchproof/term/plain_text.hpp>

#include <catch2/catch.hpp>

using patchproof::Operation;
using patchproof::Rational;
using patchproof::Symbol;
using patchproof::Term;
using patchproof::to_text;
using patchproof::Type;

namespace {

const Type scalar = Type::scalar();
const Type space = Type::point(3);

patchproof::SymbolPointer symbol_of(const std::string& name, const Type& type) {
  const unsigned ordinal = static_cast<unsigned>(name.size());
  return std::make_shared<const Symbol>(Symbol{name, Symbol::Role::scalar, type, 9, ordinal});
}
Term letter(const std::string& name, const Type& type = scalar) {
  return patchproof::symbol_term(symbol_of(name, type));
}
Term n(const Rational& number) { return patchproof::number_term(number); }
Term of(Operation operation, std::vector<Term> children, patchproof::TermNode::Payload payload = {},
        const Type& type = scalar) {
  return make_term(operation, type, std::move(children), std::move(payload));
}
Term sum(std::vector<Term> terms) { return of(Operation::sum, std::move(terms)); }
Term product(std::vector<Term> factors) { return of(Operation::product, std::move(factors)); }
Term quotient(const Term& a, const Term& b) { return of(Operation::quotient, {a, b}); }
Term minus(const Term& a) { return of(Operation::negation, {a}); }
Term power(const Term& base, long exponent) { return of(Operation::power, {base}, exponent); }
Term apply(std::vector<Term> terms) { return of(Operation::apply, std::move(terms)); }
Term derivative(const Term& function, patchproof::Indices orders) {
  return of(Operation::derivative, {function}, std::move(orders), function.type());
}
Term matrix(int rows, int columns, std::vector<Term> entries) {
  return of(Operation::matrix, std::move(entries), {}, Type::matrix(rows, columns, scalar));
}

const Term a = letter("a");
const Term b = letter("b");
const Term c = letter("c");
const Term u = letter("u");
const Term v = letter("v");

}  // namespace

TEST_CASE("sums are written with plus and minus") {
  CHECK(to_text(sum({a, b, c})) == "a + b + c");
  CHECK(to_text(sum({a, minus(b)})) == "a - b");
  CHECK(to_text(sum({minus(a), minus(b)})) == "-a - b");
  CHECK(to_text(sum({a, n(-2)})) == "a - 2");
  CHECK(to_text(sum({a, n(Rational(-2, 3))})) == "a - 2/3");
  CHECK(to_text(sum({a, product({n(-2), b})})) == "a - 2*b");
  CHECK(to_text(sum({a, quotient(minus(b), c)})) == "a - b/c");
  CHECK(to_text(sum({a, quotient(product({minus(b), c}), u), v})) == "a - b*c/u + v");
  CHECK(to_text(sum({a, sum({minus(b), c})})) == "a - b + c");
  CHECK(to_text(sum({sum({minus(a), b}), c})) == "-a + b + c");
  CHECK(to_text(sum({a, minus(sum({b, c}))})) == "a - (b + c)");
  CHECK(to_text(sum({a, minus(minus(b))})) == "a - (-b)");
  CHECK(to_text(sum({a, minus(n(-2))})) == "a - (-2)");
  CHECK(to_text(sum({a, product({sum({minus(b), c}), u})})) == "a + (-b + c)*u");
}

TEST_CASE("products, quotients and powers have only the parentheses they need") {
  CHECK(to_text(product({power(sum({n(1), minus(u)}), 3), letter("V[0,0]", space)})) ==
        "(1 - u)^3*V[0,0]");
  CHECK(to_text(product({a, product({b, c})})) == "a*b*c");
  CHECK(to_text(product({n(Rational(1, 3)), a})) == "1/3*a");
  CHECK(to_text(product({a, n(Rational(1, 3))})) == "a*(1/3)");
  CHECK(to_text(product({a, product({n(Rational(1, 3)), n(-2)})})) == "a*(1/3)*(-2)");
  CHECK(to_text(product({minus(a), b})) == "-a*b");
  CHECK(to_text(product({a, minus(b)})) == "a*(-b)");
  CHECK(to_text(minus(product({a, b}))) == "-a*b");
  CHECK(to_text(minus(product({minus(a), b}))) == "-(-a*b)");
  CHECK(to_text(product({quotient(a, b), c})) == "a/b*c");
  CHECK(to_text(product({a, quotient(b, c)})) == "a*(b/c)");
  CHECK(to_text(quotient(quotient(a, b), c)) == "a/b/c");
  CHECK(to_text(quotient(a, quotient(b, c))) == "a/(b/c)");
  CHECK(to_text(quotient(a, product({b, c}))) == "a/(b*c)");
  CHECK(to_text(quotient(a, power(b, 2))) == "a/b^2");
  CHECK(to_text(quotient(a, n(Rational(1, 2)))) == "a/(1/2)");
  CHECK(to_text(quotient(sum({a, b}), sum({b, c}))) == "(a + b)/(b + c)");
  CHECK(to_text(quotient(product({a, b}), c)) == "a*b/c");
  CHECK(to_text(power(a, -2)) == "a^-2");
  CHECK(to_text(power(n(-2), 2)) == "(-2)^2");
  CHECK(to_text(power(n(Rational(1, 2)), 2)) == "(1/2)^2");
  CHECK(to_text(power(power(a, 2), 3)) == "(a^2)^3");
  CHECK(to_text(minus(power(a, 2))) == "-a^2");
  CHECK(to_text(power(minus(a), 2)) == "(-a)^2");
}

TEST_CASE("functions of numbers are written as calls") {
  const Term pi = of(Operation::pi, {});
  CHECK(to_text(of(Operation::sine, {product({quotient(pi, n(2)), u})})) == "sin(pi/2*u)");
  CHECK(to_text(power(of(Operation::cosine, {u}), 2)) == "cos(u)^2");
  CHECK(to_text(of(Operation::exponential, {minus(u)})) == "exp(-u)");
  CHECK(to_text(of(Operation::square_root, {n(2)})) == "sqrt(2)");
  CHECK(to_text(of(Operation::bernstein, {u}, patchproof::Indices{3, 1})) == "bernstein(3, 1, u)");
  const patchproof::BasisFunction hat{1, 0, 1, {0, 0, Rational(1, 2), 1, 1}};
  CHECK(to_text(of(Operation::bspline_basis, {u}, hat)) ==
        "bspline_basis(0, 1, 1, [0, 0, 1/2, 1, 1], u)");
}

TEST_CASE("points and matrices are written by their entries") {
  const Term p = of(Operation::tuple, {a, sum({b, c}), n(-1)}, {}, space);
  CHECK(to_text(p) == "(a, b + c, -1)");
  CHECK(to_text(of(Operation::tuple, {a}, {}, Type::point(1))) == "tuple(a)");
  const Term m = matrix(2, 2, {a, b, minus(c), n(1)});
  CHECK(to_text(m) == "[a, b ; -c, 1]");
  CHECK(to_text(matrix(3, 1, {a, b, c})) == "[a ; b ; c]");
  CHECK(to_text(of(Operation::matrix_product, {letter("M"), of(Operation::transpose, {m})})) ==
        "M*transpose([a, b ; -c, 1])");
  CHECK(to_text(of(Operation::determinant, {letter("M")})) == "det(M)");
  CHECK(to_text(of(Operation::dot, {p, letter("q", space)})) == "dot((a, b + c, -1), q)");
  CHECK(to_text(of(Operation::cross, {letter("p", space), letter("q", space)})) == "cross(p, q)");
  CHECK(to_text(of(Operation::entry, {letter("M")}, patchproof::Indices{0, 2})) == "M[0,2]");
  CHECK(to_text(of(Operation::entry, {sum({letter("M"), letter("N")})},
                   patchproof::Indices{0, 2})) == "(M + N)[0,2]");
  CHECK(to_text(of(Operation::slice, {letter("M")}, patchproof::Indices{0, 3, 1, 4})) ==
        "M[0..3,1..4]");
  CHECK(to_text(of(Operation::component, {letter("q", space)}, patchproof::Indices{1})) == "q.y");
  CHECK(to_text(of(Operation::component, {sum({letter("p", space), letter("q", space)})},
                   patchproof::Indices{2})) == "(p + q).z");
  CHECK(to_text(of(Operation::component, {letter("q", Type::point(5))}, patchproof::Indices{3})) ==
        "component(q, 3)");
}

TEST_CASE("derivatives of named functions carry marks, others are written out") {
  const Term r = letter("r", Type::function({"u", "v"}, space));
  const Term curve = letter("C1", Type::function({"t"}, space));
  CHECK(to_text(apply({r, u, n(0)})) == "r(u, 0)");
  CHECK(to_text(derivative(r, {1, 1})) == "r_uv");
  CHECK(to_text(derivative(r, {0, 2})) == "r_vv");
  CHECK(to_text(apply({derivative(r, {2, 2}), n(0), v})) == "r_uuvv(0, v)");
  CHECK(to_text(derivative(derivative(r, {1, 0}), {0, 1})) == "r_uv");
  CHECK(to_text(derivative(r, {0, 7})) == "diff(r, v, 7)");
  CHECK(to_text(derivative(r, {3, 4})) == "diff(r, u, 3, v, 4)");
  CHECK(to_text(derivative(r, {0, 0})) == "r");
  CHECK(to_text(apply({derivative(curve, {2}), n(0)})) == "C1''(0)");
  CHECK(to_text(derivative(curve, {4})) == "diff(C1, t, 4)");
  const Term long_names = letter("s", Type::function({"phi", "theta"}, space));
  CHECK(to_text(derivative(long_names, {1, 0})) == "diff(s, phi)");
  CHECK(to_text(derivative(long_names, {1, 2})) == "diff(s, phi, 1, theta, 2)");
}

TEST_CASE("definitions are written by name, functions by their body") {
  const Type patch = Type::function({"u", "v"}, space);
  const patchproof::Formals formals{symbol_of("u", scalar), symbol_of("v", scalar)};
  const Term body = of(Operation::lambda, {sum({u, minus(v)})}, formals, patch);
  CHECK(to_text(body) == "u - v");
  CHECK(to_text(apply({body, n(0), n(1)})) == "(u - v)(0, 1)");
  CHECK(to_text(sum({a, body})) == "a + u - v");
  CHECK(to_text(product({body, a})) == "(u - v)*a");
  CHECK(to_text(minus(body)) == "-(u - v)");
  const Term ruled = of(Operation::definition, {body, a, b}, std::string{"ruled"}, patch);
  CHECK(to_text(ruled) == "ruled(a, b)");
  CHECK(to_text(apply({ruled, u, n(0)})) == "ruled(a, b)(u, 0)");
  CHECK(to_text(derivative(ruled, {1, 0})) == "diff(ruled(a, b), u)");
  const Term named = of(Operation::definition, {body}, std::string{"r"}, patch);
  CHECK(to_text(derivative(named, {1, 1})) == "r_uv");
  CHECK(to_text(Term{}) == "");
}

TEST_CASE("text is cut off after so many bytes, between characters") {
  CHECK(to_text(sum({a, b}), 5) == "a + b");
  CHECK(to_text(sum({a, b}), 4) == "a + …");
  CHECK(to_text(sum({a, b}), 0) == "…");
  CHECK(to_text(letter("h\xC3\xA9"), 2) == "h…");
  CHECK(to_text(sum({a, b}), ~std::size_t{0}) == "a + b");
  const Term large = n(patchproof::power(7, 200'000));
  CHECK(to_text(large, 10) == "4055111978…");
  CHECK(to_text(n(patchproof::power(7, 20)), 16) == "7979226629761200…");
  CHECK(to_text(n(patchproof::power(7, 20)), 17) == "79792266297612001");
}

TEST_CASE("a long number is cut off like any text, whatever its length", "[law]") {
  for (long exponent = 1; exponent <= 300; ++exponent) {
    const Rational number = patchproof::power(10, exponent) - exponent % 2;
    const std::string text = patchproof::to_text(number);
    for (const std::size_t longest : {0, 1, 2, 5, 40, 299, 300}) {
      INFO(number << " to " << longest << " digits");
      CHECK(to_text(n(number), longest) ==
            (text.size() <= longest ? text : text.substr(0, longest) + "…"));
    }
  }
}

TEST_CASE("a term that shares its parts is cut off before its text explodes") {
  Term term = a;
  for (int i = 0; i < 300; ++i) term = i % 2 == 0 ? sum({term, term}) : product({term, term});
  const std::string text = to_text(term);
  CHECK(text.size() == 400 + 3);
  Term nested = a;
  while (nested->depth < patchproof::deepest_term) {
    nested = nested->depth % 2 == 0 ? of(Operation::tuple, {nested, nested}) : minus(nested);
  }
  CHECK(to_text(nested).size() == 400 + 3);
}
