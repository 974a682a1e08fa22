#include <patchproof/term/type.hpp>

#include <utility>

namespace patchproof {

namespace {

bool same_inner(const Type& a, const Type& b) {
  if (!a.inner || !b.inner) return a.inner == b.inner;
  return a.inner == b.inner || *a.inner == *b.inner;
}

std::string dimension_suffix(const Type& point) {
  if (point.dimension == Type::any_dimension) return "";
  return " in R^" + std::to_string(point.dimension);
}

// "4 points in R^3", "1 scalar": what a matrix or list is made of.
std::string entries_text(const Type& entry, bool plural) {
  const std::string ending = plural ? "s" : "";
  switch (entry.kind) {
    case Type::Kind::scalar:
      return "scalar" + ending;
    case Type::Kind::point:
      return "point" + ending + dimension_suffix(entry);
    case Type::Kind::matrix:
      return plural ? "matrices" : "matrix";
    case Type::Kind::function:
      return "function" + ending;
  }
  return "";
}

std::string matrix_text(const Type& type) {
  const Type entry = type.inner ? *type.inner : Type::scalar();
  if (type.list) {
    return "list of " + std::to_string(type.rows) + " " + entries_text(entry, type.rows != 1);
  }
  return std::to_string(type.rows) + " x " + std::to_string(type.columns) + " matrix of " +
         entries_text(entry, type.rows != 1 || type.columns != 1);
}

std::string function_text(const Type& type) {
  std::string arguments;
  for (const std::string& name : type.parameters) {
    arguments += (arguments.empty() ? "" : ", ") + name;
  }
  arguments = "(" + arguments + ")";
  const std::size_t count = type.parameters.size();
  if (!type.inner || count < 1 || count > 3) return "function" + arguments;
  if (type.inner->is_scalar()) return "scalar function" + arguments;
  if (type.inner->is_matrix()) return "matrix function" + arguments;
  if (type.inner->is_function()) return "function" + arguments;
  return (count == 1 ? "curve" : count == 2 ? "patch" : "volume") + arguments;
}

}  // namespace

Type Type::scalar() { return Type{}; }

Type Type::point(int dimension) {
  Type type;
  type.kind = Kind::point;
  type.dimension = dimension;
  return type;
}

Type Type::matrix(int rows, int columns, const Type& entry, bool list) {
  Type type;
  type.kind = Kind::matrix;
  type.rows = rows;
  type.columns = columns;
  type.list = list;
  type.inner = std::make_shared<const Type>(entry);
  return type;
}

Type Type::function(std::vector<std::string> parameters, const Type& value) {
  Type type;
  type.kind = Kind::function;
  type.parameters = std::move(parameters);
  type.inner = std::make_shared<const Type>(value);
  return type;
}

std::size_t Type::component_count() const {
  switch (kind) {
    case Kind::scalar:
      return 1;
    case Kind::point:
      return dimension == any_dimension ? 1 : static_cast<std::size_t>(dimension);
    case Kind::matrix:
      return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) *
             (inner ? inner->component_count() : 1);
    case Kind::function:
      return inner ? inner->component_count() : 1;
  }
  return 1;
}

bool operator==(const Type& a, const Type& b) {
  return a.kind == b.kind && a.dimension == b.dimension && a.rows == b.rows &&
         a.columns == b.columns && a.parameters.size() == b.parameters.size() && same_inner(a, b);
}

std::string to_text(const Type& type) {
  switch (type.kind) {
    case Type::Kind::scalar:
      return "scalar";
    case Type::Kind::point:
      return "point" + dimension_suffix(type);
    case Type::Kind::matrix:
      return matrix_text(type);
    case Type::Kind::function:
      return function_text(type);
  }
  return "";
}

}  // namespace patchproof
