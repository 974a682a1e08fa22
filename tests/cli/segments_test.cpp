#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

// A polygon of degree 1 over 0, 1, 2, extruded: a crease at u = 1.
const std::string crease = "0,0\n0,1\n\n1,0\n1,1\n\n0,0\n0,1\n";

Ended segments(const TemporaryFolder& folder, std::vector<std::string> arguments,
               const std::string& input = "") {
  arguments.insert(arguments.begin(), "segments");
  return run_program(folder, arguments, input);
}

}  // namespace

TEST_CASE("segments says what is proved of a net, and ends with 0") {
  const TemporaryFolder folder;
  folder.write("net.csv", crease);
  const Ended ended = segments(folder, {"net.csv", "--degrees", "1"});
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "net.csv: 3 x 2 points in R^2, degrees (1, 1), 2 x 1 segments\n"
        "  every net  PROVED  (C^0 in u, C^0 in v)\n"
        "  segments   PROVED\n"
        "  C^0 in u   PROVED\n"
        "  C^0 in v   PROVED  (there is no seam)\n"
        "\n"
        "4 claims: 4 proved\n");
}

TEST_CASE("segments ends with 1 where a seam is less smooth, and shows the derivatives") {
  const TemporaryFolder folder;
  const Ended ended = segments(folder, {"-", "--degrees", "1,1", "--continuity", "1"}, crease);
  CHECK(ended.code == 1);
  CHECK(ended.output ==
        "<stdin>: 3 x 2 points in R^2, degrees (1, 1), 2 x 1 segments\n"
        "  every net  PROVED  (C^0 in u, C^1 in v)\n"
        "  segments   PROVED\n"
        "! C^1 in u   REFUTED\n"
        "  C^1 in v   PROVED  (there is no seam)\n"
        "\n"
        "C^1 in u: REFUTED: the segments join with C^1 at 1 knot in u, 1 edge\n"
        "       = seam: u = 1, between the segments (0, 0) and (1, 0)\n"
        "       = derivative: of order 1 in u, Bézier coefficient 0 along the seam, coordinate x\n"
        "       = before: 1\n"
        "       = behind: -1\n"
        "       = edges: 1 of 1 edge are not C^1\n"
        "       = knot: 1 occurs once: splines of degree 1 are C^0 there\n"
        "\n"
        "4 claims: 3 proved, 1 refuted\n");
}

TEST_CASE("segments compares with the segments of somebody else") {
  const TemporaryFolder folder;
  folder.write("net.csv", crease);
  for (const std::string name : {"out.csv", "out.json"}) {
    CHECK(segments(folder, {"net.csv", "--degrees", "1", "--output", name}).code == 0);
    CHECK(segments(folder, {"net.csv", "--degrees", "1", "--against", name}).code == 0);
  }
  folder.write("wrong.csv", "0,0\n0,1\n1,0\n1,1\n1,0\n1,1.1\n0,0\n0,1\n");
  const Ended ended = segments(folder, {"net.csv", "--degrees", "1", "--against", "wrong.csv"});
  CHECK(ended.code == 1);
  CHECK(ended.output.find("against: REFUTED: the segments of wrong.csv are these segments\n"
                          "       = segment: (1, 0)\n"
                          "       = point: (0, 1), coordinate y\n"
                          "       = exact: 1\n"
                          "       = found: 11/10\n"
                          "       = points: 1 of 8 points is different\n") != std::string::npos);
}

TEST_CASE("segments reports the same twice, as JSON too") {
  const TemporaryFolder folder;
  folder.write("net.json",
               R"({"degrees": [1, 1], "points": [[[0.1], ["1/3"]], [["0x1p-1"], [2]]]})");
  const Ended first = segments(folder, {"net.json", "--format", "json"});
  CHECK(first.code == 0);
  CHECK(first.output == segments(folder, {"net.json", "--format", "json"}).output);
  const auto document = nlohmann::json::parse(first.output);
  CHECK(document["exit"] == 0);
  CHECK(document["net"]["segments"] == nlohmann::json::array({1, 1}));
  CHECK(document["claims"].size() == 4);
  CHECK(document["claims"][1]["verdict"] == "PROVED");
}

TEST_CASE("segments ends with 4 for what it cannot read, and leaves no file") {
  const TemporaryFolder folder;
  folder.write("net.csv", crease);
  folder.write("bad.csv", std::string(3'000'000, '\n') + "1,2\n1,x\n");
  const Ended missing = segments(folder, {"none.csv"});
  CHECK(missing.code == 4);
  CHECK(missing.errors == "patchproof: cannot read 'none.csv': No such file or directory\n");
  const Ended bad = segments(folder, {"bad.csv", "--output", "out.csv"});
  CHECK(bad.code == 4);
  CHECK(bad.errors ==
        "bad.csv:3000002:3: error: expected a number, found 'x'\n"
        "3000002 | 1,x\n"
        "        |   ^\n"
        "       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like "
        "0x1.8p-3\n");
  CHECK(segments(folder, {"net.csv"}).errors ==
        "net.csv: error: in u: degree 3 needs at least 4 points, and there are 3\n");
  folder.write("short.csv", "0,0\n");
  const Ended cut = segments(
      folder, {"net.csv", "--degrees", "1", "--against", "short.csv", "--output", "out.csv"});
  CHECK(cut.code == 4);
  CHECK(cut.errors ==
        "short.csv:2:1: error: the segments end after 1 point; 8 belong to the net\n"
        "     2 |\n"
        "       | ^\n");
  CHECK_FALSE(std::filesystem::exists(folder.path("out.csv")));
  CHECK(segments(folder, {"net.csv", "--degrees", "1", "--output", "net.csv"}).errors ==
        "patchproof: cannot write 'net.csv': it is one of the files that are read\n");
  CHECK(folder.text("net.csv") == crease);
}

TEST_CASE("segments ends with 64 for what makes no sense") {
  const TemporaryFolder folder;
  folder.write("net.json", R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]],
                               "points": [[[1], [2]], [[3], [4]]]})");
  const auto message = [&](std::vector<std::string> arguments) {
    const Ended ended = segments(folder, std::move(arguments));
    CHECK(ended.code == 64);
    return ended.errors.substr(0, ended.errors.find('\n'));
  };
  const std::string start = "patchproof segments: ";
  CHECK(message({}) == start + "no net: name a file, or '-' for standard input");
  CHECK(message({"-", "--against", "-"}) ==
        start + "standard input cannot be both the net and the segments");
  CHECK(message({"net.json", "--degrees", "2"}) ==
        start + "--degrees: the file of the net gives other degrees");
  CHECK(message({"net.json", "--degrees", "1,2,3"}) ==
        start + "--degrees: one or two whole numbers from 1 to 9, like 3,3");
  CHECK(message({"net.json", "--knots-u", "0,0,1,1"}) ==
        start + "--knots-u: the file of the net gives the knots");
  CHECK(message({"net.json", "--degrees", "x"}) ==
        start + "--degrees: expected a number, found 'x'");
  CHECK(message({"net.json", "--continuity", "-1"}) ==
        start + "--continuity: a whole number from 0 to 9");
}

}  // namespace patchproof
