#include <patchproof/algebra/sign_over_box.hpp>

#include <algorithm>
#include <deque>

#include <patchproof/algebra/corner_chart.hpp>
#include <patchproof/algebra/odd_part.hpp>
#include <patchproof/algebra/simplest_between.hpp>
#include <patchproof/algebra/squares.hpp>

namespace patchproof {

namespace {

constexpr unsigned deepest = 44;
constexpr unsigned most_charts = 3;
constexpr std::size_t most_coefficients_kept = 400'000;

// One box of the tree.
struct Part {
  BernsteinForm form;
  std::vector<Interval> sides;
  std::vector<unsigned> cuts;  // along each axis
  unsigned depth = 0;
  unsigned zero_age = 0;  // how many cuts ago a corner with a zero was seen first
};

Rational between(const Interval& side, const Rational& local) {
  return side.low + (side.high - side.low) * local;
}

class Search {
 public:
  Search(const Polynomial& polynomial, const Box& box, bool strict, std::size_t boxes,
         unsigned charts, Budget& budget)
      : strict_{strict}, boxes_{boxes}, charts_{charts}, budget_{budget} {
    std::vector<Interval> sides;
    for (const auto& [variable, interval] : box) {
      variables_.push_back(variable);
      sides.push_back(interval);
    }
    const std::vector<unsigned> cuts(sides.size(), 0);
    waiting_.push_back({BernsteinForm{polynomial, box, budget}, sides, cuts});
  }

  BoxSign run() {
    while (!waiting_.empty()) {
      const Part part = std::move(waiting_.front());
      waiting_.pop_front();
      budget_.spend(part.form.coefficients().size());
      result_.tree.depth = std::max(result_.tree.depth, part.depth);
      if (look_at(part)) continue;
      if (result_.answer == BoxSign::Answer::fails) return result_;
      ++result_.tree.boxes;
      if (result_.point.empty()) keep_point(part, std::vector<Rational>(variables_.size(), half_));
      open_ = true;
      if (result_.tree.boxes + waiting_.size() >= boxes_) return result_;
    }
    if (!open_) result_.answer = BoxSign::Answer::shown;
    return result_;
  }

 private:
  bool wrong(const Integer& value) const { return strict_ ? value <= 0 : value < 0; }

  // True when the part is dealt with; false when it fails, or nothing can be said of it.
  bool look_at(const Part& part) {
    const auto& all = part.form.coefficients();
    if (std::none_of(all.begin(), all.end(), [&](const Integer& c) { return wrong(c); })) {
      ++result_.tree.boxes;
      return true;
    }
    const auto corners = 1U << variables_.size();
    std::optional<unsigned> zero;
    for (unsigned bits = 0; bits < corners; ++bits) {
      const Integer& value = all[part.form.corner(bits)];
      if (wrong(value)) return fails(part, corner_place(bits));
      if (value == 0) zero = bits;
    }
    if (part.depth >= deepest || result_.tree.boxes + waiting_.size() + 1 >= boxes_) return false;
    if (zero && part.zero_age >= 2 * variables_.size()) return blow_up(part, *zero);
    const unsigned zero_age = zero ? part.zero_age + 1 : 0;
    if (part.depth % variables_.size() == 0) {
      for (const std::vector<Rational>& place : simple_places(part)) {
        const Rational value = part.form.value(place, budget_);
        if (value < 0 || (strict_ && value == 0)) return fails(part, place);
        if (value == 0) return cut_at(part, place, zero_age);
      }
    }
    cut(part, axis_to_cut(part), half_, zero_age, waiting_);
    return true;
  }

  std::vector<Rational> corner_place(unsigned bits) const {
    std::vector<Rational> place;
    for (std::size_t k = 0; k < variables_.size(); ++k) place.emplace_back(bits >> k & 1U);
    return place;
  }

  void keep_point(const Part& part, const std::vector<Rational>& place) {
    for (std::size_t k = 0; k < variables_.size(); ++k)
      result_.point[variables_[k]] = between(part.sides[k], place[k]);
    result_.value = part.form.value(place, budget_);
  }

  bool fails(const Part& part, const std::vector<Rational>& place) {
    keep_point(part, place);
    result_.answer = BoxSign::Answer::fails;
    return false;
  }

  // Local places with simple coordinates, inside the box and inside its faces: a zero the textbook
  // speaks of is a simple fraction.
  std::vector<std::vector<Rational>> simple_places(const Part& part) const {
    std::vector<std::vector<Rational>> places{{}};
    for (const Interval& side : part.sides) {
      std::vector<Rational> along;
      if (const auto inner = simplest_between(side.low, true, side.high, true))
        along.push_back((*inner - side.low) / (side.high - side.low));
      if (variables_.size() <= 3 || along.empty())
        along.insert(along.end(), {Rational{0}, Rational{1}});
      std::vector<std::vector<Rational>> longer;
      for (const auto& place : places)
        for (const Rational& next : along) {
          longer.push_back(place);
          longer.back().push_back(next);
        }
      places = std::move(longer);
    }
    std::erase_if(places, [](const std::vector<Rational>& place) {
      return std::all_of(place.begin(), place.end(),
                         [](const Rational& at) { return at == 0 || at == 1; });
    });
    return places;
  }

  // The axis that was cut least often; a point has no middle.
  std::size_t axis_to_cut(const Part& part) const {
    std::size_t best = 0;
    const auto rank = [&](std::size_t k) {
      return std::tuple{part.form.degrees()[k] == 0, part.sides[k].low == part.sides[k].high,
                        part.cuts[k]};
    };
    for (std::size_t k = 1; k < variables_.size(); ++k)
      if (rank(k) < rank(best)) best = k;
    return best;
  }

