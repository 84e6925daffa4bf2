#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Solves each Minibex file of a folder, as those of the suites that come with the solver IBEX:
#
#   sh benchmark/suite.sh FOLDER [SECONDS [PROGRAM]]
#
# SECONDS (10) is the limit of time of each file, PROGRAM is solve_system (build/release/...), which uses all cores of the
# machine where it was built with TBB. Prints a line for each
# file: how it ended, the seconds of the whole process, and the line that sums up; then how many are complete,
# incomplete, refused (with the reason), past the limit by more than 0.3 s, or failed otherwise. Exit status: 0 when none
# failed.
set -u
folder=$1
limit=${2:-10}
program=${3:-$(dirname "$0")/../build/release/examples/Spline_constraints_d/solve_system}
complete=0 incomplete=0 refused=0 late=0 failed=0

for file in "$folder"/*.bch; do
  status=0
  begin=$(date +%s.%N)
  output=$("$program" "$file" --time-limit "$limit" 2>&1) || status=$?
  seconds=$(echo "$(date +%s.%N) $begin" | awk '{printf "%.3f", $1 - $2}')
  case $status in
    0) complete=$((complete + 1)) kind=complete ;;
    3) incomplete=$((incomplete + 1)) kind=incomplete ;;
    2) refused=$((refused + 1)) kind=refused ;;
    *) failed=$((failed + 1)) kind="exit status $status" ;;
  esac
  if awk "BEGIN {exit !($seconds > $limit + 0.3)}"; then
    late=$((late + 1)) kind="$kind, late"
  fi
  printf '%-28s %-18s %8s s  %s\n' "$(basename "$file" .bch)" "$kind" "$seconds" "$(printf '%s\n' "$output" | tail -n 1)"
done
printf 'files: %d complete, %d incomplete, %d refused, %d failed; %d past their limit\n' \
  "$complete" "$incomplete" "$refused" "$failed" "$late"
[ "$failed" -eq 0 ]
