#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# sh cmake/configure.sh PRESET: installs what is missing and configures build/PRESET. CGAL_DIR, if it is set, is the folder
# of the CGALConfig.cmake to take.
set -eu
cd "$(dirname "$0")/.."

sh cmake/install_dependencies.sh ||
  echo "Some packages could not be installed; going on with what is there." >&2

if [ ! -f "build/$1/CMakeCache.txt" ] && [ -z "${CMAKE_GENERATOR:-}" ] && command -v ninja >/dev/null 2>&1; then
  CMAKE_GENERATOR=Ninja
  export CMAKE_GENERATOR
fi
cmake --preset "$1" ${CGAL_DIR:+-D "CGAL_DIR=$CGAL_DIR"}
