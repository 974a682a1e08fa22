#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("no limit is not a limit of a case", "[language][reject]") {
  CHECK(type_messages(R"~(  limit steps 0
  limit time 0.0001 s
  limit memory 0.0000001 MB
)~") ==
        R"~(bad.proof:2:3: error: a limit is more than 0
     2 |   limit steps 0
       |   ^^^^^^^^^^^^^
       = help: leave it out for no limit of its own
bad.proof:3:3: error: a limit is more than 0
     3 |   limit time 0.0001 s
       |   ^^^^^^^^^^^^^^^^^^^
       = help: leave it out for no limit of its own
bad.proof:4:3: error: a limit is more than 0
     4 |   limit memory 0.0000001 MB
       |   ^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: leave it out for no limit of its own
)~");
}

}  // namespace patchproof
