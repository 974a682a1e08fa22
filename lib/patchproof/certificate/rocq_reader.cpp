#include <patchproof/certificate/rocq_reader.hpp>

#include <algorithm>
#include <array>

namespace patchproof {

namespace {

using Kind = RocqTerm::Kind;
using Token = RocqToken::Kind;

constexpr std::array<std::string_view, 6> relation_signs{"=", "<>", "<", "<=", ">", ">="};
constexpr std::size_t longest_number = 10'000;

RocqTermPointer made(Kind kind, std::vector<RocqTermPointer> parts,
                     std::vector<std::string> operators = {}) {
  RocqTerm term;
  term.kind = kind;
  term.parts = std::move(parts);
  term.operators = std::move(operators);
  return std::make_shared<const RocqTerm>(std::move(term));
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_{text}, next_{rocq_token(text, 0)} {}

  RocqTermPointer proposition() {
    const Level level{*this};
    if (is_word("forall")) return binding(Kind::forall, ",");
    if (is_word("fun")) return binding(Kind::function, "=>");
    std::vector<RocqTermPointer> parts{disjunction()};
    while (accepted("->")) {
      if (is_word("forall")) {
        // What follows belongs to it.
        parts.push_back(binding(Kind::forall, ","));
        break;
      }
      parts.push_back(disjunction());
    }
    return parts.size() == 1 ? parts.front() : made(Kind::implication, std::move(parts));
  }

  std::string type() {
    const Level level{*this};
    std::string result;
    std::string last = type_atom();
    while (accepted("->")) {
      result += last + " -> ";
      last = type_atom();
    }
    // Arrows bind to the right.
    return result + (last.front() == '(' ? last.substr(1, last.size() - 2) : last);
  }

  std::size_t position() const { return next().position; }

  void expect_end() const {
    if (next().kind != Token::end) fail("the end");
  }

 private:
  // How deep the reader is; it counts what can be within itself.
  class Level {
   public:
    explicit Level(Reader& reader) : reader_{reader} {
      if (++reader_.depth_ > deepest_rocq_term) throw RocqUnreadable{"nested too deeply"};
    }
    ~Level() { --reader_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Reader& reader_;
  };

  const RocqToken& next() const { return next_; }
  std::string_view taken() {
    const std::string_view text = next_.text;
    next_ = rocq_token(text_, next_.position + text.size());
    return text;
  }
  bool is_sign(std::string_view sign) const {
    return next().kind == Token::sign && next().text == sign;
  }
  bool is_word(std::string_view word) const {
    return next().kind == Token::name && next().text == word;
  }
  bool accepted(std::string_view sign) {
    if (!is_sign(sign)) return false;
    taken();
    return true;
  }
  void expect(std::string_view sign) {
    if (!accepted(sign)) fail("'" + std::string{sign} + "'");
  }

  [[noreturn]] void fail(const std::string& expected) const {
    const std::string_view before = text_.substr(0, next().position);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const bool over = next().kind == Token::end;
    throw RocqUnreadable{"line " + std::to_string(line) + ": expected " + expected + ", found " +
                         (over ? "the end" : "'" + std::string{next().text.substr(0, 40)} + "'")};
  }

  std::string name() {
    if (next().kind != Token::name || is_word("forall") || is_word("fun")) fail("a name");
    return std::string{taken()};
  }

  std::string type_atom() {
    if (accepted("(")) {
      const std::string inner = type();
      expect(")");
      return inner.find(' ') == std::string::npos ? inner : "(" + inner + ")";
    }
    if (!is_word("R") && !is_word("nat") && !is_word("Prop")) fail("a type");
    return name();
  }

  // x y : T
  void add_binders(std::vector<RocqBinder>& binders) {
    std::vector<std::string> names;
    while (names.empty() || !is_sign(":")) names.push_back(name());
    expect(":");
    const std::string of = type();
    for (std::string& one : names) binders.push_back({std::move(one), of});
  }

  RocqTermPointer binding(Kind kind, std::string_view before_body) {
    taken();
    RocqTerm term;
    term.kind = kind;
    if (is_sign("(")) {
      while (accepted("(")) {
        add_binders(term.binders);
        expect(")");
      }
    } else {
      add_binders(term.binders);
    }
    expect(before_body);
    term.parts.push_back(proposition());
    return std::make_shared<const RocqTerm>(std::move(term));
  }

  RocqTermPointer disjunction() {
    std::vector<RocqTermPointer> parts{conjunction()};
    while (accepted("\\/")) parts.push_back(conjunction());
    return parts.size() == 1 ? parts.front() : made(Kind::disjunction, std::move(parts));
  }

  RocqTermPointer conjunction() {
    std::vector<RocqTermPointer> parts{negation()};
    while (accepted("/\\")) parts.push_back(negation());
    return parts.size() == 1 ? parts.front() : made(Kind::conjunction, std::move(parts));
  }

  RocqTermPointer negation() {
    if (!is_sign("~")) return relation();
    const Level level{*this};
    expect("~");
    return made(Kind::negation, {negation()});
  }

  RocqTermPointer relation() {
    std::vector<RocqTermPointer> parts{sum()};
    std::vector<std::string> operators;
    while (next().kind == Token::sign &&
           std::find(relation_signs.begin(), relation_signs.end(), next().text) !=
               relation_signs.end()) {
      operators.emplace_back(next().text);
      // There is no other chain.
      const bool below = operators.back() == "<" || operators.back() == "<=";
      const bool chain = operators.size() == 2 && below && operators.front().front() == '<' &&
                         operators.front() != "<>";
      if (operators.size() > 1 && !chain) fail("no other relation");
      taken();
      parts.push_back(sum());
    }
    return parts.size() == 1 ? parts.front()
                             : made(Kind::relation, std::move(parts), std::move(operators));
  }

  RocqTermPointer sum() {
    std::vector<RocqTermPointer> parts{product()};
    std::vector<std::string> operators;
    while (is_sign("+") || is_sign("-")) {
      operators.emplace_back(taken());
      parts.push_back(product());
    }
    return parts.size() == 1 ? parts.front()
                             : made(Kind::sum, std::move(parts), std::move(operators));
  }

  RocqTermPointer product() {
    std::vector<RocqTermPointer> parts{opposite()};
    std::vector<std::string> operators;
    while (is_sign("*") || is_sign("/")) {
      operators.emplace_back(taken());
      parts.push_back(opposite());
    }
    return parts.size() == 1 ? parts.front()
                             : made(Kind::product, std::move(parts), std::move(operators));
  }

  RocqTermPointer opposite() {
    if (!is_sign("-")) return power();
    const Level level{*this};
    expect("-");
    // "-2" is a number; the opposite of one is printed "- (2)", and "- 2 ^ 3" that of a power.
    if (next().kind == Token::number && next().follows_closely) {
      const RocqTermPointer result = number(true);
      if (result->natural || is_sign("^")) fail("the end of a negative number");
      return result;
    }
    const RocqTermPointer part = opposite();
    return made(Kind::opposite, {part});
  }

  RocqTermPointer power() {
    RocqTermPointer base = application();
    if (!is_sign("^")) return base;
    const Level level{*this};
    expect("^");
    return made(Kind::power, {std::move(base), power()});
  }

  bool starts_atom() const {
    return next().kind == Token::number || is_sign("(") ||
           (next().kind == Token::name && !is_word("forall") && !is_word("fun"));
  }

  RocqTermPointer application() {
    std::vector<RocqTermPointer> parts{atom()};
    while (starts_atom()) parts.push_back(atom());
    return parts.size() == 1 ? parts.front() : made(Kind::application, std::move(parts));
  }

  RocqTermPointer atom() {
    if (accepted("(")) {
      RocqTermPointer inner = proposition();
      expect(")");
      return inner;
    }
    if (next().kind == Token::number) return number(false);
    RocqTerm term;
    term.kind = Kind::name;
    if (!starts_atom()) fail("a term");
    term.name = name();
    return std::make_shared<const RocqTerm>(std::move(term));
  }

  RocqTermPointer number(bool negative) {
    RocqTerm term;
    const std::string_view digits = taken();
    if (digits.size() > longest_number) throw RocqUnreadable{"a number that is too long"};
    // A zero in front would make it octal.
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    term.number = Integer{std::string{digits.substr(first)}};
    if (negative) term.number = -term.number;
    term.natural = accepted("%nat");
    return std::make_shared<const RocqTerm>(std::move(term));
  }

  std::string_view text_;
  RocqToken next_;
  int depth_ = 0;
};

}  // namespace

RocqTermPointer rocq_term(std::string_view text) {
  Reader reader{text};
  RocqTermPointer result = reader.proposition();
  reader.expect_end();
  return result;
}

RocqReading rocq_term_at_front(std::string_view text) {
  Reader reader{text};
  RocqTermPointer term = reader.proposition();
  return {std::move(term), reader.position()};
}

std::pair<std::string, std::size_t> rocq_type_at_front(std::string_view text) {
  Reader reader{text};
  std::string type = reader.type();
  return {std::move(type), reader.position()};
}

}  // namespace patchproof
