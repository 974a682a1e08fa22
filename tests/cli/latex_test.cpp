#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string proof =
    "case c.one\n  title \"50 % čšž & Ж_1\"\n  scalar a\n  prove x: a + a == 2*a\nend\n"
    "case c.two\n  scalar a\n  refute y: a == 2\nend\n";

Ended latex(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "latex");
  return run_program(folder, arguments);
}

std::string message(const std::string& text) {
  return "patchproof latex: " + text +
         "\n  = help: 'patchproof latex --help' shows what can be said\n";
}

/// A folder of programs that takes the place of PATH during its life.
class Programs {
 public:
  Programs() : before_{std::getenv("PATH")} { ::setenv("PATH", folder_.path("").c_str(), 1); }
  ~Programs() { ::setenv("PATH", before_.c_str(), 1); }
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  void add(const std::string& name, const std::string& script) const {
    folder_.write(name, "#!/bin/sh\n" + script);
    ::chmod(folder_.path(name).c_str(), 0700);
  }

 private:
  TemporaryFolder folder_;
  std::string before_;
};

bool is_installed(const std::string& program) {
  return std::filesystem::exists("/usr/bin/" + program);
}

}  // namespace

TEST_CASE("latex writes a file for each case, a book and the style file") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Ended ended = latex(folder, {"a.proof", "-o", "new/out"});
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output == "2 cases written to 'new/out'\n");
  for (const char* name : {"c.one.tex", "c.two.tex", "book.tex", "patchproof.sty"})
    CHECK(std::filesystem::exists(folder.path(std::string{"new/out/"} + name)));
  CHECK(folder.text("new/out/c.one.tex").find("{50 \\% čšž \\& Ж\\_1}") != std::string::npos);
  const std::string book = folder.text("new/out/book.tex");
  latex(folder, {"a.proof", "-o", "new/out"});
  CHECK(folder.text("new/out/book.tex") == book);
}

TEST_CASE("one case needs no book, and fragments have none") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  CHECK(latex(folder, {"a.proof", "-o", "one", "--only", "c.one"}).output ==
        "1 case written to 'one'\n");
  CHECK_FALSE(std::filesystem::exists(folder.path("one/book.tex")));
  CHECK(latex(folder, {"a.proof", "-o", "parts", "--fragment"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("parts/book.tex")));
  CHECK(folder.text("parts/c.one.tex").find("documentclass") == std::string::npos);
}

TEST_CASE("a case that is not as expected is written, and the exit code says so") {
  const TemporaryFolder folder;
  folder.write("a.proof", "case c\n  scalar a\n  prove x: a == 2*a\nend\n");
  const Ended ended = latex(folder, {"a.proof", "-o", "out"});
  CHECK(ended.code == 1);
  CHECK(ended.errors == "patchproof: c.x: expected PROVED, found REFUTED\n");
  CHECK(folder.text("out/c.tex").find("The author expects") != std::string::npos);
}

TEST_CASE("what the command line of latex cannot be", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const auto rejected = [&](const std::vector<std::string>& arguments) {
    const Ended ended = latex(folder, arguments);
    CHECK(ended.code == 64);
    CHECK(ended.output == "");
    return ended.errors;
  };
  CHECK(rejected({"a.proof", "-o", "x", "--lang", "de"}) ==
        message("--lang: there is no language 'de'; there are en, cs, sk, sl, ru"));
  CHECK(rejected({"a.proof", "-o", "x", "--detail", "4"}) ==
        message("--detail: '4' is none of 1, 2, 3"));
  CHECK(rejected({"a.proof"}) == message("-o is missing: name a folder for the .tex files"));
  CHECK(rejected({"-o", "x"}) ==
        message("nothing to write of: name files or folders, or '-' for standard input"));
  CHECK(rejected({"a.proof", "--check", "x"}) ==
        message("--check looks at a folder of .tex files and takes no PATH"));
  CHECK(rejected({"a.proof", "-o", "x", "--fragment", "--pdf"}) ==
        message("--fragment excludes --pdf"));
  CHECK_FALSE(std::filesystem::exists(folder.path("x")));
}

