#include <algorithm>
#include <numeric>
#include <set>

#include <patchproof/term/latex_writer.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

bool LatexWriter::is_expression(const Term& function) const {
  return function.operation() == Operation::lambda && !name_of(function);
}

Term LatexWriter::at_arguments(const Term& term) {
  const Term& function = term.child(0);
  std::map<unsigned, Term> images;
  for (std::size_t k = 0; k < function.formals().size(); ++k)
    images.emplace(function.formals()[k]->ordinal, term.child(k + 1));
  return replaced(function.child(0), images);
}

std::string LatexWriter::apply(const Term& term) {
  const Term& function = term.child(0);
  if (is_expression(function)) return of(at_arguments(term));
  return of(function) + latex_bracketed(list(term.children(), 1));
}

std::string LatexWriter::derivative(const Term& term) {
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
  const std::string plain = name ? name->text() : latex_bracketed(of(*base));
  if (orders.size() == 1) {
    if (total <= 3) return latex_base(plain) + std::string(static_cast<std::size_t>(total), '\'');
    return latex_base(plain) + "^{(" + std::to_string(total) + ")}";
  }
  std::string letters;
  for (std::size_t i = 0; i < orders.size(); ++i)
    for (int k = 0; k < orders[i]; ++k) letters += parameter_text(parameters.at(i));
  if (names_.notation.derivatives == DerivativeStyle::superscript)
    return latex_base(plain) + "^{" + letters + "}";
  if (name && !name->index.empty()) return "(" + plain + ")_{" + letters + "}";
  return plain + "_{" + letters + "}";
}

std::string LatexWriter::parameter_text(const std::string& name) const {
  return latex_name(name, names_.notation).text();
}

std::string LatexWriter::derivative_fraction(const Term& base, const Indices& orders, int total) {
  const std::string power = total > 1 ? "^{" + std::to_string(total) + "}" : "";
  const char* d = orders.size() == 1 ? "\\mathrm{d}" : "\\partial";
  std::string below;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0) continue;
    below += (below.empty() ? "" : "\\,") + std::string{d} + " " +
             latex_base(parameter_text(base.type().parameters.at(i)));
    if (orders[i] > 1) below += "^{" + std::to_string(orders[i]) + "}";
  }
  return "\\frac{" + std::string{d} + power + " " + within(base, Binding::primary) + "}{" + below + "}";
}

// t -> H03(t) is H03.
const Term* LatexWriter::call_of_formals(const Term& function) const {
  if (function.operation() != Operation::lambda) return nullptr;
  const Term& call = function.child(0);
  const Formals& formals = function.formals();
  if (call.operation() != Operation::definition || call.children().size() != formals.size() + 1)
    return nullptr;
  for (std::size_t k = 0; k < formals.size(); ++k) {
    const Term& argument = call.child(k + 1);
    if (argument.operation() != Operation::symbol ||
        argument.symbol()->ordinal != formals[k]->ordinal)
      return nullptr;
  }
  return &call;
}

// A letter with digits, as H03; words are written as operators.
bool LatexWriter::is_letter_name(const std::string& name) {
  const auto is_word = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return std::find_if_not(name.begin(), name.end(), is_word) - name.begin() == 1;
}

std::optional<LatexName> LatexWriter::symbol_name(const Term& term) const {
  if (const std::string* name = name_of(term)) return latex_name(*name, names_.notation);
  if (term.operation() == Operation::symbol)
    return latex_name(term.symbol()->name, names_.notation);
  if (has_plain_name(term)) return latex_name(term.name(), names_.notation);
  if (const Term* call = call_of_formals(term); call != nullptr && is_letter_name(call->name()))
    return latex_name(call->name(), names_.notation);
  return std::nullopt;
}

