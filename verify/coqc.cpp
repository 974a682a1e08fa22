#include <unistd.h>
#include <verify/coqc.hpp>
#include <verify/files.hpp>
#include <verify/process.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <regex>
#include <sstream>
#include <thread>

#include <patchproof/certificate/rocq_library.hpp>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds pause{10};
constexpr const char* library_folder = "PatchProof";

std::vector<std::string> command(const std::string& file) {
  return {"coqc", "-q",           "-w",         "-ambiguous-paths,-notation-overridden",
          "-Q",   library_folder, "PatchProof", file};
}

CoqRun run_of(const Process& process, const std::string& log, bool late,
              std::chrono::seconds longest) {
  CoqRun run;
  run.output = file_text(log).text.value_or("");
  run.accepted = process.code() == 0;
  if (run.accepted) return run;
  if (late) {
    run.problem = "stopped after " + std::to_string(longest.count()) + " seconds";
    return run;
  }
  static const std::regex place{R"(^File "[^"]*", line ([0-9]{1,9}), characters)"};
  std::istringstream lines{run.output};
  bool in_error = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.size() < 1000 && std::regex_search(line, match, place))
      run.line = std::stoul(match[1].str());
    if (line.rfind("Error:", 0) == 0) in_error = true;
    if (in_error && run.problem.size() < 200)
      run.problem += (run.problem.empty() ? "" : " ") + line;
  }
  if (run.problem.empty()) run.problem = "coqc ended without a word";
  return run;
}

}  // namespace

std::string coqc_version() {
  if (!is_installed("coqc")) return "";
  const fs::path log =
      fs::temp_directory_path() / ("patchproof-coqc-version-" + std::to_string(::getpid()));
  Process coqc{{"coqc", "--version"}, "", log.string()};
  while (!coqc.ended()) std::this_thread::sleep_for(pause);
  const std::string text = file_text(log.string()).text.value_or("");
  std::error_code ignored;
  fs::remove(log, ignored);
  std::smatch match;
  static const std::regex number{R"(version ([0-9]+\.[0-9.]+))"};
  return std::regex_search(text, match, number) ? match[1].str() : "";
}

std::vector<CoqRun> coqc_runs(const std::string& folder, const std::vector<std::string>& files,
                              std::size_t jobs, std::chrono::seconds longest,
                              const std::function<void(std::size_t)>& progress) {
  struct Job {
    std::size_t file;
    std::unique_ptr<Process> process;
    bool late = false;
  };
  std::vector<CoqRun> runs(files.size());
  std::vector<Job> running;
  std::size_t next = 0;
  const auto log_of = [&](std::size_t file) {
    return (fs::path{folder} / files[file]).replace_extension(".log").string();
  };
  while (next < files.size() || !running.empty()) {
    while (next < files.size() && running.size() < jobs) {
      running.push_back(
          {next, std::make_unique<Process>(command(files[next]), folder, log_of(next)), false});
      ++next;
    }
    std::this_thread::sleep_for(pause);
    for (Job& job : running)
      if (!job.process->ended() && job.process->age() > longest) {
        job.process->kill();
        job.late = true;
      }
    for (auto job = running.begin(); job != running.end();) {
      if (!job->process->ended()) {
        ++job;
        continue;
      }
      runs[job->file] = run_of(*job->process, log_of(job->file), job->late, longest);
      if (progress) progress(job->file);
      job = running.erase(job);
    }
  }
  return runs;
}

std::string library_made(const std::string& folder) {
  const fs::path place = fs::path{folder} / library_folder;
  std::error_code error;
  fs::create_directories(place, error);
  if (error) return "cannot make '" + place.string() + "': " + error.message();
  std::string order;
  bool stale = false;
  for (const auto& [name, text] : rocq_library_files()) {
    if (name == "ORDER") {
      order = text;
      continue;
    }
    const std::string path = (place / name).string();
    if (file_text(path).text == std::string{text}) continue;
    stale = true;
    if (const std::string problem = replace_file(path, std::string{text}); !problem.empty())
      return "cannot write '" + path + "': " + problem;
  }
  std::istringstream names{order};
  for (std::string name; std::getline(names, name);) {
    // What changed may be needed by all that follow.
    if (!stale && fs::exists(place / (name + ".vo"))) continue;
    stale = true;
    const std::string file = std::string{library_folder} + "/" + name + ".v";
    const CoqRun run = coqc_runs(folder, {file}, 1, std::chrono::seconds{600}, {}).front();
    if (!run.accepted)
      return "coqc does not accept the support library, " + file + ": " + run.problem;
  }
  return "";
}

std::optional<std::vector<std::string>> axioms_in(const std::string& output) {
  // Without the word of coqc nothing is known: no axioms named is not the same as none used.
  if (output.find("\nAxioms:") == std::string::npos && output.rfind("Axioms:", 0) != 0 &&
      output.find("Closed under the global context") == std::string::npos)
    return std::nullopt;
  std::vector<std::string> result;
  std::istringstream lines{output};
  bool listing = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("Axioms:", 0) == 0 || line.rfind("Section Variables:", 0) == 0) {
      listing = true;
      continue;
    }
    if (!listing || line.empty() || line.front() == ' ') continue;
    const std::string name = line.substr(0, line.find_first_of(" :"));
    if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
  }
  return result;
}

bool is_accepted_axiom(const std::string& axiom) {
  constexpr std::array<const char*, 4> accepted{
      "ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
      "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"};
  return std::find(accepted.begin(), accepted.end(), axiom) != accepted.end();
}

}  // namespace patchproof
