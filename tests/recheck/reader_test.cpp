#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string first = "/certificates/0";

std::string good() {
  static const Claims claims{R"(
    param u in [0, 1]
    scalar a
    point P in R^2
    curve C(t) in R^2 : C^2
    prove sum: a*(P + C(u)) == a*P + a*C(u))"};
  SequentProof proof = by_equations(claims.sequent("sum"), {});
  proof.components.push_back({0, 1, EquationProof{}, false});
  return document_of(proof);
}

std::string with(const std::string& place, const nlohmann::json& value) {
  return judged(changed(good(), place, value));
}

// One more node at the end of the table; it is read although nothing uses it.
std::string with_node(const nlohmann::json& node) {
  nlohmann::json json = nlohmann::json::parse(good());
  json["certificates"][0]["nodes"].push_back(node);
  const std::size_t index = json["certificates"][0]["nodes"].size() - 1;
  const std::string found = judged(json.dump());
  const std::string start = "unreadable: certificates[0].nodes[" + std::to_string(index) + "]";
  return found.starts_with(start) ? found.substr(start.size()) : found;
}

}  // namespace

TEST_CASE("The certificates of the reader's tests are good", "[law]") {
  CHECK(judged(good()) == "RECHECKED");
  CHECK(with_node({{"operation", "pi"}}) == "RECHECKED");
}

TEST_CASE("What is no JSON, or no document, is refused", "[reject]") {
  CHECK(judged("").starts_with("unreadable: this is no JSON: "));
  CHECK(judged("[1, 2").starts_with("unreadable: this is no JSON: "));
  CHECK(judged("[]") == "unreadable: an object is needed here");
  CHECK(judged("{}") == "unreadable: the member 'format' is missing");
  CHECK(judged("{\"a\": {\"b\": 1, \"b\": 2}}") ==
        "unreadable: the member 'b' stands twice in one object");
  CHECK(judged(std::string(500, '[')) == "unreadable: the text is nested too deeply");
  CHECK(judged(std::string(1'000'000, '[')) == "unreadable: the text is nested too deeply");
  CHECK(with("/format", "other") == "unreadable: format: 'other' is not known here");
  CHECK(with("/version", 2) == "unreadable: version: version 2 is not known, only version 1");
  CHECK(with("/version", "1") == "unreadable: version: a whole number is needed here");
  CHECK(with("/certificates", 1) == "unreadable: certificates: a list is needed here");
  CHECK(with(first, nlohmann::json::object()) ==
        "unreadable: certificates[0]: the member 'claim' is missing");
}

TEST_CASE("A member that is not known, or missing, is found", "[reject]") {
  nlohmann::json json = nlohmann::json::parse(good());
  json["certificates"][0]["proofs"][0]["trust"] = true;
  CHECK(judged(json.dump()) ==
        "unreadable: certificates[0].proofs[0]: the member 'trust' is not known");
  json["certificates"][0]["proofs"][0].erase("trust");
  json["certificates"][0]["proofs"][0].erase("not_zero");
  CHECK(judged(json.dump()) ==
        "unreadable: certificates[0].proofs[0]: the member 'not_zero' is missing");
  json["certificates"][0].erase("proofs");
  CHECK(judged(json.dump()) ==
        "unreadable: certificates[0]: a certificate has either 'proofs' or a 'refutation'");
  CHECK(with(first + "/proofs", nlohmann::json::array()) ==
        "unreadable: certificates[0].proofs: there is nothing shown");
  CHECK(with(first + "/proofs/0/sequent/conclusions", nlohmann::json::array()) ==
        "unreadable: certificates[0].proofs[0].sequent.conclusions: there is no conclusion");
}

TEST_CASE("A parameter has one range", "[reject]") {
  const auto range = nlohmann::json::parse(good()).at(
      nlohmann::json::json_pointer{first + "/proofs/0/sequent/ranges/0"});
  CHECK(with(first + "/proofs/0/sequent/ranges", {range, range}) ==
        "unreadable: certificates[0].proofs[0].sequent.ranges[1].parameter: this parameter has a "
        "range already");
}

