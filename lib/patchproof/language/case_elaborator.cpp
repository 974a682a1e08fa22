#include <patchproof/language/case_elaborator.hpp>

#include <algorithm>

#include <patchproof/language/nearest_name.hpp>
#include <patchproof/language/notation_check.hpp>

namespace patchproof {

namespace {

using WrittenStatement = syntax::Statement;

// 0 stands for no limit.
template <typename Amount>
void lower(Amount& limit, Amount to) {
  limit = limit == Amount{} ? to : std::min(limit, to);
}

void set_limit(const WrittenStatement& statement, Limits& limits, std::vector<Diagnostic>& diagnostics) {
  const std::string kind = statement.limit_kind ? statement.limit_kind->text : "";
  const std::string unit = statement.limit_unit ? statement.limit_unit->text : "";
  const Rational value = statement.limit_value.value_or(0);
  const auto whole = [&](const Rational& scaled, const Rational& largest) {
    const Rational bounded = std::min(scaled, largest);
    return static_cast<std::uint64_t>(Integer{numerator(bounded) / denominator(bounded)});
  };
  const auto wrong_unit = [&](const std::string& expected) {
    diagnostics.push_back({statement.limit_unit->span, "unknown unit '" + unit + "'", expected});
  };
  const Rational most{1'000'000'000'000LL};
  const Rational smallest = kind == "memory"                 ? Rational{1, 1'048'576}
                            : kind == "time" && unit != "ms" ? Rational{1, 1000}
                                                             : Rational{1};
  if (value < smallest) {
    diagnostics.push_back(
        {statement.span, "a limit is more than 0", "leave it out for no limit of its own"});
    return;
  }
  if (kind == "time") {
    if (!unit.empty() && unit != "s" && unit != "ms") return wrong_unit("time is given in s or ms");
    const Rational milliseconds = unit == "ms" ? value : Rational{value * 1000};
    lower(limits.time, std::chrono::milliseconds{whole(milliseconds, Rational{86'400'000})});
  } else if (kind == "memory") {
    if (!unit.empty() && unit != "MB" && unit != "GB")
      return wrong_unit("memory is given in MB or GB");
    lower<std::size_t>(limits.memory,
                       whole(value * (unit == "GB" ? 1'073'741'824 : 1'048'576), most));
  } else if (kind == "terms") {
    lower<std::size_t>(limits.terms, whole(value, most));
  } else {
    lower(limits.steps, whole(value, most));
  }
}

void set_title(const WrittenStatement& statement, Case& result,
               std::vector<Diagnostic>& diagnostics) {
  if (!statement.language) {
    result.title = statement.text;
  } else if (!result.translated_titles.emplace(statement.language->text, statement.text).second) {
    diagnostics.push_back({statement.span, "a second title in the language '" +
                                               statement.language->text + "'", ""});
  }
}

void set_notation(const WrittenStatement& statement, Notation& notation,
                  std::vector<Diagnostic>& diagnostics) {
  if (statement.derivative_style)
    notation.derivatives = statement.derivative_style->text == "superscript"
                               ? DerivativeStyle::superscript
                           : statement.derivative_style->text == "fraction"
                               ? DerivativeStyle::fraction
                               : DerivativeStyle::subscript;
  for (const syntax::Notation& entry : statement.notations) {
    try {
      check_notation(entry);
      if (!notation.names.emplace(entry.name.text, entry.latex).second)
        throw Fault{entry.name.span, "'" + entry.name.text + "' already has a notation"};
    } catch (const Fault& fault) {
      diagnostics.push_back(fault.diagnostic);
    }
  }
}

// A notation of a name that is not there would be a slip that nobody sees.
void check_notated_names(const syntax::Case& written, const Scope& scope, const Library& library,
                         std::vector<Diagnostic>& diagnostics) {
  for (const WrittenStatement& statement : written.statements) {
    for (const syntax::Notation& entry : statement.notations) {
      const std::string& name = entry.name.text;
      if (scope.find(name) != nullptr || library.find(name) != nullptr) continue;
      std::vector<std::string> known = scope.names();
      diagnostics.push_back({entry.name.span, "a notation for '" + name + "', which is not declared",
                             did_you_mean(name, known)});
    }
  }
}

void set_meta(const WrittenStatement& statement, Case& result, std::vector<Diagnostic>& diagnostics) {
  switch (statement.kind) {
    case WrittenStatement::Kind::title: set_title(statement, result, diagnostics); break;
    case WrittenStatement::Kind::quote: result.quote = statement.text; break;
    case WrittenStatement::Kind::source:
      result.sources.push_back({statement.text,
                                statement.language ? statement.language->text : "",
                                statement.section.value_or(""), statement.page.value_or("")});
      break;
    case WrittenStatement::Kind::tags:
      for (const syntax::Name& tag : statement.tags) result.tags.push_back(tag.text);
      break;
    case WrittenStatement::Kind::notation: set_notation(statement, result.notation, diagnostics); break;
    default: set_limit(statement, result.limits, diagnostics); break;
  }
}

bool is_meta(WrittenStatement::Kind kind) {
  return kind == WrittenStatement::Kind::title || kind == WrittenStatement::Kind::source ||
         kind == WrittenStatement::Kind::quote || kind == WrittenStatement::Kind::tags ||
         kind == WrittenStatement::Kind::limit || kind == WrittenStatement::Kind::notation;
}

// The running indices of the family; a case without one has none.
std::vector<syntax::Binder> family_of(const syntax::Case& written) {
  std::vector<syntax::Binder> result;
  for (const WrittenStatement& statement : written.statements)
    if (statement.kind == WrittenStatement::Kind::family)
      result.insert(result.end(), statement.binders.begin(), statement.binders.end());
  return result;
}

}  // namespace

bool has_meaning(syntax::Statement::Kind kind) {
  return !is_meta(kind) && kind != WrittenStatement::Kind::family;
}

std::vector<CaseInstance> instances_of(const syntax::Case& written, const Library& library) {
  const std::vector<syntax::Binder> family = family_of(written);
  Workshop workshop;
  Elaborator elaborator{library, workshop};
  std::vector<CaseInstance> result;
  for (const std::vector<int>& values :
       elaborator.combinations(family, Scope{}, most_instances)) {
    CaseInstance& instance = result.emplace_back();
    for (std::size_t k = 0; k < family.size(); ++k) {
      instance.text += (instance.text.empty() ? "" : ",") + family[k].name.text + "=" +
                       std::to_string(values[k]);
      instance.values.emplace_back(family[k].name, values[k]);
    }
  }
  return result;
}

Case elaborated(const syntax::Case& written, const Library& library, const Limits& limits,
                std::vector<Diagnostic>& diagnostics) {
  Case result;
  result.name = written.name.text;
  result.limits = limits;
  result.span = written.name.span;
  result.whole = written.span;
  for (const WrittenStatement& statement : written.statements)
    if (is_meta(statement.kind)) set_meta(statement, result, diagnostics);
  std::vector<CaseInstance> instances;
  try {
    instances = instances_of(written, library);
  } catch (const Fault& fault) {
    diagnostics.push_back(fault.diagnostic);
    return result;
  }
  for (const CaseInstance& instance : instances) {
    const std::size_t before = diagnostics.size();
    CaseElaborator elaborator{library, instance.text, diagnostics};
    for (const auto& [name, value] : instance.values)
      elaborator.declare_number(name.text, value, name.span);
    for (const WrittenStatement& statement : written.statements)
      if (has_meaning(statement.kind)) elaborator.statement(statement, result);
    if (&instance == &instances.front()) {
      check_notated_names(written, elaborator.scope(), library, diagnostics);
      result.joined = elaborator.joined();
    }
    // One faulty instance is enough: the others would repeat its messages.
    if (diagnostics.size() > before) break;
  }
  return result;
}

}  // namespace patchproof
