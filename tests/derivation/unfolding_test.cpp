#include <patchproof/derivation/unfolding.hpp>

#include <catch2/catch.hpp>

#include <patchproof/term/plain_text.hpp>
#include <tests/derivation/random_terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// f(t) = body of t, g(s) = body of f: two functions with names, one defined by the other.
struct Named {
  Named(const Term& t, const Term& body_of_f, const Term& s, const Term& body_of_g_without_f)
      : f{lambda({t}, body_of_f)}, g{lambda({s}, at(f, {2 * s}) * s + body_of_g_without_f)} {
    names.add(f, "f");
    names.add(g, "g");
  }
  Term f;
  Term g;
  LatexNames names;
};

struct Letters {
  Declarations declare;
  Term u = declare.parameter("u");
  Term t = declare.parameter("t");
  Term s = declare.parameter("s");
  Term a = declare.scalar("a");
};

std::string text(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

}  // namespace

TEST_CASE("writing out names changes no value, and ends", "[law]") {
  const Letters l;
  for (unsigned seed = 0; seed < 60; ++seed) {
    TermDrawer draw_f{seed, {l.t, l.a}};
    TermDrawer draw_g{seed + 1000, {l.s, l.a}};
    const Named named{l.t, draw_f.scalar(2), l.s, draw_g.scalar(2)};
    Unfolding unfolding{named.names};
    const std::vector<Term> values{
        at(named.g, {l.u}) + at(named.f, {number(2)}), at(derivative(named.g, {1}), {l.u}),
        at(derivative(named.f, {2}), {1 - l.u}), at(named.f, {at(named.g, {l.a})})};
    for (const Term& value : values) {
      Term current = value;
      int depth = unfolding.depth(current);
      CHECK(depth > 0);
      while (depth > 0) {
        const std::optional<Unfolded> next = unfolding.layer(current);
        INFO(seed << ": " << to_text(current));
        REQUIRE(next);
        INFO(to_text(next->term));
        CHECK_FALSE(next->names.empty());
        const std::string said = decided_equation(current, next->term);
        CHECK((said == "holds" || said == "ERROR none"));
        REQUIRE(unfolding.depth(next->term) < depth);
        depth = unfolding.depth(next->term);
        current = next->term;
      }
    }
  }
}

TEST_CASE("names are written out layer by layer") {
  const Letters l;
  const Named named{l.t, power(l.t, 2), l.s, number(1) * l.a};
  Unfolding unfolding{named.names};
  const Term value = at(named.g, {l.u});
  CHECK(unfolding.depth(l.u + 1) == 0);
  CHECK(unfolding.depth(at(named.f, {l.u})) == 1);
  CHECK(unfolding.depth(value) == 2);
  const std::optional<Unfolded> first = unfolding.layer(value);
  REQUIRE(first);
  CHECK(text(first->names) == "g");
  CHECK_FALSE(first->differentiated);
  CHECK_FALSE(first->only_renamed);
  CHECK(unfolding.depth(first->term) == 1);
  const std::optional<Unfolded> second = unfolding.layer(first->term);
  REQUIRE(second);
  CHECK(text(second->names) == "f");
  CHECK(to_text(second->term) == "(2*u)^2*u + 1*a");
}

TEST_CASE("each name is said once, in order of appearance") {
  const Letters l;
  const Term f = lambda({l.t}, l.t + 1);
  const Term g = lambda({l.s}, l.s - 1);
  LatexNames names;
  names.add(f, "f");
  names.add(g, "g");
  Unfolding unfolding{names};
  const auto layer =
      unfolding.layer(at(g, {l.u}) + at(f, {l.u}) * at(g, {number(2)}) + at(f, {l.a}));
  REQUIRE(layer);
  CHECK(text(layer->names) == "g, f");
  CHECK(to_text(layer->term) == "u - 1 + (u + 1)*(2 - 1) + a + 1");
}

TEST_CASE("derivatives are carried out where their function is written out") {
  const Letters l;
  const Term f = lambda({l.t}, power(l.t, 3) + l.a);
  LatexNames names;
  names.add(f, "f");
  Unfolding unfolding{names};
  const auto layer = unfolding.layer(at(derivative(f, {2}), {1 - l.u}));
  REQUIRE(layer);
  CHECK(layer->differentiated);
  CHECK(to_text(layer->term) == "6*(1 - u)");
}

TEST_CASE("a name that only stands for another one is only renamed") {
  const Letters l;
  const Term f = lambda({l.t}, power(l.t, 3));
  const Term h = lambda({l.s}, at(f, {l.s}));
  LatexNames names;
  names.add(f, "f");
  names.add(h, "h");
  Unfolding unfolding{names};
  const auto layer = unfolding.layer(at(h, {l.u}));
  REQUIRE(layer);
  CHECK(layer->only_renamed);
  CHECK(text(layer->names) == "h");
}

TEST_CASE("where a derivative follows no rule nothing is written out") {
  const Letters l;
  const Term f = lambda({l.t}, basis({1, 0, 1, {0, 0, 1, 1}}, l.t));
  LatexNames names;
  names.add(f, "f");
  Unfolding unfolding{names};
  CHECK(unfolding.layer(at(f, {l.u})));
  CHECK_FALSE(unfolding.layer(at(derivative(f, {1}), {l.u})));
}
