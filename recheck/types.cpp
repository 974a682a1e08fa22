#include <recheck/types.hpp>

#include <algorithm>
#include <set>

namespace recheck {

Type product_type(const Type& a, const Type& b) {
  Type result = a.has_points() ? a : b;
  result.rows = a.rows;
  result.columns = b.columns;
  return result;
}

namespace {

void require(bool good, const char* what) {
  if (!good) throw WrongType{what};
}

/// The rules of one node, one function for each sort of operations.
class Typing {
 public:
  Typing(const Node& node, const std::vector<Node>& nodes, const std::vector<Symbol>& symbols,
         const Limits& limits)
      : node_{node}, nodes_{nodes}, symbols_{symbols}, limits_{limits} {}

  Type type() const {
    switch (node_.operation) {
      case Operation::number:
      case Operation::pi:
        return leaf(Type{});
      case Operation::symbol:
        return leaf(symbols_.at(node_.symbol).type);
      case Operation::tuple:
        return tuple();
      case Operation::matrix:
        return matrix();
      case Operation::sum:
        return sum();
      case Operation::product:
        return product();
      case Operation::negation:
        require_count(1);
        return value(0);
      case Operation::quotient:
        require_count(2);
        require_scalar(1);
        return value(0);
      case Operation::lambda:
        return lambda();
      case Operation::apply:
        return apply();
      case Operation::derivative:
        return derivative();
      case Operation::integral:
        return integral();
      case Operation::definition:
        require(count() > 0, "a definition without expansion");
        return of(0);
      case Operation::component:
        return component();
      case Operation::entry:
        return part(true);
      case Operation::slice:
        return part(false);
      case Operation::transpose:
        return transpose();
      case Operation::matrix_product:
        return matrix_product();
      case Operation::determinant:
        return determinant();
      case Operation::dot:
        require_points(false);
        return Type{};
      case Operation::cross:
        require_points(true);
        return of(0);
      case Operation::bspline_basis:
        require_knots();
        return scalar();
      case Operation::bernstein:
        require(node_.indices[0] <= limits_.order, "a degree too large");
        return scalar();
      default:
        return scalar();  // powers, square roots, sines, cosines, exponentials
    }
  }

 private:
  std::size_t count() const { return node_.children.size(); }
  const Type& of(std::size_t child) const { return nodes_[node_.children[child]].type; }

  void require_count(std::size_t wanted) const {
    require(count() == wanted, "a wrong number of children");
  }
  void require_scalar(std::size_t child) const {
    require(of(child).is_scalar(), "a scalar is needed here");
  }
  void require_matrix(std::size_t child) const {
    require(value(child).kind == Type::Kind::matrix, "a matrix is needed here");
  }
  const Type& value(std::size_t child) const {
    require(!of(child).is_function(), "a function is no value");
    return of(child);
  }
  const Type& function() const {
    require(count() > 0 && of(0).is_function(), "a function is needed here");
    return of(0);
  }

  Type leaf(const Type& type) const {
    require_count(0);
    return type;
  }

  Type scalar() const {
    require_count(1);
    require_scalar(0);
    return Type{};
  }

  Type tuple() const {
    require(count() > 0 && count() <= limits_.extent, "a wrong number of children");
    for (std::size_t k = 0; k < count(); ++k) require_scalar(k);
    Type result;
    result.kind = Type::Kind::point;
    result.any = node_.type.any;
    require(!result.any || count() == 1, "a point of any dimension has one coordinate");
    if (!result.any) result.dimension = count();
    return result;
  }

  Type matrix() const {
    require_count(node_.type.rows * node_.type.columns);
    require(count() > 0, "a matrix without entries");
    for (std::size_t k = 0; k < count(); ++k)
      require(value(k) == value(0) && value(k).kind != Type::Kind::matrix,
              "the entries of a matrix are scalars or points, all of one type");
    return checked(node_.type.rows, node_.type.columns, of(0));
  }

  Type checked(std::size_t rows, std::size_t columns, Type entry) const {
    entry.kind = Type::Kind::matrix;
    entry.rows = rows;
    entry.columns = columns;
    require(rows <= limits_.extent && columns <= limits_.extent &&
                entry.component_count() <= limits_.extent,
            "a matrix that is too large");
    return entry;
  }

  Type sum() const {
    require(count() >= 2, "a wrong number of children");
    for (std::size_t k = 0; k < count(); ++k)
      require(value(k) == value(0), "summands of different types");
    return of(0);
  }

