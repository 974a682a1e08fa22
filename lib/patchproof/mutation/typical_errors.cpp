#include <patchproof/mutation/typical_errors.hpp>

#include <algorithm>
#include <utility>

#include <patchproof/language/lexer.hpp>
#include <patchproof/repair/line.hpp>

namespace patchproof {

namespace {

using syntax::Argument;
using syntax::Expression;
using Kind = Expression::Kind;

/// In longer lists nobody exchanges two arguments by a slip of the pen.
constexpr std::size_t most_exchanged = 6;

enum class Place { value, divisor, argument, index, exponent };

std::string shortened(const Span& span) {
  constexpr std::size_t longest = 40;
  const std::string text = in_one_line(span);
  return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

/// Walks over an expression and collects what may have gone wrong in it.
class Walk {
 public:
  explicit Walk(const Vocabulary& vocabulary) : vocabulary_{vocabulary} {}

  std::vector<TypicalError> errors(const Expression& e) {
    visit(e, Place::value);
    const auto before = [](const TypicalError& a, const TypicalError& b) {
      return a.edit < b.edit;
    };
    std::stable_sort(result_.begin(), result_.end(), before);
    const auto same = [](const TypicalError& a, const TypicalError& b) { return a.edit == b.edit; };
    result_.erase(std::unique(result_.begin(), result_.end(), same), result_.end());
    return std::move(result_);
  }

 private:
  static std::string text_of(const Span& span) {
    return span.source->text.substr(span.begin, span.end - span.begin);
  }

  void add(std::size_t begin, std::size_t end, const std::string& text, const char* what,
           const std::string& words) {
    result_.push_back(
        {{begin, end, text, what}, words + (context_.empty() ? "" : " in " + context_)});
  }

  void replace(const Span& span, const std::string& text, const char* what) {
    add(span.begin, span.end, text, what, shortened(span) + " -> " + text);
  }

  void visit(const Expression& e, Place place) {
    switch (e.kind) {
      case Kind::number:
        return number(e, place);
      case Kind::name:
        return name(e);
      case Kind::sum:
        return sum(e, place);
      case Kind::product:
        return product(e, place);
      case Kind::negation:
        add(e.mark.begin, e.mark.end, "", "sign", "sign of " + shortened(e.operands[0]->span));
        return visit(*e.operands[0], place);
      case Kind::power:
        visit(*e.operands[0], place);
        return visit(*e.operands[1], Place::exponent);
      case Kind::call:
      case Kind::index:
        return applied(e);
      case Kind::matrix:
        for (const auto& row : e.rows)
          for (const auto& entry : row) visit(*entry, Place::value);
        return;
      default:
        for (const auto& operand : e.operands) visit(*operand, place);
    }
  }

  void number(const Expression& e, Place place) {
    const Rational& n = e.number;
    const bool is_whole = denominator(n) == 1;
    const auto become = [&](const Rational& value, const char* what) {
      const std::string text = to_text(value);
      replace(e.span, denominator(value) == 1 ? text : "(" + text + ")", what);
    };
    const bool is_corner = place == Place::argument && n == 1;
    if (!is_corner) become(n + 1, place == Place::index ? "index" : "number");
    if (is_corner || (place == Place::index && n >= 1) || (place == Place::divisor && n >= 3))
      become(n - 1, place == Place::index ? "index" : "number");
    if (!is_whole) become(-n, "sign");
  }

  void name(const Expression& e) {
    const std::string unprimed = e.text.substr(0, e.text.find('\''));
    const std::string primes = e.text.substr(unprimed.size());
    const std::size_t underscore = unprimed.rfind('_');
    const bool is_whole =
        vocabulary_.names.contains(unprimed) || underscore == std::string::npos || underscore == 0;
    const std::string base = is_whole ? unprimed : unprimed.substr(0, underscore);
    const std::string suffix = unprimed.substr(base.size());
    for (const std::string& other : vocabulary_.similar(base))
      replace(e.span, other + suffix + primes, "name");
    for (std::size_t k = 1; k < suffix.size(); ++k) {
      // r_uv and r_vu are the same: of equal letters the first stands for all.
      if (suffix.find(suffix[k]) != k) continue;
      for (const std::string& parameter : vocabulary_.parameters) {
        if (parameter.size() != 1 || parameter[0] == suffix[k]) continue;
        std::string other = suffix;
        other[k] = parameter[0];
        std::sort(other.begin() + 1, other.end());
        replace(e.span, base + other, "derivative");
      }
    }
  }

  /// The sign that stands before an operand of a sum, after the one before it.
  static const Token* sign_between(const std::vector<Token>& tokens, std::size_t from,
                                   std::size_t to, const std::string& text) {
    for (const Token& token : tokens) {
      if (token.begin < from || token.end > to || token.end != token.begin + 1) continue;
      if (text[token.begin] == '+' || text[token.begin] == '-') return &token;
    }
    return nullptr;
  }

  void sum(const Expression& e, Place place) {
    const std::string outer = context_;
    if (e.parenthesised) context_ = shortened(e.span);
    if (place != Place::exponent) signs(e, place);
    for (const auto& operand : e.operands) visit(*operand, place);
    context_ = outer;
  }

  void signs(const Expression& e, Place place) {
    const std::string& text = e.span.source->text;
    const std::vector<Token>& tokens = tokens_in(e.span.source);
    for (std::size_t k = 0; k < e.operands.size(); ++k) {
      const Span& operand = e.operands[k]->span;
      const std::size_t from = k == 0 ? e.span.begin : e.operands[k - 1]->span.end;
      const Token* sign = sign_between(tokens, from, operand.begin, text);
      const std::string words = shortened(operand);
      if (sign == nullptr)
        add(operand.begin, operand.begin, "-", "sign", "sign of " + words);
      else if (k == 0)
        add(sign->begin, sign->end, "", "sign", "sign of " + words);
      else
        add(sign->begin, sign->end, e.signs[k] == '+' ? "-" : "+", "sign", "sign of " + words);
      if (e.operands.size() < 2 || place == Place::index) continue;
      if (k > 0)
        add(from, operand.end, "", "summand", words + " left out");
      else if (const Token* next =
                   sign_between(tokens, operand.end, e.operands[1]->span.begin, text))
        // A minus stays: a - b becomes -b.
        add(sign == nullptr ? operand.begin : sign->begin,
            e.signs[1] == '+' ? next->end : next->begin, "", "summand", words + " left out");
    }
  }

  void product(const Expression& e, Place place) {
    for (std::size_t k = 0; k < e.operands.size(); ++k) {
      const Expression& operand = *e.operands[k];
      const bool divides = e.signs[k] == '/';
      const bool is_fraction = divides && k > 0 && operand.kind == Kind::number &&
                               e.operands[k - 1]->kind == Kind::number;
      if (is_fraction) {
        fraction(*e.operands[k - 1], operand);
        continue;
      }
      // The numerator of 1/9 is changed with it.
      const bool is_numerator = operand.kind == Kind::number && k + 1 < e.operands.size() &&
                                e.signs[k + 1] == '/' && e.operands[k + 1]->kind == Kind::number;
      if (is_numerator && operand.number == 1) continue;
      visit(operand, divides ? Place::divisor : place);
    }
  }

  // 1/9 -> 1/10, 1/3 -> 1/2
  void fraction(const Expression& above, const Expression& below) {
    const std::string start = text_of(above.span) + "/";
    const auto become = [&](const Rational& value) {
      const std::string text = to_text(value);
      add(below.span.begin, below.span.end, text, "number",
          start + text_of(below.span) + " -> " + start + text);
    };
    if (denominator(below.number) != 1) return;
    become(below.number + 1);
    if (below.number >= 3) become(below.number - 1);
  }

  void applied(const Expression& e) {
    const Expression& head = *e.operands.front();
    const bool is_call = e.kind == Kind::call;
    visit(head, Place::value);
    // Arguments look alike: "0 -> 1" alone says little.
    const std::string outer = std::exchange(context_, shortened(e.span));
    for (const Argument& a : e.arguments) {
      if (a.value) visit(*a.value, is_call ? Place::argument : Place::index);
      if (a.value && is_call) transposed(*a.value);
      const auto* interval = a.binder ? &a.binder->interval : a.interval ? &*a.interval : nullptr;
      if (interval != nullptr) {
        const std::string around = context_;
        if (a.binder) context_ = a.binder->name.text + " in " + ends_of(*interval);
        visit(*interval->first, Place::index);
        visit(*interval->last, Place::index);
        context_ = around;
      }
    }
    exchanged(e);
    context_ = outer;
  }

  static std::string ends_of(const syntax::Interval& interval) {
    return text_of(interval.first->span) + ".." + text_of(interval.last->span);
  }

  void transposed(const Expression& e) {
    if (e.kind == Kind::name && vocabulary_.nets.contains(e.text))
      replace(e.span, "transpose(" + e.text + ")", "transposed");
  }

  void exchanged(const Expression& e) {
    if (e.arguments.size() > most_exchanged) return;
    for (std::size_t a = 0; a < e.arguments.size(); ++a) {
      for (std::size_t b = a + 1; b < e.arguments.size(); ++b) {
        if (!e.arguments[a].value || !e.arguments[b].value) continue;
        const Span& first = e.arguments[a].value->span;
        const Span& second = e.arguments[b].value->span;
        if (text_of(first) == text_of(second)) continue;
        const std::string between = text_of({first.source, first.end, second.begin});
        add(first.begin, second.end, text_of(second) + between + text_of(first), "exchanged",
            shortened(first) + " and " + shortened(second) + " exchanged");
      }
    }
  }

  const std::vector<Token>& tokens_in(const std::shared_ptr<const SourceText>& source) {
    if (tokens_.empty()) tokens_ = tokens_of(source).tokens;
    return tokens_;
  }

  const Vocabulary& vocabulary_;
  std::vector<Token> tokens_;
  /// The innermost call, index or pair of parentheses around the place.
  std::string context_;
  std::vector<TypicalError> result_;
};

}  // namespace

std::vector<TypicalError> typical_errors(const syntax::ExpressionPointer& expression,
                                         const Vocabulary& vocabulary) {
  return Walk{vocabulary}.errors(*expression);
}

}  // namespace patchproof
