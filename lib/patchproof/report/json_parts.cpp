#include <patchproof/report/json_parts.hpp>

namespace patchproof {

namespace {

Json to_json(const Diagnostic& diagnostic) {
  Json object;
  add_place(diagnostic.span, object);
  object["message"] = diagnostic.message;
  object["help"] = text_or_null(diagnostic.help);
  return object;
}

}  // namespace

Json text_or_null(const std::string& text) { return text.empty() ? Json{} : Json(text); }

Json named_values(const std::vector<std::pair<std::string, std::string>>& values) {
  Json list = Json::array();
  for (const auto& [name, value] : values) list.push_back({{"name", name}, {"value", value}});
  return list;
}

void add_place(const Span& span, Json& object) {
  if (!span.source) {
    object["file"] = object["line"] = object["column"] = nullptr;
    return;
  }
  const Position position = position_of(*span.source, span.begin);
  object["file"] = span.source->name;
  object["line"] = position.line;
  object["column"] = position.column;
}

Json witness_of(const Decision& decision) {
  if (decision.verdict != Verdict::refuted) return nullptr;
  const WitnessReport& witness = decision.witness;
  return {{"values", named_values(witness.values)},
          {"left", witness.left},
          {"right", witness.right},
          {"component", text_or_null(witness.component)}};
}

void add_mistakes(const std::vector<FileReport>& files, Json& document) {
  Json diagnostics = Json::array();
  Json unreadable = Json::array();
  for (const FileReport& file : files) {
    if (!file.unreadable.empty())
      unreadable.push_back({{"path", file.path}, {"message", file.unreadable}});
    for (const Diagnostic& diagnostic : file.diagnostics)
      diagnostics.push_back(to_json(diagnostic));
  }
  document["diagnostics"] = std::move(diagnostics);
  document["unreadable"] = std::move(unreadable);
}

std::string in_lines(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace patchproof
