# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -D SOURCE_DIR=<tree> -P check_house_rules.cmake
# Checks the licence header of every file of code, and of every header of the package its include guard, its length and that it
# includes its own and lower floors only.

cmake_minimum_required(VERSION 3.25)

set(floor_of_number 0)
set(floor_of_function 1)
set(floor_of_solver 2)
set(floor_of_geometry 3)
set(floor_of_operations 4)
set(floor_of_output 5)
set(floor_of_IO 5)

set(broken "")
macro(report file text)
  string(APPEND broken "${file}: ${text}\n")
endmacro()

file(GLOB_RECURSE code RELATIVE ${SOURCE_DIR}
  ${SOURCE_DIR}/include/*.h ${SOURCE_DIR}/test/*.cpp ${SOURCE_DIR}/test/*.h ${SOURCE_DIR}/examples/*.cpp
  ${SOURCE_DIR}/examples/*.h ${SOURCE_DIR}/benchmark/*.cpp ${SOURCE_DIR}/benchmark/*.h ${SOURCE_DIR}/doc/*.h)
foreach(file IN LISTS code)
  file(READ ${SOURCE_DIR}/${file} beginning LIMIT 1000)
  if(NOT beginning MATCHES "^// Copyright \\(c\\) [0-9-]+ [^\n]*\n// SPDX-License-Identifier: GPL-3.0-or-later\n")
    report(${file} "does not begin with the copyright and SPDX lines")
  endif()
endforeach()

file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR}/include ${SOURCE_DIR}/include/*.h)
foreach(header IN LISTS headers)
  file(READ ${SOURCE_DIR}/include/${header} text)

  string(REPLACE "CGAL/Spline_constraints_d" "CGAL/SPLINE_CONSTRAINTS_D" guard ${header})
  string(MAKE_C_IDENTIFIER ${guard} guard)
  string(TOUPPER ${guard} guard)
  if(NOT text MATCHES "\n#ifndef ${guard}\n#define ${guard}\n")
    report(${header} "the include guard is not ${guard}")
  endif()

  string(REGEX MATCHALL "\n" lines "${text}")
  list(LENGTH lines line_count)
  if(line_count GREATER 500)
    report(${header} "${line_count} lines; 500 are allowed")
  endif()

  if(header MATCHES "^CGAL/Spline_constraints_d/([^/]+)/" AND DEFINED floor_of_${CMAKE_MATCH_1})
    set(own_floor ${floor_of_${CMAKE_MATCH_1}})
    string(REGEX MATCHALL "#include <CGAL/Spline_constraints_d/[^/>]+/" includes "${text}")
    list(REMOVE_DUPLICATES includes)
    foreach(include IN LISTS includes)
      string(REGEX REPLACE ".*/([^/]+)/$" "\\1" floor "${include}")
      if(DEFINED floor_of_${floor} AND floor_of_${floor} GREATER own_floor)
        report(${header} "includes a header of the higher floor ${floor}/")
      endif()
    endforeach()
  endif()
endforeach()

if(NOT headers)
  report(${SOURCE_DIR}/include "no headers found")
endif()
if(broken)
  message(FATAL_ERROR "House rules broken:\n${broken}")
endif()
list(LENGTH code code_count)
message(STATUS "${code_count} files keep the house rules")
