// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_SIMPLE_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_SIMPLE_ROOTS_H

#include "random_systems.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace solver_test {

/*
Random systems of which all solutions are known, rational and simple: in the unknowns z_i they are products of linear
factors g_i(z_i), and of quadratic ones without real zeros; z is an affine, a triangular or a kinked map of x, and the
equations are mixed by a regular matrix. Some zeros are a small gap apart; the domain has some solutions on its faces,
in its corners and right outside.
*/
class Planted_simple_roots
{
  Random_numbers m_random;
  Rational m_gap;
  int m_dimension = 1;
  std::vector<std::vector<Rational>> m_zeros;   // of g_i
  std::vector<Polynomial> m_factors;            // g_i, in z_i

public:
  std::size_t on_faces = 0, in_corners = 0, close_pairs = 0, splines = 0;
  int highest_degree = 0;

  explicit Planted_simple_roots(std::uint64_t seed, const Rational& gap = fraction(1, 1000000000))
    : m_random(seed), m_gap(gap)
  {}

  Problem make(int n)
  {
    m_dimension = n;
    choose_zeros();
    switch (m_random.integer(0, 3)) {
    case 0: return changed("affine", affine_change(m_random, degrees()));
    case 1: return changed("triangular", triangular_change(m_random, degrees()));
    case 2: return changed("separable", identity(n));
    default: return kinked();
    }
  }

  // The same without breaks, as polynomials; the problem has no constraints.
  std::pair<Problem, std::vector<Polynomial>> make_polynomials(int n)
  {
    m_dimension = n;
    choose_zeros();
    const int kind = m_random.integer(0, 2);
    const Change_of_unknowns change = kind == 0 ? affine_change(m_random, degrees())
        : kind == 1                            ? triangular_change(m_random, degrees())
                                               : identity(n);
    std::vector<Point> roots;
    for (const Point& z : combinations())
      roots.push_back(change.inverse(z));
    const std::vector<System::Domain> domain = domain_around(m_random, roots);
    return {all_known("polynomials", System(domain), counted(domain, roots)), composed(m_factors, change.z)};
  }

private:
  Rational number() { return m_random.ratio(-36, 36, 12); }

  std::vector<int> degrees() const
  {
    std::vector<int> result;
    for (int i = 0; i < m_dimension; ++i)
      result.push_back(m_factors[i].degree(i));
    return result;
  }

  // Degrees up to 6, but not many solutions.
  void choose_zeros()
  {
    m_zeros.assign(m_dimension, {});
    int room = 20;
    for (int i : m_random.permutation(m_dimension)) {
      const int count = m_random.integer(1, (std::min)(room, m_dimension > 3 ? 3 : 6));
      room /= count;
      std::vector<Rational>& zeros = m_zeros[i];
      while (static_cast<int>(zeros.size()) < count) {
        const Rational z = number();
        if (std::find(zeros.begin(), zeros.end(), z) == zeros.end())
          zeros.push_back(z);
      }
      if (count > 1 && m_random.chance(25)) {
        zeros[0] = zeros[1] + m_gap;
        ++close_pairs;
      }
    }
    m_factors.clear();
    for (int i = 0; i < m_dimension; ++i) {
      const Polynomial z = Polynomial::variable(i);
      Polynomial g(1);
      for (const Rational& zero : m_zeros[i])
        g *= z - zero;
      if (m_zeros[i].size() < 5 && m_dimension < 4 && m_random.chance(20))
        g *= square(z - number()) + m_random.ratio(1, 5, 5);
      highest_degree = (std::max)(highest_degree, g.degree(i));
      m_factors.push_back(std::move(g));
    }
  }

  // All combinations of zeros.
  std::vector<Point> combinations() const
  {
    std::vector<Point> result{{}};
    for (const std::vector<Rational>& zeros : m_zeros) {
      std::vector<Point> longer;
      for (const Point& point : result)
        for (const Rational& zero : zeros) {
          longer.push_back(point);
          longer.back().emplace_back(zero);
        }
      result = std::move(longer);
    }
    return result;
  }

  // Those in the domain.
  std::vector<Point> counted(const std::vector<System::Domain>& domain, const std::vector<Point>& roots)
  {
    std::vector<Point> known;
    for (const Point& root : roots)
      if (is_in(domain, root)) {
        const int faces = count_faces(domain, root);
        on_faces += faces > 0;
        in_corners += m_dimension > 1 && faces == m_dimension;
        known.push_back(root);
      }
    return known;
  }

  Problem problem(const std::string& name, const std::vector<System::Domain>& domain, const std::vector<Point>& roots,
                  std::vector<SC::Spline_function> functions)
  {
    std::vector<Point> known = counted(domain, roots);
    return all_known(name, mixed_system(m_random, domain, std::move(functions)), std::move(known));
  }

  Problem changed(const std::string& name, const Change_of_unknowns& change)
  {
    std::vector<Point> roots;
    for (const Point& z : combinations())
      roots.push_back(change.inverse(z));
    const std::vector<Polynomial> functions = composed(m_factors, change.z);
    return problem(name, domain_around(m_random, roots), roots, {functions.begin(), functions.end()});
  }

  // z_i = x_i up to a break and increases with another slope from there on. The break may be a zero.
  Problem kinked()
  {
    ++splines;
    std::vector<Rational> kink, slope;
    for (int i = 0; i < m_dimension; ++i) {
      kink.push_back(m_random.chance(40) ? m_zeros[i][0] : number());
      slope.push_back(m_random.chance(30) ? Rational(1) : m_random.ratio(1, 6, 6));
    }
    std::vector<Point> roots;
    for (Point x : combinations()) {
      for (int i = 0; i < m_dimension; ++i)
        if (x[i].lower > kink[i])
          x[i] = kink[i] + (x[i].lower - kink[i]) / slope[i];
      roots.push_back(std::move(x));
    }
    const std::vector<System::Domain> domain = domain_around(m_random, roots);
    std::vector<SC::Spline_function> functions;
    for (int i = 0; i < m_dimension; ++i) {
      const auto& [lower, upper] = domain[i];
      std::vector<Polynomial> replacement(m_dimension);
      replacement[i] = kink[i] + slope[i] * (Polynomial::variable(i) - kink[i]);
      const Polynomial above = composed(m_factors[i], replacement);
      if (kink[i] <= lower)
        functions.push_back(in_pieces(above, i, {lower, upper}));
      else if (upper <= kink[i])
        functions.push_back(in_pieces(m_factors[i], i, {lower, upper}));
      else
        functions.push_back(piecewise(i, {lower, kink[i], upper}, {m_factors[i], above}));
    }
    return problem("kinked", domain, roots, std::move(functions));
  }
};

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_SIMPLE_ROOTS_H
