// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FUZZ_READ_SPLINES_H
#define FUZZ_READ_SPLINES_H

#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/Spline_file.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<CGAL::Exact_rational>;

inline void require(bool condition)
{
  if (!condition)
    __builtin_trap();
}

// Whatever the bytes: `read(stream, name)` reads them, or throws a Parse_error that points into the input.
template <class Read>
int check_reader(const std::uint8_t* data, std::size_t size, const Read& read)
{
  const std::string content(reinterpret_cast<const char*>(data), size);
  std::istringstream in(content);
  try {
    read(in, "fuzz");
  } catch (const SC::Parse_error& error) {
    require(error.line() >= 1 && error.column() >= 1 && error.file() == "fuzz");
    const auto lines = 1 + std::count_if(content.begin(), content.end(), [](char c) { return c == '\n' || c == '\r'; });
    require(error.line() <= lines);
  }
  return 0;
}

#endif // FUZZ_READ_SPLINES_H
