#include <recheck/place.hpp>

#include <algorithm>
#include <set>

namespace recheck {

void Place::fail(const std::string& problem) const {
  throw Unreadable{(path_.empty() ? "" : path_ + ": ") + problem};
}

void Place::require_members(const std::vector<std::string_view>& names) const {
  if (!json_->is_object()) fail("an object is needed here");
  std::set<std::string_view> known;
  for (std::string_view name : names) {
    const bool optional = name.starts_with('?');
    if (optional) name.remove_prefix(1);
    known.insert(name);
    if (!optional && !has(name)) fail("the member '" + std::string{name} + "' is missing");
  }
  for (const auto& [name, value] : json_->items())
    if (!known.contains(name)) fail("the member '" + name + "' is not known");
}

bool Place::has(std::string_view name) const {
  return json_->is_object() && json_->contains(std::string{name});
}

Place Place::operator[](std::string_view name) const {
  if (!has(name)) fail("the member '" + std::string{name} + "' is missing");
  return {json_->at(std::string{name}), (path_.empty() ? "" : path_ + ".") + std::string{name}};
}

std::vector<Place> Place::items() const {
  constexpr std::size_t most = 1'000'000;
  if (!json_->is_array()) fail("a list is needed here");
  if (json_->size() > most) fail("the list is too long");
  std::vector<Place> result;
  for (std::size_t k = 0; k < json_->size(); ++k)
    result.emplace_back((*json_)[k], path_ + "[" + std::to_string(k) + "]");
  return result;
}

std::string Place::text() const {
  if (!json_->is_string()) fail("a text is needed here");
  return json_->get<std::string>();
}

bool Place::truth() const {
  if (!json_->is_boolean()) fail("true or false is needed here");
  return json_->get<bool>();
}

std::size_t Place::whole(std::size_t limit) const {
  if (!json_->is_number_unsigned()) fail("a whole number is needed here");
  const auto number = json_->get<std::uint64_t>();
  if (number >= limit) fail(std::to_string(number) + " is too large");
  return static_cast<std::size_t>(number);
}

long Place::integer(std::size_t limit) const {
  if (!json_->is_number_integer()) fail("a whole number is needed here");
  const auto most = static_cast<std::int64_t>(limit);
  // Large numbers without sign would be negative ones here.
  if (json_->is_number_unsigned() && json_->get<std::uint64_t>() > limit)
    fail("this number is too large");
  const auto number = json_->get<std::int64_t>();
  if (number > most || number < -most) fail("this number is too large");
  return static_cast<long>(number);
}

Rational Place::number() const {
  const std::optional<Rational> found = number_of(text());
  if (!found) fail("'" + text().substr(0, 40) + "' is no exact number in lowest terms");
  return *found;
}

std::size_t Place::one_of(const std::vector<std::string_view>& texts) const {
  const std::string found = text();
  const auto place = std::find(texts.begin(), texts.end(), found);
  if (place == texts.end()) fail("'" + found.substr(0, 40) + "' is not known here");
  return static_cast<std::size_t>(place - texts.begin());
}

namespace {

// The text outside of strings decides how deep brackets are nested.
bool is_nested_deeper(const std::string& text, std::size_t limit) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (in_string) {
      if (text[k] == '\\')
        ++k;
      else if (text[k] == '"')
        in_string = false;
      continue;
    }
    if (text[k] == '"') in_string = true;
    if (text[k] == '[' || text[k] == '{') ++depth;
    if ((text[k] == ']' || text[k] == '}') && depth > 0) --depth;
    if (depth > limit) return true;
  }
  return false;
}

}  // namespace

nlohmann::json json_of(const std::string& text, const Limits& limits) {
  using Json = nlohmann::json;
  if (text.size() > limits.bytes) throw Unreadable{"the text is too long"};
  if (is_nested_deeper(text, limits.nesting)) throw Unreadable{"the text is nested too deeply"};
  // Of two members with one name a reader would see only one.
  std::vector<std::set<std::string>> open;
  const auto look = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
      throw Unreadable{"the member '" + parsed.get<std::string>() + "' stands twice in one object"};
    return true;
  };
  try {
    return Json::parse(text, look);
  } catch (const Json::exception& error) {
    throw Unreadable{std::string{"this is no JSON: "} + error.what()};
  }
}

}  // namespace recheck
