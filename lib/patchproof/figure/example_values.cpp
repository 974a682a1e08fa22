#include <patchproof/figure/example_values.hpp>

#include <algorithm>
#include <set>

namespace patchproof {

namespace {

// The height of a surface over the square [0,1] x [0,1]: a saddle on a dome, with all corners
// different, so that twists and orientation can be seen.
Rational height(const Rational& s, const Rational& t, int number) {
  const Rational dome = s * (1 - s) + t * (1 - t);
  const Rational slope = s * t / 3 - s / 4 + t * (1 - s) * Rational{2, 5};
  return number % 2 == 0 ? Rational{dome * Rational{9, 10} + slope}
                         : Rational{dome * Rational{1, 2} - slope + s * s * t / 2};
}

Rational part_of(int index, int count) {
  return count < 2 ? Rational{0} : Rational{index, count - 1};
}

Point net_point(int i, int j, int rows, int columns, int number) {
  const int size = std::max({rows, columns, 2}) - 1;
  // Nets that follow each other lie side by side, as for a joint at v = 1.
  return {Rational{i}, Rational{j + number * std::max(columns - 1, 1)},
          Rational{size * height(part_of(i, rows), part_of(j, columns), number)}};
}

Point polygon_point(int i, int count, int number) {
  static const std::vector<Rational> heights{0, {7, 5}, {8, 5}, {1, 5}, {-1, 2}, {3, 5}, {4, 5}};
  const Rational bulge = part_of(i, count) * (1 - part_of(i, count));
  return {Rational{i + number * std::max(count - 1, 1)}, Rational{-bulge * count / 4},
          heights[static_cast<std::size_t>(i + number) % heights.size()]};
}

// Corner, tangent or twist of a Hermite matrix in the order value 0, value 1, slope 0, slope 1.
Point hermite_vector(int i, int j, int number) {
  const int s = i % 2;
  const int t = j % 2;
  const Rational sign_s{1 - 2 * s};
  const Rational sign_t{1 - 2 * t};
  if (i < 2 && j < 2) return {s, t + number, Rational{s + 2 * t, 8} - Rational{s * t, 4}};
  if (j < 2) return {1, 0, sign_s * Rational{3 + t, 5}};
  if (i < 2) return {0, 1, sign_t * Rational{2 + s, 5}};
  return {0, 0, Rational{1 + s - 2 * t, 2}};
}

Point single_point(int number) {
  static const std::vector<Point> points{
      Point{0, 0, {1, 5}}, Point{1, 0, 0},      Point{0, 1, 0},      Point{1, 1, {3, 5}},
      Point{2, 0, {1, 3}}, Point{2, 1, {2, 3}}, Point{0, 2, {1, 4}}, Point{1, 2, {3, 4}}};
  return points[static_cast<std::size_t>(number) % points.size()];
}

Polynomial of(const Rational& number) { return Polynomial{number}; }

}  // namespace

std::vector<int> indices_of(const std::string& name) {
  std::vector<int> result;
  const std::size_t bracket = name.find('[');
  if (bracket == std::string::npos) return result;
  for (std::size_t k = bracket; k + 1 < name.size();) {
    const std::size_t end = name.find_first_of(",]", k + 1);
    const std::string digits = name.substr(k + 1, end - k - 1);
    if (digits.empty() || digits.size() > 6 ||
        digits.find_first_not_of("0123456789") != std::string::npos)
      return {};
    result.push_back(std::stoi(digits));
    k = end;
  }
  return result;
}

std::string base_of(const std::string& name) { return name.substr(0, name.find('[')); }

ExampleValues::ExampleValues(const std::vector<SymbolPointer>& symbols,
                             const std::vector<Term>& terms) {
  std::map<std::string, std::vector<int>> extents;
  for (const SymbolPointer& symbol : symbols) {
    const std::vector<int> indices = indices_of(symbol->name);
    std::vector<int>& extent = extents[base_of(symbol->name)];
    extent.resize(std::max(extent.size(), indices.size()), 1);
    for (std::size_t k = 0; k < indices.size(); ++k)
      extent[k] = std::max(extent[k], indices[k] + 1);
  }
  // Numbers are given in the order of declaration, arrays have one as a whole.
  std::map<std::string, int> counts;
  std::map<std::string, int> numbers;
  for (const SymbolPointer& symbol : symbols) {
    const std::string base = base_of(symbol->name);
    Part part;
    part.indices = indices_of(symbol->name);
    part.extents = extents[base];
    std::string sort = symbol->type.is_point()           ? "point"
                       : symbol->type.is_scalar()        ? "scalar"
                       : symbol->type.inner->is_scalar() ? "scalar of"
                                                         : "point of";
    for (const std::string& parameter : symbol->type.parameters) sort += " " + parameter;
    sort += std::to_string(part.indices.size());
    const auto known = numbers.find(base);
    if (known == numbers.end() || part.indices.empty()) numbers[base] = counts[sort]++;
    part.number = numbers[base];
    parts_.emplace(symbol->ordinal, std::move(part));
  }
  for (const Term& term : terms) find_uses(term);
}

void ExampleValues::note_matrix(const Term& matrix, const std::string& use) {
  if (!matrix.type().is_matrix() || matrix.operation() != Operation::matrix) return;
  for (std::size_t k = 0; k < matrix.children().size(); ++k) {
    if (matrix.child(k).operation() != Operation::symbol) continue;
    const auto part = parts_.find(matrix.child(k).symbol()->ordinal);
    if (part == parts_.end() || !part->second.use.empty()) continue;
    part->second.use = use;
    const int column_count = matrix.type().columns;
    part->second.indices = {static_cast<int>(k) / column_count, static_cast<int>(k) % column_count};
  }
}

void ExampleValues::find_uses(const Term& term) {
  std::set<const TermNode*> seen;
  std::vector<Term> open{term};
  while (!open.empty()) {
    const Term next = open.back();
    open.pop_back();
    if (!seen.insert(next.address()).second) continue;
    if (next.operation() == Operation::definition) {
      if (next.name() == "bicubic_hermite") note_matrix(next.child(1), "hermite");
      if (next.name() == "ferguson") {
        note_matrix(next.child(1), "hermite");
        note_matrix(next.child(2), "ferguson_u");
        note_matrix(next.child(3), "ferguson_v");
      }
    }
    open.insert(open.end(), next.children().rbegin(), next.children().rend());
  }
}

Point ExampleValues::constant(const SymbolPointer& symbol) const {
  const auto found = parts_.find(symbol->ordinal);
  const Part part = found == parts_.end() ? Part{} : found->second;
  if (symbol->type.is_scalar()) {
    if (part.indices.empty()) return {Rational{part.number + 1, 2}, 0, 0};
    // Knots increase.
    if (part.indices.size() == 1) return {Rational{part.indices[0] + 1, part.extents[0]}, 0, 0};
    int pattern = part.number;
    for (std::size_t k = 0; k < part.indices.size(); ++k)
      pattern += (static_cast<int>(k) + 1) * part.indices[k];
    return {Rational{2 + pattern % 3, 2}, 0, 0};
  }
  if (part.use == "hermite") return hermite_vector(part.indices[0], part.indices[1], part.number);
  if (part.use == "ferguson_u") return hermite_vector(part.indices[0] + 2, part.indices[1], 0);
  if (part.use == "ferguson_v") return hermite_vector(part.indices[0], part.indices[1] + 2, 0);
  if (part.indices.size() >= 2)
    return net_point(part.indices[0], part.indices[1], part.extents[0], part.extents[1],
                     part.number);
  if (part.indices.size() == 1) return polygon_point(part.indices[0], part.extents[0], part.number);
  // P01 is the point of u = 0, v = 1.
  const std::string& name = symbol->name;
  const auto digit = [&](std::size_t from_end) {
    const char letter = name.size() > from_end ? name[name.size() - from_end] : ' ';
    return letter == '0' || letter == '1' ? letter - '0' : -1;
  };
  if (name.size() > 2 && digit(1) >= 0 && digit(2) >= 0)
    return single_point(digit(2) + 2 * digit(1));
  return single_point(part.number);
}

std::array<Polynomial, 3> ExampleValues::function(const SymbolPointer& symbol,
                                                  const std::vector<Variable>& variables,
                                                  Budget& budget) const {
  const auto found = parts_.find(symbol->ordinal);
  const int number = found == parts_.end() ? 0 : found->second.number;
  const auto times = [&](const Polynomial& a, const Polynomial& b) {
    return product(a, b, budget);
  };
  const auto plus = [&](const Polynomial& a, const Polynomial& b) { return sum(a, b, budget); };
  const auto one_minus = [&](const Polynomial& a) { return difference(of(1), a, budget); };
  const Polynomial s = Polynomial::variable(variables.front());
  const Polynomial bump = times(s, one_minus(s));
  if (variables.size() == 1 && symbol->type.inner->is_scalar()) {
    // The cubic blending functions: 1 - 3s^2 + 2s^3 and what it lacks to 1.
    const Polynomial rise = plus(scaled(power(s, 2, budget), 3), scaled(power(s, 3, budget), -2));
    return {number % 2 == 0 ? one_minus(rise) : rise, of(0), of(0)};
  }
  if (variables.size() == 1) {
    const std::string& parameter = symbol->type.parameters.front();
    const bool across = parameter == "v";
    // Third and later ones are taken for derivatives across an edge.
    if (number >= 2) {
      const Polynomial rise =
          plus(of({1, 4}), scaled(s, number % 2 == 0 ? Rational{1, 4} : Rational{-1, 3}));
      if (across) return {of(1), of(0), rise};
      return {of(0), of(1), rise};
    }
    // The edges of a patch: corners at the heights 0, 1/5 (u), 1/3 (v), 1/10 (both).
    const Rational first = number == 0 ? Rational{0} : across ? Rational{1, 5} : Rational{1, 3};
    const Rational last = number == 1 ? Rational{1, 10} : across ? Rational{1, 3} : Rational{1, 5};
    const Rational swing =
        across ? Rational{number == 0 ? 4 : 5, 5} : Rational{number == 0 ? 6 : 3, 5};
    const Polynomial tilted =
        times(bump, plus(of(number == 0 ? Rational{1} : Rational{1, 2}),
                         scaled(s, number == 0 ? Rational{-1, 2} : Rational{1, 2})));
    const Polynomial z = plus(plus(of(first), scaled(s, last - first)), scaled(tilted, swing));
    const Polynomial bulge = plus(of(number), scaled(bump, Rational{2 * number - 1, 4}));
    if (across) return {bulge, s, z};
    return {s, bulge, z};
  }
  const Polynomial t = Polynomial::variable(variables[1]);
  const Polynomial dome = plus(bump, scaled(times(t, one_minus(t)), Rational{3, 4}));
  const Polynomial slope = scaled(times(s, t), number % 2 == 0 ? Rational{1, 2} : Rational{-1, 2});
  const Polynomial wave = scaled(times(times(bump, t), s), number % 2 == 0 ? 1 : -2);
  const Polynomial z = plus(plus(dome, slope), wave);
  if (symbol->type.inner->is_scalar()) return {z, of(0), of(0)};
  return {s, t, z};
}

}  // namespace patchproof
