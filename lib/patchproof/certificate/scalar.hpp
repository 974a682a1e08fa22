#pragma once

#include <memory>
#include <vector>

#include <patchproof/algebra/number.hpp>
#include <patchproof/term/symbol.hpp>

namespace patchproof {

struct Scalar;
struct ScalarFunction;
using ScalarPointer = std::shared_ptr<const Scalar>;
using ScalarFunctionPointer = std::shared_ptr<const ScalarFunction>;

/// One coordinate of a symbol: of a scalar the only one, of an unknown function one of its values.
struct Coordinate {
  SymbolPointer symbol;
  std::size_t index = 0;
};

/// A term without points and matrices: one component of a term of the case, with the operations that
/// a proof assistant has. Immutable and shared.
struct Scalar {
  enum class Kind {
    integer,      ///< number
    variable,     ///< coordinate
    sum,          ///< two children, as are the next three
    difference,
    product,
    quotient,
    opposite,     ///< one child
    power,        ///< one child, exponent `order`
    bernstein,    ///< one child t: B_index^order(t)
    root,         ///< one child
    application,  ///< function, children are the arguments
    integral,     ///< children lower, upper, body; `formal` is bound in the body
    named,        ///< child: what the value of the case that is called `name` stands for
  };
  Kind kind = Kind::integer;
  Integer number;
  Coordinate coordinate;
  std::vector<ScalarPointer> children;
  ScalarFunctionPointer function;
  unsigned order = 0;
  unsigned index = 0;
  SymbolPointer formal;
  std::string name;
  /// How many nodes it has when nothing is shared; capped at `largest_scalar`.
  std::size_t size = 1;
};

struct ScalarFunction {
  enum class Kind {
    lambda,      ///< formals, body
    derivative,  ///< of `inner` in its argument number `slot`
    unknown,     ///< coordinate of an unknown function
    named,       ///< inner: what the function of the case that is called `name` stands for
  };
  Kind kind = Kind::unknown;
  std::vector<SymbolPointer> formals;
  ScalarPointer body;
  ScalarFunctionPointer inner;
  std::size_t slot = 0;
  Coordinate coordinate;
  std::string name;
  /// How many arguments it takes.
  std::size_t arity = 1;
  std::size_t size = 1;
};

/// Terms beyond this are not written down.
inline constexpr std::size_t largest_scalar = 20'000;

}  // namespace patchproof
