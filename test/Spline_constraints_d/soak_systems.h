// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_SYSTEMS_H

#include "planted_multiple_roots.h"
#include "planted_simple_roots.h"

#include <CGAL/Spline_constraints_d/solver/internal/certification/point_values.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace solver_test {

struct Soak_system
{
  std::string kind;
  System system;
  std::vector<Point> planted;        // solutions, maybe not all
  bool are_all = false;              // there are no others
  std::vector<int> multiplicities{}; // of the planted solutions, if they are known
};

/*
A random system for every number, of these kinds, each in 1 to 4 unknowns and now and then with an inequality, on whose
boundary a solution may lie:

- dense, sparse: polynomials of degrees 1 to 6 with integer, dyadic and decimal coefficients;
- near-double: two curves that touch, or miss that by as little as 1e-12;
- simple roots: all are planted, some with gaps from 1e-3 to 1e-12;
- close roots: the same with gaps from 1e-12 to 1e-18, below what doubles tell apart;
- multiple roots: all are planted;
- on faces: all are simple and planted; one of them is in a corner of the domain, or on breaks of all functions;
- scales: the same with unknowns in units from 1e-12 to 1e12, far from zero, and equations likewise;
- splines: sums of splines in one unknown each;
- continuum: the equations have a common factor, of which points are planted;
- singular: quadratic forms, so that the Jacobian is zero at the solution;
- overdetermined: one equation more than unknowns.
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
    switch (m_random.integer(0, 11)) {
    case 0:
      return with_root("dense", n, dense(n));
    case 1:
      return with_root("sparse", n, sparse(n));
    case 2:
      return near_double();
    case 3:
      return simple_roots("simple roots", n, gap(3, 12));
    case 4:
      return simple_roots("close roots", n, gap(12, 18));
    case 5:
      return multiple_roots(n);
    case 6:
      return on_faces(n);
    case 7:
      return in_other_units(n);
    case 8:
      return splines(n);
    case 9:
      return continuum();
    case 10:
      return singular((std::max)(n, 2));
    default: {
      std::vector<Polynomial> functions = n < 3 ? dense(n) : sparse(n);
      functions.push_back(sparse(n).front());
      return with_root("overdetermined", n, functions);
    }
    }
  }

  Soak_system simple_roots(const std::string& kind, int n, const Rational& gap)
  {
    const Problem problem = Planted_simple_roots(m_seed, gap).make(n);
    return {kind, problem.system, problem.known, true};
  }

  Soak_system multiple_roots(int n)
  {
    const Planted_problem problem = Planted_multiple_roots(m_seed, 2).make(n, false);
    Soak_system result{"multiple roots", problem.system, {}, true};
    for (const Planted_root& root : problem.roots) {
      result.planted.push_back(root.point);
      result.multiplicities.push_back(root.is_on_break ? 0 : root.multiplicity);
    }
    return result;
  }

  // One of the solutions is a corner of the domain, or the functions have breaks there.
  Soak_system on_faces(int n)
  {
    const auto [problem, functions] = Planted_simple_roots(m_seed, gap(2, 9)).make_polynomials(n);
    std::vector<System::Domain> domain;
    for (int j = 0; j < n; ++j)
      domain.push_back(problem.system.domain(j));
    Soak_system result{"on faces", System(domain), problem.known, true};
    if (problem.known.empty()) {
      result.system = mixed_system(m_random, domain, {functions.begin(), functions.end()});
      return result;
    }
    const Point root = problem.known[m_random.integer(0, static_cast<int>(problem.known.size()) - 1)];
    const bool is_corner = m_random.chance(50);
    std::vector<SC::Spline_function> rows;
    for (int j = 0; j < n && is_corner; ++j)
      (m_random.chance(50) ? domain[j].first : domain[j].second) = root[j].lower;
    for (const Polynomial& function : functions) {
      const int axis = m_random.integer(0, n - 1);
      const auto& [lower, upper] = domain[axis];
      const Rational& at = root[axis].lower;
      if (is_corner || at <= lower || upper <= at || function.variables() != std::vector<int>{axis})
        rows.emplace_back(function);
      else
        rows.push_back(in_pieces(function, axis, {lower, at, upper}));
    }
    std::erase_if(result.planted, [&](const Point& point) { return !is_in(domain, point); });
    result.system = mixed_system(m_random, domain, std::move(rows));
    return result;
  }

  // x = unit * y + origin
  Soak_system in_other_units(int n)
  {
    const auto [problem, functions] = Planted_simple_roots(m_seed, gap(1, 6)).make_polynomials(n);
    std::vector<Rational> unit, origin;
    std::vector<Polynomial> replacement;
    std::vector<System::Domain> domain;
    const Rational common = power(10, m_random.integer(-12, 12));
    const bool is_common = m_random.chance(50);
    for (int j = 0; j < n; ++j) {
      unit.push_back(is_common ? common : power(10, m_random.integer(-12, 12)));
      origin.push_back(m_random.chance(30) ? Rational(m_random.integer(-1000000, 1000000)) : Rational(0));
      replacement.push_back(unit[j] * Polynomial::variable(j) + origin[j]);
      const auto& [lower, upper] = problem.system.domain(j);
      domain.emplace_back((lower - origin[j]) / unit[j], (upper - origin[j]) / unit[j]);
    }
    std::vector<Point> planted;
    for (const Point& root : problem.known) {
      Point& point = planted.emplace_back();
      for (int j = 0; j < n; ++j)
        point.emplace_back(Rational((root[j].lower - origin[j]) / unit[j]));
    }
    std::vector<SC::Spline_function> rows;
    for (const Polynomial& function : functions)
      rows.emplace_back(power(10, m_random.integer(-12, 12)) * composed(function, replacement));
    return {"scales", mixed_system(m_random, domain, std::move(rows)), std::move(planted), true};
  }

  // A line or a conic, times equations with planted solutions; points of the line are planted, too.
  Soak_system continuum()
  {
    const std::vector<Polynomial> x = variables(2);
    const auto [problem, functions] = Planted_simple_roots(m_seed, gap(1, 6)).make_polynomials(2);
    const Rational u = place(), v = place(), a(m_random.integer(-3, 3)), b(m_random.integer(1, 3));
    Polynomial factor = a * (x[0] - u) + b * (x[1] - v);
    Soak_system result{"continuum", problem.system, problem.known};
    if (m_random.chance(70))
      for (int k = -6; k <= 6; ++k)
        result.planted.push_back({Rational(u + b * k), Rational(v - a * k)});
    else
      factor = square(x[0] - u) + square(x[1] - v) - m_random.ratio(1, 9, 3);
    const std::vector<System::Domain> domain{problem.system.domain(0), problem.system.domain(1)};
    std::erase_if(result.planted, [&](const Point& point) { return !is_in(domain, point); });
    for (const Polynomial& function : functions)
      result.system.add(factor * function, Relation::EQUAL);
    return result;
  }

  // Squares of linear forms that vanish at a point, and products of three of them.
  Soak_system singular(int n)
  {
    Point root;
    std::vector<System::Domain> domain;
    std::vector<Polynomial> forms, functions;
    for (int j = 0; j < n; ++j) {
      const Rational x = place();
      root.emplace_back(x);
      domain.emplace_back(Rational(x - m_random.ratio(1, 8, 3)), Rational(x + m_random.ratio(1, 8, 3)));
      forms.push_back(Polynomial::variable(j) - x);
      if (j > 0 && m_random.chance(50))
        forms.back() += Rational(m_random.integer(-2, 2)) * forms[0];
    }
    for (int i = 0; i < n; ++i)
      functions.push_back(square(forms[i]) +
                          coefficient() * forms[i] * forms[(i + 1) % n] * forms[m_random.integer(0, n - 1)]);
    for (int i = 1; i < n; ++i)
      functions[i] += m_random.ratio(-3, 3, 3) * functions[0];
    return {"singular", with_equalities(System(domain), functions), {root}};
  }

  Rational gap(int least, int most) { return power(10, -m_random.integer(least, most)); }

  static Rational power(int base, int exponent)
  {
    Rational result(1);
    for (int i = 0; i < std::abs(exponent); ++i)
      result *= base;
    return exponent < 0 ? Rational(Rational(1) / result) : result;
  }

  // An integer, a dyadic or a decimal number.
  Rational coefficient()
  {
    const int numerator = m_random.integer(-99, 99);
    switch (m_random.integer(0, 2)) {
    case 0:
      return Rational(numerator);
    case 1:
      return fraction(numerator, 1 << m_random.integer(0, 7));
    default:
      return fraction(numerator, std::array{1, 10, 100, 1000}[m_random.integer(0, 3)]);
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
  Soak_system with_root(const std::string& kind, int n, const std::vector<Polynomial>& functions)
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
    return {kind, std::move(system), {root}};
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
    for (std::size_t i = problem.planted.size(); i-- > 0;)
      if (!is_satisfied(relation, CGAL::sign(value_at(function, problem.planted[i]).lower))) {
        problem.planted.erase(problem.planted.begin() + static_cast<std::ptrdiff_t>(i));
        if (!problem.multiplicities.empty())
          problem.multiplicities.erase(problem.multiplicities.begin() + static_cast<std::ptrdiff_t>(i));
      }
  }
};

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_SOAK_SYSTEMS_H
