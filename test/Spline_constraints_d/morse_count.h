// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_MORSE_COUNT_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_MORSE_COUNT_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// The Euler characteristic of surfaces in the cube [-1,1]^3 from the critical points of a linear function, which the
// solver for points finds by proof: it knows nothing of surfaces.
namespace morse_count {

namespace SC = CGAL::Spline_constraints;
using Interval = CGAL::Interval_nt<false>;

// A polynomial of three unknowns with integer coefficients.
class Polynomial
{
  std::map<std::array<int, 3>, long> m_terms; // of degrees

public:
  // A sum of products of Chebyshev polynomials of all degrees up to a total one, at most four: so it changes its sign
  // everywhere in the cube, and has all coefficients.
  static Polynomial random(int degree, std::mt19937& generator)
  {
    static constexpr std::array<std::array<long, 5>, 5> chebyshev{
        {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {-1, 0, 2, 0, 0}, {0, -3, 0, 4, 0}, {1, 0, -8, 0, 8}}};
    std::uniform_int_distribution<long> any(-99, 99);
    Polynomial result;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k)
          result.add(any(generator), chebyshev[static_cast<std::size_t>(i)], chebyshev[static_cast<std::size_t>(j)],
                     chebyshev[static_cast<std::size_t>(k)]);
    return result;
  }

  Polynomial derivative(std::size_t i) const
  {
    Polynomial result;
    for (const auto& [degrees, coefficient] : m_terms)
      if (const long factor = degrees[i]; factor > 0) {
        std::array<int, 3> lower = degrees;
        --lower[i];
        result.m_terms[lower] += factor * coefficient;
      }
    return result;
  }

  Polynomial with_value(std::size_t i, int value) const
  {
    Polynomial result;
    for (const auto& [degrees, coefficient] : m_terms) {
      const long factor = degrees[i] % 2 != 0 ? value : 1; // the value is 1 or -1
      std::array<int, 3> others = degrees;
      others[i] = 0;
      result.m_terms[others] += factor * coefficient;
    }
    return result;
  }

  Polynomial times(long factor) const
  {
    Polynomial result = *this;
    for (auto& [degrees, coefficient] : result.m_terms)
      coefficient *= factor;
    return result;
  }

  Polynomial minus(const Polynomial& other) const
  {
    Polynomial result = *this;
    for (const auto& [degrees, coefficient] : other.m_terms)
      result.m_terms[degrees] -= coefficient;
    return result;
  }

  Interval operator()(const std::array<Interval, 3>& point) const
  {
    Interval result(0);
    for (const auto& [degrees, coefficient] : m_terms) {
      Interval term(static_cast<double>(coefficient));
      for (std::size_t i = 0; i < 3; ++i)
        for (int k = 0; k < degrees[i]; ++k)
          term *= point[i];
      result += term;
    }
    return result;
  }

  // Of these unknowns only, numbered anew.
  SC::Power_polynomial in_unknowns(const std::vector<std::size_t>& unknowns) const
  {
    SC::Power_polynomial result;
    for (const auto& [degrees, coefficient] : m_terms) {
      SC::Power_polynomial term(coefficient);
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        for (int k = 0; k < degrees[unknowns[i]]; ++k)
          term *= SC::Power_polynomial::variable(static_cast<int>(i));
      result += term;
    }
    return result;
  }

private:
  using Coefficients = std::array<long, 5>;

  // The product of a polynomial of each unknown.
  void add(long factor, const Coefficients& p, const Coefficients& q, const Coefficients& r)
  {
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < q.size(); ++j)
        for (std::size_t k = 0; k < r.size(); ++k)
          if (const long coefficient = factor * p[i] * q[j] * r[k]; coefficient != 0)
            m_terms[{static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)}] += coefficient;
  }
};

/*
Critical points of h = w . x on f = 0 in the cube, stratum by stratum. What is below a level of h changes there by one
less the characteristic of the directions on the surface in which h decreases:
- inside, by 1 at extrema and by -1 at saddles;
- on an arc in a face, where h grows from the arc into the surface, by 1 at minima and -1 at maxima of the arc, else 0;
- in the corner of two arcs, by 1 if h grows along both, else 0.
*/
class Morse_count
{
  Polynomial m_f;
  std::array<Polynomial, 3> m_gradient;
  std::array<std::array<Polynomial, 3>, 3> m_hessian;
  static constexpr std::array<long, 3> w{17, 23, 31};
  int m_sum = 0;

public:
  explicit Morse_count(const Polynomial& f) : m_f(f)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      m_gradient[i] = f.derivative(i);
      for (std::size_t k = 0; k < 3; ++k)
        m_hessian[i][k] = m_gradient[i].derivative(k);
    }
  }

  // None where a point or a sign is not certain.
  std::optional<int> operator()()
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    bool is_certain = count_inside();
    for (std::size_t a = 0; a < 3; ++a)
      for (const int s : {-1, 1}) {
        is_certain = is_certain && count_on_face(a, s);
        for (const int t : {-1, 1})
          is_certain = is_certain && count_on_edge((a + 1) % 3, (a + 2) % 3, s, t);
      }
    return is_certain ? std::optional(m_sum) : std::nullopt;
  }