TEST_CASE("Symbols have one ordinal each, and the type of their role", "[reject]") {
  const nlohmann::json json = nlohmann::json::parse(good());
  const nlohmann::json ordinal = json["certificates"][0]["symbols"][0]["ordinal"];
  CHECK(with(first + "/symbols/1/ordinal", ordinal) ==
        "unreadable: certificates[0].symbols[1].ordinal: " + ordinal.dump() +
            " is that of symbols[0] too");
  CHECK(with(first + "/symbols/0/role", "point") ==
        "unreadable: certificates[0].symbols[0].type: the role wants another type");
  CHECK(with(first + "/symbols/0/role", "hero") ==
        "unreadable: certificates[0].symbols[0].role: 'hero' is not known here");
  CHECK(with(first + "/symbols/0/type", {{"point", 0}}) ==
        "unreadable: certificates[0].symbols[0].type.point: a point has coordinates");
  CHECK(with(first + "/symbols/0/type", {{"point", 1000000}}) ==
        "unreadable: certificates[0].symbols[0].type.point: 1000000 is too large");
  CHECK(
      with(first + "/symbols/0/type", {{"function", nlohmann::json::array()}, {"to", "scalar"}}) ==
      "unreadable: certificates[0].symbols[0].type.function: a wrong number of parameters");
}

TEST_CASE("Nodes stand behind their children, so there are no cycles", "[reject]") {
  const std::size_t count = nlohmann::json::parse(good())["certificates"][0]["nodes"].size();
  CHECK(with_node({{"operation", "negation"}, {"children", {count}}}) ==
        ".children[0]: a child has to stand before its parent");
  CHECK(with_node({{"operation", "negation"}, {"children", {-1}}}) ==
        ".children[0]: a whole number is needed here");
  CHECK(with_node({{"operation", "negation"}, {"children", {4.5}}}) ==
        ".children[0]: a whole number is needed here");
}

TEST_CASE("Numbers are exact and have one text each", "[reject]") {
  const std::string text = GENERATE("0.5", "1e3", "", "-", "-0", "01", "2/4", "1/0", "3/1", "1/-2",
                                    "+1", " 1", "1/", "/2", "0x10", "nan");
  CAPTURE(text);
  CHECK(with_node({{"operation", "number"}, {"value", text}}) ==
        ".value: '" + text + "' is no exact number in lowest terms");
  CHECK(with_node({{"operation", "number"}, {"value", 1}}) == ".value: a text is needed here");
}

