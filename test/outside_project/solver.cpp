// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d.h>

namespace SC = CGAL::Spline_constraints;

int main()
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const auto solutions = SC::solve(x * x + y * y == 1, x == y);
  return solutions.is_complete() && solutions.count(SC::Solution_kind::CERTIFIED) == 2 ? 0 : 1;
}
