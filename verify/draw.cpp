// patchproof draw: a picture of a patch, curve or joint, or of how far a refuted claim is off.
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/image.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>

#include <memory>

#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/svg_writer.hpp>
#include <patchproof/figure/tikz_writer.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

struct DrawArguments {
  std::string path;
  std::vector<std::string> names;
  std::string case_name;
  std::string output;
  std::string size;
  std::string view;
  bool net = false;
  bool twists = false;
  bool zebra = false;
};

ExitCode complain(const std::string& problem, const std::string& help) {
  print_error("patchproof draw: " + problem + "\n" +
              (help.empty() ? "" : "  = help: " + help + "\n"));
  return ExitCode::usage;
}

// "35,20": whole degrees, not more than a turn.
View view_of(const std::string& text) {
  const auto degrees = [&](std::string part, int most) {
    const bool negative = part.starts_with("-");
    if (negative) part.erase(0, 1);
    const bool whole = !part.empty() && part.size() <= 3 &&
                       part.find_first_not_of("0123456789") == std::string::npos;
    if (!whole || std::stoi(part) > most)
      throw UsageError{"--view: '" + text + "' is not two angles in whole degrees, like 32,30"};
    return negative ? -std::stoi(part) : std::stoi(part);
  };
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return {degrees("", 0), 0};
  return {degrees(text.substr(0, comma), 360), degrees(text.substr(comma + 1), 90)};
}

FigureOptions options_of(const DrawArguments& arguments) {
  constexpr int least = 10;
  constexpr int most = 1000;
  FigureOptions options;
  options.net = arguments.net;
  options.twists = arguments.twists;
  options.zebra = arguments.zebra;
  if (!arguments.view.empty()) options.view = view_of(arguments.view);
  if (arguments.size.empty()) return options;
  const long long size = std::stoll(arguments.size);
  if (size < least || size > most)
    throw UsageError{"--size: from 10 to 1000 millimetres can be drawn"};
  options.width = size;
  options.greatest_height = size;
  return options;
}

// The derivations are made, and the claims whose deviation may be asked for.
CaseResult result_for(const Case& given, const std::vector<std::string>& names) {
  VerificationOptions options;
  options.engines = Engines::kernel;
  options.wanted = [&](const Claim& claim) {
    if (claim.verb == "derive") return true;
    return names.size() == 1 && claim.label == names.front().substr(0, names.front().find('['));
  };
  return verified(given, options);
}

std::string names_of(const std::vector<Case>& cases) {
  std::string text;
  for (const Case& given : cases) text += (text.empty() ? "" : ", ") + given.name;
  return text;
}

ExitCode draw(const Case& given, const DrawArguments& arguments, const FigureOptions& options) {
  const Drawing drawing = drawing_of(result_for(given, arguments.names), arguments.names, options);
  if (!drawing.figure) return complain(drawing.problem, drawing.help);
  std::string text;
  if (arguments.output.ends_with(".png")) {
    FileText png = png_of(svg(*drawing.figure));
    if (!png.text) {
      print_error("patchproof: cannot write '" + arguments.output + "': " + png.problem + "\n");
      return ExitCode::unreadable;
    }
    text = std::move(*png.text);
  } else {
    text = arguments.output.ends_with(".svg") ? svg(*drawing.figure)
                                              : tikz(*drawing.figure, latex_labels(given.notation));
  }
  Output output{arguments.output, {arguments.path}};
  return output.good() && output.write(text) ? ExitCode::as_expected : ExitCode::unreadable;
}

ExitCode run(const DrawArguments& arguments) {
  const FigureOptions options = options_of(arguments);
  bool known_ending = false;
  for (const char* ending : {".svg", ".png", ".tex", ".tikz"})
    known_ending = known_ending || arguments.output.ends_with(ending);
  if (!known_ending)
    throw UsageError{"'" + arguments.output + "' has to end in .svg, .png, .tex or .tikz"};
  CheckOptions reading;
  reading.load = [](const std::string& path) { return file_text(path).text; };
  const std::vector<CaseFile> files = read_files(inputs(found_paths({arguments.path})), reading);
  Report report;
  std::vector<Case> cases;
  for (const CaseFile& file : files) {
    report.files.push_back({file.path, file.unreadable, file.diagnostics, {}});
    cases.insert(cases.end(), file.cases.begin(), file.cases.end());
  }
  print_error(mistakes(report));
  if (cases.empty()) {
    if (files.empty()) return complain("no .proof file in '" + arguments.path + "'", "");
    return ExitCode::unreadable;
  }
  if (arguments.case_name.empty()) {
    if (cases.size() == 1) return draw(cases.front(), arguments, options);
    return complain("there are " + std::to_string(cases.size()) + " cases in '" + arguments.path +
                        "': name one with --case",
                    "one of " + names_of(cases));
  }
  std::vector<std::string> known;
  for (const Case& given : cases) {
    if (given.name == arguments.case_name) return draw(given, arguments, options);
    known.push_back(given.name);
  }
  return complain("there is no case '" + arguments.case_name + "' in '" + arguments.path + "'",
                  did_you_mean(arguments.case_name, known));
}

}  // namespace

void add_draw(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<DrawArguments>();
  CLI::App* command =
      program.add_subcommand("draw", "Draw a patch, a curve, a joint, or how far a claim is off");
  const auto option = [&](const std::string& name, std::string& value, const std::string& what,
                          const std::string& type) {
    return command->add_option(name, value, what)->option_text(type);
  };
  option("CASE", arguments->path, "A case file, or - for standard input", " ")->required();
  command
      ->add_option("PATCH", arguments->names,
                   "Curves, patches or scalar functions of the case, drawn together; or the label "
                   "of one refuted equation, whose sides are compared")
      ->option_text("...")
      ->required();
  option("-o,--output", arguments->output, "The file: *.svg, *.png, *.tex or *.tikz", "FILE")
      ->required();
  option("--case", arguments->case_name, "Which case of the file", "NAME");
  option("--size", arguments->size, "Greatest width and height in millimetres; usual are 90", "MM")
      ->check(whole_number());
  option("--view", arguments->view, "Azimuth and elevation in degrees; usual are 32,30", "A,E");
  command->add_flag("--net", arguments->net,
                    "The Bézier net also of patches that are not written as Bézier patches");
  command->add_flag("--twists", arguments->twists, "Twist vectors at the corners");
  command->add_flag("--zebra", arguments->zebra, "Zebra stripes in the place of shades and lines");
  command->footer(
      "Ends with 0 when the file is written, 4 when the case cannot be read or the file not be\n"
      "written, 64 for what cannot be drawn.\n\n"
      "Example:\n  patchproof draw cases/ruled/ruled.proof r --case sk.ruled.C -o r.svg\n");
  command->callback([arguments, &result] { result = run(*arguments); });
}

}  // namespace patchproof
