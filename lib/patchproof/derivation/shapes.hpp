#pragma once

#include <patchproof/term/term.hpp>

/// Small questions about the shape of terms, and small terms, for those who rewrite them.
namespace patchproof {

/// Zero of the type: 0, (0, 0, 0), a matrix of zeros.
Term zero_of(const Type& type);

/// Whether the term is written as zero: 0, or made of zeros.
bool is_zero_term(const Term& term);

bool is_number(const Term& term, const Rational& number);

/// Whether the term is an array of symbols, which has a name but stands for nothing else.
bool is_array(const Term& term);

/// The same value, made of nodes that a name given to the term does not belong to. It has children.
Term without_name(const Term& term);

/// The derivative of a function; of a derivative the one of the orders together.
Term derivative_of(const Term& function, const Indices& orders);

/// The sum of terms of one type; zero for none.
Term sum_of(std::vector<Term> parts, const Type& type);

}  // namespace patchproof
