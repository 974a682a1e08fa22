#include <verify/coqc.hpp>
#include <verify/coqc_check.hpp>
#include <verify/files.hpp>
#include <verify/progress.hpp>
#include <verify/theorem_bundle.hpp>

#include <algorithm>
#include <filesystem>

namespace patchproof {

namespace {

class Check {
 public:
  Check(const CoqcCheck& how, std::vector<CaseWork>& works)
      : how_{how}, works_{works}, progress_{with_theorems().size()} {}

  std::string run() {
    std::vector<std::size_t> alone = with_theorems();
    // The longest first, lest one of them runs alone in the end.
    std::stable_sort(alone.begin(), alone.end(), [&](std::size_t a, std::size_t b) {
      return works_[a].rocq.text.size() > works_[b].rocq.text.size();
    });
    const auto small = std::find_if(alone.begin(), alone.end(), [&](std::size_t k) {
      return works_[k].rocq.text.size() <= largest_small;
    });
    std::vector<std::size_t> smalls(small, alone.end());
    alone.erase(small, alone.end());
    std::string problem = one_round(alone, bundles_of(smalls));
    while (problem.empty() && !again_.empty()) {
      const std::vector<std::size_t> waiting = std::move(again_);
      again_.clear();
      problem = one_round(waiting, {});
    }
    return problem;
  }

 private:
  static constexpr std::size_t largest_small = 100'000;
  static constexpr std::size_t most_together = 16;

  std::vector<std::size_t> with_theorems() const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < works_.size(); ++k)
      if (!theorems_of(works_[k]).empty()) result.push_back(k);
    return result;
  }

  // As many as there are jobs, or more. The cases are sorted by size, so each gets some of every
  // size.
  std::vector<std::vector<std::size_t>> bundles_of(const std::vector<std::size_t>& cases) const {
    const std::size_t least = (cases.size() + most_together - 1) / most_together;
    std::vector<std::vector<std::size_t>> result(
        std::min(cases.size(), std::max(least, how_.jobs)));
    for (std::size_t k = 0; k < cases.size(); ++k) result[k % result.size()].push_back(cases[k]);
    return result;
  }

  std::string one_round(const std::vector<std::size_t>& alone,
                        const std::vector<std::vector<std::size_t>>& bundles) {
    std::vector<std::string> files;
    for (const std::size_t k : alone) files.push_back(works_[k].file);
    for (const std::vector<std::size_t>& bundle : bundles) {
      std::vector<const RocqFile*> parts;
      for (const std::size_t k : bundle) parts.push_back(&works_[k].rocq);
      files.push_back(bundle.size() == 1 ? works_[bundle.front()].file : bundle_file(files.size()));
      if (bundle.size() == 1) continue;
      if (!replace_file(path(files.back()), bundle_text(parts)).empty())
        return "a file could not be written";
    }
    const std::vector<CoqRun> runs = coqc_runs(how_.folder, files, how_.jobs, how_.longest,
                                               [&](std::size_t f) { progress_.next(files[f]); });
    std::string problem;
    for (std::size_t k = 0; k < alone.size() && problem.empty(); ++k)
      problem = take(works_[alone[k]], alone[k], runs[k]);
    for (std::size_t b = 0; b < bundles.size() && problem.empty(); ++b) {
      const CoqRun& run = runs[alone.size() + b];
      if (bundles[b].size() == 1)
        problem = take(works_[bundles[b].front()], bundles[b].front(), run);
      else
        take(bundles[b], run, files[alone.size() + b]);
    }
    return problem;
  }

  // What coqc says of a case, and whether it is to be tried again.
  std::string take(CaseWork& work, std::size_t number, const CoqRun& run) {
    if (run.accepted) {
      accept(work, run.output, axioms_in(run.output));
      return "";
    }
    const std::string claim = claim_at(work, run.line);
    if (claim.empty()) {
      for (const std::string& id : theorems_of(work))
        work.missing.emplace_back(id, "not checked by coqc: " + run.problem);
      return "";
    }
    work.left_out.push_back(claim);
    work.missing.emplace_back(claim, "not accepted by coqc: " + run.problem);
    write_down(work);
    if (!how_.rewrite(work)) return "a file could not be written";
    if (!theorems_of(work).empty()) again_.push_back(number);
    return "";
  }

  // Anything but a good answer about all is no answer: each is then asked about alone.
  void take(const std::vector<std::size_t>& bundle, const CoqRun& run, const std::string& file) {
    const std::optional<std::vector<std::string>> axioms = axioms_in(run.output);
    const std::vector<std::string> outputs = bundle_outputs(run.output, bundle.size());
    const bool good = run.accepted && axioms && outputs.size() == bundle.size() &&
                      std::all_of(axioms->begin(), axioms->end(), is_accepted_axiom);
    for (std::size_t k = 0; k < bundle.size(); ++k) {
      CaseWork& work = works_[bundle[k]];
      if (good && is_understood(work, outputs[k]))
        accept(work, outputs[k], axioms);
      else
        again_.push_back(bundle[k]);
    }
    remove_compiled(path(file));
  }

  void accept(CaseWork& work, const std::string& output,
              const std::optional<std::vector<std::string>>& axioms) {
    if (!axioms) {
      work.unfounded = true;
      for (const std::string& id : theorems_of(work))
        work.missing.emplace_back(id, "coqc has not said which axioms it rests on");
      return;
    }
    work.accepted = true;
    work.axioms = *axioms;
    compare(work, output);
  }

  std::string path(const std::string& file) const {
    return (std::filesystem::path{how_.folder} / file).string();
  }

  const CoqcCheck& how_;
  std::vector<CaseWork>& works_;
  Progress progress_;
  std::vector<std::size_t> again_;
};

}  // namespace

std::string check_with_coqc(const CoqcCheck& how, std::vector<CaseWork>& works) {
  return Check{how, works}.run();
}

}  // namespace patchproof
