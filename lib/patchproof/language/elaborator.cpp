#include <patchproof/language/elaborator.hpp>

#include <algorithm>

#include <patchproof/language/builtins.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/language/spline_changes.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

// "uuv" as orders in the parameters (u, v); empty when it is not made of their names.
std::optional<Indices> orders_of(std::string_view suffix,
                                 const std::vector<std::string>& parameters) {
  Indices orders(parameters.size(), 0);
  while (!suffix.empty()) {
    bool found = false;
    for (std::size_t k = 0; k < parameters.size() && !found; ++k) {
      if (parameters[k].empty() || suffix.substr(0, parameters[k].size()) != parameters[k]) continue;
      ++orders[k];
      suffix.remove_prefix(parameters[k].size());
      found = true;
    }
    if (!found) return std::nullopt;
  }
  return orders;
}

// A declared term where it is mentioned: what is wrong with it there is to be shown there, not at
// its declaration.
Term mentioned(const Term& term, const Span& span) {
  const Span& own = term.span();
  const bool here = own.source != span.source || (span.begin <= own.begin && own.end <= span.end);
  if (here) return term;
  return make_term(term.operation(), term.type(), term.children(), term->payload, span);
}

}  // namespace

void Elaborator::unknown_name(const std::string& text, const Span& span, const Scope& scope) {
  std::vector<std::string> known = scope.names();
  known.insert(known.end(), library_.names().begin(), library_.names().end());
  for (const std::string& builtin : builtin_names()) known.push_back(builtin);
  throw Fault{span, "unknown name '" + text + "'", did_you_mean(text, known)};
}

Term Elaborator::name(const std::string& text, const Span& span, const Scope& scope) {
  const std::size_t quote = text.find('\'');
  const std::string base = text.substr(0, quote);
  const auto primes = quote == std::string::npos ? 0 : static_cast<int>(text.size() - quote);
  if (const Entity* entity = scope.find(base)) {
    if (entity->kind == Entity::Kind::faulty) throw FollowUp{};
    if (entity->kind == Entity::Kind::spline)
      throw Fault{span, "'" + base + "' is a spline, which is made of pieces",
                  "segment(" + base + ", 0) is its first piece, for a surface segment(" + base +
                      ", 0, 0)"};
    if (entity->kind == Entity::Kind::functional)
      throw Fault{span, "'" + base + "' needs arguments: " + base + "(" +
                            entity->functional->formals.front().text + ")"};
    // The same node, with the span of this use.
    const TermNode& node = *entity->term;
    const Term term = node.operation == Operation::symbol
                          ? make_term(node.operation, node.type, {}, node.payload, span)
                          : entity->term;
    if (primes == 0) return term;
    if (!term.type().is_function() || term.type().parameters.size() != 1)
      throw Fault{span, "' marks the derivative of a function of one parameter, and '" + base +
                            "' is a " + to_text(term.type())};
    return construct_.derivative(term, Indices{primes}, span);
  }
  if (const syntax::Definition* definition = library_.find(base)) {
    const Term function = definition_as_function(*definition, span);
    return primes == 0 ? function : construct_.derivative(function, Indices{primes}, span);
  }
  if (base == "pi" && primes == 0) return construct_.make(Operation::pi, Type::scalar(), {}, {}, span);
  const std::size_t underscore = base.rfind('_');
  if (underscore != std::string::npos && underscore > 0 && primes == 0) {
    const Entity* entity = scope.find(base.substr(0, underscore));
    if (entity != nullptr && entity->kind == Entity::Kind::faulty) throw FollowUp{};
    if (entity != nullptr && entity->kind == Entity::Kind::term &&
        entity->term.type().is_function()) {
      const auto orders =
          orders_of(base.substr(underscore + 1), entity->term.type().parameters);
      if (!orders)
        throw Fault{span, "'" + base + "' is not a derivative of '" + base.substr(0, underscore) +
                              "', a " + to_text(entity->term.type()),
                    "parameters mark derivatives, as in r_u and r_uv"};
      return construct_.derivative(entity->term, *orders, span);
    }
  }
  if (is_builtin(base))
    throw Fault{span, "'" + base + "' needs arguments: " + builtin_usage(base)};
  unknown_name(base, span, scope);
}

std::pair<int, int> Elaborator::interval(const syntax::Interval& i, const Scope& scope) {
  const Term first = expression(*i.first, scope);
  const Term last = expression(*i.last, scope);
  return {static_cast<int>(construct_.whole_number(first, "the start of a span")),
          static_cast<int>(construct_.whole_number(last, "the end of a span"))};
}

std::vector<std::vector<int>> Elaborator::combinations(const std::vector<syntax::Binder>& binders,
                                                       const Scope& scope, std::size_t most) {
  std::vector<std::vector<int>> result{{}};
  for (const syntax::Binder& binder : binders) {
    if (const Entity* hidden = scope.find(binder.name.text))
      throw Fault{binder.name.span,
                  "the running index '" + binder.name.text + "' would hide what is declared " +
                      (hidden->declared.source
                           ? "on line " + std::to_string(position_of(*hidden->declared.source,
                                                                     hidden->declared.begin)
                                                             .line)
                           : "under that name"),
                  "choose another name"};
    const auto [first, last] = interval(binder.interval, scope);
    if (last < first)
      throw Fault{binder.name.span, "'" + binder.name.text + "' runs over the empty span " +
                                        std::to_string(first) + ".." + std::to_string(last)};
    const auto count = static_cast<std::size_t>(last - first) + 1;
    if (result.size() * count > most)
      throw Fault{binder.name.span, "more than " + std::to_string(most) +
                                        " combinations of the running indices"};
    std::vector<std::vector<int>> longer;
    for (const std::vector<int>& values : result) {
      for (int value = first; value <= last; ++value) {
        longer.push_back(values);
        longer.back().push_back(value);
      }
    }
    result = std::move(longer);
  }
  return result;
}

