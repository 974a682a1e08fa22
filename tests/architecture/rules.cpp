#include <tests/architecture/rules.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string_view>

namespace patchproof::architecture {
namespace {

constexpr std::string_view library = "lib/patchproof/";

/// How high each folder of the library is; a file beside the folders is above them all.
const std::map<std::string, int, std::less<>>& layers() {
  static const std::map<std::string, int, std::less<>> heights{
      {"version.hpp", 0}, {"algebra", 1},     {"net", 2},         {"term", 2},
      {"kernel", 3},      {"symbolic", 3},    {"grid", 4},        {"decide", 5},
      {"claims", 6},      {"certificate", 7}, {"language", 7},    {"repair", 8},
      {"mutation", 9},    {"derivation", 10}, {"figure", 11},     {"latex", 12},
      {"report", 13},     {"patchproof.hpp", 14}};
  return heights;
}

/// The first part of a path inside the library: a layer, or a file beside them.
std::string_view first_part(std::string_view path) { return path.substr(0, path.find('/')); }

/// The layer of a file of the library.
std::string_view layer_of(const SourceFile& file) {
  const std::string_view part = first_part(std::string_view{file.path}.substr(library.size()));
  return part == "patchproof.cpp" ? "patchproof.hpp" : part;
}

bool in(std::string_view path, std::string_view folder) { return path.starts_with(folder); }

std::string place(const SourceFile& file, std::size_t line_index) {
  return file.path + ":" + std::to_string(line_index + 1) + ": ";
}

/// Calls `judge(file, line index, line)` for the code of each line of each C++ file in a folder.
template <typename Judge>
void for_each_code_line(const Tree& tree, std::string_view folder, const Judge& judge) {
  for (const SourceFile& file : tree) {
    if (!is_cpp(file) || !in(file.path, folder)) continue;
    const std::vector<std::string> lines = lines_of(code_only(file.text));
    for (std::size_t i = 0; i < lines.size(); ++i) judge(file, i, lines[i]);
  }
}

/// What a line includes, with its brackets: "<vector>", or "\"" for a quoted name; or "".
std::string included(const std::string& line) {
  static const std::regex pattern{R"(^\s*#\s*include\s*(<[^>]*>|"))"};
  std::smatch match;
  return std::regex_search(line, match, pattern) ? match[1].str() : "";
}

/// The breaches of all lines with a match of a pattern.
Breaches lines_matching(const Tree& tree, std::string_view folder, const std::regex& pattern,
                        const std::string& what, bool only_headers = false) {
  Breaches breaches;
  for_each_code_line(tree, folder, [&](const SourceFile& file, std::size_t i, const auto& line) {
    if (only_headers && !is_header(file)) return;
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      breaches.push_back(place(file, i) + what + " '" + match.str() + "'");
    }
  });
  return breaches;
}

/// A library, by how the names of its headers start, and the only places that may include it.
struct Door {
  std::string_view headers;
  std::vector<std::string_view> places;
};

const std::vector<Door>& doors() {
  static const std::vector<Door> all{
      {"<ginac/", {"lib/patchproof/symbolic/"}},
      {"<cln/", {"lib/patchproof/symbolic/"}},
      {"<gmp", {}},
      {"<boost/multiprecision/", {"lib/patchproof/algebra/rational.hpp", "recheck/number.hpp"}},
      {"<nlohmann/",
       {"lib/patchproof/language/dump", "lib/patchproof/report/",
        "lib/patchproof/certificate/term_table.hpp", "verify/", "recheck/place.hpp"}},
      {"<CLI/", {"verify/"}}};
  return all;
}

}  // namespace

Breaches upward_includes(const Tree& tree) {
  Breaches breaches;
  for_each_code_line(tree, library, [&](const SourceFile& file, std::size_t i, const auto& line) {
    const std::string header = included(line);
    const auto own = layers().find(layer_of(file));
    if (header == "\"") {
      breaches.push_back(place(file, i) + "write #include <patchproof/...>, without quotes");
    }
    constexpr std::string_view start = "<patchproof/";
    if (!header.starts_with(start) || own == layers().end()) return;
    const std::string_view inside = std::string_view{header}.substr(start.size());
    const std::string_view part = first_part(inside.substr(0, inside.size() - 1));
    const auto other = layers().find(part);
    if (other == layers().end()) {
      breaches.push_back(place(file, i) + header + " is in no known layer");
    } else if (other->second > own->second ||
               (other->second == own->second && other->first != own->first)) {
      breaches.push_back(place(file, i) + own->first + " may not include " + header);
    }
  });
  return breaches;
}

