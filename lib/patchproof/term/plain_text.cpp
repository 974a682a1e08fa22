#include <patchproof/term/plain_text.hpp>

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <string_view>
#include <utility>

#include <patchproof/term/binding.hpp>
#include <patchproof/term/bounded_text.hpp>
#include <patchproof/term/call_name.hpp>

namespace patchproof {

namespace {

class Writer {
 public:
  explicit Writer(std::size_t longest) : text_{longest} {}

  void write(const Term& term);

  std::string text() const { return text_.text(); }

 private:
  bool full() const { return text_.full(); }
  void put(std::string_view text) { text_.put(text); }
  void put(int number) { put(std::to_string(number)); }

  // In parentheses unless the term holds together at least as tightly as asked.
  void write(const Term& term, Binding least) {
    if (binding(term) >= least) return write(term);
    put("(");
    write(term);
    put(")");
  }
  void write_list(const std::vector<Term>& terms, std::size_t first = 0) {
    for (std::size_t i = first; i < terms.size() && !full(); ++i) {
      if (i > first) put(", ");
      write(terms[i]);
    }
  }
  void write_call(std::string_view name, const std::vector<Term>& arguments,
                  std::size_t first = 0) {
    put(name);
    put("(");
    write_list(arguments, first);
    put(")");
  }

  void write_number(const Rational& number);
  void write_summand(const Term& term, bool first);
  void write_factor(const Term& term, bool first);
  void write_function(const Term& function);
  void write_derivative(const Term& derivative);
  void write_component(const Term& point, int k);
  void write_indexed(const Term& term, std::initializer_list<std::string_view> separators);
  void write_matrix(const Term& matrix);
  void write_integral(const Term& integral);
  void write_basis_function(const BasisFunction& basis, const Term& argument);

  BoundedText text_;
  // The next '-' has been written already, as part of " - ".
  bool minus_done_ = false;
};

void Writer::write_number(const Rational& number) {
  if (number < 0 && !minus_done_) put("-");
  if (number < 0) minus_done_ = false;
  text_.put_digits(boost::multiprecision::abs(numerator(number)));
  const Integer below = denominator(number);
  if (below == 1 || full()) return;
  put("/");
  text_.put_digits(below);
}

void Writer::write_summand(const Term& function_or_value, bool first) {
  const Term& term = written(function_or_value);
  if (term.operation() == Operation::sum) {
    for (const Term& summand : term.children()) {
      if (full()) return;
      write_summand(summand, first);
      first = false;
    }
    return;
  }
  if (!first) {
    minus_done_ = starts_with_minus(term);
    put(minus_done_ ? " - " : " + ");
  }
  write(term);
}

void Writer::write_factor(const Term& function_or_value, bool first) {
  const Term& term = written(function_or_value);
  if (is_product(term)) {
    for (const Term& factor : term.children()) {
      if (full()) return;
      write_factor(factor, first);
      first = false;
    }
    return;
  }
  if (!first) put("*");
  // A minus or a division is read with what stands to its left, so only the first factor may
  // have one; a sum never.
  const bool bare = first && term.operation() != Operation::sum;
  write(term, bare ? Binding::sum : Binding::power);
}

void Writer::write_function(const Term& function) {
  if (function.operation() != Operation::lambda) return write(function, Binding::primary);
  put("(");
  write(function.child(0));
  put(")");
}

void Writer::write_derivative(const Term& derivative) {
  // A derivative of a derivative is written as one of higher order.
  const Term* base = &derivative;
  Indices orders(derivative.indices().size(), 0);
  for (; base->operation() == Operation::derivative; base = &base->child(0)) {
    for (std::size_t i = 0; i < orders.size(); ++i) orders[i] += base->indices().at(i);
  }
  const Term& function = *base;
  const std::vector<std::string>& names = function.type().parameters;
  const int total = std::accumulate(orders.begin(), orders.end(), 0);
  if (total == 0) return write(function, Binding::primary);
  if (has_plain_name(function) && orders.size() == 1 && total <= 3) {
    write(function);
    return put(std::string(static_cast<std::size_t>(total), '\''));
  }
  const bool short_names = std::all_of(names.begin(), names.end(),
                                       [](const std::string& name) { return name.size() == 1; });
  if (has_plain_name(function) && short_names && orders.size() > 1 && total <= 6) {
    write(function);
    put("_");
    for (std::size_t i = 0; i < orders.size(); ++i) {
      for (int k = 0; k < orders[i]; ++k) put(names.at(i));
    }
    return;
  }
  put("diff(");
  write(function);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0) continue;
    put(", ");
    put(names.at(i));
    if (total == 1) continue;
    put(", ");
    put(orders[i]);
  }
  put(")");
}

