#include <patchproof/certificate/json_certificate.hpp>

#include <patchproof/certificate/term_table.hpp>
#include <patchproof/term/replacement.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

using Json = CertificateJson;

const char* sign_of(Relation relation) {
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
    case Relation::greater_equal:
      return ">=";
  }
  throw std::logic_error{"a relation without a sign"};
}

/// Writes one certificate; its terms go to the table.
class Writer {
 public:
  Json of(const Certificate& certificate) {
    const Json content =
        std::visit([&](const auto& c) { return of_content(c); }, certificate.content);
    Json result{{"claim", certificate.claim},
                {"statement", certificate.statement},
                {"symbols", table_.symbols()},
                {"nodes", table_.nodes()}};
    const bool refuted = std::holds_alternative<Refutation>(certificate.content);
    result[refuted ? "refutation" : "proofs"] = content;
    return result;
  }

 private:
  template <typename Part, typename Function>
  static Json list(const std::vector<Part>& parts, const Function& written) {
    Json result = Json::array();
    for (const Part& part : parts) result.push_back(written(part));
    return result;
  }

  Json of_content(const std::vector<SequentProof>& proofs) {
    return list(proofs, [&](const SequentProof& proof) {
      return Json{
          {"sequent", of(proof.sequent)},
          {"components", list(proof.components, [&](const auto& c) { return of(c, proof); })},
          {"not_zero", list(proof.not_zero, [&](const auto& n) { return of(n, proof); })},
          {"divisors", list(proof.divisors, [&](const Divisor& d) {
             return Json{{"factor", table_.node(d.factor)}, {"product", d.product}};
           })}};
    });
  }

  Json of_content(const Refutation& refutation) {
    Json sequent = of(refutation.sequent);
    Json values = list(refutation.values, [&](const KnownValue& value) {
      return Json{{"symbol", table_.symbol(value.symbol)}, {"value", table_.node(value.value)}};
    });
    return {{"sequent", std::move(sequent)},
            {"values", std::move(values)},
            {"conclusion", refutation.conclusion},
            {"component", refutation.component}};
  }

  Json of(const Statement& statement) {
    const std::size_t left = table_.node(statement.left);
    const std::size_t right = table_.node(statement.right);
    return {{"left", left}, {"relation", sign_of(statement.relation)}, {"right", right}};
  }

  Json of(const Sequent& sequent) {
    const Json hypotheses = list(sequent.hypotheses, [&](const Assumption& assumption) {
      Json result{{"label", assumption.label}};
      result.update(of(assumption.statement));
      return result;
    });
    const Json ranges = list(sequent.ranges, [&](const ParameterRange& range) {
      const std::size_t parameter = table_.symbol(range.parameter);
      const std::size_t lower = table_.node(range.lower);
      return Json{{"parameter", parameter}, {"lower", lower}, {"upper", table_.node(range.upper)}};
    });
    const Json conclusions =
        list(sequent.conclusions, [&](const Statement& statement) { return of(statement); });
    return {{"hypotheses", hypotheses}, {"ranges", ranges}, {"conclusions", conclusions}};
  }

  Json of(const Cofactor& cofactor, const SequentProof& proof) {
    const Instance& instance = cofactor.equation;
    const Statement& equation = proof.sequent.hypotheses.at(instance.hypothesis).statement;
    std::map<unsigned, SymbolPointer> symbols = free_symbols(equation.left);
    symbols.merge(free_symbols(equation.right));
    Json at = Json::array();
    std::size_t next = 0;
    for (const auto& [ordinal, symbol] : symbols) {
      if (symbol->role != Symbol::Role::parameter) continue;
      Json entry{{"parameter", table_.symbol(symbol)}};
      entry["value"] = table_.node(instance.at.at(next));
      if (next < instance.orders.size() && instance.orders[next] != 0)
        entry["order"] = instance.orders[next];
      at.push_back(std::move(entry));
      ++next;
    }
    if (next != instance.at.size())
      throw std::logic_error{"an instance of a hypothesis with too many values"};
    return {{"hypothesis", instance.hypothesis},
            {"component", instance.component},
            {"at", std::move(at)},
            {"factor", table_.node(cofactor.factor)}};
  }

  Json cofactors(const std::vector<Cofactor>& all, const SequentProof& proof) {
    return list(all, [&](const Cofactor& cofactor) { return of(cofactor, proof); });
  }

  Json of(const Combination& combination, const SequentProof& proof) {
    const Json summands = list(combination.summands, [&](const Summand& summand) {
      const auto node = [&](const Term& square) { return Json(table_.node(square)); };
      const auto fact = [](const auto& f) {
        return Json{{"fact", f.first}, {"exponent", f.second}};
      };
      return Json{{"coefficient", to_text(summand.coefficient)},
                  {"squares", list(summand.squares, node)},
                  {"facts", list(summand.facts, fact)}};
    });
    return {{"summands", summands}, {"cofactors", cofactors(combination.cofactors, proof)}};
  }

  Json of(const SignProof& sign, const SequentProof& proof) {
    Json result{
        {"steps", list(sign.steps, [&](const SignProof::Step& step) {
           const std::size_t fact = table_.node(step.fact);
           return Json{{"fact", fact}, {"strict", step.strict}, {"why", of(step.why, proof)}};
         })}};
    if (const auto* end = std::get_if<Combination>(&sign.end)) {
      result["end"] = of(*end, proof);
      return result;
    }
    const auto& cut = std::get<SignProof::Cut>(sign.end);
    const std::size_t at = table_.node(cut.at);
    result["cut"] = {{"at", at},
                     {"cases", list(cut.cases, [&](const SignProof& c) { return of(c, proof); })}};
    return result;
  }

  Json of(const ComponentProof& component, const SequentProof& proof) {
    Json result{{"conclusion", component.conclusion}, {"component", component.component}};
    if (const auto* equation = std::get_if<EquationProof>(&component.why))
      result["equation"] = cofactors(equation->cofactors, proof);
    else
      result["sign"] = of(std::get<SignProof>(component.why), proof);
    if (component.negative) result["negative"] = true;
    return result;
  }

  Json of(const NonZero& claim, const SequentProof& proof) {
    Json result{{"scalar", table_.node(claim.scalar)}};
    if (claim.hypothesis) result["hypothesis"] = *claim.hypothesis;
    if (claim.sign) result["sign"] = of(*claim.sign, proof);
    if (claim.negative) result["negative"] = true;
    return result;
  }

  TermTable table_;
};

/// The text of a JSON value over several lines, unless it fits on one.
std::string in_lines(const Json& json, const std::string& indent) {
  constexpr std::size_t longest = 96;
  const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (json.empty() || !json.is_structured() || indent.size() + line.size() <= longest) return line;
  const std::string inside = indent + "  ";
  std::string text = json.is_array() ? "[" : "{";
  for (auto part = json.begin(); part != json.end(); ++part) {
    text += (part == json.begin() ? "\n" : ",\n") + inside;
    if (json.is_object()) text += Json(part.key()).dump() + ": ";
    text += in_lines(*part, inside);
  }
  return text + "\n" + indent + (json.is_array() ? "]" : "}");
}

}  // namespace

std::string json_certificates(const std::string& case_name,
                              const std::vector<Certificate>& certificates) {
  Json written = Json::array();
  for (const Certificate& certificate : certificates) written.push_back(Writer{}.of(certificate));
  Json document;
  document["format"] = "patchproof certificate";
  document["version"] = 1;
  document["program"] = "patchproof " + std::string{version};
  document["case"] = case_name;
  document["certificates"] = std::move(written);
  return in_lines(document, "") + "\n";
}

}  // namespace patchproof
