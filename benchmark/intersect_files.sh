#!/bin/sh
# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Intersects each of many real files with itself: drawings, icons and models. Reads the list of files from standard input:
#
#   find /usr/share/icons/Adwaita -type f -name '*.svg' | sort | sh benchmark/intersect_files.sh build/release/examples/Spline_constraints_d/intersect 10
#
# The first argument is the program, the second one the seconds of the processor allowed for each file. Prints a line for each file that was not complete, with the reason or the last line of the program, then how many were
# complete, undecided (exit status 3), refused (2), slow, or failed otherwise. Exit status: 0 when none failed.
set -u
program=$1
seconds=$2
complete=0 undecided=0 refused=0 slow=0 failed=0

while read -r file; do
  status=0
  output=$(ulimit -t "$seconds"; exec "$program" "$file" 2>&1) || status=$?
  case $status in
    0) complete=$((complete + 1)); continue ;;
    3) undecided=$((undecided + 1)); kind=undecided ;;
    2) refused=$((refused + 1)); kind=refused ;;
    137 | 152) slow=$((slow + 1)); kind=slow; output= ;;
    *) failed=$((failed + 1)); kind="exit status $status" ;;
  esac
  printf '%s  %s  %s\n' "$kind" "$file" "$(printf '%s\n' "$output" | tail -n 1)"
done
printf 'files: %d complete, %d undecided, %d refused, %d slow, %d failed\n' "$complete" "$undecided" "$refused" "$slow" "$failed"
[ "$failed" -eq 0 ]
