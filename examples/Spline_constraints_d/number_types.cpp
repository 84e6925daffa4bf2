// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Twelve points of a parabola, looked for in larger and larger squares: (x-1)(x-2)...(x-12) = 0 and 10 y = x^2. The
// values of the polynomial reach 10^72 on [-10^6, 10^6], and the rounding of a double there hides all that happens
// between 1 and 12. Doubles that do not watch their error drop points and call the answer complete. The other number
// types know what they do not know.
#include <CGAL/Spline_constraints_d.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
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

enum Outcome { RIGHT, OPEN, WRONG };

// Right: each point (k, k^2/10) lies in one certified box, and there is nothing else. Wrong: called complete, but a
// point is lost or one too many is certified.
template <class Solution_set>
Outcome judge(const Solution_set& solutions)
{
  int found = 0, lost = 0;
  for (int k = 1; k <= points; ++k) {
    const SC::Exact_rational point[] = {k, SC::Exact_rational(k*k) / 10};
    bool is_certified = false, is_covered = false;
    for (const auto& s : solutions) {
      bool is_inside = true;
      for (int j = 0; j < 2; ++j)
        is_inside =
            is_inside && SC::Exact_rational(s[j].first) <= point[j] && point[j] <= SC::Exact_rational(s[j].second);
      is_covered = is_covered || is_inside;
      is_certified = is_certified || (is_inside && s.is_certified());
    }
    found += is_certified;
    lost += !is_covered;
  }
  if (solutions.is_complete() && found == points && solutions.size() == points)
    return RIGHT;
  return (solutions.is_complete() && lost > 0) || solutions.count(SC::Solution_kind::CERTIFIED) > points ? WRONG : OPEN;
}

// One row of the table; the worst outcome in it.
template <class Traits>
Outcome solve_with(const char* name)
{
  Outcome worst = RIGHT;
  std::cout << std::left << std::setw(14) << name << std::right;
  for (double half_width : {20.0, 1e3, 1e6}) {
    const auto solutions = SC::Subdivision_solver_d<Traits>()(system_on_square(half_width));
    const Outcome outcome = judge(solutions);
    const char* const names[] = {"right", "open", "WRONG"};
    std::cout << std::setw(9) << solutions.count(SC::Solution_kind::CERTIFIED) << " points, " << std::left
              << std::setw(5) << names[outcome] << std::right;
    worst = std::max(worst, outcome);
  }
  std::cout << '\n';
  return worst;
}

int main()
{
  std::cout << "number type           on [-20,20]^2       on [-10^3,10^3]^2     on [-10^6,10^6]^2\n";
  solve_with<SC::Fast_solver_traits>("fast");
  bool is_right = solve_with<SC::Certified_solver_traits>("certified") == RIGHT;
  is_right &= solve_with<SC::Interval_solver_traits>("interval") == RIGHT;
  is_right &= solve_with<SC::Multiprecision_solver_traits>("multiprecision") == RIGHT;
  is_right &= solve_with<SC::Exact_solver_traits>("exact") == RIGHT;
  return is_right ? 0 : 1;
}
