#include <patchproof/latex/claim_text.hpp>

#include <algorithm>

#include <patchproof/latex/given_text.hpp>
#include <patchproof/latex/line_breaks.hpp>
#include <patchproof/latex/plain_latex.hpp>
#include <patchproof/latex/prose.hpp>
#include <patchproof/latex/verdict_text.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

std::string paragraph(const std::string& text) { return "\\pptext{" + text + "}\n"; }

std::string in_result(const std::string& chains) {
  return "\\begin{ppresult}\n" + chains + "\\end{ppresult}\n";
}

std::string derive_text(const DeriveClaim& claim, Expectation expectation, const Wording& wording) {
  std::string unknowns;
  for (const SymbolPointer& unknown : claim.goal.unknowns)
    unknowns += (unknowns.empty() ? "$" : ", $") + symbol_text(*unknown, wording) + "$";
  std::string text =
      paragraph(wording(Word::find) + " " + unknowns + " " + wording(Word::such_that)) +
      statements_text(claim.goal.goal.statements, wording);
  if (!claim.gives.empty())
    text += paragraph(wording(Word::says_the_author)) + statements_text(claim.gives, wording);
  if (!claim.leaves.empty()) {
    std::string free;
    for (const SymbolPointer& symbol : claim.leaves)
      free += (free.empty() ? "$" : ", $") + symbol_text(*symbol, wording) + "$";
    text += paragraph(wording(Word::left_open) + " " + free + ".");
  }
  if (expectation == Expectation::inconsistent) text += paragraph(wording(Word::no_solution));
  return text;
}

std::string minimum_text(const MinimumClaim& claim, const Wording& wording) {
  const MinimumGoal& goal = claim.goal;
  const std::string candidate = to_latex(goal.membership.right, wording.names);
  const std::string competitor = to_latex(goal.membership.left, wording.names);
  return "\\ppalone{" + breakable(candidate) + "}\n" + paragraph(wording(Word::minimizes)) +
         "\\ppalone{" + breakable(competitor) + "}\n" + paragraph(wording(Word::where)) +
         relations_text(goal.constraints, wording) + statements_text(goal.goal.statements, wording);
}

Word opening_of(Passage::Kind kind) {
  switch (kind) {
    case Passage::Kind::definition:
      return Word::by_definition;
    case Passage::Kind::computation:
      return Word::we_compute;
    case Passage::Kind::condition:
      return Word::it_must_hold;
    case Passage::Kind::result:
      return Word::hence;
    case Passage::Kind::check:
      return Word::check;
    case Passage::Kind::witness:
      return Word::counterexample;
    case Passage::Kind::difference:
      return Word::difference;
    default:
      return Word::variation;
  }
}

bool has_passage(const CheckedDerivation& derivation, Passage::Kind kind) {
  return std::any_of(derivation.passages().begin(), derivation.passages().end(),
                     [&](const CheckedPassage& passage) { return passage.kind == kind; });
}

bool has_chains(const CheckedDerivation& derivation, Passage::Kind kind) {
  return std::any_of(derivation.passages().begin(), derivation.passages().end(),
                     [&](const CheckedPassage& passage) {
                       return passage.kind == kind && !passage.chains.empty();
                     });
}

// What `derive` found, where the derivation does not say it.
std::string solution_text(const Decision& decision, const Wording& wording) {
  std::string chains;
  for (const KnownValue& value : decision.solution)
    chains +=
        equation_text(symbol_text(*value.symbol, wording), to_latex(value.value, wording.names));
  return chains.empty() ? "" : in_result(chains);
}

}  // namespace

namespace {

std::string chains_text(const CheckedPassage& passage, const Wording& wording) {
  std::string text;
  for (const CheckedChain& chain : passage.chains)
    text += readable_chain_text(chain, passage.kind, wording);
  return text;
}

// Short equations one behind the other.
std::string conditions_text(const CheckedPassage& passage, const Wording& wording) {
  constexpr int widest = 1400;
  const std::vector<CheckedChain>& chains = passage.chains;
  std::string text;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    const CheckedChain& chain = chains[k];
    if (chain.links.size() != 1) return chains_text(passage, wording);
    const Link& link = chain.links.front().link;
    const std::string equation = to_latex(chain.start, wording.names) + " " +
                                 relation_text(link.relation) + " " +
                                 to_latex(link.term, wording.names);
    if (estimated_width(equation) > widest) return chains_text(passage, wording);
    text += "\\pps{" + equation + (k + 1 < chains.size() ? ",\\quad" : "") + "}";
  }
  return "\\ppalone{" + text + "}\n";
}

bool has_wide_side(const Statement& statement, const Wording& wording) {
  return is_too_wide(to_latex(statement.left, wording.names)) ||
         is_too_wide(to_latex(statement.right, wording.names));
}

