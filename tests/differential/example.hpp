#pragma once

#include <string>
#include <vector>

#include "choices.hpp"
#include "draft.hpp"

namespace patchproof::differential {

/// A random claim of which it is known beforehand whether it holds.
struct Example {
  /// What it is about: "bezier patch".
  std::string subject;
  std::vector<std::string> declarations;
  /// Without its verb: "p: u + v == v + u", or "derive p: …".
  std::string claim;
  bool holds = true;
  /// Statements of Python, and the two sides; no sides where Python is not asked.
  std::vector<std::string> python = {};
  std::string python_left = "";
  std::string python_right = "";
  /// What `meaning` says of it; the same as `holds` where it is not asked.
  bool meaning_holds = true;
  /// It holds only under conditions.
  bool conditional = false;
};

/// The whole case, with the verb that expects the truth.
std::string case_of(const Example& example, const std::string& name = "random");

/// Two expressions of the same value, under the declarations of a draft.
struct Equation {
  Node left;
  Node right;
};

/// The claim that an equation, after random changes that keep it true and perhaps one that does
/// not, holds.
Example example_of(Choices& choices, const std::string& subject, const Draft& draft,
                   const Equation& equation, bool holds);

/// A way to make claims about one subject.
struct Subject {
  std::string name;
  Example (*example)(Choices& choices, const std::string& name, bool holds);
};

/// All subjects, always in this order.
const std::vector<Subject>& subjects();

/// A random claim: the first decision is the subject, the second whether it holds.
Example random_example(Choices& choices);
inline constexpr std::size_t decisions_kept = 2;

}  // namespace patchproof::differential
