#include <patchproof/report/claim_json.hpp>

#include <patchproof/report/summary.hpp>

namespace patchproof {

namespace {

// The inverse of `to_text` for the enumerations of a report, whose last value is `last`.
template <typename Enumeration>
Enumeration value_of(const std::string& text, Enumeration last) {
  for (int k = 0; k <= static_cast<int>(last); ++k)
    if (to_text(static_cast<Enumeration>(k)) == text) return static_cast<Enumeration>(k);
  throw std::invalid_argument{"'" + text + "' has no meaning here"};
}

std::string text_of(const Json& object, const char* member) {
  const Json& value = object.at(member);
  return value.is_null() ? "" : value.get<std::string>();
}

std::vector<std::string> texts_of(const Json& object, const char* member) {
  return object.at(member).get<std::vector<std::string>>();
}

std::vector<std::pair<std::string, std::string>> values_of(const Json& list) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const Json& one : list)
    values.emplace_back(one.at("name").get<std::string>(), one.at("value").get<std::string>());
  return values;
}

Json to_json(const Subdivision& tree) {
  if (tree.boxes == 0) return nullptr;
  return {{"boxes", tree.boxes}, {"depth", tree.depth}};
}

Json to_json(const JointReport& joint) {
  Json object;
  object["parametric"] = joint.parametric ? Json(*joint.parametric) : Json{};
  object["one_polynomial"] = joint.one_polynomial;
  object["geometric"] = joint.geometric ? Json(*joint.geometric) : Json{};
  object["next_parametric"] = text_or_null(joint.next_parametric);
  object["next_geometric"] = text_or_null(joint.next_geometric);
  object["conditions"] = joint.conditions;
  return object;
}

JointReport joint_from(const Json& object) {
  JointReport joint;
  const auto order = [&](const char* member) {
    const Json& value = object.at(member);
    return value.is_null() ? std::optional<int>{} : value.get<int>();
  };
  joint.parametric = order("parametric");
  joint.one_polynomial = object.at("one_polynomial").get<bool>();
  joint.geometric = order("geometric");
  joint.next_parametric = text_of(object, "next_parametric");
  joint.next_geometric = text_of(object, "next_geometric");
  joint.conditions = texts_of(object, "conditions");
  return joint;
}

Decision decision_from(const Json& object) {
  Decision decision;
  decision.verdict = value_of(text_of(object, "verdict"), Verdict::internal);
  decision.evidence = value_of(text_of(object, "evidence"), Evidence::certified);
  decision.certificate = text_of(object, "certificate");
  decision.reason = text_of(object, "reason");
  decision.conditions = texts_of(object, "conditions");
  decision.residual = text_of(object, "residual");
  decision.assumptions_used = texts_of(object, "assumptions_used");
  decision.derived = values_of(object.at("derived"));
  decision.free = texts_of(object, "free");
  decision.details = values_of(object.at("details"));
  if (const Json& witness = object.at("witness"); !witness.is_null())
    decision.witness = {values_of(witness.at("values")),
                        {},
                        text_of(witness, "left"),
                        text_of(witness, "right"),
                        text_of(witness, "component")};
  if (const Json& tree = object.at("subdivision"); !tree.is_null())
    decision.subdivision = {count_from(tree.at("boxes")),
                            static_cast<unsigned>(count_from(tree.at("depth")))};
  return decision;
}

}  // namespace

Json to_json(const ClaimRecord& claim, const std::string& of) {
  const Decision& decision = claim.decision;
  Json object;
  object["id"] = claim.id;
  object["case"] = of;
  object["label"] = claim.label;
  object["instance"] = text_or_null(claim.instance);
  add_place(claim.place, object);
  object["verb"] = claim.verb;
  object["statement"] = claim.statement;
  object["expectation"] = to_text(claim.expectation);
  object["verdict"] = to_text(decision.verdict);
  object["as_expected"] = claim.outcome == Outcome::as_expected;
  object["outcome"] = to_text(claim.outcome);
  object["evidence"] = to_text(decision.evidence);
  object["certificate"] = text_or_null(decision.certificate);
  object["reason"] = text_or_null(decision.reason);
  object["conditions"] = decision.conditions;
  object["witness"] = witness_of(decision);
  object["subdivision"] = to_json(decision.subdivision);
  object["residual"] = text_or_null(decision.residual);
  object["assumptions_used"] = decision.assumptions_used;
  object["derived"] = named_values(decision.derived);
  object["free"] = decision.free;
  object["details"] = named_values(decision.details);
  object["note"] = text_or_null(claim.note);
  object["finding"] = text_or_null(claim.finding);
  return object;
}

ClaimRecord claim_from(const Json& object) {
  ClaimRecord claim;
  claim.id = text_of(object, "id");
  claim.label = text_of(object, "label");
  claim.instance = text_of(object, "instance");
  claim.place = place_from(object);
  claim.verb = text_of(object, "verb");
  claim.statement = text_of(object, "statement");
  claim.expectation = value_of(text_of(object, "expectation"), Expectation::inconsistent);
  claim.decision = decision_from(object);
  claim.outcome = value_of(text_of(object, "outcome"), Outcome::internal);
  // What is undecided for want of a process is unknown, also where "open" was expected.
  const bool is_unknown =
      claim.outcome == Outcome::unknown && claim.decision.verdict == Verdict::unknown;
  if (claim.outcome != outcome_of(claim.expectation, claim.decision.verdict) && !is_unknown)
    throw std::invalid_argument{"the outcome of '" + claim.id + "' does not fit its verdict"};
  claim.note = text_of(object, "note");
  claim.finding = text_of(object, "finding");
  if (object.contains("position")) claim.position = count_from(object.at("position"));
  return claim;
}

Json to_json(const ShownRecord& shown, const std::string& of) {
  Json object;
  object["case"] = of;
  object["instance"] = text_or_null(shown.instance);
  add_place(shown.place, object);
  object["term"] = shown.term;
  object["value"] = shown.value;
  if (shown.joint) object["joint"] = to_json(*shown.joint);
  if (shown.is_lost) object["lost"] = true;
  return object;
}

ShownRecord shown_from(const Json& object) {
  ShownRecord shown{place_from(object),
                    text_of(object, "instance"),
                    text_of(object, "term"),
                    text_of(object, "value"),
                    std::nullopt,
                    object.contains("lost")};
  if (object.contains("joint")) shown.joint = joint_from(object.at("joint"));
  return shown;
}

Json to_json(const DiagnosticRecord& diagnostic) {
  Json object;
  add_place(diagnostic.place, object);
  object["message"] = diagnostic.message;
  object["help"] = text_or_null(diagnostic.help);
  return object;
}

DiagnosticRecord diagnostic_from(const Json& object) {
  DiagnosticRecord record{place_from(object), text_of(object, "message"), text_of(object, "help"),
                          ""};
  const FilePlace& place = record.place;
  if (!place.file.empty())
    record.text =
        place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
  record.text += "error: " + record.message + "\n";
  if (!record.help.empty()) record.text += "       = help: " + record.help + "\n";
  return record;
}

}  // namespace patchproof