TEST_CASE("Nodes that are no mathematics are refused", "[reject]") {
  // The nodes a*P and P; the last one is a sum of points.
  const auto nodes = nlohmann::json::parse(good())["certificates"][0]["nodes"];
  const std::size_t point = nodes.size() - 1;
  const auto symbols = nlohmann::json::parse(good())["certificates"][0]["symbols"];
  std::size_t letter = 0;
  while (symbols[letter]["name"] != "a") ++letter;
  std::size_t scalar = 0;
  while (nodes[scalar]["operation"] != "symbol" || nodes[scalar]["symbol"] != letter) ++scalar;
  const auto node = [](const std::string& operation, std::vector<std::size_t> children,
                       nlohmann::json members = nlohmann::json::object()) {
    members["operation"] = operation;
    members["children"] = std::move(children);
    return with_node(members);
  };
  CHECK(node("sum", {scalar, point}) == ": summands of different types");
  CHECK(node("sum", {scalar}) == ": a wrong number of children");
  CHECK(node("product", {point, point}) == ": two factors that are no scalars");
  CHECK(node("quotient", {scalar, point}) == ": a scalar is needed here");
  CHECK(node("power", {point}, {{"exponent", 2}}) == ": a scalar is needed here");
  CHECK(node("power", {scalar}, {{"exponent", 1000000}}) == ".exponent: this number is too large");
  CHECK(node("power", {scalar}, {{"exponent", 18446744073709551615ULL}}) ==
        ".exponent: this number is too large");
  CHECK(node("apply", {scalar, scalar}) == ": a function is needed here");
  CHECK(node("component", {point}, {{"indices", {2}}}) == ": the point has no such coordinate");
  CHECK(node("entry", {point}, {{"indices", {0, 0}}}) == ": a matrix is needed here");
  CHECK(node("matrix", {scalar, point}, {{"rows", 1}, {"columns", 2}}) ==
        ": the entries of a matrix are scalars or points, all of one type");
  CHECK(node("matrix", {scalar}, {{"rows", 2}, {"columns", 2}}) == ": a wrong number of children");
  CHECK(node("determinant", {scalar}) == ": a matrix is needed here");
  CHECK(node("dot", {point, scalar}) == ": two points of one known dimension are needed here");
  CHECK(node("cross", {point, point}) == ": two points in R^3 are needed here");
  CHECK(node("bernstein", {scalar}, {{"degree", 5000}, {"index", 0}}) == ": a degree too large");
  const nlohmann::json knots = {"0", "0", "1", "1"};
  const auto spline = [&](std::size_t degree, std::size_t index, std::size_t span,
                          const nlohmann::json& at) {
    return node("bspline_basis", {scalar},
                {{"degree", degree}, {"index", index}, {"span", span}, {"knots", at}});
  };
  CHECK(spline(1, 1, 1, knots) == "RECHECKED");
  CHECK(spline(1, 2, 1, knots) == ": there are not enough knots");
  CHECK(spline(1, 1, 3, knots) == ": there are not enough knots");
  CHECK(spline(1, 0, 0, knots) == ": the span is empty");
  CHECK(spline(1, 1, 1, {"0", "1", "0", "1"}) == ": the knots are not in order");
  CHECK(node("lambda", {scalar}, {{"formals", {letter}}}) ==
        ": a formal parameter has the role 'bound' or 'parameter'");
  CHECK(node("lambda", {scalar}, {{"formals", nlohmann::json::array()}}) ==
        ": a wrong number of formal parameters");
  CHECK(node("tuple", {scalar, scalar}, {{"any_dimension", true}}) ==
        ": a point of any dimension has one coordinate");
}

TEST_CASE("A bound symbol stays in its function", "[reject]") {
  nlohmann::json json = nlohmann::json::parse(good());
  nlohmann::json& certificate = json["certificates"][0];
  for (auto& symbol : certificate["symbols"])
    if (symbol["name"] == "u") symbol["role"] = "bound";
  certificate["proofs"][0]["sequent"]["ranges"] = nlohmann::json::array();
  CHECK(judged(json.dump()) ==
        "unreadable: certificates[0].proofs[0].sequent.conclusions[0].left: the bound symbol 'u' "
        "stands outside of its function");
}

TEST_CASE("What is over a limit is unknown or refused, and never runs on", "[reject]") {
  recheck::Limits limits;
  limits.steps = 10;
  CHECK(judged(good(), limits) == "UNKNOWN limit: steps");
  limits = {};
  limits.atoms = 2;
  CHECK(judged(good(), limits) == "UNKNOWN limit: atoms");
  limits = {};
  limits.nodes = 2;
  CHECK(judged(good(), limits) == "unreadable: certificates[0].nodes: there are too many nodes");
  limits = {};
  limits.bytes = 10;
  CHECK(judged(good(), limits) == "unreadable: the text is too long");
}

TEST_CASE("A power of a power of a power ends at a limit", "[law]") {
  nlohmann::json json = nlohmann::json::parse(good());
  nlohmann::json& nodes = json["certificates"][0]["nodes"];
  nodes.push_back({{"operation", "sum"}, {"children", {0, 0}}});
  nodes[nodes.size() - 1] = {{"operation", "number"}, {"value", "3"}};
  for (int k = 0; k < 5; ++k)
    nodes.push_back(
        {{"operation", "power"}, {"exponent", 10000}, {"children", {nodes.size() - 1}}});
  const std::size_t last = nodes.size() - 1;
  auto& proof = json["certificates"][0]["proofs"][0];
  proof["sequent"]["conclusions"][0] = {{"left", last}, {"relation", "=="}, {"right", last}};
  proof["components"].erase(1);
  CHECK(judged(json.dump()) == "UNKNOWN limit: steps");
}
