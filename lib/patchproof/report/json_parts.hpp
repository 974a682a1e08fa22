#pragma once

// Internal to the reports: what several JSON documents have in common.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// JSON whose members stay in the order they were given.
using Json = nlohmann::ordered_json;

/// The text; null for "".
Json text_or_null(const std::string& text);

/// Adds "file", "line" and "column", null without a text.
void add_place(const FilePlace& place, Json& object);
void add_place(const Span& span, Json& object);
/// A whole number that is not negative.
/// @throws std::exception when the value is none.
std::size_t count_from(const Json& value);

/// The place that was added to an object.
/// @throws std::exception when there is none.
FilePlace place_from(const Json& object);

/// Adds "diagnostics" and "unreadable": what could not be read of the files.
void add_mistakes(const FileRecords& files, Json& document);

/// "values", "left", "right" and "component" of a refuted claim; null for any other.
Json witness_of(const Decision& decision);

/// Named values as a list of objects, in their order.
Json named_values(const std::vector<std::pair<std::string, std::string>>& values);

/// The document as text; bytes that are not valid UTF-8 become U+FFFD.
std::string in_lines(const Json& document);

}  // namespace patchproof
