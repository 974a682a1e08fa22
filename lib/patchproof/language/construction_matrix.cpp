#include <algorithm>

#include <patchproof/language/construction.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

void require_inside(int index, int extent, const Span& span) {
  if (index < 0 || index >= extent)
    throw Fault{span, "index " + std::to_string(index) + " is outside 0.." +
                          std::to_string(extent - 1)};
}

// The type all entries have; the number 0 fits every type.
Type entry_type(const std::vector<Term>& entries) {
  for (const Term& entry : entries)
    if (!is_zero(entry)) return entry.type();
  return Type::scalar();
}

}  // namespace

Term Construction::tuple(const Scope& scope, std::vector<Term> coordinates, const Span& span) {
  constexpr std::size_t most = 9;
  if (coordinates.size() > most) throw Fault{span, "a point has at most 9 coordinates"};
  for (Term& c : coordinates) c = scalar(scope, c, "a coordinate");
  const auto dimension = static_cast<int>(coordinates.size());
  return make(Operation::tuple, Type::point(dimension), std::move(coordinates), {}, span);
}

Term Construction::list(std::vector<Term> entries, const Span& span) {
  const auto count = static_cast<int>(entries.size());
  const Type type = entry_type(entries);
  for (Term& entry : entries) {
    if (is_zero(entry)) entry = zero(type, entry.span());
    if (!(entry.type() == type) || type.is_matrix() || type.is_function())
      throw Fault{entry.span(), "the entries of a list are scalars, or points of one dimension"};
  }
  return make(Operation::matrix, Type::matrix(count, 1, type, true), std::move(entries), {}, span);
}

Term Construction::matrix(const Scope& scope, std::vector<std::vector<Term>> rows,
                          const Span& span) {
  std::vector<Term> entries;
  for (const auto& row : rows)
    for (const Term& entry : row) entries.push_back(decayed(value(scope, entry)));
  const Type type = entry_type(entries);
  for (Term& entry : entries) {
    if (is_zero(entry)) entry = zero(type, entry.span());
    if (type.is_matrix())
      throw Fault{entry.span(), "an entry of a matrix has to be a scalar or a point, not a " +
                                    to_text(type)};
    if (!(entry.type() == type))
      throw Fault{entry.span(),
                  "the entries of a matrix are of one type, and this is a " +
                      to_text(entry.type()) + " beside a " + to_text(type)};
  }
  const auto row_count = static_cast<int>(rows.size());
  const auto columns = static_cast<int>(rows.front().size());
  return make(Operation::matrix, Type::matrix(row_count, columns, type), std::move(entries), {},
              span);
}

Term Construction::component(const Term& point, int index, const Span& span) {
  const Type& type = point.type();
  if (!type.is_point())
    throw Fault{span, "only points have coordinates, this is a " + to_text(type)};
  if (type.dimension == Type::any_dimension)
    throw Fault{span, "the coordinates of a point of any dimension have no names",
                "declare the dimension: 'point P in R^3', 'curve C(u) in R^3'"};
  if (index >= type.dimension)
    throw Fault{span, "a point in R^" + std::to_string(type.dimension) +
                          " has no coordinate '" + std::string(1, "xyz"[index]) + "'"};
  if (point.operation() == Operation::tuple) return point.child(static_cast<std::size_t>(index));
  return make(Operation::component, Type::scalar(), {point}, Indices{index}, span);
}

Term Construction::entry(const Term& matrix, const std::vector<int>& indices, const Span& span) {
  const Type& type = matrix.type();
  if (!type.is_matrix())
    throw Fault{span, "only arrays, nets and matrices have entries, this is a " + to_text(type)};
  const bool one = indices.size() == 1 && (type.list || type.columns == 1 || type.rows == 1);
  if (!one && (type.list || indices.size() != 2))
    throw Fault{span, "a " + to_text(type) + " needs " + (type.list ? "one index" : "two indices")};
  int row = indices.front();
  int column = one ? 0 : indices.back();
  if (one && !type.list && type.columns != 1) std::swap(row, column);
  require_inside(row, type.rows, span);
  require_inside(column, type.columns, span);
  if (matrix.operation() == Operation::matrix)
    return matrix.child(static_cast<std::size_t>(row * type.columns + column));
  return make(Operation::entry, *type.inner, {matrix}, Indices{row, column}, span);
}