Breaches libraries_outside_their_door(const Tree& tree) {
  Breaches breaches;
  const auto judge = [&](const SourceFile& file, std::size_t i, const std::string& line) {
    const std::string header = included(line);
    for (const Door& door : doors()) {
      if (!header.starts_with(door.headers)) continue;
      const bool allowed = std::any_of(door.places.begin(), door.places.end(),
                                       [&](std::string_view p) { return in(file.path, p); });
      if (!allowed) breaches.push_back(place(file, i) + header + " may not be included here");
    }
  };
  for_each_code_line(tree, "lib/", judge);
  for_each_code_line(tree, "verify/", judge);
  for_each_code_line(tree, "recheck/", judge);
  return breaches;
}

Breaches dependence_of_the_second_checker(const Tree& tree) {
  Breaches breaches;
  for_each_code_line(tree, "recheck/", [&](const SourceFile& file, std::size_t i, const auto& line) {
    const std::string header = included(line);
    const bool foreign = header == "\"" || header.starts_with("<patchproof/") ||
                         header.starts_with("<verify/") || header.starts_with("<tests/");
    if (foreign) breaches.push_back(place(file, i) + "the second checker may not include " + header);
  });
  return breaches;
}

Breaches floating_point(const Tree& tree) {
  // Also float_t, std::numeric_limits<double>, 1.5, 1., .5, 1e-9; but not x1.e, a.b or 0xe5.
  static const std::regex pattern{
      R"(\b(double|float|double_t|float_t|stod|stof|stold|strtod|strtof|strtold|atof)\b|)"
      R"((^|[^\w.'])((\d[\d']*)?\.\d|\d[\d']*\.(?![.\w])|\d[\d']*[eE][+-]?\d))"};
  Breaches breaches = lines_matching(tree, "lib/", pattern, "floating point");
  for (std::string& breach : lines_matching(tree, "recheck/", pattern, "floating point"))
    breaches.push_back(std::move(breach));
  return breaches;
}

Breaches unknown_folders(const Tree& tree) {
  Breaches breaches;
  for (const SourceFile& file : tree) {
    if (!in(file.path, "lib/")) continue;
    if (!in(file.path, library)) {
      breaches.push_back(file.path + ": outside lib/patchproof");
      continue;
    }
    const std::string_view layer = layer_of(file);
    const bool definitions = layer == "prelude" && file.path.ends_with(".proof");
    const bool template_of_version = layer == "version.hpp.in";
    if (!definitions && !template_of_version && layers().find(layer) == layers().end()) {
      breaches.push_back(file.path + ": '" + std::string{layer} + "' is no known layer");
    }
  }
  return breaches;
}

Breaches headers_without_pragma_once(const Tree& tree) {
  Breaches breaches;
  for (const SourceFile& file : tree) {
    if (!is_header(file)) continue;
    const std::vector<std::string> lines = lines_of(code_only(file.text));
    const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find_first_not_of(" \t\r") != std::string::npos;
    });
    if (first == lines.end() || *first != "#pragma once") {
      breaches.push_back(file.path + ": does not start with #pragma once");
    }
  }
  return breaches;
}

Breaches using_namespace_in_headers(const Tree& tree) {
  static const std::regex pattern{R"(\busing\s+namespace\b)"};
  return lines_matching(tree, "", pattern, "in a header:", true);
}

Breaches long_files(const Tree& tree) {
  constexpr std::size_t too_many = 300;
  // Tables of messages are long, and split at no natural place.
  constexpr std::size_t too_many_in_tests = 400;
  Breaches breaches;
  for (const SourceFile& file : tree) {
    const std::size_t lines = lines_of(file.text).size();
    const bool is_test = file.path.rfind("tests/", 0) == 0;
    if (is_cpp(file) && lines >= (is_test ? too_many_in_tests : too_many)) {
      breaches.push_back(file.path + ": " + std::to_string(lines) + " lines");
    }
  }
  return breaches;
}

Breaches paths_of_one_machine(const Tree& tree) {
  // In two pieces each, because this file too is in the tree.
  static const std::array<std::string, 5> traces{
      std::string{"/wo"} + "rk/", std::string{"/ro"} + "ot/", std::string{"/ho"} + "me/",
      std::string{"/Use"} + "rs/", std::string{"../sha"} + "red"};
  Breaches breaches;
  for (const SourceFile& file : tree) {
    const std::vector<std::string> lines = lines_of(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string& trace : traces) {
        if (lines[i].find(trace) == std::string::npos) continue;
        breaches.push_back(place(file, i) + "a path of one machine: '" + trace + "'");
      }
    }
  }
  return breaches;
}

}  // namespace patchproof::architecture
