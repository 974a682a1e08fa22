#include <patchproof/certificate/rocq_proof.hpp>
#include <patchproof/certificate/scalar_obstacle.hpp>
#include <patchproof/certificate/sequents.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

constexpr const char* computed = "vm_cast_no_check (eq_refl true)";

class RefutationWriter {
 public:
  RefutationWriter(const Refutation& refutation, RocqSequent& sequent, Scalars& scalars,
                   RocqNames& names, RocqText& text)
      : refutation_{refutation}, sequent_{sequent}, scalars_{scalars}, names_{names}, text_{text} {
    for (const KnownValue& value : refutation.values)
      images_.emplace(value.symbol->ordinal, value.value);
  }

  std::string written() {
    std::string result = "  intro HypFalse.\n";
    result += specialized(sequent_.symbols());
    for (const SymbolPointer& symbol : sequent_.symbols())
      if (sequent_.is_differentiated(symbol)) result += smooth_premises(symbol);
    const Sequent& sequent = sequent_.sequent();
    for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k)
      if (!sequent_.is_restriction(k)) result += premise(hypothesis_script(k));
    result += specialized(sequent_.parameters());
    for (const ParameterRange& range : sequent.ranges)
      if (!sequent_.range_name(range.parameter).empty()) result += premise(range_script(range));
    for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k)
      if (sequent_.is_restriction(k)) result += premise(hypothesis_script(k));
    return result + "  " + conclusion_script();
  }

 private:
  static std::string premise(const std::string& script) {
    return "  premise HypFalse. { " + script + " }\n";
  }

  // The values of the witness, one for each variable that is quantified.
  std::string specialized(const std::vector<SymbolPointer>& symbols) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<SymbolPointer>> entries;
    for (const SymbolPointer& symbol : symbols) {
      const std::string& name = names_.variable(symbol).name;
      if (entries[name].empty()) order.push_back(name);
      entries[name].push_back(symbol);
    }
    std::string result;
    for (const std::string& name : order) result += "\n    " + values(entries[name]);
    return result.empty() ? "" : "  specialize (HypFalse" + result + ").\n";
  }

  std::string value(const SymbolPointer& symbol, std::size_t component) {
    const auto image = images_.find(symbol->ordinal);
    if (image == images_.end()) throw NotScalar{"a symbol without a value in the witness"};
    if (symbol->type.is_function()) {
      const auto& functions = scalars_.functions_of(image->second);
      return text_.of(functions.at(component < functions.size() ? component : 0));
    }
    const auto& components = scalars_.of(image->second);
    return "(" + text_.of(components.at(component < components.size() ? component : 0)) + ")";
  }

  // An array as a function of its indices, 0 where it has no entry.
  std::string values(const std::vector<SymbolPointer>& symbols) {
    const RocqVariable& variable = names_.variable(symbols.front());
    if (variable.indices == 0) return value(symbols.front(), 0);
    std::string heads;
    std::string scrutinees;
    std::string otherwise;
    for (std::size_t k = 0; k < variable.indices; ++k) {
      const std::string name = "i" + std::to_string(k + 1);
      heads += " " + name;
      scrutinees += (k == 0 ? "" : ", ") + name;
      otherwise += k == 0 ? "_" : ", _";
    }
    std::string cases;
    for (const SymbolPointer& symbol : symbols) {
      const std::vector<unsigned>& indices = names_.indices(symbol);
      const bool coordinates = variable.indices > indices.size();
      for (std::size_t c = 0; c < symbol->type.component_count(); ++c) {
        std::string pattern;
        for (const unsigned index : indices)
          pattern += (pattern.empty() ? "" : ", ") + std::to_string(index) + "%nat";
        if (coordinates) pattern += (pattern.empty() ? "" : ", ") + std::to_string(c) + "%nat";
        cases += " | " + pattern + " => " + value(symbol, c);
      }
    }
    std::string zero = "0";
    for (std::size_t k = 0; k < variable.arity; ++k) zero = "(fun _ => " + zero + ")";
    return "(fun" + heads + " : nat => match " + scrutinees + " with" + cases + " | " + otherwise +
           " => " + zero + " end)";
  }

  std::string smooth_premises(const SymbolPointer& symbol) {
    const auto image = images_.find(symbol->ordinal);
    if (image == images_.end()) throw NotScalar{"a symbol without a value in the witness"};
    std::string result;
    for (const ScalarFunctionPointer& function : scalars_.functions_of(image->second)) {
      if (function->kind != ScalarFunction::Kind::lambda)
        throw NotScalar{"a witness that is no polynomial"};
      RocqTwin twin;
      for (const SymbolPointer& formal : function->formals) {
        Scalar variable;
        variable.kind = Scalar::Kind::variable;
        variable.coordinate = {formal, 0};
        twin.of(std::make_shared<const Scalar>(variable));
      }
      const std::size_t arity = function->formals.size();
      result += premise("refine (polynomial_smooth" + (arity == 1 ? "" : std::to_string(arity)) +
                        " [] [] 0 eq_refl " + std::to_string(sequent_.smoothness(symbol)) + " " +
                        twin.of(function->body) + " _). " + computed + ".");
    }
    return result;
  }

  std::pair<ScalarPointer, ScalarPointer> sides(const Statement& statement, std::size_t component) {
    return {scalars_.of(replaced(statement.left, images_)).at(component),
            scalars_.of(replaced(statement.right, images_)).at(component)};
  }

  // Script that compares two numbers.
  static std::string comparison(const char* theorem, const ScalarPointer& a, const ScalarPointer& b) {
    if (has_root(a) || has_root(b)) throw NotScalar{"a square root in a counterexample"};
    RocqTwin twin;
    const std::string left = twin.of(a);
    const std::string right = twin.of(b);
    return std::string{"exact ("} + theorem + " [] [] [] 0 I eq_refl\n    " + left + "\n    " + right +
           "\n    ltac:(" + computed + "))";
  }

  static std::string equality(const ScalarPointer& a, const ScalarPointer& b,
                              const std::vector<SymbolPointer>& parameters,
                              const std::vector<std::string>& names) {
    RocqTwin twin;
    for (const SymbolPointer& parameter : parameters) {
      Scalar variable;
      variable.kind = Scalar::Kind::variable;
      variable.coordinate = {parameter, 0};
      twin.of(std::make_shared<const Scalar>(variable));
    }
    const std::string left = twin.of(a);
    const std::string right = twin.of(b);
    std::string sigma;
    for (const std::string& name : names) sigma += (sigma.empty() ? "" : "; ") + name;
    return "exact (equation [] [" + sigma + "] [] " + std::to_string(names.size()) +
           " [] [] [] []\n    " + left + "\n    " + right + "\n    I eq_refl I I ltac:(" + computed +
           "))";
  }

  std::string range_script(const ParameterRange& range) {
    const ScalarPointer parameter =
        scalars_.of(replaced(symbol_term(range.parameter), images_)).front();
    const auto end = [&](const Term& term) { return scalars_.of(replaced(term, images_)).front(); };
    return "apply both_ends. { " + comparison("at_most", end(range.lower), parameter) + ". } " +
           comparison("at_most", parameter, end(range.upper)) + ".";
  }

  std::string hypothesis_script(std::size_t index) {
    const Statement& statement = sequent_.sequent().hypotheses[index].statement;
    std::string result;
    std::map<unsigned, Term> all = images_;
    std::vector<SymbolPointer> parameters;
    std::vector<std::string> names;
    if (statement.relation == Relation::equal && !parameters_of(statement).empty()) {
      parameters = parameters_of(statement);
      for (const SymbolPointer& parameter : parameters) {
        images_.erase(parameter->ordinal);
        names.push_back(names_.variable(parameter).name);
      }
      result = "intros";
      for (const std::string& name : names) result += " " + name;
      for (const SymbolPointer& parameter : parameters)
        for (const ParameterRange& range : sequent_.sequent().ranges)
          if (range.parameter->ordinal == parameter->ordinal) result += " ?";
      for (std::size_t k = 0; k < sequent_.guards_of(index).size(); ++k) result += " ?";
      result += ". ";
    }
    const std::size_t count = component_count(statement);
    for (std::size_t c = 0; c < count; ++c) {
      const auto [left, right] = sides(statement, c);
      if (c + 1 < count && statement.relation == Relation::equal) result += "split. { ";
      result += holds(statement.relation, left, right, parameters, names, c, count);
      if (statement.relation != Relation::equal) break;
      if (c + 1 < count) result += " } ";
    }
    images_ = std::move(all);
    return result;
  }

  std::string holds(Relation relation, const ScalarPointer& left, const ScalarPointer& right,
                    const std::vector<SymbolPointer>& parameters,
                    const std::vector<std::string>& names, std::size_t component,
                    std::size_t count) {
    switch (relation) {
      case Relation::equal: return equality(left, right, parameters, names) + ".";
      case Relation::not_equal:
        if (count > 1 || component > 0) throw NotScalar{"an inequality between points that is assumed"};
        return comparison("different", left, right) + ".";
      case Relation::less: return comparison("less", left, right) + ".";
      case Relation::less_equal: return comparison("at_most", left, right) + ".";
      case Relation::greater: return "apply Rlt_gt. " + comparison("less", right, left) + ".";
      default: return "apply Rle_ge. " + comparison("at_most", right, left) + ".";
    }
  }

  // a <> b \/ c <> d fails where all components are equal.
  std::string none_differs(const Statement& statement, const std::string& part) {
    std::string result = "pose proof " + part + " as HypPart.";
    const std::size_t components = component_count(statement);
    for (std::size_t c = 0; c < components; ++c) {
      const auto [left, right] = sides(statement, c);
      const std::string script = "apply HypPart. " + equality(left, right, {}, {}) + ".";
      result += c + 1 < components
                    ? "\n  destruct HypPart as [HypPart|HypPart]. { " + script + " }"
                    : "\n  " + script;
    }
    return result;
  }

  std::string conclusion_script() {
    std::size_t before = 0;
    std::size_t count = 0;
    const Sequent& sequent = sequent_.sequent();
    for (std::size_t k = 0; k < sequent.conclusions.size(); ++k) {
      const bool one = sequent.conclusions[k].relation == Relation::not_equal;
      const std::size_t own = one ? 1 : component_count(sequent.conclusions[k]);
      if (k < refutation_.conclusion) before += own;
      count += own;
    }
    const Statement& statement = sequent.conclusions[refutation_.conclusion];
    const auto [left, right] = sides(statement, refutation_.component);
    const bool one = statement.relation == Relation::not_equal;
    const std::string part =
        rocq_part("HypFalse", before + (one ? 0 : refutation_.component), count);
    const std::string set = "pose proof " + part + " as HypPart. clear HypFalse. revert HypPart.\n  ";
    switch (statement.relation) {
      case Relation::equal: return set + comparison("different", left, right) + ".";
      case Relation::not_equal: return none_differs(statement, part);
      case Relation::less: return set + "apply not_less. " + comparison("at_most", right, left) + ".";
      case Relation::less_equal:
        return set + "apply not_at_most. " + comparison("less", right, left) + ".";
      case Relation::greater:
        return set + "apply not_greater. " + comparison("at_most", left, right) + ".";
      default: return set + "apply not_at_least. " + comparison("less", left, right) + ".";
    }
  }

  const Refutation& refutation_;
  RocqSequent& sequent_;
  Scalars& scalars_;
  RocqNames& names_;
  RocqText& text_;
  std::map<unsigned, Term> images_;
};

}  // namespace

std::string rocq_refutation(const Refutation& refutation, RocqSequent& sequent, Scalars& scalars,
                            RocqNames& names, RocqText& text) {
  return RefutationWriter{refutation, sequent, scalars, names, text}.written();
}

}  // namespace patchproof