TEST_CASE("latex says where it cannot write, and where there is no case", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  folder.write("file", "");
  const Ended file = latex(folder, {"a.proof", "-o", "file"});
  CHECK(file.code == 4);
  CHECK(file.errors == "patchproof: cannot write into 'file': Not a directory\n");
  const Ended below = latex(folder, {"a.proof", "-o", "file/x"});
  CHECK(below.code == 4);
  CHECK(below.errors == "patchproof: cannot write into 'file/x': Not a directory\n");
  // Whoever may do everything may write everywhere.
  if (::geteuid() != 0) {
    std::filesystem::create_directory(folder.path("closed"));
    ::chmod(folder.path("closed").c_str(), 0500);
    CHECK(latex(folder, {"a.proof", "-o", "closed"}).errors ==
          "patchproof: cannot write into 'closed': Permission denied\n");
  }
  std::filesystem::create_directory(folder.path("empty"));
  const Ended empty = latex(folder, {"empty", "-o", "out"});
  CHECK(empty.code == 5);
  CHECK(empty.errors == "patchproof: no .proof file in 'empty'\n");
}

TEST_CASE("--check lists what is stale") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  latex(folder, {"a.proof", "-o", "out"});
  const Ended fresh = latex(folder, {"--check", "out"});
  CHECK(fresh.code == 0);
  CHECK(fresh.output == "3 files are fresh\n");
  folder.write("a.proof", proof + "# a remark outside of all cases\n");
  CHECK(latex(folder, {"--check", "out"}).code == 0);
  std::string changed = proof;
  changed.replace(changed.find("a == 2\n"), 6, "a == 3");
  folder.write("a.proof", changed);
  const Ended stale = latex(folder, {"--check", "out"});
  CHECK(stale.code == 1);
  CHECK(stale.output ==
        "out/book.tex: stale: the case, a definition or the program has changed\n"
        "out/c.two.tex: stale: the case, a definition or the program has changed\n"
        "3 files, 2 stale\n");
  folder.write("a.proof", "case c.two\n  scalar a\n  refute y: a == 2\nend\n");
  CHECK(latex(folder, {"--check", "out"}).output ==
        "out/book.tex: stale: 'a.proof' has no case 'c.one'\n"
        "out/c.one.tex: stale: 'a.proof' has no case 'c.one'\n"
        "3 files, 2 stale\n");
  std::filesystem::remove(folder.path("a.proof"));
  CHECK(latex(folder, {"--check", "out"})
            .output.starts_with(
                "out/book.tex: stale: cannot read 'a.proof': No such file or directory\n"));
}

TEST_CASE("--check says where there is nothing to check", "[reject]") {
  const TemporaryFolder folder;
  folder.write("out/other.tex", "\\documentclass{article}\n");
  const Ended none = latex(folder, {"--check", "out"});
  CHECK(none.code == 5);
  CHECK(none.errors == "patchproof: no .tex file of patchproof in 'out'\n");
  const Ended missing = latex(folder, {"--check", "nowhere"});
  CHECK(missing.code == 4);
  CHECK(missing.errors == "patchproof: cannot read 'nowhere': No such file or directory\n");
}

TEST_CASE("without LaTeX, --pdf says what is missing, and the .tex stays", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Programs programs;
  const std::string help =
      "  = help: on Debian: apt-get install texlive-luatex texlive-latex-recommended "
      "texlive-pictures latexmk fonts-cmu texlive-lang-czechslovak texlive-lang-european "
      "texlive-lang-cyrillic\n";
  const Ended none = latex(folder, {"a.proof", "-o", "out", "--pdf"});
  CHECK(none.code == 4);
  CHECK(none.errors == "patchproof: cannot make a PDF: there is no 'latexmk'\n" + help);
  programs.add("latexmk", "exit 0\n");
  CHECK(latex(folder, {"a.proof", "-o", "out", "--pdf"}).errors ==
        "patchproof: cannot make a PDF: there is no 'lualatex'\n" + help);
  CHECK(std::filesystem::exists(folder.path("out/book.tex")));
}

