#include <patchproof/certificate/rocq_layout.hpp>

#include <algorithm>
#include <catch2/catch.hpp>

namespace patchproof {
namespace {

std::string words_of(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  const auto both_spaces = [](char a, char b) { return a == ' ' && b == ' '; };
  text.erase(std::unique(text.begin(), text.end(), both_spaces), text.end());
  return text;
}

std::size_t widest(const std::string& text) {
  std::size_t result = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result = std::max(result, end - begin);
    begin = end + 1;
  }
  return result;
}

}  // namespace

TEST_CASE("Short lines stay as they are", "[certificate]") {
  CHECK(with_short_lines("") == "");
  CHECK(with_short_lines("  a + b\n\n  c\n") == "  a + b\n\n  c\n");
}

TEST_CASE("Long sums are broken before their signs, outside of brackets first", "[certificate]") {
  CHECK(with_short_lines(
            "  (1 - u) * aaaaaaaaaaaaaaaaaaaaaaaaaaaa + u * bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb"
            " - (c - d) * (e + ffffffffff)") ==
        "  (1 - u) * aaaaaaaaaaaaaaaaaaaaaaaaaaaa + u * bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb\n"
        "    - (c - d) * (e + ffffffffff)");
  CHECK(with_short_lines(
            "  (aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbbbbbbbb"
            " + ccccccccccccccccccccccccccc) * d") ==
        "  (aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbbbbbbbb\n"
        "      + ccccccccccccccccccccccccccc) * d");
}

TEST_CASE("Long lines become short and say the same", "[certificate][law]") {
  std::string text = "  forall u : R, ";
  for (int k = 0; k < 60; ++k)
    text += "(Bern 3 " + std::to_string(k % 4) + " u * (- V 0%nat " + std::to_string(k) +
            "%nat - (1 - u) ^ 2 * (fun u => D_u (b V) u 0) u)) + ";
  text += "1 = RInt (fun x => x) 0 1";
  const std::string broken = with_short_lines(text);
  CHECK(words_of(broken) == words_of(text));
  CHECK(widest(broken) <= 100);
  CHECK(with_short_lines(broken) == broken);
}

TEST_CASE("A word that is too long stays in one piece", "[certificate]") {
  const std::string word(150, 'a');
  CHECK(with_short_lines("  x + " + word + " + y") == "  x\n    + " + word + "\n    + y");
}

}  // namespace patchproof
