#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/algebra/number.hpp>
#include <patchproof/term/span.hpp>

/// The syntax tree of the case language, as written; nothing is known of names or types here.
namespace patchproof::syntax {

struct Expression;
using ExpressionPointer = std::shared_ptr<const Expression>;

/// A name with its place. Quotes belong to it: "C1''".
struct Name {
  std::string text;
  Span span;
};

/// `first..last`, both inclusive.
struct Interval {
  ExpressionPointer first;
  ExpressionPointer last;
};

/// `i in 0..3`
struct Binder {
  Name name;
  Interval interval;
};

/// `[a, b]`
struct Range {
  ExpressionPointer lower;
  ExpressionPointer upper;
  Span span;
};

/// `u in [0, 1]`
struct RangeBinder {
  Name name;
  Range range;
};

/// One argument of a call or one index of an index expression.
struct Argument {
  /// The value; empty when one of the others is set.
  ExpressionPointer value;
  /// `i in 0..3`, as in sum(..., i in 0..3).
  std::optional<Binder> binder;
  /// `0..3` as in M[0..3, 3..6].
  std::optional<Interval> interval;
  /// `u in [0, 1]`, as in integral(..., u in [0, 1]).
  std::optional<RangeBinder> range;
};

/// One expression. Sums, products and comparisons are flat lists, so that a line of a million
/// summands is one node, not a tree a million deep.
struct Expression {
  enum class Kind {
    number,      ///< `number`
    name,        ///< `text`
    hole,        ///< `?`
    sum,         ///< operands with signs: signs[k] is '+' or '-' ; signs[0] '-' for a leading minus
    product,     ///< operands with signs: '*' or '/' ; signs[0] is '*'
    negation,    ///< -operands[0], where the grammar allows a sign inside a term (as in x^-2, a + -b)
    power,       ///< operands[0] ^ operands[1]
    call,        ///< operands[0] ( arguments )
    index,       ///< operands[0] [ arguments ]
    component,   ///< operands[0] . text      (x, y or z)
    tuple,       ///< ( a, b, ... ) with two or more operands; (a) is just a, parenthesised
    matrix,      ///< rows of equal length
  };
  Kind kind = Kind::number;
  Span span;
  Rational number;
  std::string text;  ///< name as written; for numbers the digits as written
  std::vector<ExpressionPointer> operands;
  std::string signs;
  std::vector<Argument> arguments;
  std::vector<std::vector<ExpressionPointer>> rows;
  /// Where the operator, '(' or '[' stands: what a message about this node points at, if not span.
  Span mark;
  /// Written inside parentheses of its own: `(a + b)`.
  bool parenthesised = false;
  /// How many levels of brackets, exponents, signs and postfix operators are at or below this
  /// node; at most `deepest_nesting`, so that functions may recurse over expressions.
  int height = 0;
};

/// `a == b`, or a chain `a == b == c`; operators[k] stands between operands[k] and operands[k+1].
struct Comparison {
  std::vector<ExpressionPointer> operands;
  std::vector<std::string> operators;  ///< "==", "!=", "<", "<=", ">", ">="
  std::vector<Span> operator_spans;
  bool on_boundary = false;
  Span span;
};

/// `P at v = 1`
struct Edge {
  Name patch;
  Name parameter;
  ExpressionPointer value;
};

/// `C^2 joint of P at v = 1 and R at v = 0`, `G^1 joint of ... with alpha, gamma`
struct Joint {
  bool geometric = false;  ///< G^k, not C^k
  int order = 0;
  Edge first;
  Edge second;
  std::vector<ExpressionPointer> functions;  ///< G^k: the connecting functions; empty: not given
  Span span;
};

/// `r minimizes E(p) over p where p == r on boundary`
struct Minimum {
  ExpressionPointer candidate;
  ExpressionPointer functional;
  Name competitor;
  std::vector<Comparison> constraints;
  Span span;
};

/// What a claim states: comparisons joined by commas, a joint, or a minimum.
struct Proposition {
  std::vector<Comparison> comparisons;
  std::optional<Joint> joint;
  std::vector<Joint> further_joints;  ///< derive ... from several joints: those after the first
  std::optional<Minimum> minimum;
  Span span;
};

/// `C^2`
struct Smoothness {
  int order = 0;
  Span span;
};

/// `"surface.csv"`, as written.
struct FileName {
  std::string path;
  Span span;
};

/// One declared name with what may stand behind it:
/// `P`, `V[0..3, 0..3]`, `C1(u)`, `C1(u) = (u, 0)`, `M = [...]`, `b[i,j] = ...`, `d from "d.csv"`.
struct Declarator {
  Name name;
  std::vector<Interval> extents;       ///< point/scalar arrays
  std::vector<Name> parameters;        ///< functions: formal parameters; nets: index names
  ExpressionPointer value;             ///< what it is defined as, or empty
  std::optional<FileName> file;        ///< nets: where the points stand
};

/// `param u, v in [0,1], t in [a,b]` : one group per range.
struct ParameterGroup {
  std::vector<Name> names;
  Range range;
};

/// `bspline(M, degree 3, 3, clamped uniform)` or `bspline(M, degree 2, weights w, knots [..], [..])`;
/// `merged(B, …)` has Bézier points instead of control points.
struct SplineData {
  bool merged = false;
  ExpressionPointer control_points;
  std::vector<int> degrees;
  ExpressionPointer weights;             ///< empty: polynomial
  std::vector<ExpressionPointer> knots;  ///< empty: clamped uniform
};

/// `r = "\\mathbf r"`: how a name is written in LaTeX.
struct Notation {
  Name name;
  std::string latex;
  Span span;  ///< of the text, without its quotes
};

struct Clauses {
  std::vector<Name> using_labels;
  std::vector<Binder> binders;
};

/// One statement of a case (or of a definition: title, source, let).
struct Statement {
  enum class Kind {
    title, source, quote, tags, limit, notation,
    parameter, scalar, point, curve, patch, volume, matrix, net, spline, let, assume, family,
    prove, refute, open, derive, erratum, show,
  };
  Kind kind = Kind::title;
  Span span;      ///< the whole statement
  Span keyword;

