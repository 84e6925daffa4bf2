// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All solutions of systems in many unknowns, by constraint propagation. First one in which each unknown has a cubic
// equation of its own, and all know of each other through their sum: drawn are the coordinates of all solutions, those
// of a solution joined by a line; where the cubic turns, one of three branches is taken. Then a product of thirty
// unknowns, which has 2^30 coefficients as a tensor; and a chain of a hundred unknowns, each of which knows its
// neighbours. Writes large_systems.svg. Exit status: 0 when all of them are complete, 3 when not.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Power_polynomial;
using SC::Relation;
using Kernel = CGAL::Simple_cartesian<double>;
using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
using Solutions = SC::Solution_set_d<double>;

namespace {

Power_polynomial sum_of(int count)
{
  Power_polynomial result;
  for (int i = 0; i < count; ++i)
    result += Power_polynomial::variable(i);
  return result;
}

// (5 x_i^3 - 21 x_i^2)/2 + 59 x_i/5 + s = i + 1 with s the sum of all (Yamamura).
Constraints coupled_cubics(int n)
{
  Constraints result;
  for (int i = 0; i < n; ++i) {
    const Power_polynomial x = Power_polynomial::variable(i);
    result.emplace_back((5 * pow(x, 3) - 21 * pow(x, 2)) / 2 + 59 * x / 5 + sum_of(n) - (i + 1), Relation::EQUAL);
  }
  return result;
}

// x_i + s = n + 1, but for the last one, and the product of all is one.
Constraints product_of_all(int n)
{
  Power_polynomial product(1);
  Constraints result;
  for (int i = 0; i < n; ++i) {
    product *= Power_polynomial::variable(i);
    if (i + 1 < n)
      result.emplace_back(Power_polynomial::variable(i) + sum_of(n) - (n + 1), Relation::EQUAL);
  }
  result.emplace_back(product - 1, Relation::EQUAL);
  return result;
}

// (3 - 2 x_i) x_i - x_{i-1} - 2 x_{i+1} + 1 = 0.
Constraints chain(int n)
{
  const auto x = [n](int i) { return i < 0 || i >= n ? Power_polynomial() : Power_polynomial::variable(i); };
  Constraints result;
  for (int i = 0; i < n; ++i)
    result.emplace_back((3 - 2 * x(i)) * x(i) - x(i - 1) - 2 * x(i + 1) + 1, Relation::EQUAL);
  return result;
}

Solutions solve(const std::string& name, const Constraints& constraints, int size)
{
  const std::vector<std::pair<Exact_rational, Exact_rational>> domain(constraints.size(),
                                                                      {Exact_rational(-size), Exact_rational(size)});
  Solutions solutions = SC::solve_polynomials(domain, constraints);
  std::cout << name << ", " << constraints.size() << " unknowns: " << solutions.size()
            << " solutions; complete: " << (solutions.is_complete() ? "yes" : "no") << '\n';
  return solutions;
}

// The coordinates of a solution above their indices.
void draw(SC::SVG_writer& picture, const SC::Solution_d<double>& solution, const std::string& color)
{
  std::vector<Kernel::Point_2> points;
  for (const double value : solution.point())
    points.emplace_back(0.25 * points.size(), value);
  picture.polyline(points, color, 0.8);
  for (const Kernel::Point_2& point : points)
    picture.point(point, color, 5);
}

} // namespace

int main()
{
  const int n = 40;
  const Solutions cubics = solve("cubics with a common sum", coupled_cubics(n), 100000000);
  const Solutions product = solve("a product of all", product_of_all(30), 100);
  const Solutions neighbours = solve("a chain", chain(100), 100);

  std::ofstream file("large_systems.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-0.3, -1.3, 0.25 * n, 3.6), 800);
  picture.polyline(std::vector{Kernel::Point_2(-0.2, 0), Kernel::Point_2(0.25 * n, 0)}, "#999999", 1);
  const std::vector<std::string> colors{"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b"};
  for (std::size_t k = 0; k < cubics.size(); ++k)
    draw(picture, cubics[k], colors[k % colors.size()]);
  return cubics.is_complete() && product.is_complete() && neighbours.is_complete() ? 0 : 3;
}
