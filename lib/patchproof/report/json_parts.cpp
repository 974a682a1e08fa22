#include <patchproof/report/json_parts.hpp>

#include <stdexcept>

#include <patchproof/report/claim_json.hpp>

namespace patchproof {

Json text_or_null(const std::string& text) { return text.empty() ? Json{} : Json(text); }

Json named_values(const std::vector<std::pair<std::string, std::string>>& values) {
  Json list = Json::array();
  for (const auto& [name, value] : values) list.push_back({{"name", name}, {"value", value}});
  return list;
}

void add_place(const FilePlace& place, Json& object) {
  if (place.file.empty()) {
    object["file"] = object["line"] = object["column"] = nullptr;
    return;
  }
  object["file"] = place.file;
  object["line"] = place.line;
  object["column"] = place.column;
}

void add_place(const Span& span, Json& object) { add_place(place_at(span), object); }

std::size_t count_from(const Json& value) {
  if (!value.is_number_unsigned()) throw std::invalid_argument{"a whole number is wanted"};
  return value.get<std::size_t>();
}

FilePlace place_from(const Json& object) {
  if (object.at("file").is_null()) return {};
  return {object.at("file").get<std::string>(), count_from(object.at("line")),
          count_from(object.at("column"))};
}

Json witness_of(const Decision& decision) {
  if (decision.verdict != Verdict::refuted) return nullptr;
  const WitnessReport& witness = decision.witness;
  return {{"values", named_values(witness.values)},
          {"left", witness.left},
          {"right", witness.right},
          {"component", text_or_null(witness.component)}};
}

void add_mistakes(const FileRecords& files, Json& document) {
  Json diagnostics = Json::array();
  Json unreadable = Json::array();
  const Summary& summary = files.summary();
  // Looking at many files takes its time.
  if (summary.mistakes > 0 || summary.unreadable_files > 0)
    files.for_each([&](const FileRecord& file) {
      if (!file.unreadable.empty())
        unreadable.push_back({{"path", file.path}, {"message", file.unreadable}});
      for (const DiagnosticRecord& diagnostic : file.diagnostics)
        diagnostics.push_back(to_json(diagnostic));
    });
  document["diagnostics"] = std::move(diagnostics);
  document["unreadable"] = std::move(unreadable);
}

std::string in_lines(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace patchproof
