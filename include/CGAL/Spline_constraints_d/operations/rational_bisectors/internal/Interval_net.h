// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_INTERVAL_NET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_INTERVAL_NET_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// Of an interval, with rounding upwards, which `CGAL::sqrt()` changes and restores, in most of its time.
inline CGAL::Interval_nt<false> square_root(const CGAL::Interval_nt<false>& x)
{
  const double least = std::sqrt((std::max)(x.inf(), 0.0));
  return {-((0x1p-51 - 1) * least), std::sqrt((std::max)(x.sup(), 0.0))};
}

// The Bernstein coefficients of a polynomial in two parameters as intervals. Used with rounding upwards.
class Interval_net
{
public:
  using Interval = CGAL::Interval_nt<false>;

private:
  std::array<int, 2> m_degrees;
  std::vector<Interval> m_values; // row-major

public:
  explicit Interval_net(const Bernstein_tensor<Exact_rational>& f) : m_degrees{f.degree(0), f.degree(1)}
  {
    for (const Exact_rational& c : f.coefficients())
      m_values.push_back(Interval(to_double_interval(c)));
  }

  static Interval_net constant(double value)
  {
    return Interval_net(Bernstein_tensor<Exact_rational>::constant(2, Exact_rational(value)));
  }

  const std::vector<Interval>& values() const { return m_values; }
  int degree(std::size_t axis) const { return m_degrees[axis]; }

  // Adds a multiple of another polynomial of the same degrees.
  void add(const Interval& factor, const Interval_net& other)
  {
    for (std::size_t k = 0; k < m_values.size(); ++k)
      m_values[k] += factor * other.m_values[k];
  }

  // An upper bound of the least value over the unit box: that in one of its corners.
  double least_corner() const
  {
    const std::size_t columns = static_cast<std::size_t>(m_degrees[1]) + 1, size = m_values.size();
    return (std::min)(
        {m_values[0].sup(), m_values[columns - 1].sup(), m_values[size - columns].sup(), m_values[size - 1].sup()});
  }

  // Bounds of a quotient of polynomials of the same degrees, the second one without zeros in its coefficients.
  static Interval quotients(const Interval_net& f, const Interval_net& g)
  {
    Interval result = f.m_values[0] / g.m_values[0];
    for (std::size_t k = 1; k < f.m_values.size(); ++k) {
      const Interval x = f.m_values[k] / g.m_values[k];
      result = Interval((std::min)(result.inf(), x.inf()), (std::max)(result.sup(), x.sup()));
    }
    return result;
  }

  // The value at a point.
  Interval operator()(double u, double v) const { return restricted(0, u, u).restricted(1, v, v).m_values.front(); }

  // An upper bound of |f - w L| for a function with three coordinates f and the bilinear function L with these values
  // at the corners (0,0), (0,1), (1,0), (1,1): of the Bernstein coefficients of the next higher degree.
  static double distance(const std::array<const Interval_net*, 3>& f, const Interval_net& w,
                         const std::array<std::array<double, 3>, 4>& corners)
  {
    const int p = w.m_degrees[0] + 1, q = w.m_degrees[1] + 1;
    Interval greatest(0);
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        Interval square(0);
        for (std::size_t c = 0; c < 3; ++c) {
          Interval sum(0);
          for (const int a : {0, 1})
            for (const int b : {0, 1}) {
              const int factor = (a == 1 ? i : p - i) * (b == 1 ? j : q - j);
              if (factor == 0)
                continue;
              const std::size_t k = static_cast<std::size_t>((i - a) * q + j - b);
              sum += Interval(factor) *
                  (f[c]->m_values[k] - w.m_values[k] * Interval(corners[static_cast<std::size_t>(2 * a + b)][c]));
            }
          square += CGAL::square(sum);
        }
        greatest = Interval((std::max)(greatest.sup(), square.sup()));
      }
    return (square_root(greatest) / Interval(p * q)).sup();
  }

  // Bounds of the polynomial over the unit box.
  Interval bounds() const
  {
    double least = m_values.front().inf(), greatest = m_values.front().sup();
    for (const Interval& x : m_values) {
      least = (std::min)(least, x.inf());
      greatest = (std::max)(greatest, x.sup());
    }
    return Interval(least, greatest);
  }

  // Over another range of an axis, which may lead out of the unit box: ends of the range that are not those of the box
  // are taken one after the other, by the algorithm of de Casteljau, in the order that keeps what is left longer.
  Interval_net restricted(int axis, double begin, double end) const
  {
    Interval_net result(*this);
    const Interval b(begin), e(end);
    if (begin < 0.5) {
      if (begin != 0)
        result.move_end(axis, 0, b);
      if (end != 1)
        result.move_end(axis, 1, (e - b) / (Interval(1) - b));
    } else {
      if (end != 1)
        result.move_end(axis, 1, e);
      result.move_end(axis, 0, b / e);
    }
    return result;
  }

private:
  void move_end(int axis, int end, const Interval& to)
  {
    const int n = m_degrees[static_cast<std::size_t>(axis)], columns = m_degrees[1] + 1;
    const int lines = axis == 0 ? columns : m_degrees[0] + 1, step = axis == 0 ? columns : 1;
    const Interval rest = Interval(1) - to;
    for (int line = 0; line < lines; ++line) {
      Interval* const values = m_values.data() + (axis == 0 ? line : line * columns);
      for (int round = 1; round <= n; ++round)
        if (end == 1)
          for (int i = n; i >= round; --i)
            values[i * step] = rest * values[(i - 1) * step] + to * values[i * step];
        else
          for (int i = 0; i <= n - round; ++i)
            values[i * step] = rest * values[i * step] + to * values[(i + 1) * step];
    }
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_INTERVAL_NET_H
