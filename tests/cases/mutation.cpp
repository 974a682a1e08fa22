#include <algorithm>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/lexer.hpp>
#include <patchproof/language/parser.hpp>
#include <tests/cases/case_files.hpp>
#include <tests/cases/mutation.hpp>

namespace patchproof::test {

namespace {

struct Part {
  std::string id;
  std::string claim;  ///< "" when every claim of the case may notice a change
  Span span;
  bool removable = false;
};

void add_hypotheses(const std::string& name, const syntax::Statement& s,
                    std::vector<Part>& result) {
  const std::string id = name + (s.label ? "." + s.label->text : ".assume");
  for (const syntax::Comparison& c : s.proposition.comparisons)
    result.push_back({id, "", c.span, true});
}

void add_values(const std::string& name, const syntax::Statement& s, std::vector<Part>& result) {
  for (const syntax::Declarator& d : s.declarators)
    if (d.value) result.push_back({name + "." + d.name.text, "", d.value->span});
}

// The texts that state something true, and those the statements rest on.
std::vector<Part> true_parts(const syntax::File& file) {
  std::vector<Part> result;
  for (const syntax::Case& written : file.cases) {
    for (const syntax::Statement& s : written.statements) {
      using Kind = syntax::Statement::Kind;
      const std::string& name = written.name.text;
      if (s.kind == Kind::assume) add_hypotheses(name, s, result);
      add_values(name, s, result);
      if (!s.label) continue;
      const std::string id = name + "." + s.label->text;
      const std::string corrected = id + ".corrected";
      if (s.kind == Kind::prove) result.push_back({id, id, s.proposition.span});
      if (s.kind == Kind::erratum) result.push_back({corrected, corrected, s.corrected.span});
      if (s.kind != Kind::derive) continue;
      result.push_back({id, id, s.proposition.span});
      for (const auto& e : s.gives) result.push_back({id, id, e->span});
    }
  }
  return result;
}

std::vector<std::string> replacements(const Token& token, const std::string& text) {
  if (text == "+") return {"-"};
  if (text == "-") return {"+"};
  if (token.kind == Token::Kind::number && text.find('.') == std::string::npos && text.size() < 9)
    return {std::to_string(std::stoi(text) + 1)};
  if (token.kind != Token::Kind::name) return {};
  const std::string base = text.substr(0, text.find('\''));
  const char last = base.back();
  if (last < '0' || last > '9' || base.size() < 2) return {};
  std::string other = base;
  other.back() = last == '1' ? '2' : '1';
  return {other + text.substr(base.size())};
}

std::string described(const SourceText& source, const Part& part, std::size_t begin,
                      std::size_t end, const std::string& replacement) {
  const std::size_t from = std::max(part.span.begin, begin < 24 ? 0 : begin - 24);
  const std::size_t to = std::min(part.span.end, end + 24);
  std::string around = source.text.substr(from, begin - from) + "{" +
                       source.text.substr(begin, end - begin) + " -> " + replacement + "}" +
                       source.text.substr(end, to - end);
  std::replace(around.begin(), around.end(), '\n', ' ');
  around.erase(std::unique(around.begin(), around.end(),
                           [](char a, char b) { return a == ' ' && b == ' '; }),
               around.end());
  const std::size_t first = around.find_first_not_of(' ');
  const std::size_t last = around.find_last_not_of(' ');
  return part.id + ": " + around.substr(first, last - first + 1);
}

ReadFile read(const SourceText& source) {
  return read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
}

}  // namespace

std::vector<SourceText> single_cases(const SourceText& file) {
  std::vector<SourceText> result;
  const Parsed parsed = parse(std::make_shared<const SourceText>(file));
  for (const syntax::Case& written : parsed.file.cases)
    result.push_back(
        {file.name, file.text.substr(written.span.begin, written.span.end - written.span.begin)});
  return result;
}

std::vector<Mutation> mutations(const SourceText& source) {
  const auto shared = std::make_shared<const SourceText>(source);
  const Parsed parsed = parse(shared);
  const Lexed lexed = tokens_of(shared);
  std::vector<Mutation> result;
  for (const Part& part : true_parts(parsed.file)) {
    const auto add = [&](std::size_t begin, std::size_t end, const std::string& replacement) {
      result.push_back(
          {part.claim, begin, end, replacement, described(source, part, begin, end, replacement)});
    };
    if (part.removable) add(part.span.begin, part.span.end, "0 == 0");
    for (const Token& token : lexed.tokens) {
      if (token.begin < part.span.begin || token.end > part.span.end) continue;
      const std::string text = source.text.substr(token.begin, token.end - token.begin);
      for (const std::string& replacement : replacements(token, text))
        add(token.begin, token.end, replacement);
    }
  }
  return result;
}

bool is_caught(const SourceText& source, const Mutation& mutation) {
  SourceText changed = source;
  changed.text.replace(mutation.begin, mutation.end - mutation.begin, mutation.replacement);
  const ReadFile file = read(changed);
  if (!file.diagnostics.empty()) return true;
  VerificationOptions options;
  options.engines = Engines::kernel;
  for (const Case& given : file.cases) {
    const std::string label =
        mutation.claim.empty() ? "" : mutation.claim.substr(given.name.size() + 1);
    // Claims further down may use what this one derives.
    options.wanted = [&](const Claim& claim) {
      return label.empty() || claim.label == label ||
             std::any_of(claim.uses.begin(), claim.uses.end(),
                         [&](const std::string& use) { return use == label; });
    };
    const CaseResult verdicts = verified(given, options);
    if (std::any_of(verdicts.claims.begin(), verdicts.claims.end(),
                    [](const ClaimResult& r) { return r.outcome != Outcome::as_expected; }))
      return true;
  }
  return false;
}

}  // namespace patchproof::test
