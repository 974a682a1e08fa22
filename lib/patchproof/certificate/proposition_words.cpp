#include <patchproof/certificate/proposition_words.hpp>

#include <sstream>
#include <string_view>

#include <patchproof/certificate/rocq_syntax.hpp>

namespace patchproof {

namespace {

using Kind = RocqTerm::Kind;

// Parts that are shown; so many nodes fill about a line.
constexpr int most_shown = 24;

RocqTermPointer shared(RocqTerm term) { return std::make_shared<const RocqTerm>(std::move(term)); }

RocqTermPointer name(std::string text) {
  RocqTerm term;
  term.kind = Kind::name;
  term.name = std::move(text);
  return shared(std::move(term));
}

RocqTermPointer number(const std::string& digits, bool natural) {
  RocqTerm term;
  const bool negative = digits.front() == '-';
  term.number = Integer{negative ? digits.substr(1) : digits};
  if (negative) term.number = -term.number;
  term.natural = natural;
  return shared(std::move(term));
}

bool is_among(std::string_view head, std::string_view all) {
  return all.find(" " + std::string{head} + " ") != std::string_view::npos;
}

// Which kind of term a head with two parts makes.
Kind kind_of(const std::string& head) {
  if (is_among(head, " + - ")) return Kind::sum;
  if (is_among(head, " * / ")) return Kind::product;
  if (head == "->") return Kind::implication;
  if (head == "/\\") return Kind::conjunction;
  if (head == "\\/") return Kind::disjunction;
  return is_among(head, " = <> < <= > >= ") ? Kind::relation : Kind::application;
}

class Words {
 public:
  Words(const PropositionTable& table, const std::vector<std::string>& names)
      : table_{table}, names_{names} {}

  RocqTermPointer term(std::size_t number, std::size_t depth) {
    if (left_-- <= 0) return name("…");
    const PropositionTable::Node& node = table_.node(number);
    if (node.parts.empty()) return leaf(node.head);
    const Kind kind = kind_of(node.head);
    RocqTerm result;
    result.kind = kind;
    if (kind != Kind::application) {
      for (const std::size_t part : node.parts) result.parts.push_back(term(part, depth));
      if (kind == Kind::sum || kind == Kind::product || kind == Kind::relation)
        result.operators = {node.head};
      flatten(result);
      return shared(std::move(result));
    }
    if (node.head.starts_with("fun ") || node.head.starts_with("forall ")) {
      const std::size_t space = node.head.find(' ');
      result.kind = space == 3 ? Kind::function : Kind::forall;
      result.binders = {{name_of(depth), node.head.substr(space + 1)}};
      result.parts = {term(node.parts[0], depth + 1)};
    } else if (node.head == "opposite" || node.head == "~") {
      result.kind = node.head == "~" ? Kind::negation : Kind::opposite;
      result.parts = {term(node.parts[0], depth)};
    } else if (node.head.starts_with("^ ")) {
      result.kind = Kind::power;
      result.parts = {term(node.parts[0], depth), patchproof::number(node.head.substr(2), false)};
    } else {
      if (node.head != "apply") result.parts = words_of(node.head, false);
      for (const std::size_t part : node.parts) result.parts.push_back(term(part, depth));
      flatten(result);
    }
    return shared(std::move(result));
  }

 private:
  // (a + b) + c needs no brackets, nor does A -> (B -> C), nor (f x) y.
  static void flatten(RocqTerm& term) {
    const bool left = term.kind == Kind::sum || term.kind == Kind::product ||
                      term.kind == Kind::application;
    const RocqTermPointer inner = left ? term.parts.front() : term.parts.back();
    if (term.kind == Kind::relation || inner->kind != term.kind) return;
    term.parts.erase(left ? term.parts.begin() : term.parts.end() - 1);
    term.parts.insert(left ? term.parts.begin() : term.parts.end(), inner->parts.begin(),
                      inner->parts.end());
    term.operators.insert(term.operators.begin(), inner->operators.begin(), inner->operators.end());
  }

  // "Bern 3 1"
  std::vector<RocqTermPointer> words_of(const std::string& head, bool natural) const {
    std::vector<RocqTermPointer> result;
    std::istringstream words{head};
    for (std::string word; words >> word;)
      result.push_back(result.empty() ? word.front() == '#' ? name(name_of(std::stoul(word.substr(1))))
                                                            : name(word)
                                      : number(word, natural));
    return result;
  }

  // "3", "#2", "#2 1 0"
  RocqTermPointer leaf(const std::string& head) const {
    if (head.front() != '#') return number(head, false);
    const std::vector<RocqTermPointer> words = words_of(head, true);
    if (words.size() == 1) return words.front();
    RocqTerm term;
    term.kind = Kind::application;
    term.parts = words;
    return shared(std::move(term));
  }

  std::string name_of(std::size_t level) const {
    return level < names_.size() ? names_[level] : "x" + std::to_string(level);
  }

  const PropositionTable& table_;
  const std::vector<std::string>& names_;
  int left_ = most_shown;
};

}  // namespace

std::string proposition_words(const PropositionTable& table, std::size_t number, std::size_t depth,
                              const std::vector<std::string>& names) {
  return to_text(*Words{table, names}.term(number, depth));
}

}  // namespace patchproof
