#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/claims/joint.hpp>
#include <patchproof/decide/decision.hpp>
#include <patchproof/term/goal.hpp>
#include <patchproof/term/notation.hpp>

namespace patchproof {

/// What the author of the case expects: the verb of the claim.
enum class Expectation {
  prove,         ///< prove, derive, and the corrected part of an erratum
  refute,        ///< refute, and the printed part of an erratum
  open,          ///< open: not decided so far
  inconsistent,  ///< derive ... inconsistent
};

std::string to_text(Expectation expectation);

/// Statements that hold or do not; a joint is one, written out as equations.
struct IdentityClaim {
  Goal goal;
};

/// Unknowns, the equations that determine them, and what they are said to be.
struct DeriveClaim {
  SolveGoal goal;
  std::vector<Statement> gives;
  std::vector<SymbolPointer> leaves;
};

/// A candidate that is said to have the least value of a functional among its competitors.
struct MinimumClaim {
  MinimumGoal goal;
};

/// One thing to be decided. Instances of a family share label and span and differ in `instance`.
struct Claim {
  std::string label;
  /// "[i=0,j=2]" for an instance of a family, else "".
  std::string instance;
  /// "prove", "refute", "open", "derive", "printed", "corrected"
  std::string verb;
  Expectation expectation = Expectation::prove;
  Span span;
  /// The proposition alone, for messages.
  Span statement;
  /// Labels of derivations of the same case and family instance whose results may be used.
  std::vector<std::string> uses;
  /// Erratum: the note of its author.
  std::string note;
  std::variant<IdentityClaim, DeriveClaim, MinimumClaim> kind;
};

/// A joint whose smoothness is asked for.
struct JointQuestion {
  JointEdge first;
  JointEdge second;
  std::vector<Term> along;
  /// The assumptions and ranges, without statements.
  Goal given;
  Span span;
};

/// A term whose normal form is printed, or a joint that is described, without any verdict.
struct Shown {
  Span span;
  std::string instance;
  Term term;
  std::optional<JointQuestion> joint;
};

/// Where a case comes from.
struct Source {
  std::string work;
  std::string language;
  std::string section;
  std::string page;
};

/// One `assume` as written. Its relations are one after the other among the assumptions of the
/// claims below it.
struct WrittenAssumption {
  /// "" where the author gave none.
  std::string label;
  /// Index of the first relation, and how many there are.
  std::size_t first = 0;
  std::size_t count = 0;
  Span span;
  /// Why it is there although no proof needs it; "" where the author does not say.
  std::string note;
};

/// Something a case gives a name to: `patch r(u, v) = ...`, `point V[0..3, 0..3]`.
struct Declaration {
  std::string name;
  /// The word it is declared with: "point", "curve", "patch", "matrix", "let", …
  std::string keyword;
  /// As for claims, of a family "[m=1]".
  std::string instance;
  /// What it stands for: a symbol, a matrix of symbols, a function, a value.
  Term term;
  /// A free symbol, unknown function or array of symbols; not something defined.
  bool given = false;
  Span span;
};

/// A case as read: everything typed, nothing decided.
struct Case {
  std::string name;
  std::string title;
  /// Language -> the title in it.
  std::map<std::string, std::string> translated_titles;
  std::vector<Source> sources;
  std::string quote;
  std::vector<std::string> tags;
  Limits limits;
  Notation notation;
  /// Its name.
  Span span;
  /// From `case` to its `end`.
  Span whole;
  /// In the order written; splines and functionals, which are no terms, are left out.
  std::vector<Declaration> declarations;
  /// Splines and functionals as declared, such as "T = bspline(M, degree 3, clamped uniform)".
  std::vector<std::string> written;
  /// The names of patches, curves or volumes whose joints are spoken of, two by two.
  std::vector<std::pair<std::string, std::string>> joined;
  /// Those of the first instance of a family.
  std::vector<WrittenAssumption> assumptions;
  std::vector<Claim> claims;
  std::vector<Shown> shown;
};

}  // namespace patchproof
