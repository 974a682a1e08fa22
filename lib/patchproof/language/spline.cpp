#include <patchproof/language/spline.hpp>

#include <algorithm>

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

namespace {

void require_continuous(const std::vector<int>& spans, int degree, const Span& span) {
  for (std::size_t k = 1; k < spans.size(); ++k)
    if (spans[k] - spans[k - 1] > degree)
      throw Fault{span,
                  "this spline is not continuous: an inner knot has a multiplicity above "
                  "the degree"};
}

}  // namespace

ControlNet::ControlNet(const Spline& spline, Elaborator& elaborator, const Span& span)
    : elaborator_{elaborator},
      arithmetic_{elaborator.construct(), span},
      span_{span},
      list_{spline.control_points.type().list},
      given_{spline.control_points} {
  const Type& type = spline.control_points.type();
  for (int i = 0; i < type.rows; ++i) {
    points_.emplace_back();
    if (spline.weights) weights_.emplace_back();
    for (int j = 0; j < type.columns; ++j) {
      const std::vector<int> index = list_ ? std::vector<int>{i} : std::vector<int>{i, j};
      const Term point = elaborator.construct().entry(spline.control_points, index, span);
      if (!spline.weights) {
        points_.back().push_back(point);
        continue;
      }
      const Term weight = elaborator.construct().entry(spline.weights, index, span);
      weights_.back().push_back(weight);
      points_.back().push_back(
          elaborator.construct().product(Scope{}, {weight, point}, "**", span));
    }
  }
}

void ControlNet::combine(std::size_t direction, const Factors& factors) {
  changed_ = true;
  for (auto* net : {&points_, &weights_}) {
    if (net->empty()) continue;
    std::vector<std::vector<Term>> result;
    if (direction == 1) {
      for (const auto& row : *net) {
        result.emplace_back();
        for (const auto& f : factors) result.back().push_back(arithmetic_.combination(f, row));
      }
    } else {
      for (const auto& f : factors) {
        result.emplace_back();
        for (std::size_t j = 0; j < net->front().size(); ++j) {
          std::vector<Term> column;
          for (const auto& row : *net) column.push_back(row[j]);
          result.back().push_back(arithmetic_.combination(f, column));
        }
      }
    }
    *net = std::move(result);
  }
}

Term ControlNet::shaped(std::vector<std::vector<Term>> entries) {
  if (!list_) return elaborator_.construct().matrix(Scope{}, std::move(entries), span_);
  std::vector<Term> list;
  for (const auto& row : entries) list.push_back(row.front());
  return elaborator_.construct().list(std::move(list), span_);
}

Term ControlNet::points() {
  if (!changed_) return given_;
  if (weights_.empty()) return shaped(points_);
  std::vector<std::vector<Term>> quotients = points_;
  for (std::size_t i = 0; i < quotients.size(); ++i) {
    for (std::size_t j = 0; j < quotients[i].size(); ++j) {
      if (is_zero(weights_[i][j]))
        throw Fault{span_, "one of these points has the weight 0: it is a direction, not a point"};
      quotients[i][j] = arithmetic_.ratio(quotients[i][j], weights_[i][j]);
    }
  }
  return shaped(std::move(quotients));
}

Term ControlNet::weights() { return weights_.empty() ? Term{} : shaped(weights_); }

Factors bezier_factors(const Knots& knots, int degree, Elaborator& elaborator, const Span& span) {
  const auto points = knots.size() - static_cast<std::size_t>(degree) - 1;
  const std::vector<int> spans = spans_of(knots, degree);
  require_continuous(spans, degree, span);
  Factors rows;
  for (const int k : spans) {
    const Term& a = knots[static_cast<std::size_t>(k)];
    const Term& b = knots[static_cast<std::size_t>(k) + 1];
    for (int i = rows.empty() ? 0 : 1; i <= degree; ++i) {
      std::vector<Term> arguments(static_cast<std::size_t>(degree - i), a);
      arguments.insert(arguments.end(), static_cast<std::size_t>(i), b);
      const std::vector<Term> factors =
          blossom(knots, degree, k, arguments, elaborator.workshop(), elaborator.construct(), span);
      rows.emplace_back(points, number_term(0, span));
      std::copy(factors.begin(), factors.end(), rows.back().begin() + (k - degree));
    }
  }
  return rows;
}

std::size_t piece_for_point(const std::vector<int>& values, const std::vector<int>& starts,
                            int degree, int i) {
  const auto value = [&](int k) { return values[static_cast<std::size_t>(k)]; };
  std::size_t best = 0;
  long most = -1;
  for (std::size_t piece = 0; piece < starts.size(); ++piece) {
    const int start = starts[piece];
    if (start < value(i) || start + 1 > value(i + degree + 1)) continue;
    const auto first = values.begin() + i + 1;
    const long ends =
        std::count_if(first, first + degree, [&](int v) { return v == start || v == start + 1; });
    if (ends <= most) continue;
    most = ends;
    best = piece;
  }
  return best;
}

Factors control_factors(const Knots& knots, int degree, Elaborator& elaborator, const Span& span) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int points = static_cast<int>(knots.size()) - degree - 1;
  const std::vector<int> values = values_of(knots);
  const std::vector<int> spans = spans_of(knots, degree);
  require_continuous(spans, degree, span);
  std::vector<int> starts;
  for (const int k : spans) starts.push_back(values[at(k)]);
  Factors rows;
  for (int i = 0; i < points; ++i) {
    const std::size_t piece = piece_for_point(values, starts, degree, i);
    const int k = spans[piece];
    Knots ends(at(degree) + 1, knots[at(k)]);
    ends.insert(ends.end(), at(degree) + 1, knots[at(k) + 1]);
    const std::vector<Term> arguments(knots.begin() + i + 1, knots.begin() + i + 1 + degree);
    const std::vector<Term> factors = blossom(ends, degree, degree, arguments,
                                              elaborator.workshop(), elaborator.construct(), span);
    rows.emplace_back(spans.size() * at(degree) + 1, number_term(0, span));
    std::copy(factors.begin(), factors.end(),
              rows.back().begin() + static_cast<std::ptrdiff_t>(piece) * degree);
  }
  return rows;
}

}  // namespace patchproof
