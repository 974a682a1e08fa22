#include <patchproof/latex/case_figure.hpp>

#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/tikz_writer.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

bool is_patch(const Declaration& declaration) {
  return declaration.keyword == "patch" && !declaration.given &&
         declaration.term.type().is_function();
}

// What to draw, in the order of preference.
std::vector<std::vector<std::string>> candidates(const Case& given) {
  std::vector<std::vector<std::string>> result;
  for (const auto& [first, second] : given.joined) {
    if (first != second) result.push_back({first, second});
    break;
  }
  // What is defined last is made of what is defined before, and what the case is about.
  for (auto declaration = given.declarations.rbegin(); declaration != given.declarations.rend();
       ++declaration)
    if (is_patch(*declaration)) result.push_back({declaration->name});
  return result;
}

}  // namespace

std::string case_figure(const CaseResult& result, const Wording& wording) {
  // A page prints small, and a book has hundreds of them.
  constexpr std::size_t most_tries = 4;
  FigureOptions options;
  options.width = 75;
  options.greatest_height = 60;
  options.cells = 10;
  options.cells_between_lines = 2;
  std::size_t tries = 0;
  for (const std::vector<std::string>& names : candidates(result.verified)) {
    if (++tries > most_tries) break;
    const Drawing drawing = drawing_of(result, names, options);
    if (!drawing.figure) continue;
    std::string caption;
    for (const std::string& name : names)
      caption += (caption.empty() ? "$" : ", $") +
                 latex_name(name, wording.names.notation).text() + "$";
    if (!drawing.figure->notes.empty()) caption += "; " + wording(Word::example_values);
    return "\\ppfigure{" + tikz(*drawing.figure, latex_labels(wording.names.notation)) + "}{" +
           caption + "}\n";
  }
  return "";
}

}  // namespace patchproof
