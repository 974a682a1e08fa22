#include <patchproof/language/construction.hpp>

#include <algorithm>
#include <map>

#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

bool is_zero(const Term& term) { return term.is_number() && term.number() == 0; }

Term decayed(const Term& term) {
  const Type& type = term.type();
  if (!type.is_matrix() || type.rows != 1 || type.columns != 1) return term;
  if (term.operation() == Operation::matrix) return term.child(0);
  return make_term(Operation::entry, *type.inner, {term}, Indices{0, 0}, term.span());
}

Term Construction::make(Operation operation, const Type& type, std::vector<Term> children,
                        TermNode::Payload payload, const Span& span) {
  workshop_.count_term(span);
  try {
    return make_term(operation, type, std::move(children), std::move(payload), span);
  } catch (const TooDeep&) {
    throw Fault{span, "this expression nests more than " + std::to_string(deepest_term) +
                          " operations inside each other"};
  }
}

// A scalar of the case may be given a value by a derivation, and that value may contain another one:
// inside of the lambda neither may be taken for a formal parameter.
Term Construction::lambda(const Formals& formals, const Term& body, const Span& span) {
  std::vector<std::string> names;
  Formals own;
  std::map<unsigned, Term> images;
  for (const SymbolPointer& formal : formals) {
    names.push_back(formal->name);
    own.push_back(formal);
    if (formal->role != Symbol::Role::scalar) continue;
    own.back() = workshop_.symbol(formal->name, Symbol::Role::bound, Type::scalar());
    images.emplace(formal->ordinal, symbol_term(own.back(), span));
  }
  const Term own_body = images.empty() ? body : replaced(body, images);
  return make(Operation::lambda, Type::function(std::move(names), body.type()), {own_body}, own,
              span);
}

Term Construction::definition(const std::string& name, const Term& expansion,
                              std::vector<Term> arguments, const Span& span) {
  arguments.insert(arguments.begin(), expansion);
  return make(Operation::definition, expansion.type(), std::move(arguments), name, span);
}

Term Construction::zero(const Type& type, const Span& span) {
  switch (type.kind) {
    case Type::Kind::scalar: return number_term(0, span);
    case Type::Kind::point:
      return make(Operation::tuple, type,
                  std::vector<Term>(type.component_count(), number_term(0, span)), {}, span);
    case Type::Kind::matrix: {
      const auto count = static_cast<std::size_t>(type.rows) * static_cast<std::size_t>(type.columns);
      return make(Operation::matrix, type, std::vector<Term>(count, zero(*type.inner, span)), {},
                  span);
    }
    default:
      return function(type.parameters, span,
                      [&](const std::vector<Term>&) { return zero(*type.inner, span); });
  }
}

Term Construction::apply(const Term& function, std::vector<Term> arguments, const Span& span) {
  const Type& type = function.type();
  if (!type.is_function())
    throw Fault{span, to_text(function, 40) + " is a " + to_text(type) + ", not a function",
                "multiplication is written '*'"};
  if (arguments.size() != type.parameters.size())
    throw Fault{span, "a " + to_text(type) + " takes " + std::to_string(type.parameters.size()) +
                          " argument" + (type.parameters.size() == 1 ? "" : "s") + ", not " +
                          std::to_string(arguments.size())};
  for (const Term& argument : arguments)
    if (!argument.type().is_scalar())
      throw Fault{argument.span(), "an argument of a function has to be a scalar, not a " +
                                       to_text(argument.type())};
  arguments.insert(arguments.begin(), function);
  return make(Operation::apply, *type.inner, std::move(arguments), {}, span);
}

Term Construction::derivative(const Term& function, Indices orders, const Span& span) {
  if (!function.type().is_function())
    throw Fault{span, "only functions have derivatives, this is a " + to_text(function.type())};
  constexpr int highest = 64;
  if (std::any_of(orders.begin(), orders.end(), [](int order) { return order > highest; }))
    throw Fault{span, "the order of a derivative is at most " + std::to_string(highest)};
  return make(Operation::derivative, function.type(), {function}, std::move(orders), span);
}

Term Construction::elementary(Operation operation, const Term& argument, const Span& span) {
  return make(operation, Type::scalar(), {argument}, {}, span);
}

Term Construction::value(const Scope& scope, const Term& term) {
  if (!term.type().is_function()) return term;
  std::vector<Term> arguments;
  for (const std::string& name : term.type().parameters) {
    const Entity* entity = scope.find(name);
    const bool parameter = entity != nullptr && entity->kind == Entity::Kind::term &&
                           entity->term.operation() == Operation::symbol &&
                           entity->term.type().is_scalar();
    if (!parameter) {
      std::string call = to_text(term, 40) + "(";
      for (const std::string& p : term.type().parameters)
        call += (call.back() == '(' ? "" : ", ") + p;
      throw Fault{term.span(), "a value is needed here, and this is a " + to_text(term.type()),
                  "'" + name + "' is not a parameter of this case; write " + call +
                      ") with values for the parameters"};
    }
    arguments.push_back(entity->term);
  }
  return apply(term, std::move(arguments), term.span());
}

