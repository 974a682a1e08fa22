#include <patchproof/certificate/quotient_argument.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace patchproof {

namespace {

// What is known of a value: whether it is a number, and whether something is divided in it.
struct Shape {
  bool constant = true;
  bool divided = false;
};

class Walk {
 public:
  bool found = false;

  Shape of(const ScalarPointer& scalar) {
    Shape result;
    if (scalar->kind == Scalar::Kind::integral) {
      result = both(of(scalar->children[0]), of(scalar->children[1]));
      return both(result, inside({scalar->formal}, {Shape{false, false}}, scalar->children[2]));
    }
    std::vector<Shape> children;
    for (const ScalarPointer& child : scalar->children) children.push_back(of(child));
    for (const Shape& child : children) result = both(result, child);
    switch (scalar->kind) {
      case Scalar::Kind::variable: {
        const auto bound = bound_.find(scalar->coordinate.symbol->ordinal);
        return bound == bound_.end() ? Shape{false, false} : bound->second;
      }
      case Scalar::Kind::quotient:
        if (!children[1].constant) result.divided = true;
        return result;
      case Scalar::Kind::application: return applied(scalar->function, children);
      default: return result;
    }
  }

 private:
  static Shape both(const Shape& a, const Shape& b) {
    return {a.constant && b.constant, a.divided || b.divided};
  }

  Shape inside(const std::vector<SymbolPointer>& formals, const std::vector<Shape>& shapes,
               const ScalarPointer& body) {
    const auto outer = bound_;
    for (std::size_t k = 0; k < formals.size(); ++k) bound_[formals[k]->ordinal] = shapes[k];
    const Shape result = of(body);
    bound_ = outer;
    return result;
  }

  Shape applied(const ScalarFunctionPointer& function, const std::vector<Shape>& arguments) {
    switch (function->kind) {
      case ScalarFunction::Kind::lambda:
        return inside(function->formals, arguments, function->body);
      case ScalarFunction::Kind::unknown: {
        const bool divided = std::any_of(arguments.begin(), arguments.end(),
                                         [](const Shape& a) { return a.divided; });
        found = found || divided;
        return {false, divided};
      }
      default: return applied(function->inner, arguments);
    }
  }

  std::map<unsigned, Shape> bound_;
};

}  // namespace

bool has_quotient_argument(const ScalarPointer& scalar) {
  Walk walk;
  walk.of(scalar);
  return walk.found;
}

}  // namespace patchproof
