#include <patchproof/certificate/proposition_difference.hpp>

#include <algorithm>
#include <string_view>

namespace patchproof {

namespace {

using Node = PropositionTable::Node;

// Terms in messages are cut off behind so many nodes.
constexpr int longest_shown = 40;

bool is_between(const std::string& head) {
  constexpr std::string_view all = " + - * / = <> < <= > >= -> /\\ \\/ ";
  return all.find(" " + head + " ") != std::string_view::npos;
}

bool is_relation(const std::string& head) {
  constexpr std::string_view all = " = <> < <= > >= ";
  return all.find(" " + head + " ") != std::string_view::npos;
}

class Words {
 public:
  Words(const PropositionTable& table, const std::vector<std::string>& names)
      : table_{table}, names_{names} {}

  std::string of(std::size_t number) {
    left_ = longest_shown;
    return text(number, false);
  }

 private:
  std::string text(std::size_t number, bool bracket) {
    if (left_-- <= 0) return "…";
    const Node& node = table_.node(number);
    if (node.parts.empty()) {
      const std::string leaf = node.head.front() == '#' ? variable(node.head) : node.head;
      return bracket && (leaf.find(' ') != std::string::npos || leaf.front() == '-')
                 ? "(" + leaf + ")"
                 : leaf;
    }
    std::string result;
    if (is_between(node.head) && node.parts.size() == 2) {
      result = text(node.parts[0], !is_relation(node.head));
      result += " " + node.head + " " + text(node.parts[1], !is_relation(node.head));
    } else if (node.head.starts_with("^ ")) {
      result = text(node.parts[0], true) + " " + node.head;
    } else {
      result = node.head == "apply" ? "" : node.head == "opposite" ? "-" : node.head;
      for (const std::size_t part : node.parts)
        result += (result.empty() ? "" : " ") + text(part, true);
    }
    return bracket ? "(" + result + ")" : result;
  }

  // "#2 1 0"
  std::string variable(const std::string& head) const {
    const std::size_t end = std::min(head.find(' '), head.size());
    const std::size_t level = std::stoul(head.substr(1, end - 1));
    const std::string name = level < names_.size() ? names_[level] : "x" + std::to_string(level);
    return name + head.substr(end);
  }

  const PropositionTable& table_;
  const std::vector<std::string>& names_;
  int left_ = 0;
};

}  // namespace

std::string proposition_difference(const PropositionTable& table, std::size_t understood,
                                   std::size_t asked, const std::vector<std::string>& names) {
  if (understood == asked) return "";
  std::vector<std::string> known = names;
  std::string place = "conclusion";
  std::size_t premises = 0;
  std::size_t binders = 0;
  // Behind the last premise, or inside one.
  bool inside = false;
  std::size_t relation = understood;
  bool in_relation = false;
  for (;;) {
    const Node& a = table.node(understood);
    const Node& b = table.node(asked);
    if (is_relation(a.head)) {
      relation = understood;
      in_relation = true;
    }
    if (a.head != b.head || a.parts.size() != b.parts.size()) break;
    std::vector<std::size_t> differing;
    for (std::size_t k = 0; k < a.parts.size(); ++k)
      if (a.parts[k] != b.parts[k]) differing.push_back(k);
    const bool one_by_one = a.head == "->" || a.head == "/\\" || a.head == "\\/";
    if (differing.empty() || (differing.size() > 1 && !one_by_one)) break;
    const std::size_t at = differing.front();
    if (!inside && a.head.starts_with("forall ")) ++binders;
    if (!inside && a.head == "->") {
      ++premises;
      if (at == 0) {
        place = "premise " + std::to_string(premises);
        // The binders of a premise are others than those of the conclusion.
        known.resize(std::min(known.size(), binders));
        inside = true;
      }
    } else if (!a.head.starts_with("forall ")) {
      inside = true;
    }
    understood = a.parts[at];
    asked = b.parts[at];
  }
  if (!inside && table.node(understood).head != table.node(asked).head && !in_relation)
    place = "structure";
  Words words{table, known};
  std::string result = place + ": Rocq understood " + words.of(understood) + " where " +
                       words.of(asked) + " was asked";
  if (in_relation && relation != understood) result += ", in " + words.of(relation);
  return result;
}

}  // namespace patchproof
