#pragma once

#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <patchproof/certificate/proposition_table.hpp>
#include <patchproof/certificate/rocq_syntax.hpp>

namespace patchproof {

/// What terms that Rocq has printed say: definitions unfolded, functions applied to their arguments,
/// no names for what is bound.
class RocqMeaning {
 public:
  explicit RocqMeaning(PropositionTable& table) : table_{table} {}

  /// From now on the name stands for the term; a null term has the problem given.
  void define(const std::string& name, RocqTermPointer term, const std::string& problem = "");

  /// @throws RocqUnreadable where a name is unknown, or the term is no proposition
  std::size_t of_proposition(const RocqTermPointer& term);

 private:
  /// A name and what it is bound to: a variable with its level and type, or a term in its scope.
  struct Scope {
    std::string name;
    std::size_t level = 0;
    std::string type;
    const RocqTerm* value = nullptr;
    const Scope* value_scope = nullptr;
    const Scope* outer = nullptr;
  };
  struct Argument {
    const RocqTerm* term = nullptr;
    const Scope* scope = nullptr;
  };
  struct Definition {
    RocqTermPointer term;
    std::string problem;
  };
  class Nesting;

  std::size_t proposition(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t implication(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t relation(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t smoothness(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t value(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t applied(const RocqTerm* term, const Scope* scope, std::vector<Argument> arguments,
                      std::size_t depth);
  std::size_t operation(const RocqTerm& term, const Scope* scope, std::size_t depth);
  std::size_t variable(const Scope& of, const std::vector<Argument>& arguments, std::size_t depth);
  std::size_t word(const std::string& name, const std::vector<Argument>& arguments,
                   std::size_t depth);
  std::size_t function_from(const RocqTerm& term, std::size_t binder, const Scope* scope,
                            std::size_t depth);
  /// The arguments bound to the first binders; the same scope again for the same arguments.
  const Scope* with_arguments(const RocqTerm& function, const Scope* scope,
                              const std::vector<Argument>& arguments, std::size_t depth);
  /// Tells arguments apart, also those that are no values.
  std::size_t identity(const Argument& argument, std::size_t depth);
  std::size_t applied_to_rest(std::size_t function, const std::vector<Argument>& arguments,
                              std::size_t first, std::size_t depth);
  const Scope* bound(const RocqBinder& binder, std::size_t level, const Scope* outer);
  const Scope* found(const std::string& name, const Scope* scope);
  static std::string natural(const Argument& argument, bool marked);
  void count(std::size_t work);

  PropositionTable& table_;
  std::map<std::string, Definition> definitions_;
  std::deque<Scope> scopes_;
  /// Keeps alive what the maps have addresses of.
  std::vector<RocqTermPointer> roots_;
  std::map<std::tuple<const void*, const void*, std::size_t>, std::size_t> values_;
  std::map<std::tuple<const void*, const void*, std::size_t, std::vector<std::size_t>>, const Scope*>
      applications_;
  std::size_t work_ = 0;
  std::size_t nesting_ = 0;
};

}  // namespace patchproof
