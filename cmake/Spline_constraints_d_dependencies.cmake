# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds what the target CGAL::Spline_constraints_d links, for the source tree and for an installed package alike.
# `problem` becomes a sentence that says what is missing, or stays empty. What is found reaches every directory of the project,
# as the target itself does.
function(spline_constraints_find_dependencies problem)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE) # CGAL reports its whole search as status messages

  # No version is asked of find_package: CGAL and Eigen then refuse a newer major version, which works too.
  find_package(CGAL QUIET)
  find_package(Eigen3 QUIET CONFIG)
  set(missing "")
  if(NOT CGAL_FOUND OR CGAL_VERSION VERSION_LESS 5.5.1)
    set(missing "CGAL 5.5.1 or newer (found: ${CGAL_VERSION})")
  elseif(CGAL_DISABLE_GMP OR NOT CGAL_USE_GMP OR NOT CGAL_USE_MPFR)
    set(missing "a CGAL that uses GMP and MPFR")
  elseif(NOT Eigen3_FOUND OR Eigen3_VERSION VERSION_LESS 3.4)
    set(missing "Eigen 3.4 or newer (found: ${Eigen3_VERSION})")
  endif()

  if(SPLINE_CONSTRAINTS_WITH_TBB)
    find_package(TBB QUIET CONFIG)
    if(NOT TBB_FOUND)
      set(missing "TBB (SPLINE_CONSTRAINTS_WITH_TBB is on)")
    endif()
  endif()
  if(SPLINE_CONSTRAINTS_WITH_MPFI)
    find_library(SPLINE_CONSTRAINTS_MPFI_LIBRARY mpfi)
    mark_as_advanced(SPLINE_CONSTRAINTS_MPFI_LIBRARY)
    if(NOT SPLINE_CONSTRAINTS_MPFI_LIBRARY)
      set(missing "MPFI (SPLINE_CONSTRAINTS_WITH_MPFI is on)")
    endif()
  endif()

  if(missing)
    set(${problem} "Spline_constraints_d needs ${missing}" PARENT_SCOPE)
  else()
    set(${problem} "" PARENT_SCOPE)
  endif()
endfunction()

# CGAL::Spline_constraints_d_MPI, where Boost.MPI is found: the package with what solver/batch_mpi.h needs.
function(spline_constraints_add_MPI_target)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  find_package(boost_mpi QUIET CONFIG)
  if(boost_mpi_FOUND AND NOT TARGET CGAL::Spline_constraints_d_MPI)
    add_library(CGAL::Spline_constraints_d_MPI INTERFACE IMPORTED GLOBAL)
    target_link_libraries(CGAL::Spline_constraints_d_MPI INTERFACE CGAL::Spline_constraints_d Boost::mpi)
  endif()
endfunction()
