#include <patchproof/latex/line_breaks.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace patchproof {

namespace {

// Hundredths of an em, of Computer Modern.
constexpr int letter = 56;
constexpr int digit = 50;
constexpr int bracket = 39;
constexpr int sign = 122;
constexpr int symbol = 62;
constexpr int surely_fits = 1100;
constexpr int widest_piece = 2200;
// Inside of this many brackets a line may still be broken.
constexpr int deepest_brackets = 3;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The end of the command that begins at `at` with a backslash.
std::size_t end_of_command(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  return end == at + 1 ? std::min(end + 1, text.size()) : end;
}

/// The end of the group, of the command or of the letter at `at`.
std::size_t end_of_argument(const std::string& text, std::size_t at) {
  if (at >= text.size()) return at;
  if (text[at] == '\\') return end_of_command(text, at);
  if (text[at] != '{') return at + 1;
  int depth = 0;
  for (std::size_t k = at; k < text.size(); ++k) {
    if (text[k] == '\\') {
      ++k;
      continue;
    }
    if (text[k] == '{') ++depth;
    if (text[k] == '}' && --depth == 0) return k + 1;
  }
  return text.size();
}

class Width {
 public:
  explicit Width(const std::string& text) : text_{text} {}

  int total() {
    int width = 0;
    int widest = 0;
    while (at_ < text_.size()) {
      // Rows of a matrix stand below each other.
      if (text_.compare(at_, 2, "\\\\") == 0) {
        widest = std::max(widest, width);
        width = 0;
        at_ += 2;
        continue;
      }
      width += next();
    }
    return std::max(widest, width);
  }

 private:
  int argument() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    const std::size_t end = end_of_argument(text_, at_);
    std::string inside = text_.substr(at_, end - at_);
    if (inside.size() >= 2 && inside.front() == '{') inside = inside.substr(1, inside.size() - 2);
    at_ = end;
    return Width{inside}.total();
  }

  int next() {
    const char c = text_[at_];
    if (c == '\\') return command();
    ++at_;
    if (c == '_' || c == '^') return argument() * 7 / 10;
    if (c == ' ' || c == '{' || c == '}') return 0;
    if (c == '&') return 2 * digit;
    if (std::string_view{"+-=<>"}.find(c) != std::string_view::npos) return sign;
    if (std::string_view{"()[]|,.'"}.find(c) != std::string_view::npos) return bracket;
    return is_letter(c) ? letter : digit;
  }

