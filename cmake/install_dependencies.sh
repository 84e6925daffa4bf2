#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs what building, testing and documenting the package needs and the machine does not have yet (Debian, Ubuntu).
set -eu

packages="build-essential cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libmpfi-dev libboost-dev libboost-mpi-dev
  libeigen3-dev
  libtbb-dev libpugixml-dev libgtest-dev libbenchmark-dev doxygen graphviz"

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg >/dev/null 2>&1; then
  cat <<'END'
This is no Debian or Ubuntu system: nothing is installed. Install by hand, where they are missing:
  required   a C++20 compiler (g++ 12, clang 14 or newer), CMake 3.25, CGAL 5.5.1, GMP, MPFR, Boost headers, Eigen 3.4
  tests      GoogleTest
  optional   Ninja, Google Benchmark, Doxygen 1.9.4, Graphviz, TBB, MPFI, Boost.MPI, pugixml (reading of SVG)
CMake says which of them it does not find.
END
  exit 0
fi

missing=""
for package in $packages; do
  if ! dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed'; then
    missing="$missing $package"
  fi
done
if [ -z "$missing" ]; then
  exit 0
fi

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "Not root and no sudo. As root, run: apt-get install$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi

echo "Installing$missing"
$as_root apt-get update
# shellcheck disable=SC2086 # both are lists of words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
