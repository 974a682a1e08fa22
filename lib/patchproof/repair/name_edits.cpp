#include <patchproof/repair/name_edits.hpp>

namespace patchproof {

namespace {

/// A name and what marks it as a derivative: C1 and '', r and _uv.
struct Parts {
  std::string base;
  std::string marks;
};

Parts parts_of(const std::string& text, const Names& names) {
  const std::string unprimed = text.substr(0, text.find('\''));
  const std::size_t underscore = unprimed.rfind('_');
  const bool is_whole = names.is_declared(unprimed) || names.is_definition(unprimed) ||
                        underscore == std::string::npos || underscore == 0;
  const std::size_t end = is_whole ? unprimed.size() : underscore;
  return {text.substr(0, end), text.substr(end)};
}

// "_uv" in parameters u, v: "_uu", "_vv".
std::vector<std::string> other_suffixes(const std::string& suffix,
                                        const std::vector<std::string>& parameters) {
  std::vector<std::string> result;
  for (std::size_t k = 1; k < suffix.size(); ++k) {
    for (const std::string& parameter : parameters) {
      if (parameter.size() != 1 || suffix[k] == parameter[0]) continue;
      result.push_back(suffix);
      result.back()[k] = parameter[0];
    }
  }
  return result;
}

std::vector<std::string> other_marks(const Parts& parts, const Names& names) {
  if (parts.marks.starts_with("'")) return {parts.marks.substr(1), parts.marks + "'"};
  const Type* type = names.type(parts.base);
  if (type == nullptr || !type->is_function()) return {};
  if (parts.marks.empty())
    return type->parameters.size() == 1 ? std::vector<std::string>{"'"}
                                        : std::vector<std::string>{};
  return other_suffixes(parts.marks, type->parameters);
}

}  // namespace

void add_name_edits(const syntax::Expression& name, const Names& names,
                    const std::vector<std::string>& running, std::vector<Edit>& edits) {
  const Parts parts = parts_of(name.text, names);
  const auto add = [&](const std::string& text, const char* what) {
    edits.push_back({Line::begin_of(name.span), Line::end_of(name.span), text, what});
  };
  for (const std::string& other : names.others(parts.base, running))
    add(other + parts.marks, "name");
  for (const std::string& marks : other_marks(parts, names)) add(parts.base + marks, "derivative");
}

}  // namespace patchproof
