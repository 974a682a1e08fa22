#include <recheck/run.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>

#include <recheck/place.hpp>

namespace recheck {

namespace {

// One byte more than allowed shows that there is too much.
std::string text_of(std::istream& stream, std::size_t most) {
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

std::optional<std::string> text_of(const std::string& path, std::size_t most) {
  if (path == "-") return text_of(std::cin, most);
  // Devices and pipes need not end.
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  if (std::filesystem::file_size(path, error) > most) throw Unreadable{"the text is too long"};
  std::ifstream stream{path, std::ios::binary};
  if (!stream) return std::nullopt;
  return text_of(stream, most);
}

// Names come from the documents: control characters in them must not reach a terminal.
std::string printable(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    result += code < ' ' || code == 127 ? '?' : c;
  }
  return result;
}

std::string line_of(const Outcome& outcome, std::size_t width) {
  const std::string claim = printable(outcome.claim);
  const std::string gap(width > claim.size() ? width - claim.size() : 0, ' ');
  const std::string start = claim + gap + "  ";
  switch (outcome.kind) {
    case Outcome::Kind::rechecked:
      return "  " + start + "RECHECKED\n";
    case Outcome::Kind::rejected:
      return "! " + start + "REJECTED (" + printable(outcome.reason) + ")\n";
    default:
      return "? " + start + "UNKNOWN (" + printable(outcome.reason) + ")\n";
  }
}

using Counts = std::map<Outcome::Kind, std::size_t>;

std::string summary_of(Counts counts, std::size_t files) {
  const std::size_t total = counts[Outcome::Kind::rechecked] + counts[Outcome::Kind::rejected] +
                            counts[Outcome::Kind::unknown];
  return std::to_string(total) + (total == 1 ? " certificate in " : " certificates in ") +
         std::to_string(files) + (files == 1 ? " file: " : " files: ") +
         std::to_string(counts[Outcome::Kind::rechecked]) + " rechecked, " +
         std::to_string(counts[Outcome::Kind::rejected]) + " rejected, " +
         std::to_string(counts[Outcome::Kind::unknown]) + " unknown\n";
}

int code_of(Counts counts, bool all_read) {
  if (!all_read) return 4;
  if (counts[Outcome::Kind::rejected] > 0) return 1;
  if (counts[Outcome::Kind::unknown] > 0) return 2;
  return counts[Outcome::Kind::rechecked] > 0 ? 0 : 5;
}

}  // namespace

Run run_of(const std::vector<std::string>& paths, const Limits& limits) {
  constexpr std::size_t widest = 48;
  Run run;
  std::vector<Outcome> outcomes;
  bool all_read = true;
  for (const std::string& path : paths) {
    const auto complain = [&](const std::string& problem) {
      run.errors += printable(path) + ": " + printable(problem) + "\n";
      all_read = false;
    };
    try {
      const std::optional<std::string> text = text_of(path, limits.bytes);
      if (!text) {
        complain("the file cannot be read");
        continue;
      }
      for (Outcome& outcome : outcomes_of(*text, limits)) outcomes.push_back(std::move(outcome));
    } catch (const Unreadable& error) {
      complain(error.what());
    }
  }
  std::size_t width = 0;
  for (const Outcome& outcome : outcomes)
    width = std::max(width, std::min(outcome.claim.size(), widest));
  Counts counts;
  for (const Outcome& outcome : outcomes) {
    run.output += line_of(outcome, width);
    ++counts[outcome.kind];
  }
  run.output += (run.output.empty() ? "" : "\n") + summary_of(counts, paths.size());
  run.code = code_of(counts, all_read);
  return run;
}

}  // namespace recheck