Term Construction::slice(const Term& matrix, const std::vector<std::pair<int, int>>& ranges,
                         const Span& span) {
  const Type& type = matrix.type();
  if (!type.is_matrix() || ranges.size() != (type.list ? 1U : 2U))
    throw Fault{span, "a part of a " + to_text(type) + " cannot be taken like this",
                type.is_matrix() ? (type.list ? "as in b[0..1]" : "as in M[0..1, 0..1]") : ""};
  const std::pair<int, int> rows = ranges.front();
  const std::pair<int, int> columns = type.list ? std::pair{0, 0} : ranges.back();
  for (const auto& [first, last] : {rows, columns})
    if (last < first)
      throw Fault{span, "the span " + std::to_string(first) + ".." + std::to_string(last) +
                            " is empty"};
  require_inside(rows.first, type.rows, span);
  require_inside(rows.second, type.rows, span);
  require_inside(columns.first, type.columns, span);
  require_inside(columns.second, type.columns, span);
  const Type part = Type::matrix(rows.second - rows.first + 1, columns.second - columns.first + 1,
                                 *type.inner, type.list);
  if (matrix.operation() != Operation::matrix)
    return make(Operation::slice, part, {matrix},
                Indices{rows.first, rows.second, columns.first, columns.second}, span);
  std::vector<Term> entries;
  for (int i = rows.first; i <= rows.second; ++i)
    for (int j = columns.first; j <= columns.second; ++j)
      entries.push_back(matrix.child(static_cast<std::size_t>(i * type.columns + j)));
  return make(Operation::matrix, part, std::move(entries), {}, span);
}

std::pair<Term, Term> Construction::same_type(const Scope& scope, Term left, Term right,
                                              const Span& span,
                                              std::vector<ParameterRange>& fresh) {
  // A function is compared at its parameters: the declared ones of that name, or new ones.
  const auto at_parameters = [&](const Type& type) {
    std::vector<Term> result;
    for (const std::string& name : type.parameters) {
      const Entity* entity = scope.find(name);
      if (entity != nullptr && entity->kind == Entity::Kind::term &&
          entity->term.operation() == Operation::symbol &&
          entity->term.symbol()->role == Symbol::Role::parameter) {
        result.push_back(entity->term);
        continue;
      }
      const SymbolPointer symbol =
          workshop_.symbol(name, Symbol::Role::parameter, Type::scalar());
      fresh.push_back({symbol, number_term(0, span), number_term(1, span)});
      result.push_back(symbol_term(symbol, span));
    }
    return result;
  };
  const bool left_function = left.type().is_function();
  const bool right_function = right.type().is_function();
  if (left_function && right_function &&
      left.type().parameters.size() != right.type().parameters.size())
    throw Fault{span, "a " + to_text(left.type()) + " is compared with a " + to_text(right.type())};
  if ((left_function && (right_function || is_zero(right))) || (right_function && is_zero(left))) {
    const std::vector<Term> parameters =
        at_parameters(left_function ? left.type() : right.type());
    if (left_function) left = apply(left, parameters, left.span());
    if (right_function) right = apply(right, parameters, right.span());
  }
  left = value(scope, left);
  right = value(scope, right);
  if (!left.type().is_matrix() || !right.type().is_matrix()) {
    left = decayed(left);
    right = decayed(right);
  }
  if (is_zero(left)) left = zero(right.type(), left.span());
  if (is_zero(right)) right = zero(left.type(), right.span());
  const auto as_list = [&](const Term& term) {
    // A control polygon written as one row: [p, q, r].
    const Type& t = term.type();
    if (term.operation() != Operation::matrix || t.list || t.rows != 1) return term;
    return list(term.children(), term.span());
  };
  if (left.type().is_matrix() && right.type().is_matrix() && left.type().list != right.type().list) {
    left = as_list(left);
    right = as_list(right);
  }
  if (!(left.type() == right.type())) {
    const auto any = [](const Type& t) {
      return t.is_point() && t.dimension == Type::any_dimension;
    };
    throw Fault{span,
                "a " + to_text(left.type()) + " is compared with a " + to_text(right.type()),
                any(left.type()) != any(right.type()) && left.type().is_point() &&
                        right.type().is_point()
                    ? "declare the dimension: 'point P in R^3', 'curve C(u) in R^3'"
                    : ""};
  }
  return {left, right};
}

}  // namespace patchproof
