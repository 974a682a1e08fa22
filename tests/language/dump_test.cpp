#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "language_test.hpp"

namespace patchproof {
namespace {

/// Checks that every object below has a kind and a place.
void check_nodes(const nlohmann::ordered_json& node) {
  if (node.is_object()) {
    CHECK(node.contains("kind"));
    CHECK(node.at("line") >= 1);
    CHECK(node.at("column") >= 1);
  }
  if (node.is_structured()) {
    for (const auto& part : node) check_nodes(part);
  }
}

}  // namespace

TEST_CASE("a tree is dumped as JSON with the place of every node", "[language]") {
  CHECK(dump(parse(source_of("case a.b\n  prove x: u/0.1 == 2\nend\n")).file) == R"({
  "kind": "file",
  "line": 1,
  "column": 1,
  "name": "bad.proof",
  "cases": [
    {
      "kind": "case",
      "line": 1,
      "column": 1,
      "name": "a.b",
      "statements": [
        {
          "kind": "prove",
          "line": 2,
          "column": 3,
          "label": {
            "kind": "name",
            "line": 2,
            "column": 9,
            "text": "x"
          },
          "proposition": {
            "kind": "proposition",
            "line": 2,
            "column": 12,
            "comparisons": [
              {
                "kind": "comparison",
                "line": 2,
                "column": 12,
                "operators": [
                  "=="
                ],
                "operands": [
                  {
                    "kind": "product",
                    "line": 2,
                    "column": 12,
                    "signs": "*/",
                    "operands": [
                      {
                        "kind": "name",
                        "line": 2,
                        "column": 12,
                        "text": "u"
                      },
                      {
                        "kind": "number",
                        "line": 2,
                        "column": 14,
                        "value": "1/10",
                        "text": "0.1"
                      }
                    ]
                  },
                  {
                    "kind": "number",
                    "line": 2,
                    "column": 21,
                    "value": "2",
                    "text": "2"
                  }
                ]
              }
            ]
          }
        }
      ]
    }
  ]
}
)");
}

TEST_CASE("every statement and definition can be dumped", "[language]") {
  const std::string text = R"(include "x.proof"
define f(a, b : scalar, C : curve(u), r : patch(u, v), g : scalar function) : list
  title "t"
  = (a, b)
end
case a
  title "t"
  source "s" lang sk section "x" page 3
  quote "q"
  tags one, two
  limit time 5 s
  family m in 1..6
  param u, v in [0, 1]
  scalar a, b[0..3], f(u) : C^1
  point P in R^3
  curve C(u) = (u, 0), D(u) : degree 3
  patch r(u, v) : degree (1, 2)
  matrix M = [1, ? ; -2, 3]
  net b1[i, j] = i*j for i in 0..3, j in 0..3
  spline T = bspline(M, degree 3, 3, clamped uniform)
  spline S = bspline(M, degree 3, knots [0, 1])
  let E(q) = q.x + M[0..1, 1] + sum(i, i in 0..m) - -2^-3
  assume c: a != b
  prove d: a < b on boundary using c for i in 0..3
  open e: C^1 joint of P at v = 1 and R at v = 0
  derive g: a from a == 1, C^1 joint of P at v = 1 and R at v = 0 gives 1 leaves b
  derive h: a from a == 1, C^0 joint of P at v = 1 and R at v = 0,
      C^1 joint of P at v = 1 and R at v = 0 inconsistent
  erratum k printed a == b corrected a == -b note "n"
  end
  show a
end
)";
  REQUIRE(messages_of(text) == "");
  check_nodes(nlohmann::ordered_json::parse(dump(parse(source_of(text)).file)));
  CHECK(meaning_of(text).find("further_joints") != std::string::npos);
}

TEST_CASE("a tree from a faulty text can be dumped too", "[language]") {
  const std::string text = "case a\n  title \"B\xE9zier\"\n  prove\nend\ndefine f\nend";
  const auto tree = nlohmann::ordered_json::parse(dump(parse(source_of(text)).file));
  CHECK(tree.at("cases").at(0).at("statements").at(0).at("text") == "B\xEF\xBF\xBDzier");
}

}  // namespace patchproof
