#include <patchproof/term/term.hpp>

#include <catch2/catch.hpp>

using patchproof::Operation;
using patchproof::Term;
using patchproof::Type;

TEST_CASE("a term knows its operation, type, children and payload") {
  const auto x = std::make_shared<const patchproof::Symbol>(
      patchproof::Symbol{"x", patchproof::Symbol::Role::scalar, Type::scalar(), 0, 1});
  const Term square = make_term(Operation::power, Type::scalar(), {patchproof::symbol_term(x)}, 2L);
  CHECK(square.operation() == Operation::power);
  CHECK(square.exponent() == 2);
  CHECK(square.type() == Type::scalar());
  CHECK(square.child(0).symbol() == x);
  CHECK(square.child(0).type() == Type::scalar());
  CHECK(patchproof::number_term(7).number() == 7);
  CHECK(patchproof::number_term(7).is_number());
  CHECK_THROWS_AS(square.number(), std::bad_variant_access);
  CHECK_FALSE(Term{});
}

TEST_CASE("the depth of a term is one more than that of its deepest child") {
  const Term leaf = patchproof::number_term(1);
  CHECK(leaf->depth == 1);
  const Term negated = make_term(Operation::negation, Type::scalar(), {leaf});
  CHECK(make_term(Operation::sum, Type::scalar(), {leaf, negated})->depth == 3);
}

TEST_CASE("a term may be as deep as the limit and no deeper", "[reject]") {
  Term term = patchproof::number_term(1);
  while (term->depth < patchproof::deepest_term) {
    term = make_term(Operation::sine, Type::scalar(), {term});
  }
  CHECK_THROWS_AS(make_term(Operation::sine, Type::scalar(), {term}), patchproof::TooDeep);
  CHECK_THROWS_WITH(make_term(Operation::sine, Type::scalar(), {term}),
                    "this expression is nested more than 1000 levels deep");
}

TEST_CASE("an empty term is nobody's child", "[reject]") {
  CHECK_THROWS_AS(make_term(Operation::negation, Type::scalar(), {Term{}}), std::logic_error);
}
