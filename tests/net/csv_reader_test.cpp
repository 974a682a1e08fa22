#include <catch2/catch.hpp>

#include <patchproof/net/net_writer.hpp>
#include <tests/net/net_messages.hpp>

using namespace patchproof;

namespace {

std::string csv(const std::string& text) { return net_message("a.csv", text); }

PointNet net_of(const std::string& text) { return net_from_csv(whole_text(text)); }

}  // namespace

TEST_CASE("Empty lines end the rows of a net", "[net]") {
  const PointNet net =
      net_of("# a comment\n\n1, 2\n3,4 # another\n# inside of a row\n5,6\n\n\n7,8\n9,10\n11,12");
  CHECK(net.rows == 2);
  CHECK(net.columns == 3);
  CHECK(net.dimension == 2);
  CHECK(net_as_csv(net) == "1,2\n3,4\n5,6\n\n7,8\n9,10\n11,12\n\n");
}

TEST_CASE("A heading gives the shape, and the names of the coordinates may stand above", "[net]") {
  const std::string text = "net 2 x 2\nx;y;z\n1;2;3\n\n4;5;6\n7;8;9\n0;0;0\n";
  CHECK(net_as_csv(net_of(text)) == "1,2,3\n4,5,6\n\n7,8,9\n0,0,0\n\n");
  CHECK(net_as_csv(net_of("X,Y\r\n1,2\r\n\r\n3,4\r\n")) == "1,2\n\n3,4\n\n");
}

TEST_CASE("Coordinates are separated by commas, semicolons or blanks", "[net]") {
  for (const std::string text : {"1,2,3\n", "1 ; 2;3\n", "1\t2\t3", "  1 2   3  \n",
                                 "\xEF\xBB\xBF"
                                 "1,2,3\n"})
    CHECK(net_as_csv(net_of(text)) == "1,2,3\n\n");
}

TEST_CASE("The mark of UTF-8 is no part of the text, wherever blocks end", "[net]") {
  for (const std::size_t block : {1U, 2U, 3U, 4U, 9U}) {
    CHECK(net_message("a.csv",
                      "\xEF\xBB\xBF"
                      "1,2\n",
                      {}, block) == "");
    CHECK(net_message("a.csv",
                      "\xEF\xBB"
                      "1,2\n",
                      {}, block) == net_message("a.csv",
                                                "\xEF\xBB"
                                                "1,2\n",
                                                {}, 100));
  }
}

TEST_CASE("What is no net is refused where it stops being one", "[net][reject]") {
  CHECK(csv("1,2\n1,x\n") == R"(a.csv:2:3: error: expected a number, found 'x'
     2 | 1,x
       |   ^
       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3
)");
  CHECK(csv("1,2\n\n1,2\n1,3\n") ==
        R"(a.csv:4:1: error: row 2 has more points than the 1 of the rows before
     4 | 1,3
       | ^^^
)");
  CHECK(csv("1,2\n1,2\n\n1,2\n\n1,3\n") ==
        R"(a.csv:5:1: error: row 2 has 1 point; the rows before have 2
     5 |
       | ^
)");
  CHECK(csv("0,5;1\n") == R"(a.csv:1:4: error: ';' between coordinates, and before it ','
     1 | 0,5;1
       |    ^
       = help: one separator for the whole text; decimals are written with a point
)");
  CHECK(csv("1,2\n0,5 1,5\n") == R"(a.csv:2:4: error: a blank between coordinates, and before it ','
     2 | 0,5 1,5
       |    ^
       = help: one separator for the whole text; decimals are written with a point
)");
  CHECK(csv("1,,2\n") == R"(a.csv:1:3: error: a coordinate is missing here
     1 | 1,,2
       |   ^
       = help: between separators, and behind the last one, stands a number
)");
  CHECK(csv("1,2,\n") == R"(a.csv:1:5: error: a coordinate is missing here
     1 | 1,2,
       |     ^
       = help: between separators, and behind the last one, stands a number
)");
  CHECK(csv("1,2\n1,2,3\n") ==
        R"(a.csv:2:1: error: a point with 3 coordinates; the points before have 2
     2 | 1,2,3
       | ^^^^^
)");
  CHECK(csv("1,2,3,4,5\n") == R"(a.csv:1:9: error: a point with more than 4 coordinates
     1 | 1,2,3,4,5
       |         ^
)");
  CHECK(csv("1, nan\n") == R"(a.csv:1:4: error: 'nan' is not a point of any patch
     1 | 1, nan
       |    ^^^
       = help: nets have finite, exact coordinates
)");
  CHECK(csv("\"1\",2\n") == R"(a.csv:1:1: error: expected a number, found '"1"'
     1 | "1",2
       | ^^^
       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3
)");
  CHECK(csv("") == "a.csv:1:1: error: there are no points\n     1 |\n       | ^\n");
  CHECK(csv("# nothing\n") == "a.csv:2:1: error: there are no points\n     2 |\n       | ^\n");
}

TEST_CASE("Headings that do not fit are refused", "[net][reject]") {
  CHECK(csv("net 2 x 2\n1\n2\n3\n") == R"(a.csv:1:1: error: 2 x 2 are 4 points, and there are 3
     1 | net 2 x 2
       | ^^^^^^^^^
)");
  CHECK(csv("net 0 x 2\n") == R"(a.csv:1:5: error: expected a shape like 'net 4 x 7'
     1 | net 0 x 2
       |     ^
       = help: whole numbers from 1 to 1000000
)");
  CHECK(csv("net 2 x\n1\n") == R"(a.csv:1:8: error: expected a shape like 'net 4 x 7'
     1 | net 2 x
       |        ^
       = help: whole numbers from 1 to 1000000
)");
  CHECK(csv("net 1000000 x 1000000\n1\n") == R"(a.csv:1:1: error: more than 4000000 points
     1 | net 1000000 x 1000000
       | ^^^^^^^^^^^^^^^^^^^^^
)");
  CHECK(csv("y,x\n1,2\n") == R"(a.csv:1:1: error: expected a number, found 'y'
     1 | y,x
       | ^
       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3
)");
  CHECK(csv("x,z\n1,2\n") == R"(a.csv:1:3: error: expected the names x, y, z, w in this order
     1 | x,z
       |   ^
       = help: the coordinates of a point stand in this order
)");
  CHECK(csv("1,2\nx,y\n") == R"(a.csv:2:1: error: expected a number, found 'x'
     2 | x,y
       | ^
       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3
)");
}

TEST_CASE("A reader takes no more than it was told", "[net][reject]") {
  NetLimits limits;
  limits.points = 2;
  limits.help = "there is a command for that";
  CHECK(net_message("a.csv", "1\n2\n", limits) == "");
  CHECK(net_message("a.csv", "1\n2\n3\n", limits) == R"(a.csv:3:1: error: more than 2 points
     3 | 3
       | ^
       = help: there is a command for that
)");
  limits = NetLimits{};
  limits.bytes_of_large_numbers = std::size_t{1} << 20U;
  std::string many;
  for (int k = 0; k < 4000; ++k) many += "1e400\n";
  CHECK(net_message("a.csv", many, limits, 4096).find("need more than 1 MB") != std::string::npos);
}
