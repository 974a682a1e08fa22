# Installs into a new folder, moves it, and builds a small program against it: once with
# find_package and once with pkg-config. Also tries the installed program.
cmake_minimum_required(VERSION 3.25)

set(scratch ${BUILD}/install_test)
set(prefix ${scratch}/moved)
set(consumer ${CMAKE_CURRENT_LIST_DIR}/consumer)
file(REMOVE_RECURSE ${scratch})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${code}): ${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_version)
  run(${ARGN})
  if(NOT output MATCHES "(^|[^0-9.])${VERSION}\n")
    message(FATAL_ERROR "expected version ${VERSION}, got: ${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${scratch}/installed)
file(RENAME ${scratch}/installed ${prefix})
expect_version(${prefix}/bin/patchproof --version)

run(${CMAKE_COMMAND} -S ${consumer} -B ${scratch}/build -G Ninja -DVERSION=${VERSION}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${scratch}/build)
expect_version(${scratch}/build/consumer)

set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBRARIES}/pkgconfig)
run(${PKG_CONFIG} --cflags --libs patchproof)
string(STRIP "${output}" flags)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${COMPILER} -std=c++20 ${consumer}/consumer.cpp -o ${scratch}/consumer ${flags})
expect_version(${scratch}/consumer)
