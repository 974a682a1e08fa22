#include <patchproof/algebra/bernstein_form.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// A line of the tensor along one axis: entries `first`, `first + stride`, …
template <typename Action>
void for_each_line(const std::vector<unsigned>& degrees, std::size_t axis, const Action& action) {
  std::size_t stride = 1;
  for (std::size_t k = axis + 1; k < degrees.size(); ++k) stride *= degrees[k] + 1;
  std::size_t outer = 1;
  for (std::size_t k = 0; k < axis; ++k) outer *= degrees[k] + 1;
  const std::size_t block = stride * (degrees[axis] + 1);
  for (std::size_t o = 0; o < outer; ++o)
    for (std::size_t s = 0; s < stride; ++s) action(o * block + s, stride);
}

// Power coefficients over [0,1] turned into Bernstein coefficients along one axis:
// b_i = sum_{k<=i} C(i,k)/C(n,k) a_k. Source: Farin, ch. 5.
void to_bernstein(std::vector<Rational>& tensor, const std::vector<unsigned>& degrees,
                  std::size_t axis, Budget& budget) {
  const std::size_t n = degrees[axis];
  for_each_line(degrees, axis, [&](std::size_t first, std::size_t stride) {
    std::vector<Rational> line;
    for (std::size_t i = 0; i <= n; ++i) {
      Rational total = 0;
      Rational ratio = 1;
      for (std::size_t k = 0; k <= i; ++k) {
        total += ratio * tensor[first + k * stride];
        if (k < i) ratio *= Rational{i - k, n - k};
      }
      line.push_back(total);
    }
    for (std::size_t i = 0; i <= n; ++i) tensor[first + i * stride] = line[i];
    budget.spend((n + 1) * (n + 1));
  });
}

std::vector<unsigned> degrees_of(const Polynomial& polynomial, const Box& box) {
  std::vector<unsigned> degrees;
  for (const auto& [variable, interval] : box) degrees.push_back(polynomial.degree(variable));
  return degrees;
}

std::size_t words(const Integer& number) {
  return number.is_zero() ? 1 : msb(Integer{abs(number)}) / 64 + 1;
}

}  // namespace

std::size_t bernstein_size(const Polynomial& polynomial, const Box& box) {
  std::size_t size = 1;
  for (const unsigned degree : degrees_of(polynomial, box))
    size = size > (std::size_t{1} << 40) ? size : size * (degree + 1);
  return size;
}

BernsteinForm::BernsteinForm(const Polynomial& polynomial, const Box& box, Budget& budget)
    : degrees_{degrees_of(polynomial, box)} {
  const std::size_t size = bernstein_size(polynomial, box);
  budget.require_terms(size);
  std::map<Variable, Polynomial> to_unit;
  for (const Variable v : polynomial.variables()) {
    const auto& [low, high] = box.at(v);
    to_unit.emplace(v, Polynomial::from_terms({{Monomial{}, low}, {Monomial{v}, high - low}}));
  }
  const Polynomial local = substituted(polynomial, to_unit, budget);
  std::vector<Rational> tensor(size);
  for (const auto& term : local.terms()) {
    std::size_t place = 0;
    std::size_t axis = 0;
    for (const auto& [variable, interval] : box)
      place = place * (degrees_[axis++] + 1) + term.monomial.exponent(variable);
    tensor[place] = term.coefficient;
  }
  for (std::size_t axis = 0; axis < degrees_.size(); ++axis)
    to_bernstein(tensor, degrees_, axis, budget);
  Integer common = 1;
  for (const Rational& entry : tensor) common = lcm(common, Integer{denominator(entry)});
  budget.spend(size * words(common));
  for (const Rational& entry : tensor)
    coefficients_.push_back(Integer{numerator(entry)} * Integer{common / denominator(entry)});
  scale_ = Rational{Integer{1}, common};
  shorten();
}

std::size_t BernsteinForm::corner(unsigned bits) const {
  std::size_t place = 0;
  for (std::size_t axis = 0; axis < degrees_.size(); ++axis)
    place = place * (degrees_[axis] + 1) + ((bits >> axis & 1) != 0 ? degrees_[axis] : 0);
  return place;
}

// Common factors would let the numbers grow with every cut.
void BernsteinForm::shorten() {
  Integer common = 0;
  for (const Integer& c : coefficients_) {
    common = gcd(common, c);
    if (common == 1) return;
  }
  if (common == 0) return;
  for (Integer& c : coefficients_) c /= common;
  scale_ *= Rational{common};
}

std::pair<BernsteinForm, BernsteinForm> BernsteinForm::split(std::size_t axis, const Rational& at,
                                                             Budget& budget) const {
  const Integer from_left{numerator(at)};
  const Integer whole{denominator(at)};
  const Integer from_right = whole - from_left;
  const unsigned n = degrees_[axis];
  std::pair<BernsteinForm, BernsteinForm> parts{*this, *this};
  // After k steps the entries are whole^k times too large; all end up whole^n times too large.
  std::vector<Integer> missing(n + 1, Integer{1});
  for (unsigned k = n; k-- > 0;) missing[k] = missing[k + 1] * whole;
  std::uint64_t work = 0;
  for_each_line(degrees_, axis, [&](std::size_t first, std::size_t stride) {
    std::vector<Integer> line;
    for (unsigned i = 0; i <= n; ++i) line.push_back(coefficients_[first + i * stride]);
    for (unsigned k = 0; k <= n; ++k) {
      parts.first.coefficients_[first + k * stride] = line.front() * missing[k];
      parts.second.coefficients_[first + (n - k) * stride] = line.back() * missing[k];
      work += words(line.front()) + words(missing[k]);
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        line[i] = line[i] * from_right + line[i + 1] * from_left;
      line.pop_back();
    }
    work += std::uint64_t{n + 1} * (n + 1) * words(missing[0]);
  });
  budget.spend(work);
  for (BernsteinForm* part : {&parts.first, &parts.second}) {
    part->scale_ /= Rational{missing[0]};
    part->shorten();
  }
  return parts;
}

Rational BernsteinForm::value(const std::vector<Rational>& local, Budget& budget) const {
  std::vector<Integer> tensor = coefficients_;
  Rational scale = scale_;
  // The first axis is taken away each time, so what is left keeps its order.
  for (std::size_t axis = 0; axis < degrees_.size(); ++axis) {
    const Integer from_left{numerator(local[axis])};
    const Integer whole{denominator(local[axis])};
    const Integer from_right = whole - from_left;
    std::size_t rows = degrees_[axis] + 1;
    const std::size_t width = tensor.size() / rows;
    for (; rows > 1; --rows) {
      for (std::size_t i = 0; i + 1 < rows; ++i)
        for (std::size_t j = 0; j < width; ++j)
          tensor[i * width + j] =
              tensor[i * width + j] * from_right + tensor[(i + 1) * width + j] * from_left;
      budget.spend(rows * width * words(tensor.front()));
      scale /= Rational{whole};
    }
    tensor.resize(width);
  }
  return Rational{tensor.front()} * scale;
}

}  // namespace patchproof
