#include <patchproof/decide/shown.hpp>

#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/evaluator.hpp>
#include <patchproof/kernel/readable.hpp>

namespace patchproof {

namespace {

// Components from `next` on, arranged as the type says.
std::string arranged(const Type& type, const std::vector<std::string>& parts, std::size_t& next) {
  if (type.is_function()) return arranged(*type.inner, parts, next);
  if (type.is_scalar() || type.component_count() == 1) return parts.at(next++);
  std::string text;
  if (type.is_point()) {
    for (int k = 0; k < type.dimension; ++k) text += (k > 0 ? ", " : "(") + parts.at(next++);
    return text + ")";
  }
  for (int i = 0; i < type.rows; ++i) {
    text += i > 0 ? " ; " : "[";
    for (int j = 0; j < type.columns; ++j)
      text += (j > 0 ? ", " : "") + arranged(*type.inner, parts, next);
  }
  return text + "]";
}

}  // namespace

std::string normal_form_in_words(const Term& term, const Limits& limits) {
  std::string text;
  const Decision outcome = guarded(limits, [&](Workspace& workspace) {
    Evaluator evaluator{workspace};
    std::vector<std::string> parts;
    for (const Fraction& component : evaluator.value(term).components)
      parts.push_back(to_text(component, workspace.atoms, workspace.budget, 1000));
    std::size_t next = 0;
    text = arranged(term.type(), parts, next);
    Decision done;
    done.verdict = Verdict::proved;
    return done;
  });
  if (outcome.verdict == Verdict::proved) return text;
  return (outcome.verdict == Verdict::error ? "no value: " : "not computed: ") + outcome.reason;
}

}  // namespace patchproof