Term Construction::scalar(const Scope& scope, const Term& term, const std::string& what) {
  const Term result = decayed(value(scope, term));
  if (!result.type().is_scalar())
    throw Fault{term.span(), what + " has to be a scalar, not a " + to_text(result.type())};
  return result;
}

long Construction::whole_number(const Term& term, const std::string& what) {
  const Term number = decayed(term);
  constexpr long largest = 1'000'000;
  if (!number.is_number() || denominator(number.number()) != 1)
    throw Fault{term.span(), what + " has to be a whole number that is known beforehand"};
  if (abs(number.number()) > largest) throw Fault{term.span(), what + " is too large"};
  return static_cast<long>(numerator(number.number()));
}

namespace {

// `zero` beside points and matrices, and functions beside values, made to fit.
std::optional<Type> common_type(const std::vector<Term>& terms) {
  for (const Term& term : terms)
    if (!is_zero(term)) return term.type();
  return std::nullopt;
}

std::string clash(const Type& a, const Type& b) {
  std::string text = "a " + to_text(b) + " cannot be added to a " + to_text(a);
  return text;
}

std::string dimension_help(const Type& a, const Type& b) {
  const auto any = [](const Type& t) {
    return t.is_point() && t.dimension == Type::any_dimension;
  };
  if (a.is_point() && b.is_point() && any(a) != any(b))
    return "declare the dimension of the points and curves: 'point P in R^3', 'curve C(u) in R^3'";
  return "";
}

}  // namespace

Term Construction::lifted_sum(std::vector<Term> terms, const std::string& signs,
                              const Span& span) {
  const Type type = *common_type(terms);
  return function(type.parameters, span, [&](const std::vector<Term>& formals) {
    std::vector<Term> values;
    for (const Term& term : terms) {
      if (!is_zero(term) && term.type().parameters.size() != formals.size())
        throw Fault{term.span(), clash(type, term.type())};
      values.push_back(is_zero(term) ? term : apply(term, formals, term.span()));
    }
    return sum(Scope{}, std::move(values), signs, span);
  });
}

Term Construction::sum(const Scope& scope, std::vector<Term> terms, const std::string& signs,
                       const Span& span) {
  if (terms.size() == 1) return signs[0] == '-' ? negation(terms.front(), span) : terms.front();
  const auto is_function = [](const Term& t) { return t.type().is_function(); };
  if (std::all_of(terms.begin(), terms.end(), [](const Term& t) { return t.is_number(); })) {
    Rational total = 0;
    for (std::size_t k = 0; k < terms.size(); ++k)
      total += signs[k] == '-' ? Rational{-terms[k].number()} : terms[k].number();
    return number_term(total, span);
  }
  if (std::any_of(terms.begin(), terms.end(), is_function)) {
    const bool pointwise = std::all_of(terms.begin(), terms.end(), [&](const Term& t) {
      return is_function(t) || is_zero(t);
    });
    if (pointwise) return lifted_sum(std::move(terms), signs, span);
    for (Term& term : terms) term = value(scope, term);
  }
  const bool all_matrices = std::all_of(terms.begin(), terms.end(), [](const Term& t) {
    return t.type().is_matrix() || is_zero(t);
  });
  if (!all_matrices)
    for (Term& term : terms) term = decayed(term);
  const Type type = *common_type(terms);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (is_zero(terms[k])) terms[k] = zero(type, terms[k].span());
    if (!(terms[k].type() == type))
      throw Fault{terms[k].span(), clash(type, terms[k].type()),
                  dimension_help(type, terms[k].type())};
    if (signs[k] == '-') terms[k] = negation(terms[k], terms[k].span());
  }
  return make(Operation::sum, type, std::move(terms), {}, span);
}

Term Construction::negation(const Term& term, const Span& span) {
  if (term.is_number()) return number_term(-term.number(), span);
  if (term.type().is_function())
    return function(term.type().parameters, span, [&](const std::vector<Term>& formals) {
      return negation(apply(term, formals, span), span);
    });
  return make(Operation::negation, term.type(), {term}, {}, span);
}

Term Construction::power(const Term& base, const Term& exponent, const Span& span) {
  constexpr long largest_power = 4096;
  constexpr std::size_t longest_result = 100'000;
  const long n = whole_number(exponent, "an exponent");
  if (std::abs(n) > largest_power)
    throw Fault{exponent.span(), "an exponent lies between -" + std::to_string(largest_power) +
                                     " and " + std::to_string(largest_power)};
  if (!base.type().is_scalar())
    throw Fault{span, "only scalars have powers, this is a " + to_text(base.type()),
                base.type().is_point() ? "the square of a vector is dot(p, p)" : ""};
  if (!base.is_number()) return make(Operation::power, Type::scalar(), {base}, n, span);
  if (base.number() == 0 && n < 0) throw Fault{span, "division by zero"};
  if (bit_length(base.number()) * static_cast<std::size_t>(std::abs(n)) > longest_result)
    throw Fault{span, "this number has more than " + std::to_string(longest_result) +
                          " binary digits"};
  return number_term(patchproof::power(base.number(), n), span);
}

}  // namespace patchproof