  void cut(const Part& part, std::size_t axis, const Rational& at, unsigned zero_age,
           std::deque<Part>& to) {
    auto [low, high] = part.form.split(axis, at, budget_);
    const Rational middle = between(part.sides[axis], at);
    for (const bool upper : {false, true}) {
      Part next{std::move(upper ? high : low), part.sides, part.cuts, part.depth + 1, zero_age};
      (upper ? next.sides[axis].low : next.sides[axis].high) = middle;
      ++next.cuts[axis];
      to.push_back(std::move(next));
    }
  }

  // Cuts every axis at the place, so that it becomes a corner.
  bool cut_at(const Part& part, const std::vector<Rational>& place, unsigned zero_age) {
    std::deque<Part> parts{part};
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      if (place[axis] == 0 || place[axis] == 1) continue;
      std::deque<Part> finer;
      for (const Part& p : parts) cut(p, axis, place[axis], zero_age, finer);
      parts = std::move(finer);
    }
    for (Part& p : parts) waiting_.push_back(std::move(p));
    return true;
  }

  bool blow_up(const Part& part, unsigned corner) {
    if (charts_ == 0) return false;
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      const CornerChart chart{part.form, corner, k, budget_};
      Box unit;
      for (std::size_t j = 0; j < variables_.size(); ++j) unit[static_cast<Variable>(j)] = {0, 1};
      const std::size_t left = boxes_ - std::min(boxes_, result_.tree.boxes + waiting_.size());
      const BoxSign inner =
          Search{chart.polynomial(), unit, false, left, charts_ - 1, budget_}.run();
      result_.tree.boxes += inner.tree.boxes;
      result_.tree.depth = std::max(result_.tree.depth, part.depth + inner.tree.depth);
      if (inner.answer == BoxSign::Answer::open) return false;
      if (inner.answer == BoxSign::Answer::fails)
        return fails(part, chart.place(inner.point, budget_));
    }
    return true;
  }

  const Rational half_{1, 2};
  bool strict_;
  std::size_t boxes_;
  unsigned charts_;
  Budget& budget_;
  std::vector<Variable> variables_;
  std::deque<Part> waiting_;
  BoxSign result_;
  bool open_ = false;
};

Rational value_at(const Polynomial& polynomial, Variable variable, const Rational& at,
                  Budget& budget) {
  return substituted(polynomial, {{variable, Polynomial{at}}}, budget).constant();
}

// In one variable zeros of even order at irrational places can be taken away: without them the
// sign is the same everywhere else, and no zero is left that subdivision does not come to an end
// at.
BoxSign sign_without_even_zeros(const Polynomial& polynomial, const Box& box, Budget& budget) {
  const auto& [variable, side] = *box.begin();
  const Polynomial odd = odd_part(polynomial, variable, budget);
  // Checked, not trusted: what was taken away is a square.
  const std::optional<Polynomial> rest = quotient(polynomial, odd, budget);
  if (!rest || !square_root(*rest, budget)) return {};
  if (odd.is_constant() && odd.constant() > 0)
    return {BoxSign::Answer::shown, {1, 0}, {}, odd.constant()};
  BoxSign result = Search{odd, box, false, most_boxes, most_charts, budget}.run();
  if (result.answer != BoxSign::Answer::fails) return result;
  // An even zero exactly there hides the sign: it shows beside it.
  const Rational& found = result.point[variable];
  Rational at = found;
  for (Rational step = side.high - side.low; value_at(polynomial, variable, at, budget) >= 0;) {
    step = -step / 2;
    const Rational moved = found + step;
    if (side.low <= moved && moved <= side.high) at = moved;
    // Both sides are tried at each distance, as the signs of the steps alternate.
    const Rational other = found - step;
    if (side.low <= other && other <= side.high &&
        value_at(polynomial, variable, other, budget) < 0)
      at = other;
  }
  result.point[variable] = at;
  result.value = value_at(polynomial, variable, at, budget);
  return result;
}

}  // namespace

void Subdivision::add(const Subdivision& other) {
  boxes += other.boxes;
  depth = std::max(depth, other.depth);
}

BoxSign sign_over_box(const Polynomial& polynomial, const Box& box, bool strict, Budget& budget) {
  // A side that is a point is a value.
  std::map<Variable, Polynomial> values;
  for (const Variable v : polynomial.variables())
    if (box.at(v).low == box.at(v).high) values.emplace(v, Polynomial{box.at(v).low});
  const Polynomial moving = substituted(polynomial, values, budget);
  Box needed;
  for (const Variable v : moving.variables()) needed.emplace(v, box.at(v));
  BoxSign result;
  if (needed.size() > most_box_variables) return result;
  if (needed.empty()) {
    result.value = moving.constant();
    const bool wrong = strict ? result.value <= 0 : result.value < 0;
    result.answer = wrong ? BoxSign::Answer::fails : BoxSign::Answer::shown;
  } else {
    // Large tensors get fewer boxes, as all that wait are kept.
    const std::size_t fitting = most_coefficients_kept / bernstein_size(moving, needed);
    const bool try_odd_part = needed.size() == 1 && !strict;
    const std::size_t boxes = try_odd_part ? 64 : std::clamp<std::size_t>(fitting, 16, most_boxes);
    result = Search{moving, needed, strict, boxes, most_charts, budget}.run();
    if (result.answer == BoxSign::Answer::open && try_odd_part)
      result = sign_without_even_zeros(moving, needed, budget);
  }
  for (const auto& [variable, value] : values) result.point[variable] = value.constant();
  return result;
}

}  // namespace patchproof
