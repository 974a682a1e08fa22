# find_package(patchproof) gives the target patchproof::patchproof.
include(CMakeFindDependencyMacro)
find_dependency(Boost)
find_dependency(fmt)
find_dependency(PkgConfig)
pkg_check_modules(GINAC REQUIRED QUIET IMPORTED_TARGET ginac)
pkg_check_modules(CLN REQUIRED QUIET IMPORTED_TARGET cln)
include(${CMAKE_CURRENT_LIST_DIR}/patchproofTargets.cmake)
