#include <patchproof/derivation/basis_rows.hpp>

#include <map>

#include <patchproof/derivation/shapes.hpp>

namespace patchproof {

namespace {

class Rows {
 public:
  explicit Rows(const Type& type) : type_{type} {}

  bool add(const Term& term, bool negative) {
    if (term.operation() == Operation::sum) {
      for (const Term& child : term.children())
        if (!add(child, negative)) return false;
      return true;
    }
    if (term.operation() == Operation::negation) return add(term.child(0), !negative);
    if (term.operation() != Operation::product) return false;
    std::vector<Term> rest;
    Term basis;
    for (const Term& factor : term.children()) {
      if (factor.operation() != Operation::bernstein) {
        rest.push_back(factor);
        continue;
      }
      if (basis || factor.child(0).operation() != Operation::symbol) return false;
      basis = factor;
    }
    if (!basis || rest.empty() || !fits(basis)) return false;
    Term coefficient =
        rest.size() == 1 ? rest.front() : make_term(Operation::product, type_, std::move(rest));
    if (!(coefficient.type() == type_)) return false;
    if (negative) coefficient = make_term(Operation::negation, type_, {coefficient});
    auto& [function, parts] = rows_[basis.indices().at(1)];
    function = basis;
    parts.push_back(std::move(coefficient));
    return true;
  }

  BasisRows result() const {
    BasisRows result;
    for (const auto& [index, row] : rows_) {
      result.basis.push_back(row.first);
      result.coefficients.push_back(sum_of(row.second, type_));
    }
    return result;
  }

 private:
  // All of one degree and one argument.
  bool fits(const Term& basis) {
    if (rows_.empty()) return true;
    const Term& other = rows_.begin()->second.first;
    return other.indices().at(0) == basis.indices().at(0) &&
           other.child(0).symbol()->ordinal == basis.child(0).symbol()->ordinal;
  }

  const Type& type_;
  std::map<int, std::pair<Term, std::vector<Term>>> rows_;
};

}  // namespace

std::optional<BasisRows> basis_rows(const Term& value) {
  Rows rows{value.type()};
  if (!rows.add(value, false)) return std::nullopt;
  return rows.result();
}

}  // namespace patchproof
