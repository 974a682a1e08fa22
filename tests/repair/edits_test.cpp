#include <algorithm>
#include <catch2/catch.hpp>

#include <patchproof/repair/canonical.hpp>
#include <patchproof/repair/edits.hpp>

namespace patchproof {

namespace {

const Scope nothing;

std::vector<std::string> changes(const std::string& text) {
  const Line line = line_of(text).value();
  const Names names{nothing, Library::prelude()};
  std::vector<std::string> result;
  for (const Edit& edit : edits_of(line, line.proposition.comparisons.front(), names, {}, {}))
    result.push_back(changed(line.text, {edit}));
  return result;
}

bool trivial(const std::string& text) {
  const Line line = line_of(text).value();
  return is_trivial(line.proposition.comparisons.front(), Names{nothing, Library::prelude()});
}

std::string canonical_of(const std::string& text) {
  const Line line = line_of(text).value();
  return canonical(line.proposition.comparisons.front(), Names{nothing, Library::prelude()});
}

}  // namespace

TEST_CASE("every single change of a short statement") {
  CHECK(changes("x + 2 == y") == std::vector<std::string>{"-x + 2 == y", "x - 2 == y", "x + 0 == y",
                                                          "x + 1 == y", "x + 3 == y",
                                                          "x + 2 == -y"});
  CHECK(changes("-x == y") == std::vector<std::string>{"x == y", "-x == -y"});
  CHECK(changes("b[0] == y") == std::vector<std::string>{"-b[0] == y", "b[1] == y", "b[0] == -y"});
  CHECK(changes("H03(t) == y").size() == 5);  // -H03, H13, H23, H33, -y
}

TEST_CASE("every change can be read again") {
  for (const std::string text :
       {"a*(b - 2*c) - 1/2 == [1, -2 ; x, (3, 4)]", "f'(1-u) + r_uv(u, 0) == x^2^n",
        "sum(bernstein(n, i, u)*b[i, 0], i in 0..m-1) == transpose(M)*M[0..1, 2..3]"})
    for (const std::string& change : changes(text)) {
      INFO(change);
      CHECK(line_of(change).has_value());
    }
}

TEST_CASE("changes overlap where both cannot be made") {
  CHECK(overlap({0, 2, "a", ""}, {1, 3, "b", ""}));
  CHECK(overlap({1, 1, "a", ""}, {1, 2, "b", ""}));
  CHECK_FALSE(overlap({0, 1, "a", ""}, {1, 2, "b", ""}));
}

TEST_CASE("what was changed is marked below the changed line") {
  CHECK(changed("a + b == c", {{2, 3, "-", "sign"}, {9, 10, "dd", "name"}}) == "a - b == dd");
  CHECK(marks_of("a + b == c", {{2, 3, "-", "sign"}, {9, 10, "dd", "name"}}) == "  ^      ^^");
  CHECK(in_words("-a == c", {0, 1, "", "sign"}) == "without - (sign)");
  CHECK(in_words("a == c", {0, 0, "-", "sign"}) == "added - (sign)");
  CHECK(in_words("a == 2", {5, 6, "3", "number"}) == "2 -> 3 (number)");
}

TEST_CASE("a statement about nothing is recognised") {
  CHECK(trivial("a == a"));
  CHECK(trivial("a*b + c == (c) + b*a"));
  CHECK(trivial("a - a == 0"));
  CHECK(trivial("0*f(u) == 0"));
  CHECK(trivial("1 + 1 == 2"));
  CHECK(trivial("f(u, 2*v) - b[1-i] == -b[-i + 1] + f(u, v*2)"));
  CHECK_FALSE(trivial("a == b"));
  CHECK_FALSE(trivial("integral(s, s in [0, 1]) == integral(s, s in [0, 2])"));
  CHECK_FALSE(trivial("a == 2*a"));
  CHECK_FALSE(trivial("f(u) == f(v)"));
  CHECK_FALSE(trivial("[1, 2]*[3 ; 4] == [3 ; 4]*[1, 2]"));
}

TEST_CASE("order and parentheses do not count, everything else does") {
  CHECK(canonical_of("a + b*c == d") == canonical_of("(c*b) + a == d"));
  CHECK(canonical_of("a - (b - c) == d") == canonical_of("a + c - b == d"));
  CHECK(canonical_of("a == d") != canonical_of("a == d'"));
  CHECK(canonical_of("a/b == d") != canonical_of("b/a == d"));
  CHECK(canonical_of("b[i,j] == d") != canonical_of("b[j,i] == d"));
}

}  // namespace patchproof
