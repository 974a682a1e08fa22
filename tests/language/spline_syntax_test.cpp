#include <catch2/catch.hpp>

#include "language/language_test.hpp"

namespace patchproof {

TEST_CASE("splines with weights, of Bézier points and of other splines are read and laid out",
          "[language]") {
  const std::string text =
      "case a\n"
      "  spline T=bspline( d,degree 2,weights[1,2 , 1],clamped   uniform)\n"
      "spline S = merged(b, degree 2, 1, weights w, knots[0, 1], [-1 ,2])\n"
      "  spline I=insert_knot( S,u ,1/2 )\n"
      "  spline J=I\n"
      "assume positive:w[i]>0 for i in 0..2\n"
      "end\n";
  REQUIRE(messages_of(text) == "");
  const std::string laid_out =
      "case a\n"
      "  spline T = bspline(d, degree 2, weights [1, 2, 1], clamped uniform)\n"
      "  spline S = merged(b, degree 2, 1, weights w, knots [0, 1], [-1, 2])\n"
      "  spline I = insert_knot(S, u, 1/2)\n"
      "  spline J = I\n"
      "  assume positive: w[i] > 0 for i in 0..2\n"
      "end\n";
  CHECK(formatted(*source_of(text)) == laid_out);
  CHECK(meaning_of(text) == meaning_of(laid_out));

  const auto file = parse(source_of(text)).file;
  const auto& statements = file.cases.at(0).statements;
  REQUIRE(statements.size() == 5);
  CHECK_FALSE(statements[0].spline->merged);
  CHECK(statements[0].spline->weights != nullptr);
  CHECK(statements[1].spline->merged);
  CHECK(statements[1].spline->knots.size() == 2);
  CHECK_FALSE(statements[2].spline.has_value());
  CHECK(statements[2].declarators.at(0).value != nullptr);
  CHECK(statements[4].clauses.binders.size() == 1);

  const std::string tree = meaning_of(text);
  CHECK(tree.find("\"bezier_points\"") != std::string::npos);
  CHECK(tree.find("\"weights\"") != std::string::npos);
}

TEST_CASE("what is missing in a spline is said", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  spline T = merged(b, 3)
  spline S = bspline(b, degree 2, weights w)
  spline R = merged(b, degree 2, knots)
  spline Q =
end
)~") ==
        R"~(bad.proof:2:24: error: expected 'degree', found '3'
     2 |   spline T = merged(b, 3)
       |                        ^
bad.proof:3:44: error: expected ',', found ')'
     3 |   spline S = bspline(b, degree 2, weights w)
       |                                            ^
bad.proof:4:39: error: expected an expression, found ')'
     4 |   spline R = merged(b, degree 2, knots)
       |                                       ^
bad.proof:5:13: error: expected an expression; the statement ends here
     5 |   spline Q =
       |             ^
)~");
}

}  // namespace patchproof
