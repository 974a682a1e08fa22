#pragma once

#include <memory>
#include <string>

#include <patchproof/term/type.hpp>

namespace patchproof {

/// A name that stands for something not known further: the letters of a statement.
///
/// Two symbols are the same exactly when they have the same ordinal; names need not be unique
/// (the formal parameters of definitions are made afresh at each use).
struct Symbol {
  enum class Role {
    parameter,  ///< u, v: runs over its range; equations hold for every value of it
    scalar,     ///< an arbitrary number
    point,      ///< an arbitrary point, perhaps one entry of an array: "V[1,2]"
    function,   ///< an unknown curve, patch or scalar function; type is Type::Kind::function
    bound,      ///< the formal parameter of a function, with no meaning outside it
  };

  std::string name;
  Role role = Role::scalar;
  Type type;
  /// Functions: how many continuous derivatives are assumed (in each variable order up to it).
  int smoothness = 0;
  /// Position in the order of declaration; the identity of the symbol.
  unsigned ordinal = 0;
};

using SymbolPointer = std::shared_ptr<const Symbol>;

}  // namespace patchproof
