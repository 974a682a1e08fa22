#include <patchproof/latex/case_figure.hpp>

#include <algorithm>
#include <set>

#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/tikz_writer.hpp>
#include <patchproof/latex/given_text.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

bool is_patch(const Declaration& declaration) {
  return declaration.keyword == "patch" && !declaration.given &&
         declaration.term.type().is_function();
}

using Seen = std::set<const TermNode*>;

bool speaks_of(const Term& where, const Term& what, Seen& seen) {
  if (is_one_term(where, what)) return true;
  // Nor is what a function of the case stands for.
  if (where.operation() == Operation::lambda) return false;
  if (!seen.insert(where.address()).second) return false;
  // What a definition was made into is not what is said.
  const bool call = where.operation() == Operation::definition && where.children().size() > 1;
  for (std::size_t k = call ? 1 : 0; k < where.children().size(); ++k)
    if (speaks_of(where.child(k), what, seen)) return true;
  return false;
}

// A line or a point is no picture of a patch.
bool is_degenerate(const Figure& figure) {
  return figure.height * 6 < figure.width || figure.width * 6 < figure.height ||
         figure.shapes.size() < 3;
}

std::size_t claims_about(const Term& patch, const Case& given) {
  std::size_t count = 0;
  for (const Claim& claim : given.claims) {
    Seen seen;
    const std::vector<Statement>& statements = goal_of(claim).statements;
    count += std::any_of(statements.begin(), statements.end(), [&](const Statement& statement) {
      return speaks_of(statement.left, patch, seen) || speaks_of(statement.right, patch, seen);
    });
  }
  return count;
}

// What to draw, in the order of preference.
std::vector<std::vector<std::string>> candidates(const Case& given) {
  std::vector<std::vector<std::string>> result;
  for (const auto& [first, second] : given.joined) {
    if (first != second) result.push_back({first, second});
    break;
  }
  // What most claims speak of; what is defined last is made of what is defined before.
  std::vector<std::pair<std::size_t, std::string>> patches;
  for (auto declaration = given.declarations.rbegin(); declaration != given.declarations.rend();
       ++declaration)
    if (is_patch(*declaration))
      patches.emplace_back(claims_about(declaration->term, given), declaration->name);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [count, name] : patches) result.push_back({name});
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
    if (!drawing.figure || is_degenerate(*drawing.figure)) continue;
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
