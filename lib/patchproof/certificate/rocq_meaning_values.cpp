#include <patchproof/certificate/rocq_meaning.hpp>

#include <string_view>

#include <patchproof/certificate/rocq_tokens.hpp>

namespace patchproof {

namespace {

using Kind = RocqTerm::Kind;

bool is_derivative(const std::string& name) {
  return name == "Derive" || name == "D_u" || name == "D_v" || name == "D_1" || name == "D_2" ||
         name == "D_3";
}

}  // namespace

std::size_t RocqMeaning::operation(const RocqTerm& term, const Scope* scope, std::size_t depth) {
  switch (term.kind) {
    case Kind::number:
      if (term.natural) throw RocqUnreadable{"a natural number in the place of a real one"};
      return table_.number_of(term.number.str());
    case Kind::sum:
    case Kind::product: {
      std::size_t result = value(*term.parts[0], scope, depth);
      for (std::size_t k = 1; k < term.parts.size(); ++k)
        result = table_.number_of(term.operators[k - 1],
                                  {result, value(*term.parts[k], scope, depth)});
      return result;
    }
    case Kind::opposite:
      return table_.number_of("opposite", {value(*term.parts[0], scope, depth)});
    case Kind::power:
      return table_.number_of("^ " + natural({term.parts[1].get(), scope}, false),
                              {value(*term.parts[0], scope, depth)});
    default: throw RocqUnreadable{"a proposition in the place of a value"};
  }
}

std::size_t RocqMeaning::applied_to_rest(std::size_t function,
                                         const std::vector<Argument>& arguments, std::size_t first,
                                         std::size_t depth) {
  if (first >= arguments.size()) return function;
  std::vector<std::size_t> parts{function};
  for (std::size_t k = first; k < arguments.size(); ++k)
    parts.push_back(value(*arguments[k].term, arguments[k].scope, depth));
  return table_.number_of("apply", std::move(parts));
}

// The natural numbers among the arguments are indices.
std::size_t RocqMeaning::variable(const Scope& of, const std::vector<Argument>& arguments,
                                  std::size_t depth) {
  constexpr std::string_view index = "nat -> ";
  std::string head = "#" + std::to_string(of.level);
  std::size_t indices = 0;
  for (std::string_view type = of.type; type.starts_with(index); type.remove_prefix(index.size())) {
    if (indices == arguments.size()) throw RocqUnreadable{"an array without its indices"};
    head += " " + natural(arguments[indices++], true);
  }
  if (of.type == "nat") throw RocqUnreadable{"a natural number in the place of a real one"};
  return applied_to_rest(table_.number_of(head), arguments, indices, depth);
}

// Of the library; the definitions of the case hide its words.
std::size_t RocqMeaning::word(const std::string& name, const std::vector<Argument>& arguments,
                              std::size_t depth) {
  const auto argument = [&](std::size_t k) {
    return value(*arguments[k].term, arguments[k].scope, depth);
  };
  const auto expect = [&](bool good) {
    if (!good) throw RocqUnreadable{"'" + name + "' has another number of arguments"};
  };
  if (name == "Bern") {
    expect(arguments.size() == 3);
    const std::string head = "Bern " + natural(arguments[0], false) + " " +
                             natural(arguments[1], false);
    return table_.number_of(head, {argument(2)});
  }
  if (name == "sqrt") {
    expect(arguments.size() == 1);
    return table_.number_of(name, {argument(0)});
  }
  if (name == "RInt") {
    expect(arguments.size() == 3);
    return table_.number_of(name, {argument(0), argument(1), argument(2)});
  }
  if (is_derivative(name)) {
    expect(!arguments.empty());
    return applied_to_rest(table_.number_of(name, {argument(0)}), arguments, 1, depth);
  }
  throw RocqUnreadable{"the name '" + name.substr(0, 40) + "' is not known"};
}

}  // namespace patchproof
