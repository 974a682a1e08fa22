#include <tests/architecture/rules.hpp>

#include <catch2/catch.hpp>

using namespace patchproof::architecture;

namespace {

const Tree& project() {
  static const Tree tree = project_files(PATCHPROOF_SOURCE_FOLDER);
  return tree;
}

/// A tree of one file with this text.
Tree tree_of(const std::string& path, const std::string& text) { return {{path, text}}; }

const std::string algebra = "lib/patchproof/algebra/number.hpp";
const std::string term = "lib/patchproof/term/term.cpp";

}  // namespace

TEST_CASE("The rules are tried on the project itself", "[architecture]") {
  const auto has = [](const std::string& path) {
    for (const SourceFile& file : project()) {
      if (file.path == path) return true;
    }
    return false;
  };
  CHECK(has("CMakeLists.txt"));
  CHECK(has("lib/patchproof/algebra/number.hpp"));
  CHECK(has("verify/main.cpp"));
  CHECK(has("tests/architecture/rules_test.cpp"));
}

TEST_CASE("Includes go down the layers", "[architecture]") {
  CHECK(upward_includes(project()) == Breaches{});
}

TEST_CASE("An include of a higher layer is found", "[architecture][reject]") {
  CHECK(upward_includes(tree_of(algebra, "#pragma once\n#include <patchproof/term/type.hpp>\n")) ==
        Breaches{"lib/patchproof/algebra/number.hpp:2: algebra may not include "
                 "<patchproof/term/type.hpp>"});
  CHECK(upward_includes(tree_of(term, "  #  include <patchproof/patchproof.hpp>")).size() == 1);
  CHECK(upward_includes(tree_of("lib/patchproof/patchproof.cpp",
                                "#include <patchproof/patchproof.hpp>\n"
                                "#include <patchproof/report/report.hpp>\n")) == Breaches{});
}

TEST_CASE("The two engines may not include each other", "[architecture][reject]") {
  CHECK(upward_includes(tree_of("lib/patchproof/kernel/field.cpp",
                                "#include <patchproof/symbolic/second_opinion.hpp>")) ==
        Breaches{"lib/patchproof/kernel/field.cpp:1: kernel may not include "
                 "<patchproof/symbolic/second_opinion.hpp>"});
  CHECK(upward_includes(tree_of("lib/patchproof/symbolic/second_opinion.cpp",
                                "#include <patchproof/kernel/field.hpp>"))
            .size() == 1);
}

TEST_CASE("An include that hides its layer is found", "[architecture][reject]") {
  CHECK(
      upward_includes(tree_of(term, "#include \"../report/report.hpp\"")) ==
      Breaches{"lib/patchproof/term/term.cpp:1: write #include <patchproof/...>, without quotes"});
  CHECK(upward_includes(tree_of(term, "#include <patchproof/misc/report.hpp>")) ==
        Breaches{"lib/patchproof/term/term.cpp:1: <patchproof/misc/report.hpp> is in no known "
                 "layer"});
}

TEST_CASE("An include in a comment is none", "[architecture]") {
  CHECK(upward_includes(tree_of(algebra,
                                "// #include <patchproof/term/type.hpp>\n"
                                "/* \n#include <patchproof/term/type.hpp>\n*/")) == Breaches{});
}

TEST_CASE("Foreign libraries have one door each", "[architecture]") {
  CHECK(libraries_outside_their_door(project()) == Breaches{});
}

TEST_CASE("A foreign library outside its door is found", "[architecture][reject]") {
  const auto breaches = [](const std::string& path, const std::string& header) {
    return libraries_outside_their_door(tree_of(path, "#include " + header)).size();
  };
  CHECK(libraries_outside_their_door(tree_of(algebra, "#include <cln/cln.h>")) ==
        Breaches{"lib/patchproof/algebra/number.hpp:1: <cln/cln.h> may not be included here"});
  CHECK(breaches("lib/patchproof/kernel/field.cpp", "<ginac/ginac.h>") == 1);
  CHECK(breaches("verify/main.cpp", "<ginac/ginac.h>") == 1);
  CHECK(breaches("lib/patchproof/symbolic/engine.cpp", "<ginac/ginac.h>") == 0);
  CHECK(breaches("lib/patchproof/algebra/power.cpp", "<boost/multiprecision/cpp_int.hpp>") == 1);
  CHECK(breaches("lib/patchproof/algebra/rational.hpp", "<boost/multiprecision/cpp_int.hpp>") == 0);
  CHECK(breaches("lib/patchproof/language/parser.cpp", "<nlohmann/json.hpp>") == 1);
  CHECK(breaches("lib/patchproof/language/dump.cpp", "<nlohmann/json.hpp>") == 0);
  CHECK(breaches("lib/patchproof/report/json.cpp", "<CLI/CLI.hpp>") == 1);
  CHECK(breaches("verify/main.cpp", "<CLI/CLI.hpp>") == 0);
  CHECK(breaches("recheck/number.hpp", "<boost/multiprecision/cpp_int.hpp>") == 0);
  CHECK(breaches("recheck/field.cpp", "<boost/multiprecision/cpp_int.hpp>") == 1);
  CHECK(breaches("recheck/node_reader.cpp", "<nlohmann/json.hpp>") == 1);
  CHECK(breaches("lib/patchproof/kernel/field.cpp", "<gmpxx.h>") == 1);
}

TEST_CASE("The second checker knows nothing of what it checks", "[architecture]") {
  CHECK(dependence_of_the_second_checker(project()) == Breaches{});
  const bool is_there = std::any_of(project().begin(), project().end(), [](const SourceFile& file) {
    return file.path == "recheck/recheck.cpp";
  });
  CHECK(is_there);
}