std::string LatexWriter::component(const Term& term) {
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

std::string LatexWriter::index(const Term& matrix, const Indices& indices) {
  std::string text;
  const bool single = std::all_of(indices.begin(), indices.end(), [](int i) { return i < 10; });
  for (const int i : indices) text += (text.empty() || single ? "" : ",") + std::to_string(i);
  if (const std::optional<LatexName> name = symbol_name(matrix)) {
    LatexName entry = *name;
    entry.index += (entry.index.empty() ? "" : ",") + text;
    return entry.text();
  }
  if (matrix.operation() == Operation::slice) {
    // The entry of a part is one of the whole.
    Indices whole = indices;
    for (std::size_t k = 0; k < whole.size(); ++k) whole[k] += matrix.indices().at(2 * k);
    return index(matrix.child(0), whole);
  }
  return latex_subscript(within(matrix, Binding::primary), text);
}

std::string LatexWriter::slice(const Term& term) {
  const Indices& i = term.indices();
  const std::string range = std::to_string(i.at(0)) + "\\ldots " + std::to_string(i.at(1)) +
                            ",\\," + std::to_string(i.at(2)) + "\\ldots " +
                            std::to_string(i.at(3));
  if (const std::optional<LatexName> name = symbol_name(term.child(0))) {
    LatexName part = *name;
    part.index += (part.index.empty() ? "" : ",") + range;
    return part.text();
  }
  return latex_subscript(within(term.child(0), Binding::primary), range);
}

std::string LatexWriter::matrix(const Term& term) {
  if (term.type().list) return latex_bracketed(list(term.children()));
  const std::size_t columns = static_cast<std::size_t>(std::max(term.type().columns, 1));
  std::string result = "\\begin{pmatrix} ";
  for (std::size_t k = 0; k < term.children().size(); ++k) {
    if (k > 0) result += k % columns == 0 ? " \\\\ " : " & ";
    result += of(term.child(k));
  }
  return result + " \\end{pmatrix}";
}

std::string LatexWriter::determinant(const Term& term) {
  const Term& matrix_term = term.child(0);
  if (matrix_term.operation() != Operation::matrix || name_of(matrix_term))
    return "\\det" + latex_bracketed(of(matrix_term));
  // Bars around the whole; matrices inside stay matrices.
  std::string text = matrix(matrix_term);
  const std::string environment = "pmatrix";
  text.replace(text.find(environment), environment.size(), "vmatrix");
  text.replace(text.rfind(environment), environment.size(), "vmatrix");
  return text;
}

std::string LatexWriter::basis_function(const Term& term) {
  const BasisFunction& basis = term.basis_function();
  return "N_{" + std::to_string(basis.index) + "," + std::to_string(basis.degree) + "}^{[" +
         std::to_string(basis.span) + "]}" + latex_bracketed(of(term.child(0)));
}

std::string LatexWriter::integral(const Term& term) {
  const Term& function = term.child(0);
  const std::map<unsigned, std::string> before = renamed_;
  if (function.operation() == Operation::lambda) rename_formals(function);
  std::string signs;
  std::string differentials;
  const std::vector<std::string>& parameters = function.type().parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const std::string sign = "\\int_{" + of(term.child(2 * k + 1)) + "}^{" +
                             of(term.child(2 * k + 2)) + "}";
    signs = sign + (signs.empty() ? "" : "\\!") + signs;
    differentials += "\\,\\mathrm{d}" + (function.operation() == Operation::lambda
                                           ? of(symbol_term(function.formals()[k]))
                                           : parameter_text(parameters[k]));
  }
  const Term& integrand =
      function.operation() == Operation::lambda ? function.child(0) : function;
  const std::string text = signs + " " + within(integrand, Binding::product) + differentials;
  renamed_ = before;
  return text;
}

// A bound variable that is called as something free inside of it gets another letter: the integral
// of f(t u) over u at t = u is not one of f(u u).
bool LatexWriter::rename_formals(const Term& lambda) {
  std::set<std::string> taken;
  for (const auto& [ordinal, symbol] : free_symbols(lambda)) {
    const auto other = renamed_.find(ordinal);
    taken.insert(other == renamed_.end() ? latex_name(symbol->name, names_.notation).text()
                                         : other->second);
  }
  bool any = false;
  for (const SymbolPointer& formal : lambda.formals()) {
    std::string name = latex_name(formal->name, names_.notation).text();
    for (const char* letter : {"s", "\\sigma", "\\tau", "\\xi", "\\eta", "\\zeta", "\\theta"}) {
      if (!taken.contains(name)) break;
      any = true;
      name = letter;
    }
    renamed_[formal->ordinal] = name;
    taken.insert(name);
  }
  return any;
}


std::string LatexWriter::definition(const Term& term) {
  const bool plain = has_plain_name(term);
  const auto own = names_.notation.names.find(term.name());
  std::string name;
  if (plain || own != names_.notation.names.end() || is_letter_name(term.name()))
    name = latex_name(term.name(), names_.notation).text();
  else
    name = "\\operatorname{" + words(term.name()) + "}";
  if (plain) return name;
  // The points of a single list are the arguments: bezier_curve(p_0, p_1, p_2).
  const Term& only = term.child(1);
  const bool is_list = term.children().size() == 2 && only.type().is_matrix() && only.type().list &&
                       only.operation() == Operation::matrix && !name_of(only);
  return name + (is_list ? of(only) : latex_bracketed(list(term.children(), 1)));
}

std::string LatexWriter::words(const std::string& name) {
  std::string result;
  for (const char c : name) result += c == '_' ? std::string{"\\_"} : std::string(1, c);
  return result;
}

}  // namespace patchproof
