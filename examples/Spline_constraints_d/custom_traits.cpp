// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A solver with policies of one's own: a test for systems whose Jacobian matrix is dominated by its diagonal, and a
// splitter that prefers some unknowns. Solves Broyden's tridiagonal system, whose diagonal does dominate near its two
// solutions.
#include <CGAL/Spline_constraints_d.h>
#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;

// Where |J_ii| > sum |J_ik| holds for all Jacobian matrices that the node's derivative bounds allow, f(s) - f(t) = J (s
// - t) vanishes for s = t only.
struct Diagonal_dominance_test
{
  bool has_at_most_one_solution(SC::Node_view& node, const SC::Linear_enclosure&)
  {
    for (int i = 0; i < node.equalities(); ++i) {
      const double *lower = node.derivative_lower(i), *upper = node.derivative_upper(i);
      double others = 0;
      for (int k = 0; k < node.dimension(); ++k)
        if (k != i)
          others += std::max(std::abs(lower[k]), std::abs(upper[k]));
      // of the derivatives between the bounds, the one nearest to zero
      const double own = std::max(lower[i], -upper[i]);
      if (!(own > others * (1 + 1e-10)))   // the sum is rounded
        return false;
    }
    return true;
  }
};

// Splits the first unknowns first: in a chain of equations the others follow from them.
struct Front_splitter
{
  void rate(SC::Node_view&, const std::vector<double>& widths, std::vector<double>& rating)
  {
    rating = widths;
    for (std::size_t j = 0; j < rating.size(); ++j)
      rating[j] = std::ldexp(rating[j], -static_cast<int>(j));
  }
};

using My_traits = SC::Solver_traits<double, Diagonal_dominance_test, SC::Preconditioned_reduction, Front_splitter>;

template <class Traits>
std::size_t solve(const char* name, const SC::Constraint_system_d& system)
{
  const auto solutions = SC::Subdivision_solver_d<Traits>()(system);
  std::cout << name << solutions.count(SC::Solution_kind::CERTIFIED) << " solutions in " << solutions.summary().nodes
            << " nodes\n";
  return solutions.is_complete() ? solutions.count(SC::Solution_kind::CERTIFIED) : 0;
}

int main()
{
  const int n = 6;
  const std::vector<SC::Unknown> x = SC::unknowns(n, {-2, 2});
  std::vector<SC::Constraint> constraints;
  for (int i = 0; i < n; ++i) {
    SC::Expression f = (3 - 2*x[i])*x[i] + 1;
    if (i > 0)
      f -= x[i - 1];
    if (i + 1 < n)
      f -= 2*x[i + 1];
    constraints.push_back(f == 0);
  }
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const std::size_t by_default = solve<SC::Certified_solver_traits>("default policies: ", system);
  const std::size_t by_mine = solve<My_traits>("my policies:      ", system);
  return by_default == 2 && by_mine == 2 ? 0 : 1;
}
