#include <patchproof/derivation/computation.hpp>

#include <algorithm>

#include <patchproof/decide/guard.hpp>
#include <patchproof/derivation/shapes.hpp>
#include <patchproof/derivation/tidied.hpp>
#include <patchproof/kernel/readable_term.hpp>

namespace patchproof {

namespace {

constexpr int most_layers = 12;
// About six lines of a page.
constexpr std::size_t longest_term = 240;
// Numbers that are put in but not worked out yet: two lines.
constexpr std::size_t longest_raw = 110;
constexpr std::size_t longest_definition = 160;

// How many signs the term takes on paper, about; counts no further than `most`.
std::size_t printed_size(const Term& term, std::size_t most) {
  std::size_t size = 1;
  const bool is_call = term.operation() == Operation::definition;
  const std::size_t first = is_call && term.children().size() > 1 ? 1 : 0;
  for (std::size_t k = first; k < term.children().size() && size <= most; ++k)
    size += printed_size(term.child(k), most - size);
  return size;
}

// Matrices and fractions cannot be broken: what is wider than a line would be made too small.
bool fits_a_line(const Term& term) {
  constexpr std::size_t widest = 62;
  if (term.operation() == Operation::matrix && !is_array(term)) {
    const std::size_t columns = static_cast<std::size_t>(std::max(term.type().columns, 1));
    std::size_t width = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      std::size_t column = 0;
      for (std::size_t k = j; k < term.children().size(); k += columns)
        column = std::max(column, printed_size(term.child(k), widest + 1));
      width += column;
    }
    if (width > widest) return false;
  }
  if (term.operation() == Operation::quotient &&
      std::max(printed_size(term.child(0), widest + 1), printed_size(term.child(1), widest + 1)) >
          widest)
    return false;
  const bool is_call = term.operation() == Operation::definition && term.children().size() > 1;
  for (std::size_t k = is_call ? 1 : 0; k < term.children().size(); ++k)
    if (!fits_a_line(term.child(k))) return false;
  return true;
}

}  // namespace

bool Computation::same(const Term& a, const Term& b) const {
  if (a.address() == b.address()) return true;
  return to_latex(a, names_) == to_latex(b, names_);
}

bool Computation::is_readable(const Term& term) const {
  return is_brief(term) && fits_a_line(term);
}

bool Computation::is_brief(const Term& term) const {
  return printed_size(term, longest_term) < longest_term;
}

void Computation::append(Chain& chain, const Term& term, Reason reason) const {
  if (!is_readable(term)) return;
  const Term& last = chain.links.empty() ? chain.start : chain.links.back().term;
  if (same(last, term)) return;
  chain.links.push_back({Relation::equal, term, std::move(reason)});
}

Chain Computation::of(const Term& value) {
  Chain chain{value, {}};
  Term current = value;
  std::vector<std::string> renamed;
  for (int k = 0; k < most_layers && unfolding_.depth(current) > 0; ++k) {
    const std::optional<Unfolded> next = unfolding_.layer(current);
    if (!next) break;
    current = next->term;
    std::vector<std::string> names = renamed;
    names.insert(names.end(), next->names.begin(), next->names.end());
    if (next->only_renamed && detail_ != Detail::all) {
      renamed = names;
      continue;
    }
    renamed.clear();
    const Reason definition{next->differentiated ? Reason::Kind::derivative
                                                 : Reason::Kind::definition,
                            names};
    const Term tidy = tidied(current);
    const bool is_short = printed_size(current, longest_raw) < longest_raw;
    const bool put_in = !next->differentiated && is_short && next->numbers_put_in;
    if (put_in || detail_ == Detail::all) {
      append(chain, current, definition);
      append(chain, tidy, {Reason::Kind::arithmetic, {}});
    } else {
      append(chain, tidy, definition);
    }
    current = tidy;
  }
  append(chain, tidied(current), {Reason::Kind::arithmetic, {}});
  // Collected only where that makes it shorter.
  const Term& last = chain.links.empty() ? chain.start : chain.links.back().term;
  const std::optional<Term> normal = collected(value);
  if (normal && printed_size(*normal, longest_term) < printed_size(last, longest_term))
    append(chain, *normal, {Reason::Kind::collected, {}});
  return chain;
}

std::vector<Chain> Computation::lower_derivatives(const Term& value) {
  std::vector<Chain> chains;
  if (value.operation() != Operation::apply) return chains;
  const Term& function = value.child(0);
  if (function.operation() != Operation::derivative || function.indices().size() < 2) return chains;
  for (std::size_t k = 1; k < value.children().size(); ++k)
    if (value.child(k).operation() != Operation::symbol) return chains;
  const Indices& whole = function.indices();
  Indices orders(whole.size(), 0);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    for (int n = 0; n < whole[k]; ++n) {
      ++orders[k];
      // In the first parameter at once, then one by one; the whole is what is asked for.
      if (orders == whole || (k == 0 && orders[0] < whole[0])) continue;
      std::vector<Term> children = value.children();
      children.front() = derivative_of(function.child(0), orders);
      Chain chain = of(make_term(Operation::apply, value.type(), std::move(children)));
      if (chain.links.empty()) continue;
      chain.links.resize(1);
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

Chain Computation::definition(const Term& value, const Term& body) {
  Chain chain{value, {{Relation::equal, body, {}}}};
  std::vector<std::string> names;
  Term current = body;
  // Through all names that only stand for another one, to the first formula.
  for (int k = 0; k < most_layers && unfolding_.depth(current) > 0; ++k) {
    const std::optional<Unfolded> next = unfolding_.layer(current);
    if (!next) return chain;
    current = next->term;
    names.insert(names.end(), next->names.begin(), next->names.end());
    if (!next->only_renamed) break;
  }
  const bool is_call = body.operation() == Operation::apply;
  if (is_call && printed_size(current, longest_definition) < longest_definition)
    append(chain, current, {Reason::Kind::definition, names});
  return chain;
}

std::optional<Term> Computation::collected(const Term& value,
                                           const std::vector<KnownValue>& known) const {
  std::optional<Term> result;
  guarded(limits_, [&](Workspace& workspace) {
    Evaluator evaluator{workspace, known};
    result = readable_term(evaluator.value(value), value.type(), workspace);
    return Decision{};
  });
  return result;
}

}  // namespace patchproof
