// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_SOAK_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_SOAK_SYSTEMS_H

#include "../../test/Spline_constraints_d/planted_multiple_roots.h"
#include "../../test/Spline_constraints_d/planted_simple_roots.h"

#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace solver_benchmark {

using namespace solver_test;

struct Soak_system
{
  std::string name;
  System system;
  std::vector<Point> planted;   // solutions, maybe not all
};

/*
A random system for every number: dense and sparse polynomials of degrees 1 to 6 with integer, dyadic and decimal
coefficients, near-double roots, systems with all roots planted, simple ones with gaps from 1e-3 to 1e-12 and multiple
ones, and sums of splines; each in 1 to 4 unknowns and now and then with inequalities, on whose boundary a solution may
lie.
*/
class Soak_systems
{
  Random_numbers m_random;
  std::uint64_t m_seed;

public:
  explicit Soak_systems(std::uint64_t seed) : m_random(seed), m_seed(seed) {}

  Soak_system make()
  {
    const int n = m_random.integer(1, 4);
    Soak_system result = make_equalities(n);
    if (m_random.chance(25))
      add_inequality(result);
    return result;
  }

private:
  Soak_system make_equalities(int n)
  {
    switch (m_random.integer(0, 5)) {
    case 0: return with_root("dense", n, dense(n));
    case 1: return with_root("sparse", n, sparse(n));
    case 2: return near_double();
    case 3: {
      const Problem problem = Planted_simple_roots(m_seed, gap(3, 12)).make(n);
      return {"simple roots, " + problem.name, problem.system, problem.known};
    }
    case 4: {
      const Planted_problem problem = Planted_multiple_roots(m_seed, 2).make(n, false);
      Soak_system result{"multiple roots, " + problem.name, problem.system, {}};
      for (const Planted_root& root : problem.roots)
        result.planted.push_back(root.point);
      return result;
    }
    default: return splines(n);
    }
  }

  Rational gap(int least, int most) { return Rational(1) / power_of_ten(m_random.integer(least, most)); }

  static Rational power_of_ten(int exponent)
  {
    Rational result(1);
    for (int i = 0; i < exponent; ++i)
      result *= 10;
    return result;
  }

  // An integer, a dyadic or a decimal number.
  Rational coefficient()
  {
    const int numerator = m_random.integer(-99, 99);
    switch (m_random.integer(0, 2)) {
    case 0: return Rational(numerator);
    case 1: return fraction(numerator, 1 << m_random.integer(0, 7));
    default: return fraction(numerator, std::array{1, 10, 100, 1000}[m_random.integer(0, 3)]);
    }
  }

  Rational place() { return m_random.chance(30) ? fraction(m_random.integer(-4, 4), 4) : m_random.ratio(-30, 30, 31); }

  // All monomials of the unknowns up to a total degree.
  std::vector<Polynomial> dense(int n)
  {
    const int degree = m_random.integer(1, std::array{6, 5, 3, 2}[n - 1]);
    std::vector<Polynomial> functions;
    for (int i = 0; i < n; ++i) {
      Polynomial function;
      for (const std::vector<int>& exponents : SC::internal::exponents_up_to(n, degree)) {
        Polynomial monomial(coefficient());
        for (int j = 0; j < n; ++j)
          monomial *= pow(Polynomial::variable(j), exponents[j]);
        function += monomial;
      }
      functions.push_back(std::move(function));
    }
    return functions;
  }

  std::vector<Polynomial> sparse(int n)
  {
    std::vector<Polynomial> functions;
    for (int i = 0; i < n; ++i) {
      Polynomial function = coefficient() * Polynomial::variable(i);
      for (int terms = m_random.integer(1, 4); terms > 0; --terms) {
        Polynomial monomial(coefficient());
        for (int j = 0, room = 6; j < n; ++j)
          if (m_random.chance(50)) {
            const int exponent = m_random.integer(0, room);
            room -= exponent;
            monomial *= pow(Polynomial::variable(j), exponent);
          }
        function += monomial;
      }
      functions.push_back(std::move(function));
    }
    return functions;
  }

