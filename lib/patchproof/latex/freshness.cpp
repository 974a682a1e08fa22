#include <patchproof/latex/freshness.hpp>

#include <sstream>
#include <string_view>

#include <patchproof/language/parser.hpp>
#include <patchproof/net/net_writer.hpp>
#include <patchproof/latex/sha256.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

constexpr std::string_view first_line = "% patchproof ";
constexpr std::string_view case_line = "% case: ";
constexpr std::string_view between = ", source: ";
constexpr std::string_view digest_line = "% digest: ";
constexpr std::string_view options_line = "% options: ";

// Each part with its length before it, so that no two lists of parts are one text.
std::string digest(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += std::to_string(part.size()) + ":" + part;
  return sha256(text);
}

std::string options_text(const DocumentOptions& options) {
  return "--lang " + code_of(options.language) + " --detail " +
         std::to_string(static_cast<int>(options.detail)) + (options.fragment ? " --fragment" : "") +
         (options.figures ? "" : " --no-figures");
}

std::string text_of(const Span& span) {
  return span.source->text.substr(span.begin, span.end - span.begin);
}

// A comment ends with its line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

DocumentOptions options_of(std::istringstream words) {
  DocumentOptions options;
  for (std::string word; words >> word;) {
    std::string value;
    if (word == "--fragment") options.fragment = true;
    if (word == "--no-figures") options.figures = false;
    if (word == "--lang" && words >> value)
      options.language = language_of(value).value_or(Language::english);
    if (word == "--detail" && words >> value && value.size() == 1 && value >= "1" && value <= "3")
      options.detail = static_cast<Detail>(value.front() - '0');
  }
  return options;
}

}  // namespace

std::optional<std::string> case_digest(const std::shared_ptr<const SourceText>& source,
                                       const std::string& case_name, const Loader& load,
                                       const DocumentOptions& options) {
  const Parsed parsed = parse(source);
  for (const syntax::Case& written : parsed.file.cases) {
    if (written.name.text != case_name) continue;
    std::vector<std::string> parts{std::string{version}, options_text(options),
                                   text_of(written.span)};
    std::vector<Diagnostic> reported_elsewhere;
    const Library library = read_definitions(source, load, reported_elsewhere);
    for (const std::string& name : library.names())
      parts.push_back(text_of(library.find(name)->span));
    for (const syntax::Statement& statement : written.statements)
      for (const syntax::Declarator& declarator : statement.declarators) {
        if (!declarator.file) continue;
        const NetFile* file = library.net(path_of(*declarator.file));
        parts.push_back(file != nullptr && file->net ? net_as_csv(*file->net) : "");
      }
    return digest(parts);
  }
  return std::nullopt;
}

std::string book_digest(const std::vector<std::string>& digests) { return digest(digests); }

std::string header_text(const std::vector<Origin>& cases, const std::string& digest,
                        const DocumentOptions& options) {
  std::string text = std::string{first_line} + std::string{version} + "\n";
  for (const auto& [name, path] : cases)
    text += std::string{case_line} + name + std::string{between} + one_line(path) + "\n";
  return text + std::string{digest_line} + digest + "\n" + std::string{options_line} +
         options_text(options) + "\n";
}

std::optional<Header> header_of(const std::string& tex) {
  if (!tex.starts_with(first_line)) return std::nullopt;
  Header header;
  std::istringstream lines{tex};
  for (std::string line; std::getline(lines, line) && line.starts_with("%");) {
    if (line.starts_with(digest_line)) header.digest = line.substr(digest_line.size());
    if (line.starts_with(options_line))
      header.options = options_of(std::istringstream{line.substr(options_line.size())});
    const std::size_t middle = line.find(between);
    if (line.starts_with(case_line) && middle != std::string::npos)
      header.cases.emplace_back(line.substr(case_line.size(), middle - case_line.size()),
                                line.substr(middle + between.size()));
  }
  return header;
}

}  // namespace patchproof
