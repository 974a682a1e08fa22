// patchproof segments: the Bézier segments of a B-spline net, proved.
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/deadline.hpp>
#include <verify/file_blocks.hpp>
#include <verify/files.hpp>
#include <verify/output.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/net/csv_lines.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>
#include <patchproof/net/segment_comparison.hpp>
#include <patchproof/report/segments_report.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

/// What is read of a net. A file of segments is passed over once and may be larger.
constexpr std::size_t most_megabytes = 1024;
constexpr std::size_t most_segment_megabytes = 65'536;

struct SegmentsArguments {
  std::string net;
  std::string degrees;
  std::array<std::string, 2> knots;
  std::string continuity;
  std::string output;
  std::string against;
  std::string format = "text";
  std::string seconds = "600";
};

/// A file that cannot be read; what is to be said of it was said.
struct Unreadable {};

std::string shown_name(const std::string& path) { return path == "-" ? standard_input_name : path; }

[[noreturn]] void fail_to_read(const std::string& path, const std::string& problem) {
  print_error("patchproof: cannot read '" + shown_name(path) + "': " + problem + "\n");
  throw Unreadable{};
}

/// Says what is wrong with a text. It is read again for the line to be shown; of the lines before
/// only their ends are kept, so that they are counted.
[[noreturn]] void fail_at(const std::string& path, const ByteSource& again, const NetFault& fault) {
  constexpr std::size_t behind = 4096;
  std::string text;
  std::size_t left_out = 0;
  while (left_out + text.size() < fault.end + behind) {
    const std::string_view block = again();
    if (block.empty()) break;
    text.append(block);
    const std::size_t place = std::min(fault.begin - left_out, text.size());
    const std::size_t line = place == 0 ? 0 : text.rfind('\n', place - 1) + 1;
    const auto lines = static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line), '\n'));
    text.replace(0, line, lines, '\n');
    left_out += line - lines;
  }
  const auto source =
      std::make_shared<const SourceText>(SourceText{shown_name(path), std::move(text)});
  print_error(to_text(Diagnostic{
      {source, fault.begin - left_out, fault.end - left_out}, fault.message, fault.help}));
  throw Unreadable{};
}

/// Calls read(source) for the bytes of a file, and reports what it does not like in them.
template <typename Read>
auto reading(const std::string& path, std::size_t megabytes, const Read& read) {
  // Standard input cannot be read again for the line with the mistake.
  const FileText input = path == "-" ? standard_input_text() : FileText{"", ""};
  if (!input.text) fail_to_read(path, input.problem);
  try {
    return read(path == "-" ? whole_text(*input.text) : file_blocks(path, megabytes));
  } catch (const UnreadableFile& problem) {
    fail_to_read(path, problem.what());
  } catch (const NetFault& fault) {
    fail_at(path, path == "-" ? whole_text(*input.text) : file_blocks(path, megabytes), fault);
  }
}

std::vector<Rational> numbers_of(const std::string& option, const std::string& text) {
  std::vector<Rational> numbers;
  try {
    CsvLines lines{whole_text(text)};
    while (lines.next() == CsvLine::fields)
      lines.numbers([&](Rational number, BytePlace) { numbers.push_back(std::move(number)); });
  } catch (const NetFault& fault) {
    throw UsageError{option + ": " + fault.message};
  }
  return numbers;
}

std::array<int, 2> degrees_of(const SegmentsArguments& arguments, const PointNet& net) {
  if (arguments.degrees.empty()) return net.degrees.value_or(std::array<int, 2>{3, 3});
  const std::vector<Rational> written = numbers_of("--degrees", arguments.degrees);
  std::array<int, 2> degrees{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational& degree = written.empty() ? Rational{} : written[written.size() == 1 ? 0 : k];
    if (written.empty() || written.size() > 2 || denominator(degree) != 1 || degree < Rational{1} ||
        degree > Rational{highest_net_degree})
      throw UsageError{"--degrees: one or two whole numbers from 1 to " +
                       std::to_string(highest_net_degree) + ", like 3,3"};
    degrees[k] = static_cast<int>(degree.words().numerator);
  }
  if (net.degrees && *net.degrees != degrees)
    throw UsageError{"--degrees: the file of the net gives other degrees"};
  return degrees;
}

KnotVector knots_of(const SegmentsArguments& arguments, const PointNet& net, std::size_t direction,
                    int degree) {
  const std::string letter = direction == 0 ? "u" : "v";
  const std::string& written = arguments.knots[direction];
  const std::size_t points = direction == 0 ? net.rows : net.columns;
  try {
    if (written.empty() && !net.knots) return KnotVector::clamped_uniform(degree, points);
    const std::string option = "--knots-" + letter;
    if (!written.empty() && net.knots)
      throw UsageError{option + ": the file of the net gives the knots"};
    return {degree, written.empty() ? (*net.knots)[direction] : numbers_of(option, written),
            points};
  } catch (const KnotFault& fault) {
    print_error(shown_name(arguments.net) + ": error: in " + letter + ": " + fault.what() + "\n");
    throw Unreadable{};
  }
}

int continuity_of(const SegmentsArguments& arguments, const std::array<int, 2>& degrees) {
  if (arguments.continuity.empty()) return std::min(degrees[0], degrees[1]) - 1;
  const bool good = arguments.continuity.size() == 1 && '0' <= arguments.continuity[0] &&
                    arguments.continuity[0] <= '9';
  if (!good) throw UsageError{"--continuity: a whole number from 0 to 9"};
  return arguments.continuity[0] - '0';
}

