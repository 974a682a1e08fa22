// Scripts for SymPy: what they look like, and that SymPy agrees.

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include <patchproof/certificate/certificates.hpp>
#include <patchproof/certificate/sympy_helpers.hpp>
#include <patchproof/certificate/sympy_script.hpp>
#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>
#include <tests/cli/program.hpp>
#include <tests/differential/python.hpp>

namespace patchproof::test {

namespace {

struct Script {
  std::string case_name;
  std::string text;
};

std::vector<Script> scripts_of(const SourceText& source) {
  VerificationOptions options;
  options.engines = Engines::kernel;
  std::vector<Script> result;
  const ReadFile file =
      read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
  CHECK(file.diagnostics.empty());
  for (const Case& given : file.cases) {
    std::vector<Certificate> certificates;
    for (const ClaimResult& claim : verified(given, options).claims) {
      auto found = certificate(claim, given.name, given.limits);
      if (auto* one = std::get_if<Certificate>(&found)) certificates.push_back(std::move(*one));
    }
    if (!certificates.empty()) result.push_back({given.name, sympy_script(given, certificates)});
  }
  return result;
}

std::string script_of(const std::string& statements) {
  return scripts_of({"test.proof", "case t\n" + statements + "\nend\n"}).at(0).text;
}

// What is the script's own: below the helpers.
std::string own_part(const std::string& script) {
  const std::size_t helpers = script.find(sympy_helpers());
  REQUIRE(helpers != std::string::npos);
  return script.substr(helpers + sympy_helpers().size());
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t found = text.find(old);
  REQUIRE(found != std::string::npos);
  return text.replace(found, old.size(), now);
}

struct Said {
  int code = -1;
  std::string output;
};

Said said_by_sympy(const std::string& script) {
  const TemporaryFolder folder;
  folder.write("script.py", script);
  const int status =
      std::system((differential::python_with_sympy() + " '" + folder.path("script.py") + "' > '" +
                   folder.path("output") + "' 2>&1")
                      .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.text("output")};
}

const std::string coons_edge = R"(
  param u in [0, 1]
  curve C(t), D(t) : C^1
  assume touching: C(0) == D(0)
  curve m(t) = (1-t)*C(t) + t*D(t)
  prove start: m'(0) == C'(0)
  refute end: m'(1) == D'(1)
  prove parabola: u*(1-u) <= 1/4)";

}  // namespace

TEST_CASE("A script has symbols, definitions and a function for each claim", "[literature]") {
  CHECK(own_part(script_of(coons_edge)) == R"py(

# The symbols of the case.
u = Symbol("u")
C = unknown("C", 1)
D = unknown("D", 1)


# What the case has a name for.
def m(t):
    return (1 - t)*C(t) + t*D(t)


# t.start:
# m'(0) == C'(0)
def claim_start():
    # assumed to be 0, touching:
    assumed_1 = C(0) - D(0)
    yield is_zero(
        derivative(m, 1)(0) - derivative(C, 1)(0)
        + assumed_1
    )


# t.end:
# m'(1) == D'(1)
def claim_end():
    # It is false:
    values = {
        C: (lambda t: 0),
        D: (lambda t: -t**2 + 2*t),
    }
    # assumed, touching:
    yield is_zero(at(C(0) - D(0), values))
    # and yet not what is claimed:
    yield differs(at(derivative(m, 1)(1) - derivative(D, 1)(1), values))


# t.parabola:
# u*(1-u) <= 1/4
def claim_parabola():
    # a sum of parts that are >= 0:
    yield is_zero(
        Rational(1, 4) - u*(1 - u)
        - (u - Rational(1, 2))**2
    )


CLAIMS = {
    "start": claim_start,
    "end": claim_end,
    "parabola": claim_parabola,
}

failed = 0
open_claims = 0
for label, claim in CLAIMS.items():
    unsettled.clear()
    if all(list(claim())):
        print(label + ": holds")
    elif unsettled:
        print(label + ": not settled by SymPy")
        open_claims += 1
    else:
        print(label + ": FAILS")
        failed += 1
sys.exit(1 if failed else 2 if open_claims else 0)
)py");
}

TEST_CASE("SymPy says of each claim whether it holds") {
  const Said said = said_by_sympy(script_of(coons_edge));
  CHECK(said.output == "start: holds\nend: holds\nparabola: holds\n");
  CHECK(said.code == 0);
}

TEST_CASE("SymPy notices a sign that was changed", "[reject]") {
  const std::string script = script_of(coons_edge);
  const Said equation = said_by_sympy(with(script, "C(0) - D(0)", "C(0) + D(0)"));
  CHECK(equation.output == "start: FAILS\nend: holds\nparabola: holds\n");
  CHECK(equation.code == 1);
  const Said inequality = said_by_sympy(with(script, "        - (u - ", "        - (u + "));
  CHECK(inequality.output == "start: holds\nend: holds\nparabola: FAILS\n");
  CHECK(inequality.code == 1);
}

TEST_CASE("SymPy notices values at which nothing is wrong", "[reject]") {
  const std::string script = script_of("  scalar a\n  refute one: a == 1");
  const Said said = said_by_sympy(with(script, "a: 0", "a: 1"));
  CHECK(said.output == "one: FAILS\n");
}

TEST_CASE("Hypotheses are checked at the values of a refutation", "[reject]") {
  const std::string script = script_of("  scalar a\n  assume a == 2\n  refute one: a == 1");
  CHECK(said_by_sympy(script).output == "one: holds\n");
  CHECK(said_by_sympy(with(script, "a: 2", "a: 3")).output == "one: FAILS\n");
}

TEST_CASE("What scalars have no word for is a comment with the reason") {
  const std::string script = own_part(script_of("  scalar a\n  prove sines: sin(a) - sin(a) == 0"));
  CHECK(script.find("# t.sines:\n# sin(a) - sin(a) == 0\n"
                    "# not written: pi, sines, cosines and exponentials\n") != std::string::npos);
  CHECK(script.find("def claim_") == std::string::npos);
}

TEST_CASE("Whole numbers are divided exactly") {
  const std::string script = script_of(R"(
    curve f(t) = t/3
    prove third: 3*f(1) == 1)");
  CHECK(said_by_sympy(script).output == "third: holds\n");
}

TEST_CASE("Words of Python and of the script are no names of symbols") {
  const std::string script = script_of(R"(
    scalar lambda, S, pass
    prove words: lambda*(S + pass) == lambda*S + pass*lambda)");
  CHECK(said_by_sympy(script).output == "words: holds\n");
}

TEST_CASE("Integrals of unknown functions are compared after taking factors out") {
  const std::string script = script_of(R"(
    scalar a
    curve C(t) : C^1
    prove factor: integral(a*t*C(t) + t*C(0), t in [0, 1]) == a*integral(t*C(t), t in [0, 1]) + C(0)/2)");
  CHECK(said_by_sympy(script).output == "factor: holds\n");
}

TEST_CASE("SymPy agrees with the certificates of a sample of the cases") {
  for (const std::string path :
       {"coons/form", "blend/blend", "bounds/heights", "bounds/regular", "hermite/hermite",
        "bilinear/closure", "twist_energy/minimum_degrees", "bspline/elevation", "rational/conics",
        "triangular/bezier", "volume/volume"})
    for (const SourceText& source : case_files(path + ".proof"))
      for (const Script& script : scripts_of(source)) {
        const Said said = said_by_sympy(script.text);
        INFO(script.case_name << ":\n" << said.output);
        CHECK(said.code == 0);
        CHECK(said.output.find(": holds") != std::string::npos);
      }
}

}  // namespace patchproof::test