Scope Elaborator::bound(const Scope& scope, const std::vector<syntax::Binder>& binders,
                        const std::vector<int>& values) {
  Scope inner{&scope};
  for (std::size_t k = 0; k < binders.size(); ++k)
    inner.declare(binders[k].name.text, number_term(values[k], binders[k].name.span));
  return inner;
}

bool Elaborator::is_number(const syntax::Expression& e, const Scope& scope) {
  const Entity* entity = scope.find(e.text);
  return entity != nullptr && entity->kind == Entity::Kind::term && entity->term.is_number();
}

Spline Elaborator::spline(const syntax::Expression& e, const Scope& scope) {
  if (e.kind == syntax::Expression::Kind::name) {
    const Entity* entity = scope.find(e.text);
    if (entity != nullptr && entity->kind == Entity::Kind::faulty) throw FollowUp{};
    if (entity != nullptr && entity->kind == Entity::Kind::spline) return *entity->spline;
    if (entity == nullptr) unknown_name(e.text, e.span, scope);
  }
  if (e.kind == syntax::Expression::Kind::call) {
    const syntax::Expression& callee = *e.operands.front();
    const bool changes = callee.kind == syntax::Expression::Kind::name &&
                         scope.find(callee.text) == nullptr && changes_splines(callee.text);
    if (changes) return changed_spline(callee.text, e, scope, *this);
  }
  throw Fault{e.span, "a spline is needed here", "declare one: 'spline T = bspline(d, degree 3, clamped uniform)'"};
}

Term Elaborator::index(const syntax::Expression& e, const Scope& scope) {
  // Not `expression`: that would copy a whole array for each of its entries.
  const syntax::Expression& array = *e.operands.front();
  const Term base = array.kind == syntax::Expression::Kind::name
                        ? name(array.text, array.span, scope)
                        : expression(array, scope);
  bool spans = false;
  for (const syntax::Argument& argument : e.arguments) {
    if (argument.binder) throw Fault{e.span, "an index cannot run"};
    spans = spans || argument.interval.has_value();
  }
  std::vector<std::pair<int, int>> ranges;
  std::vector<int> indices;
  for (const syntax::Argument& argument : e.arguments) {
    if (argument.interval) {
      ranges.push_back(interval(*argument.interval, scope));
    } else {
      const auto at = static_cast<int>(
          construct_.whole_number(expression(*argument.value, scope), "an index"));
      ranges.emplace_back(at, at);
      indices.push_back(at);
    }
  }
  return spans ? construct_.slice(base, ranges, e.span) : construct_.entry(base, indices, e.span);
}

Term Elaborator::expression(const syntax::Expression& e, const Scope& scope) {
  using Kind = syntax::Expression::Kind;
  const auto operands = [&] {
    std::vector<Term> terms;
    for (const auto& operand : e.operands) terms.push_back(expression(*operand, scope));
    return terms;
  };
  switch (e.kind) {
    case Kind::number: return number_term(e.number, e.span);
    case Kind::name: return mentioned(name(e.text, e.span, scope), e.span);
    case Kind::hole:
      throw Fault{e.span, "'?' stands for an unknown entry of a matrix and nothing else",
                  "as in: matrix M = [?, (0,1) ; (1,0), (1,1)]"};
    case Kind::sum: return construct_.sum(scope, operands(), e.signs, e.span);
    case Kind::product: return construct_.product(scope, operands(), e.signs, e.span);
    case Kind::negation: return construct_.negation(expression(*e.operands.front(), scope), e.span);
    case Kind::power: {
      const std::vector<Term> terms = operands();
      return construct_.power(decayed(construct_.value(scope, terms[0])), terms[1], e.span);
    }
    case Kind::call: return call(e, scope);
    case Kind::index: return index(e, scope);
    case Kind::component: {
      const Term point = decayed(construct_.value(scope, expression(*e.operands.front(), scope)));
      return construct_.component(point, e.text[0] - 'x', e.span);
    }
    case Kind::tuple: return construct_.tuple(scope, operands(), e.span);
    default: {
      std::vector<std::vector<Term>> rows;
      for (const auto& row : e.rows) {
        rows.emplace_back();
        for (const auto& entry : row) rows.back().push_back(expression(*entry, scope));
      }
      return construct_.matrix(scope, std::move(rows), e.span);
    }
  }
}

Term Elaborator::call(const syntax::Expression& e, const Scope& scope) {
  const syntax::Expression& callee = *e.operands.front();
  const Entity* entity =
      callee.kind == syntax::Expression::Kind::name ? scope.find(callee.text) : nullptr;
  if (entity != nullptr && entity->kind == Entity::Kind::functional)
    return functional_call(*entity->functional, e, scope);
  if (callee.kind == syntax::Expression::Kind::name && entity == nullptr) {
    if (const syntax::Definition* definition = library_.find(callee.text))
      return definition_call(*definition, e, scope);
    if (is_builtin(callee.text)) return builtin_call(callee.text, e, scope, *this);
  }
  const Term function = expression(callee, scope);
  std::vector<Term> arguments;
  for (const syntax::Argument& argument : e.arguments) {
    if (!argument.value) throw Fault{e.span, "a running index is not an argument of a function"};
    const Term given = expression(*argument.value, scope);
    arguments.push_back(decayed(construct_.value(scope, given)));
  }
  return construct_.apply(function, std::move(arguments), e.span);
}

}  // namespace patchproof
