// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -ffp-contract=off -I include
// test/fuzz/fuzz_read_minibex.cpp -lmpfr -lgmp -o fuzz_read_minibex ./fuzz_read_minibex -max_total_time=60
// test/fuzz/corpus/read_minibex
//
// Whatever the bytes: either a system that survives writing and reading unchanged, or a Parse_error that points into
// the input.

#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_minibex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

namespace SC = CGAL::Spline_constraints;

namespace {

void require(bool condition)
{
  if (!condition)
    __builtin_trap();
}

void check_round_trip(const SC::Minibex_system& system)
{
  std::ostringstream out;
  SC::write_minibex(out, system);
  std::istringstream in(out.str());
  const SC::Minibex_system copy = SC::read_minibex(in, "copy");
  require(copy.names == system.names && copy.domains == system.domains &&
          copy.constraints.size() == system.constraints.size());
  for (std::size_t i = 0; i < copy.constraints.size(); ++i)
    require(copy.constraints[i].function == system.constraints[i].function &&
            copy.constraints[i].relation == system.constraints[i].relation);
}

// Whether every number of the system is written with few enough digits for the reader.
bool is_small(const SC::Minibex_system& system)
{
  const auto fits = [](const SC::Exact_rational& value) {
    return SC::internal::bit_length(SC::internal::numerator_of(value)) < 10000 &&
        SC::internal::bit_length(SC::internal::denominator_of(value)) < 10000;
  };
  for (const auto& [lower, upper] : system.domains)
    if (!fits(lower) || !fits(upper))
      return false;
  for (const auto& constraint : system.constraints) {
    if (constraint.function.terms().size() > 1000)
      return false;
    for (const auto& [monomial, coefficient] : constraint.function.terms())
      if (!fits(coefficient))
        return false;
  }
  return true;
}

// With elementary functions, texts may be long.
void check_text(const SC::Minibex_system& system)
{
  std::ostringstream out;
  try {
    SC::write_minibex(out, system);
  } catch (const SC::Invalid_input&) {
  }
}

void check(const std::string& content, SC::Minibex_subset subset)
{
  std::istringstream in(content);
  try {
    const SC::Minibex_system system = SC::read_minibex(in, "fuzz", subset);
    require(!system.names.empty() && system.names.size() == system.domains.size() && !system.constraints.empty());
    require(subset == SC::Minibex_subset::ELEMENTARY || system.values.all().empty());
    if (is_small(system))
      system.values.all().empty() ? check_round_trip(system) : check_text(system);
  } catch (const SC::Parse_error& error) {
    require(error.line() >= 1 && error.column() >= 1 && error.file() == "fuzz");
    const auto lines = 1 + std::count_if(content.begin(), content.end(), [](char c) { return c == '\n' || c == '\r'; });
    require(error.line() <= lines);
    require(content.find(error.text()) != std::string::npos);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string content(reinterpret_cast<const char*>(data), size);
  check(content, SC::Minibex_subset::POLYNOMIAL);
  check(content, SC::Minibex_subset::ELEMENTARY);
  return 0;
}
