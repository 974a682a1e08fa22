#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/certificate/rocq_text.hpp>
#include <patchproof/certificate/rocq_twin.hpp>
#include <patchproof/certificate/scalars.hpp>

namespace patchproof {

/// A statement of Rocq, premise by premise, and the names its proof uses for them.
struct RocqStatement {
  /// "C1 C2 : R -> R", "V : nat -> nat -> R"
  std::vector<std::string> quantified;
  struct Premise {
    std::string name;
    std::string text;
  };
  /// smooth 2 C1
  std::vector<Premise> smoothness;
  /// Equations, for all parameters in them, and what restricts no parameter.
  std::vector<Premise> hypotheses;
  std::vector<std::string> parameters;
  /// 0 <= u <= 1, and what restricts parameters.
  std::vector<Premise> restrictions;
  std::string conclusion;

  /// The whole proposition, on several lines.
  std::string text() const;
};

/// Writes the statement of a sequent, and names for what it speaks of.
class RocqSequent {
 public:
  RocqSequent(const Sequent& sequent, Scalars& scalars, RocqNames& names, RocqText& text);

  const RocqStatement& statement() const { return statement_; }
  const Sequent& sequent() const { return sequent_; }
  /// Symbols quantified first: no parameters; by ordinal.
  const std::vector<SymbolPointer>& symbols() const { return symbols_; }
  const std::vector<SymbolPointer>& parameters() const { return parameters_; }
  /// Unknown functions whose derivatives occur.
  bool is_differentiated(const SymbolPointer& function) const;
  /// How smooth it is taken to be: as its class says, or as its derivatives of all kinds need.
  int smoothness(const SymbolPointer& function) const;
  /// The name of the premise of a hypothesis, and of the range of a parameter.
  std::string hypothesis_name(std::size_t hypothesis) const;
  std::string range_name(const SymbolPointer& parameter) const;
  /// The name of the premise that a function is smooth.
  /// @throws NotScalar when it is not assumed to be
  std::string smoothness_name(const Coordinate& function) const;
  /// "  intros …" for everything in front of the conclusion, a line; "" when there is nothing.
  std::string introductions() const;
  /// Whether a hypothesis stands behind the parameters of the conclusions.
  bool is_restriction(std::size_t hypothesis) const;
  /// Whether the parameters of a hypothesis that is an equation are restricted by others.
  std::vector<std::size_t> guards_of(std::size_t hypothesis) const;

  /// The two sides of one component.
  std::pair<ScalarPointer, ScalarPointer> sides(const Statement& statement, std::size_t component);

 private:
  void collect();
  std::string relation_text(const Statement& statement);
  std::string hypothesis_text(std::size_t hypothesis);
  std::string range_text(const ParameterRange& range);
  void note_derivatives(const Term& term, std::set<const TermNode*>& seen);

  const Sequent& sequent_;
  Scalars& scalars_;
  RocqNames& names_;
  RocqText& text_;
  std::vector<SymbolPointer> symbols_;
  std::vector<SymbolPointer> parameters_;
  /// Unknown functions under derivatives, and the highest order in all.
  std::map<unsigned, int> differentiated_;
  std::map<const TermNode*, int> orders_;
  RocqStatement statement_;
};

/// How to get part number `index` of `count` out of a proof of A /\ (B /\ C).
std::string rocq_part(const std::string& proof, std::size_t index, std::size_t count);

}  // namespace patchproof
