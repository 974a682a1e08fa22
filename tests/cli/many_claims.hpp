#pragma once

#include <string>

#include "program.hpp"

namespace patchproof {

/// Files with everything a report may speak of: families, derivations and what uses them, shown
/// terms, verdicts of all kinds, mistakes, a name that is used twice, a file that is none.
inline void write_corpus(const TemporaryFolder& folder) {
  std::string many = "case many\n  scalar a, b, x, y\n  point V[0..1]\n";
  many += "  derive half: x from 2*x == a gives a/2\n";
  for (int k = 0; k < 40; ++k) {
    const std::string n = std::to_string(k);
    many += "  prove true_" + n + ": (a + " + n + ")^2 == a^2 + " + std::to_string(2 * k) +
            "*a + " + std::to_string(k * k) + "\n";
    many += "  refute false_" + n + ": a + " + n + " == b\n";
    many += "  prove used_" + n + ": 2*x + " + n + " == a + " + n + " using half\n";
  }
  many += "  prove wrong: a == b\n  show (a + b)^3\n  show (a - b)^2\nend\n";
  many +=
      "case family\n  family n in 0..12\n  scalar a, b\n  prove power: (a*b)^n == a^n*b^n\nend\n";
  folder.write("corpus/a.proof", many);
  folder.write("corpus/b.proof",
               "case shown\n  scalar a\n  show a + a\nend\n"
               "case family\n  scalar a\n  prove other: a == a\nend\n");
  folder.write("corpus/c.proof",
               "case broken\n  scalar a\n  prove one: a ==\nend\n"
               "case quotient\n  scalar a, b\n  prove one: (a^2 - b^2)/(a - b) == a + b\nend\n");
}

}  // namespace patchproof
