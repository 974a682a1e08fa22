#include <patchproof/language/library.hpp>

#include <algorithm>
#include <functional>
#include <set>

#include <patchproof/language/builtins.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/language/parser.hpp>
#include <patchproof/language/prelude.hpp>

namespace patchproof {

namespace {

using syntax::Expression;

// Looks at every name of a definition before anyone uses it.
class NameCheck {
 public:
  NameCheck(const Library& library, const syntax::Definition& definition,
            std::vector<Diagnostic>& diagnostics)
      : library_{library}, definition_{definition}, diagnostics_{diagnostics} {
    for (const syntax::Formal& formal : definition.formals) add_new(formal.name);
    for (const syntax::Name& name : definition.result.parameters) add_new(name);
  }

  void run() {
    for (const syntax::Statement& statement : definition_.statements) {
      for (const syntax::Declarator& local : statement.declarators) {
        if (local.value) look(*local.value);
        add_new(local.name);
      }
    }
    if (definition_.value) look(*definition_.value);
  }

 private:
  void add_new(const syntax::Name& name) {
    if (!known_.insert(name.text).second)
      diagnostics_.push_back({name.span, "'" + name.text + "' is declared twice in this definition", ""});
  }

  void look(const Expression& e) {
    if (e.kind == Expression::Kind::name) check(e);
    std::set<std::string> bound;
    for (const syntax::Argument& a : e.arguments) {
      const auto& interval = a.binder ? std::optional{a.binder->interval} : a.interval;
      if (interval) {
        look(*interval->first);
        look(*interval->last);
      }
      if (a.binder && known_.insert(a.binder->name.text).second) bound.insert(a.binder->name.text);
      if (!a.range) continue;
      look(*a.range->range.lower);
      look(*a.range->range.upper);
      if (known_.insert(a.range->name.text).second) bound.insert(a.range->name.text);
    }
    for (const auto& operand : e.operands) look(*operand);
    for (const syntax::Argument& a : e.arguments)
      if (a.value) look(*a.value);
    for (const auto& row : e.rows)
      for (const auto& entry : row) look(*entry);
    for (const std::string& name : bound) known_.erase(name);
  }

  bool is_known(const std::string& name) const {
    return known_.contains(name) || library_.find(name) != nullptr || is_builtin(name) ||
           name == "pi";
  }

  void check(const Expression& e) {
    const std::string base = e.text.substr(0, e.text.find('\''));
    if (is_known(base) || known_.contains(base.substr(0, base.rfind('_')))) return;
    if (base == definition_.name.text) {
      diagnostics_.push_back({e.span, "the definition of '" + base + "' uses itself",
                              "a definition may use only definitions above it"});
      return;
    }
    std::vector<std::string> names{known_.begin(), known_.end()};
    names.insert(names.end(), library_.names().begin(), library_.names().end());
    for (const std::string& builtin : builtin_names()) names.push_back(builtin);
    diagnostics_.push_back({e.span, "unknown name '" + base + "'", did_you_mean(base, names)});
  }

  const Library& library_;
  const syntax::Definition& definition_;
  std::vector<Diagnostic>& diagnostics_;
  std::set<std::string> known_;
};

Library read_prelude() {
  Library library;
  std::vector<Diagnostic> diagnostics;
  for (const auto& [name, text] : prelude_files()) {
    const auto source = std::make_shared<const SourceText>(
        SourceText{"prelude/" + std::string{name}, std::string{text}});
    const Parsed parsed = parse(source);
    diagnostics.insert(diagnostics.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
    for (const syntax::Definition& definition : parsed.file.definitions)
      library.add(definition, diagnostics);
  }
  if (!diagnostics.empty())
    throw std::logic_error{"the prelude is faulty:\n" + to_text(diagnostics.front())};
  return library;
}

}  // namespace

const Library& Library::prelude() {
  static const Library library = read_prelude();
  return library;
}

void Library::add(const syntax::Definition& definition, std::vector<Diagnostic>& diagnostics) {
  const std::string& name = definition.name.text;
  if (find(name) != nullptr) {
    diagnostics.push_back({definition.name.span, "'" + name + "' is already defined", ""});
    return;
  }
  if (is_builtin(name) || name == "pi") {
    diagnostics.push_back(
        {definition.name.span, "'" + name + "' has a meaning of its own and cannot be defined", ""});
    return;
  }
  NameCheck{*this, definition, diagnostics}.run();
  // Kept even when faulty: cases that use it are not to complain about an unknown name as well.
  if (definition.value) {
    definitions_.emplace(name, definition);
    names_.push_back(name);
  }
}

void Library::add_net(const std::string& path, const Loader& load) {
  if (!nets_.contains(path)) nets_.emplace(path, net_file(path, load));
}

const NetFile* Library::net(const std::string& path) const {
  const auto found = nets_.find(path);
  return found == nets_.end() ? nullptr : &found->second;
}

const syntax::Definition* Library::find(const std::string& name) const {
  const auto found = definitions_.find(name);
  return found == definitions_.end() ? nullptr : &found->second;
}

}  // namespace patchproof
