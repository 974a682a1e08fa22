// Every certificate of the cases is accepted by the second checker, which shares no code with what
// has found it.

#include <catch2/catch.hpp>
#include <map>

#include <patchproof/certificate/certificates.hpp>
#include <patchproof/certificate/json_certificate.hpp>
#include <patchproof/language/reader.hpp>
#include <recheck/recheck.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

TEST_CASE("the second checker rejects no certificate of the cases") {
  VerificationOptions options;
  options.engines = Engines::kernel;
  std::map<recheck::Outcome::Kind, std::size_t> counts;
  for (const SourceText& source : sampled_case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    for (const Case& given : file.cases) {
      std::vector<Certificate> certificates;
      for (const ClaimResult& claim : verified(given, options).claims) {
        auto found = certificate(claim, given.name, given.limits);
        if (auto* one = std::get_if<Certificate>(&found)) certificates.push_back(std::move(*one));
      }
      for (const recheck::Outcome& outcome :
           recheck::outcomes_of(json_certificates(given.name, certificates))) {
        INFO(outcome.claim << ": " << outcome.reason);
        CHECK(outcome.kind != recheck::Outcome::Kind::rejected);
        ++counts[outcome.kind];
      }
    }
  }
  // What the format has no word for yet: sines, integrals of unknown functions.
  CHECK(counts[recheck::Outcome::Kind::unknown] < 40);
  CHECK(counts[recheck::Outcome::Kind::rechecked] > (sanitized ? 300U : 5100U));
}

}  // namespace patchproof::test