// Numbers are worked out when a case is read, so that 4 == binomial(4, 1) reads 4 = 4; and matrices
// can be too wide for a page. Then the text of the case says what is meant.
std::string written_text(const Claim& claim, const Wording& wording) {
  const std::vector<Statement>& statements = goal_of(claim).statements;
  const bool needed =
      std::any_of(statements.begin(), statements.end(), [&](const Statement& statement) {
        return has_wide_side(statement, wording) ||
               to_latex(statement.left, wording.names) == to_latex(statement.right, wording.names);
      });
  const Span& span = claim.statement;
  if (!needed || !span.source) return "";
  std::string text;
  for (std::size_t k = span.begin; k < span.end; ++k) {
    const char c = span.source->text[k];
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank || (!text.empty() && text.back() != ' ')) text += blank ? ' ' : c;
  }
  return paragraph("\\ppname{" + latex_escaped(text) + "}");
}

// All of a printed line, which has to be there to be struck; else those that can be read.
std::vector<Statement> readable_statements(const Claim& claim, const Wording& wording) {
  std::vector<Statement> result;
  for (const Statement& statement : goal_of(claim).statements)
    if (claim.verb == "printed" || !has_wide_side(statement, wording)) result.push_back(statement);
  return result;
}

}  // namespace

std::string statement_text(const Claim& claim, const Wording& wording) {
  std::string text;
  if (const auto* derive = std::get_if<DeriveClaim>(&claim.kind))
    text = derive_text(*derive, claim.expectation, wording);
  else if (const auto* minimum = std::get_if<MinimumClaim>(&claim.kind))
    text = minimum_text(*minimum, wording);
  else
    text = written_text(claim, wording) + statements_text(readable_statements(claim, wording), wording);
  if (claim.uses.empty()) return text;
  std::string labels;
  for (const std::string& label : claim.uses)
    labels += (labels.empty() ? "" : ", ") + std::string{"\\pplabel{"} + latex_escaped(label) + "}";
  return text + paragraph("(" + wording(Word::using_results) + " " + labels + ")");
}

std::string definitions_text(const CheckedDerivation& derivation, const Wording& wording) {
  std::string text;
  for (const CheckedPassage& passage : derivation.passages())
    for (const CheckedChain& chain : passage.chains) text += chain_text(chain, wording);
  return text;
}

std::string passages_text(const CheckedDerivation& derivation, const Wording& wording) {
  std::string text;
  std::optional<Passage::Kind> before;
  for (const CheckedPassage& passage : derivation.passages()) {
    const bool witness = passage.kind == Passage::Kind::witness;
    const std::string chains = passage.kind == Passage::Kind::condition
                                   ? conditions_text(passage, wording)
                                   : chains_text(passage, wording);
    if (chains.empty() && !witness) continue;
    // Paragraphs of one sort are one after the other, and are introduced once.
    std::string opening;
    if (witness)
      opening = "\\textbf{" + wording(Word::counterexample) + ":} " +
                values_text(passage.values, wording);
    else if (before != passage.kind)
      opening = wording(opening_of(passage.kind));
    if (!before)
      text += "\\ppderivation{" + wording(Word::derivation) + "}{" + opening + "}\n";
    else if (!opening.empty())
      text += paragraph(opening);
    before = passage.kind;
    text += passage.kind == Passage::Kind::result ? in_result(chains) : chains;
  }
  return text;
}

std::string claim_text(const ClaimResult& result, const ClaimDerivation& derivation,
                       bool goes_on_with_erratum, const Wording& wording,
                       const std::string& remark) {
  const Claim& claim = result.claim;
  const bool printed = claim.verb == "printed";
  const bool erratum = printed || claim.verb == "corrected";
  std::string text;
  if (!goes_on_with_erratum)
    text += "\\ppclaim{" + wording(erratum ? Word::erratum : Word::claim) + "}{" +
            latex_escaped(common_label(claim) + claim.instance) + "}\n";
  if (erratum) text += paragraph(wording(printed ? Word::printed : Word::corrected) + ":");
  const std::string statement = statement_text(claim, wording);
  text += printed ? "\\begin{ppstruck}\n" + statement + "\\end{ppstruck}\n" : statement;
  text += remark;
  if (!derivation.derivation.passages().empty())
    text += passages_text(derivation.derivation, wording);
  if (!has_passage(derivation.derivation, Passage::Kind::result))
    text += solution_text(result.decision, wording);
  if (result.decision.verdict == Verdict::refuted)
    text += refutation_text(result.decision,
                            {!has_passage(derivation.derivation, Passage::Kind::witness),
                             !has_chains(derivation.derivation, Passage::Kind::witness),
                             !has_passage(derivation.derivation, Passage::Kind::difference)},
                            wording);
  text += verdict_text(result, wording);
  if (derivation.further_instances > 0)
    text += paragraph(wording(Word::further_instances) + ": " +
                      std::to_string(derivation.further_instances) + ".");
  if (claim.verb == "corrected" && !claim.note.empty())
    text += paragraph(wording(Word::note) + ": " + prose(claim.note));
  return text;
}

std::string common_label(const Claim& claim) {
  if (claim.verb != "printed" && claim.verb != "corrected") return claim.label;
  return claim.label.substr(0, claim.label.rfind('.'));
}

}  // namespace patchproof
