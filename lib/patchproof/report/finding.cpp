#include <patchproof/report/finding.hpp>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/verdict_words.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string sign_of(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return "==";
    case Relation::not_equal:
      return "!=";
    case Relation::less:
      return "<";
    case Relation::less_equal:
      return "<=";
    case Relation::greater:
      return ">";
    default:
      return ">=";
  }
}

/// Writes the notes below the statement of one claim.
class Notes {
 public:
  explicit Notes(const ClaimResult& result)
      : claim_{result.claim}, decision_{result.decision}, outcome_{result.outcome} {}

  std::string text() {
    switch (decision_.verdict) {
      case Verdict::proved:
      case Verdict::proved_if:
        proved();
        break;
      case Verdict::refuted:
        refuted();
        break;
      case Verdict::underdetermined:
        underdetermined();
        break;
      case Verdict::inconsistent:
        inconsistent();
        break;
      case Verdict::vacuous:
        vacuous();
        break;
      case Verdict::unknown:
        unknown();
        break;
      case Verdict::error:
        error();
        break;
      case Verdict::internal:
        internal();
        break;
    }
    note("note", printable(claim_.note));
    return text_;
  }

 private:
  void note(const std::string& name, const std::string& value) {
    if (!value.empty()) text_ += "       = " + name + ": " + value + "\n";
  }

  void proved() {
    for (const std::string& condition : decision_.conditions) note("only if", condition);
    derived();
    details();
    if (outcome_ == Outcome::as_expected) {
      for (const std::string& condition : decision_.conditions)
        note("help", "where the condition is meant, say so in the case: assume " + condition);
    } else if (claim_.verb == "printed") {
      note("help", "the printed statement is true: this is no erratum");
    } else if (claim_.expectation == Expectation::inconsistent) {
      note("help", "the equations can be solved: write 'gives ...' in place of 'inconsistent'");
    } else {
      note("help", "the statement is true: write 'prove " + claim_.label + ": ...' in place of '" +
                       claim_.verb + "'");
    }
  }

  void refuted() {
    which_statement();
    const WitnessReport& witness = decision_.witness;
    const std::string component =
        witness.component.empty() ? "" : " in component " + witness.component;
    note("left - right" + component, decision_.residual);
    note("witness", in_words(witness));
    const bool minimum = std::holds_alternative<MinimumClaim>(claim_.kind);
    note(minimum ? "value at the candidate" : "left side", witness.left);
    note(minimum ? "value at the competitor" : "right side", witness.right);
    note("reason", printable(decision_.reason));
    derived();
    details();
    if (claim_.expectation == Expectation::open)
      note("help",
           "the statement is false: write 'refute " + claim_.label + ": ...' in place of 'open'");
  }

  // A claim may consist of several statements, of which a person sees only the abbreviation.
  void which_statement() {
    // What a minimum comes to stands in its witness.
    if (std::holds_alternative<MinimumClaim>(claim_.kind)) return;
    const bool identity = std::holds_alternative<IdentityClaim>(claim_.kind);
    const std::vector<Statement>& statements =
        identity ? std::get<IdentityClaim>(claim_.kind).goal.statements
                 : std::get<DeriveClaim>(claim_.kind).gives;
    if (decision_.statement >= statements.size() || (identity && statements.size() == 1)) return;
    const Statement& statement = statements[decision_.statement];
    note("what fails", to_text(statement.left, 200) + " " + sign_of(statement.relation) + " " +
                           to_text(statement.right, 200));
  }

  void derived() {
    for (const auto& [name, value] : decision_.derived) note("derived", name + " = " + value);
  }

  void details() {
    for (const auto& [name, value] : decision_.details) note(name, value);
  }

  void underdetermined() {
    note("free", joined(decision_.free));
    derived();
    note("help", "the equations leave these arbitrary; if that is meant, add: leaves " +
                     joined(decision_.free));
  }

  void inconsistent() {
    note("reason", printable(decision_.reason));
    note("help",
         "no value satisfies the equations; if that is meant, write 'inconsistent' in "
         "place of 'gives ...'");
  }

  void vacuous() {
    note("reason", printable(decision_.reason));
    note("help", "from these assumptions everything would follow; correct an 'assume' of the case");
  }

  void unknown() {
    note("reason", printable(decision_.reason));
    if (decision_.reason.starts_with("limit: "))
      note("help",
           "allow more with --limit-time, --limit-memory, --limit-terms or --limit-steps, "
           "or with 'limit' in the case");
  }

  // The place is often inside a definition, far from the claim.
  void error() {
    if (!decision_.span.source)
      note("reason", printable(decision_.reason));
    else
      text_ += to_text(Diagnostic{decision_.span, decision_.reason, ""});
  }

  void internal() {
    note("reason", printable(decision_.reason));
    note("help", "this is a fault of patchproof itself; please report it together with the case");
  }

  const Claim& claim_;
  const Decision& decision_;
  Outcome outcome_;
  std::string text_;
};

}  // namespace

std::string finding(const Case& of, const ClaimResult& result) {
  const Claim& claim = result.claim;
  // What a derivation asks for stands outside its equations.
  const Span& span =
      claim.verb == "derive" || !claim.statement.source ? claim.span : claim.statement;
  const std::string place = place_of(span);
  std::string text = place.empty() ? "" : place + ": ";
  text += claim_id(of, claim) + ": expected " + expected_verdict(claim.expectation) + ", found " +
          to_text(result.decision.verdict) + "\n";
  return text + excerpt_of(span) + Notes{result}.text();
}

}  // namespace patchproof
