#include <patchproof/repair/edits.hpp>

#include <algorithm>
#include <set>

#include <patchproof/repair/name_edits.hpp>
#include <patchproof/repair/number_edits.hpp>
#include <patchproof/repair/sign_edits.hpp>

namespace patchproof {

namespace {

using syntax::Argument;
using syntax::Expression;
using Kind = Expression::Kind;

/// In longer lists nobody exchanges two arguments by a slip of the pen.
constexpr std::size_t most_exchanged = 8;

// Parentheses around everything that would otherwise be torn apart by an operator next to it.
std::string as_operand(const Expression& e, const std::string& text) {
  const bool torn = e.kind == Kind::sum || e.kind == Kind::product || e.kind == Kind::power ||
                    e.kind == Kind::negation;
  return torn && !e.parenthesised ? "(" + text + ")" : text;
}

/// Walks over one comparison and collects what may be changed.
class Walk {
 public:
  Walk(const Line& line, const Names& names, const std::vector<std::string>& running,
       const std::vector<Span>& determined)
      : line_{line},
        names_{names},
        determined_{determined},
        numbers_{numbers_in(line)},
        running_{running} {}

  std::vector<Edit> edits(const syntax::Comparison& comparison) {
    result_ = sign_edits(line_, comparison.span);
    for (const auto& operand : comparison.operands) side(*operand);
    result_.erase(std::remove_if(result_.begin(), result_.end(),
                                 [&](const Edit& edit) { return is_determined(edit); }),
                  result_.end());
    std::stable_sort(result_.begin(), result_.end());
    result_.erase(std::unique(result_.begin(), result_.end()), result_.end());
    return std::move(result_);
  }

 private:
  bool is_determined(const Edit& edit) const {
    return std::any_of(determined_.begin(), determined_.end(), [&](const Span& span) {
      return Line::begin_of(span) <= edit.begin && edit.end <= Line::end_of(span);
    });
  }

  void add(const Expression& e, std::string text, const char* what) {
    result_.push_back({Line::begin_of(e.span), Line::end_of(e.span), std::move(text), what});
  }

  std::string text_of(const Expression& e) const { return line_.text_of(e.span); }

  // Something that may have a sign of its own.
  void side(const Expression& e) {
    if (e.kind == Kind::sum ? e.signs.front() == '+' : e.kind != Kind::number) {
      const Expression& first = e.kind == Kind::sum ? *e.operands.front() : e;
      const std::size_t begin = Line::begin_of(first.span);
      result_.push_back({begin, begin, "-", "sign"});
    }
    visit(e, NumberPlace::value);
  }

  void visit(const Expression& e, NumberPlace place) {
    switch (e.kind) {
      case Kind::number:
        add_number_edits(line_, e, place, numbers_, result_);
        break;
      case Kind::name:
        add_name_edits(e, names_, running_, result_);
        add_reversed_function(e);
        add_transposed(e);
        break;
      case Kind::call:
        call(e);
        break;
      case Kind::index:
        index(e);
        break;
      case Kind::power:
        visit(*e.operands[0], place);
        visit(*e.operands[1], NumberPlace::exponent);
        break;
      case Kind::tuple:
        for (const auto& operand : e.operands) side(*operand);
        break;
      case Kind::matrix:
        add_transposed(e);
        for (const auto& row : e.rows)
          for (const auto& entry : row) side(*entry);
        break;
      default:
        if (e.kind == Kind::sum && e.parenthesised && e.signs.front() == '+') {
          const std::size_t begin = Line::begin_of(e.operands.front()->span);
          result_.push_back({begin, begin, "-", "sign"});
        }
        for (const auto& operand : e.operands) visit(*operand, place);
        break;
    }
  }

  // C1 becomes C1(1-u) where it is handed on as a whole.
  void add_reversed_function(const Expression& e) {
    const Type* type = names_.type(e.text);
    if (type == nullptr || !type->is_function() || type->parameters.size() != 1) return;
    const std::string& parameter = type->parameters.front();
    if (names_.is_parameter(parameter)) add(e, e.text + "(1-" + parameter + ")", "reversed");
  }

  void add_transposed(const Expression& e) {
    const Type* type = e.kind == Kind::name ? names_.type(e.text) : nullptr;
    const bool is_matrix = e.kind != Kind::name || (type != nullptr && type->is_matrix());
    if (is_matrix) add(e, "transpose(" + text_of(e) + ")", "transposed");
  }

