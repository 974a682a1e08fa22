#include <patchproof/certificate/misunderstood.hpp>

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <string_view>

#include <patchproof/certificate/rocq_tokens.hpp>
#include <tests/certificate/small_case.hpp>

namespace patchproof {
namespace {

const CertifiedCase& small() {
  static const CertifiedCase all = certified_case(golden_certificate("small.proof"));
  return all;
}

const std::string& printed() {
  static const std::string text = golden_certificate("small.printed");
  return text;
}

std::string found_in(const std::string& output) {
  std::string result;
  for (const Misunderstanding& one : misunderstood(small().given, small().certificates, output))
    result += one.claim + ": " + one.what + "\n";
  return result;
}

std::string after(const std::string& old_part, const std::string& new_part) {
  return found_in(with_part(printed(), old_part, new_part));
}

}  // namespace

TEST_CASE("What Rocq prints of a small case is what was asked", "[certificate]") {
  CHECK(found_in(printed()) == "");
}

TEST_CASE("Names of variables and line breaks play no part", "[certificate]") {
  CHECK(after("RInt (fun x : R => RInt (fun y : R => b V x y) 0 1)",
              "RInt (fun y : R =>\nRInt (fun\nx0 : R => b V y x0) 0 1)") == "");
  CHECK(after("r = fun (C D : R -> R) (u v : R) => (1 - v) * C u + v * D u",
              "r = fun (A C : R -> R) (C1 u : R) => (1 - u) * (A C1) + (u * C C1)") == "");
}

TEST_CASE("A definition may be unfolded, and functions applied", "[certificate]") {
  CHECK(after("r C D 0 v = C 0", "(1 - v) * C 0 + v * D 0 = C 0") == "");
  CHECK(after("r C D 0 v = C 0", "(fun u : R => r C D u v) 0 = C 0") == "");
  CHECK(after("r C D 0 v = C 0", "(fun (f : R -> R) (u : R) => r f D u v) C 0 = C 0") == "");
  CHECK(after("D_v (D_u (r C D)) u v", "D_v (D_u (fun x y : R => r C D x y)) u v") == "");
}

TEST_CASE("A definition is unfolded at each of its arguments", "[certificate]") {
  CHECK(after("r C D 1 v = r C D 0 v", "r C D 1 v = r C D 0 v") == "");
  CHECK(after("r C D 1 v = r C D 0 v", "r C D 1 v = r C D 1 v") ==
        "small.wrong: conclusion: Rocq understood (1 - v) * C 1 + v * D 1 where (1 - v) * C "
        "0 + v * D 0 was asked, in (1 - v) * C 1 + v * D 1 = (1 - v) * C 1 + v * …\n");
}

TEST_CASE("A variable that does not occur has no name in what Rocq prints", "[certificate]") {
  CHECK(after("(c : nat -> R), R -> C 0", "(c : nat -> R) (e : R), C 0") == "");
  CHECK(after("(c : nat -> R), R -> C 0", "(c : nat -> R), C 0") ==
        "small.first: behind premise 0: Rocq understood C 0 = D 0 -> (forall (u : R), 0 <= u "
        "/\\ u <= 1 -> u <= 1 / 2 -> …) -> … where forall (u : R), C 0 = D 0 -> (forall (x7 : "
        "R), 0 <= x7 /\\ x7 <= 1 -> x7 <= 1 / … -> …) -> … was asked\n");
  CHECK(after("(c : nat -> R), R -> C 0", "(c : nat -> R), (R -> R) -> C 0") ==
        "small.first: behind premise 0: Rocq understood forall (_ : R -> R), C 0 = D 0 -> "
        "(forall (u : R), 0 <= u /\\ u <= 1 -> u <= 1 / … -> …) -> … where forall (_ : R), C "
        "0 = D 0 -> (forall (u : R), 0 <= u /\\ u <= 1 -> u <= 1 / … -> …) -> … was asked\n");
}

TEST_CASE("A changed statement is found", "[certificate][reject]") {
  // A sign, an index, a coefficient, two ends, two variables, a relation.
  CHECK(after("Derive D u - Derive C u", "Derive D u + Derive C u") ==
        "small.mixed: conclusion: Rocq understood Derive D u + Derive C u where Derive D u - "
        "Derive C u was asked, in D_v (D_u (fun (x7 : R) => fun (x8 : R) => (1 - x8) * C x7 "
        "+ x8 * D x7)) u v = Derive … … + …\n");
  CHECK(after("(V 0%nat 0%nat + V 0%nat 1%nat", "(V 0%nat 0%nat + V 1%nat 1%nat") ==
        "small.area: conclusion: Rocq understood V 1%nat 1%nat where V 0%nat 1%nat was "
        "asked, in RInt (fun (x7 : R) => RInt (fun (x8 : R) => Bern 1 0 x7 * Bern 1 0 x8 * V "
        "0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 x8 * V 0%nat 1%nat + … * … * … + …) … …) … … = "
        "…\n");
  CHECK(after("= 1 / 4 * (V", "= 1 / 3 * (V") ==
        "small.area: conclusion: Rocq understood 3 where 4 was asked, in RInt (fun (x7 : R) "
        "=> RInt (fun (x8 : R) => Bern 1 0 x7 * Bern 1 0 x8 * V 0%nat 0%nat + Bern 1 0 x7 * "
        "Bern 1 1 x8 * V 0%nat 1%nat + … * … * … + …) … …) … … = …\n");
  CHECK(after("RInt (fun y : R => b V x y) 0 1)", "RInt (fun y : R => b V x y) 1 0)") ==
        "small.area: conclusion: Rocq understood RInt (fun (x8 : R) => Bern 1 0 x7 * Bern 1 "
        "0 x8 * V 0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 x8 * V 0%nat 1%nat + Bern 1 1 x7 * "
        "Bern 1 0 … * … + …) … … where RInt (fun (x8 : R) => Bern 1 0 x7 * Bern 1 0 x8 * V "
        "0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 x8 * V 0%nat 1%nat + Bern 1 1 x7 * Bern 1 0 … "
        "* … + …) … … was asked, in RInt (fun (x7 : R) => RInt (fun (x8 : R) => Bern 1 0 x7 "
        "* Bern 1 0 x8 * V 0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 x8 * V 0%nat 1%nat + … * … * "
        "… + …) … …) … … = …\n");
  CHECK(after("RInt (fun y : R => b V x y)", "RInt (fun y : R => b V y x)") ==
        "small.area: conclusion: Rocq understood Bern 1 0 x8 * Bern 1 0 x7 * V 0%nat 0%nat + "
        "Bern 1 0 x8 * Bern 1 1 x7 * V 0%nat 1%nat + Bern 1 1 x8 * Bern 1 0 x7 * V 1%nat "
        "0%nat + … where Bern 1 0 x7 * Bern 1 0 x8 * V 0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 "
        "x8 * V 0%nat 1%nat + Bern 1 1 x7 * Bern 1 0 x8 * V 1%nat 0%nat + … was asked, in "
        "RInt (fun (x7 : R) => RInt (fun (x8 : R) => Bern 1 0 x8 * Bern 1 0 x7 * V 0%nat "
        "0%nat + Bern 1 0 x8 * Bern 1 1 x7 * V 0%nat 1%nat + … * … * … + …) … …) … … = …\n");
  CHECK(after("- a > 0", "- a >= 0") ==
        "small.sign: conclusion: Rocq understood 2 * v + 4 - 2 * u - a >= 0 where 2 * v + 4 "
        "- 2 * u - a > 0 was asked\n");
  CHECK(after("p 1%nat - q 1%nat + q 1%nat = p 1%nat", "p 1%nat - q 1%nat + q 1%nat = p 0%nat") ==
        "small.points: conclusion: Rocq understood p 0%nat where p 1%nat was asked, in p "
        "1%nat - q 1%nat + q 1%nat = p 0%nat\n");
  CHECK(after("smooth 2 D ->", "smooth 1 D ->") ==
        "small.mixed: premise 2: Rocq understood smooth 1 D where smooth 2 D was asked\n");
  CHECK(after("r C D 0 v = C 0", "r D C 0 v = C 0") ==
        "small.corner: conclusion: Rocq understood (1 - v) * D 0 + v * C 0 where (1 - v) * C "
        "0 + v * D 0 was asked, in (1 - v) * D 0 + v * C 0 = C 0\n");
  CHECK(after("D_v (D_u (r C D)) u v", "D_u (D_v (r C D)) u v") ==
        "small.mixed: conclusion: Rocq understood D_u (D_v (fun (x7 : R) => fun (x8 : R) => "
        "(1 - x8) * C x7 + x8 * D x7)) where D_v (D_u (fun (x7 : R) => fun (x8 : R) => (1 - "
        "x8) * C x7 + x8 * D x7)) was asked, in D_u (D_v (fun (x7 : R) => fun (x8 : R) => (1 "
        "- x8) * C x7 + x8 * D x7)) u v = Derive … … - …\n");
  CHECK(after("(V 0%nat 0%nat + V", "(- V 0%nat 0%nat + V") ==
        "small.area: conclusion: Rocq understood - V 0%nat 0%nat where V 0%nat 0%nat was "
        "asked, in RInt (fun (x7 : R) => RInt (fun (x8 : R) => Bern 1 0 x7 * Bern 1 0 x8 * V "
        "0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 x8 * V 0%nat 1%nat + … * … * … + …) … …) … … = "
        "…\n");
}

TEST_CASE("Changed premises are found", "[certificate][reject]") {
  CHECK(after("smooth 2 D ->\n", "") ==
        "small.mixed: premise 2: Rocq understood C 0 = D 0 where smooth 2 D was asked\n");
  CHECK(after("smooth 2 D ->\nC 0 = D 0", "smooth 2 D ->\nC 1 = D 0") ==
        "small.mixed: premise 3: Rocq understood 1 where 0 was asked, in C 1 = D 0\n");
  const std::string corner = "claim_corner = \nforall (a : R) (C D f g : R -> R), ";
  CHECK(after(corner, "claim_corner = \nforall (C D f g : R -> R) (a : R), ") ==
        "small.corner: behind premise 0: Rocq understood forall (C : R -> R), forall (D : R "
        "-> R), forall (f : R -> R), forall (g : R -> R), forall (a : R), C 0 = D 0 -> "
        "(forall (u : R), 0 <= u /\\ u <= 1 -> … -> …) -> … where forall (C : R), forall (D : "
        "R -> R), forall (f : R -> R), forall (g : R -> R), forall (a : R -> R), D 0 = f 0 "
        "-> (forall (u : R), 0 <= u /\\ u <= 1 -> … -> …) -> … was asked\n");
  CHECK(after(corner, "claim_corner = \nforall (a : R) (C D f g : R -> R) (h : R), ") ==
        "small.corner: behind premise 0: Rocq understood forall (h : R), C 0 = D 0 -> "
        "(forall (u : R), 0 <= u /\\ u <= 1 -> u <= 1 / … -> …) -> … where C 0 = D 0 -> "
        "(forall (h : R), 0 <= h /\\ h <= 1 -> h <= 1 / 2 -> …) -> … was asked\n");
  const std::string rest = "C 0 = D 0 -> (forall u : R, 0 <= u <= 1 -> u <= 1 / 2 -> ";
  CHECK(after(corner + rest, corner + "C 0 = D 0 -> (forall u : R, 0 <= u <= 1 -> ") ==
        "small.corner: premise 2: Rocq understood f x5 + g x5 = 1 where x5 <= 1 / 2 -> f x5 "
        "+ g x5 = 1 was asked\n");
  CHECK(after("u <= 1 / 2 -> r C D 0 v = C 0", "u < 1 / 2 -> r C D 0 v = C 0") ==
        "small.corner: premise 6: Rocq understood u < 1 / 2 where u <= 1 / 2 was asked\n");
  CHECK(after("0 <= v <= 1 -> u <= 1 / 2 -> r C D 0 v", "u <= 1 / 2 -> 0 <= v <= 1 -> r C D 0 v") ==
        "small.corner: premise 5: Rocq understood u <= 1 / 2 where 0 <= v /\\ v <= 1 was "
        "asked\n");
  CHECK(after("forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 -> u <= 1 / 2 -> r C D 0 v",
              "forall v u : R, 0 <= u <= 1 -> 0 <= v <= 1 -> u <= 1 / 2 -> r C D 0 v") ==
        "small.corner: premise 4: Rocq understood u where v was asked, in 0 <= u\n");
  CHECK(after("forall u : R, 0 <= u <= 1 -> u <= 1 / 2 -> RInt",
              "forall u : R, 0 <= u /\\ u < 1 -> u <= 1 / 2 -> RInt") ==
        "small.area: premise 4: Rocq understood u < 1 where u <= 1 was asked\n");
}

TEST_CASE("A changed definition is found in the claims that use it", "[certificate][reject]") {
  CHECK_THAT(after("r = fun (C D : R -> R) (u v : R) => (1 - v)",
              "r = fun (C D : R -> R) (u v : R) => (1 - u)"),
             Catch::Contains("small.mixed: conclusion: Rocq understood x7 where x8 was asked, in D_v (D_u (fun "
        "(x7 : R) => fun (x8 : R) => (1 - x7) * C x7 + x8 * D x7)) u v = Derive … … - …\n"));
  CHECK_THAT(after("r = fun (C D : R -> R) (u v", "r = fun (D C : R -> R) (u v"),
             Catch::Contains("small.mixed: conclusion: Rocq understood (1 - x8) * D x7 + x8 * C x7 where (1 - x8) "
        "* C x7 + x8 * D x7 was asked, in D_v (D_u (fun (x7 : R) => fun (x8 : R) => (1 - x8) "
        "* D x7 + x8 * C x7)) u v = Derive … … - …\n"));
  CHECK(after("bezier_patch V u v\n", "bezier_patch V v u\n") ==
        "small.area: conclusion: Rocq understood Bern 1 0 x8 * Bern 1 0 x7 * V 0%nat 0%nat + "
        "Bern 1 0 x8 * Bern 1 1 x7 * V 0%nat 1%nat + Bern 1 1 x8 * Bern 1 0 x7 * V 1%nat "
        "0%nat + … where Bern 1 0 x7 * Bern 1 0 x8 * V 0%nat 0%nat + Bern 1 0 x7 * Bern 1 1 "
        "x8 * V 0%nat 1%nat + Bern 1 1 x7 * Bern 1 0 x8 * V 1%nat 0%nat + … was asked, in "
        "RInt (fun (x7 : R) => RInt (fun (x8 : R) => Bern 1 0 x8 * Bern 1 0 x7 * V 0%nat "
        "0%nat + Bern 1 0 x8 * Bern 1 1 x7 * V 0%nat 1%nat + … * … * … + …) … …) … … = …\n");
  CHECK_THAT(after("r = fun", "other = fun"),
             Catch::Contains("small.mixed: claim_mixed cannot be compared: Rocq has not printed r\n"));
  CHECK_THAT(after("r = fun", "r = func"),
             Catch::Contains("small.mixed: claim_mixed cannot be compared: what Rocq printed of r cannot be "
        "read: line 1: expected ')', found ':'\n"));
  CHECK(after("(u v : R) => bezier_patch V u v", "(u v : R) => b V u v") ==
        "small.area: claim_area cannot be compared: nested too deeply\n");
}

TEST_CASE("No number and no sign can be changed unnoticed", "[certificate][law]") {
  const std::map<std::string_view, std::string> others{
      {"+", "-"},     {"-", "+"},       {"*", "/"},           {"/", "*"},    {"^", "*"},
      {"<=", "<"},    {"<", "<="},      {">", "<"},           {"=", "<>"},   {"->", "/\\"},
      {"/\\", "->"},  {"0", "1"},       {"1", "0"},           {"2", "1"},    {"4", "2"},
      {"~", ""},      {"C", "D"},       {"D", "C"},           {"u", "v"},    {"v", "u"},
      {"f", "g"},     {"p", "q"},       {"q", "p"},           {"Bern", "f"}, {"D_u", "D_v"},
      {"D_v", "D_u"}, {"RInt", "sqrt"}, {"smooth", "smooth2"}};
  std::size_t changes = 0;
  for (RocqToken token = rocq_token(printed(), 0); token.kind != RocqToken::Kind::end;
       token = rocq_token(printed(), token.position + token.text.size())) {
    const auto other = others.find(token.text);
    const std::size_t line = printed().rfind('\n', token.position) + 1;
    const std::string_view before = std::string_view{printed()}.substr(line, token.position - line);
    // Renaming a binder may change nothing; the types of definitions that Rocq prints are not
    // needed.
    const bool binder = before.empty() || before.starts_with("Arguments") ||
                        before.starts_with("     :") || printed()[token.position + 1] == ',' ||
                        std::string_view{printed()}.substr(token.position).starts_with("u v :") ||
                        std::string_view{printed()}.substr(token.position).starts_with("u :");
    if (other == others.end() || (binder && token.kind == RocqToken::Kind::name)) continue;
    if (before.starts_with("     :") && token.text == "->") continue;
    std::string text = printed();
    text.replace(token.position, token.text.size(), other->second);
    ++changes;
    INFO(text.substr(line, text.find('\n', line) - line));
    INFO(token.position - line);
    CHECK(found_in(text) != "");
  }
  CHECK(changes > 300);
}

TEST_CASE("Damaged output breaks nothing", "[certificate]") {
  std::mt19937 random{11};
  for (int round = 0; round < 300; ++round) {
    std::string text = printed();
    for (int k = 0; k < 1 + round % 5; ++k) {
      const std::size_t at = random() % text.size();
      if (round % 2 == 0)
        text.erase(at, random() % 40);
      else
        text.insert(at, text.substr(random() % text.size(), random() % 60));
    }
    for (const Misunderstanding& one : misunderstood(small().given, small().certificates, text)) {
      CHECK(one.claim.starts_with("small."));
      CHECK(one.what.size() < 1500);
    }
  }
}

TEST_CASE("A theorem about something else is found", "[certificate][reject]") {
  CHECK(after("     : ~ claim_wrong", "     : claim_wrong") ==
        "small.wrong: certified_wrong shows something else than ~ claim_wrong\n");
  CHECK(after("     : claim_area", "     : claim_points") ==
        "small.area: certified_area shows something else than claim_area\n");
  CHECK(after("certified_sign\n", "") ==
        "small.area: what Rocq printed of certified_area cannot be read: line 2: expected "
        "the end, found ':'\n"
        "small.sign: Rocq has not printed certified_sign\n");
  CHECK(after("claim_sign = ", "claim_design = ") ==
        "small.sign: Rocq has not printed claim_sign\n");
}

TEST_CASE("What cannot be read is not what was asked", "[certificate][reject]") {
  CHECK(after("- a > 0", "- a > ...") ==
        "small.sign: what Rocq printed of claim_sign cannot be read: line 3: expected a "
        "term, found '.'\n");
  CHECK(after("- a > 0", "- a > 0%nat") ==
        "small.sign: claim_sign cannot be compared: a natural number in the place of a real "
        "one\n");
  CHECK(after("- a > 0", "- a > hidden") ==
        "small.sign: claim_sign cannot be compared: the name 'hidden' is not known\n");
  CHECK(after("- a > 0", "- a 1 > 0") ==
        "small.sign: conclusion: Rocq understood a 1 where a was asked, in 2 * v + 4 - 2 * u "
        "- a 1 > 0\n");
  CHECK(after("- a > 0", "- a > (fun x : R => x x) (fun x : R => x x)") ==
        "small.sign: claim_sign cannot be compared: nested too deeply\n");
  CHECK(found_in("").size() > 100);
}

}  // namespace patchproof
