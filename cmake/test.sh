#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# sh cmake/test.sh [PRESET]: installs what is missing, builds everything in build/PRESET and runs every test.
# The presets are release (the default), debug, sanitizers and threads (ThreadSanitizer).
#
# CGAL_DIR=FOLDER sh cmake/test.sh: with the CGAL whose CGALConfig.cmake is in FOLDER, for instance 6.0.1 of Debian 13:
# libcgal-dev_6.0.1-1_amd64.deb, unpacked by dpkg -x to cgal, has it in cgal/usr/lib/x86_64-linux-gnu/cmake/CGAL.
set -eu
cd "$(dirname "$0")/.."
preset=${1:-release}
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)

sh cmake/configure.sh "$preset"
cmake --build --preset "$preset" --parallel "$jobs"
ctest --preset "$preset" --parallel "$jobs"
