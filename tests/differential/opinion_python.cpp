#include <unistd.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <tests/cli/program.hpp>

#include "opinion.hpp"
#include "python.hpp"

namespace patchproof::differential {
namespace {

const std::string script = PATCHPROOF_SOURCE_FOLDER "/tests/differential/opinion.py";

std::string in_quotes(const std::string& path) { return "'" + path + "'"; }

}  // namespace

std::vector<std::optional<bool>> opinions_of_python(const std::vector<Example>& examples) {
  nlohmann::json asked = nlohmann::json::array();
  for (const Example& example : examples)
    asked.push_back({{"statements", example.python},
                     {"left", example.python_left},
                     {"right", example.python_right}});
  const TemporaryFolder folder;
  folder.write("asked.json", asked.dump());
  const std::string command = python_with_sympy() + " " + in_quotes(script) + " " +
                              in_quotes(folder.path("asked.json")) + " > " +
                              in_quotes(folder.path("answers.json"));
  if (std::system(command.c_str()) != 0) throw std::runtime_error{"failed: " + command};
  const auto answers = nlohmann::json::parse(folder.text("answers.json"));
  if (answers.size() != examples.size()) throw std::runtime_error{"answers are missing"};
  std::vector<std::optional<bool>> result;
  for (const auto& answer : answers)
    result.push_back(answer.is_null() ? std::nullopt : std::optional{answer.get<bool>()});
  return result;
}

}  // namespace patchproof::differential
