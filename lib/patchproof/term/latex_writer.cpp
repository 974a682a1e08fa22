#include <patchproof/term/latex_writer.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// Tall texts need brackets that grow.
bool is_tall(const std::string& text) {
  return text.find("\\frac") != std::string::npos || text.find("pmatrix") != std::string::npos ||
         text.find("\\int") != std::string::npos;
}

std::string number_text(const Rational& number) {
  const Integer above = numerator(number);
  const Integer below = denominator(number);
  if (below == 1) return above.str();
  const Integer size = boost::multiprecision::abs(above);
  return std::string{above < 0 ? "-" : ""} + "\\tfrac{" + size.str() + "}{" + below.str() + "}";
}

}  // namespace

std::string latex_bracketed(const std::string& text) {
  return is_tall(text) ? "\\left(" + text + "\\right)" : "(" + text + ")";
}

std::string LatexWriter::of(const Term& term) {
  if (const std::string* name = name_of(term)) return latex_name(*name, names_.notation).text();
  return unnamed(term);
}

std::vector<std::string> LatexWriter::summands(const Term& function_or_value) {
  const Term& term = written(function_or_value);
  if (term.operation() != Operation::sum || name_of(term)) return {of(term)};
  std::vector<std::string> result;
  for (const Term& child : term.children()) {
    for (std::string& text : summands(child)) {
      const bool minus = text.front() == '-';
      if (!result.empty() && !minus && text.front() != '+') text = "+ " + text;
      if (!result.empty() && minus) text = "- " + text.substr(text.size() > 1 && text[1] == ' ' ? 2 : 1);
      result.push_back(std::move(text));
    }
  }
  return result;
}

bool LatexWriter::is_single(const Term& matrix) {
  return matrix.type().rows == 1 && matrix.type().columns == 1;
}

Binding LatexWriter::binding_of(const Term& term) const {
  if (name_of(term)) return Binding::primary;
  if (term.operation() == Operation::entry && is_single(term.child(0)))
    return binding_of(term.child(0));
  const Term& body = written(term);
  if (name_of(body)) return Binding::primary;
  if (body.operation() == Operation::apply && is_expression(body.child(0)))
    return binding_of(body.child(0).child(0));
  // As mathematics a quotient stands in a fraction, and scalar and vector products are infix.
  if (body.operation() == Operation::dot || body.operation() == Operation::cross)
    return Binding::product;
  if (body.operation() == Operation::integral) return Binding::product;
  if (body.operation() == Operation::tuple && body.children().size() == 1)
    return binding_of(body.child(0));
  return binding(term);
}

std::string LatexWriter::within(const Term& term, Binding least) {
  const std::string text = of(term);
  return binding_of(term) >= least ? text : latex_bracketed(text);
}

std::string LatexWriter::list(const std::vector<Term>& terms, std::size_t first) {
  std::string result;
  for (std::size_t k = first; k < terms.size(); ++k)
    result += (k > first ? ", " : "") + as_argument(terms[k]);
  return result;
}

std::string LatexWriter::as_argument(const Term& term) {
  if (term.operation() == Operation::lambda && !name_of(term)) {
    const Term& body = term.child(0);
    if (body.operation() == Operation::apply &&
        body.children().size() == term.formals().size() + 1) {
      bool same = true;
      for (std::size_t k = 0; k < term.formals().size(); ++k)
        same = same && body.child(k + 1).operation() == Operation::symbol &&
               body.child(k + 1).symbol()->ordinal == term.formals()[k]->ordinal;
      if (same) return of(body.child(0));
    }
  }
  return of(term);
}

std::string LatexWriter::unnamed(const Term& term) {
  switch (term.operation()) {
    case Operation::number: return number_text(term.number());
    case Operation::pi: return "\\pi";
    case Operation::symbol: {
      const auto other = renamed_.find(term.symbol()->ordinal);
      return other == renamed_.end() ? latex_name(term.symbol()->name, names_.notation).text()
                                     : other->second;
    }
    case Operation::tuple:
      return term.children().size() == 1 ? of(term.child(0)) : latex_bracketed(list(term.children()));
    case Operation::matrix: return matrix(term);
    case Operation::sum: return sum(term);
    case Operation::negation: return "-" + within(term.child(0), Binding::product);
    case Operation::product:
    case Operation::matrix_product: return product(term);
    case Operation::quotient: return quotient(term);
    case Operation::power:
      if (term.exponent() == 1) return of(term.child(0));
      if (const Term& base = term.child(0);
          term.exponent() > 1 && !name_of(base) &&
          (base.operation() == Operation::sine || base.operation() == Operation::cosine))
        return (base.operation() == Operation::sine ? "\\sin^{" : "\\cos^{") +
               std::to_string(term.exponent()) + "}" + elementary_argument(base.child(0));
      return latex_base(within(term.child(0), Binding::primary)) + "^{" +
             std::to_string(term.exponent()) + "}";
    case Operation::sine: return "\\sin" + elementary_argument(term.child(0));
    case Operation::cosine: return "\\cos" + elementary_argument(term.child(0));
    case Operation::exponential: return "e^{" + of(term.child(0)) + "}";
    case Operation::square_root: return "\\sqrt{" + of(term.child(0)) + "}";
    case Operation::lambda: return lambda(term);
    case Operation::apply: return apply(term);
    case Operation::derivative: return derivative(term);
    case Operation::component: return component(term);
    case Operation::entry:
      return is_single(term.child(0)) ? of(term.child(0)) : index(term.child(0), term.indices());
    case Operation::slice: return slice(term);
    case Operation::transpose: return latex_base(within(term.child(0), Binding::primary)) + "^{\\mathsf{T}}";
    case Operation::determinant: return determinant(term);
    case Operation::dot: return infix(term, "\\cdot");
    case Operation::cross: return infix(term, "\\times");
    case Operation::bernstein:
      return "B_{" + std::to_string(term.indices().at(1)) + "}^{" +
             std::to_string(term.indices().at(0)) + "}" + latex_bracketed(of(term.child(0)));
    case Operation::bspline_basis: return basis_function(term);
    case Operation::integral: return integral(term);
    case Operation::definition: return definition(term);
  }
  return "";
}

