#include <catch2/catch.hpp>

#include <patchproof/patchproof.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

const std::string squares =
    "case squares\n"
    "  scalar a, b\n"
    "  prove  third: (a + b)*(a - b) == a^2 - b^2\n"
    "end\n";

}  // namespace

TEST_CASE("A text can be checked and reported on in three lines") {
  const Report report = check({{"squares.proof", squares, ""}});
  CHECK(written(report, "text", {}) ==
        "  squares.third  PROVED\n\n1 claim in 1 case: 1 as expected (1 proved)\n");
  CHECK(exit_code(report) == ExitCode::as_expected);
}

TEST_CASE("Without a loader nothing can be included", "[reject]") {
  const Report report = check({{"a.proof", "include \"b.proof\"\n" + squares, ""}});
  REQUIRE(report.files.front().diagnostics.size() == 1);
  CHECK(report.files.front().diagnostics.front().message == "cannot read 'b.proof'");
  CHECK(exit_code(report) == ExitCode::unreadable);
}

TEST_CASE("A path without a text is in the report as unreadable", "[reject]") {
  const Report report =
      check({{"a.proof", std::nullopt, "Permission denied"}, {"b.proof", squares, ""}});
  CHECK(mistakes(report) == "patchproof: cannot read 'a.proof': Permission denied\n");
  CHECK(report.files.back().cases.size() == 1);
}

TEST_CASE("Cases without a wanted claim are left out of the report") {
  CheckOptions options;
  options.wanted = [](const Case& of, const Claim&) { return of.name == "squares"; };
  std::size_t decided_claims = 0;
  options.progress = [&](const Case&, const Claim&) { ++decided_claims; };
  const Report report = check(
      {{"a.proof", squares + "case other\n  scalar a\n  prove x: a == a\nend\n", ""}}, options);
  REQUIRE(report.files.front().cases.size() == 1);
  CHECK(report.files.front().cases.front().verified.name == "squares");
  CHECK(decided_claims == 1);
}

TEST_CASE("A report does not throw for bytes that are no text") {
  std::string bytes;
  for (int k = 0; k < 256; ++k) bytes += static_cast<char>(k);
  const Report report = check({{bytes, bytes, ""}});
  CHECK(exit_code(report) == ExitCode::unreadable);
  for (const Format& format : formats()) CHECK_NOTHROW(written(report, format.name, {}));
  CHECK(!mistakes(report).empty());
}

}  // namespace patchproof
