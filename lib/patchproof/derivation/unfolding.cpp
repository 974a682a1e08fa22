#include <patchproof/derivation/unfolding.hpp>

#include <algorithm>

#include <patchproof/derivation/differentiated.hpp>
#include <patchproof/derivation/shapes.hpp>
#include <patchproof/derivation/tidied.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// Thrown where a derivative has no rule.
struct NoRule {};

bool is_named(const Term& term, const LatexNames& names) {
  return names.name_of(term) != nullptr && !is_array(term);
}

// Whether the body is only another function at the same parameters.
bool delegates(const Term& body, const Formals& formals) {
  if (body.operation() != Operation::apply) return false;
  if (body.child(0).operation() == Operation::symbol) return false;
  for (std::size_t k = 1; k < body.children().size(); ++k) {
    const Term& argument = body.child(k);
    const bool formal = argument.operation() == Operation::symbol &&
                        std::any_of(formals.begin(), formals.end(), [&](const auto& f) {
                          return f->ordinal == argument.symbol()->ordinal;
                        });
    if (!formal) return false;
  }
  return true;
}

class Layer {
 public:
  Layer(Unfolding& depths, const LatexNames& names, int depth)
      : depths_{depths}, names_{names}, depth_{depth} {}

  Term of(const Term& term) {
    if (term.operation() == Operation::apply) return apply(term);
    if (term.operation() == Operation::definition) {
      if (term.type().is_function() || depths_.depth(term) != depth_) return term;
      result.names.push_back(term.name());
      result.only_renamed = false;
      return term.child(0);
    }
    if (is_named(term, names_)) {
      if (term.type().is_function() || depths_.depth(term) != depth_) return term;
      result.names.push_back(*names_.name_of(term));
      result.only_renamed = false;
      return without_name(term);
    }
    return rebuilt(term);
  }

  Unfolded result;

 private:
  Term rebuilt(const Term& term) {
    std::vector<Term> children;
    bool changed = false;
    for (const Term& child : term.children()) {
      children.push_back(of(child));
      changed = changed || children.back().address() != child.address();
    }
    if (!changed) return term;
    return make_term(term.operation(), term.type(), std::move(children), term->payload,
                     term.span());
  }

  Term apply(const Term& term) {
    std::vector<Term> arguments;
    for (std::size_t k = 1; k < term.children().size(); ++k) arguments.push_back(of(term.child(k)));
    const Term& function = term.child(0);
    Indices orders(arguments.size(), 0);
    const Term* base = &function;
    while (base->operation() == Operation::derivative && !is_named(*base, names_)) {
      for (std::size_t k = 0; k < orders.size(); ++k) orders[k] += base->indices().at(k);
      base = &base->child(0);
    }
    const bool unnamed = base->operation() == Operation::lambda && !is_named(*base, names_);
    const bool now = base->operation() != Operation::symbol &&
                     (unnamed || depths_.depth(term.child(0)) == depth_);
    if (!now) {
      std::vector<Term> children{function};
      children.insert(children.end(), arguments.begin(), arguments.end());
      return make_term(Operation::apply, term.type(), std::move(children), {}, term.span());
    }
    if (unnamed) return of(at(*base, orders, arguments, false));
    result.names.push_back(is_named(*base, names_) ? *names_.name_of(*base) : base->name());
    result.numbers_put_in =
        result.numbers_put_in || std::any_of(arguments.begin(), arguments.end(),
                                             [](const Term& t) { return t.is_number(); });
    return at(*base, orders, arguments, true);
  }

  // The value of a derivative of the function at the arguments, with its body written out.
  Term at(const Term& function, const Indices& orders, const std::vector<Term>& arguments,
          bool is_step) {
    const Term* lambda = &function;
    while (lambda->operation() == Operation::definition) lambda = &lambda->child(0);
    if (lambda->operation() != Operation::lambda) {
      // A definition that is an unknown function, or one of the case, under another name.
      std::vector<Term> children{derivative_of(*lambda, orders)};
      children.insert(children.end(), arguments.begin(), arguments.end());
      return make_term(Operation::apply, *function.type().inner, std::move(children));
    }
    Term body = lambda->child(0);
    const Formals& formals = lambda->formals();
    if (is_step && !delegates(body, formals)) result.only_renamed = false;
    for (std::size_t k = 0; k < formals.size(); ++k) {
      for (int n = 0; n < orders[k]; ++n) {
        const std::optional<Term> slope = differentiated(body, formals[k]);
        if (!slope) throw NoRule{};
        body = tidied(*slope);
        result.differentiated = result.differentiated || is_step;
      }
    }
    std::map<unsigned, Term> images;
    for (std::size_t k = 0; k < formals.size(); ++k)
      images.emplace(formals[k]->ordinal, arguments[k]);
    return replaced(body, images);
  }

  Unfolding& depths_;
  const LatexNames& names_;
  int depth_;
};

}  // namespace

int Unfolding::depth(const Term& term) {
  const auto known = depths_.find(term.address());
  if (known != depths_.end()) return known->second;
  int inner = 0;
  if (term.operation() == Operation::definition) {
    inner = 1 + depth(term.child(0));
  } else {
    for (const Term& child : term.children()) inner = std::max(inner, depth(child));
    if (is_named(term, names_)) ++inner;
  }
  seen_.push_back(term);
  return depths_.emplace(term.address(), inner).first->second;
}

std::optional<Unfolded> Unfolding::layer(const Term& term) {
  Layer layer{*this, names_, depth(term)};
  // Expressions given as functions, such as b(u, 0), are put at their arguments at once.
  constexpr int no_depth = -1;
  Layer without_names{*this, names_, no_depth};
  try {
    layer.result.term = without_names.of(layer.of(term));
  } catch (const NoRule&) {
    return std::nullopt;
  }
  std::vector<std::string> names;
  for (const std::string& name : layer.result.names)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  layer.result.names = std::move(names);
  return layer.result;
}

}  // namespace patchproof
