#include <patchproof/certificate/proposition_difference.hpp>

#include <algorithm>
#include <optional>

#include <patchproof/certificate/proposition_words.hpp>

namespace patchproof {

namespace {

using Node = PropositionTable::Node;

bool is_relation(const std::string& head) {
  return head == "=" || head == "<>" || head == "<" || head == "<=" || head == ">" || head == ">=";
}

bool binds(const std::string& head) {
  return head.starts_with("forall ") || head.starts_with("fun ");
}

// The part in which alone they differ; of propositions that are joined the first one.
std::optional<std::size_t> differing_part(const Node& a, const Node& b) {
  if (a.head != b.head || a.parts.size() != b.parts.size()) return std::nullopt;
  std::optional<std::size_t> found;
  for (std::size_t k = a.parts.size(); k-- > 0;) {
    if (a.parts[k] == b.parts[k]) continue;
    const bool joined = a.head == "->" || a.head == "/\\" || a.head == "\\/";
    if (found && !joined) return std::nullopt;
    found = k;
  }
  return found;
}

}  // namespace

std::string proposition_difference(const PropositionTable& table, std::size_t understood,
                                   std::size_t asked, const std::vector<std::string>& names) {
  if (understood == asked) return "";
  std::vector<std::string> known = names;
  std::size_t premises = 0;
  std::size_t depth = 0;
  bool in_premise = false;
  // The relation around the difference, and how deep it stands.
  std::optional<std::pair<std::size_t, std::size_t>> relation;
  for (;;) {
    const Node& node = table.node(understood);
    const std::optional<std::size_t> part = differing_part(node, table.node(asked));
    if (!part) break;
    if (is_relation(node.head)) relation = {understood, depth};
    if (binds(node.head)) ++depth;
    if (!in_premise && node.head == "->") {
      ++premises;
      in_premise = *part == 0;
      // The binders of a premise are others than those of the conclusion.
      if (in_premise) known.resize(std::min(known.size(), depth));
    }
    understood = node.parts[*part];
    asked = table.node(asked).parts[*part];
  }
  const auto words = [&](std::size_t number, std::size_t around) {
    return proposition_words(table, number, around, known);
  };
  const auto goes_on = [&](std::size_t number) {
    const std::string& head = table.node(number).head;
    return head == "->" || head.starts_with("forall ");
  };
  const std::string place = in_premise ? "premise " + std::to_string(premises)
                            : goes_on(understood) || goes_on(asked)
                                ? "behind premise " + std::to_string(premises)
                                : "conclusion";
  std::string result = place + ": Rocq understood " + words(understood, depth) + " where " +
                       words(asked, depth) + " was asked";
  if (relation) result += ", in " + words(relation->first, relation->second);
  return result;
}

}  // namespace patchproof
