#include <patchproof/certificate/scalar_obstacle.hpp>

#include <algorithm>
#include <map>
#include <vector>

namespace patchproof {

namespace {

// What is in a value.
struct Content {
  bool variables = false;
  bool integrated = false;  // a variable of an integral around it
  bool quotient = false;    // by more than a number
};

Content operator+(const Content& a, const Content& b) {
  return {a.variables || b.variables, a.integrated || b.integrated, a.quotient || b.quotient};
}

// Evaluates to contents. What the formals of a lambda stand for is in `bound_` while its body is
// read.
class ObstacleSearch {
 public:
  std::string found;

  Content of(const ScalarPointer& scalar) {
    if (scalar->kind == Scalar::Kind::variable) {
      const auto bound = bound_.find(scalar->coordinate.symbol->ordinal);
      return bound == bound_.end() ? Content{true, false, false} : bound->second;
    }
    if (scalar->kind == Scalar::Kind::integral) {
      Content body = inside({scalar->formal}, {Content{true, true, false}}, scalar->children[2]);
      body.integrated = false;
      return of(scalar->children[0]) + of(scalar->children[1]) + body;
    }
    std::vector<Content> children;
    for (const ScalarPointer& child : scalar->children) children.push_back(of(child));
    if (scalar->kind == Scalar::Kind::application) return applied(scalar->function, children);
    Content result;
    for (const Content& child : children) result = result + child;
    if (scalar->kind == Scalar::Kind::quotient && children[1].variables) {
      result.quotient = true;
      if (children[1].integrated) found = "an integral of a quotient";
    }
    return result;
  }

 private:
  Content inside(const std::vector<SymbolPointer>& formals, const std::vector<Content>& values,
                 const ScalarPointer& body) {
    const auto outer = bound_;
    for (std::size_t k = 0; k < formals.size(); ++k) bound_[formals[k]->ordinal] = values[k];
    const Content result = of(body);
    bound_ = outer;
    return result;
  }

  Content applied(const ScalarFunctionPointer& function, const std::vector<Content>& arguments) {
    if (function->kind == ScalarFunction::Kind::lambda)
      return inside(function->formals, arguments, function->body);
    if (function->kind != ScalarFunction::Kind::unknown) return applied(function->inner, arguments);
    Content result;
    for (const Content& argument : arguments) result = result + argument;
    if (result.quotient) found = "an unknown function at a quotient";
    if (result.integrated) found = "an integral of an unknown function";
    result.variables = true;
    return result;
  }

  std::map<unsigned, Content> bound_;
};

bool has_root(const ScalarFunctionPointer& function) {
  return (function->body && patchproof::has_root(function->body)) ||
         (function->inner && has_root(function->inner));
}

}  // namespace

std::string obstacle_in_equation(const ScalarPointer& scalar) {
  ObstacleSearch search;
  search.of(scalar);
  return search.found;
}

bool has_root(const ScalarPointer& scalar) {
  return scalar->kind == Scalar::Kind::root || (scalar->function && has_root(scalar->function)) ||
         std::any_of(scalar->children.begin(), scalar->children.end(),
                     [](const ScalarPointer& child) { return has_root(child); });
}

}  // namespace patchproof
