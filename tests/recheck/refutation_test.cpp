#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

#include <patchproof/term/replacement.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string refutation = "/certificates/0/refutation";

const Claims& wrong() {
  static const Claims claims{R"(
    param u in [0, 1]
    scalar a, b, f(t), g(t) = t^2
    assume ordered: a < b
    assume rule: f(u) == a*u^2
    refute slope: f'(u) == 2*a
    refute order: f(u) + b <= sqrt(2)
    refute differ: f(u) != a*u^2
    prove g_value: g(a) == 0)"};
  return claims;
}

SymbolPointer named(const Sequent& sequent, const std::string& name) {
  const auto in = [&](const Statement& s) -> SymbolPointer {
    for (const Term& side : {s.left, s.right})
      for (const auto& [ordinal, symbol] : free_symbols(side))
        if (symbol->name == name) return symbol;
    return nullptr;
  };
  for (const Assumption& assumption : sequent.hypotheses)
    if (const SymbolPointer found = in(assumption.statement)) return found;
  return in(sequent.conclusions.at(0));
}

/// u, a, b, and f(t) = a * t^2.
Refutation at(const std::string& label, const Rational& u, const Rational& a, const Rational& b) {
  const Sequent sequent = wrong().sequent(label);
  const SymbolPointer f = named(sequent, "f");
  const SymbolPointer t =
      std::make_shared<const Symbol>(Symbol{"t", Symbol::Role::bound, Type::scalar(), 0, ~0U});
  const Term square = make_term(Operation::power, Type::scalar(), {symbol_term(t)}, 2L);
  const Term body = make_term(Operation::product, Type::scalar(), {number_term(a), square});
  const Term function = make_term(Operation::lambda, f->type, {body}, Formals{t});
  return {sequent,
          {{named(sequent, "u"), number_term(u)},
           {named(sequent, "a"), number_term(a)},
           {named(sequent, "b"), number_term(b)},
           {f, function}},
          0,
          0};
}

std::string judged_at(const std::string& label, const Rational& u, const Rational& a,
                      const Rational& b) {
  return judged(document_of(at(label, u, a, b)));
}

}  // namespace

TEST_CASE("Values at which a statement is false, functions and roots included", "[law]") {
  CHECK(judged_at("slope", 0, 1, 2) == "RECHECKED");
  CHECK(judged_at("order", 1, 0, {3, 2}) == "RECHECKED");
  CHECK(judged_at("differ", 1, 1, 2) == "RECHECKED");
}

TEST_CASE("Values at which the statement holds refute nothing", "[reject]") {
  CHECK(judged_at("slope", 1, 1, 2) ==
        "REJECTED refutation.sequent.conclusions[0]: the statement is true at the values: left - "
        "right is 0");
  CHECK(judged_at("order", 1, 0, {7, 5}) ==
        "REJECTED refutation.sequent.conclusions[0]: the statement is true at the values: left - "
        "right is -sqrt(2) + 7/5");
}

TEST_CASE("Values at which a hypothesis fails refute nothing", "[reject]") {
  CHECK(judged_at("slope", 0, 2, 2) ==
        "REJECTED refutation.sequent.hypotheses[0]: the hypothesis does not hold: left - right is "
        "0");
  CHECK(judged_at("slope", 2, 1, 2) ==
        "REJECTED refutation.sequent.ranges[0]: 'u' = 2 is not in its range");
  // f(u) = a*u^2 has to hold for all u, not at one of them only.
  Refutation other = at("slope", 0, 1, 2);
  other.values.back().value = at("slope", 0, 3, 4).values.back().value;
  CHECK(judged(document_of(other)) ==
        "REJECTED refutation.sequent.hypotheses[1]: the equation does not hold: left - right is "
        "2*u^2");
}

TEST_CASE("Every symbol needs a value, and one of its type", "[reject]") {
  Refutation missing = at("slope", 0, 1, 2);
  missing.values.erase(missing.values.begin() + 2);
  CHECK(judged(document_of(missing)) == "REJECTED refutation: there is no value for 'b'");
  Refutation mistyped = at("slope", 0, 1, 2);
  mistyped.values.back().value = number_term(1);
  CHECK(judged(document_of(mistyped)) ==
        "unreadable: certificates[0].refutation.values[3]: the value of 'f' has another type");
  Refutation open = at("slope", 0, 1, 2);
  open.values[1].value = wrong().term("g_value");
  CHECK(judged(document_of(open)) ==
        "unreadable: certificates[0].refutation.values[1].value: a value without symbols is needed "
        "here");
  Refutation twice = at("slope", 0, 1, 2);
  twice.values.push_back(twice.values.front());
  CHECK(judged(document_of(twice)) ==
        "unreadable: certificates[0].refutation.values[4].symbol: this symbol has a value already");
}

TEST_CASE("A refuted conclusion and component exist", "[reject]") {
  const std::string good = document_of(at("slope", 0, 1, 2));
  CHECK(judged(changed(good, refutation + "/conclusion", 1)) ==
        "REJECTED refutation: there is no conclusion 1");
  CHECK(judged(changed(good, refutation + "/component", 1)) ==
        "REJECTED refutation.sequent.conclusions[0]: there is no component 1");
}

