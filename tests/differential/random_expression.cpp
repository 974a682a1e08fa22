#include "draft.hpp"

namespace patchproof::differential {
namespace {

/// 2^61 - 1, the usual modulus of hashes; what it divides must not look like zero.
const Integer mersenne{"2305843009213693951"};

Integer random_large(Choices& choices) {
  const Integer one = 1;
  switch (choices.below(6)) {
    case 0:
      return mersenne;
    case 1:
      return mersenne * (2 + choices.below(1000));
    case 2:
      return (one << 63) - 1 + choices.below(3);
    case 3:
      return (one << 64) - 1 + choices.below(3);
    case 4:
      return (one << 127) - 1 + choices.below(3);
    default: {
      const Integer low = choices.below(3);
      return (one << 128) - 2 + low + (Integer{choices.below(1u << 16)} << 90);
    }
  }
}

/// An argument: a parameter, an end of its range, or something inside.
Node random_argument(Choices& choices, const Draft& draft, const std::string& formal) {
  const Node variable = scalar_name(draft.parameters.empty() ? case_text(draft.scalars.front())
                                                             : draft.parameters.front());
  const Node own = [&] {
    for (const Node& scalar : draft.scalars)
      if (scalar->text == formal) return scalar;
    return variable;
  }();
  switch (choices.below(8)) {
    case 0:
    case 1:
    case 2:
      return own;
    case 3:
      return number(0);
    case 4:
      return number(1);
    case 5:
      return number(choices.once_in(2) ? "0.5" : "1/3");
    case 6:
      return difference(number(1), own);
    default:
      return choices.once_in(2) ? power(own, 2) : product({own, choices.one_of(draft.scalars)});
  }
}

Node random_power(Choices& choices, const Draft& draft, unsigned depth) {
  const Node base = random_scalar(choices, draft, depth > 1 ? 1 : 0);
  return power(base, 2 + static_cast<unsigned>(choices.below(depth > 1 ? 2 : 3)));
}

}  // namespace

Node random_number(Choices& choices) {
  const std::uint64_t sort = choices.below(12);
  if (sort < 7) return number(static_cast<long>(choices.below(6)) + 1);
  if (sort < 9) {
    const std::string above = std::to_string(1 + choices.below(9));
    return number(above + "/" + std::to_string(2 + choices.below(9)));
  }
  if (sort == 9) return number("0." + std::to_string(1 + choices.below(999)));
  const std::string large = random_large(choices).str();
  if (sort == 10) return number(large);
  return number(std::to_string(1 + choices.below(9)) + "/" + large);
}

Node random_application(Choices& choices, const Draft& draft) {
  const DeclaredFunction& function = choices.one_of(draft.functions);
  std::vector<Node> arguments;
  for (const std::string& formal : function.formals)
    arguments.push_back(random_argument(choices, draft, formal));
  std::string derivative;
  for (std::uint64_t k = choices.below(function.order + 1); k > 0; --k)
    derivative += function.formals[choices.below(function.formals.size())];
  return apply(function_name(function.name), arguments, function.type, derivative);
}

// Arguments of a function are worked out in no certain order, so no two of them may choose.
Node random_scalar(Choices& choices, const Draft& draft, unsigned depth) {
  if (depth == 0) {
    if (draft.scalars.empty() || choices.once_in(4)) return random_number(choices);
    return choices.one_of(draft.scalars);
  }
  const auto part = [&] { return random_scalar(choices, draft, depth - 1); };
  const auto over_divisor = [&](const Node& above) {
    return quotient(above, choices.one_of(draft.divisors));
  };
  switch (choices.below(9)) {
    case 0:
      return random_scalar(choices, draft, 0);
    case 1:
    case 2:
      return sum({part(), part()});
    case 3:
      return sum({part(), negative(part())});
    case 4:
    case 5:
      return product({part(), part()});
    case 6:
      return random_power(choices, draft, depth);
    case 7:
      if (draft.points.empty() || draft.points[0]->kind != Kind::name ||
          draft.environment.values.count(draft.points[0]->text) == 0)
        return negative(part());
      // Only points of space have products.
      return call(
          "dot", {random_point(choices, draft, depth / 2), random_point(choices, draft, depth / 2)},
          Type::scalar);
    default:
      if (draft.divisors.empty()) return sum({part(), part(), part()});
      return over_divisor(part());
  }
}

Node random_point(Choices& choices, const Draft& draft, unsigned depth) {
  const bool has_functions = !draft.functions.empty();
  if (depth == 0) {
    if (has_functions && (draft.points.empty() || choices.once_in(2)))
      return random_application(choices, draft);
    return choices.one_of(draft.points);
  }
  const auto part = [&] { return random_point(choices, draft, depth - 1); };
  const auto over_divisor = [&](const Node& above) {
    return quotient(above, choices.one_of(draft.divisors));
  };
  switch (choices.below(6)) {
    case 0:
      return random_point(choices, draft, 0);
    case 1:
      return sum({part(), part()});
    case 2:
      return sum({part(), negative(part())});
    case 3:
      return sum({part(), part(), part()});
    case 4:
      if (!draft.divisors.empty() && choices.once_in(2)) return over_divisor(part());
      return product({random_scalar(choices, draft, depth - 1), part()});
    default:
      return product({random_scalar(choices, draft, depth - 1), part()});
  }
}

}  // namespace patchproof::differential
