// patchproof_bench SECONDS FILE...: decides the claims of each file again and again, by the kernel
// alone. Prints, for each file, "NANOSECONDS NANOSECONDS_WITH_READING KILOBYTES VERDICT": medians
// of processor time without the start of the process, and the most memory that was in use. PROVED
// means all claims, REFUTED at least one.
//
// A case is read anew before each decision, because terms may remember their values.
#include <sys/resource.h>

#include <ctime>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/reader.hpp>

using namespace patchproof;

namespace {

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Times {
  std::vector<double> deciding;
  std::vector<double> reading_too;
  std::string verdict;
};

bool run(const std::shared_ptr<const SourceText>& source, Times& times) {
  const double begin = cpu_now();
  const ReadFile read = read_cases(source, {}, {});
  const double middle = cpu_now();
  if (!read.diagnostics.empty() || read.cases.size() != 1 || read.cases[0].claims.empty()) {
    for (const Diagnostic& diagnostic : read.diagnostics)
      std::cerr << source->name << ": " << diagnostic.message << "\n";
    std::cerr << source->name << ": one case with claims is needed\n";
    return false;
  }
  CaseVerifier verifier{read.cases[0], Engines::kernel};
  std::string verdict = to_text(Verdict::proved);
  for (std::size_t k = 0; k < read.cases[0].claims.size(); ++k) {
    const Decision decision = verifier.decided(k).decision;
    if (decision.verdict == Verdict::proved) continue;
    verdict = to_text(decision.verdict);
    if (decision.verdict == Verdict::unknown) verdict += ": " + decision.reason;
    // Nothing that comes later can make up for it.
    if (decision.verdict != Verdict::refuted) break;
  }
  const double end = cpu_now();
  times.deciding.push_back(end - middle);
  times.reading_too.push_back(end - begin);
  times.verdict = verdict;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: patchproof_bench SECONDS FILE...\n";
    return 64;
  }
  const double seconds = std::atof(argv[1]);
  for (int k = 2; k < argc; ++k) {
    std::ifstream file{argv[k]};
    std::ostringstream text;
    text << file.rdbuf();
    const auto source = std::make_shared<const SourceText>(argv[k], text.str());
    Times times;
    double total = 0;
    while (times.deciding.size() < 3 ? total < 5 * seconds
                                     : total < seconds && times.deciding.size() < 1001) {
      if (!run(source, times)) return 65;
      total += times.reading_too.back();
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    std::printf("%.0f %.0f %ld %s\n", 1e9 * median(times.deciding), 1e9 * median(times.reading_too),
                used.ru_maxrss, times.verdict.c_str());
    std::fflush(stdout);
  }
}
