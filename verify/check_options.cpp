#include <verify/check_options.hpp>
#include <verify/files.hpp>
#include <verify/shard.hpp>

#include <algorithm>
#include <set>
#include <thread>

namespace patchproof {

namespace {

constexpr std::size_t most_digits = 12;
constexpr std::size_t most_jobs = 1024;

bool is_whole(const std::string& text) {
  return !text.empty() && text.size() <= most_digits &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

// Read by hand: the numbers of a limit are exact like all others.
std::string whole_number_fault(const std::string& text) {
  return is_whole(text) ? "" : "'" + text + "' is not a whole number of at most 12 digits";
}

std::string seconds_fault(const std::string& text) {
  const std::size_t point = text.find('.');
  const bool good = point == std::string::npos
                        ? is_whole(text)
                        : is_whole(text.substr(0, point)) && is_whole(text.substr(point + 1)) &&
                              text.size() - point - 1 <= 3;
  return good ? "" : "'" + text + "' is not a number of seconds, like 10 or 0.5";
}

std::chrono::milliseconds milliseconds(const std::string& seconds) {
  const std::size_t point = seconds.find('.');
  std::string thousandths = point == std::string::npos ? "" : seconds.substr(point + 1);
  thousandths.resize(3, '0');
  return std::chrono::milliseconds{std::stoll(seconds.substr(0, point)) * 1000 +
                                   std::stoll(thousandths)};
}

std::set<std::string> format_names() {
  std::set<std::string> names;
  for (const Format& format : formats()) names.emplace(format.name);
  return names;
}

}  // namespace

CLI::Validator whole_number() { return {whole_number_fault, "", "whole number"}; }
CLI::Validator number_of_seconds() { return {seconds_fault, "", "seconds"}; }

CLI::Validator count_of_jobs() {
  return {[](const std::string& text) {
            const bool good =
                is_whole(text) && std::stoull(text) >= 1 && std::stoull(text) <= most_jobs;
            return good ? "" : "'" + text + "' is not a whole number from 1 to 1024";
          },
          "", "jobs"};
}

CLI::Validator shard_of_a_run() {
  return {[](const std::string& text) {
            return shard_from_text(text) ? ""
                                         : "'" + text + "' is not the number of a shard, like 2/4";
          },
          "", "shard"};
}

void declare(CLI::App& command, CheckArguments& a) {
  const CLI::Validator whole = whole_number();
  const CLI::Validator seconds = number_of_seconds();
  const auto option = [&](const std::string& name, auto& value, const std::string& what,
                          const std::string& type) {
    return command.add_option(name, value, what)->option_text(type);
  };
  option("PATH", a.paths, "Case files, folders of *.proof, or - for standard input", "...");
  option(
      "--only", a.only,
      "Only these claims: their ids, with or without [i=0], names of cases, or tag:NAME; * stands "
      "for any characters; may be given several times",
      "GLOB")
      ->allow_extra_args(false);
  option("--format", a.format, "text (usual) or json", "FORMAT")
      ->check(CLI::IsMember(format_names()));
  option("--output", a.output, "Write the report to a file", "FILE");
  option(
      "--certificates", a.certificates,
      "Folder of 'patchproof certify --check': what is still as it was checked there is certified",
      "DIR");
  command.add_flag("--strict", a.strict, "Claims that hold only under conditions are not enough");
  command.add_flag("--audit", a.audit,
                   "Also say which claims need which assumptions; one that nothing needs is a "
                   "finding");
  command.add_flag("--list", a.list, "List the claims and what is expected; decide nothing");
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", a.quiet, "Only what needs attention, and the summary");
  command.add_flag("-v,--verbose", a.verbose, "Also evidence, witnesses, titles and times")
      ->excludes(quiet);
  option("--color", a.colour, "auto (usual), always or never", "WHEN")
      ->check(CLI::IsMember(std::set<std::string>{"auto", "always", "never"}));
  option("--engines", a.engines,
         "usual: the kernel, and the second engine where that is cheap; both: the second engine at "
         "any "
         "cost within the limits; or kernel: without second opinion",
         "WHICH")
      ->check(CLI::IsMember(std::set<std::string>{"usual", "both", "kernel"}));
  option("--jobs", a.jobs, "Claims decided at the same time; usual: the number of processors", "N")
      ->check(count_of_jobs());
  option("--shard", a.shard,
         "Only the i-th of n parts of the claims, for one of n machines; 'patchproof merge' joins "
         "their reports",
         "i/n")
      ->check(shard_of_a_run());
  option("--cache", a.cache,
         "Folder where what was decided is kept, and looked up by later runs of the same program "
         "over the same texts; made where there is none",
         "DIR");
  option("--limit-time", a.seconds, "Time for a claim; 0: no limit", "SECONDS")->check(seconds);
  option("--limit-memory", a.megabytes, "Memory for a claim; 0: no limit", "MB")->check(whole);
  option("--limit-steps", a.steps, "Arithmetic steps for a claim; 0: no limit", "N")->check(whole);
  option("--limit-terms", a.terms, "Terms of one polynomial; 0: no limit", "N")->check(whole);
  command.footer(
      "Ends with 0 when every claim is decided as expected, 1 when one is decided otherwise\n"
      "(with --audit also for an assumption that nothing needs),\n"
      "2 when one is not decided, 3 for contradictory assumptions (with --strict also for\n"
      "conditions), 4 for mistakes in a text, 5 when there is no claim, 64 for a wrong command\n"
      "line, 70 for a fault of the program.\n\n"
      "Example:\n  patchproof check cases --only 'coons.*'\n");
}

std::size_t jobs_of(const CheckArguments& arguments) {
  if (!arguments.jobs.empty()) return std::stoull(arguments.jobs);
  return std::max(1U, std::thread::hardware_concurrency());
}

CheckOptions options_of(const CheckArguments& arguments) {
  CheckOptions options;
  options.strict = arguments.strict;
  options.audit = arguments.audit;
  options.engines = arguments.engines == "both"     ? Engines::both
                    : arguments.engines == "kernel" ? Engines::kernel
                                                    : Engines::usual;
  Limits& limits = options.limits;
  if (!arguments.seconds.empty()) limits.time = milliseconds(arguments.seconds);
  if (!arguments.megabytes.empty()) limits.memory = std::stoull(arguments.megabytes) * 1'000'000;
  if (!arguments.steps.empty()) limits.steps = std::stoull(arguments.steps);
  if (!arguments.terms.empty()) limits.terms = std::stoull(arguments.terms);
  options.load = [](const std::string& path) { return file_text(path).text; };
  return options;
}

}  // namespace patchproof
