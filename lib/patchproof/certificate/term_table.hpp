#pragma once

// Internal to the certificates: terms as JSON.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// JSON whose members stay in the order they were given.
using CertificateJson = nlohmann::ordered_json;

/// The symbols and nodes that stand in one certificate, each once: children before their parents,
/// symbols and nodes in the order in which they are first needed.
class TermTable {
 public:
  /// The index of the term among the nodes.
  /// @throws std::logic_error for an empty term
  std::size_t node(const Term& term);
  /// The index of the symbol; two are the same exactly when they have the same ordinal.
  /// @throws std::logic_error when two with one ordinal differ in role or type
  std::size_t symbol(const SymbolPointer& symbol);

  const CertificateJson& nodes() const { return nodes_; }
  CertificateJson symbols() const;

 private:
  CertificateJson node_without_children(const Term& term);

  std::unordered_map<const TermNode*, std::size_t> known_;
  /// Keeps the terms alive whose addresses are keys of `known_`.
  std::vector<Term> seen_;
  /// By what is written: equal nodes are one.
  std::unordered_map<std::string, std::size_t> written_;
  CertificateJson nodes_ = CertificateJson::array();
  std::vector<SymbolPointer> symbols_;
  std::map<unsigned, std::size_t> symbol_indices_;
};

}  // namespace patchproof
