# What `cmake --install` puts where: program, library, headers, and how others find them.
include(CMakePackageConfigHelpers)

install(TARGETS patchproof_program patchproof_recheck)
install(TARGETS patchproof EXPORT patchproof_targets)
install(DIRECTORY lib/patchproof ${generated}/patchproof TYPE INCLUDE
  # Users of the library need no JSON library.
  FILES_MATCHING PATTERN *.hpp PATTERN prelude EXCLUDE PATTERN json_parts.hpp EXCLUDE
  PATTERN audit_json.hpp EXCLUDE PATTERN term_table.hpp EXCLUDE)
install(FILES LICENSE TYPE DOC)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/patchproof)
install(EXPORT patchproof_targets NAMESPACE patchproof:: DESTINATION ${package_folder}
  FILE patchproofTargets.cmake)
write_basic_package_version_file(patchproofConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/patchproofConfig.cmake ${PROJECT_BINARY_DIR}/patchproofConfigVersion.cmake
  DESTINATION ${package_folder})

# From the folder of patchproof.pc up to the prefix, so that an installation can be moved.
file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up_to_prefix "${up_to_prefix}")
configure_file(cmake/patchproof.pc.in patchproof.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/patchproof.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
