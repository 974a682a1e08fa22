#include <catch2/catch.hpp>
#include <random>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

// Integrals of products of unknown functions, as text.
class RandomIntegrals {
 public:
  explicit RandomIntegrals(unsigned seed) : random_{seed} {}

  std::string one() {
    const int count = below(3) == 0 ? 1 : 2;
    std::string text = "integral(" + product(count);
    if (below(3) == 0) text += " + " + product(count);
    for (int k = 0; k < count; ++k)
      text +=
          std::string{", "} + "st"[k] + " in " + pick({"[0, 1]", "[a, b]", "[-1, a]", "[0, 2]"});
    return text + ")";
  }

  std::string polynomial(const std::vector<std::string>& variables) {
    std::string text = "1";
    for (int k = 0; k < 4; ++k) {
      text += " + (" + std::to_string(below(9) - 4) + ")";
      for (const std::string& v : variables) text += "*" + v + "^" + std::to_string(below(5));
    }
    return text;
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>{0, n - 1}(random_); }
  std::string pick(const std::vector<std::string>& texts) {
    return texts.at(static_cast<std::size_t>(below(static_cast<int>(texts.size()))));
  }

  std::string product(int count) {
    std::string text = factor(count);
    for (int k = below(3); k > 0; --k) text += "*" + factor(count);
    return text;
  }

  std::string factor(int count) {
    const std::string v = count == 1 ? "s" : pick({"s", "t"});
    const std::string primes(static_cast<std::size_t>(below(3)), '\'');
    switch (below(5)) {
      case 0:
        return v + "^" + std::to_string(1 + below(3));
      case 1:
        return "f" + primes + "(" + pick({v, v, "2*" + v + " + 1", "a*" + v}) + ")";
      case 2:
        return "g" + primes + "(" + pick({v, v, "1 - " + v}) + ")";
      default: {
        const std::string derivative = pick({"", "_u", "_v", "_uv", "_uuv", "_uuvv"});
        const std::string other = count == 1 ? pick({"s", "0", "a"}) : pick({"s", "t", "1"});
        return pick({"h", "k"}) + derivative + "(" + v + ", " + other + ")";
      }
    }
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("what an integral of unknown functions comes to is right for polynomials",
          "[integral][law]") {
  RandomIntegrals random{99};
  std::vector<std::string> terms;
  std::string shows;
  for (int k = 0; k < 60; ++k) {
    terms.push_back(k % 2 == 0 ? random.one() : "diff(" + random.one() + ", a)");
    shows += "  show " + terms.back() + "\n";
  }
  const auto abstract = results_of(
      "case t\n  scalar a, b\n  scalar f(t) : C^6\n  scalar g(t) : C^4\n"
      "  scalar h(u, v) : C^8\n  scalar k(u, v) : C^6\n" +
      shows + "end\n");
  REQUIRE(abstract.at(0).shown.size() == terms.size());

  std::string claims = "  scalar a, b\n";
  for (const std::string name : {"f(t)", "g(t)"})
    claims += "  let " + name + " = " + random.polynomial({"t"}) + "\n";
  for (const std::string name : {"h(u, v)", "k(u, v)"})
    claims += "  patch " + name + " = " + random.polynomial({"u", "v"}) + "\n";
  std::size_t compared = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const std::string& value = abstract.at(0).shown[k].value;
    const bool whole =
        value.find("…") == std::string::npos && value.find("not computed") == std::string::npos;
    if (!whole) continue;
    ++compared;
    claims += "  prove p" + std::to_string(k) + ": " + terms[k] + " == " + value + "\n";
  }
  CHECK(compared > 50);
  const auto concrete = results_of("case t\n" + claims + "end\n");
  for (const ClaimResult& result : concrete.at(0).claims) {
    INFO(line_of(result));
    CHECK(result.decision.verdict == Verdict::proved);
  }
}

}  // namespace patchproof
