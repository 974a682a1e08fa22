// The program `patchproof`: options in, exit code out. Each subcommand is a file of its own.
#include <fcntl.h>
#include <unistd.h>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/memory_counter.hpp>

#include <csignal>
#include <exception>
#include <string>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/version.hpp>

namespace {

using namespace patchproof;

// The innermost subcommand that was named: the one whose help is of use.
const CLI::App& named_command(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

std::string name_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : name_of(*parent) + " " + command.get_name();
}

// What the library for command lines says of an unknown command is of little use.
std::string message_of(const CLI::ParseError& error, const CLI::App& program) {
  if (!program.get_subcommands().empty()) return error.what();
  const std::vector<std::string> rest = program.remaining();
  if (rest.empty()) return error.what();
  std::vector<std::string> known;
  for (const CLI::App* command : program.get_subcommands({})) known.push_back(command->get_name());
  const std::string help = did_you_mean(rest.front(), known);
  return "there is no command '" + rest.front() + "'" + (help.empty() ? "" : "; " + help);
}

int ended(ExitCode code) { return static_cast<int>(code); }

int run(int argument_count, char* arguments[]) {
  CLI::App program{"Proves or refutes, exactly, statements about surface patches.", "patchproof"};
  program.footer("Example:\n  patchproof check cases\n");
  program.set_version_flag("--version", "patchproof " + std::string{version});
  program.require_subcommand(1);
  ExitCode result = ExitCode::internal;
  add_check(program, result);
  add_repair(program, result);
  add_mutate(program, result);
  add_draw(program, result);
  add_format(program, result);
  add_latex(program, result);
  add_certify(program, result);
  add_definitions(program, result);
  add_dump(program, result);
  add_recheck(program, result);
  add_merge(program, result);
  add_segments(program, result);
  try {
    program.parse(argument_count, arguments);
    return ended(result);
  } catch (const CLI::CallForVersion& asked) {
    return ended(print(asked.what() + std::string{"\n"}) ? ExitCode::as_expected
                                                         : ExitCode::unreadable);
  } catch (const CLI::CallForHelp&) {
    const CLI::App& command = named_command(program);
    const std::string parent = command.get_parent() == nullptr ? "" : "patchproof";
    return ended(print(command.help(parent)) ? ExitCode::as_expected : ExitCode::unreadable);
  } catch (const CLI::ParseError& error) {
    if (argument_count <= 1) {
      print_error(program.help());
      return ended(ExitCode::usage);
    }
    const std::string name = name_of(named_command(program));
    print_error(name + ": " + message_of(error, program) + "\n  = help: '" + name +
                " --help' shows what can be said\n");
    return ended(ExitCode::usage);
  }
}

}  // namespace

namespace {

// A file that is opened must not get the number of a standard stream that is closed, or what is
// meant for nobody would be written into it. Using these still fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

}  // namespace

int main(int argument_count, char* arguments[]) {
  occupy_closed_streams();
  // A closed pipe is an error of writing like any other.
  std::signal(SIGPIPE, SIG_IGN);
  count_bytes_with(allocated_bytes);
  try {
    return run(argument_count, arguments);
  } catch (const std::bad_alloc&) {
    print_error("patchproof: out of memory\n");
  } catch (const std::exception& error) {
    print_error(std::string{"patchproof: internal error: "} + error.what() +
                "\n  = help: this is a fault of patchproof; please report it with the case\n");
  } catch (...) {
    print_error("patchproof: internal error\n");
  }
  return ended(ExitCode::internal);
}
