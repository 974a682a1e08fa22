#include <algorithm>
#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

using Json = nlohmann::json;
using Place = Json::json_pointer;

// What is for people, and what tells symbols apart without saying anything of them.
bool says_nothing(const std::string& member) {
  static const std::vector<std::string> members{"name", "label",   "claim",  "statement",
                                                "case", "program", "ordinal"};
  return std::find(members.begin(), members.end(), member) != members.end();
}

/// All places from this one on whose values are numbers, texts or truth values, and all lists.
void collect(const Json& json, const Place& place, std::vector<Place>& places) {
  const Json& here = json.at(place);
  if (!here.is_object()) places.push_back(place);
  if (here.is_array())
    for (std::size_t k = 0; k < here.size(); ++k) collect(json, place / k, places);
  if (here.is_object())
    for (const auto& [name, value] : here.items())
      if (!says_nothing(name)) collect(json, place / name, places);
}

/// Other values that could stand there.
std::vector<Json> others(const Json& value) {
  if (value.is_boolean()) return {!value.get<bool>()};
  if (value.is_number()) return {value.get<int>() + 1, value.get<int>() - 1};
  if (value.is_array()) {
    std::vector<Json> result;
    for (std::size_t k = 0; k < value.size(); ++k) {
      Json fewer = value;
      fewer.erase(k);
      result.push_back(std::move(fewer));
    }
    return result;
  }
  const std::string text = value.get<std::string>();
  static const std::vector<std::string> signs{"==", "!=", "<", "<=", ">", ">="};
  if (std::find(signs.begin(), signs.end(), text) != signs.end())
    return std::vector<Json>(signs.begin(), signs.end());
  if (text.find_first_not_of("-/0123456789") != std::string::npos) return {};
  return {text == "0" ? "1" : text.starts_with("-") ? text.substr(1) : "-" + text, "5/7"};
}

/// The changes that the checker does not mind, each as "place: old -> new".
std::vector<std::string> unnoticed(const std::string& good, const std::string& below,
                                   std::size_t& tried) {
  const Json json = Json::parse(good);
  std::vector<Place> places;
  collect(json, Place{"/certificates/0" + below}, places);
  std::vector<std::string> result;
  for (const Place& place : places) {
    for (const Json& other : others(json.at(place))) {
      if (other == json.at(place)) continue;
      Json changed = json;
      changed.at(place) = other;
      ++tried;
      if (judged(changed.dump()) == "RECHECKED")
        result.push_back(place.to_string().substr(15) + ": " + json.at(place).dump() + " -> " +
                         other.dump());
    }
  }
  return result;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("Changes of a proof by equations are noticed", "[law]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar f(t) : C^2
    scalar a
    assume rule: f(u) == a*u^3
    prove slope: f'(1/2) + 1/(1 + a^2) == 3/4*a + 1/(1 + a^2)
    prove a_term: a == 0
    prove below: 1 + a^2 == 0
    prove one: 1 == 0
    prove half: 1/2 == 0)"};
  SequentProof proof = by_equations(claims.sequent("slope"),
                                    {{{0, 0, {claims.term("half")}, {1}}, claims.term("one")}});
  proof.not_zero = {
      {claims.term("below"), std::nullopt,
       SignProof{{}, Combination{{{1, {}, {}}, {1, {claims.term("a_term")}, {}}}, {}}}, false}};
  const std::string good = document_of(proof);
  REQUIRE(judged(good) == "RECHECKED");
  std::size_t tried = 0;
  // 0/(1 + a^2) on both sides, more places for the hypothesis, a function as smooth as it has to
  // be: each of these is a right proof of another statement.
  CHECK(unnoticed(good, "", tried) ==
        Lines{"/nodes/13/children/0: 7 -> 6",
              "/proofs/0/sequent/ranges: [{\"lower\":6,\"parameter\":1,\"upper\":7}] -> []",
              "/symbols/0/smoothness: 2 -> 3", "/symbols/0/smoothness: 2 -> 1"});
  CHECK(tried > 100);
}

TEST_CASE("Changes of a proof of a sign are noticed", "[law]") {
  const Claims claims{R"(
    scalar a, b
    assume positive: a > 0
    assume order: b >= a
    prove sign: a*b + a^2*(b - 2*a)^2 > 0
    prove a_term: a == 0
    prove b_term: b == 0
    prove cut_at: b - 2*a == 0)"};
  // Fact 0 is a, 1 is b - a, 2 is b, shown in a step, 3 is b - 2*a or 2*a - b.
  const SignProof::Step step{
      claims.term("b_term"), true, {{{1, {}, {{0, 1}}}, {1, {}, {{1, 1}}}}, {}}};
  const SignProof half{
      {}, Combination{{{1, {}, {{0, 1}, {2, 1}}}, {1, {claims.term("a_term")}, {{3, 2}}}}, {}}};
  SequentProof proof = by_facts(claims.sequent("sign"), {});
  proof.components[0].why = SignProof{{step}, SignProof::Cut{claims.term("cut_at"), {half, half}}};
  const std::string good = document_of(proof);
  REQUIRE(judged(good) == "RECHECKED");
  std::size_t tried = 0;
  // Statement and proof have nodes in common, so a changed node is mostly another true statement.
  // Of the rest: a weaker conclusion, a stronger hypothesis.
  CHECK(unnoticed(good, "/proofs", tried) ==
        Lines{"/proofs/0/sequent/conclusions/0/relation: \">\" -> \"!=\"",
              "/proofs/0/sequent/conclusions/0/relation: \">\" -> \">=\"",
              "/proofs/0/sequent/hypotheses/1/relation: \">=\" -> \">\""});
  CHECK(tried > 100);
}
