#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/claims/joint.hpp>
#include <patchproof/language/elaborator.hpp>

namespace patchproof {

/// Reads a case: its declarations in order, then its claims as goals. What is wrong is appended to
/// `diagnostics`; the case is complete only when there is nothing new there.
Case elaborated(const syntax::Case& written, const Library& library, const Limits& limits,
                std::vector<Diagnostic>& diagnostics);

/// One instance of a case: the values of the running indices of its family.
struct CaseInstance {
  /// "m=1,n=2"; "" for a case without a family.
  std::string text;
  std::vector<std::pair<syntax::Name, int>> values;
};

/// All instances of a case; one without values where there is no family.
/// @throws Fault when the family has no or too many instances.
std::vector<CaseInstance> instances_of(const syntax::Case& written, const Library& library);

/// Whether such a statement says something, rather than something about the case as a whole.
bool has_meaning(syntax::Statement::Kind kind);
/// Checks that no parameter occurs twice. @throws Fault
void require_different(const std::vector<syntax::Name>& parameters);

/// The work on one instance of a case; see `elaborated`.
class CaseElaborator {
 public:
  CaseElaborator(const Library& library, std::string instance,
                 std::vector<Diagnostic>& diagnostics);

  /// A running index of the family, before any statement.
  void declare_number(const std::string& name, int value, const Span& span);
  void statement(const syntax::Statement& statement, Case& result);
  /// What is declared so far.
  const Scope& scope() const { return scope_; }
  /// The names in joints so far, two by two.
  const std::vector<std::pair<std::string, std::string>>& joined() const { return joined_; }

 private:
  // declarations (case_declarations.cpp)
  void declare(const syntax::Statement& statement);
  /// Takes over into the case what a statement has declared.
  void record(const syntax::Statement& statement, Case& result) const;
  void record_parameters(const syntax::Statement& statement, Case& result) const;
  void declare_parameters(const syntax::Statement& statement);
  void declare_symbols(const syntax::Statement& statement);
  void declare_functions(const syntax::Statement& statement);
  void declare_matrix(const syntax::Declarator& declarator);
  void declare_let(const syntax::Declarator& declarator);
  void assume(const syntax::Statement& statement, Case& result);
  Term unknown_function(const syntax::Statement& statement, const syntax::Declarator& declarator,
                        const Type& value);
  Term degree_function(const syntax::Statement& statement, const syntax::Declarator& declarator,
                       const Type& value);
  Term defined_function(const syntax::Declarator& declarator);
  Term array(const syntax::Declarator& declarator, Symbol::Role role, const Type& type);
  void declare_name(const syntax::Name& name, const Term& term);
  void require_new(const syntax::Name& name);
  void mark_faulty(const syntax::Statement& statement);
  Formals formals_of(const std::vector<syntax::Name>& names, Scope& inner);

  // claims (case_claims.cpp)
  void claim(const syntax::Statement& statement, Case& result);
  void identity(const syntax::Statement& statement, const syntax::Proposition& proposition,
                const std::string& label, const std::string& verb, const Scope& scope,
                const std::string& instance, Case& result);
  void derive(const syntax::Statement& statement, const Scope& scope, const std::string& instance,
              Case& result);
  // minima (case_minimum.cpp)
  MinimumClaim minimum(const syntax::Minimum& minimum, const Scope& scope);
  Goal goal_of(const syntax::Proposition& proposition, const Scope& scope);
  void add_comparison(const syntax::Comparison& comparison, const Scope& scope, Goal& goal);
  void add_relation(Term left, Relation relation, Term right, const Span& span, const Scope& scope,
                    Goal& goal);
  void add_boundary_relation(const Term& left, const Term& right, const Span& span,
                             const Scope& scope, Goal& goal);
  std::pair<Term, Term> range_of(const std::string& parameter) const;
  void require_equal_ranges(const JointEdge& first, const JointEdge& second,
                            const Span& span) const;
  JointEdge edge_of(const syntax::Edge& edge, const Scope& scope);
  JointQuestion joint_of(const syntax::Joint& joint, const Scope& scope, const Goal& given);
  std::vector<Term> connecting_functions(const syntax::Joint& joint, const JointQuestion& question,
                                         const Scope& scope);
  void add_joint(const syntax::Joint& joint, const Scope& scope, Goal& goal);
  void show(const syntax::Statement& statement, Case& result);
  std::vector<SymbolPointer> unknowns_of(const Term& term, const Span& span) const;
  void check_uses(const syntax::Statement& statement, Claim& claim);

  Workshop workshop_;
  Elaborator elaborator_;
  Scope scope_;
  std::string instance_;
  std::vector<Diagnostic>& diagnostics_;
  std::vector<ParameterRange> ranges_;
  std::vector<Assumption> assumptions_;
  std::set<unsigned> holes_;
  std::set<std::string> derivations_;
  std::vector<std::pair<std::string, std::string>> joined_;
};

}  // namespace patchproof
