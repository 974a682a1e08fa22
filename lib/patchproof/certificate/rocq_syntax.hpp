#pragma once

#include <memory>
#include <string>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

struct RocqTerm;
using RocqTermPointer = std::shared_ptr<const RocqTerm>;

/// A variable that `forall` or `fun` binds.
struct RocqBinder {
  std::string name;
  /// "nat -> R", "(R -> R) -> R": without more brackets than needed.
  std::string type;
};

/// A term or a proposition as Rocq prints it, without any meaning yet. Immutable.
struct RocqTerm {
  enum class Kind {
    number,       ///< number; with `natural` it was written 3%nat
    name,         ///< name
    application,  ///< parts: a function and its arguments, at least one
    function,     ///< fun binders => parts[0]
    forall,       ///< forall binders, parts[0]
    implication,  ///< parts, each -> the next: A -> (B -> C)
    disjunction,  ///< parts with \/ between; A \/ (B \/ C)
    conjunction,  ///< parts with /\ between; A /\ (B /\ C)
    negation,     ///< ~ parts[0]
    relation,     ///< parts with the operators between; three of them are a chain a <= b <= c
    sum,          ///< parts with + and - between, from the left: (a + b) - c
    product,      ///< parts with * and / between, from the left
    opposite,     ///< - parts[0]
    power,        ///< parts[0] ^ parts[1]
  };
  Kind kind = Kind::number;
  Integer number;
  bool natural = false;
  std::string name;
  std::vector<RocqTermPointer> parts;
  /// One less than parts: of relations, sums and products.
  std::vector<std::string> operators;
  std::vector<RocqBinder> binders;
};

/// The term written on one line, with the brackets that a reader needs; read again it is the same.
std::string to_text(const RocqTerm& term);

/// Whether it is a type of variables: R, nat, R -> R. In front of -> it stands for a variable that
/// does not occur: Rocq prints `forall x : R, A` as `R -> A`.
bool is_type(const RocqTerm& term);

/// Whether two terms are written alike, but for brackets and line breaks.
bool same_writing(const RocqTerm& a, const RocqTerm& b);

}  // namespace patchproof
