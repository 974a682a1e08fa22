#include <patchproof/figure/studio.hpp>

#include <algorithm>
#include <set>

#include <patchproof/kernel/transformation.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// "p[m=2]" is p in the instance [m=2].
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t bracket = name.find('[');
  if (bracket == std::string::npos) return {name, ""};
  return {name.substr(0, bracket), name.substr(bracket)};
}

std::string first_instance(const Case& given) {
  return given.declarations.empty() ? "" : given.declarations.front().instance;
}

bool is_drawable(const Declaration& declaration) {
  const Type& type = declaration.term.type();
  return type.is_function() && type.parameters.size() <= 2 &&
         (type.inner->is_point() || type.inner->is_scalar());
}

const Statement* compared(const Claim& claim, std::size_t statement) {
  const auto* identity = std::get_if<IdentityClaim>(&claim.kind);
  if (identity == nullptr || identity->goal.statements.size() <= statement) return nullptr;
  const Statement& found = identity->goal.statements[statement];
  return found.relation == Relation::equal ? &found : nullptr;
}

// Patches over the triangle u, v >= 0, u + v <= 1.
bool is_triangular(const Term& term) {
  if (term.operation() == Operation::lambda || term.operation() == Operation::apply)
    return is_triangular(term.child(0));
  return term.operation() == Operation::definition &&
         (term.name() == "bezier_triangle" || term.name() == "triangular_coons");
}

void require_dimension(const std::string& name, const Type& value) {
  if (value.is_scalar() || value.dimension <= 3) return;
  throw CannotDraw{
      "'" + name + "' lies in R^" + std::to_string(value.dimension) + ", which is not drawn",
      "figures are of R^1, R^2 and R^3"};
}

}  // namespace

Point Subject::at(const std::vector<Rational>& place) const {
  const Point value = function.value(place);
  if (!is_graph) return value;
  const std::vector<Rational> where = function.parameters(place);
  if (where.size() == 2) return {where[0], where[1], value[0]};
  return {where[0], value[0], 0};
}

Studio::Studio(const CaseResult& result, const std::vector<std::string>& names,
               Workspace& workspace)
    : case_{result.verified}, workspace_{workspace} {
  instance_ = names.empty() ? "" : split(names.front()).second;
  if (instance_.empty()) instance_ = first_instance(case_);
  facts_ = facts_of(result, instance_);
  if (names.size() == 1 && declaration(names.front()) == nullptr)
    for (const ClaimResult& claim : result.claims) {
      const auto [label, instance] = split(names.front());
      if (claim.claim.label != label || (!instance.empty() && claim.claim.instance != instance))
        continue;
      if (claim.decision.verdict != Verdict::refuted)
        throw CannotDraw{"claim '" + label + "' is not refuted: there is no deviation to be drawn"};
      if (compared(claim.claim, claim.decision.statement) == nullptr)
        throw CannotDraw{"claim '" + label + "' is no equation: there is no deviation to be drawn"};
      Claim only = claim.claim;
      auto& goal = std::get<IdentityClaim>(only.kind).goal;
      goal.statements = {goal.statements[claim.decision.statement]};
      compare(only);
      return;
    }
  std::vector<Term> terms;
  for (const std::string& name : names) {
    const Declaration* found = declaration(name);
    if (found == nullptr) {
      std::vector<std::string> known;
      for (const Declaration& d : case_.declarations)
        if (is_drawable(d)) known.push_back(d.name);
      throw CannotDraw{"there is nothing called '" + name + "' in case '" + case_.name + "'",
                       did_you_mean(split(name).first, known)};
    }
    if (!is_drawable(*found))
      throw CannotDraw{
          "'" + name + "' is a " + to_text(found->term.type()) + ", which is not drawn",
          "curves, patches and scalar functions of one or two parameters are"};
    require_dimension(name, *found->term.type().inner);
    terms.push_back(found->term);
  }
  prepare(terms);
  for (std::size_t k = 0; k < names.size(); ++k) subjects_.push_back(subject(names[k], terms[k]));
}