// A function is written as its value; where one of its parameters is called as something else in
// it, with the parameters.
std::string LatexWriter::lambda(const Term& term) {
  const std::map<unsigned, std::string> before = renamed_;
  const bool any = rename_formals(term);
  if (!any) {
    renamed_ = before;
    return of(term.child(0));
  }
  std::string parameters;
  for (const SymbolPointer& formal : term.formals())
    parameters += (parameters.empty() ? "" : ", ") + of(symbol_term(formal));
  const std::string text = "\\bigl(" + parameters + " \\mapsto " + of(term.child(0)) + "\\bigr)";
  renamed_ = before;
  return text;
}

std::string LatexWriter::sum(const Term& term) {
  std::string result;
  for (const std::string& text : summands(term)) result += (result.empty() ? "" : " ") + text;
  return result;
}

std::string LatexWriter::product(const Term& term) {
  std::vector<Factor> factors;
  collect_factors(term, factors);
  std::string result;
  bool after_number = false;
  for (const Factor& factor : factors) {
    // Nobody writes 1 or u^0 as a factor of something.
    if (factor.is_one && factors.size() > 1 && &factor != &factors.back()) continue;
    if (factor.is_one && !result.empty()) continue;
    if (result.empty())
      result = factor.text;
    else if (result == "-1" && !factor.is_number)
      result = "-" + factor.text;
    else if (factor.is_number || result == "0")
      result += " \\cdot " + factor.text;
    else
      result += (factor.text.front() == '(' || after_number ? "" : "\\,") + factor.text;
    after_number = factor.is_number && factor.text.back() != '}';
  }
  return result;
}

void LatexWriter::collect_factors(const Term& function_or_value, std::vector<Factor>& factors) {
  const Term& term = written(function_or_value);
  if (is_product(term) && !name_of(term)) {
    for (const Term& child : term.children()) collect_factors(child, factors);
    return;
  }
  const bool first = factors.empty();
  const bool fraction = term.operation() == Operation::quotient || term.is_number();
  const bool minus = binding_of(term) == Binding::sum;
  const bool bare = !name_of(term) && ((fraction && !minus) ||
                                       (first && minus && term.operation() != Operation::sum));
  const bool is_one = (term.is_number() && term.number() == 1) ||
                      (term.operation() == Operation::power && term.exponent() == 0);
  factors.push_back({bare ? of(term) : within(term, Binding::power), term.is_number(), is_one});
}

std::string LatexWriter::quotient(const Term& term) {
  const Term& above = written(term.child(0));
  if (!above.type().is_scalar() && above.operation() == Operation::sum)
    return "\\frac{1}{" + of(term.child(1)) + "}" + latex_bracketed(of(above));
  if (starts_with_minus(above) && above.operation() == Operation::negation && !name_of(above))
    return "-\\frac{" + of(above.child(0)) + "}{" + of(term.child(1)) + "}";
  return "\\frac{" + of(above) + "}{" + of(term.child(1)) + "}";
}

std::string LatexWriter::elementary_argument(const Term& argument) {
  // Always in brackets: a factor or a power behind it must not be taken for a part of it.
  return latex_bracketed(of(argument));
}

std::string LatexWriter::infix(const Term& term, const std::string& sign) {
  const auto side = [&](const Term& t) {
    const bool infix_too = t.operation() == Operation::dot || t.operation() == Operation::cross;
    return infix_too ? latex_bracketed(of(t)) : within(t, Binding::product);
  };
  return side(term.child(0)) + " " + sign + " " + side(term.child(1));
}

std::string latex_base(const std::string& text) {
  const bool has_superscript = text.find_first_of("^'") != std::string::npos;
  return has_superscript && text.back() != ')' ? latex_bracketed(text) : text;
}

std::string latex_subscript(const std::string& text, const std::string& index) {
  const bool has_subscript = text.find('_') != std::string::npos && text.back() != ')';
  return (has_subscript ? latex_bracketed(text) : text) + "_{" + index + "}";
}

}  // namespace patchproof
