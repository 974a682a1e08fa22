#include <catch2/catch.hpp>
#include <random>

#include <patchproof/certificate/rocq_reader.hpp>
#include <tests/certificate/small_case.hpp>

namespace patchproof {
namespace {

using Kind = RocqTerm::Kind;

std::string read_back(const std::string& text) { return to_text(*rocq_term(text)); }

std::string problem(const std::string& text) {
  try {
    rocq_term(text);
  } catch (const RocqUnreadable& error) {
    return error.what();
  }
  return "";
}

std::string repeated(const std::string& piece, std::size_t times) {
  std::string result;
  for (std::size_t k = 0; k < times; ++k) result += piece;
  return result;
}

RocqTermPointer made(Kind kind, std::vector<RocqTermPointer> parts,
                     std::vector<std::string> operators = {}) {
  RocqTerm term;
  term.kind = kind;
  term.parts = std::move(parts);
  term.operators = std::move(operators);
  return std::make_shared<const RocqTerm>(std::move(term));
}

// A term of any shape that the reader can give.
class RandomTerms {
 public:
  explicit RandomTerms(unsigned seed) : random_{seed} {}

  RocqTermPointer term(int depth) {
    const unsigned shape = depth == 0 ? below(2) : below(14);
    const auto part = [&] { return term(depth - 1); };
    switch (shape) {
      case 0: {
        RocqTerm number;
        number.natural = below(3) == 0;
        number.number = below(30);
        if (!number.natural && below(3) == 0) number.number = -1 - number.number;
        return std::make_shared<const RocqTerm>(number);
      }
      case 2:
        return made(Kind::application, {part(), part(), part()});
      case 3:
        return bound(Kind::function, part());
      case 4:
        return bound(Kind::forall, part());
      case 5:
        return made(Kind::implication, {part(), part()});
      case 6:
        return made(Kind::disjunction, {part(), part(), part()});
      case 7:
        return made(Kind::conjunction, {part(), part()});
      case 8:
        return made(Kind::negation, {part()});
      case 9:
        return made(Kind::relation, {part(), part()}, {sign({"=", "<>", ">=", ">"})});
      case 10:
        return made(Kind::relation, {part(), part(), part()},
                    {sign({"<", "<="}), sign({"<", "<="})});
      case 11:
        return made(Kind::sum, {part(), part(), part()}, {sign({"+", "-"}), sign({"+", "-"})});
      case 12:
        return made(Kind::product, {part(), part()}, {sign({"*", "/"})});
      case 13:
        return below(2) == 0 ? made(Kind::opposite, {part()}) : made(Kind::power, {part(), part()});
      default:
        return name({"u", "V", "b_2", "C1'", "Derive"});
    }
  }

 private:
  unsigned below(unsigned count) { return static_cast<unsigned>(random_() % count); }

  std::string sign(const std::vector<std::string>& all) {
    return all[below(static_cast<unsigned>(all.size()))];
  }

  RocqTermPointer name(const std::vector<std::string>& all) {
    RocqTerm term;
    term.kind = Kind::name;
    term.name = sign(all);
    return std::make_shared<const RocqTerm>(term);
  }

