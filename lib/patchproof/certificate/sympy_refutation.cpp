#include <map>

#include <patchproof/certificate/python_lines.hpp>
#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/sequents.hpp>
#include <patchproof/certificate/sympy_proof.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

const std::string margin = "    ";

class RefutationWriter {
 public:
  RefutationWriter(const Refutation& refutation, Scalars& scalars, PythonText& text)
      : refutation_{refutation}, scalars_{scalars}, text_{text} {
    for (const KnownValue& value : refutation.values) images_.emplace(value.symbol->ordinal, value);
  }

  std::string written() {
    const Sequent& sequent = refutation_.sequent;
    std::map<unsigned, SymbolPointer> needed;
    for (const Assumption& hypothesis : sequent.hypotheses) note(hypothesis.statement, needed);
    for (const Statement& conclusion : sequent.conclusions) note(conclusion, needed);
    std::string symbols;
    std::string parameters;
    for (const auto& [ordinal, symbol] : needed) {
      const bool is_parameter = symbol->role == Symbol::Role::parameter;
      (is_parameter ? parameters : symbols) += entries(symbol);
    }
    result_ = margin + "values = {" + symbols + (symbols.empty() ? "}\n" : "\n" + margin + "}\n");
    if (!parameters.empty()) {
      result_ += margin + "place = {" + parameters + "\n" + margin + "}\n";
      result_ += margin + "everything = {**values, **place}\n";
      everything_ = "everything";
    }
    for (const ParameterRange& range : sequent.ranges) add_range(range);
    for (const Assumption& hypothesis : sequent.hypotheses) add_hypothesis(hypothesis);
    add_conclusion();
    return result_;
  }

 private:
  using Components = std::vector<ScalarPointer>;

  static void note(const Statement& s, std::map<unsigned, SymbolPointer>& needed) {
    needed.merge(free_symbols(s.left));
    needed.merge(free_symbols(s.right));
  }

  // Parameters that stand in equations among the hypotheses alone have no value.
  std::string entries(const SymbolPointer& symbol) {
    const auto image = images_.find(symbol->ordinal);
    if (image == images_.end()) {
      if (symbol->role == Symbol::Role::parameter) return "";
      throw NotScalar{"a symbol without a value in the witness"};
    }
    const Term& value = image->second.value;
    const std::size_t count = symbol->type.component_count();
    std::string result;
    for (std::size_t c = 0; c < count; ++c) {
      const auto component = [&](const auto& all) { return text_.of(all.at(c < all.size() ? c : 0)); };
      const std::string text = symbol->type.is_function() ? component(scalars_.functions_of(value))
                                                          : component(scalars_.of(value));
      result += "\n" + margin + margin + text_.of(scalar_variable({symbol, c})) + ": " + text + ",";
    }
    return result;
  }

  void check(const std::string& what) { result_ += margin + "yield " + what + "\n"; }
  void remark(const std::string& text) { result_ += python_comment(text, margin); }

  static std::string at(const std::string& text, const std::string& values) {
    return "at(" + text + ", " + values + ")";
  }

  std::string difference(const Statement& s, std::size_t component, bool turned = false) {
    const ScalarPointer left = scalars_.of(s.left).at(component);
    const ScalarPointer right = scalars_.of(s.right).at(component);
    return turned ? text_.of(scalar_pair(Scalar::Kind::difference, right, left))
                  : text_.of(scalar_pair(Scalar::Kind::difference, left, right));
  }

  void add_range(const ParameterRange& range) {
    if (!images_.contains(range.parameter->ordinal)) return;
    const ScalarPointer parameter = scalar_variable({range.parameter, 0});
    const auto part = [&](const ScalarPointer& a, const ScalarPointer& b) {
      return at(text_.of(scalar_pair(Scalar::Kind::difference, a, b)), everything_);
    };
    remark("the place is in the range:");
    check("is_not_negative(" + part(parameter, scalars_.of(range.lower).front()) + ")");
    check("is_not_negative(" + part(scalars_.of(range.upper).front(), parameter) + ")");
  }

  void add_hypothesis(const Assumption& hypothesis) {
    const Statement& s = hypothesis.statement;
    remark("assumed" + (hypothesis.label.empty() ? "" : ", " + hypothesis.label) + ":");
    if (s.relation == Relation::equal) {
      for (std::size_t c = 0; c < component_count(s); ++c)
        check("is_zero(" + at(difference(s, c), "values") + ")");
      return;
    }
    if (s.relation == Relation::not_equal) {
      std::string any;
      for (std::size_t c = 0; c < component_count(s); ++c)
        any += std::string{c == 0 ? "" : " or "} + "differs(" + at(difference(s, c), everything_) + ")";
      return check(any);
    }
    const bool turned = s.relation == Relation::less || s.relation == Relation::less_equal;
    const bool strict = s.relation == Relation::less || s.relation == Relation::greater;
    check((strict ? "is_positive(" : "is_not_negative(") + at(difference(s, 0, turned), everything_) +
          ")");
  }

  void add_conclusion() {
    const Statement& s = refutation_.sequent.conclusions.at(refutation_.conclusion);
    const std::size_t c = refutation_.component;
    remark("and yet not what is claimed:");
    switch (s.relation) {
      case Relation::equal: return check("differs(" + at(difference(s, c), everything_) + ")");
      case Relation::not_equal:
        for (std::size_t k = 0; k < component_count(s); ++k)
          check("is_zero(" + at(difference(s, k), everything_) + ")");
        return;
      case Relation::less:
        return check("is_not_negative(" + at(difference(s, c), everything_) + ")");
      case Relation::less_equal:
        return check("is_positive(" + at(difference(s, c), everything_) + ")");
      case Relation::greater:
        return check("is_not_negative(" + at(difference(s, c, true), everything_) + ")");
      default: return check("is_positive(" + at(difference(s, c, true), everything_) + ")");
    }
  }

  const Refutation& refutation_;
  Scalars& scalars_;
  PythonText& text_;
  std::map<unsigned, KnownValue> images_;
  /// The name of the values of symbols and parameters together.
  std::string everything_ = "values";
  std::string result_;
};

}  // namespace

std::string sympy_refutation(const Refutation& refutation, Scalars& scalars, PythonText& text) {
  return RefutationWriter{refutation, scalars, text}.written();
}

}  // namespace patchproof
