// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Twelve points of a parabola, looked for in larger and larger squares: (x-1)(x-2)...(x-12) = 0 and 10 y = x^2. The coefficients of the polynomial
// reach 10^9, and its values on [-10^6, 10^6] reach 10^72: between 1 and 12 nothing is left of them after the first rounding to double. Doubles
// that do not watch their error find too few points, or too many, and call the answer complete. The other number types know when they cannot tell.
#include <CGAL/Spline_constraints_d.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;

constexpr int points = 12;

SC::Constraint_system_d system_on_square(double half_width)
{
  auto [x, y] = SC::unknowns({-half_width, half_width}, {-half_width, half_width});
  SC::Expression product(1);
  for (int k = 1; k <= points; ++k)
    product *= x - k;
  const std::vector<SC::Constraint> constraints{product == 0, 10*y == x*x};
  return SC::make_system(constraints);
}

// How many of the points (k, k^2/10) lie in exactly one certified box.
template <class Solution_set>
int points_found(const Solution_set& solutions)
{
  int found = 0;
  for (int k = 1; k <= points; ++k) {
    int boxes = 0;
    for (const auto& s : solutions) {
      const auto contains = [&](int j, const SC::Exact_rational& value) {
        return SC::Exact_rational(s[j].first) <= value && value <= SC::Exact_rational(s[j].second);
      };
      boxes += s.is_certified() && contains(0, k) && contains(1, SC::Exact_rational(k*k) / 10);
    }
    found += boxes == 1;
  }
  return found;
}

// One row of the table; whether all of it is right.
template <class Traits>
bool solve_with(const char* name)
{
  bool is_right = true;
  std::cout << std::left << std::setw(16) << name << std::right;
  for (double half_width : {20.0, 1e3, 1e6}) {
    const auto solutions = SC::Subdivision_solver_d<Traits>()(system_on_square(half_width));
    const std::size_t certified = solutions.count(SC::Solution_kind::CERTIFIED);
    const bool is_right_here = points_found(solutions) == points && certified == points && solutions.is_complete();
    std::cout << std::setw(8) << certified << " roots, " << (is_right_here ? "right" : solutions.is_complete() ? "WRONG" : "open ");
    is_right = is_right && is_right_here;
  }
  std::cout << '\n';
  return is_right;
}

int main()
{
  std::cout << "number type      within [-20, 20]^2  [-10^3, 10^3]^2     [-10^6, 10^6]^2\n";
  solve_with<SC::Fast_solver_traits>("fast");
  bool is_right = solve_with<SC::Certified_solver_traits>("certified");
  is_right &= solve_with<SC::Interval_solver_traits>("interval");
  is_right &= solve_with<SC::Multiprecision_solver_traits>("multiprecision");
  is_right &= solve_with<SC::Exact_solver_traits>("exact");
  return is_right ? 0 : 1;
}
