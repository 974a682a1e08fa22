#include "example.hpp"

#include <stdexcept>

#include "near_miss.hpp"
#include "rewriting.hpp"

namespace patchproof::differential {

std::string case_of(const Example& example, const std::string& name) {
  std::string text = "case " + name + "\n";
  for (const std::string& line : example.declarations) text += "  " + line + "\n";
  const bool is_derivation = example.claim.rfind("derive", 0) == 0;
  const std::string verb = is_derivation ? "" : example.holds ? "prove " : "refute ";
  return text + "  " + verb + example.claim + "\nend\n";
}

Example example_of(Choices& choices, const std::string& subject, const Draft& draft,
                   const Equation& equation, bool holds) {
  const Node left =
      rewritten(choices, draft, equation.left, static_cast<unsigned>(choices.below(3)));
  Node right =
      choices.once_in(3) ? equation.right : unfolded_somewhere(choices, draft, equation.right);
  right = rewritten(choices, draft, right, 1 + static_cast<unsigned>(choices.below(6)));
  if (!holds) {
    const Node missed = near_miss(choices, draft, right);
    if (missed)
      right = missed;
    else
      holds = true;
  }
  Example example{subject, draft.declarations, "", holds, draft.python};
  example.claim = "p: " + case_text(left) + " == " + case_text(right);
  example.python_left = python_text(left);
  example.python_right = python_text(right);
  example.meaning_holds = same(meaning(left, draft.environment), meaning(right, draft.environment));
  return example;
}

Example random_example(Choices& choices) {
  const Subject& subject = choices.one_of(subjects());
  const bool holds = choices.below(2) == 0;
  return subject.example(choices, subject.name, holds);
}

}  // namespace patchproof::differential
