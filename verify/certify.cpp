// patchproof certify: certificates of verdicts for other programs to check, and coqc's word on
// them.
#include <unistd.h>
#include <verify/case_work.hpp>
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/coqc.hpp>
#include <verify/coqc_check.hpp>
#include <verify/files.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/selection.hpp>

#include <algorithm>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include <patchproof/certificate/json_certificate.hpp>
#include <patchproof/certificate/rocq_names.hpp>
#include <patchproof/certificate/sympy_script.hpp>
#include <patchproof/latex/sha256.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

struct CertifyArguments {
  CheckArguments check;
  std::string folder;
  std::string coqc_seconds = "300";
  std::string jobs = "0";
  std::string format = "rocq";
  bool run_coqc = false;
};

bool prepared(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) == 0) return true;
  print_error("patchproof: cannot write into '" + folder +
              "': " + (error ? error.message() : std::generic_category().message(errno)) + "\n");
  return false;
}

bool written(const CertifyArguments& arguments, const CaseWork& work,
             const std::vector<std::string>& inputs) {
  Output output{(fs::path{arguments.folder} / work.file).string(), inputs};
  return output.good() && output.write(arguments.format == "rocq" ? work.rocq.text : work.other);
}

std::size_t number_of_jobs(const CertifyArguments& arguments) {
  const auto asked = static_cast<std::size_t>(std::stoul(arguments.jobs));
  return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

CheckedFolder record_of(const std::vector<CaseWork>& works, const std::string& coqc) {
  CheckedFolder record{coqc, {}};
  for (const CaseWork& work : works) {
    const bool good = std::all_of(work.axioms.begin(), work.axioms.end(), is_accepted_axiom);
    if (!work.accepted || !good) continue;
    record.files.push_back({work.result->verified.name, work.file, sha256(work.rocq.text),
                            certified_in(work), work.left_out, work.axioms});
  }
  return record;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// One line for each case, and the claims without a certificate with their reasons.
std::string said_of(const std::vector<CaseWork>& works, const std::string& verb, std::size_t& total,
                    std::size_t& done) {
  std::string text;
  for (const CaseWork& work : works) {
    const std::size_t claims = work.result->claims.size();
    const std::size_t own = claims - std::min(claims, work.missing.size());
    total += claims;
    done += own;
    text += work.result->verified.name + ": " + std::to_string(own) + " of " +
            counted(claims, "claim") + " " + verb + "\n";
    for (const auto& [id, why] : work.missing) text += "    " + id + ": " + why + "\n";
  }
  return text;
}

CaseWork work_of(const CaseResult& result, const std::string& format) {
  CaseWork work;
  work.result = &result;
  work.file = rocq_identifier(result.verified.name);
  work.found = certificates_of(result);
  work.missing = work.found.missing;
  if (format == "json") {
    work.file += ".json";
    work.other = json_certificates(result.verified.name, work.found.certificates);
    return work;
  }
  if (format == "sympy") {
    work.file += ".py";
    work.other = sympy_script(result.verified, work.found.certificates);
    return work;
  }
  work.file += ".v";
  write_down(work);
  for (const RocqTheorem& theorem : work.rocq.theorems)
    if (theorem.theorems.empty()) work.missing.emplace_back(theorem.claim, theorem.why_not);
  return work;
}

std::vector<CaseWork> works_of(const Report& report, const std::string& format) {
  std::vector<CaseWork> works;
  for (const FileReport& file : report.files)
    for (const CaseResult& result : file.cases)
      if (!result.claims.empty()) works.push_back(work_of(result, format));
  return works;
}

ExitCode run(const CertifyArguments& arguments) {
  const Selection selection{arguments.check.only};
  CheckOptions options = options_of(arguments.check);
  if (!selection.everything())
    options.wanted = [&](const Case& of, const Claim& claim) {
      return selection.contains(of, claim);
    };
  const FoundPaths paths = found_paths(arguments.check.paths);
  const std::vector<CaseFile> files = read_files(inputs(paths), options);
  if (!prepared(arguments.folder)) return ExitCode::unreadable;
  const std::string coqc = arguments.run_coqc ? coqc_version() : "";
  std::future<std::string> library;
  // coqc works on the library while the claims are decided.
  if (!coqc.empty()) library = std::async(std::launch::async, library_made, arguments.folder);
  const Report report = decided(files, options);
  print_error(mistakes(report));
  ExitCode code = exit_code(report);
  std::vector<CaseWork> works = works_of(report, arguments.format);
  if (works.empty()) {
    print_error("patchproof: there is no claim to certify\n");
    return graver(code, ExitCode::nothing_ran);
  }
  for (const CaseWork& work : works)
    if (!written(arguments, work, paths.files)) return graver(code, ExitCode::unreadable);

  std::string verb = "with a certificate, not checked";
  std::string by;
  if (arguments.run_coqc && coqc.empty())
    print_error(
        "patchproof: there is no 'coqc'; certificates were written, not checked\n"
        "  = help: on Debian: apt-get install coq libcoq-coquelicot\n");
  if (!coqc.empty()) {
    std::string problem = library.get();
    if (problem.empty())
      problem = check_with_coqc(
          {arguments.folder, number_of_jobs(arguments),
           std::chrono::seconds{std::stoll(arguments.coqc_seconds)},
           [&](const CaseWork& work) { return written(arguments, work, paths.files); }},
          works);
    if (!problem.empty()) {
      print_error("patchproof: " + problem + "\n");
      return graver(code, ExitCode::unreadable);
    }
    const CheckedFolder record = record_of(works, coqc);
    for (CaseWork& work : works) {
      if (!work.accepted || std::all_of(work.axioms.begin(), work.axioms.end(), is_accepted_axiom))
        continue;
      work.unfounded = true;
      for (const std::string& id : certified_in(work))
        work.missing.emplace_back(id, "rests on an axiom that is not accepted");
    }
    problem = write_checked(arguments.folder, record);
    if (!problem.empty()) {
      print_error("patchproof: " + problem + "\n");
      return graver(code, ExitCode::unreadable);
    }
    std::vector<std::string> axioms;
    for (const CheckedFile& file : record.files)
      for (const std::string& axiom : file.axioms)
        if (std::find(axioms.begin(), axioms.end(), axiom) == axioms.end()) axioms.push_back(axiom);
    std::sort(axioms.begin(), axioms.end());
    verb = "certified";
    by = " (" + check_in_words(coqc, axioms) + ")";
  }
  std::size_t total = 0;
  std::size_t done = 0;
  const std::string cases = said_of(works, verb, total, done);
  const std::string sum = std::to_string(done) + " of " + counted(total, "claim") + " in " +
                          counted(works.size(), "case") + " " + verb + by + "\n";
  if (!print(cases + sum)) return graver(code, ExitCode::unreadable);
  const bool refused = std::any_of(works.begin(), works.end(), [](const CaseWork& work) {
    return !work.left_out.empty() || !work.misunderstood.empty() || work.unfounded;
  });
  if (refused) code = graver(code, ExitCode::internal);
  if (arguments.check.strict && done < total) code = graver(code, ExitCode::unknown);
  return code;
}

void declare(CLI::App& command, CertifyArguments& a) {
  const auto option = [&](const std::string& name, auto& value, const std::string& what,
                          const std::string& type) {
    return command.add_option(name, value, what)->option_text(type);
  };
  option("PATH", a.check.paths, "Case files, folders of *.proof, or - for standard input", "...");
  option("-o,--output", a.folder, "Folder for the certificates; it is made if need be", "DIR");
  option("--only", a.check.only, "Only claims that match, as for 'patchproof check'", "PATTERN")
      ->take_all();
  option("--format", a.format, "rocq (usual), json for 'patchproof recheck', or sympy", "FORMAT")
      ->check(CLI::IsMember(std::set<std::string>{"rocq", "json", "sympy"}));
  command.add_flag("--check", a.run_coqc, "Let coqc check the certificates");
  command.add_flag("--strict", a.check.strict, "Claims without a certificate are not good enough");
  option("--jobs", a.jobs, "How many coqc may run at a time; 0: as many as processors", "N")
      ->check(whole_number());
  option("--coqc-time", a.coqc_seconds, "Longest time of coqc for a case [300]", "SECONDS")
      ->check(number_of_seconds());
  option("--limit-time", a.check.seconds, "Time for a claim; 0: no limit", "SECONDS")
      ->check(number_of_seconds());
  option("--limit-steps", a.check.steps, "Arithmetic steps for a claim; 0: no limit", "N")
      ->check(whole_number());
  command.footer(
      "Ends like 'patchproof check'; with 70 when coqc does not accept a certificate, or takes a "
      "claim\n"
      "for another one than was asked, and with 2 when --strict is given and some claim has "
      "none.\n\n"
      "Example:\n  patchproof certify cases/coons -o out --check\n");
}

}  // namespace

void add_certify(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App* command =
      program.add_subcommand("certify", "Write certificates of verdicts, and let Rocq check them");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->check.paths.empty())
      throw UsageError{"nothing to certify: name files or folders, or '-' for standard input"};
    if (arguments->folder.empty())
      throw UsageError{"-o is missing: name a folder for the certificates"};
    if (arguments->run_coqc && arguments->format != "rocq")
      throw UsageError{"--check is for --format rocq; see 'patchproof recheck' for json"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
