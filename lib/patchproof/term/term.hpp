#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <patchproof/algebra/number.hpp>
#include <patchproof/term/span.hpp>
#include <patchproof/term/symbol.hpp>
#include <patchproof/term/type.hpp>

namespace patchproof {

/// What a term does with its children. The comment gives children -> meaning.
enum class Operation {
  number,           ///< () payload Rational
  pi,               ///< () the number pi
  symbol,           ///< () payload SymbolPointer: parameter, scalar, bound, point or function
  tuple,            ///< (scalars) -> point
  matrix,           ///< (entries, row by row) -> matrix; shape in the type
  sum,              ///< (two or more of one type) -> entrywise sum
  negation,         ///< (x) -> -x
  product,          ///< (scalars and at most one point or matrix) -> product
  quotient,         ///< (x, scalar) -> x divided by a scalar
  power,            ///< (scalar) payload long: exponent, any whole number
  sine, cosine, exponential, square_root,  ///< (scalar) -> scalar
  lambda,           ///< (body) payload Formals -> function
  apply,            ///< (function, arguments...) -> value
  derivative,       ///< (function) payload Indices: order in each parameter -> function
  component,        ///< (point) payload Indices{k} -> scalar, k from 0
  entry,            ///< (matrix) payload Indices{i, j} -> entry, from 0
  slice,            ///< (matrix) payload Indices{i0, i1, j0, j1}, inclusive -> matrix
  transpose,        ///< (matrix) -> matrix
  matrix_product,   ///< (matrix, matrix, ...) -> matrix; a 1 x 1 result still is a matrix
  determinant,      ///< (square matrix of scalars) -> scalar
  dot,              ///< (point, point) of one known dimension -> scalar
  cross,            ///< (point, point) in R^3 -> point in R^3
  bernstein,        ///< (t) payload Indices{n, i} -> B_i^n(t) = C(n,i) t^i (1-t)^(n-i)
  bspline_basis,    ///< (t) payload BasisFunction -> its polynomial piece on one span
  integral,         ///< (function, lower, upper, ...) -> its integral, one pair of bounds for each
                    ///< parameter; the bounds do not contain the parameters
  definition,       ///< (expansion, arguments...) payload string: name -> value of the expansion
};

/// The formal parameters of a lambda; role `parameter` or `bound`.
using Formals = std::vector<SymbolPointer>;
using Indices = std::vector<int>;

/// N_{index,degree} on the knot span [knots[span], knots[span+1]], as a polynomial in the local
/// parameter t in [0,1]: the argument is (1-t)*knots[span] + t*knots[span+1].
/// Source: Piegl & Tiller, The NURBS Book, 2.2 (Cox-de Boor recursion).
struct BasisFunction {
  int degree = 0;
  int index = 0;
  int span = 0;
  std::vector<Rational> knots;
};

class Term;

/// One node of a term; made only by `make_term`.
struct TermNode {
  using Payload = std::variant<std::monostate, Rational, SymbolPointer, long, Formals, Indices,
                               BasisFunction, std::string>;
  Operation operation;
  Type type;
  std::vector<Term> children;
  Payload payload;
  Span span;
  /// 1 for leaves, else one more than the deepest child.
  int depth = 1;
};

/// A typed expression tree in the vocabulary of the textbook, immutable and shared.
class Term {
 public:
  Term() = default;
  explicit Term(std::shared_ptr<const TermNode> node) : node_(std::move(node)) {}

  const TermNode& operator*() const { return *node_; }
  const TermNode* operator->() const { return node_.get(); }
  explicit operator bool() const { return node_ != nullptr; }
  const TermNode* address() const { return node_.get(); }

  Operation operation() const { return node_->operation; }
  const Type& type() const { return node_->type; }
  const std::vector<Term>& children() const { return node_->children; }
  const Term& child(std::size_t i) const { return node_->children.at(i); }
  const Span& span() const { return node_->span; }

  /// The payload of the node.
  /// @throws std::bad_variant_access when the operation has another kind of payload.
  const Rational& number() const { return std::get<Rational>(node_->payload); }
  const SymbolPointer& symbol() const { return std::get<SymbolPointer>(node_->payload); }
  long exponent() const { return std::get<long>(node_->payload); }
  const Formals& formals() const { return std::get<Formals>(node_->payload); }
  const Indices& indices() const { return std::get<Indices>(node_->payload); }
  const BasisFunction& basis_function() const { return std::get<BasisFunction>(node_->payload); }
  const std::string& name() const { return std::get<std::string>(node_->payload); }

  bool is_number() const { return operation() == Operation::number; }

 private:
  std::shared_ptr<const TermNode> node_;
};

/// Deeper terms are rejected, so that every walk over a term may recurse.
inline constexpr int deepest_term = 1000;

/// Thrown when a term would be deeper than `deepest_term`.
class TooDeep : public std::length_error {
 public:
  using std::length_error::length_error;
};

/// A term with this operation over these children. The caller has checked the types.
/// @throws TooDeep
Term make_term(Operation operation, Type type, std::vector<Term> children,
               TermNode::Payload payload = {}, Span span = {});

/// Whether the two are one term that was mentioned at two places: the same operation over the very
/// same children, perhaps with other spans. Leaves are mentioned as themselves.
bool is_one_term(const Term& a, const Term& b);

Term number_term(const Rational& number, Span span = {});
Term symbol_term(const SymbolPointer& symbol, Span span = {});

}  // namespace patchproof
