#include <patchproof/language/notation_check.hpp>

#include <set>
#include <string_view>

#include <patchproof/language/fault.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest_notation = 200;
constexpr int deepest_braces = 20;

using Names = std::set<std::string, std::less<>>;

// Commands that are put on what follows them: alphabets and accents.
const Names& commands_with_argument() {
  static const Names names{"mathbf", "mathrm", "mathit", "mathsf", "mathtt", "mathcal", "mathbb",
                           "mathfrak", "boldsymbol", "bar", "tilde", "hat", "vec", "dot", "ddot",
                           "check", "breve", "acute", "grave", "overline", "underline", "widetilde",
                           "widehat", "overrightarrow"};
  return names;
}

const Names& symbols() {
  static const Names names{
      "prime", "ast", "star", "circ", "bullet", "dagger", "partial", "nabla", "ell", "hbar", "Re",
      "Im", "aleph", "infty", "perp", "parallel", "pm", "times", "cdot", "oplus", "otimes",
      "alpha", "beta", "gamma", "delta", "epsilon", "varepsilon", "zeta", "eta", "theta",
      "vartheta", "iota", "kappa", "lambda", "mu", "nu", "xi", "pi", "varpi", "rho", "varrho",
      "sigma", "varsigma", "tau", "upsilon", "phi", "varphi", "chi", "psi", "omega", "Gamma",
      "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega"};
  return names;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_plain(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') ||
         std::string_view{"*+-(),.|/=<>[]"}.find(c) != std::string_view::npos;
}

// Reads atoms with their scripts, as TeX does, so that TeX finds nothing to complain of.
class Check {
 public:
  explicit Check(const syntax::Notation& notation)
      : notation_{notation}, text_{notation.latex} {}

  void run() {
    if (text_.find_first_not_of(' ') == std::string_view::npos)
      throw Fault{notation_.span, "an empty notation"};
    if (text_.size() > longest_notation)
      throw Fault{notation_.span, "a notation has at most " + std::to_string(longest_notation) +
                                      " characters"};
    atoms(0);
    if (at_ < text_.size()) fail(at_, at_ + 1, "'}' closes nothing");
  }

 private:
  [[noreturn]] void fail(std::size_t begin, std::size_t end, const std::string& message,
                         const std::string& help = "") const {
    throw Fault{{notation_.span.source, notation_.span.begin + begin, notation_.span.begin + end},
                message,
                help};
  }

  bool at_end() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ >= text_.size() || text_[at_] == '}';
  }

  void atoms(int depth) {
    while (!at_end()) {
      const char c = text_[at_];
      if (c == '_' || c == '^' || c == '\'') {
        script(depth);
        continue;
      }
      lower_ = upper_ = false;
      atom(depth);
    }
  }

  void script(int depth) {
    const std::size_t begin = at_;
    const char c = text_[at_++];
    bool& taken = c == '_' ? lower_ : upper_;
    const bool more_primes = c == '\'' && begin > 0 && text_[begin - 1] == '\'';
    if (taken && !more_primes)
      fail(begin, begin + 1, c == '_' ? "a second subscript" : "a second superscript",
           "braces make one of them: x_{12}, {x_1}_2");
    taken = true;
    if (c == '\'') return;
    argument(begin, begin + 1, depth);
  }

  // What a script or an accent is made of. Scripts inside belong to other atoms.
  void argument(std::size_t begin, std::size_t end, int depth) {
    if (at_end() || text_[at_] == '_' || text_[at_] == '^' || text_[at_] == '\'')
      fail(begin, end, "nothing stands behind this '" +
                           std::string{text_.substr(begin, end - begin)} + "'");
    const bool lower = lower_;
    const bool upper = upper_;
    atom(depth + 1);
    lower_ = lower;
    upper_ = upper;
  }

  void atom(int depth) {
    const std::size_t begin = at_;
    if (depth > deepest_braces)
      fail(begin, begin + 1, "more than " + std::to_string(deepest_braces) +
                                 " braces inside each other");
    const char c = text_[at_];
    if (c == '\\') return command(depth);
    if (c == '{') {
      ++at_;
      lower_ = upper_ = false;
      atoms(depth + 1);
      if (at_ >= text_.size()) fail(begin, begin + 1, "'{' is not closed");
    } else if (!is_plain(c)) {
      fail(begin, begin + 1, "a notation is mathematics in LaTeX, and this sign is not",
           "letters, digits, _ ^ { } and commands such as \\mathbf or \\alpha");
    }
    ++at_;
  }

  void command(int depth) {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string name{text_.substr(begin + 1, at_ - begin - 1)};
    if (commands_with_argument().contains(name)) return argument(begin, at_, depth);
    if (symbols().contains(name)) return;
    fail(begin, at_, "'\\" + name + "' is not a command a notation may use",
         "alphabets, accents and Greek letters, such as \\mathbf, \\tilde, \\alpha");
  }

  const syntax::Notation& notation_;
  std::string_view text_;
  std::size_t at_ = 0;
  // Whether the last atom has these scripts.
  bool lower_ = false;
  bool upper_ = false;
};

}  // namespace

void check_notation(const syntax::Notation& notation) { Check{notation}.run(); }

}  // namespace patchproof
