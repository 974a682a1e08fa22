#include <catch2/catch.hpp>
#include <cstdlib>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string text =
    "case first\n"
    "  param u, v in [0, 1]\n"
    "  point V[0..1, 0..1]\n"
    "  patch surface(u, v) = bezier(V)\n"
    "  patch high(u, v) = (u, v, u*v, u)\n"
    "  prove same: surface(0,0) == V[0,0]\n"
    "  refute sum: surface(0,0) + surface(1,1) == V[0,0]\n"
    "  refute above: surface(u,v) == V[0,0]\n"
    "end\n";

Ended draw(const TemporaryFolder& folder, std::vector<std::string> words) {
  folder.write("case.proof", text);
  words.insert(words.begin(), {"draw", "case.proof"});
  return run_program(folder, words);
}

std::string complaint(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const Ended ended = draw(folder, std::move(words));
  CHECK(ended.code == 64);
  CHECK(ended.output == "");
  return ended.errors;
}

}  // namespace

TEST_CASE("draw writes SVG, TikZ and PNG by the ending of the file, and ends with 0") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.svg", "a.tikz", "a.tex", "a.png"}) {
    const Ended ended = draw(folder, {"surface", "-o", name});
    INFO(name << ended.errors);
    if (name == "a.png" && ended.errors.find("no program rsvg-convert") != std::string::npos)
      continue;
    CHECK(ended.code == 0);
    CHECK(ended.output + ended.errors == "");
  }
  CHECK(folder.text("a.svg").rfind("<svg xmlns=", 0) == 0);
  CHECK(folder.text("a.tikz").rfind("% example values: V\n\\begin{tikzpicture}[", 0) == 0);
  CHECK(folder.text("a.tikz") == folder.text("a.tex"));
  const std::string png = folder.text("a.png");
  CHECK((png.empty() || png.substr(1, 3) == "PNG"));
}

TEST_CASE("[reject] without the program for PNG it is said what to install") {
  const TemporaryFolder folder;
  folder.write("a.png", "as it was");
  const char* const before = std::getenv("PATH");
  const std::string path = before == nullptr ? "" : before;
  ::setenv("PATH", folder.path("").c_str(), 1);
  const Ended ended = draw(folder, {"surface", "-o", "a.png"});
  ::setenv("PATH", path.c_str(), 1);
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "patchproof: cannot write 'a.png': there is no program rsvg-convert\n"
        "  = help: install the package librsvg2-bin, or write *.svg\n");
  CHECK(folder.text("a.png") == "as it was");
}

TEST_CASE("the label of a refuted equation draws how far it is off") {
  const TemporaryFolder folder;
  CHECK(draw(folder, {"above", "-o", "a.svg"}).code == 0);
  CHECK(folder.text("a.svg").find("<line class=\"deviation\"") != std::string::npos);
}

TEST_CASE("[reject] what cannot be drawn is said, with 64") {
  CHECK(complaint({"surfaec", "-o", "a.svg"}) ==
        "patchproof draw: there is nothing called 'surfaec' in case 'first'\n"
        "  = help: did you mean 'surface'?\n");
  CHECK(complaint({"V", "-o", "a.svg"}) ==
        "patchproof draw: 'V' is a 2 x 2 matrix of points, which is not drawn\n"
        "  = help: curves, patches and scalar functions of one or two parameters are\n");
  CHECK(complaint({"high", "-o", "a.svg"}) ==
        "patchproof draw: 'high' lies in R^4, which is not drawn\n"
        "  = help: figures are of R^1, R^2 and R^3\n");
  CHECK(complaint({"same", "-o", "a.svg"}) ==
        "patchproof draw: claim 'same' is not refuted: there is no deviation to be drawn\n");
  CHECK(complaint({"sum", "-o", "a.svg"}) ==
        "patchproof draw: claim 'sum' does not compare curves, patches or functions of one or two "
        "parameters\n");
}

TEST_CASE("[reject] what has no value is not drawn") {
  const TemporaryFolder folder;
  folder.write("case.proof",
               "case a\n  param u, v, w, t in [0, 1]\n"
               "  volume F(u, v, w) = (u, v, w)\n"
               "  patch zero(u, v) = (u, v, 1/(u-u))\n"
               "  patch pole(u, v) = (u, v, 1/(2*u-1))\n"
               "  patch root(u, v) = (u, v, sqrt(u-v))\n"
               "  patch moving(u, v) = (u, v, t)\nend\n");
  const auto complaint_about = [&](const std::string& name) {
    const Ended ended = run_program(folder, {"draw", "case.proof", name, "-o", "a.svg"});
    CHECK(ended.code == 64);
    return ended.errors;
  };
  CHECK(complaint_about("F") ==
        "patchproof draw: 'F' is a volume(u, v, w), which is not drawn\n"
        "  = help: curves, patches and scalar functions of one or two parameters are\n");
  CHECK(complaint_about("zero") == "patchproof draw: cannot draw 'zero': division by zero\n");
  const std::string some = "it has no value at some of its places\n";
  CHECK(complaint_about("pole") == "patchproof draw: cannot draw 'pole': " + some);
  CHECK(complaint_about("root") == "patchproof draw: cannot draw 'root': " + some);
  CHECK(complaint_about("moving") ==
        "patchproof draw: cannot draw 'moving': nothing is known of t\n");
}