void Studio::compare(const Claim& claim) {
  const Statement& statement = *compared(claim, 0);
  const Type& type = statement.left.type();
  std::map<unsigned, SymbolPointer> found = free_symbols(statement.left);
  found.merge(free_symbols(statement.right));
  Formals parameters;
  for (const auto& [ordinal, symbol] : found)
    if (symbol->role == Symbol::Role::parameter) parameters.push_back(symbol);
  if (parameters.empty() || parameters.size() > 2 || type.is_matrix())
    throw CannotDraw{"claim '" + claim.label +
                     "' does not compare curves, patches or functions "
                     "of one or two parameters"};
  require_dimension(claim.label, type);
  is_comparison_ = true;
  prepare({statement.left, statement.right});
  subjects_ = {side("left", statement.left, parameters),
               side("right", statement.right, parameters)};
}

void Studio::prepare(const std::vector<Term>& terms) {
  // All definitions are looked at, so that a matrix gets the same values whatever is drawn.
  std::vector<Term> all = terms;
  for (const Term& term : terms)
    for (const auto& [ordinal, symbol] : free_symbols(term)) symbols_.insert(ordinal);
  for (const Declaration& d : case_.declarations)
    if (d.instance == instance_) all.push_back(d.term);
  std::optional<Example> example = example_of(all, facts_, workspace_);
  if (!example)
    throw CannotDraw{"no example was found that satisfies the assumptions of case '" + case_.name +
                     "'"};
  example_ = std::move(*example);
  for (const std::vector<KnownValue>& values : example_.values) {
    std::vector<KnownValue> known = facts_.derived;
    known.insert(known.end(), values.begin(), values.end());
    evaluators_.emplace_back(workspace_, known);
  }
}

const Declaration* Studio::declaration(const std::string& name) const {
  const auto [base, instance] = split(name);
  const std::string wanted = instance.empty() ? instance_ : instance;
  for (const Declaration& d : case_.declarations)
    if (d.name == base && (d.instance == wanted || d.instance.empty())) return &d;
  return nullptr;
}

std::vector<Fraction> Studio::coordinates(const Term& term) {
  const Type& type = term.type().is_function() ? *term.type().inner : term.type();
  if (!type.is_point() || type.dimension != Type::any_dimension)
    return evaluators_.front().value(term).components;
  std::vector<Fraction> result;
  for (Evaluator& evaluator : evaluators_)
    result.push_back(evaluator.value(term).components.front());
  return result;
}

ParameterInterval Studio::interval(const std::string& parameter, Variable own,
                                   const std::vector<Variable>& variables,
                                   const std::vector<std::string>& names) {
  for (const ParameterRange& range : facts_.ranges) {
    if (range.parameter->name != parameter) continue;
    // The ends may contain other parameters, which have other variables here.
    std::map<Variable, Fraction> images;
    for (std::size_t k = 0; k < variables.size(); ++k)
      for (const ParameterRange& other : facts_.ranges)
        if (other.parameter->name == names[k] && variables[k] != own)
          images.emplace(workspace_.atoms.symbol(other.parameter),
                         Fraction{Polynomial::variable(variables[k])});
    Substitution renamed{images, workspace_};
    return {renamed(evaluators_.front().value(range.lower).components.front()),
            renamed(evaluators_.front().value(range.upper).components.front())};
  }
  return {};
}

Subject Studio::subject(const std::string& name, const Term& term) {
  return made(name, term, evaluators_.front().formals(term), term.type().parameters,
              *term.type().inner);
}

Subject Studio::side(const std::string& name, const Term& term, const Formals& parameters) {
  std::vector<Variable> variables;
  std::vector<std::string> names;
  for (const SymbolPointer& parameter : parameters) {
    variables.push_back(workspace_.atoms.symbol(parameter));
    names.push_back(parameter->name);
  }
  return made(name, term, variables, names, term.type());
}

