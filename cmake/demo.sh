#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# sh cmake/demo.sh: installs what is missing, builds the examples and runs them. solve_system solves every system of
# examples/Spline_constraints_d/data; what the other examples draw goes to build/pictures.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
examples=$root/examples/Spline_constraints_d
programs=$root/build/release/examples/Spline_constraints_d
pictures=$root/build/pictures
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)

sh cmake/configure.sh release
cmake --build --preset release --parallel "$jobs" --target examples

rm -rf "$pictures"
mkdir -p "$pictures"
cd "$pictures"
failures=0

if [ -x "$programs/solve_system" ]; then
  printf '\nsolve_system\n'
  for system in "$examples"/data/*.bch "$examples"/data/curves/*.bch "$examples"/data/surfaces/*.bch; do
    [ -e "$system" ] || continue
    status=0
    case $system in
      */surfaces/*) output=$("$programs/solve_system" "$system" --output "$(basename "$system" .bch).svg") || status=$? ;;
      *) output=$("$programs/solve_system" "$system") || status=$? ;;
    esac
    printf '  %-28s %s\n' "$(basename "$system")" "$(printf '%s\n' "$output" | tail -n 1)"
    if [ "$status" -ne 0 ]; then
      printf '  %-28s exit status %s\n' '' "$status"
      failures=$((failures + 1))
    fi
  done
fi

for source in "$examples"/*.cpp; do
  name=$(basename "$source" .cpp)
  if [ "$name" = solve_system ] || [ ! -x "$programs/$name" ]; then
    continue
  fi
  printf '\n%s\n' "$name"
  status=0
  output=$("$programs/$name") || status=$?
  printf '%s\n' "$output" | sed 's/^/  /'
  if [ "$status" -ne 0 ]; then
    printf '  exit status %s\n' "$status"
    failures=$((failures + 1))
  fi
done

if [ -n "$(ls -A "$pictures")" ]; then
  printf '\nWritten to build/pictures:\n'
  for picture in "$pictures"/*; do
    printf '  %s\n' "$(basename "$picture")"
  done
fi
if [ "$failures" -ne 0 ]; then
  printf '\n%s programs failed.\n' "$failures"
  exit 1
fi