void Writer::write_component(const Term& point, int k) {
  static constexpr std::string_view letters = "xyz";
  if (k >= 0 && k < 3) {
    write(point, Binding::primary);
    put(".");
    return put(letters.substr(static_cast<std::size_t>(k), 1));
  }
  put("component(");
  write(point);
  put(", ");
  put(k);
  put(")");
}

// M[1,2] or M[0..2,1..3]: each index of the payload, and what is put after it.
void Writer::write_indexed(const Term& term, std::initializer_list<std::string_view> separators) {
  write(term.child(0), Binding::primary);
  put("[");
  std::size_t i = 0;
  for (const std::string_view separator : separators) {
    put(term.indices().at(i));
    put(separator);
    ++i;
  }
}

void Writer::write_matrix(const Term& matrix) {
  const std::size_t columns = static_cast<std::size_t>(std::max(matrix.type().columns, 1));
  put("[");
  for (std::size_t i = 0; i < matrix.children().size() && !full(); ++i) {
    if (i > 0) put(i % columns == 0 ? " ; " : ", ");
    write(matrix.child(i));
  }
  put("]");
}

void Writer::write_integral(const Term& integral) {
  put("integral(");
  write(integral.child(0));
  const std::vector<std::string>& names = integral.child(0).type().parameters;
  for (std::size_t k = 0; k < names.size() && !full(); ++k) {
    put(", ");
    put(names[k]);
    put(" in [");
    write(integral.child(2 * k + 1));
    put(", ");
    write(integral.child(2 * k + 2));
    put("]");
  }
  put(")");
}

void Writer::write_basis_function(const BasisFunction& basis, const Term& argument) {
  put("bspline_basis(");
  for (const int number : {basis.index, basis.degree, basis.span}) {
    put(number);
    put(", ");
  }
  put("[");
  for (std::size_t i = 0; i < basis.knots.size() && !full(); ++i) {
    if (i > 0) put(", ");
    write_number(basis.knots[i]);
  }
  put("], ");
  write(argument);
  put(")");
}

void Writer::write(const Term& term) {
  // The one place where the walk over a term of exponential size ends.
  if (full()) return;
  switch (term.operation()) {
    case Operation::number:
      return write_number(term.number());
    case Operation::pi:
      return put("pi");
    case Operation::symbol:
      return put(term.symbol()->name);
    case Operation::matrix:
      return write_matrix(term);
    case Operation::sum:
      return write_summand(term, true);
    case Operation::negation:
      if (!minus_done_) put("-");
      minus_done_ = false;
      return write(term.child(0), Binding::product);
    case Operation::product:
    case Operation::matrix_product:
      return write_factor(term, true);
    case Operation::quotient:
      write_factor(term.child(0), true);
      put("/");
      return write(term.child(1), Binding::power);
    case Operation::power:
      write(term.child(0), Binding::primary);
      put("^");
      return put(std::to_string(term.exponent()));
    case Operation::lambda:
      return write(term.child(0));
    case Operation::apply:
      write_function(term.child(0));
      return write_call("", term.children(), 1);
    case Operation::derivative:
      return write_derivative(term);
    case Operation::component:
      return write_component(term.child(0), term.indices().at(0));
    case Operation::entry:
      return write_indexed(term, {",", "]"});
    case Operation::slice:
      return write_indexed(term, {"..", ",", "..", "]"});
    case Operation::bernstein:
      put("bernstein(");
      put(term.indices().at(0));
      put(", ");
      put(term.indices().at(1));
      put(", ");
      write(term.child(0));
      return put(")");
    case Operation::bspline_basis:
      return write_basis_function(term.basis_function(), term.child(0));
    case Operation::integral:
      return write_integral(term);
    case Operation::definition:
      if (has_plain_name(term)) return put(term.name());
      return write_call(term.name(), term.children(), 1);
    default:
      return write_call(call_name(term), term.children());
  }
}

}  // namespace

std::string to_text(const Term& term, std::size_t longest) {
  if (!term) return "";
  Writer writer{longest};
  writer.write(term);
  return writer.text();
}

}  // namespace patchproof
