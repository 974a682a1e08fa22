#pragma once

#include <map>
#include <set>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// How often unknown functions are differentiated in terms: derivatives of derivatives, and of
/// functions made of derivatives, count together, and in all arguments.
class DerivativeOrders {
 public:
  /// The terms have to outlive this.
  void note(const Term& term);

  /// 0 for a function that stands under no derivative.
  int of(const SymbolPointer& function) const;

 private:
  int in(const Term& term);

  std::set<const TermNode*> noted_;
  std::map<const TermNode*, int> all_;
  std::map<unsigned, int> orders_;
};

}  // namespace patchproof
