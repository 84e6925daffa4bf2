// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -ffp-contract=off -I include
// test/fuzz/fuzz_read_IRIT.cpp -lmpfr -lgmp -o fuzz_read_IRIT ./fuzz_read_IRIT -max_total_time=60
// test/fuzz/corpus/read_IRIT

#include "fuzz_read_splines.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  return check_reader(data, size, [](std::istream& in, const std::string& name) { SC::IO::read_IRIT<K>(in, name); });
}