  void call(const Expression& e) {
    const Expression& callee = *e.operands.front();
    if (callee.kind == Kind::name)
      add_name_edits(callee, names_, running_, result_);
    else
      visit(callee, NumberPlace::value);
    const bool is_transpose = callee.kind == Kind::name && callee.text == "transpose";
    if (is_transpose && e.arguments.size() == 1 && e.arguments[0].value) {
      const Expression& inner = *e.arguments[0].value;
      add(e, as_operand(inner, text_of(inner)), "transposed");
    }
    const std::size_t running = running_.size();
    for (const Argument& a : e.arguments) {
      if (a.range) {
        visit(*a.range->range.lower, NumberPlace::value);
        visit(*a.range->range.upper, NumberPlace::value);
      }
      if (!a.binder) continue;
      // The ends of a running index do not see it.
      ends(a.binder->interval);
      running_.push_back(a.binder->name.text);
    }
    for (const Argument& a : e.arguments) {
      if (!a.value) continue;
      const std::size_t before = result_.size();
      visit(*a.value, NumberPlace::argument);
      // Transposing twice is the same as not at all.
      if (is_transpose) forget_transposed(*a.value, before);
      add_reversed_argument(*a.value);
    }
    running_.resize(running);
    add_exchanged(e);
  }

  void forget_transposed(const Expression& e, std::size_t from) {
    const auto is_of_e = [&](const Edit& edit) {
      return edit.what == "transposed" && edit.begin == Line::begin_of(e.span) &&
             edit.end == Line::end_of(e.span);
    };
    result_.erase(
        std::remove_if(result_.begin() + static_cast<std::ptrdiff_t>(from), result_.end(), is_of_e),
        result_.end());
  }

  void index(const Expression& e) {
    const Expression& array = *e.operands.front();
    if (array.kind == Kind::name)
      add_name_edits(array, names_, running_, result_);
    else
      visit(array, NumberPlace::value);
    bool is_part = false;
    for (const Argument& a : e.arguments) {
      if (a.interval) ends(*a.interval);
      if (a.value) visit(*a.value, NumberPlace::index);
      is_part = is_part || a.interval.has_value();
    }
    if (is_part) add_transposed(e);
    add_exchanged(e);
  }

  void ends(const syntax::Interval& interval) {
    visit(*interval.first, NumberPlace::index);
    visit(*interval.last, NumberPlace::index);
  }

  // u becomes 1-u, and 1-u becomes u.
  void add_reversed_argument(const Expression& e) {
    if (e.kind == Kind::name && names_.is_parameter(e.text)) add(e, "1-" + e.text, "reversed");
    const bool is_reversed = e.kind == Kind::sum && e.signs == "+-" &&
                             e.operands[0]->kind == Kind::number && e.operands[0]->number == 1 &&
                             e.operands[1]->kind == Kind::name;
    if (is_reversed) add(e, e.operands[1]->text, "reversed");
  }

  void add_exchanged(const Expression& e) {
    if (e.arguments.size() > most_exchanged) return;
    for (std::size_t a = 0; a < e.arguments.size(); ++a) {
      for (std::size_t b = a + 1; b < e.arguments.size(); ++b) {
        if (!e.arguments[a].value || !e.arguments[b].value) continue;
        const Span& first = e.arguments[a].value->span;
        const Span& second = e.arguments[b].value->span;
        if (line_.text_of(first) == line_.text_of(second)) continue;
        const std::string between = line_.text_of({first.source, first.end, second.begin});
        result_.push_back({Line::begin_of(first), Line::end_of(second),
                           line_.text_of(second) + between + line_.text_of(first), "exchanged"});
      }
    }
  }

  const Line& line_;
  const Names& names_;
  const std::vector<Span>& determined_;
  std::vector<Rational> numbers_;
  std::vector<std::string> running_;
  std::vector<Edit> result_;
};

}  // namespace

std::vector<Edit> edits_of(const Line& line, const syntax::Comparison& comparison,
                           const Names& names, const std::vector<std::string>& running,
                           const std::vector<Span>& determined) {
  return Walk{line, names, running, determined}.edits(comparison);
}

}  // namespace patchproof
