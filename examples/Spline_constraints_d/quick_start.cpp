// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where an ellipse and a circle meet above a line: once across, and once where they touch.
#include <CGAL/Spline_constraints_d.h>

#include <iostream>

namespace SC = CGAL::Spline_constraints;

int main()
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  auto solutions = SC::solve(x*x/4 + y*y == 1, square(x - 1) + y*y == 1, x + y > 0);

  std::cout.precision(16);
  for (const auto& s : solutions)
    std::cout << s.kind() << " of multiplicity " << s.multiplicity() << " with x in [" << s[0].first << ", "
              << s[0].second << "] and y in [" << s[1].first << ", " << s[1].second << "]\n";
  std::cout << (solutions.is_complete() ? "There are no others." : "There may be others.") << '\n';

  return solutions.is_complete() && solutions.size() == 2 ? 0 : 1;
}