TEST_CASE("A formal parameter that is called like a parameter is not its value", "[law]") {
  // The derivative of t^2 at t = u = 1/2 is 1, and not the derivative of the number 1/4.
  const Claims claims{R"(
    param u in [0, 1]
    scalar s(u) = u^2
    refute slope: s'(u) == 0
    refute one: s'(u) != 1)"};
  const auto half = [&](const std::string& label) {
    const Sequent sequent = claims.sequent(label);
    return judged(document_of(
        Refutation{sequent, {{named(sequent, "u"), number_term(Rational{1, 2})}}, 0, 0}));
  };
  CHECK(half("slope") == "RECHECKED");
  CHECK(half("one") == "RECHECKED");
}

TEST_CASE("A hypothesis about a function may be about all parameters", "[law]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar f(t)
    assume positive: f(u) > 0
    refute one: f(u) == 1)"};
  const Sequent sequent = claims.sequent("one");
  const SymbolPointer f = named(sequent, "f");
  const SymbolPointer t =
      std::make_shared<const Symbol>(Symbol{"t", Symbol::Role::bound, Type::scalar(), 0, ~0U});
  const auto with = [&](const Rational& start, const Rational& slope) {
    const Term part =
        make_term(Operation::product, Type::scalar(), {number_term(slope), symbol_term(t)});
    const Term body = make_term(Operation::sum, Type::scalar(), {number_term(start), part});
    const Term function = make_term(Operation::lambda, f->type, {body}, Formals{t});
    return judged(document_of(Refutation{
        sequent, {{named(sequent, "u"), number_term(Rational{1, 2})}, {f, function}}, 0, 0}));
  };
  CHECK(with(2, 0) == "RECHECKED");
  CHECK(with(1, 2) == "RECHECKED");
  CHECK(
      with(0, 3) ==
      "UNKNOWN refutation.sequent.hypotheses[0]: whether the hypothesis holds for all parameters");
  CHECK(with(-1, 1).starts_with("REJECTED refutation.sequent.hypotheses[0]: "));
}

TEST_CASE("Points differ when one coordinate does", "[law]") {
  const Claims claims{R"(
    point P in R^2
    point Q in R^2
    assume apart: P != Q
    refute first: P.x == Q.x + 5
    refute differ: P != Q)"};
  const auto values = [](const Sequent& sequent, const Rational& x) {
    const auto point = [](const Rational& first) {
      return make_term(Operation::tuple, Type::point(2), {number_term(first), number_term(0)});
    };
    return judged(document_of(Refutation{
        sequent, {{named(sequent, "P"), point(0)}, {named(sequent, "Q"), point(x)}}, 0, 0}));
  };
  CHECK(values(claims.sequent("first"), 1) == "RECHECKED");
  CHECK(values(claims.sequent("first"), 0) ==
        "REJECTED refutation.sequent.hypotheses[0]: the hypothesis does not hold: left - right is "
        "0");
  Sequent alone = claims.sequent("differ");
  alone.hypotheses.clear();
  CHECK(values(alone, 0) == "RECHECKED");
  CHECK(values(alone, 1) ==
        "REJECTED refutation.sequent.conclusions[0]: the statement is true at the values: left - "
        "right is -1");
  // The second coordinates are equal, but the points differ.
  CHECK(judged(changed(document_of(Refutation{
                           alone,
                           {{named(alone, "P"), make_term(Operation::tuple, Type::point(2),
                                                          {number_term(1), number_term(0)})},
                            {named(alone, "Q"), make_term(Operation::tuple, Type::point(2),
                                                          {number_term(2), number_term(0)})}},
                           0,
                           0}),
                       refutation + "/component", 1))
            .starts_with("REJECTED"));
}

TEST_CASE("A hypothesis must not divide by zero anywhere", "[reject]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar f(t)
    assume ratio: f(u)/u == 1
    refute value: f(2) == 3)"};
  const Sequent sequent = claims.sequent("value");
  const SymbolPointer f = named(sequent, "f");
  const SymbolPointer t =
      std::make_shared<const Symbol>(Symbol{"t", Symbol::Role::bound, Type::scalar(), 0, ~0U});
  const auto with = [&](const Term& body) {
    const Term function = make_term(Operation::lambda, f->type, {body}, Formals{t});
    return document_of(Refutation{sequent, {{f, function}}, 0, 0});
  };
  // The parameter u has no value: the equation is there for all of them.
  CHECK(judged(with(symbol_term(t))) ==
        "UNKNOWN refutation.sequent.hypotheses[0]: whether the divisor u has a zero");
  const Term inverse =
      make_term(Operation::quotient, Type::scalar(), {number_term(1), symbol_term(t)});
  CHECK(judged(with(inverse)) == "REJECTED refutation: the value of 'f' is no polynomial");
  const Term hidden =
      make_term(Operation::quotient, Type::scalar(), {number_term(0), symbol_term(t)});
  CHECK(judged(with(hidden)) == "REJECTED refutation: the value of 'f' is no polynomial");
  const std::string good = with(symbol_term(t));
  const auto json = nlohmann::json::parse(good);
  const auto range = json.at(nlohmann::json::json_pointer{refutation + "/sequent/ranges/0"});
  nlohmann::json turned = range;
  turned["lower"] = range["upper"];
  turned["upper"] = range["lower"];
  CHECK(judged(changed(good, refutation + "/sequent/ranges/0", turned)) ==
        "REJECTED refutation.sequent.ranges[0]: the range of 'u' is empty");
}