Subject Studio::made(const std::string& name, const Term& term,
                     const std::vector<Variable>& variables, const std::vector<std::string>& names,
                     const Type& value) {
  std::vector<ParameterInterval> ranges;
  for (std::size_t k = 0; k < variables.size(); ++k)
    ranges.push_back(interval(names[k], variables[k], variables, names));
  if (variables.size() == 2 && is_triangular(term))
    ranges[1].high = difference(Rational{1}, Polynomial::variable(variables[0]), workspace_.budget);
  const bool is_graph = value.is_scalar() || value.dimension == 1;
  return {name,
          names,
          SampledFunction{coordinates(term), variables, std::move(ranges), workspace_},
          is_graph,
          value.dimension == 2 || (is_graph && variables.size() == 1),
          net_of(term)};
}

Point Studio::point_of(const std::vector<Fraction>& coordinates) {
  Point result{};
  for (std::size_t k = 0; k < coordinates.size() && k < 3; ++k) {
    const std::optional<Rational> number = number_at(coordinates[k], {}, workspace_);
    if (!number) throw OutsideTheory{"a point has no value"};
    result[k] = *number;
  }
  return result;
}

std::optional<DrawnNet> Studio::net_of(const Term& term) {
  static const std::set<std::string, std::less<>> with_net{"bezier", "bezier_patch",
                                                           "bezier_curve"};
  switch (term.operation()) {
    case Operation::lambda:
      return net_of(term.child(0));
    case Operation::apply: {
      // Only where the arguments are the bare parameters.
      for (std::size_t k = 1; k < term.children().size(); ++k)
        if (term.child(k).operation() != Operation::symbol) return std::nullopt;
      return net_of(term.child(0));
    }
    case Operation::definition:
      break;
    default:
      return std::nullopt;
  }
  if (!with_net.contains(term.name()) || term.children().size() < 2) return std::nullopt;
  const Term& matrix = term.child(1);
  const Type& type = matrix.type();
  if (!type.is_matrix() || !type.inner->is_point()) return std::nullopt;
  DrawnNet net{static_cast<std::size_t>(type.rows), static_cast<std::size_t>(type.columns), {}};
  const auto width = type.inner->component_count();
  const bool any = type.inner->dimension == Type::any_dimension;
  for (std::size_t k = 0; k < net.rows * net.columns; ++k) {
    std::vector<Fraction> its;
    for (std::size_t c = 0; c < (any ? 3 : width); ++c)
      its.push_back(any ? evaluators_[c].value(matrix).components[k]
                        : evaluators_.front().value(matrix).components[k * width + c]);
    net.points.push_back(point_of(its));
  }
  return net;
}

std::vector<NamedPoint> Studio::named_points() {
  std::vector<NamedPoint> result;
  for (const Declaration& d : case_.declarations) {
    if (d.keyword != "point" || (d.instance != instance_ && !d.instance.empty())) continue;
    const std::vector<Term> entries =
        d.term.operation() == Operation::matrix ? d.term.children() : std::vector<Term>{d.term};
    for (const Term& entry : entries)
      if (entry.operation() == Operation::symbol && symbols_.contains(entry.symbol()->ordinal))
        result.push_back({entry.symbol()->name, point_of(coordinates(entry))});
  }
  return result;
}

std::vector<Subject> Studio::named_curves() {
  std::vector<Subject> result;
  for (const Declaration& d : case_.declarations)
    if (d.keyword == "curve" && is_drawable(d) && d.term.type().inner->is_point() &&
        (d.instance == instance_ || d.instance.empty()) && d.term.type().inner->dimension <= 3)
      try {
        result.push_back(subject(d.name, d.term));
      } catch (const OutsideTheory&) {
      } catch (const std::domain_error&) {
        // A curve without value that is not to be drawn has no label either.
      }
  return result;
}

std::vector<std::string> Studio::notes() const {
  std::vector<std::string> result;
  if (is_comparison_) result.emplace_back("left side: thin lines; right side: orange");
  std::string names;
  for (const std::string& name : example_.names) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) result.push_back("example values: " + names);
  return result;
}

}  // namespace patchproof