  RocqTermPointer bound(Kind kind, RocqTermPointer body) {
    RocqTerm term;
    term.kind = kind;
    for (unsigned k = 0; k <= below(3); ++k)
      term.binders.push_back({sign({"u", "v", "r"}), sign({"R", "nat -> R", "(R -> R) -> R"})});
    term.parts = {std::move(body)};
    return std::make_shared<const RocqTerm>(term);
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("What is written is read as the same term", "[certificate][law]") {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const RocqTermPointer term = RandomTerms{seed}.term(1 + static_cast<int>(seed % 5));
    const std::string text = to_text(*term);
    INFO(text);
    CHECK(same_writing(*rocq_term(text), *term));
  }
}

TEST_CASE("Line breaks and brackets that are not needed say nothing", "[certificate]") {
  CHECK(read_back("(a) +\n  (b * c)\n- d") == "a + b * c - d");
  CHECK(read_back("forall u v : R,\n0 <= u <= 1 ->\n(u = v)") ==
        "forall (u : R) (v : R), 0 <= u <= 1 -> u = v");
  CHECK(read_back("forall (C D : R -> (R -> R)), A") ==
        "forall (C : R -> R -> R) (D : R -> R -> R), A");
  CHECK(read_back("(fun x : R => x) 1") == "(fun (x : R) => x) 1");
}

TEST_CASE("Signs bind as tightly as in Rocq", "[certificate]") {
  CHECK(read_back("a - (b - c)") == "a - (b - c)");
  CHECK(read_back("(a - b) - c") == "(a - b) - c");
  CHECK(rocq_term("a - b + c")->kind == Kind::sum);
  CHECK(rocq_term("- a ^ 2")->kind == Kind::opposite);
  CHECK(rocq_term("(- a) ^ 2")->kind == Kind::power);
  CHECK(rocq_term("- a * b")->kind == Kind::product);
  CHECK(rocq_term("f x ^ 2")->kind == Kind::power);
  CHECK(rocq_term("~ a = b")->kind == Kind::negation);
  CHECK(rocq_term("A /\\ B \\/ C")->kind == Kind::disjunction);
  CHECK(rocq_term("A \\/ B -> C")->kind == Kind::implication);
  CHECK(rocq_term("A -> forall u : R, B -> C")->parts.size() == 2);
}

TEST_CASE("A negative number is no opposite", "[certificate]") {
  CHECK(rocq_term("-2")->number == -2);
  CHECK(rocq_term("- (2)")->kind == Kind::opposite);
  CHECK(rocq_term("- 2 ^ 3")->kind == Kind::opposite);
  CHECK(rocq_term("a - 2")->kind == Kind::sum);
  CHECK(rocq_term("a * -2")->parts[1]->number == -2);
  CHECK(rocq_term("2%nat")->natural);
}

TEST_CASE("Other texts are refused with their place", "[certificate][reject]") {
  CHECK(problem("") == "line 1: expected a term, found the end");
  CHECK(problem("a +\n* b") == "line 2: expected a term, found '*'");
  CHECK(problem("(a") == "line 1: expected ')', found the end");
  CHECK(problem("a b)") == "line 1: expected the end, found ')'");
  CHECK(problem("forall u, A") == "line 1: expected a name, found ','");
  CHECK(problem("forall u : T, A") == "line 1: expected a type, found 'T'");
  CHECK(problem("fun u : R, u") == "line 1: expected '=>', found ','");
  CHECK(problem("a = b = c") == "line 1: expected no other relation, found '='");
  CHECK(problem("a < b > c") == "line 1: expected no other relation, found '>'");
  CHECK(problem("-2 ^ 2") == "line 1: expected the end of a negative number, found '^'");
  CHECK(problem("a + ...") == "line 1: expected a term, found '.'");
  CHECK(problem("let x := 1 in x") == "line 1: expected the end, found ':='");
  CHECK(problem("2%Z") == "line 1: expected the end, found '%'");
  CHECK(problem(repeated("9", 10'001)) == "a number that is too long");
}

TEST_CASE("Deep nesting is refused, long texts are not", "[certificate][reject]") {
  for (const std::string piece :
       {"(", "- ", "~ ", "a ^ ", "f (", "fun x : R => ", "A -> forall x : R, "}) {
    INFO(piece);
    CHECK(problem(repeated(piece, 100'000) + "a") == "nested too deeply");
  }
  CHECK(problem("fun x : " + repeated("(", 100'000)) == "nested too deeply");
  CHECK(rocq_term("a" + repeated(" + a", 100'000))->parts.size() == 100'001);
  CHECK(rocq_term("a" + repeated(" -> a", 100'000))->parts.size() == 100'001);
  CHECK(rocq_term("a" + repeated(" a", 100'000))->parts.size() == 100'001);
}

TEST_CASE("Damaged texts are read or refused", "[certificate]") {
  const std::string whole = golden_certificate("small.printed");
  std::mt19937 random{7};
  for (int round = 0; round < 3000; ++round) {
    const std::size_t begin = random() % whole.size();
    std::string text = whole.substr(begin, 1 + random() % 400);
    for (unsigned k = 0; k < random() % 4; ++k)
      text[random() % text.size()] = "()-+*/^~%:=<>,. \n0u\\\x80"[random() % 22];
    const std::string message = problem(text);
    CHECK(message.size() < 200);
    if (message.empty()) CHECK(same_writing(*rocq_term(read_back(text)), *rocq_term(text)));
  }
}

}  // namespace patchproof
