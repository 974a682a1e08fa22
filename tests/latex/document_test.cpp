#include <catch2/catch.hpp>

#include <patchproof/latex/document.hpp>
#include <patchproof/patchproof.hpp>

namespace patchproof {

namespace {

std::vector<Page> pages_of(const std::string& text, Detail detail = Detail::result) {
  const Report report = check({{"f/a.proof", text, ""}});
  REQUIRE(report.files.front().diagnostics.empty());
  std::vector<Page> pages;
  for (const CaseResult& result : report.files.front().cases)
    pages.push_back({result, case_derivation(result, detail, Engines::kernel), {}, "d"});
  return pages;
}

// A fragment without the lines that say where it comes from.
std::string body_of(const std::string& text, Language language = Language::english) {
  const std::string tex = document(pages_of(text).front(), {language, Detail::result, true});
  return tex.substr(tex.find("\\ppcase"));
}

bool contains(const std::string& text, const std::string& part) {
  INFO(text);
  INFO(part);
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a page: title, source, what is given, assumptions, claims with verdicts") {
  const std::string text =
      "case edge.one\n"
      "  title \"100 % of {C^1} & more\"\n"
      "  source \"A_B\" section \"2\" page 12\n"
      "  param u in [0, 1]\n"
      "  point V[0..3, 0..1], q\n"
      "  scalar a\n"
      "  assume positive: a > 0\n"
      "  prove sum: a + a == 2*a\n"
      "  refute no: a == 2\n"
      "end\n";
  CHECK(body_of(text) ==
        "\\ppcase{100 \\% of \\{$C^{1}$\\} \\& more}{edge.one}"
        "{\\ppsource{Source: A\\_B, section 2, p.~12}}\n"
        "\\label{case:edge.one}\n"
        "\\ppheading{Given}\n"
        "\\ppitem{parameter $u \\in [0,1]$}\n"
        "\\ppitem{points $V_{ij}$ ($i=0,\\dots,3$; $j=0,\\,1$), $q$}\n"
        "\\ppitem{number $a$}\n"
        "\\ppheading{Assumptions}\n"
        "\\pptext{\\pplabel{positive}}\n"
        "\\ppalone{\\pps{a > 0}}\n"
        "\n% case f/a.proof:8\n"
        "\\ppclaim{Claim}{sum}\n"
        "\\begin{ppchain}{a + a}\n  \\ppline{=}{2a}{}\n\\end{ppchain}\n"
        "\\ppverdict{ppgood}{proved}{both engines}\n"
        "\n% case f/a.proof:9\n"
        "\\ppclaim{Claim}{no}\n"
        "\\begin{ppchain}{a}\n  \\ppline{=}{2}{}\n\\end{ppchain}\n"
        "\\pptext{\\textbf{Counterexample:} $a = 1$}\n"
        "\\pptext{left side: $1$, right side: $2$}\n"
        "\\ppside{left side minus right side}{a - 2}\n"
        "\\ppverdict{ppbad}{refuted}{both engines}\n");
}

TEST_CASE("an erratum has one heading; what is printed is struck, what is right stands below it") {
  const std::string tex = body_of(
      "case e\n  scalar a\n  erratum slip\n    printed a == 2*a\n    corrected a + a == 2*a\n"
      "    note \"a + a\"\n  end\nend\n",
      Language::slovak);
  const std::size_t printed = tex.find(
      "\\ppclaim{Oprava}{slip}\n\\pptext{Vytlačené:}\n\\begin{ppstruck}\n"
      "\\begin{ppchain}{a}\n  \\ppline{=}{2a}{}\n\\end{ppchain}\n\\end{ppstruck}\n"
      "\\pptext{\\textbf{Kontrapríklad:}");
  const std::size_t corrected = tex.find("\\pptext{Správne:}\n\\begin{ppchain}{a + a}\n");
  CHECK(printed != std::string::npos);
  CHECK(corrected != std::string::npos);
  CHECK(printed < corrected);
  CHECK(tex.find("\\ppclaim", printed + 1) == std::string::npos);
  CHECK(contains(tex, "\\pptext{Poznámka: a + a}"));
}

TEST_CASE("conditions stand with the verdict that needs them") {
  const std::string tex =
      body_of("case c\n  scalar a, b\n  prove x: (a^2 - b^2)/(a - b) == a + b\nend\n");
  CHECK(contains(tex,
                 "\\pptext{provided that}\n\\ppalone{a - b \\neq 0}\n"
                 "\\ppverdict{ppgood}{proved if}{both engines}\n"));
}

TEST_CASE("what is not decided stands in a frame with its reason") {
  const std::string tex =
      body_of("case c\n  scalar a, b\n  limit steps 1\n  open x: (a + b)^9 == (b + a)^9\nend\n");
  CHECK(contains(tex,
                 "\\ppalarm{ppopen}{\\textbf{\\textsf{unknown: not decided}}\\par Reason: limit"));
}

TEST_CASE("a verdict that the author does not expect is said to be so") {
  const std::string tex = body_of("case c\n  scalar a\n  prove x: a == 2*a\nend\n");
  CHECK(contains(tex,
                 "\\ppverdict{ppbad}{refuted}{both engines}\n"
                 "\\ppalarm{ppbad}{The author expects: \\textbf{proved}}\n"));
}

TEST_CASE("a derivation says what is looked for, and boxes what was found") {
  const std::string tex = body_of(
      "case c\n  point x, y\n  derive d: x from 2*x == y gives 1/2*y\n  prove p: x + x == y using "
      "d\nend\n");
  CHECK(contains(tex, "\\pptext{Find $x$ such that}\n\\begin{ppchain}{2x}\n  \\ppline{=}{y}{}\n"));
  CHECK(contains(tex, "\\pptext{The stated solution is}\n\\begin{ppchain}{x}\n"));
  CHECK(contains(tex, "\\begin{ppresult}\n\\begin{ppchain}{x}\n"));
  CHECK(contains(tex, "\\pptext{(using \\pplabel{d})}\n"));
}

TEST_CASE("of a family one instance is written down, and the others are counted") {
  const std::string tex =
      body_of("case c\n  point V[0..3]\n  prove f: 2*V[i] == V[i] + V[i] for i in 0..3\nend\n");
  CHECK(contains(tex, "\\ppclaim{Claim}{f[i=0]}\n"));
  CHECK(contains(tex, "\\pptext{Further instances, decided in the same way: 3.}\n"));
}

TEST_CASE("a document stands alone and can be read by a book; a fragment is the body alone") {
  const std::string text = "case c.d\n  scalar a\n  prove x: a == a\nend\n";
  const Page page = pages_of(text).front();
  const std::string whole = document(page, {Language::czech, Detail::result, false});
  CHECK(contains(whole,
                 "% options: --lang cs --detail 1\n"
                 "\\ifdefined\\ppbook\\else\n\\documentclass[11pt,a4paper]{article}\n"
                 "\\usepackage[czech]{babel}\n\\usepackage{patchproof}\n"
                 "\\begin{document}\n\\fi\n\\ppcase{c.d}{c.d}{}\n"));
  CHECK(whole.ends_with("\\ifdefined\\ppbook\\expandafter\\endinput\\fi\n\\end{document}\n"));
  CHECK(document(page, {Language::czech, Detail::result, true}).find("document}") ==
        std::string::npos);
  CHECK(file_name(page.result.verified) == "c.d.tex");
  CHECK(document(page, {}) == document(pages_of(text).front(), {}));
}

TEST_CASE("a book reads its cases by folders, collects errata, and counts verdicts") {
  const std::string tex = book(pages_of("case one\n  scalar a\n  prove x: a == a\nend\n"
                                        "case two\n  scalar a\n  erratum slip\n    printed a == "
                                        "2*a\n    corrected a + a == 2*a\n  end\nend\n"),
                               {});
  CHECK(contains(tex, "% case: one, source: f/a.proof\n% case: two, source: f/a.proof\n"));
  CHECK(contains(tex,
                 "\\tableofcontents\n\n\\chapter{F}\n\\input{one.tex}\n\\input{two.tex}\n"
                 "\n\\chapter{Errata}\n\\ppclaim{two, p.~\\pageref{case:two}}{slip}\n"));
  CHECK(contains(tex,
                 "\\begin{pptable}{l*{3}{r}}\nSubject & proved & refuted & Total \\\\\\hline\n"
                 "F & 2 & 1 & 3 \\\\\n\\hline\nTotal & 2 & 1 & 3 \\\\\n\\end{pptable}\n"));
}

}  // namespace patchproof