TEST_CASE("A second checker that is not independent is found", "[architecture][reject]") {
  const auto breaches = [](const std::string& header) {
    return dependence_of_the_second_checker(
        tree_of("recheck/field.cpp", "#include <map>\n#include " + header));
  };
  CHECK(breaches("<patchproof/term/term.hpp>") ==
        Breaches{"recheck/field.cpp:2: the second checker may not include "
                 "<patchproof/term/term.hpp>"});
  CHECK(breaches("<verify/files.hpp>").size() == 1);
  CHECK(breaches("\"../lib/patchproof/term/term.hpp\"").size() == 1);
  CHECK(breaches("<recheck/field.hpp>") == Breaches{});
}

TEST_CASE("There is no floating point in the library", "[architecture]") {
  CHECK(floating_point(project()) == Breaches{});
}

TEST_CASE("Floating point is found by type, by literal and by function", "[architecture][reject]") {
  CHECK(floating_point(tree_of(term, "int a;\nlong double x;")) ==
        Breaches{"lib/patchproof/term/term.cpp:2: floating point 'double'"});
  const std::string line = GENERATE(
      "float x;", "std::vector<double> x;", "auto x = 0.5;", "auto x = 1.;", "auto x = .5;",
      "auto x = 1e9;", "auto x = 1'000.5;", "f(2.0f)", "x = stod(text);", "auto x = 2E-3;");
  CAPTURE(line);
  CHECK(floating_point(tree_of(term, line)).size() == 1);
}

TEST_CASE("What only looks like floating point is none", "[architecture]") {
  const std::string line = GENERATE("// a double", "f(\"1.5 float\")", "int double_knot = 10'000;",
                                    "v[0].size()", "a1.e5()", "case '.':", "0xe5", "f(R\"(0.5)\")",
                                    "/* 1e9 */", "f(xs...)", "x = '\\''; // 0.5");
  CAPTURE(line);
  CHECK(floating_point(tree_of(term, line)) == Breaches{});
}

TEST_CASE("Every folder of the library is a layer", "[architecture]") {
  CHECK(unknown_folders(project()) == Breaches{});
}

TEST_CASE("A folder that is no layer is found", "[architecture][reject]") {
  CHECK(unknown_folders(tree_of("lib/patchproof/helpers/text.hpp", "")) ==
        Breaches{"lib/patchproof/helpers/text.hpp: 'helpers' is no known layer"});
  CHECK(unknown_folders(tree_of("lib/patchproof/text.hpp", "")).size() == 1);
  CHECK(unknown_folders(tree_of("lib/other/text.hpp", "")) ==
        Breaches{"lib/other/text.hpp: outside lib/patchproof"});
  CHECK(unknown_folders(tree_of("lib/patchproof/prelude/coons.cpp", "")).size() == 1);
  CHECK(unknown_folders(tree_of("lib/patchproof/prelude/coons.proof", "")) == Breaches{});
}

TEST_CASE("Headers can be included twice", "[architecture]") {
  CHECK(headers_without_pragma_once(project()) == Breaches{});
}

TEST_CASE("A header without #pragma once is found", "[architecture][reject]") {
  CHECK(headers_without_pragma_once(tree_of(algebra, "// #pragma once\n#include <vector>\n")) ==
        Breaches{"lib/patchproof/algebra/number.hpp: does not start with #pragma once"});
  CHECK(headers_without_pragma_once(tree_of(algebra, "")).size() == 1);
  CHECK(headers_without_pragma_once(tree_of(algebra, "// Why.\n\n#pragma once\n")) == Breaches{});
}

TEST_CASE("Headers open no namespace to their readers", "[architecture]") {
  CHECK(using_namespace_in_headers(project()) == Breaches{});
}

TEST_CASE("A header that opens a namespace is found", "[architecture][reject]") {
  CHECK(using_namespace_in_headers(tree_of(algebra, "\nusing  namespace std;")) ==
        Breaches{"lib/patchproof/algebra/number.hpp:2: in a header: 'using  namespace'"});
  CHECK(using_namespace_in_headers(tree_of(term, "using namespace std;")) == Breaches{});
}

TEST_CASE("Files are short", "[architecture]") { CHECK(long_files(project()) == Breaches{}); }

TEST_CASE("A file of 300 lines is found", "[architecture][reject]") {
  CHECK(long_files(tree_of(term, std::string(300, '\n'))) ==
        Breaches{"lib/patchproof/term/term.cpp: 300 lines"});
  CHECK(long_files(tree_of(term, std::string(299, '\n'))) == Breaches{});
  CHECK(long_files(tree_of("tests/term/term_test.cpp", std::string(399, '\n'))) == Breaches{});
  CHECK(long_files(tree_of("tests/term/term_test.cpp", std::string(400, '\n'))) ==
        Breaches{"tests/term/term_test.cpp: 400 lines"});
  CHECK(long_files(tree_of("docs/long.md", std::string(300, '\n'))) == Breaches{});
}

TEST_CASE("No file depends on one machine", "[architecture]") {
  CHECK(paths_of_one_machine(project()) == Breaches{});
}

TEST_CASE("A path of one machine is found", "[architecture][reject]") {
  const std::string path = std::string{"/ho"} + "me/";
  CHECK(paths_of_one_machine(tree_of("docs/start.md", "cd\ncd " + path + "me\n")) ==
        Breaches{"docs/start.md:2: a path of one machine: '" + path + "'"});
}
