# One libFuzzer executable and one CTest test for each tests/fuzz/NAME_fuzz.cpp, with the seeds in
# tests/fuzz/corpus/NAME. What a run finds goes to build/fuzz/fuzz/, never into the sources.
set(PATCHPROOF_FUZZ_SECONDS 60 CACHE STRING "How long all fuzz targets together may run")

file(GLOB fuzz_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/*_fuzz.cpp)
list(LENGTH fuzz_sources count)
if(count EQUAL 0)
  message(FATAL_ERROR "There is no fuzz target in tests/fuzz.")
endif()
math(EXPR seconds "(${PATCHPROOF_FUZZ_SECONDS} + ${count} - 1) / ${count}")

foreach(source IN LISTS fuzz_sources)
  get_filename_component(target ${source} NAME_WE)
  string(REGEX REPLACE "_fuzz$" "" name ${target})
  set(corpus ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/${name})
  if(NOT IS_DIRECTORY ${corpus})
    message(FATAL_ERROR "The fuzz target ${name} has no seeds in tests/fuzz/corpus/${name}.")
  endif()

  add_executable(${target} ${source})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE patchproof recheck)
  target_link_options(${target} PRIVATE -fsanitize=fuzzer)
  use_project_warnings(${target})

  set(findings ${PROJECT_BINARY_DIR}/fuzz/${name})
  file(MAKE_DIRECTORY ${findings}/corpus)
  # New inputs are written to the first folder; the seeds are only read.
  add_test(NAME fuzz/${name} COMMAND ${target}
    -max_total_time=${seconds} -timeout=60 -rss_limit_mb=4096 -artifact_prefix=${findings}/
    ${findings}/corpus ${corpus})
  math(EXPR longest "${seconds} + 120")
  set_tests_properties(fuzz/${name} PROPERTIES
    TIMEOUT ${longest} FAIL_REGULAR_EXPRESSION "Done 0 runs;no interesting inputs were found")
endforeach()
