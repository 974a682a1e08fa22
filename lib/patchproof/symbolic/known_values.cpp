#include <patchproof/symbolic/known_values.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <patchproof/symbolic/substitution.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;

struct Entry {
  SymbolPointer symbol;
  Components letters;
  Components value;
};

// Values are first taken as written, then each gets the final values of the symbols in it.
class Resolution {
 public:
  Resolution(Ring& ring, const std::vector<KnownValue>& known) : ring_{ring} {
    Evaluation evaluation{ring};
    for (const KnownValue& entry : known) {
      Components value = evaluation(entry.value).components;
      const Components own = letters(ring, entry.symbol);
      if (value.size() != own.size()) {
        throw std::domain_error{"the value of " + entry.symbol->name + " is of another type"};
      }
      const bool is_itself = std::equal(value.begin(), value.end(), own.begin(),
                                        [](const ex& a, const ex& b) { return a.is_equal(b); });
      if (is_itself) continue;
      for (const ex& letter : own) owners_[ring.atoms().id_of(letter)] = entry.symbol->ordinal;
      entries_.emplace(entry.symbol->ordinal, Entry{entry.symbol, own, std::move(value)});
    }
  }

  SymbolValues values() {
    SymbolValues result;
    for (const auto& [ordinal, entry] : entries_) result[ordinal] = final_value(ordinal);
    return result;
  }

 private:
  const Components& final_value(unsigned ordinal) {
    const auto known = final_.find(ordinal);
    if (known != final_.end()) return known->second;
    const Entry& entry = entries_.at(ordinal);
    if (!in_progress_.insert(ordinal).second) {
      throw std::domain_error{"the value of " + entry.symbol->name + " refers to itself"};
    }
    Replacements replacements;
    for (const unsigned other : known_symbols_in(entry.value)) {
      const Components& value = final_value(other);
      const Components& symbols = entries_.at(other).letters;
      for (std::size_t i = 0; i < symbols.size(); ++i) {
        replacements.atoms[ring_.atoms().id_of(symbols[i])] = value[i];
      }
    }
    Substitution substitution{ring_, std::move(replacements)};
    Components result;
    for (const ex& component : entry.value) result.push_back(substitution(component));
    in_progress_.erase(ordinal);
    return final_.emplace(ordinal, std::move(result)).first->second;
  }

  std::set<unsigned> known_symbols_in(const Components& value) const {
    std::set<unsigned> result;
    for (const ex& component : value) {
      for (const unsigned id : ring_.atoms().occurring_deeply(component)) {
        const auto owner = owners_.find(id);
        if (owner != owners_.end()) result.insert(owner->second);
      }
    }
    return result;
  }

  Ring& ring_;
  std::map<unsigned, Entry> entries_;
  std::map<unsigned, unsigned> owners_;
  std::set<unsigned> in_progress_;
  std::map<unsigned, Components> final_;
};

}  // namespace

SymbolValues values_of(Ring& ring, const std::vector<KnownValue>& known) {
  return Resolution{ring, known}.values();
}

}  // namespace patchproof::symbolic
