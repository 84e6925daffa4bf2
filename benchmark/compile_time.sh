#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# sh benchmark/compile_time.sh [EXAMPLE...]: what it costs to compile examples, by default quick_start, medial_axis,
# intersect_curves and surface_intersection, with the headers alone and with the compiled library, beside a program that
# inserts two segments into an arrangement of CGAL. All with -O2; user seconds and peak memory of the compiler, and the
# ratio of the seconds to those of CGAL's program. On an idle machine. Needs /usr/bin/time (package time).
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- quick_start medial_axis intersect_curves surface_intersection
examples=examples/Spline_constraints_d
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat > "$work/arrangement.cpp" <<'END'
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <iostream>

using Traits = CGAL::Arr_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;

int main()
{
  CGAL::Arrangement_2<Traits> arrangement;
  insert(arrangement, Traits::Curve_2({0, 0}, {1, 1}));
  insert(arrangement, Traits::Curve_2({0, 1}, {1, 0}));
  std::cout << arrangement.number_of_vertices() << '\n';
}
END

compiler=${CXX:-g++}
# As the target of CGAL has it where gmpxx is installed.
flags="-DCGAL_USE_GMPXX=1 -std=c++20 -O2 -frounding-math -ffp-contract=off -I include -I $examples -I /usr/include/eigen3"

# compile NAME SOURCE [FLAG...]: prints the name, user seconds, peak memory in MB and the ratio.
compile() {
  name=$1 source=$2
  shift 2
  # shellcheck disable=SC2086 # a list of flags
  /usr/bin/time -f '%U %M' -o "$work/cost" "$compiler" $flags -DDATA_DIRECTORY='"data/"' "$@" -c "$source" -o "$work/object.o"
  seconds=$(cut -d ' ' -f 1 "$work/cost")
  [ -n "${reference:-}" ] || reference=$seconds
  awk -v name="$name" -v reference="$reference" \
    '{ printf "%-44s %8.2f s %8.0f MB %8.2f\n", name, $1, $2 / 1024, $1 / reference }' "$work/cost"
}

printf '%-44s %10s %11s %8s\n' '' 'user' 'memory' 'ratio'
compile 'arrangement of CGAL' "$work/arrangement.cpp"
for example in "$@"; do
  compile "$example, compiled library" "$examples/$example.cpp" -DCGAL_SPLINE_CONSTRAINTS_COMPILED -DCGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_PUGIXML
  compile "$example, headers alone" "$examples/$example.cpp"
done
