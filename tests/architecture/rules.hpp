#pragma once

#include <string>
#include <vector>

#include <tests/architecture/source_tree.hpp>

namespace patchproof::architecture {

using Tree = std::vector<SourceFile>;

/// The places where a tree breaks a rule, each as "path:line: what is wrong" ("path: …" when no
/// line is to blame); empty when the tree keeps it.
using Breaches = std::vector<std::string>;

/// Includes in lib/ go down the layers and never up:
/// algebra < term < kernel, symbolic < decide < claims < certificate, language < repair < mutation <
/// derivation < figure < latex < report < patchproof.hpp, where kernel and symbolic, certificate and
/// language, repair and figure do not know each other. They are written <patchproof/layer/file.hpp>.
Breaches upward_includes(const Tree& tree);

/// Each foreign library has one door, so that it can be judged and replaced in one place:
/// GiNaC and CLN only in symbolic, Boost.Multiprecision only through algebra/number.hpp, the JSON
/// library only in language/dump, report, certificate/term_table and the program, CLI11 only in the
/// program; in recheck/, numbers only through number.hpp and JSON only through place.hpp.
Breaches libraries_outside_their_door(const Tree& tree);

/// The second checker in recheck/ is independent: it includes nothing of the library, of the program
/// or of the tests.
Breaches dependence_of_the_second_checker(const Tree& tree);

/// No floating point in lib/ and recheck/: neither its types nor its literals.
Breaches floating_point(const Tree& tree);

/// Every folder in lib/patchproof is a layer, the generated prelude's, or unknown.
Breaches unknown_folders(const Tree& tree);

/// Every header starts by `#pragma once`.
Breaches headers_without_pragma_once(const Tree& tree);

/// No header says `using namespace`.
Breaches using_namespace_in_headers(const Tree& tree);

/// A C++ file has fewer than 300 lines: one idea. Files of tests have fewer than 400.
Breaches long_files(const Tree& tree);

/// No file names a folder of one person's machine.
Breaches paths_of_one_machine(const Tree& tree);

}  // namespace patchproof::architecture
