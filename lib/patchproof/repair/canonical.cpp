#include <patchproof/repair/canonical.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace patchproof {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

/// Summands with their numerical factors; the one of numbers alone has the name "".
using Sum = std::map<std::string, Rational>;

void add(Sum& sum, const std::string& summand, const Rational& factor) {
  Rational& total = sum[summand];
  total += factor;
  if (total == 0) sum.erase(summand);
}

std::optional<Rational> as_number(const Sum& sum) {
  if (sum.empty()) return Rational{0};
  if (sum.size() == 1 && sum.begin()->first.empty()) return sum.begin()->second;
  return std::nullopt;
}

std::string to_text(const Sum& sum) {
  if (sum.empty()) return "0";
  std::string result;
  for (const auto& [summand, factor] : sum)
    result += (result.empty() ? "" : " + ") + patchproof::to_text(factor) +
              (summand.empty() ? "" : "*" + summand);
  return result;
}

class Canonical {
 public:
  explicit Canonical(const Names& names) : names_{names} {}

  Sum sum(const Expression& e) const {
    switch (e.kind) {
      case Kind::number:
        return number(e.number);
      case Kind::sum: {
        Sum result;
        for (std::size_t k = 0; k < e.operands.size(); ++k)
          add_all(result, sum(*e.operands[k]), e.signs[k] == '-' ? -1 : 1);
        return result;
      }
      case Kind::negation: {
        Sum result;
        add_all(result, sum(*e.operands.front()), -1);
        return result;
      }
      case Kind::product:
        return product(e);
      case Kind::power:
        return power(e);
      default:
        return {{leaf(e), Rational{1}}};
    }
  }

 private:
  static Sum number(const Rational& value) { return value == 0 ? Sum{} : Sum{{"", value}}; }

  static void add_all(Sum& result, const Sum& summands, int sign) {
    for (const auto& [summand, factor] : summands) add(result, summand, factor * sign);
  }

  // Products of matrices have an order; where there may be one, nothing is exchanged.
  bool may_be_matrix(const Expression& e) const {
    if (e.kind == Kind::number || e.kind == Kind::tuple || e.kind == Kind::component) return false;
    if (e.kind == Kind::matrix) return true;
    if (e.kind == Kind::name || e.kind == Kind::call) {
      const Expression& head = e.kind == Kind::call ? *e.operands.front() : e;
      const Type* type = head.kind == Kind::name ? names_.type(head.text) : nullptr;
      if (type == nullptr)
        return e.kind == Kind::call && head.kind == Kind::name && names_.may_make_matrix(head.text);
      return type->is_matrix() || (type->is_function() && type->inner->is_matrix());
    }
    if (e.kind == Kind::index)
      return std::any_of(e.arguments.begin(), e.arguments.end(),
                         [](const syntax::Argument& a) { return a.interval.has_value(); });
    return std::any_of(e.operands.begin(), e.operands.end(),
                       [&](const auto& operand) { return may_be_matrix(*operand); });
  }

  Sum product(const Expression& e) const {
    Rational factor = 1;
    std::map<std::string, int> powers;
    std::string ordered;
    const bool has_order = may_be_matrix(e);
    for (std::size_t k = 0; k < e.operands.size(); ++k) {
      const bool divides = e.signs[k] == '/';
      const Sum operand = sum(*e.operands[k]);
      if (operand.empty() && !divides) return {};
      std::string name = to_text(operand);
      Rational own = 0;
      if (operand.size() == 1) {
        name = operand.begin()->first;
        own = operand.begin()->second;
      }
      if (own != 0) factor *= divides ? Rational{1 / own} : own;
      if (own != 0 && name.empty()) continue;
      if (own == 0) name = "(" + name + ")";
      powers[name] += divides ? -1 : 1;
      ordered += (divides ? "/" : "*") + name;
    }
    if (has_order) return {{ordered, factor}};
    std::string text;
    for (const auto& [name, exponent] : powers)
      if (exponent != 0)
        text += (text.empty() ? "" : "*") + name +
                (exponent == 1 ? "" : "^" + std::to_string(exponent));
    return {{text, factor}};
  }

  Sum power(const Expression& e) const {
    const Sum base = sum(*e.operands[0]);
    const Sum exponent = sum(*e.operands[1]);
    const std::optional<Rational> n = as_number(exponent);
    if (n && *n == 0) return number(1);
    if (n && *n == 1) return base;
    return {{"(" + to_text(base) + ")^(" + to_text(exponent) + ")", Rational{1}}};
  }

  std::string leaf(const Expression& e) const {
    switch (e.kind) {
      case Kind::name:
        return e.text;
      case Kind::hole:
        return "?";
      case Kind::component:
        return "(" + to_text(sum(*e.operands.front())) + ")." + e.text;
      case Kind::tuple: {
        std::string text;
        for (const auto& operand : e.operands)
          text += (text.empty() ? "(" : ", ") + to_text(sum(*operand));
        return text + ")";
      }
      case Kind::matrix: {
        std::string text = "[";
        for (const auto& row : e.rows) {
          for (const auto& entry : row) text += to_text(sum(*entry)) + ", ";
          text += "; ";
        }
        return text + "]";
      }
      default:
        return applied(e);
    }
  }

  std::string applied(const Expression& e) const {
    std::string text = to_text(sum(*e.operands.front()));
    text += e.kind == Kind::call ? "(" : "[";
    for (const syntax::Argument& a : e.arguments) {
      if (a.value) text += to_text(sum(*a.value));
      if (a.binder) text += a.binder->name.text + " in ";
      const auto* interval = a.binder ? &a.binder->interval : a.interval ? &*a.interval : nullptr;
      if (interval != nullptr)
        text += to_text(sum(*interval->first)) + ".." + to_text(sum(*interval->last));
      if (a.range)
        text += a.range->name.text + " in [" + to_text(sum(*a.range->range.lower)) + ", " +
                to_text(sum(*a.range->range.upper)) + "]";
      text += ", ";
    }
    return text + (e.kind == Kind::call ? ")" : "]");
  }

  const Names& names_;
};

}  // namespace

std::string canonical(const syntax::Comparison& comparison, const Names& names) {
  const Canonical forms{names};
  std::string result;
  for (std::size_t k = 0; k < comparison.operands.size(); ++k)
    result += to_text(forms.sum(*comparison.operands[k])) +
              (k < comparison.operators.size() ? " " + comparison.operators[k] + " " : "");
  return result + (comparison.on_boundary ? " on boundary" : "");
}

bool is_trivial(const syntax::Comparison& comparison, const Names& names) {
  const Canonical forms{names};
  for (std::size_t k = 0; k + 1 < comparison.operands.size(); ++k) {
    const Sum left = forms.sum(*comparison.operands[k]);
    const Sum right = forms.sum(*comparison.operands[k + 1]);
    if (as_number(left) && as_number(right)) return true;
    Sum difference = left;
    for (const auto& [summand, factor] : right) add(difference, summand, -factor);
    if (difference.empty()) return true;
  }
  return false;
}

}  // namespace patchproof
