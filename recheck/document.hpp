#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <recheck/number.hpp>

/// What a document of certificates says, after it was read: docs/certificates.md.
namespace recheck {

using NodeIndex = std::size_t;
using SymbolIndex = std::size_t;

/// A scalar, a point, a matrix of one of them; or a function with such values.
struct Type {
  enum class Kind { scalar, point, matrix };
  Kind kind = Kind::scalar;
  /// Of a point, or of the points in a matrix: 0 for scalars.
  std::size_t dimension = 0;
  /// A point, or entries that are points, of any dimension: one coordinate stands for all.
  bool any = false;
  std::size_t rows = 1;
  std::size_t columns = 1;
  /// Functions: how many arguments; the rest is the type of a value. 0: not a function.
  std::size_t arguments = 0;

  bool is_scalar() const { return kind == Kind::scalar && arguments == 0; }
  bool is_function() const { return arguments > 0; }
  bool has_points() const { return dimension > 0 || any; }
  /// How many scalars an entry has, and how many a value.
  std::size_t width() const { return dimension > 0 ? dimension : 1; }
  std::size_t component_count() const { return rows * columns * width(); }
  friend bool operator==(const Type&, const Type&) = default;
};

struct Symbol {
  enum class Role { parameter, scalar, point, function, bound };
  std::string name;
  Role role = Role::scalar;
  Type type;
  std::size_t smoothness = 0;
  std::size_t ordinal = 0;
};

enum class Operation {
  number,
  pi,
  symbol,
  tuple,
  matrix,
  sum,
  negation,
  product,
  quotient,
  power,
  sine,
  cosine,
  exponential,
  square_root,
  lambda,
  apply,
  derivative,
  component,
  entry,
  slice,
  transpose,
  matrix_product,
  determinant,
  dot,
  cross,
  bernstein,
  bspline_basis,
  integral,
  definition
};

/// One node of the terms; its children come before it.
struct Node {
  Operation operation = Operation::number;
  Type type;
  std::vector<NodeIndex> children;
  Rational number;
  SymbolIndex symbol = 0;
  long exponent = 0;
  std::vector<SymbolIndex> formals;
  /// Orders of a derivative, indices, degree and index of a Bernstein polynomial; degree, index and
  /// span of a B-spline basis function.
  std::vector<std::size_t> indices;
  std::vector<Rational> knots;
  /// Whether some coordinate of a point of any dimension stands in it: whichever is looked at.
  bool has_any_coordinate = false;
};

enum class Relation { equal, not_equal, less, less_equal, greater, greater_equal };

struct Statement {
  NodeIndex left = 0;
  Relation relation = Relation::equal;
  NodeIndex right = 0;
};

struct Range {
  SymbolIndex parameter = 0;
  NodeIndex lower = 0;
  NodeIndex upper = 0;
};

struct Sequent {
  std::vector<Statement> hypotheses;
  std::vector<Range> ranges;
  std::vector<Statement> conclusions;
};

struct Cofactor {
  /// What a parameter of the hypothesis is, after as many derivatives.
  struct At {
    SymbolIndex parameter = 0;
    NodeIndex value = 0;
    std::size_t order = 0;
  };
  std::size_t hypothesis = 0;
  std::size_t component = 0;
  std::vector<At> at;
  NodeIndex factor = 0;
};

struct Combination {
  struct Summand {
    Rational coefficient;
    std::vector<NodeIndex> squares;
    std::vector<std::pair<std::size_t, std::size_t>> facts;
  };
  std::vector<Summand> summands;
  std::vector<Cofactor> cofactors;
};

struct SignProof {
  struct Step {
    NodeIndex fact = 0;
    bool strict = false;
    Combination why;
  };
  std::vector<Step> steps;
  /// Either the end, or what is cut at and two cases.
  std::optional<Combination> end;
  NodeIndex cut = 0;
  std::vector<SignProof> cases;
};

struct ComponentProof {
  std::size_t conclusion = 0;
  std::size_t component = 0;
  std::optional<std::vector<Cofactor>> equation;
  std::optional<SignProof> sign;
  bool negative = false;
};

struct NonZero {
  NodeIndex scalar = 0;
  std::optional<std::size_t> hypothesis;
  std::optional<SignProof> sign;
  bool negative = false;
};

/// Factor times some divisor is, but for a number, the product of scalars that are not zero.
struct Divisor {
  NodeIndex factor = 0;
  std::vector<std::size_t> product;
};

struct Proof {
  Sequent sequent;
  std::vector<ComponentProof> components;
  std::vector<NonZero> not_zero;
  std::vector<Divisor> divisors;
};

struct Refutation {
  Sequent sequent;
  std::map<SymbolIndex, NodeIndex> values;
  std::size_t conclusion = 0;
  std::size_t component = 0;
};

/// A certificate: all proofs are right, or the refutation is.
struct Certificate {
  std::string claim;
  std::vector<Symbol> symbols;
  std::vector<Node> nodes;
  /// The free symbols of each node; of a definition those of its expansion.
  std::vector<std::set<SymbolIndex>> free_symbols;
  std::vector<Proof> proofs;
  std::optional<Refutation> refutation;
};

struct Document {
  std::string name;
  std::vector<Certificate> certificates;
};

}  // namespace recheck
