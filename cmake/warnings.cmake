# The warnings that code of this project must not give.
#
# They are errors only with the compilers the project is tried with: a newer one may know a new
# warning, and that should not keep anybody from building.
function(use_project_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  if(PATCHPROOF_WARNINGS_AS_ERRORS AND compiler MATCHES "^(GNU 12|Clang 14)\\.")
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
