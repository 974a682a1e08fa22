#pragma once

#include <recheck/document.hpp>
#include <recheck/place.hpp>

namespace recheck {

/// The table of symbols of a certificate.
std::vector<Symbol> symbols_of(const Place& table, const Limits& limits);

/// The table of nodes, with their types; children stand before their parents.
std::vector<Node> nodes_of(const Place& table, const std::vector<Symbol>& symbols,
                           const Limits& limits);

/// The free symbols of each node; of a definition those of its expansion.
std::vector<std::set<SymbolIndex>> free_symbols_of(const std::vector<Node>& nodes,
                                                   const Place& table, const Limits& limits);

}  // namespace recheck