  // Moves the values so that there is a root, now and then on faces of the domain.
  Soak_system with_root(const std::string& name, int n, const std::vector<Polynomial>& functions)
  {
    Point root;
    std::vector<System::Domain> domain;
    for (int j = 0; j < n; ++j) {
      const Rational x = place();
      root.emplace_back(x);
      domain.emplace_back(m_random.chance(8) ? x : Rational(x - m_random.ratio(1, 8, 3)),
                          m_random.chance(8) ? x : Rational(x + m_random.ratio(1, 8, 3)));
    }
    System system(domain);
    for (const Polynomial& function : functions)
      system.add(function - value_at(function, root).lower, Relation::EQUAL);
    return {name, std::move(system), {root}};
  }

  // Two curves that cross twice close to a point, touch there, or miss each other.
  Soak_system near_double()
  {
    const std::vector<Polynomial> v = variables(2);
    const Rational x = place(), distance = gap(3, 12);
    Polynomial height;
    for (int k = m_random.integer(1, 4); k >= 0; --k)
      height = height * v[0] + coefficient();
    const Polynomial f = v[1] - height, a = Polynomial(coefficient()) + coefficient() * v[0];
    const int sign = m_random.integer(-1, 1);
    Soak_system result{"near-double", cube(1, 0, 1), {}};
    if (sign >= 0)
      for (const int side : {-1, 1}) {
        const Coordinate at(x + sign * side * distance);
        result.planted.push_back({at, value_at(height, {at})});
      }
    Rational least = value_at(height, {x}).lower, largest = least;
    for (const Rational& end : {Rational(x - distance), Rational(x + distance)}) {
      least = (std::min)(least, value_at(height, {end}).lower);
      largest = (std::max)(largest, value_at(height, {end}).lower);
    }
    const Rational width = m_random.ratio(1, 6, 3);
    result.system =
        with_equalities(System({{x - width, x + width / 2}, {least - width, largest + width / 3}}),
                        {f, a * f + m_random.ratio(1, 9, 9) * (square(v[0] - x) - sign * distance * distance)});
    return result;
  }

  // A continuous spline in one unknown with random control points.
  SC::Spline_function spline(int variable, const Rational& lower, const Rational& upper)
  {
    const int pieces = m_random.integer(1, 4), degree = m_random.integer(1, 5);
    std::vector<Rational> breaks;
    std::vector<SC::Bernstein_tensor<Rational>> tensors;
    Rational last = coefficient();
    for (int k = 0; k <= pieces; ++k) {
      breaks.push_back(lower + (upper - lower) * fraction(k, pieces));
      if (k == pieces)
        break;
      std::vector<Rational> control{last};
      for (int i = 0; i < degree; ++i)
        control.push_back(coefficient());
      last = control.back();
      tensors.emplace_back(std::vector<int>{degree}, control);
    }
    return SC::Spline_function::from_bezier_pieces({variable}, {breaks}, tensors);
  }

  // Sums of splines in one unknown each, with a root in the grid of tenths.
  Soak_system splines(int n)
  {
    const Rational lower(m_random.integer(-3, 0)), upper = lower + m_random.integer(1, 6);
    std::vector<Rational> root;
    for (int j = 0; j < n; ++j)
      root.push_back(lower + (upper - lower) * fraction(m_random.integer(0, 12), 12));
    System system = cube(n, lower, upper);
    for (int i = 0; i < n; ++i) {
      SC::Spline_function sum = spline(i, lower, upper);
      for (int j = 0; j < n; ++j)
        if (j != i && m_random.chance(50))
          sum += spline(j, lower, upper) *= fraction(1, 4);
      system.add(sum - SC::Spline_function(Polynomial(SC::internal::evaluate_exactly(sum, root))), Relation::EQUAL);
    }
    return {"splines", std::move(system), {Point(root.begin(), root.end())}};
  }

  // Through a planted solution, or anywhere.
  void add_inequality(Soak_system& problem)
  {
    Polynomial function;
    for (int j = 0; j < problem.system.dimension(); ++j)
      function += coefficient() * (m_random.chance(70) ? Polynomial::variable(j) : square(Polynomial::variable(j)));
    const bool is_through = !problem.planted.empty() && m_random.chance(40);
    function -= is_through ? value_at(function, problem.planted[0]).lower : coefficient();
    const Relation relation = std::array{Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER_EQUAL,
                                         Relation::GREATER}[m_random.integer(0, 3)];
    problem.system.add(function, relation);
    problem.name += ", inequality";
    std::erase_if(problem.planted, [&](const Point& point) {
      return !is_satisfied(relation, CGAL::sign(value_at(function, point).lower));
    });
  }
};

} // namespace solver_benchmark

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_SOAK_SYSTEMS_H
