// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Two pieces of one cubic curve, and a curve that crosses it: what they share is a piece of the curve, or a point.
#include <CGAL/Spline_constraints_d.h>

#include <iostream>

namespace SC = CGAL::Spline_constraints;

// Prints the common points of two curves, by their parameters t and s; returns how many answers there are.
std::size_t print_common_points(const SC::Solution_set_d<double>& solutions)
{
  for (const auto& s : solutions)
    if (s.kind() == SC::Solution_kind::CONTINUUM)
      for (const auto& end : s.ends())
        std::cout << (&end == &s.ends().front() ? "a common piece from " : " to ") << "(t,s) = (" << end[0] << ','
                  << end[1] << ')';
    else
      std::cout << "a common point near (t,s) = (" << s.point()[0] << ',' << s.point()[1] << ')';
  std::cout << (solutions.is_complete() ? ", and nothing else\n" : ", and perhaps more\n");
  return solutions.size();
}

int main()
{
  auto [t, s] = SC::unknowns({0, 1}, {0, 1});
  auto u = 3*t/4, v = 3*s/4 + SC::Exact_rational(1)/4;   // the pieces [0,3/4] and [1/4,1] of (u, u^3 - u)

  const auto overlap = SC::solve(u == v, u*u*u - u == v*v*v - v);
  const auto crossing = SC::solve(u == v, u*u*u - u == -v*v);

  return print_common_points(overlap) == 1 && print_common_points(crossing) == 1 ? 0 : 1;
}
