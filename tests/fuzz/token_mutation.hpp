#pragma once

#include <cctype>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace patchproof::fuzz {

/// The words and signs of a text, blanks and line ends among them.
inline std::vector<std::string> tokens_of(const std::string& text) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  std::vector<std::string> tokens;
  for (const char c : text) {
    const bool goes_on = !tokens.empty() && is_word(c) && is_word(tokens.back().back());
    if (goes_on)
      tokens.back() += c;
    else
      tokens.emplace_back(1, c);
  }
  return tokens;
}

/// Another text that is still nearly a case: tokens are exchanged, repeated, left out, or replaced
/// by others of the text and by words of the language. Bytes changed at random hardly ever get
/// beyond the lexer.
inline std::string changed_by_tokens(const std::string& text, std::uint64_t seed) {
  static const std::vector<std::string> words{"0",
                                              "1",
                                              "2",
                                              "3",
                                              "1/0",
                                              "0.5",
                                              "(",
                                              ")",
                                              "[",
                                              "]",
                                              ",",
                                              ";",
                                              "+",
                                              "-",
                                              "*",
                                              "/",
                                              "^",
                                              "==",
                                              "!=",
                                              "<=",
                                              ">",
                                              "..",
                                              "'",
                                              "?",
                                              "_u",
                                              "_uv",
                                              ".x",
                                              "u",
                                              "v",
                                              "t",
                                              "P",
                                              "C",
                                              "r",
                                              "b",
                                              "sum",
                                              "net",
                                              "bezier",
                                              "coons",
                                              "ruled",
                                              "diff",
                                              "sin",
                                              "sqrt",
                                              "exp",
                                              "pi",
                                              "det",
                                              "dot",
                                              "cross",
                                              "integral",
                                              "param",
                                              "scalar",
                                              "point",
                                              "curve",
                                              "patch",
                                              "matrix",
                                              "assume",
                                              "prove",
                                              "refute",
                                              "derive",
                                              "from",
                                              "gives",
                                              "leaves",
                                              "using",
                                              "for",
                                              "in",
                                              "joint",
                                              "boundary",
                                              "degree",
                                              "spline",
                                              "segment",
                                              "bspline",
                                              "knots",
                                              "let",
                                              "show",
                                              "family",
                                              "R",
                                              ":",
                                              "=",
                                              "i",
                                              "minimizes over",
                                              "on",
                                              "uniform",
                                              "clamped",
                                              "weights",
                                              "18446744073709551616"};
  std::mt19937_64 random{seed};
  std::vector<std::string> tokens = tokens_of(text);
  const auto any = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  const auto place = [&](std::size_t i) { return tokens.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t times = 1 + any(4); times > 0; --times) {
    if (tokens.empty()) tokens.push_back("case a.b\n");
    const std::size_t i = any(tokens.size());
    const std::size_t j = any(tokens.size());
    switch (any(6)) {
      case 0:
        tokens[i] = words[any(words.size())];
        break;
      case 1:
        tokens[i] = tokens[j];
        break;
      case 2:
        std::swap(tokens[i], tokens[j]);
        break;
      case 3:
        tokens.erase(place(i), place(std::min(tokens.size(), i + 1 + any(4))));
        break;
      case 4:
        tokens.insert(place(i), words[any(words.size())]);
        break;
      default: {
        const std::vector<std::string> run(place(j),
                                           place(std::min(tokens.size(), j + 1 + any(12))));
        tokens.insert(place(i), run.begin(), run.end());
      }
    }
  }
  std::string result;
  for (const std::string& token : tokens) result += token;
  return result;
}

}  // namespace patchproof::fuzz

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

/// Every fourth time by bytes, otherwise by tokens. Not inline: libFuzzer looks for it by its name,
/// and a target is one file.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t longest, unsigned int seed) {
  if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, longest);
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string changed = patchproof::fuzz::changed_by_tokens(text, seed);
  const std::size_t length = std::min(changed.size(), longest);
  std::copy_n(changed.begin(), length, data);
  return length;
}
