#include <patchproof/mutation/site.hpp>

#include <algorithm>
#include <map>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

using syntax::Declarator;
using syntax::ExpressionPointer;
using syntax::Statement;
using Word = Statement::Kind;

// The text of a part with the change made.
std::string after(const Span& part, const Edit& edit) {
  Edit inside = edit;
  inside.begin -= part.begin;
  inside.end -= part.begin;
  return changed(as_text(part), {inside});
}

// Without blanks.
std::string packed(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\t'; });
  return text;
}

// " using V11 for i in 0..3"
std::string clauses_of(const Statement& s, const std::string& derived) {
  std::string result;
  for (const syntax::Name& label : s.clauses.using_labels)
    result += (result.empty() ? " using " : ", ") + label.text;
  if (!derived.empty()) result += (result.empty() ? " using " : ", ") + derived;
  std::string binders;
  for (const syntax::Binder& b : s.clauses.binders)
    binders += (binders.empty() ? " for " : ", ") + b.name.text + " in " +
               as_text(b.interval.first->span) + ".." + as_text(b.interval.last->span);
  return result + binders;
}

/// Collects the parts of one case.
class Parts {
 public:
  Parts(const syntax::Case& written, const std::string& fresh)
      : vocabulary_{vocabulary_of(written)}, fresh_{fresh} {}

  std::vector<Site> take() { return std::move(sites_); }

  void add(const Statement& s) {
    if (std::optional<Data> data = data_of(s)) return add_data(*data);
    if (!s.declarators.empty()) return add_declaration(s);
    if (!s.label) return;
    if (s.kind == Word::prove) add_claim(s, s.label->text, s.proposition);
    if (s.kind == Word::erratum) add_claim(s, s.label->text + ".corrected", s.corrected);
    if (s.kind == Word::derive) add_derivation(s);
  }

 private:
  Site& site(Site::Kind kind, const std::string& name, const Span& span) {
    return sites_.emplace_back(Site{kind, name, span, {}});
  }

  void drop_empty() {
    if (sites_.back().errors.empty()) sites_.pop_back();
  }

  // With the same on both sides a statement says nothing, and no data could show that.
  static bool is_trivial(const syntax::Comparison& c, const ExpressionPointer& e,
                         const Edit& edit) {
    const std::string text = packed(after(e->span, edit));
    return std::any_of(c.operands.begin(), c.operands.end(), [&](const ExpressionPointer& other) {
      return other != e && packed(as_text(other->span)) == text;
    });
  }

  void add_operand(const ExpressionPointer& e, const syntax::Comparison* in, const Statement& s,
                   const std::string& derived, Site& site) {
    const bool on_boundary = in != nullptr && in->on_boundary;
    for (TypicalError& error : typical_errors(e, vocabulary_)) {
      if (in != nullptr && is_trivial(*in, e, error.edit)) continue;
      const std::string comparison =
          "\n  prove " + fresh_ + ": (" + as_text(e->span) + ") == (" + after(e->span, error.edit) +
          ")" + (on_boundary ? " on boundary" : "") + clauses_of(s, derived) + "\n";
      site.errors.push_back({std::move(error), comparison, s.span.end});
    }
  }

  // Only equations: a bound that is wrong may still hold.
  void add_claim(const Statement& s, const std::string& label, const syntax::Proposition& stated) {
    Site& added = site(Site::Kind::claim, label, stated.span);
    for (const syntax::Comparison& c : stated.comparisons) {
      const bool is_equation = std::all_of(c.operators.begin(), c.operators.end(),
                                           [](const std::string& sign) { return sign == "=="; });
      if (!is_equation) continue;
      for (const ExpressionPointer& e : c.operands) add_operand(e, &c, s, "", added);
    }
    drop_empty();
  }

  void add_derivation(const Statement& s) {
    Site& added = site(Site::Kind::claim, s.label->text, s.span);
    for (const syntax::Comparison& c : s.proposition.comparisons)
      for (const ExpressionPointer& e : c.operands)
        for (TypicalError& error : typical_errors(e, vocabulary_))
          if (!is_trivial(c, e, error.edit)) added.errors.push_back({std::move(error), "", 0});
    for (const ExpressionPointer& e : s.gives) add_operand(e, nullptr, s, s.label->text, added);
    drop_empty();
  }

  void add_declaration(const Statement& s) {
    for (const Declarator& d : s.declarators) {
      if (!d.value || s.kind == Word::spline) continue;
      Site& added = site(Site::Kind::declaration, d.name.text, declared_span(d));
      for (TypicalError& error : typical_errors(d.value, vocabulary_)) {
        const std::string comparison = copy_of(s, d, error.edit);
        added.errors.push_back({std::move(error), comparison, s.span.end});
      }
      drop_empty();
    }
  }

  static Span declared_span(const Declarator& d) {
    return {d.name.span.source, d.name.span.begin, d.value->span.end};
  }

  // The same declared again with the change, by another name, and that both are equal.
  std::string copy_of(const Statement& s, const Declarator& d, const Edit& edit) const {
    const Span head{d.name.span.source, d.name.span.end, d.value->span.begin};
    const Span properties{
        d.name.span.source,
        s.declarators.back().value ? s.declarators.back().value->span.end : s.span.end, s.span.end};
    return "\n  " + as_text(s.keyword) + " " + fresh_ + as_text(head) + after(d.value->span, edit) +
           as_text(properties) + "\n  prove " + fresh_ + ": " + d.name.text + " == " + fresh_ +
           "\n";
  }

  void add_data(const Data& data) {
    const Declarator& d = data.statement->declarators.front();
    Site& added = site(Site::Kind::data, data.name, declared_span(d));
    for (const Datum& datum : data.numbers) {
      const Edit edit = small_changes(data, datum).front();
      const std::string words =
          datum.owner + ": " + as_text(datum.value->span) + " -> " + edit.text;
      added.errors.push_back({{edit, words}, "", 0});
    }
  }

  Vocabulary vocabulary_;
  std::string fresh_;
  std::vector<Site> sites_;
};

}  // namespace

std::vector<Site> sites_of(const syntax::Case& written, const std::string& fresh) {
  Parts parts{written, fresh};
  for (const Statement& statement : written.statements) parts.add(statement);
  return parts.take();
}

Site site_of(const syntax::Definition& definition) {
  const Vocabulary vocabulary = vocabulary_of(definition);
  Site result{Site::Kind::definition, definition.name.text, definition.span, {}};
  const auto add = [&](const ExpressionPointer& e) {
    for (TypicalError& error : typical_errors(e, vocabulary))
      result.errors.push_back({std::move(error), "", 0});
  };
  for (const Statement& s : definition.statements)
    for (const Declarator& d : s.declarators)
      if (d.value) add(d.value);
  add(definition.value);
  return result;
}

std::vector<SiteError> in_turns(const std::vector<SiteError>& errors) {
  std::map<std::string, std::size_t> turns;
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const TypicalError& error = errors[k].error;
    const bool is_datum = error.edit.what == "datum";
    const std::string kind =
        is_datum ? error.words.substr(0, error.words.find(':')) : error.edit.what;
    order.emplace_back(turns[kind]++, k);
  }
  std::sort(order.begin(), order.end());
  std::vector<SiteError> result;
  for (const auto& [turn, k] : order) result.push_back(errors[k]);
  return result;
}

}  // namespace patchproof
