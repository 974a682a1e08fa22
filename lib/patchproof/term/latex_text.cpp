#include <patchproof/term/latex_text.hpp>

#include <patchproof/term/latex_writer.hpp>

namespace patchproof {

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

std::string to_latex(const Term& term, const LatexNames& names) { return LatexWriter{names}.of(term); }

std::vector<std::string> latex_summands(const Term& term, const LatexNames& names) {
  return LatexWriter{names}.summands(term);
}

}  // namespace patchproof
