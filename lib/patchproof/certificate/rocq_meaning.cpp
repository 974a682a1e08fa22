#include <patchproof/certificate/rocq_meaning.hpp>

#include <algorithm>

#include <patchproof/certificate/rocq_tokens.hpp>

namespace patchproof {

namespace {

using Kind = RocqTerm::Kind;

// Of one proposition: a step counts `work_of_step`, and a look at a variable in scope 1.
constexpr std::size_t most_work = 60'000'000;
constexpr std::size_t work_of_step = 20;
constexpr std::size_t deepest_meaning = 1'000;
constexpr std::size_t most_variables = 10'000;

}  // namespace

// Counts how deep the computation is: terms that are applied to themselves have no end.
class RocqMeaning::Nesting {
 public:
  explicit Nesting(RocqMeaning& of) : of_{of} {
    if (++of_.nesting_ > deepest_meaning) {
      --of_.nesting_;
      throw RocqUnreadable{"nested too deeply"};
    }
  }
  ~Nesting() { --of_.nesting_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  RocqMeaning& of_;
};

void RocqMeaning::define(const std::string& name, RocqTermPointer term, const std::string& problem) {
  definitions_[name] = {std::move(term), problem};
}

void RocqMeaning::count(std::size_t work) {
  work_ += work;
  if (work_ > most_work) throw RocqUnreadable{"too large when unfolded"};
}

const RocqMeaning::Scope* RocqMeaning::bound(const RocqBinder& binder, std::size_t level,
                                             const Scope* outer) {
  if (level > most_variables) throw RocqUnreadable{"too many variables"};
  return &scopes_.emplace_back(Scope{binder.name, level, binder.type, nullptr, nullptr, outer});
}

const RocqMeaning::Scope* RocqMeaning::found(const std::string& name, const Scope* scope) {
  for (; scope && scope->name != name; scope = scope->outer) count(1);
  return scope;
}

std::size_t RocqMeaning::of_proposition(const RocqTermPointer& term) {
  roots_.push_back(term);
  work_ = 0;
  return proposition(*term, nullptr, 0);
}

std::size_t RocqMeaning::proposition(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  const Nesting nesting{*this};
  // A /\ (B /\ C)
  const auto from_the_right = [&](const char* head) {
    std::size_t result = proposition(*term.parts.back(), scope, depth);
    for (std::size_t k = term.parts.size() - 1; k-- > 0;)
      result = table_.number_of(head, {proposition(*term.parts[k], scope, depth), result});
    return result;
  };
  switch (term.kind) {
    case Kind::forall: {
      for (std::size_t k = 0; k < term.binders.size(); ++k)
        scope = bound(term.binders[k], depth + k, scope);
      std::size_t result = proposition(*term.parts[0], scope, depth + term.binders.size());
      for (std::size_t k = term.binders.size(); k-- > 0;)
        result = table_.number_of("forall " + term.binders[k].type, {result});
      return result;
    }
    case Kind::implication: return implication(term, scope, depth);
    case Kind::conjunction: return from_the_right("/\\");
    case Kind::disjunction: return from_the_right("\\/");
    case Kind::negation:
      return table_.number_of("~", {proposition(*term.parts[0], scope, depth)});
    case Kind::relation: return relation(term, scope, depth);
    case Kind::application: return smoothness(term, scope, depth);
    default: throw RocqUnreadable{"a value in the place of a proposition"};
  }
}

// A -> (B -> C), and R -> A for a variable that does not occur in A.
std::size_t RocqMeaning::implication(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  struct Link {
    std::string head;
    std::vector<std::size_t> parts;
  };
  std::vector<Link> links;
  for (std::size_t k = 0; k + 1 < term.parts.size(); ++k) {
    const RocqTerm& part = *term.parts[k];
    if (is_type(part)) {
      ++depth;
      links.push_back({"forall " + to_text(part), {}});
    } else {
      links.push_back({"->", {proposition(part, scope, depth)}});
    }
  }
  std::size_t result = proposition(*term.parts.back(), scope, depth);
  for (std::size_t k = links.size(); k-- > 0;) {
    links[k].parts.push_back(result);
    result = table_.number_of(std::move(links[k].head), std::move(links[k].parts));
  }
  return result;
}

// a <= b <= c is a <= b /\ b <= c.
std::size_t RocqMeaning::relation(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  std::vector<std::size_t> links;
  for (std::size_t k = 0; k < term.operators.size(); ++k)
    links.push_back(table_.number_of(term.operators[k], {value(*term.parts[k], scope, depth),
                                                         value(*term.parts[k + 1], scope, depth)}));
  return links.size() == 1 ? links[0] : table_.number_of("/\\", {links[0], links[1]});
}

// smooth 2 C1
std::size_t RocqMeaning::smoothness(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  const RocqTerm& head = *term.parts[0];
  const bool known = head.kind == Kind::name && !found(head.name, scope) &&
                     !definitions_.contains(head.name) &&
                     (head.name == "smooth" || head.name == "smooth2" || head.name == "smooth3");
  if (!known || term.parts.size() != 3)
    throw RocqUnreadable{"a value in the place of a proposition"};
  return table_.number_of(head.name + " " + natural({term.parts[1].get(), scope}, false),
                          {value(*term.parts[2], scope, depth)});
}

std::string RocqMeaning::natural(const Argument& argument, bool marked) {
  const RocqTerm& term = *argument.term;
  const bool good =
      term.kind == Kind::number && term.number >= 0 && (term.natural || !marked);
  if (!good) throw RocqUnreadable{"something else in the place of a natural number"};
  return term.number.str();
}

std::size_t RocqMeaning::value(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  const Nesting nesting{*this};
  const auto key = std::make_tuple(static_cast<const void*>(&term),
                                   static_cast<const void*>(scope), depth);
  const auto known = values_.find(key);
  if (known != values_.end()) return known->second;
  const std::size_t result = applied(&term, scope, {}, depth);
  values_.emplace(key, result);
  return result;
}

std::size_t RocqMeaning::applied(const RocqTerm* term, const Scope* scope,
                                 std::vector<Argument> arguments, std::size_t depth) {
  for (;;) {
    count(work_of_step);
    switch (term->kind) {
      case Kind::application: {
        std::vector<Argument> all;
        for (std::size_t k = 1; k < term->parts.size(); ++k)
          all.push_back({term->parts[k].get(), scope});
        all.insert(all.end(), arguments.begin(), arguments.end());
        arguments = std::move(all);
        term = term->parts[0].get();
        break;
      }
      case Kind::function: {
        if (arguments.empty()) return function_from(*term, 0, scope, depth);
        const std::size_t count = std::min(arguments.size(), term->binders.size());
        const std::vector<Argument> own(arguments.begin(),
                                        arguments.begin() + static_cast<std::ptrdiff_t>(count));
        scope = with_arguments(*term, scope, own, depth);
        if (count < term->binders.size()) return function_from(*term, count, scope, depth);
        arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(count));
        term = term->parts[0].get();
        break;
      }
      case Kind::name: {
        if (const Scope* entry = found(term->name, scope)) {
          if (!entry->value) return variable(*entry, arguments, depth);
          term = entry->value;
          scope = entry->value_scope;
          break;
        }
        const auto definition = definitions_.find(term->name);
        if (definition == definitions_.end()) return word(term->name, arguments, depth);
        if (!definition->second.term) throw RocqUnreadable{definition->second.problem};
        term = definition->second.term.get();
        scope = nullptr;
        break;
      }
      default:
        if (!arguments.empty()) throw RocqUnreadable{"arguments of something that is no function"};
        return operation(*term, scope, depth);
    }
    // What was unfolded is remembered too.
    if (arguments.empty()) return value(*term, scope, depth);
  }
}

std::size_t RocqMeaning::function_from(const RocqTerm& term, std::size_t binder, const Scope* scope,
                                       std::size_t depth) {
  const std::size_t count = term.binders.size() - binder;
  for (std::size_t k = 0; k < count; ++k)
    scope = bound(term.binders[binder + k], depth + k, scope);
  std::size_t result = value(*term.parts[0], scope, depth + count);
  for (std::size_t k = term.binders.size(); k-- > binder;)
    result = table_.number_of("fun " + term.binders[k].type, {result});
  return result;
}

const RocqMeaning::Scope* RocqMeaning::with_arguments(const RocqTerm& function, const Scope* scope,
                                                      const std::vector<Argument>& arguments,
                                                      std::size_t depth) {
  std::vector<std::size_t> identities;
  for (const Argument& argument : arguments) identities.push_back(identity(argument, depth));
  const auto [entry, is_new] = applications_.try_emplace(
      std::make_tuple(static_cast<const void*>(&function), static_cast<const void*>(scope), depth,
                      std::move(identities)),
      scope);
  if (!is_new) return entry->second;
  for (std::size_t k = 0; k < arguments.size(); ++k)
    scope = &scopes_.emplace_back(Scope{function.binders[k].name, 0, "", arguments[k].term,
                                        arguments[k].scope, scope});
  return entry->second = scope;
}

std::size_t RocqMeaning::identity(const Argument& argument, std::size_t depth) {
  Argument at = argument;
  while (at.term->kind == Kind::name) {
    count(work_of_step);
    const Scope* entry = found(at.term->name, at.scope);
    if (!entry) break;
    if (!entry->value) return table_.number_of("#" + std::to_string(entry->level));
    at = {entry->value, entry->value_scope};
  }
  if (at.term->kind == Kind::number && at.term->natural)
    return table_.number_of(at.term->number.str() + "%nat");
  return value(*at.term, at.scope, depth);
}

}  // namespace patchproof
