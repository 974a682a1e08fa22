#include <patchproof/certificate/rocq_syntax.hpp>

#include <algorithm>

namespace patchproof {

namespace {

using Kind = RocqTerm::Kind;

// The levels of Rocq's notations: the smaller, the tighter.
int level_of(const RocqTerm& term) {
  switch (term.kind) {
    // A negative number is written like an opposite, and read as one number only there.
    case Kind::number: return term.number < 0 ? 35 : 0;
    case Kind::name: return 0;
    case Kind::application: return 10;
    case Kind::power: return 30;
    case Kind::opposite: return 35;
    case Kind::product: return 40;
    case Kind::sum: return 50;
    case Kind::relation: return 70;
    case Kind::negation: return 75;
    case Kind::conjunction: return 80;
    case Kind::disjunction: return 85;
    case Kind::implication: return 99;
    default: return 200;
  }
}

std::string written(const RocqTerm& term, int allowed) {
  const std::string text = to_text(term);
  return level_of(term) > allowed ? "(" + text + ")" : text;
}

std::string joined(const RocqTerm& term, const std::string& sign, int first, int others) {
  std::string result;
  for (std::size_t k = 0; k < term.parts.size(); ++k) {
    if (k > 0) result += " " + (sign.empty() ? term.operators[k - 1] : sign) + " ";
    result += written(*term.parts[k], k == 0 ? first : others);
  }
  return result;
}

std::string bound(const RocqTerm& term) {
  std::string result;
  for (const RocqBinder& binder : term.binders)
    result += " (" + binder.name + " : " + binder.type + ")";
  return result;
}

}  // namespace

std::string to_text(const RocqTerm& term) {
  switch (term.kind) {
    case Kind::number: return term.number.str() + (term.natural ? "%nat" : "");
    case Kind::name: return term.name;
    case Kind::application: {
      std::string result = written(*term.parts[0], 0);
      for (std::size_t k = 1; k < term.parts.size(); ++k) result += " " + written(*term.parts[k], 0);
      return result;
    }
    case Kind::function: return "fun" + bound(term) + " => " + to_text(*term.parts[0]);
    case Kind::forall: return "forall" + bound(term) + ", " + to_text(*term.parts[0]);
    case Kind::implication: {
      std::string result;
      for (std::size_t k = 0; k + 1 < term.parts.size(); ++k)
        result += written(*term.parts[k], 98) + " -> ";
      const RocqTerm& last = *term.parts.back();
      return result + written(last, last.kind == Kind::forall ? 200 : 98);
    }
    case Kind::disjunction: return joined(term, "\\/", 84, 84);
    case Kind::conjunction: return joined(term, "/\\", 79, 79);
    case Kind::negation: return "~ " + written(*term.parts[0], 75);
    case Kind::relation: return joined(term, "", 69, 69);
    case Kind::sum: return joined(term, "", 49, 49);
    case Kind::product: return joined(term, "", 39, 39);
    case Kind::opposite: {
      // Without brackets -2 would be a number, not the opposite of one.
      const RocqTerm& part = *term.parts[0];
      return "- " + written(part, part.kind == Kind::number ? -1 : 35);
    }
    case Kind::power: return written(*term.parts[0], 10) + " ^ " + written(*term.parts[1], 30);
  }
  return {};
}

bool is_type(const RocqTerm& term) {
  if (term.kind == Kind::name) return term.name == "R" || term.name == "nat";
  return term.kind == Kind::implication &&
         std::all_of(term.parts.begin(), term.parts.end(),
                     [](const RocqTermPointer& part) { return is_type(*part); });
}

bool same_writing(const RocqTerm& a, const RocqTerm& b) {
  const auto same_binder = [](const RocqBinder& x, const RocqBinder& y) {
    return x.name == y.name && x.type == y.type;
  };
  return a.kind == b.kind && a.number == b.number && a.natural == b.natural && a.name == b.name &&
         a.operators == b.operators &&
         std::equal(a.binders.begin(), a.binders.end(), b.binders.begin(), b.binders.end(),
                    same_binder) &&
         std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const RocqTermPointer& x, const RocqTermPointer& y) {
                      return same_writing(*x, *y);
                    });
}

}  // namespace patchproof
