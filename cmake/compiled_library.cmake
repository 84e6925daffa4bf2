# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# CGAL::Spline_constraints_d_compiled: all that needs no type of the user, and the default solvers, compiled once. A
# program that links it includes the same headers, which leave these definitions out then. Static, unless
# BUILD_SHARED_LIBS is on. With SPLINE_CONSTRAINTS_COMPILED_LIBRARY it is installed, too; without, it is built when a
# target of the project needs it.
set(only_on_request "")
if(NOT SPLINE_CONSTRAINTS_COMPILED_LIBRARY)
  set(only_on_request EXCLUDE_FROM_ALL)
endif()
# A function that is no template is declared where it is needed, and defined as CGAL_SPLINE_CONSTRAINTS_INLINE: below the
# operations in the same header, under `#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED`, which foundations.cpp includes; of an
# operation in a header of `internal/` that one of the other sources includes, or, if it is needed by many, in the same
# header under `#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS`, which curves_and_surfaces.cpp includes.
# The solvers by subdivision are templates, declared in solver/internal/compiled_solvers.h: solution_points.cpp and
# solution_curves_and_surfaces.cpp have them.
# Few sources with much in each: most of the time of the compiler goes into templates that they share. A source for each
# subject takes three times as long.
set(sources ${CMAKE_CURRENT_LIST_DIR}/compiled)
add_library(Spline_constraints_d_compiled ${only_on_request}
  ${sources}/foundations.cpp ${sources}/solution_points.cpp ${sources}/solution_curves_and_surfaces.cpp
  ${sources}/curves_and_surfaces.cpp ${sources}/planar_regions.cpp ${sources}/surface_regions.cpp
  ${sources}/envelope_surfaces.cpp
  ${sources}/implicit_patches.cpp ${sources}/approximate_polygons.cpp)
add_library(CGAL::Spline_constraints_d_compiled ALIAS Spline_constraints_d_compiled)
target_link_libraries(Spline_constraints_d_compiled
  PUBLIC Spline_constraints_d
  PRIVATE $<BUILD_INTERFACE:$<TARGET_NAME_IF_EXISTS:spline_constraints_warnings>>)
target_compile_definitions(Spline_constraints_d_compiled
  INTERFACE CGAL_SPLINE_CONSTRAINTS_COMPILED
  PRIVATE CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
# As benchmark/compile_time.sh compiles programs; -O3 is what CMake takes.
target_compile_options(Spline_constraints_d_compiled
  PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-O2>)
set_target_properties(Spline_constraints_d_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)

# What runs on all cores is compiled where there is TBB, also for programs that do not link TBB themselves.
find_package(TBB QUIET CONFIG)
if(TBB_FOUND)
  target_link_libraries(Spline_constraints_d_compiled PRIVATE TBB::tbb)
  target_compile_definitions(Spline_constraints_d_compiled
    PRIVATE CGAL_LINKED_WITH_TBB
    PUBLIC CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB)
endif()

find_package(pugixml QUIET CONFIG)
if(pugixml_FOUND)
  target_sources(Spline_constraints_d_compiled PRIVATE ${sources}/drawings.cpp)
  target_link_libraries(Spline_constraints_d_compiled PRIVATE pugixml::pugixml)
  target_compile_definitions(Spline_constraints_d_compiled INTERFACE CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_PUGIXML)
endif()