private:
  using Point = std::array<Interval, 3>;

  // The solutions of equations in these unknowns, the other ones as in `point`; none when one is not certified.
  static std::optional<std::vector<Point>> solutions(const std::vector<Polynomial>& equations,
                                                     const std::vector<std::size_t>& unknowns, const Point& point)
  {
    SC::Constraint_system_d system(std::vector<SC::Constraint_system_d::Domain>(unknowns.size(), {-1, 1}));
    for (const Polynomial& equation : equations)
      system.add(equation.in_unknowns(unknowns), SC::Relation::EQUAL);
    CGAL::Protect_FPU_rounding<true> protection(CGAL_FE_TONEAREST);
    const auto found = SC::solve(system);
    if (!found.is_complete() || found.count(SC::Solution_kind::CERTIFIED) != found.size())
      return std::nullopt;
    std::vector<Point> result;
    for (const auto& solution : found) {
      result.push_back(point);
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        result.back()[unknowns[i]] = Interval(solution.box()[i].first, solution.box()[i].second);
    }
    return result;
  }

  static std::optional<bool> is_positive(const Interval& value)
  {
    return value.inf() > 0 ? std::optional(true) : value.sup() < 0 ? std::optional(false) : std::nullopt;
  }

  // Whether w_i f_k = w_k f_i.
  Polynomial parallel(std::size_t i, std::size_t k) const
  {
    return m_gradient[k].times(w[i]).minus(m_gradient[i].times(w[k]));
  }

  // The second derivative of f in two directions.
  Interval bend(const Point& p, const std::array<long, 3>& u, const std::array<long, 3>& v) const
  {
    Interval result(0);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        result += Interval(static_cast<double>(u[i] * v[k])) * m_hessian[i][k](p);
    return result;
  }

  bool count_inside()
  {
    const auto points = solutions({m_f, parallel(0, 1), parallel(0, 2)}, {0, 1, 2}, {});
    if (!points)
      return false;
    for (const Point& p : *points) {
      const std::array<long, 3> u{-w[1], w[0], 0}, v{-w[2], 0, w[0]};
      const auto is_extremum = is_positive(bend(p, u, u) * bend(p, v, v) - CGAL::square(bend(p, u, v)));
      if (!is_extremum)
        return false;
      m_sum += *is_extremum ? 1 : -1;
    }
    return true;
  }

  // x_a = s
  bool count_on_face(std::size_t a, int s)
  {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    Point place{};
    place[a] = Interval(s);
    const auto points = solutions({m_f.with_value(a, s), parallel(b, c).with_value(a, s)}, {b, c}, place);
    if (!points)
      return false;
    for (const Point& p : *points) {
      const Interval factor = Interval(static_cast<double>(w[b])) / m_gradient[b](p); // of the gradients in the face
      std::array<long, 3> along{};
      along[b] = -w[c];
      along[c] = w[b];
      const auto is_inward =
          is_positive(Interval(-s) * (Interval(static_cast<double>(w[a])) - factor * m_gradient[a](p)));
      const auto is_minimum = is_positive(-factor * bend(p, along, along));
      if (!is_inward || !is_minimum)
        return false;
      m_sum += !*is_inward ? 0 : *is_minimum ? 1 : -1;
    }
    return true;
  }

  // x_a = s, x_b = t
  bool count_on_edge(std::size_t a, std::size_t b, int s, int t)
  {
    const std::size_t c = 3 - a - b;
    Point place{};
    place[a] = Interval(s);
    place[b] = Interval(t);
    const auto points = solutions({m_f.with_value(a, s).with_value(b, t)}, {c}, place);
    if (!points)
      return false;
    for (const Point& p : *points) {
      const auto grows = [&](std::size_t i, int side) { // from the face of the other unknown, where i goes inward
        return is_positive(Interval(-side) *
                           (Interval(static_cast<double>(w[i])) -
                            Interval(static_cast<double>(w[c])) * m_gradient[i](p) / m_gradient[c](p)));
      };
      const auto first = grows(a, s), second = grows(b, t);
      if (!first || !second)
        return false;
      m_sum += *first && *second ? 1 : 0;
    }
    return true;
  }
};

// The surfaces f = 0 in the cube.
inline SC::Constraint_system_d surface_in_cube(const Polynomial& f)
{
  SC::Constraint_system_d result(std::vector<SC::Constraint_system_d::Domain>(3, {-1, 1}));
  result.add(f.in_unknowns({0, 1, 2}), SC::Relation::EQUAL);
  return result;
}

} // namespace morse_count

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_MORSE_COUNT_H
