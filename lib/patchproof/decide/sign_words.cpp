#include <patchproof/decide/sign_words.hpp>

#include <patchproof/algebra/simplest_between.hpp>
#include <patchproof/kernel/readable.hpp>

namespace patchproof {

namespace {

// What has to be positive, or not negative.
std::string difference_in(Relation relation) {
  const bool right = relation == Relation::less || relation == Relation::less_equal;
  return right ? "right - left" : "left - right";
}

std::string in_words(const std::map<Variable, Rational>& point, const Workspace& workspace) {
  std::string text;
  for (const auto& [variable, value] : point)
    text +=
        (text.empty() ? "" : ", ") + to_text(variable, workspace.atoms) + " = " + to_text(value);
  return text;
}

// The point to about three digits: where subdivision stops the numbers are long.
std::map<Variable, Rational> rounded(std::map<Variable, Rational> point) {
  const Rational near{1, 2000};
  for (auto& [variable, value] : point)
    value = simplest_between(value - near, false, value + near, false).value_or(value);
  return point;
}

}  // namespace

std::string nowhere_worse(Relation relation, const SignAnswer& answer, const Workspace& workspace) {
  if (answer.kind != SignAnswer::Kind::only_zero) return "";
  const std::string known = relation == Relation::not_equal ? " does not change its sign"
                                                            : " is never negative on the box";
  return difference_in(relation) + known + "; zero at " + in_words(answer.point, workspace);
}

std::string undecided_sign(Relation relation, const SignAnswer& answer,
                           const Workspace& workspace) {
  const std::string what = difference_in(relation);
  if (answer.kind == SignAnswer::Kind::undecided)
    return "limit of subdivision: the sign of " + what + " is not decided near " +
           in_words(rounded(answer.point), workspace);
  if (answer.kind == SignAnswer::Kind::changes)
    return what + " changes its sign, so it is zero somewhere, but not at any of the points tried";
  return "this inequality is neither shown by the methods of this version nor false at any of the "
         "points tried";
}

}  // namespace patchproof
