#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <tests/cli/program.hpp>

namespace patchproof {

/// Puts a folder in front of all others in which programs are looked for.
class FirstInPath {
 public:
  explicit FirstInPath(const std::string& folder) : before_{std::getenv("PATH")} {
    std::string folders = folder;
    folders.append(":").append(before_);
    ::setenv("PATH", folders.c_str(), 1);
  }
  ~FirstInPath() { ::setenv("PATH", before_.c_str(), 1); }
  FirstInPath(const FirstInPath&) = delete;
  FirstInPath& operator=(const FirstInPath&) = delete;

 private:
  std::string before_;
};

/// A coqc that accepts everything and prints one text for files of one case, and another one for
/// bundles. It keeps the names of the files it was asked about, but for the library, in "asked".
class FakeCoqc {
 public:
  explicit FakeCoqc(const std::string& alone, const std::string& together = "")
      : first_{programs_.path("")} {
    programs_.write("alone", alone);
    programs_.write("together", together);
    std::string script =
        "#!/bin/sh\nif [ \"$1\" = --version ]; then echo 'version 8.16.1'; exit; fi\n"
        "for file; do :; done\n"
        "case $file in\n  *together_*) name=together ;;\n  PatchProof/*) exit ;;\n"
        "  *) name=alone ;;\nesac\n";
    script.append("echo $file >> '").append(programs_.path("asked")).append("'\n");
    script.append("cat '").append(programs_.path("")).append("'/$name\n");
    programs_.write("coqc", script);
    std::filesystem::permissions(programs_.path("coqc"), std::filesystem::perms::owner_all);
  }

  std::string asked() const { return programs_.text("asked"); }

 private:
  TemporaryFolder programs_;
  FirstInPath first_;
};

}  // namespace patchproof
