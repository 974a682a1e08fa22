#include <catch2/catch.hpp>
#include <random>

#include "language_test.hpp"

namespace patchproof {
namespace {

std::string format_of(const std::string& text) {
  REQUIRE(messages_of(text) == "");
  const std::string once = formatted({"a.proof", text});
  CHECK(formatted({"a.proof", once}) == once);
  CHECK(meaning_of(once) == meaning_of(text));
  return once;
}

/// An expression of the grammar with blanks and line ends thrown in.
class RandomText {
 public:
  explicit RandomText(unsigned seed) : random_(seed) {}

  std::string text() {
    std::string result = pick({"", "\n\n# first\n"}) + "case a.b" + line_end();
    for (int i = 0; i < 6; ++i) {
      result += pick({"", "\n\n\n", "# between\n", "\t"}) + statement(i) + line_end();
    }
    return result + pick({"", "  # last in the case\n"}) + "end" + pick({"", "\r\n", " # end"});
  }

 private:
  std::size_t number(std::size_t count) { return random_() % count; }
  std::string pick(std::vector<std::string> choices) { return choices[number(choices.size())]; }
  std::string gap() { return pick({"", "", " ", "   "}); }
  std::string gap_in_brackets() { return pick({"", " ", "\n", "  # why\n   "}); }
  std::string line_end() { return pick({"\n", "  \n", "\r\n", " # so\n", "\n\n\n"}); }

  std::string statement(int i) {
    const std::string label = "l" + std::to_string(i);
    switch (number(7)) {
      case 0:
        return "prove " + label + gap() + ":" + gap() + claim();
      case 1:
        return "derive " + label + ": " + sum(1) + " from " + claim() + "\n gives " + sum(1);
      case 2:
        return "erratum " + label + " printed " + claim() + "\n corrected " + claim() + "\nend";
      case 3:
        return "curve c(u)" + gap() + "=" + gap() + sum(2) + gap() + ":" + gap() + "C^2 in R^3";
      case 4:
        return "let f" + gap() + "(u," + gap() + "v)" + gap() + "=" + gap() + sum(2);
      case 5:
        return "patch p(u,v):degree" + gap() + "(3," + gap() + "3)";
      default:
        return "point V[ 0 ..3," + gap() + "- m" + gap() + ".." + gap() + "n+1]";
    }
  }
  std::string claim() {
    return sum(2) + gap() + pick({"==", "!=", "<=", "<"}) + gap() + sum(1) +
           pick({"", " on boundary"});
  }
  std::string sum(int depth) {
    std::string result = pick({"", "-", "- "}) + product(depth);
    for (std::size_t n = number(3); n > 0; --n) {
      result += gap() + pick({"+", "-", "- -", "+-"}) + gap() + product(depth);
    }
    return result;
  }
  std::string product(int depth) {
    std::string result = power(depth);
    for (std::size_t n = number(2); n > 0; --n) {
      result += gap() + pick({"*", "/"}) + gap() + power(depth);
    }
    return result;
  }
  std::string power(int depth) { return postfix(depth) + pick({"", "", "^2", " ^ -2", "^-x^3"}); }
  std::string postfix(int depth) {
    const std::string open = gap_in_brackets();
    if (depth == 0) return pick({"u", "C1'", "12", "0.50", "?", "x.y", "degree", "knots"});
    switch (number(6)) {
      case 0:
        return "(" + open + sum(depth - 1) + open + ")";
      case 1:
        return "(" + open + sum(depth - 1) + "," + open + sum(depth - 1) + ")";
      case 2:
        return "[" + open + sum(depth - 1) + gap() + ";" + open + sum(depth - 1) + "]";
      case 3:
        return "f" + gap() + "(" + sum(depth - 1) + "," + open + "i in 0 .. 3 )";
      case 4:
        return "M" + gap() + "[" + sum(depth - 1) + "," + open + "0.. 2" + "].x";
      default:
        return postfix(0);
    }
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("a formatted text has the standard indentation and blanks", "[language]") {
  CHECK(format_of("case   a . b\n"
                  " title    \"T  t\"\n"
                  "  # the square\n"
                  "   param u ,v   in[0,1],t in [ - a,b]\n"
                  "curve C1(u)=(u,0,4*u * (1 -u)) ,C2(u):C^2   in R ^ 3\n\n\n\n"
                  "patch p(u,v):degree(3,3)   # free   \n"
                  "  spline T=bspline( M ,degree 3,3,knots[0,1],[-1 ,2])\n"
                  "erratum e\n"
                  "printed  - u- -v ==f(x) ^ - 2.5\n"
                  "+ 1\n"
                  "# why\n"
                  "corrected u==[1 ,2;3 , 4]*M [0 .. 3]\n"
                  "# at the end\n"
                  "note \"n\"\n"
                  "end\n"
                  "prove x:r . x==1\n"
                  "# a comment\n"
                  "using y\n"
                  "# last\n"
                  "end") ==
        "case a.b\n"
        "  title \"T  t\"\n"
        "  # the square\n"
        "  param u, v in [0, 1], t in [-a, b]\n"
        "  curve C1(u) = (u, 0, 4*u*(1 - u)), C2(u) : C^2 in R^3\n"
        "\n"
        "  patch p(u, v) : degree (3, 3)  # free\n"
        "  spline T = bspline(M, degree 3, 3, knots [0, 1], [-1, 2])\n"
        "  erratum e\n"
        "    printed -u - -v == f(x)^-2.5\n"
        "        + 1\n"
        "    # why\n"
        "    corrected u == [1, 2 ; 3, 4]*M[0..3]\n"
        "    # at the end\n"
        "    note \"n\"\n"
        "  end\n"
        "  prove x: r.x == 1\n"
        "      # a comment\n"
        "      using y\n"
        "  # last\n"
        "end\n");
}

TEST_CASE("a formatted definition has its value on a line of two blanks", "[language]") {
  CHECK(format_of("include \"b.proof\"\n"
                  "define f(a,b:scalar,C:curve(u) ,\n"
                  "g:scalar function):patch(u,v)\n"
                  "let h(x)\n"
                  "= x\n"
                  "# the value\n"
                  "=h(a)*C(u)\n"
                  "-b\n"
                  "end\n"
                  "# the rest\n") ==
        "include \"b.proof\"\n"
        "define f(a, b : scalar, C : curve(u),\n"
        "    g : scalar function) : patch(u, v)\n"
        "  let h(x)\n"
        "      = x\n"
        "  # the value\n"
        "  = h(a)*C(u)\n"
        "      - b\n"
        "end\n"
        "# the rest\n");
}

TEST_CASE("a text of nothing or of comments keeps just these", "[language]") {
  CHECK(format_of("") == "");
  CHECK(format_of("\n\n  \n") == "");
  CHECK(format_of("\xEF\xBB\xBF\r\n  # a \t\r\n\r\n\r\n#b") == "# a\n\n#b\n");
}

TEST_CASE("formatting keeps the meaning and is done after once", "[language][law]") {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const std::string text = RandomText(seed).text();
    CAPTURE(seed, text);
    const std::string once = format_of(text);
    const auto comments = [](const std::string& some) {
      return std::count(some.begin(), some.end(), '#');
    };
    CHECK(comments(once) == comments(text));
    CHECK(once.find(" \n") == std::string::npos);
    CHECK(once.find("\n\n\n") == std::string::npos);
  }
}

}  // namespace patchproof
