# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Install rules: afterwards find_package(Spline_constraints_d) gives the targets CGAL::Spline_constraints_d and
# CGAL::Spline_constraints_d_compiled.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Spline_constraints_d)
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/Spline_constraints_dConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/Spline_constraints_dConfig.cmake
  INSTALL_DESTINATION ${config_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/Spline_constraints_dConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)

set(installed_targets Spline_constraints_d)
if(SPLINE_CONSTRAINTS_COMPILED_LIBRARY)
  list(APPEND installed_targets Spline_constraints_d_compiled)
endif()
install(TARGETS ${installed_targets} EXPORT Spline_constraints_d_targets)
install(EXPORT Spline_constraints_d_targets NAMESPACE CGAL:: DESTINATION ${config_dir})
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/Spline_constraints_dConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/Spline_constraints_dConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Spline_constraints_d_dependencies.cmake
  DESTINATION ${config_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
