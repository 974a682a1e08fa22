#include <catch2/catch.hpp>

#include "near_miss.hpp"
#include "opinion.hpp"
#include "rewriting.hpp"
#include "shrinking.hpp"
#include "subjects.hpp"

namespace patchproof::differential {
namespace {

Draft draft_of_two() {
  Draft draft;
  declare_parameters(draft, {"u"});
  declare_scalars(draft, {"a"});
  return draft;
}

/// u + a == the right side.
Example sum_is(const Node& right, bool holds) {
  const Draft draft = draft_of_two();
  const Node left = sum({scalar_name("u"), scalar_name("a")});
  Example example{"ring", draft.declarations, "", holds, draft.python};
  example.claim = "p: " + case_text(left) + " == " + case_text(right);
  example.python_left = python_text(left);
  example.python_right = python_text(right);
  example.meaning_holds = same(meaning(left, {}), meaning(right, {}));
  return example;
}

const Node exchanged = sum({scalar_name("a"), scalar_name("u")});
const Node missed = sum({scalar_name("a"), scalar_name("u"), number("1/1000000000000000000000")});

}  // namespace

TEST_CASE("a seed gives the same case on every machine") {
  Choices choices{61};
  const Example example = quotient_example(choices, "quotient", false);
  CHECK(
      case_of(example) ==
      "case random\n"
      "  param u, v in [0, 1]\n"
      "  scalar a, b, c\n"
      "  point P, Q\n"
      "  assume different: a != b\n"
      "  refute p: (1/2)*(2*(v/(a - b))) == (((c*v + 1) - c*v) + (1/3)*(3*(-a))) + a*(v/(a - b))\n"
      "end\n");
}

TEST_CASE("decisions that were made give the same case again, none a case too") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Choices choices{seed};
    const Example first = random_example(choices);
    Choices replayed{choices.made()};
    CHECK(case_of(random_example(replayed)) == case_of(first));
  }
  Choices nothing{std::vector<std::uint64_t>{}};
  CHECK(judged(random_example(nothing)).verdict == "PROVED");
}

TEST_CASE("every opinion tells a true claim from a near miss", "[reject]") {
  CHECK(judged(sum_is(exchanged, true)).fault == "");
  CHECK(judged(sum_is(missed, false)).fault == "");
  CHECK(opinions_of_python({sum_is(exchanged, true), sum_is(missed, false)}) ==
        std::vector<std::optional<bool>>{true, false});
}

TEST_CASE("what is not as expected is a fault", "[reject]") {
  Example false_one = sum_is(missed, true);
  CHECK(judged(false_one).fault == "the generator takes a claim for something else than it means");
  false_one.meaning_holds = true;
  CHECK(judged(false_one).fault == "a true claim is REFUTED");
  Example true_one = sum_is(exchanged, false);
  true_one.meaning_holds = false;
  CHECK(judged(true_one).fault == "a near miss is PROVED");
  true_one.declarations.clear();
  CHECK(judged(true_one).fault == "the case cannot be read");
}

TEST_CASE("what fails is made as small as it can be", "[law]") {
  // Fails when some decision after the first is at least 17.
  const auto fails = [](const std::vector<std::uint64_t>& decisions) {
    for (std::size_t i = 1; i < decisions.size(); ++i)
      if (decisions[i] >= 17) return true;
    return false;
  };
  CHECK(shrunk({99, 3, 4, 1000, 5, 40, 6}, 1, 1000, fails) == std::vector<std::uint64_t>{99, 17});
  CHECK(shrunk({99, 1000}, 1, 0, fails) == std::vector<std::uint64_t>{99, 1000});
}

TEST_CASE("rewriting keeps what an expression means, a near miss does not", "[law]") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Choices choices{seed};
    const Draft draft = draft_of_two();
    const Node node = random_scalar(choices, draft, 3);
    INFO(case_text(node));
    const Node other = rewritten(choices, draft, node, 4);
    INFO(case_text(other));
    CHECK(case_text(other) != case_text(node));
    CHECK(same(meaning(node, {}), meaning(other, {})));
    const Node miss = near_miss(choices, draft, node);
    INFO(case_text(miss));
    CHECK_FALSE(same(meaning(node, {}), meaning(miss, {})));
  }
}

TEST_CASE("the third arithmetic knows the values of textbook constructions") {
  const auto value = [](const Node& node) {
    const Value found = meaning(node, {});
    return to_text(plain_value(found.entries.at(0).above) / plain_value(found.entries.at(0).below));
  };
  const auto list = [](const std::vector<long>& of) {
    std::vector<Node> entries;
    for (const long entry : of) entries.push_back(number(entry));
    return entries;
  };
  const auto at = [](const Node& function, const std::string& u, const std::string& v) {
    return apply(function, {number(u), number(v)}, Type::point);
  };
  const auto of = [](const std::string& name, std::vector<Node> operands) {
    return call(name, std::move(operands), Type::function);
  };
  // (1-t)^3*1 + 3*(1-t)^2*t*2 + 3*(1-t)*t^2*4 + t^3*8 = (1 + t)^3.
  CHECK(value(apply(of("bezier", {matrix(1, list({1, 2, 4, 8}))}), {number("1/2")}, Type::point)) ==
        "27/8");
  // The product of (1 + u) and (1 + 2*v).
  CHECK(value(at(of("bilinear", list({1, 2, 3, 6})), "1/2", "1/3")) == "5/2");
  // The Hermite cubic of t^3, and the patch of u^3*v^3 with its tangents and twists.
  CHECK(value(apply(of("hermite_curve", list({0, 1, 0, 3})), {number("1/2")}, Type::point)) ==
        "1/8");
  const Node vectors = matrix(4, list({0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 0, 3, 0, 9}));
  CHECK(value(at(of("bicubic_hermite", {vectors}), "1/2", "1/3")) == "1/216");
  CHECK(value(call("bernstein", {number(4), number(1), number("1/3")}, Type::scalar)) == "32/81");
  CHECK(value(call("binomial", {number(6), number(2)}, Type::scalar)) == "15");
  CHECK(value(call("det", {matrix(3, list({2, 0, 1, 1, 3, 2, 1, 1, 4}))}, Type::scalar)) == "18");
  CHECK(value(integral(power(scalar_name("s"), 3), "s", number(1), number(2))) == "15/4");
}

}  // namespace patchproof::differential
