#include <patchproof/algebra/quadratic_form.hpp>

#include <utility>

namespace patchproof {

namespace {

using Vector = std::vector<Rational>;

// Makes the unit vectors orthogonal with respect to the form, one after the other: the matrix is
// always that of the form in the present basis.
class Elimination {
 public:
  Elimination(std::vector<Vector> matrix, Budget& budget)
      : matrix_{std::move(matrix)}, budget_{budget}, done_(matrix_.size(), false) {
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
      basis_.emplace_back(matrix_.size(), Rational{0});
      basis_.back()[i] = 1;
    }
  }

  QuadraticForm run() {
    QuadraticForm result;
    for (std::size_t pivot = next_pivot(); pivot < matrix_.size(); pivot = next_pivot()) {
      result.pivots.push_back(matrix_[pivot][pivot]);
      if (matrix_[pivot][pivot] < 0) return negative(std::move(result), basis_[pivot]);
      eliminate(pivot);
    }
    // What is left has a zero diagonal: a single entry beside it makes the form negative somewhere.
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
      if (done_[i]) continue;
      result.kind = QuadraticForm::Kind::positive_semidefinite;
      for (std::size_t j = 0; j < i; ++j) {
        if (done_[j] || matrix_[i][j] == 0) continue;
        const Rational t = Rational{-1} / matrix_[i][j];
        Vector direction = basis_[i];
        for (std::size_t k = 0; k < direction.size(); ++k) direction[k] += t * basis_[j][k];
        return negative(std::move(result), std::move(direction));
      }
    }
    return result;
  }

 private:
  static QuadraticForm negative(QuadraticForm result, Vector direction) {
    result.kind = QuadraticForm::Kind::somewhere_negative;
    result.negative_at = std::move(direction);
    return result;
  }

  std::size_t next_pivot() const {
    for (std::size_t i = 0; i < matrix_.size(); ++i)
      if (!done_[i] && matrix_[i][i] != 0) return i;
    return matrix_.size();
  }

  void eliminate(std::size_t pivot) {
    done_[pivot] = true;
    const Vector row = matrix_[pivot];
    for (std::size_t j = 0; j < matrix_.size(); ++j) {
      if (done_[j] || row[j] == 0) continue;
      const Rational factor = row[j] / row[pivot];
      for (std::size_t k = 0; k < matrix_.size(); ++k) {
        budget_.spend(1 + bit_length(factor) / 64);
        if (!done_[k]) matrix_[j][k] -= factor * row[k];
        basis_[j][k] -= factor * basis_[pivot][k];
      }
    }
  }

  std::vector<Vector> matrix_;
  Budget& budget_;
  std::vector<bool> done_;
  std::vector<Vector> basis_;
};

}  // namespace

QuadraticForm quadratic_form(const std::vector<std::vector<Rational>>& matrix, Budget& budget) {
  return Elimination{matrix, budget}.run();
}

}  // namespace patchproof
