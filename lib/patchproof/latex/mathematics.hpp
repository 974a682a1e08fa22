#pragma once

#include <string>
#include <vector>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/latex/words.hpp>

namespace patchproof {

/// What everything that is typeset of a case needs: its names, and the language of the words.
struct Wording {
  LatexNames names;
  Language language = Language::english;

  const std::string& operator()(Word word) const { return patchproof::word(word, language); }
};

/// "=", "\leq", …
std::string relation_text(Relation relation);

/// `left relation right`, as a chain of the style file. Neighbouring statements that share a side,
/// a == b == c, are one chain.
std::string statements_text(const std::vector<Statement>& statements, const Wording& wording);

/// The same without alignment: short statements are one behind the other.
std::string relations_text(const std::vector<Statement>& statements, const Wording& wording);

/// `name = value`, as a chain.
std::string equation_text(const std::string& left, const std::string& right);

/// A chain that was decided, with its reasons.
std::string chain_text(const CheckedChain& chain, const Wording& wording);

/// The same without what is too wide to be read. Of a witness the start and the end are then called
/// the left and the right side, of a difference the start its difference; other rows are left out.
/// "" when nothing is left.
std::string readable_chain_text(const CheckedChain& chain, Passage::Kind kind,
                                const Wording& wording);

/// The values one behind the other in running text, zeros left out: "$u = \tfrac{1}{2}$, …".
std::string values_text(const std::vector<KnownValue>& values, const Wording& wording);

/// The terms one behind the other in running text.
std::string list_text(const std::vector<Term>& terms, const Wording& wording);

/// The name of a symbol with its parameters, in mathematics: "C_{1}(u)".
std::string symbol_text(const Symbol& symbol, const Wording& wording);

}  // namespace patchproof
