#include <patchproof/term/latex_text.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

#include <patchproof/term/binding.hpp>
#include <patchproof/term/latex_name.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// Tall texts need brackets that grow.
bool is_tall(const std::string& text) {
  return text.find("\\frac") != std::string::npos || text.find("pmatrix") != std::string::npos ||
         text.find("\\int") != std::string::npos;
}

std::string bracketed(const std::string& text) {
  return is_tall(text) ? "\\left(" + text + "\\right)" : "(" + text + ")";
}

std::string number_text(const Rational& number) {
  const Integer above = boost::multiprecision::numerator(number);
  const Integer below = boost::multiprecision::denominator(number);
  if (below == 1) return above.str();
  const Integer size = boost::multiprecision::abs(above);
  return std::string{above < 0 ? "-" : ""} + "\\tfrac{" + size.str() + "}{" + below.str() + "}";
}

class Writer {
 public:
  explicit Writer(const LatexNames& names) : names_{names} {}

  std::string of(const Term& term) {
    if (const std::string* name = name_of(term)) return latex_name(*name, names_.notation).text();
    return unnamed(term);
  }

  std::vector<std::string> summands(const Term& function_or_value) {
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

 private:
  const std::string* name_of(const Term& term) const { return names_.name_of(term); }

  bool is_name(const Term& term) const { return name_of(term) || has_plain_name(term); }

  // A product of matrices that is one value, of which the entry is taken.
  static bool is_single(const Term& matrix) {
    return matrix.type().rows == 1 && matrix.type().columns == 1;
  }

  Binding binding_of(const Term& term) const {
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

  std::string within(const Term& term, Binding least) {
    const std::string text = of(term);
    return binding_of(term) >= least ? text : bracketed(text);
  }

  std::string list(const std::vector<Term>& terms, std::size_t first = 0) {
    std::string result;
    for (std::size_t k = first; k < terms.size(); ++k)
      result += (k > first ? ", " : "") + as_argument(terms[k]);
    return result;
  }

  // A function that only applies another one to its own parameters is that function.
  std::string as_argument(const Term& term) {
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

  std::string unnamed(const Term& term) {
    switch (term.operation()) {
      case Operation::number: return number_text(term.number());
      case Operation::pi: return "\\pi";
      case Operation::symbol: return latex_name(term.symbol()->name, names_.notation).text();
      case Operation::tuple:
        return term.children().size() == 1 ? of(term.child(0)) : bracketed(list(term.children()));
      case Operation::matrix: return matrix(term);
      case Operation::sum: return sum(term);
      case Operation::negation: return "-" + within(term.child(0), Binding::product);
      case Operation::product:
      case Operation::matrix_product: return product(term);
      case Operation::quotient: return quotient(term);
      case Operation::power:
        return within(term.child(0), Binding::primary) + "^{" + std::to_string(term.exponent()) + "}";
      case Operation::sine: return "\\sin" + elementary_argument(term.child(0));
      case Operation::cosine: return "\\cos" + elementary_argument(term.child(0));
      case Operation::exponential: return "e^{" + of(term.child(0)) + "}";
      case Operation::square_root: return "\\sqrt{" + of(term.child(0)) + "}";
      case Operation::lambda: return of(term.child(0));
      case Operation::apply: return apply(term);
      case Operation::derivative: return derivative(term);
      case Operation::component: return component(term);
      case Operation::entry:
        return is_single(term.child(0)) ? of(term.child(0)) : index(term.child(0), term.indices());
      case Operation::slice: return slice(term);
      case Operation::transpose: return within(term.child(0), Binding::primary) + "^{\\mathsf{T}}";
      case Operation::determinant: return determinant(term);
      case Operation::dot: return infix(term, "\\cdot");
      case Operation::cross: return infix(term, "\\times");
      case Operation::bernstein:
        return "B_{" + std::to_string(term.indices().at(1)) + "}^{" +
               std::to_string(term.indices().at(0)) + "}" + bracketed(of(term.child(0)));
      case Operation::bspline_basis: return basis_function(term);
      case Operation::integral: return integral(term);
      case Operation::definition: return definition(term);
    }
    return "";
  }

  std::string sum(const Term& term) {
    std::string result;
    for (const std::string& text : summands(term)) result += (result.empty() ? "" : " ") + text;
    return result;
  }

  // Juxtaposition; a dot where two digits or two matrices would meet.
  std::string product(const Term& term) {
    std::vector<std::string> factors;
    collect_factors(term, factors);
    std::string result;
    for (const std::string& factor : factors) {
      if (result.empty()) {
        result = factor;
        continue;
      }
      const bool digit = factor.front() >= '0' && factor.front() <= '9';
      const bool fraction_after = factor.rfind("\\tfrac", 0) == 0 || factor.rfind("\\frac", 0) == 0;
      const char last = result.back();
      const bool after_number = (last >= '0' && last <= '9');
      if (result == "-1" && !digit)
        result = "-" + factor;
      else if (digit || (fraction_after && after_number) || result == "0" || result == "1")
        result += " \\cdot " + factor;
      else
        result += (factor.front() == '(' || after_number ? "" : "\\,") + factor;
    }
    return result;
  }

  void collect_factors(const Term& function_or_value, std::vector<std::string>& factors) {
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
    factors.push_back(bare ? of(term) : within(term, Binding::power));
  }

  std::string quotient(const Term& term) {
    const Term& above = written(term.child(0));
    if (!above.type().is_scalar() && above.operation() == Operation::sum)
      return "\\frac{1}{" + of(term.child(1)) + "}" + bracketed(of(above));
    if (starts_with_minus(above) && above.operation() == Operation::negation && !name_of(above))
      return "-\\frac{" + of(above.child(0)) + "}{" + of(term.child(1)) + "}";
    return "\\frac{" + of(above) + "}{" + of(term.child(1)) + "}";
  }

  std::string elementary_argument(const Term& argument) {
    const std::string text = of(argument);
    return is_name(argument) || argument.operation() == Operation::pi ? " " + text
                                                                      : bracketed(text);
  }

  std::string infix(const Term& term, const std::string& sign) {
    const auto side = [&](const Term& t) {
      const bool infix_too = t.operation() == Operation::dot || t.operation() == Operation::cross;
      return infix_too ? bracketed(of(t)) : within(t, Binding::product);
    };
    return side(term.child(0)) + " " + sign + " " + side(term.child(1));
  }

  bool is_expression(const Term& function) const {
    return function.operation() == Operation::lambda && !name_of(function);
  }

  // An expression at values of its parameters: with these in their places.
  static Term at_arguments(const Term& term) {
    const Term& function = term.child(0);
    std::map<unsigned, Term> images;
    for (std::size_t k = 0; k < function.formals().size(); ++k)
      images.emplace(function.formals()[k]->ordinal, term.child(k + 1));
    return replaced(function.child(0), images);
  }

  std::string apply(const Term& term) {
    const Term& function = term.child(0);
    if (is_expression(function)) return of(at_arguments(term));
    return of(function) + bracketed(list(term.children(), 1));
  }

  std::string derivative(const Term& term) {
    const Term* base = &term;
    Indices orders(term.indices().size(), 0);
    for (; base->operation() == Operation::derivative && !name_of(*base); base = &base->child(0))
      for (std::size_t i = 0; i < orders.size(); ++i) orders[i] += base->indices().at(i);
    const std::vector<std::string>& parameters = base->type().parameters;
    const int total = std::accumulate(orders.begin(), orders.end(), 0);
    if (total == 0) return of(*base);
    if (names_.notation.derivatives == DerivativeStyle::fraction)
      return derivative_fraction(*base, orders, total);
    const std::optional<LatexName> name = symbol_name(*base);
    const std::string plain = name ? name->text() : bracketed(of(*base));
    if (orders.size() == 1) {
      if (total <= 3) return plain + std::string(static_cast<std::size_t>(total), '\'');
      return plain + "^{(" + std::to_string(total) + ")}";
    }
    std::string letters;
    for (std::size_t i = 0; i < orders.size(); ++i)
      for (int k = 0; k < orders[i]; ++k) letters += parameters.at(i);
    if (names_.notation.derivatives == DerivativeStyle::superscript)
      return plain + "^{" + letters + "}";
    if (name && !name->index.empty()) return "(" + plain + ")_{" + letters + "}";
    return plain + "_{" + letters + "}";
  }

  std::string derivative_fraction(const Term& base, const Indices& orders, int total) {
    const std::string power = total > 1 ? "^{" + std::to_string(total) + "}" : "";
    const char* d = orders.size() == 1 ? "\\mathrm{d}" : "\\partial";
    std::string below;
    for (std::size_t i = 0; i < orders.size(); ++i) {
      if (orders[i] == 0) continue;
      below += (below.empty() ? "" : "\\,") + std::string{d} + " " + base.type().parameters.at(i);
      if (orders[i] > 1) below += "^{" + std::to_string(orders[i]) + "}";
    }
    return "\\frac{" + std::string{d} + power + " " + within(base, Binding::primary) + "}{" + below + "}";
  }

  std::optional<LatexName> symbol_name(const Term& term) const {
    if (const std::string* name = name_of(term)) return latex_name(*name, names_.notation);
    if (term.operation() == Operation::symbol)
      return latex_name(term.symbol()->name, names_.notation);
    if (has_plain_name(term)) return latex_name(term.name(), names_.notation);
    return std::nullopt;
  }

  std::string component(const Term& term) {
    const int k = term.indices().at(0);
    const std::string letter = k < 3 ? std::string(1, "xyz"[k]) : std::to_string(k + 1);
    const Term& point = term.child(0);
    if (symbol_name(point)) {
      LatexName name = *symbol_name(point);
      name.index += (name.index.empty() ? "" : ",") + letter;
      return name.text();
    }
    return "[" + of(point) + "]_{" + letter + "}";
  }

  std::string index(const Term& matrix, const Indices& indices) {
    std::string text;
    const bool single = std::all_of(indices.begin(), indices.end(), [](int i) { return i < 10; });
    for (const int i : indices) text += (text.empty() || single ? "" : ",") + std::to_string(i);
    if (const std::optional<LatexName> name = symbol_name(matrix)) {
      LatexName entry = *name;
      entry.index += (entry.index.empty() ? "" : ",") + text;
      return entry.text();
    }
    return within(matrix, Binding::primary) + "_{" + text + "}";
  }

  std::string slice(const Term& term) {
    const Indices& i = term.indices();
    return within(term.child(0), Binding::primary) + "_{" + std::to_string(i.at(0)) + "..." +
           std::to_string(i.at(1)) + ",\\," + std::to_string(i.at(2)) + "..." +
           std::to_string(i.at(3)) + "}";
  }

  // The array V[0..3, 0..3] as a whole is V.
  std::optional<std::string> array_name(const Term& matrix) const {
    std::string base;
    const std::size_t columns = static_cast<std::size_t>(std::max(matrix.type().columns, 1));
    for (std::size_t k = 0; k < matrix.children().size(); ++k) {
      const Term& entry = matrix.child(k);
      if (entry.operation() != Operation::symbol) return std::nullopt;
      const std::string& name = entry.symbol()->name;
      const std::size_t bracket = name.find('[');
      if (bracket == std::string::npos || (k > 0 && name.substr(0, bracket) != base))
        return std::nullopt;
      base = name.substr(0, bracket);
      const std::string expected =
          matrix.type().list
              ? "[" + std::to_string(k) + "]"
              : "[" + std::to_string(k / columns) + "," + std::to_string(k % columns) + "]";
      if (name.substr(bracket) != expected) return std::nullopt;
    }
    return base;
  }

  std::string matrix(const Term& term) {
    if (const auto name = array_name(term); name && !inside_matrix_)
      return latex_name(*name, names_.notation).text();
    const std::size_t columns = static_cast<std::size_t>(std::max(term.type().columns, 1));
    std::string result = "\\begin{pmatrix} ";
    for (std::size_t k = 0; k < term.children().size(); ++k) {
      if (k > 0) result += k % columns == 0 ? " \\\\ " : " & ";
      result += of(term.child(k));
    }
    return result + " \\end{pmatrix}";
  }

  std::string determinant(const Term& term) {
    const Term& matrix_term = term.child(0);
    if (matrix_term.operation() != Operation::matrix || name_of(matrix_term))
      return "\\det" + bracketed(of(matrix_term));
    std::string text = matrix(matrix_term);
    for (std::size_t at = text.find("pmatrix"); at != std::string::npos; at = text.find("pmatrix", at))
      text.replace(at, 7, "vmatrix");
    return text;
  }

  std::string basis_function(const Term& term) {
    const BasisFunction& basis = term.basis_function();
    return "N_{" + std::to_string(basis.index) + "," + std::to_string(basis.degree) + "}^{[" +
           std::to_string(basis.span) + "]}" + bracketed(of(term.child(0)));
  }

  std::string integral(const Term& term) {
    const std::vector<std::string>& parameters = term.child(0).type().parameters;
    std::string signs;
    std::string differentials;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const std::string sign = "\\int_{" + of(term.child(2 * k + 1)) + "}^{" +
                               of(term.child(2 * k + 2)) + "}";
      signs = sign + (signs.empty() ? "" : "\\!") + signs;
      differentials += "\\,\\mathrm{d}" + parameters[k];
    }
    return signs + " " + within(term.child(0), Binding::product) + differentials;
  }

  std::string definition(const Term& term) {
    const bool plain = has_plain_name(term);
    const auto own = names_.notation.names.find(term.name());
    std::string name;
    // H03 is a letter with an index; words are operators.
    const std::size_t letters =
        static_cast<std::size_t>(std::find_if(term.name().begin(), term.name().end(),
                                              [](char c) { return !std::isalpha(static_cast<unsigned char>(c)); }) -
                                 term.name().begin());
    if (plain || own != names_.notation.names.end() || letters == 1)
      name = latex_name(term.name(), names_.notation).text();
    else
      name = "\\operatorname{" + words(term.name()) + "}";
    return plain ? name : name + bracketed(list(term.children(), 1));
  }

  static std::string words(const std::string& name) {
    std::string result;
    for (const char c : name) result += c == '_' ? std::string{"\\_"} : std::string(1, c);
    return result;
  }

  const LatexNames& names_;
  bool inside_matrix_ = false;
};

}  // namespace

void LatexNames::add(const Term& term, const std::string& name) {
  if (term.children().empty()) return;
  if (name_of(term) != nullptr) return;
  places_.emplace(term.child(0).address(), all_.size());
  all_.push_back({term, name});
}

const std::string* LatexNames::name_of(const Term& term) const {
  if (term.children().empty()) return nullptr;
  const auto [begin, end] = places_.equal_range(term.child(0).address());
  for (auto candidate = begin; candidate != end; ++candidate) {
    const NamedTerm& named = all_[candidate->second];
    if (is_one_term(named.term, term)) return &named.name;
  }
  return nullptr;
}

std::string to_latex(const Term& term, const LatexNames& names) { return Writer{names}.of(term); }

std::vector<std::string> latex_summands(const Term& term, const LatexNames& names) {
  return Writer{names}.summands(term);
}

}  // namespace patchproof