  int command() {
    const std::size_t end = end_of_command(text_, at_);
    const std::string name = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end;
    if (name == "tfrac" || name == "frac") {
      const int above = argument();
      const int below = argument();
      return std::max(above, below) * (name == "tfrac" ? 7 : 10) / 10 + digit / 2;
    }
    if (name == "begin" || name == "end") {
      at_ = end_of_argument(text_, at_);
      return bracket * 2;
    }
    static const std::vector<std::string_view> without_width{
        "left",   "right",  "bigl",         "bigr",         "mathit", "mathrm",
        "mathbf", "mathsf", "operatorname", "displaystyle", ","};
    if (std::find(without_width.begin(), without_width.end(), name) != without_width.end())
      return 0;
    static const std::vector<std::string_view> relations{"le",  "leq",   "ge",  "geq",
                                                         "neq", "times", "cdot"};
    if (std::find(relations.begin(), relations.end(), name) != relations.end()) return sign;
    if (name == "sin" || name == "cos" || name == "det") return 3 * digit;
    return symbol;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

bool is_binary_place(const std::string& text, std::size_t at) {
  std::size_t before = at;
  while (before > 0 && text[before - 1] == ' ') --before;
  if (before == 0) return false;
  return std::string_view{"([{,+-=<>&_^"}.find(text[before - 1]) == std::string_view::npos;
}

/// Where the text may be broken inside of `deepest` brackets.
class Cut {
 public:
  Cut(const std::string& text, int deepest) : text_{text}, deepest_{deepest} {}

  std::vector<std::string> parts() {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < text_.size();) {
      const char c = text_[k];
      const bool open_place = fixed_ == 0 && depth_ <= deepest_;
      if (open_place && k > begin && (c == '+' || c == '-') && is_binary_place(text_, k)) {
        take(begin, k);
        begin = k;
      }
      // Between arguments only where nothing else helps.
      if (open_place && deepest_ == deepest_brackets && depth_ > 0 && c == ',') {
        take(begin, k + 1);
        begin = k + 1;
      }
      k = step(k);
    }
    take(begin, text_.size());
    return std::move(parts_);
  }

 private:
  // One letter, command, or group, whose inside is no place for a break.
  std::size_t step(std::size_t k) {
    const char c = text_[k];
    if (c == '\\') {
      const std::size_t end = end_of_command(text_, k);
      const std::string name = text_.substr(k + 1, end - k - 1);
      // Brackets that grow cannot be broken.
      if (name == "left" || name == "begin") ++fixed_;
      if (name == "right" || name == "end") --fixed_;
      if (name == "left" || name == "right")
        return std::min(end_of_argument(text_, end), text_.size());
      return end;
    }
    if (c == '{') return end_of_argument(text_, k);
    if (c == '(' || c == '[') ++depth_;
    if (c == ')' || c == ']') --depth_;
    return k + 1;
  }

  void take(std::size_t begin, std::size_t end) {
    while (begin < end && text_[begin] == ' ') ++begin;
    while (end > begin && text_[end - 1] == ' ') --end;
    if (end == begin) return;
    std::string part = text_.substr(begin, end - begin);
    // The space behind a comma would be lost at the end of a formula.
    if (part.ends_with(',') && !part.ends_with("\\,")) part += "\\,";
    parts_.push_back(std::move(part));
  }

  const std::string& text_;
  int deepest_;
  int depth_ = 0;
  int fixed_ = 0;
  std::vector<std::string> parts_;
};

/// The outermost brackets that grow, with a fixed size instead: between those a line may break.
std::string with_fixed_brackets(const std::string& text) {
  std::string result;
  int depth = 0;
  for (std::size_t k = 0; k < text.size();) {
    if (text.compare(k, 6, "\\left(") == 0 && depth++ == 0) {
      result += "\\bigl(";
      k += 6;
    } else if (text.compare(k, 7, "\\right)") == 0 && --depth == 0) {
      result += "\\bigr)";
      k += 7;
    } else {
      result += text[k++];
    }
  }
  return result;
}

}  // namespace

int estimated_width(const std::string& latex) { return Width{latex}.total(); }

std::vector<std::string> pieces(const std::string& latex) {
  std::vector<std::string> result{latex};
  for (int depth = 0; depth <= deepest_brackets; ++depth) {
    std::vector<std::string> finer;
    for (const std::string& piece : result) {
      if (depth > 0 && estimated_width(piece) <= widest_piece) {
        finer.push_back(piece);
        continue;
      }
      const std::string text = depth == 0 ? piece : with_fixed_brackets(piece);
      const std::vector<std::string> parts = Cut{text, depth}.parts();
      if (parts.size() <= 1)
        finer.push_back(piece);
      else
        finer.insert(finer.end(), parts.begin(), parts.end());
    }
    result = std::move(finer);
  }
  return result;
}

bool is_too_wide(const std::string& latex) {
  // A line holds about 36 em; letters of 11 points are still read at 7.
  constexpr int widest = 5700;
  if (estimated_width(latex) <= widest) return false;
  const std::vector<std::string> parts = pieces(latex);
  return std::any_of(parts.begin(), parts.end(), [](const std::string& part) {
    return estimated_width(part) > widest;
  });
}

std::string breakable(const std::string& latex) {
  if (estimated_width(latex) <= surely_fits) return latex;
  std::vector<std::string> parts = pieces(latex);
  if (parts.size() == 1) return latex;
  // The first sign belongs to its summand; the others stand between two.
  if (parts.front().front() == '-') parts.front().replace(0, 1, "{-}");
  std::string result;
  for (const std::string& part : parts) result += "\\pps{" + part + "}";
  return result;
}

}  // namespace patchproof