  std::string text;                       ///< title, quote; source: the work cited
  std::optional<Name> language;           ///< source ... lang sk
  std::optional<std::string> section;     ///< source ... section "..."
  std::optional<std::string> page;        ///< source ... page 12
  std::vector<Name> tags;
  std::optional<Name> limit_kind;         ///< limit time 5 s, limit memory 100 MB, limit terms 1000
  std::optional<Rational> limit_value;
  std::optional<Name> limit_unit;

  std::vector<Notation> notations;        ///< notation r = "\\mathbf r", C1 = "C_1"
  std::optional<Name> derivative_style;   ///< notation derivatives superscript

  std::vector<ParameterGroup> parameters;
  std::vector<Declarator> declarators;    ///< scalar, point, curve, patch, volume, matrix, net, spline, let
  std::optional<Smoothness> smoothness;   ///< curve/patch/scalar ... : C^2
  std::optional<Name> space;              ///< point/curve/patch ... in R^3 -> Name "R", dimension
  int dimension = 0;                      ///< of `in R^3`; 0 when not given
  std::vector<int> degrees;               ///< patch ... : degree (3, 3); curve ... : degree 3
  std::optional<SplineData> spline;
  std::vector<Binder> binders;            ///< net ... for ..., family ...

  std::optional<Name> label;              ///< claims, assume
  Proposition proposition;                ///< prove, refute, open, derive (from), assume
  Clauses clauses;
  std::vector<ExpressionPointer> unknowns;  ///< derive
  std::vector<ExpressionPointer> gives;     ///< derive ... gives
  bool underdetermined = false;             ///< derive ... leaves a, b
  std::vector<ExpressionPointer> leaves;
  bool inconsistent = false;                ///< derive ... inconsistent
  Proposition printed;                      ///< erratum
  Proposition corrected;                    ///< erratum
  std::optional<std::string> note;          ///< erratum, assume
  ExpressionPointer shown;                  ///< show
  std::optional<Joint> shown_joint;         ///< show joint of ... and ...
};

/// The declared type of a formal parameter of a definition, or of its result.
struct FormalType {
  enum class Kind {
    scalar, scalar_function, point, curve, patch, volume, net, matrix, list, spline,
  };
  Kind kind = Kind::scalar;
  std::vector<Name> parameters;  ///< curve(u), patch(u, v), volume(u, v, w)
  Span span;
};

struct Formal {
  Name name;
  FormalType type;
};

/// `define name(formals) : type  title ... source ... let ...  = value end`
struct Definition {
  Name name;
  std::vector<Formal> formals;
  FormalType result;
  std::vector<Statement> statements;  ///< title, source, quote, let
  ExpressionPointer value;
  Span span;
};

/// `case a.b ... end`
struct Case {
  Name name;
  std::vector<Statement> statements;
  Span span;
};

struct Include {
  std::string path;
  Span span;
};

/// A file: includes, definitions and cases, in the order written.
struct File {
  std::shared_ptr<const SourceText> source;
  std::vector<Include> includes;
  std::vector<Definition> definitions;
  std::vector<Case> cases;
};

}  // namespace patchproof::syntax