TEST_CASE("a run of LaTeX that fails: its first error, and the claim it came from", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Programs programs;
  programs.add("lualatex", "exit 1\n");
  programs.add("latexmk",
               "echo 'This is LuaHBTeX' > book.log\n"
               "echo './c.two.tex:19: Missing $ inserted.' >> book.log\n"
               "echo './c.two.tex:20: Another.' >> book.log\nexit 12\n");
  const Ended ended = latex(folder, {"a.proof", "-o", "out", "--pdf"});
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "patchproof: LaTeX failed on 'out/book.tex'\n"
        "  = error: c.two.tex:19: Missing $ inserted.\n"
        "  = in the case: a.proof:8\n"
        "  = log: out/book.log\n");
  CHECK(std::filesystem::exists(folder.path("out/c.two.tex")));
}

TEST_CASE("a run of LaTeX that does not end is stopped", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Programs programs;
  programs.add("lualatex", "exit 1\n");
  programs.add("latexmk", "while :; do :; done\n");
  const Ended ended = latex(folder, {"a.proof", "-o", "out", "--pdf", "--pdf-time", "1"});
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "patchproof: LaTeX failed on 'out/book.tex': stopped after 1 seconds\n"
        "  = log: out/book.log\n");
}

TEST_CASE("LuaLaTeX makes a PDF in every language, without overfull boxes") {
  if (!is_installed("latexmk") || !is_installed("lualatex")) {
    std::cout << "SKIPPED: there is no LuaLaTeX\n";
    return;
  }
  const std::string wide =
      "case w\n  param u in [0, 1]\n  scalar abcdef[0..9]\n  matrix M = [" +
      std::string{
          "abcdef[0]*abcdef[1]*abcdef[2], abcdef[0]*abcdef[1]*abcdef[2], "
          "abcdef[0]*abcdef[1]*abcdef[2], abcdef[0]*abcdef[1]*abcdef[2], "
          "abcdef[0]*abcdef[1]*abcdef[2]]\n"} +
      "  prove sum: abcdef[0]*(1-u)^3 + abcdef[1]*u*(1-u)^2 + abcdef[2]*u^2*(1-u) + abcdef[3]*u^3 "
      "+ "
      "abcdef[4]*u^4 + abcdef[5]*u^5 == abcdef[5]*u^5 + abcdef[4]*u^4 + abcdef[3]*u^3 + "
      "abcdef[2]*u^2*(1-u) + abcdef[1]*u*(1-u)^2 + abcdef[0]*(1-u)^3\n"
      "  prove matrix_: M + M == 2*[abcdef[0]*abcdef[1]*abcdef[2], abcdef[0]*abcdef[1]*abcdef[2], "
      "abcdef[0]*abcdef[1]*abcdef[2], abcdef[0]*abcdef[1]*abcdef[2], "
      "abcdef[0]*abcdef[1]*abcdef[2]]\n"
      "end\n";
  for (const std::string language : {"en", "cs", "sk", "sl", "ru"}) {
    INFO(language);
    const TemporaryFolder folder;
    folder.write("a.proof", proof + wide);
    const Ended ended = latex(folder, {"a.proof", "-o", "out", "--pdf", "--lang", language});
    CHECK(ended.code == 0);
    CHECK(ended.errors == "");
    CHECK(ended.output == "3 cases written to 'out'\nout/book.pdf\n");
    const std::string log = folder.text("out/book.log");
    CHECK(log.find("Overfull") == std::string::npos);
    CHECK(log.find("Missing character") == std::string::npos);
    CHECK(std::filesystem::exists(folder.path("out/book.pdf")));
  }
}

}  // namespace patchproof
