#include <patchproof/patchproof.hpp>

#include <algorithm>
#include <map>

namespace patchproof {

namespace {

/// Leaves out cases whose names are taken by other files.
class CaseNames {
 public:
  void keep_new(CaseFile& file) {
    std::vector<Case> kept;
    for (Case& read : file.cases) {
      const auto [place, fresh] = first_.emplace(read.name, read.span);
      if (fresh)
        kept.push_back(std::move(read));
      else
        file.diagnostics.push_back(twice(read, place->second));
    }
    file.cases = std::move(kept);
    file.diagnostics = in_order(std::move(file.diagnostics));
  }

 private:
  static Diagnostic twice(const Case& second, const Span& first) {
    const std::size_t line = position_of(*first.source, first.begin).line;
    return {second.span,
            "case '" + second.name + "' occurs twice (first in " + first.source->name + ", line " +
                std::to_string(line) + ")",
            ""};
  }

  std::map<std::string, Span> first_;
};

bool any_wanted(const Case& given, const CheckOptions& options) {
  return !options.wanted ||
         std::any_of(given.claims.begin(), given.claims.end(),
                     [&](const Claim& claim) { return options.wanted(given, claim); });
}

CaseResult decided(const Case& given, const CheckOptions& options) {
  VerificationOptions verification;
  verification.engines = options.engines;
  if (options.wanted)
    verification.wanted = [&](const Claim& claim) { return options.wanted(given, claim); };
  if (options.progress)
    verification.progress = [&](const Claim& claim) { options.progress(given, claim); };
  return verified(given, verification);
}

}  // namespace

std::vector<CaseFile> read_files(const std::vector<Input>& inputs, const CheckOptions& options) {
  const Loader load =
      options.load ? options.load : [](const std::string&) { return std::optional<std::string>{}; };
  std::vector<CaseFile> files;
  CaseNames names;
  for (const Input& input : inputs) {
    CaseFile file{input.path, input.unreadable, {}, {}};
    if (input.text) {
      ReadFile found =
          read_cases(std::make_shared<const SourceText>(SourceText{input.path, *input.text}),
                     options.limits, load);
      file.diagnostics = std::move(found.diagnostics);
      file.cases = std::move(found.cases);
      names.keep_new(file);
    } else if (file.unreadable.empty()) {
      file.unreadable = "there is no text";
    }
    files.push_back(std::move(file));
  }
  return files;
}

Report decided(const std::vector<CaseFile>& files, const CheckOptions& options) {
  Report report;
  report.strict = options.strict;
  for (const CaseFile& file : files) {
    FileReport result{file.path, file.unreadable, file.diagnostics, {}};
    for (const Case& given : file.cases) {
      if (!any_wanted(given, options)) continue;
      result.cases.push_back(decided(given, options));
      if (options.audit && !given.assumptions.empty())
        result.audits.push_back(audited(given, result.cases.back()));
    }
    report.files.push_back(std::move(result));
  }
  return report;
}

Report check(const std::vector<Input>& inputs, const CheckOptions& options) {
  return decided(read_files(inputs, options), options);
}

}  // namespace patchproof