/// The file of --output, if there is to be one.
class SegmentOutput {
 public:
  SegmentOutput(const SegmentsArguments& arguments, const SegmentShape& shape) {
    if (arguments.output.empty()) return;
    for (const std::string& input : {arguments.net, arguments.against}) {
      std::error_code error;
      if (std::filesystem::equivalent(arguments.output, input, error) && !error)
        throw UnwritableFile{"it is one of the files that are read"};
    }
    file_ = std::make_unique<FileInParts>(arguments.output);
    writer_ =
        std::make_unique<SegmentWriter>(is_json_file(arguments.output), shape,
                                        [this](const std::string& text) { file_->write(text); });
  }
  void add(const SegmentStrip& strip) {
    if (writer_) writer_->add(strip);
  }
  void finish() {
    if (!writer_) return;
    writer_->finish();
    file_->finish();
  }

 private:
  std::unique_ptr<FileInParts> file_;
  std::unique_ptr<SegmentWriter> writer_;
};

void convert(const SegmentsArguments& arguments, const PointNet& net, int continuity,
             SegmentsReport& report) {
  SegmentOutput output{arguments, report.shape};
  const auto run = [&](const StripSink& sink) {
    report.findings = segments_of(net, report.u, report.v, continuity, sink);
  };
  if (arguments.against.empty()) {
    run(arguments.output.empty() ? StripSink{}
                                 : [&](const SegmentStrip& strip) { output.add(strip); });
  } else {
    reading(arguments.against, most_segment_megabytes, [&](ByteSource source) {
      SegmentComparison comparison{is_json_file(arguments.against), std::move(source),
                                   report.shape};
      run([&](const SegmentStrip& strip) {
        output.add(strip);
        comparison.compare(strip);
      });
      comparison.finish();
      report.different_points = comparison.different_points();
      report.first_difference = comparison.first();
    });
  }
  output.finish();
}

// What is said when the time is over, and nothing is known.
std::string unknown(const SegmentsArguments& arguments) {
  const std::string reason = "limit: more than " + arguments.seconds + " s";
  if (arguments.format == "text")
    return shown_name(arguments.net) + ": UNKNOWN: " + reason +
           "\n       = help: allow more with --limit-time\n";
  nlohmann::ordered_json document;
  document["version"] = version;
  document["net"] = shown_name(arguments.net);
  document["verdict"] = "UNKNOWN";
  document["reason"] = reason;
  document["exit"] = static_cast<int>(ExitCode::unknown);
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

ExitCode run(const SegmentsArguments& arguments) {
  const Deadline deadline{std::chrono::seconds{std::stol(arguments.seconds)}, unknown(arguments),
                          ExitCode::unknown};
  try {
    const PointNet net = reading(arguments.net, most_megabytes, [&](ByteSource source) {
      return net_from_file(arguments.net, std::move(source));
    });
    const std::array<int, 2> degrees = degrees_of(arguments, net);
    SegmentsReport report{shown_name(arguments.net),
                          net.rows,
                          net.columns,
                          knots_of(arguments, net, 0, degrees[0]),
                          knots_of(arguments, net, 1, degrees[1]),
                          {},
                          {},
                          arguments.against.empty() ? "" : shown_name(arguments.against),
                          0,
                          std::nullopt};
    report.shape = {report.u.spans(), report.v.spans(), static_cast<std::size_t>(degrees[0]),
                    static_cast<std::size_t>(degrees[1]), net.dimension};
    convert(arguments, net, continuity_of(arguments, degrees), report);
    const ExitCode code = exit_code(report);
    return print(written(report, arguments.format)) ? code : graver(code, ExitCode::unreadable);
  } catch (const UnwritableFile& problem) {
    print_error("patchproof: cannot write '" + arguments.output + "': " + problem.what() + "\n");
  } catch (const Unreadable&) {
  }
  return ExitCode::unreadable;
}

void declare(CLI::App& command, SegmentsArguments& a) {
  const auto option = [&](const std::string& name, std::string& value, const std::string& what,
                          const std::string& type) {
    return command.add_option(name, value, what)->option_text(type);
  };
  option("NET", a.net, "A file of points: .json, or lines of coordinates; - for standard input",
         "");
  option("--degrees", a.degrees, "The degrees in u and v; usual are 3,3, or what the file says",
         "P,Q");
  option("--knots-u", a.knots[0], "The knots in u; usual are those of the file, or clamped uniform",
         "LIST");
  option("--knots-v", a.knots[1], "The knots in v", "LIST");
  option("--continuity", a.continuity,
         "The k of the C^k that is decided at all seams; usual is the smaller degree less 1", "K");
  option("--output", a.output, "Write the segments to a file, .json or lines of coordinates",
         "FILE");
  option("--against", a.against, "Compare with the segments in this file, .json or lines", "FILE");
  option("--format", a.format, "text (usual) or json", "FORMAT")
      ->check(CLI::IsMember(std::set<std::string>{"text", "json"}));
  option("--limit-time", a.seconds, "Time for all of it, 600 where nothing is said; 0: no limit",
         "SECONDS")
      ->check(whole_number());
  command.footer(
      "Ends with 0 when everything is proved, 1 when something is refuted, 2 when the time was "
      "not\n"
      "enough, 4 when a file cannot "
      "be\n"
      "read or written, 64 for a wrong command line, 70 for a fault of the program.\n\n"
      "Example:\n  patchproof segments surface.csv --against my_segments.csv\n");
}

}  // namespace

void add_segments(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<SegmentsArguments>();
  CLI::App* command =
      program.add_subcommand("segments", "Convert a B-spline net to Bézier segments, with proofs");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->net.empty()) throw UsageError{"no net: name a file, or '-' for standard input"};
    if (arguments->net == "-" && arguments->against == "-")
      throw UsageError{"standard input cannot be both the net and the segments"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
