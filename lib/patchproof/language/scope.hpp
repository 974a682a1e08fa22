#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <patchproof/language/fault.hpp>
#include <patchproof/language/syntax.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

struct Spline;

struct Functional;

/// What a name stands for.
struct Entity {
  enum class Kind { term, spline, functional, faulty };
  Kind kind = Kind::term;
  Term term;
  std::shared_ptr<const Spline> spline;
  Span declared;
  std::shared_ptr<const Functional> functional = nullptr;
};

/// The names known at one place, innermost first.
class Scope {
 public:
  explicit Scope(const Scope* outer = nullptr) : outer_{outer} {}

  const Entity* find(const std::string& name) const;
  /// Only in this scope, not in the outer ones.
  const Entity* find_here(const std::string& name) const;
  void declare(const std::string& name, Entity entity);
  void declare(const std::string& name, const Term& term) {
    declare(name, Entity{Entity::Kind::term, term, nullptr, term.span()});
  }
  /// All names, for "did you mean".
  std::vector<std::string> names() const;

 private:
  const Scope* outer_;
  std::map<std::string, Entity> entities_;
};

/// `let E(q) = integral(dot(q_uv, q_uv), ...)`: a value made of curves, patches or nets. It is expanded
/// where it is used, in the scope of its declaration.
struct Functional {
  std::vector<syntax::Name> formals;
  syntax::ExpressionPointer value;
  /// Which formals stand for functions or nets; the others for scalars.
  std::vector<bool> is_function;
  Scope scope;
};

/// Makes symbols and counts terms while one case is checked.
class Workshop {
 public:
  SymbolPointer symbol(const std::string& name, Symbol::Role role, const Type& type,
                       int smoothness = 0);

  /// Counts one more term. @throws Fault when one statement has made too many.
  void count_term(const Span& span);
  void start_statement() { terms_ = 0; }

  /// How many definitions are being expanded inside each other.
  int expansion_depth = 0;

 private:
  unsigned ordinals_ = 0;
  std::size_t terms_ = 0;
};

/// What one statement may expand to.
inline constexpr std::size_t most_terms_of_a_statement = 400'000;

}  // namespace patchproof
