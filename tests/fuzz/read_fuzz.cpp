// Fuzz target of reading: names, types and definitions. Whatever the text, reading ends well and
// gives the same twice; the formatted text of one without mistakes has the same claims.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

#include <patchproof/language/formatter.hpp>
#include <patchproof/patchproof.hpp>
#include <tests/fuzz/law.hpp>
#include <tests/fuzz/token_mutation.hpp>

namespace {

using namespace patchproof;

std::vector<CaseFile> read(const std::string& text) {
  return read_files({{"fuzz.proof", text, ""}});
}

/// The mistakes with their places, then the claims with what is asked of them.
std::string found_in(const std::vector<CaseFile>& files) {
  std::string result;
  for (const CaseFile& file : files) {
    for (const Diagnostic& diagnostic : file.diagnostics) result += to_text(diagnostic);
    for (const Case& given : file.cases)
      for (const Claim& claim : given.claims)
        result += claim_id(given, claim) + " " + claim.verb + "\n";
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::vector<CaseFile> files = read(text);
  const std::string found = found_in(files);
  if (found_in(read(text)) != found) fuzz::violated("reading twice finds the same", text);
  if (files.at(0).diagnostics.size() > 20) fuzz::violated("at most 20 diagnostics", text);
  if (!files.at(0).diagnostics.empty()) return 0;
  const std::string once = formatted(SourceText{"fuzz.proof", text});
  if (found_in(read(once)) != found) fuzz::violated("a formatted text has the same claims", once);
  return 0;
}
