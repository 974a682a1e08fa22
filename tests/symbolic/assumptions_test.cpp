#include <patchproof/symbolic/second_opinion.hpp>

#include <catch2/catch.hpp>
#include <ctime>
#include <string>
#include <vector>

#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// Four unknown curves and the bilinearly blended Coons patch between them.
struct Coons {
  Declarations declare;
  Term u = declare.parameter("u");
  Term v = declare.parameter("v");
  Term C1 = declare.curve("C1", "u");
  Term C2 = declare.curve("C2", "u");
  Term D1 = declare.curve("D1", "v");
  Term D2 = declare.curve("D2", "v");
  Term zero = number(0);
  Term one = number(1);
  Term ruled_in_v = (1 - v) * at(C1, {u}) + v * at(C2, {u});
  Term ruled_in_u = (1 - u) * at(D1, {v}) + u * at(D2, {v});
  Term bilinear = (1 - u) * ((1 - v) * at(C1, {zero}) + v * at(C2, {zero})) +
                  u * ((1 - v) * at(C1, {one}) + v * at(C2, {one}));
  Term patch = lambda({u, v}, ruled_in_v + ruled_in_u - bilinear);
  std::vector<Statement> closure{
      equation(at(C1, {zero}), at(D1, {zero})), equation(at(C1, {one}), at(D2, {zero})),
      equation(at(C2, {zero}), at(D1, {one})), equation(at(C2, {one}), at(D2, {one}))};
};

}  // namespace

TEST_CASE("blends that add to one are used everywhere, at values and derivatives") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term f1 = declare.scalar_function("f1", {"u"});
  const Term f2 = declare.scalar_function("f2", {"u"});
  const std::vector<Statement> partition{equation(at(f1, {u}) + at(f2, {u}), number(1))};
  CHECK(holds(at(f1, {v * v}), 1 - at(f2, {v * v}), partition));
  CHECK(holds(at(derivative(f1, {3}), {number(2)}), -at(derivative(f2, {3}), {number(2)}),
              partition));
  CHECK(fails(at(f1, {v}), at(f2, {v}), partition));
  const std::vector<Statement> more{partition[0], equation(at(f1, {number(0)}), number(1))};
  CHECK(holds(at(f2, {number(0)}), number(0), more));
  CHECK(difference(at(f1, {v}), at(f2, {v}), partition) == "-2*f2(v) + 1");
}

TEST_CASE("an assumption for all parameters holds coefficient by coefficient") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  CHECK(holds(a + b, number(0), {equation((a + b) * u + power(u, 2) * a, number(0))}));
  CHECK(fails(a, number(1), {equation((a + b) * u, number(0))}));
}

TEST_CASE("an assumption changes the arguments of values of functions") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const Term C = declare.curve("C", "u");
  const Term P = declare.point("P");
  CHECK(holds(at(C, {number(0)}), P, {equation(at(C, {a}), P), equation(a, number(0))}));
  CHECK(holds(at(C, {number(0)}), P, {equation(a, number(0)), equation(at(C, {a}), P)}));
}

TEST_CASE("an assumption that cannot be used leaves no answer but can do no harm") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  const Term f = declare.scalar_function("f", {"u"});
  const std::vector<Statement> unused{equation(a * a, number(1))};
  CHECK(reason(power(a, 3), a, unused) ==
        "the difference is not zero, but not all assumptions could be used");
  CHECK(holds(u + u, 2 * u, unused));
  const std::vector<Statement> symmetric{equation(at(f, {u}), at(f, {1 - u}))};
  CHECK(opinion(at(f, {number(0)}), at(f, {number(1)}), symmetric).answer == Answer::none);
  const Statement unequal{a, Relation::not_equal, number(0), {}};
  CHECK(fails(a, 2 * a, {unequal}));
}

TEST_CASE("an assumption is solved for what does not occur elsewhere in it") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term a = declare.scalar("a");
  const Term f = declare.scalar_function("f", {"u"});
  const Term g = declare.scalar_function("g", {"v"});
  CHECK(holds(at(f, {a}) + a, number(1), {equation(a + at(f, {a}), number(1))}));
  // Both functions are constant; that is not seen, but nothing false is said either.
  const std::vector<Statement> separated{equation(at(f, {u}) + at(g, {v}), number(1))};
  CHECK(opinion(at(f, {number(0)}), 1 - at(g, {u}), separated).answer == Answer::none);
  // a is 2, so f(2) is 3.
  const std::vector<Statement> entangled{equation(at(f, {a}), number(3)),
                                         equation(a * at(f, {a}), number(6))};
  CHECK(opinion(at(f, {number(2)}), number(3), entangled).answer == Answer::none);
}

TEST_CASE("assumptions that contradict each other leave no answer") {
  Declarations declare;
  const Term a = declare.scalar("a");
  CHECK(reason(a, a, {equation(a, number(1)), equation(a, number(2))}) ==
        "the assumptions contradict each other");
}

TEST_CASE("known symbols have their values") {
  Declarations declare;
  const Term P = declare.point("P", 2);
  const Term Q = declare.point("Q", 2);
  const Term a = declare.scalar("a");
  Goal g = goal({equation(component(P, 1), 2 * a)});
  g.known = {{P.symbol(), 2 * Q}, {Q.symbol(), point({number(1), a})}};
  CHECK(opinion(g).answer == Answer::holds);
  g.statements = {equation(component(P, 0), a)};
  CHECK(opinion(g).normal_form == "-a + 2");
  g.known = {{P.symbol(), 2 * Q}, {Q.symbol(), 2 * P}};
  CHECK(opinion(g).reason == "the value of P refers to itself");
}
