#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace recheck {

/// How much may be read and worked out before the answer is "UNKNOWN (limit: ...)", or before a
/// text is refused.
struct Limits {
  std::size_t bytes = 64'000'000;   ///< of a text
  std::size_t nesting = 300;        ///< brackets within brackets in a text
  std::size_t nodes = 200'000;      ///< of one certificate
  std::size_t symbols = 20'000;     ///< of one certificate
  std::size_t extent = 10'000;      ///< entries of a matrix, coordinates, arguments
  std::size_t order = 200;          ///< degrees of basis functions, orders of derivatives
  std::size_t exponent = 10'000;    ///< of a power
  std::size_t terms = 200'000;      ///< of a polynomial
  std::size_t kept = 5'000'000;     ///< terms of all polynomials that are kept
  std::size_t atoms = 100'000;      ///< symbols, jets and roots together
  std::size_t depth = 30;           ///< functions at values of functions, cases within cases
  std::size_t steps = 100'000'000;  ///< products of words of numbers, roughly
};

/// Thrown when more than a limit would be needed; says which.
class LimitReached : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Why a certificate is not rechecked, and at which place of it: `proofs[0].components[1]`.
class Objection : public std::runtime_error {
 public:
  explicit Objection(const std::string& reason, const std::string& place = "")
      : std::runtime_error{place.empty() ? reason : place + ": " + reason},
        reason_{reason},
        place_{place} {}

  const std::string& reason() const { return reason_; }
  /// The place, as seen from an outer one.
  std::string place_in(const std::string& outer) const {
    return place_.empty() ? outer : outer + "." + place_;
  }

 private:
  std::string reason_;
  std::string place_;
};

/// Thrown by what version 1 of the checker cannot judge.
class Unsupported : public Objection {
 public:
  using Objection::Objection;
};

/// Thrown where a certificate shows to be wrong, or not to show what it should.
class Rejection : public Objection {
 public:
  using Objection::Objection;
};

/// Calls the function; what it objects to is said to be at that place.
template <typename Function>
void at_place(const std::string& place, const Function& function) {
  try {
    function();
  } catch (const Rejection& error) {
    throw Rejection{error.reason(), error.place_in(place)};
  } catch (const Unsupported& error) {
    throw Unsupported{error.reason(), error.place_in(place)};
  }
}

/// Counts what is spent of the limits while one certificate is judged.
class Meter {
 public:
  explicit Meter(const Limits& limits) : limits_{limits} {}

  const Limits& limits() const { return limits_; }

  /// @throws LimitReached
  void spend(std::size_t steps) {
    spent_ += steps;
    if (spent_ > limits_.steps) throw LimitReached{"steps"};
  }
  /// Counts terms that stay in memory. @throws LimitReached
  void keep(std::size_t terms) {
    kept_ += terms;
    if (kept_ > limits_.kept) throw LimitReached{"terms"};
  }
  /// @throws LimitReached
  static void require(std::size_t amount, std::size_t limit, const char* what) {
    if (amount > limit) throw LimitReached{what};
  }

 private:
  Limits limits_;
  std::size_t spent_ = 0;
  std::size_t kept_ = 0;
};

}  // namespace recheck
