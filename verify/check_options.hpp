#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include <patchproof/patchproof.hpp>

namespace patchproof {

/// What can be said on the command line of `patchproof check`.
struct CheckArguments {
  std::vector<std::string> paths;
  std::vector<std::string> only;
  std::string format = "text";
  std::string output;
  std::string certificates;
  std::string colour = "auto";
  std::string engines = "usual";
  std::string seconds;
  std::string megabytes;
  std::string steps;
  std::string terms;
  std::string jobs;
  std::string shard;
  std::string cache;
  bool strict = false;
  bool audit = false;
  bool list = false;
  bool quiet = false;
  bool verbose = false;
};

/// Tells the command about its options, which are put into the arguments.
void declare(CLI::App& command, CheckArguments& arguments);

/// What a whole number, a number of seconds, and of workers, may look like on the command line.
CLI::Validator whole_number();
CLI::Validator number_of_seconds();
CLI::Validator count_of_jobs();
CLI::Validator shard_of_a_run();

/// How many workers are asked for; the number of processors where nothing is said.
std::size_t jobs_of(const CheckArguments& arguments);

/// What the arguments mean for the library.
CheckOptions options_of(const CheckArguments& arguments);

}  // namespace patchproof