  Type product() const {
    require(count() >= 1, "a wrong number of children");
    Type result;
    for (std::size_t k = 0; k < count(); ++k) {
      require(value(k).is_scalar() || result.is_scalar(), "two factors that are no scalars");
      if (!of(k).is_scalar()) result = of(k);
    }
    return result;
  }

  Type lambda() const {
    require_count(1);
    Type result = value(0);
    result.arguments = node_.formals.size();
    require(result.arguments > 0 && result.arguments <= limits_.extent,
            "a wrong number of formal parameters");
    const std::set<SymbolIndex> different(node_.formals.begin(), node_.formals.end());
    require(different.size() == node_.formals.size(), "a formal parameter twice");
    for (const SymbolIndex formal : node_.formals) {
      const Symbol::Role role = symbols_.at(formal).role;
      require(role == Symbol::Role::bound || role == Symbol::Role::parameter,
              "a formal parameter has the role 'bound' or 'parameter'");
    }
    return result;
  }

  Type apply() const {
    Type result = function();
    require_count(1 + result.arguments);
    for (std::size_t k = 1; k < count(); ++k) require_scalar(k);
    result.arguments = 0;
    return result;
  }

  Type derivative() const {
    const Type& result = function();
    require_count(1);
    require(node_.indices.size() == result.arguments,
            "a derivative needs an order for each argument");
    for (const std::size_t order : node_.indices)
      require(order <= limits_.order, "an order too large");
    return result;
  }

  Type integral() const {
    Type result = function();
    require_count(1 + 2 * result.arguments);
    for (std::size_t k = 1; k < count(); ++k) require_scalar(k);
    result.arguments = 0;
    return result;
  }

  Type component() const {
    require_count(1);
    require(value(0).kind == Type::Kind::point && node_.indices.size() == 1 &&
                node_.indices[0] < of(0).width(),
            "the point has no such coordinate");
    return Type{};
  }

  Type part(bool single) const {
    require_count(1);
    require_matrix(0);
    const Type& whole = of(0);
    const std::vector<std::size_t>& at = node_.indices;
    if (single) {
      require(at.size() == 2 && at[0] < whole.rows && at[1] < whole.columns,
              "the matrix has no such entry");
      Type entry = whole;
      entry.kind = whole.has_points() ? Type::Kind::point : Type::Kind::scalar;
      entry.rows = entry.columns = 1;
      return entry;
    }
    require(at.size() == 4 && at[0] <= at[1] && at[1] < whole.rows && at[2] <= at[3] &&
                at[3] < whole.columns,
            "the matrix has no such entries");
    return checked(at[1] - at[0] + 1, at[3] - at[2] + 1, whole);
  }

  Type transpose() const {
    require_count(1);
    require_matrix(0);
    return checked(of(0).columns, of(0).rows, of(0));
  }

  Type matrix_product() const {
    require(count() >= 1, "a wrong number of children");
    require_matrix(0);
    Type result = of(0);
    for (std::size_t k = 1; k < count(); ++k) {
      require_matrix(k);
      require(result.columns == of(k).rows, "matrices that do not fit");
      require(!result.has_points() || !of(k).has_points(), "a product of two matrices of points");
      result = checked(result.rows, of(k).columns, product_type(result, of(k)));
    }
    return result;
  }

  Type determinant() const {
    require_count(1);
    require_matrix(0);
    require(of(0).rows == of(0).columns && !of(0).has_points(),
            "a square matrix of scalars is needed here");
    return Type{};
  }

  void require_points(bool in_space) const {
    require_count(2);
    require(value(0).kind == Type::Kind::point && of(0) == of(1) && !of(0).any &&
                (!in_space || of(0).dimension == 3),
            in_space ? "two points in R^3 are needed here"
                     : "two points of one known dimension are needed here");
  }

  void require_knots() const {
    const std::size_t degree = node_.indices[0];
    const std::size_t index = node_.indices[1];
    const std::size_t span = node_.indices[2];
    const std::size_t knots = node_.knots.size();
    require(degree <= limits_.order, "a degree too large");
    require(index < knots && index + degree + 1 < knots && span < knots && span + 1 < knots,
            "there are not enough knots");
    require(std::is_sorted(node_.knots.begin(), node_.knots.end()), "the knots are not in order");
    require(node_.knots[span] < node_.knots[span + 1], "the span is empty");
  }

  const Node& node_;
  const std::vector<Node>& nodes_;
  const std::vector<Symbol>& symbols_;
  const Limits& limits_;
};

}  // namespace

Type type_of(const Node& node, const std::vector<Node>& nodes, const std::vector<Symbol>& symbols,
             const Limits& limits) {
  return Typing{node, nodes, symbols, limits}.type();
}

}  // namespace recheck
