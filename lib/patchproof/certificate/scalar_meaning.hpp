#pragma once

#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <patchproof/certificate/proposition_table.hpp>
#include <patchproof/certificate/rocq_names.hpp>
#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// What scalars say, without names: those of the case unfolded, functions applied to their arguments.
class ScalarMeaning {
 public:
  /// A symbol that is bound: a variable with its level, or a formal with its argument.
  struct Scope {
    unsigned ordinal = 0;
    std::size_t level = 0;
    ScalarPointer value;
    const Scope* value_scope = nullptr;
    const Scope* outer = nullptr;
  };

  /// `levels` has the variables of the statement by their names.
  ScalarMeaning(PropositionTable& table, const RocqNames& names,
                std::map<std::string, std::size_t> levels)
      : table_{table}, names_{names}, levels_{std::move(levels)} {}

  /// The scope with one more variable.
  const Scope* with(const SymbolPointer& symbol, std::size_t level, const Scope* outer);

  /// `depth` is the number of binders around it.
  /// @throws NotScalar when nothing binds a symbol
  std::size_t of(const ScalarPointer& scalar, const Scope* scope, std::size_t depth);
  /// A coordinate of a symbol that is not bound here.
  std::size_t free(const Coordinate& coordinate);

 private:
  using Arguments = std::vector<ScalarPointer>;

  std::size_t computed(const Scalar& scalar, const Scope* scope, std::size_t depth);
  std::size_t from_the_left(const ScalarPointer& scalar, const Scope* scope, std::size_t depth);
  std::size_t variable(const Coordinate& coordinate, const Scope* scope, std::size_t depth);
  std::size_t application(const ScalarFunctionPointer& function, const Arguments& arguments,
                          const Scope* scope, std::size_t depth);
  std::size_t function(const ScalarFunctionPointer& function, const Scope* scope,
                       std::size_t depth);
  /// fun formals => body
  std::size_t abstraction(const std::vector<SymbolPointer>& formals, const ScalarPointer& body,
                          const Scope* scope, std::size_t depth);

  PropositionTable& table_;
  const RocqNames& names_;
  std::map<std::string, std::size_t> levels_;
  std::deque<Scope> scopes_;
  /// Keeps alive what the maps have addresses of.
  std::vector<ScalarPointer> seen_;
  std::vector<ScalarFunctionPointer> seen_functions_;
  std::map<std::tuple<const void*, const void*, std::size_t>, std::size_t> values_;
  std::map<std::tuple<const void*, const void*, std::size_t, std::vector<std::size_t>>, const Scope*>
      applications_;
};

}  // namespace patchproof
