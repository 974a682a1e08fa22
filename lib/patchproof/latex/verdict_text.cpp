#include <patchproof/latex/verdict_text.hpp>

#include <patchproof/latex/line_breaks.hpp>
#include <patchproof/latex/plain_latex.hpp>
#include <patchproof/latex/prose.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

std::string paragraph(const std::string& text) { return "\\pptext{" + text + "}\n"; }

std::string mathematics(const std::string& plain, const Wording& wording) {
  return "$" + plain_latex(plain, wording.names.notation) + "$";
}

// "0", "(0, 0, 0)"
bool is_zero(const std::string& value) {
  return value.find_first_not_of("0(), ") == std::string::npos;
}

std::string witness_values(const WitnessReport& witness, const Wording& wording) {
  if (witness.values.empty()) return wording(Word::any_values);
  std::string text;
  bool zeros = false;
  for (const auto& [name, value] : witness.values) {
    if (is_zero(value)) {
      zeros = true;
      continue;
    }
    text += (text.empty() ? "" : ", ") + mathematics(name + " = " + value, wording);
  }
  if (zeros) text += (text.empty() ? "" : "; ") + wording(Word::all_others_zero);
  return text;
}

std::string side(Word word, const std::string& plain, const Wording& wording) {
  return "\\ppside{" + wording(word) + "}{" +
         breakable(plain_latex(plain, wording.names.notation)) + "}\n";
}

std::string colour_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
    case Verdict::proved_if:
      return "ppgood";
    case Verdict::unknown:
    case Verdict::underdetermined:
      return "ppopen";
    default:
      return "ppbad";
  }
}

bool needs_frame(Verdict verdict) {
  return verdict == Verdict::unknown || verdict == Verdict::error || verdict == Verdict::internal ||
         verdict == Verdict::vacuous;
}

std::string frame_text(const ClaimResult& result, const Wording& wording) {
  const Decision& decision = result.decision;
  std::string text = "\\ppalarm{" + colour_of(decision.verdict) + "}{\\textbf{\\textsf{" +
                     wording(word_of(decision.verdict)) + "}}";
  if (!decision.reason.empty())
    text += "\\par " + wording(Word::reason) + ": " + prose(decision.reason);
  return text + "}\n";
}

std::string joined_labels(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels)
    text += (text.empty() ? "\\pplabel{" : ", \\pplabel{") + latex_escaped(label) + "}";
  return text;
}

// Both sides on one line where they are short.
std::string sides_text(const WitnessReport& witness, const Wording& wording) {
  constexpr int short_side = 1000;
  const auto is_short = [&](const std::string& plain) {
    return estimated_width(plain_latex(plain, wording.names.notation)) < short_side;
  };
  if (witness.left.empty() && witness.right.empty()) return "";
  if (is_short(witness.left) && is_short(witness.right))
    return paragraph(wording(Word::left_side) + ": " + mathematics(witness.left, wording) + ", " +
                     wording(Word::right_side) + ": " + mathematics(witness.right, wording));
  return side(Word::left_side, witness.left, wording) +
         side(Word::right_side, witness.right, wording);
}

}  // namespace

std::string refutation_text(const Decision& decision, const RefutationParts& parts,
                            const Wording& wording) {
  std::string text;
  if (parts.values)
    text += paragraph("\\textbf{" + wording(Word::counterexample) + ":} " +
                      witness_values(decision.witness, wording));
  if (parts.sides) text += sides_text(decision.witness, wording);
  // What does not fit into a few lines says nothing to a reader.
  constexpr std::size_t longest_difference = 250;
  const bool program_text = decision.residual.find("integral(") != std::string::npos ||
                            decision.residual.find(".x") != std::string::npos ||
                            decision.residual.find(".y") != std::string::npos ||
                            decision.residual.find(".z") != std::string::npos;
  // The difference is that of one component.
  const bool whole = decision.witness.component.empty();
  if (parts.difference && whole && !program_text && !decision.residual.empty() &&
      decision.residual.size() <= longest_difference)
    text += side(Word::difference, decision.residual, wording);
  if (!decision.reason.empty()) text += paragraph(prose(decision.reason));
  return text;
}

std::string verdict_text(const ClaimResult& result, const Wording& wording) {
  const Decision& decision = result.decision;
  std::string text;
  if (!decision.conditions.empty()) {
    text += paragraph(wording(Word::under_conditions));
    for (const std::string& condition : decision.conditions)
      text += "\\ppalone{" + breakable(plain_latex(condition, wording.names.notation)) + "}\n";
  }
  if (!decision.free.empty()) {
    std::string free;
    for (const std::string& name : decision.free)
      free += (free.empty() ? "" : ", ") + mathematics(name, wording);
    text += paragraph(wording(Word::free_unknowns) + " " + free + ".");
  }
  for (const auto& [name, value] : decision.details) text += paragraph(prose(name + ": " + value));
  if (decision.verdict == Verdict::inconsistent && !decision.reason.empty())
    text += paragraph(prose(decision.reason));
  if (!decision.assumptions_used.empty())
    text += paragraph(wording(Word::assumptions_used) + ": " +
                      joined_labels(decision.assumptions_used));
  if (needs_frame(decision.verdict)) {
    text += frame_text(result, wording);
  } else {
    const Word evidence = decision.evidence == Evidence::certified      ? Word::certified
                          : decision.evidence == Evidence::both_engines ? Word::both_engines
                                                                        : Word::kernel_only;
    text += "\\ppverdict{" + colour_of(decision.verdict) + "}{" +
            wording(word_of(decision.verdict)) + "}{" + wording(evidence) + "}\n";
  }
  if (result.outcome != Outcome::as_expected)
    text += "\\ppalarm{ppbad}{" + wording(Word::expected) + ": \\textbf{" +
            wording(word_of(result.claim.expectation)) + "}}\n";
  return text;
}

}  // namespace patchproof
