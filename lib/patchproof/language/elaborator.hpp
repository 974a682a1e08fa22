#pragma once

#include <string>
#include <vector>

#include <patchproof/language/construction.hpp>
#include <patchproof/language/library.hpp>
#include <patchproof/language/spline.hpp>
#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// How many instances a family of claims may have.
inline constexpr std::size_t most_instances = 4096;

/// Gives meaning to expressions: names are looked up, definitions expanded, types checked.
///
/// What is wrong is thrown as Fault; FollowUp when a name's own declaration was wrong.
class Elaborator {
 public:
  Elaborator(const Library& library, Workshop& workshop)
      : library_{library}, workshop_{workshop}, construct_{workshop} {}

  Term expression(const syntax::Expression& expression, const Scope& scope);

  /// What a name stands for, with quotes (C1'') and suffixes (r_uv) read as derivatives.
  Term name(const std::string& text, const Span& span, const Scope& scope);

  /// `first..last` with both ends known beforehand.
  std::pair<int, int> interval(const syntax::Interval& interval, const Scope& scope);

  /// All combinations of values of the binders, the last one running fastest; Fault for more than
  /// `most`.
  std::vector<std::vector<int>> combinations(const std::vector<syntax::Binder>& binders,
                                             const Scope& scope, std::size_t most = 100'000);
  static Scope bound(const Scope& scope, const std::vector<syntax::Binder>& binders,
                     const std::vector<int>& values);

  /// Whether the expression is a number known beforehand, such as a running index.
  bool is_number(const syntax::Expression& expression, const Scope& scope);

  /// The spline a name or a call like insert_knot(T, 1/2) stands for; Fault when it is none.
  Spline spline(const syntax::Expression& expression, const Scope& scope);

  Construction& construct() { return construct_; }
  Workshop& workshop() { return workshop_; }
  const Library& library() const { return library_; }

 private:
  Term call(const syntax::Expression& expression, const Scope& scope);
  Term index(const syntax::Expression& expression, const Scope& scope);
  Term functional_call(const Functional& functional, const syntax::Expression& call,
                       const Scope& scope);
  Term definition_call(const syntax::Definition& definition, const syntax::Expression& call,
                       const Scope& scope);
  Term expanded(const syntax::Definition& definition, Scope& inside, std::vector<Term> arguments,
                const Span& span);
  Term argument(const syntax::Formal& formal, const Term& given, const Scope& scope);
  Term as_function(const syntax::Formal& formal, const Term& given, const Scope& scope);
  Term as_list(const Term& given);
  Term definition_as_function(const syntax::Definition& definition, const Span& span);
  [[noreturn]] void unknown_name(const std::string& text, const Span& span, const Scope& scope);

  const Library& library_;
  Workshop& workshop_;
  Construction construct_;
};

}  // namespace patchproof
