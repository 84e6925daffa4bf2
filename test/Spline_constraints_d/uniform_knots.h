// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_UNIFORM_KNOTS_H
#define TEST_UNIFORM_KNOTS_H

#include <vector>

// Clamped knots of a cubic spline with pieces of length one.
inline std::vector<double> uniform_cubic_knots(int pieces)
{
  std::vector<double> result(3, 0.0);
  for (int i = 0; i <= pieces; ++i)
    result.push_back(i);
  result.insert(result.end(), 3, pieces);
  return result;
}

#endif // TEST_UNIFORM_KNOTS_H
