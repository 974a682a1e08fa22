#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace recheck {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

/// The number written as "2", "-1/3": in lowest terms, without zeros in front; empty for any other
/// text, and for more than 10000 characters.
std::optional<Rational> number_of(std::string_view text);

std::string to_text(const Rational& number);

/// How many words of the machine numerator and denominator need beyond one for each.
std::size_t extra_words(const Rational& number);

/// The largest whole number whose square is at most the given one, which is not negative.
Integer floor_of_root(const Integer& number);

}  // namespace recheck
