# With PATCHPROOF_SANITIZE, everything is compiled with the address and undefined-behaviour
# sanitizers and the checks of the standard library; with PATCHPROOF_FUZZ also for libFuzzer.
# The first thing found ends the program.
if(PATCHPROOF_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=address,undefined)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # Instrumented code makes GCC 12 give this warning for headers of its own, such as <regex>.
    # The release build gives it where it is deserved.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
endif()
if(PATCHPROOF_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Puts into each executable of this project that links the target what the leak check should know.
function(use_leak_suppressions target)
  if(PATCHPROOF_SANITIZE)
    target_sources(${target} INTERFACE
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/cmake/leak_suppressions.cpp>)
  endif()
endfunction()
