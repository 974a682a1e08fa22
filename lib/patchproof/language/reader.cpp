#include <patchproof/language/reader.hpp>

#include <algorithm>
#include <map>

#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/language/parser.hpp>

namespace patchproof {

namespace {

constexpr std::size_t deepest_include = 20;

class Includer {
 public:
  Includer(Library& library, const Loader& load, std::vector<Diagnostic>& diagnostics)
      : library_{library}, load_{load}, diagnostics_{diagnostics} {}

  void add(const syntax::File& file) {
    open_.push_back(file.source->name);
    for (const syntax::Include& include : file.includes) follow(include, file.source->name);
    for (const syntax::Definition& definition : file.definitions)
      library_.add(definition, diagnostics_);
    open_.pop_back();
  }

 private:
  void follow(const syntax::Include& include, const std::string& from) {
    if (include.path.empty()) {
      diagnostics_.push_back({include.span, "the path of an include is empty", ""});
      return;
    }
    const std::string path = path_beside(from, include.path);
    if (std::find(open_.begin(), open_.end(), path) != open_.end()) {
      diagnostics_.push_back({include.span, "'" + path + "' includes itself", ""});
      return;
    }
    if (done_.contains(path)) return;
    if (open_.size() >= deepest_include) {
      diagnostics_.push_back({include.span, "includes are nested too deeply", ""});
      return;
    }
    const std::optional<std::string> text = load_(path);
    if (!text) {
      diagnostics_.push_back({include.span, "cannot read '" + path + "'",
                              "the path is taken from the folder of the including file"});
      return;
    }
    done_.insert(path);
    const Parsed parsed = parse(std::make_shared<const SourceText>(SourceText{path, *text}));
    diagnostics_.insert(diagnostics_.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
    add(parsed.file);
  }

  Library& library_;
  const Loader& load_;
  std::vector<Diagnostic>& diagnostics_;
  std::vector<std::string> open_;
  std::set<std::string> done_;
};

void add_nets(const syntax::File& file, const Loader& load, Library& library) {
  for (const syntax::Case& written : file.cases)
    for (const syntax::Statement& statement : written.statements)
      for (const syntax::Declarator& declarator : statement.declarators)
        if (declarator.file && !declarator.file->path.empty())
          library.add_net(path_of(*declarator.file), load);
}

// Where a declaration could not be read, the names it would have declared are missing further down;
// complaining about those too would only confuse.
void forget_unknown_names(std::vector<Diagnostic>& diagnostics, std::size_t from) {
  const auto unknown = [](const Diagnostic& d) {
    return d.message.rfind("unknown name", 0) == 0 || d.message.rfind("'using' needs", 0) == 0;
  };
  diagnostics.erase(std::remove_if(diagnostics.begin() + static_cast<std::ptrdiff_t>(from),
                                   diagnostics.end(), unknown),
                    diagnostics.end());
}

// In the order of the text; of very many only the first, and how many more there are.
std::vector<Diagnostic> readable(std::vector<Diagnostic> diagnostics) {
  const std::size_t all = in_order(diagnostics, diagnostics.size()).size();
  std::vector<Diagnostic> result = in_order(std::move(diagnostics));
  if (all > result.size() && !result.empty())
    result.push_back({result.back().span,
                      "and " + std::to_string(all - result.size()) +
                          (all == result.size() + 1 ? " more mistake" : " more mistakes"),
                      ""});
  return result;
}

}  // namespace

ReadFile read_cases(std::shared_ptr<const SourceText> source, const Limits& limits,
                    const Loader& load) {
  ReadFile result;
  const Parsed parsed = parse(std::move(source));
  result.diagnostics = parsed.diagnostics;
  Library library = Library::prelude();
  Includer{library, load, result.diagnostics}.add(parsed.file);
  add_nets(parsed.file, load, library);
  std::map<std::string, Span> names;
  for (const syntax::Case& written : parsed.file.cases) {
    const auto [place, fresh] = names.emplace(written.name.text, written.name.span);
    // A case without a name is a mistake by itself, and has no place.
    if (!fresh && !written.name.text.empty()) {
      const Position at = position_of(*place->second.source, place->second.begin);
      result.diagnostics.push_back({written.name.span,
                                    "case '" + written.name.text + "' occurs twice (first on line " +
                                        std::to_string(at.line) + ")",
                                    ""});
      continue;
    }
    const std::size_t before = result.diagnostics.size();
    Case read = elaborated(written, library, limits, result.diagnostics);
    const bool in_faulty_text = std::any_of(
        parsed.diagnostics.begin(), parsed.diagnostics.end(), [&](const Diagnostic& d) {
          return d.span.begin >= written.span.begin && d.span.begin <= written.span.end;
        });
    if (result.diagnostics.size() == before && !in_faulty_text)
      result.cases.push_back(std::move(read));
    if (in_faulty_text) forget_unknown_names(result.diagnostics, before);
  }
  result.diagnostics = readable(std::move(result.diagnostics));
  return result;
}

Library read_definitions(const std::shared_ptr<const SourceText>& source, const Loader& load,
                         std::vector<Diagnostic>& diagnostics) {
  Library library = Library::prelude();
  const Parsed parsed = parse(source);
  diagnostics.insert(diagnostics.end(), parsed.diagnostics.begin(), parsed.diagnostics.end());
  Includer{library, load, diagnostics}.add(parsed.file);
  add_nets(parsed.file, load, library);
  return library;
}

}  // namespace patchproof
