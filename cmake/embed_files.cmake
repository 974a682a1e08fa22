# cmake -DFILES=a.proof|b.proof -DFUNCTION=prelude_files -DHEADER=patchproof/language/prelude.hpp
#   -DOUTPUT=prelude_files.cpp -P embed_files.cmake
#
# The texts become arrays of characters and not string literals: literals have a longest length,
# differing by compiler, and escapes in them would run into the text that follows.
cmake_minimum_required(VERSION 3.25)

string(REPLACE "|" ";" files "${FILES}")
# By name alone: the order must not depend on where the project was cloned.
set(names)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  list(APPEND names ${name})
  set(path_of_${name} ${file})
endforeach()
list(SORT names)

set(arrays "")
set(entries "")
set(number 0)
foreach(name IN LISTS names)
  file(READ ${path_of_${name}} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," characters "${bytes}")
  string(REGEX REPLACE "(......,......,......,......,......,......,......,......,......,......,......,......,)" "\\1\n"
    characters "${characters}")
  # The last character keeps the array of an empty file from being empty; it is not in the text.
  string(APPEND arrays "constexpr char text_${number}[] = {\n${characters}'\\0'};\n")
  string(APPEND entries "      {\"${name}\", {text_${number}, sizeof text_${number} - 1}},\n")
  math(EXPR number "${number} + 1")
endforeach()

file(WRITE ${OUTPUT} "// Generated from the files named below; changes belong there.
#include <${HEADER}>

namespace patchproof {
namespace {
${arrays}}  // namespace

const std::vector<std::pair<std::string_view, std::string_view>>& ${FUNCTION}() {
  static const std::vector<std::pair<std::string_view, std::string_view>> files{
${entries}  };
  return files;
}

}  // namespace patchproof
")
