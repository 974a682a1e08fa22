#pragma once

#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchproof/figure/example.hpp>
#include <patchproof/figure/sampled_function.hpp>

namespace patchproof {

/// A figure cannot be drawn, for a reason that lies in what was asked for.
class CannotDraw : public std::runtime_error {
 public:
  explicit CannotDraw(const std::string& problem, std::string its_help = "")
      : std::runtime_error{problem}, help{std::move(its_help)} {}
  std::string help;
};

/// A control net: rows belong to the first parameter. A curve has one column.
struct DrawnNet {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Point> points;
  const Point& at(std::size_t i, std::size_t j) const { return points[i * columns + j]; }
};

/// A curve, patch or scalar function that can be drawn.
struct Subject {
  std::string name;
  /// What its parameters are called.
  std::vector<std::string> parameters;
  SampledFunction function;
  /// The graph of a scalar function: its parameters are coordinates.
  bool is_graph = false;
  /// Lies in a plane and is drawn there.
  bool is_plane = false;
  /// Of a term that is said to be a Bézier curve or patch.
  std::optional<DrawnNet> net;

  bool is_surface() const { return function.parameter_count() == 2; }
  /// The point at a place of the domain, of a graph the point above it.
  Point at(const std::vector<Rational>& place) const;
};

/// A name and the point it stands for.
struct NamedPoint {
  std::string name;
  Point point;
};

/// Makes the things of one instance of a case ready to be drawn: everything open gets an example
/// value, the same in all that is drawn together.
class Studio {
 public:
  /// `names` as in the case, all of one instance: "p" or "p[m=2]".
  /// @throws CannotDraw, NoValue, OutsideTheory, FinerAngles, OverBudget
  Studio(const CaseResult& result, const std::vector<std::string>& names, Workspace& workspace);

  const std::vector<Subject>& subjects() const { return subjects_; }
  /// The two sides of a refuted equation, where the only name is the label of one.
  bool is_comparison() const { return is_comparison_; }

  /// The points in what is drawn, and the curves of the case, that have names: for labels.
  std::vector<NamedPoint> named_points();
  std::vector<Subject> named_curves();

  /// What was made up: "V stands for example points".
  std::vector<std::string> notes() const;

 private:
  const Declaration* declaration(const std::string& name) const;
  void compare(const Claim& claim);
  void prepare(const std::vector<Term>& terms);
  Subject subject(const std::string& name, const Term& term);
  Subject side(const std::string& name, const Term& term, const Formals& parameters);
  Subject made(const std::string& name, const Term& term, const std::vector<Variable>& variables,
               const std::vector<std::string>& names, const Type& value);
  std::vector<Fraction> coordinates(const Term& term);
  std::optional<DrawnNet> net_of(const Term& term);
  Point point_of(const std::vector<Fraction>& coordinates);
  ParameterInterval interval(const std::string& parameter, Variable own,
                             const std::vector<Variable>& variables,
                             const std::vector<std::string>& names);

  const Case& case_;
  Workspace& workspace_;
  std::string instance_;
  CaseFacts facts_;
  Example example_;
  std::vector<Evaluator> evaluators_;
  std::vector<Subject> subjects_;
  /// What occurs in the subjects.
  std::set<unsigned> symbols_;
  bool is_comparison_ = false;
};

}  // namespace patchproof
