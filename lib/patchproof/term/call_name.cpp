#include <patchproof/term/call_name.hpp>

#include <utility>

namespace patchproof {

std::string_view call_name(const Term& term) {
  static constexpr std::pair<Operation, std::string_view> names[] = {
      {Operation::sine, "sin"},
      {Operation::cosine, "cos"},
      {Operation::exponential, "exp"},
      {Operation::square_root, "sqrt"},
      {Operation::transpose, "transpose"},
      {Operation::determinant, "det"},
      {Operation::dot, "dot"},
      {Operation::cross, "cross"}};
  for (const auto& [operation, name] : names) {
    if (operation == term.operation()) return name;
  }
  // A tuple; (x) alone would be x in parentheses.
  return term.children().size() == 1 ? "tuple" : "";
}

}  // namespace patchproof
