#include <patchproof/repair/orientation.hpp>

#include <algorithm>
#include <set>

namespace patchproof {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

class Walk {
 public:
  Walk(const Line& line, const Names& names) : line_{line}, names_{names} {}

  void visit(const Expression& e) {
    if (e.kind == Kind::name) return name(e);
    if (e.kind == Kind::call && e.operands.front()->kind == Kind::name && is_curve_of(e)) {
      const Expression& argument = *e.arguments.front().value;
      add(e.operands.front()->text, argument.span, backwards(argument));
      return visit(argument);
    }
    for (const auto& operand : e.operands) visit(*operand);
    for (const syntax::Argument& argument : e.arguments)
      if (argument.value) visit(*argument.value);
    for (const auto& row : e.rows)
      for (const auto& entry : row) visit(*entry);
  }

  std::vector<Reversal> found() {
    std::vector<Reversal> result;
    for (Reversal& reversal : reversals_)
      if (reversal.edits.size() > 1 && !differentiated_.contains(reversal.curve))
        result.push_back(std::move(reversal));
    return result;
  }

 private:
  bool is_curve(const std::string& text) const {
    const Type* type = names_.type(text);
    return type != nullptr && type->is_function() && type->parameters.size() == 1;
  }

  bool is_curve_of(const Expression& call) const {
    return is_curve(call.operands.front()->text) && call.arguments.size() == 1 &&
           call.arguments.front().value;
  }

  // A curve as a whole; or a derivative of one, whose sign would change as well.
  void name(const Expression& e) {
    const std::string base = e.text.substr(0, e.text.find('\''));
    if (base != e.text) differentiated_.insert(base);
    const std::size_t underscore = e.text.rfind('_');
    if (underscore != std::string::npos && !names_.is_declared(e.text))
      differentiated_.insert(e.text.substr(0, underscore));
    if (!is_curve(e.text)) return;
    const std::string& parameter = names_.type(e.text)->parameters.front();
    if (names_.is_parameter(parameter))
      add(e.text, e.span, e.text + "(1-" + parameter + ")");
    else
      differentiated_.insert(e.text);
  }

  std::string backwards(const Expression& argument) const {
    const std::string text = line_.text_of(argument.span);
    if (text == "0") return "1";
    if (text == "1") return "0";
    if (argument.kind == Kind::sum && argument.operands.size() == 2 && argument.signs == "+-" &&
        line_.text_of(argument.operands.front()->span) == "1")
      return line_.text_of(argument.operands.back()->span);
    return argument.kind == Kind::sum ? "1-(" + text + ")" : "1-" + text;
  }

  void add(const std::string& curve, const Span& span, std::string text) {
    auto reversal = std::find_if(reversals_.begin(), reversals_.end(),
                                 [&](const Reversal& r) { return r.curve == curve; });
    if (reversal == reversals_.end()) reversal = reversals_.insert(reversal, {curve, {}});
    const Edit edit{Line::begin_of(span), Line::end_of(span), std::move(text), "reversed"};
    // Nested in itself, C(C(0)), it is not a slip of the pen.
    if (!reversal->edits.empty() && overlap(reversal->edits.back(), edit))
      differentiated_.insert(curve);
    reversal->edits.push_back(edit);
  }

  const Line& line_;
  const Names& names_;
  std::vector<Reversal> reversals_;
  std::set<std::string> differentiated_;
};

}  // namespace

std::vector<Reversal> reversals_of(const Line& line, const Names& names) {
  Walk walk{line, names};
  for (const syntax::Comparison& comparison : line.proposition.comparisons)
    for (const auto& operand : comparison.operands) walk.visit(*operand);
  return walk.found();
}

}  // namespace patchproof