TEST_CASE("[reject] two sides that agree in the example have no deviation to be drawn") {
  const TemporaryFolder folder;
  folder.write("case.proof",
               "case a\n  param u in [0, 1]\n  scalar a\n"
               "  refute line: (u, a*(2*a-1)) == (u, 0)\nend\n");
  const Ended ended = run_program(folder, {"draw", "case.proof", "line", "-o", "a.svg"});
  CHECK(ended.code == 64);
  CHECK(ended.errors ==
        "patchproof draw: the two sides agree in the example that would be drawn\n"
        "  = help: give the case numbers for which they differ\n");
}

TEST_CASE("[reject] a file of another kind, and angles and sizes that are none") {
  const std::string help = "  = help: 'patchproof draw --help' shows what can be said\n";
  CHECK(complaint({"surface", "-o", "a.pdf"}) ==
        "patchproof draw: 'a.pdf' has to end in .svg, .png, .tex or .tikz\n" + help);
  CHECK(complaint({"surface", "-o", "a.svg", "--view", "10"}) ==
        "patchproof draw: --view: '10' is not two angles in whole degrees, like 32,30\n" + help);
  CHECK(complaint({"surface", "-o", "a.svg", "--view", "10,95"}) ==
        "patchproof draw: --view: '10,95' is not two angles in whole degrees, like 32,30\n" + help);
  CHECK(complaint({"surface", "-o", "a.svg", "--size", "9"}) ==
        "patchproof draw: --size: from 10 to 1000 millimetres can be drawn\n" + help);
}

TEST_CASE("[reject] one case of a file has to be named, and has to be there") {
  const TemporaryFolder folder;
  folder.write("two.proof", text + "case second\n  scalar a\nend\n");
  const Ended many = run_program(folder, {"draw", "two.proof", "surface", "-o", "a.svg"});
  CHECK(many.code == 64);
  CHECK(many.errors ==
        "patchproof draw: there are 2 cases in 'two.proof': name one with --case\n"
        "  = help: one of first, second\n");
  const Ended none =
      run_program(folder, {"draw", "two.proof", "surface", "-o", "a.svg", "--case", "fist"});
  CHECK(none.code == 64);
  CHECK(none.errors ==
        "patchproof draw: there is no case 'fist' in 'two.proof'\n"
        "  = help: did you mean 'first'?\n");
  CHECK(run_program(folder, {"draw", "two.proof", "surface", "-o", "a.svg", "--case", "first"})
            .code == 0);
}

TEST_CASE("[reject] assumptions without an example, and a missing or faulty case") {
  const TemporaryFolder folder;
  folder.write("none.proof",
               "case none\n  scalar a\n  param u in [0, 1]\n  assume no: a^2 == -1\n"
               "  curve C(u) = (a, u)\n  prove C: C(0).x == a\nend\n");
  const Ended none = run_program(folder, {"draw", "none.proof", "C", "-o", "a.svg"});
  CHECK(none.code == 64);
  CHECK(none.errors ==
        "patchproof draw: no example was found that satisfies the assumptions of case 'none'\n");
  const Ended missing = run_program(folder, {"draw", "gone.proof", "C", "-o", "a.svg"});
  CHECK(missing.code == 4);
  CHECK(missing.errors == "patchproof: cannot read 'gone.proof': No such file or directory\n");
  folder.write("bad.proof", "case bad\n  scalar\nend\n");
  CHECK(run_program(folder, {"draw", "bad.proof", "C", "-o", "a.svg"}).code == 4);
}

TEST_CASE("[reject] a file that cannot be written ends with 4 and is left as it is") {
  const TemporaryFolder folder;
  for (const std::string ending : {".svg", ".png"}) {
    const Ended ended = draw(folder, {"surface", "-o", "no/folder" + ending});
    CHECK(ended.code == 4);
    CHECK(ended.errors ==
          "patchproof: cannot write 'no/folder" + ending + "': No such file or directory\n");
  }
  folder.write("case.svg", text);
  const Ended same = run_program(folder, {"draw", "case.svg", "surface", "-o", "case.svg"});
  CHECK(same.code == 4);
  CHECK(same.errors == "patchproof: cannot write 'case.svg': it is one of the case files\n");
  CHECK(folder.text("case.svg") == text);
}

}  // namespace patchproof
