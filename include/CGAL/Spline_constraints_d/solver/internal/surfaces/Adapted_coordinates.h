// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ADAPTED_COORDINATES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ADAPTED_COORDINATES_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Coordinates u = L (x - p) for the terms of second order of a polynomial f: those are a form in the first ones alone. The
planes where these are constant are orthogonal to the ones where the others are, as those coordinates fit both surfaces
well that touch each other.
*/
class Adapted_coordinates
{
  std::array<Exact_point, 3> m_rows; // L
  std::size_t m_rank = 0;            // number of the first ones

public:
  // `centred`: f, in x - p; `lengths`: all u are at most about 1 in a box of this size.
  Adapted_coordinates(const Power_polynomial& centred, const std::vector<double>& lengths)
  {
    std::vector<Exact_point> chosen;
    for (int j = 0; j < 3; ++j) {
      Exact_point row;
      for (int k = 0; k < 3; ++k)
        row.push_back(centred.derivative(j).derivative(k).constant_term());
      add(std::move(row), chosen);
    }
    m_rank = chosen.size();
    for (std::size_t j = 0; m_rank == 0 && j < 3; ++j) {
      Exact_point row(3, Exact_rational(0));
      row[j] = Exact_rational(1);
      add(std::move(row), chosen);
    }
    if (m_rank == 1)
      chosen.push_back(orthogonal_to(chosen[0]));
    if (chosen.size() == 2)
      chosen.push_back(cross_product(chosen[0], chosen[1]));
    for (std::size_t j = 0; j < 3; ++j)
      m_rows[j] = scaled(std::move(chosen[j]), lengths);
  }

  const std::array<Exact_point, 3>& rows() const { return m_rows; }

  // For the u, those of singular points that are met most often.
  std::vector<std::array<int, 3>> weights() const
  {
    switch (m_rank) {
    case 2:
      return {{3, 3, 2}, {2, 2, 1}, {5, 5, 2}, {3, 3, 1}};
    case 1:
      return {{3, 2, 2}, {2, 1, 1}};
    default:
      return {{1, 1, 1}};
    }
  }

  // f as a polynomial in the u.
  Power_polynomial changed(Power_polynomial centred) const
  {
    const std::array<Exact_point, 3> inverse = inverse_of(m_rows);
    for (int j = 0; j < 3; ++j) {
      Power_polynomial difference;
      for (int k = 0; k < 3; ++k)
        difference += Power_polynomial(inverse[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]) *
            Power_polynomial::variable(3 + k);
      centred = centred.substituted(j, difference);
    }
    for (int j = 0; j < 3; ++j)
      centred = centred.substituted(3 + j, Power_polynomial::variable(j));
    return centred;
  }

  // Of a box around p in which the sizes of all u are at most these.
  Exact_point distances_for(const std::array<Exact_rational, 3>& sizes) const
  {
    Exact_point result;
    for (std::size_t k = 0; k < 3; ++k) {
      std::optional<Exact_rational> least;
      for (std::size_t j = 0; j < 3; ++j) {
        const Exact_point& row = m_rows[j];
        if (CGAL::is_zero(row[k]))
          continue;
        const auto summands = 3 - std::count(row.begin(), row.end(), Exact_rational(0));
        Exact_rational own = sizes[j] / (CGAL::abs(row[k]) * Exact_rational(static_cast<int>(summands)));
        if (!least || own < *least)
          least = std::move(own);
      }
      result.push_back(*least);
    }
    return result;
  }

private:
  // If it is no combination of the others.
  static void add(Exact_point row, std::vector<Exact_point>& chosen)
  {
    std::vector<Exact_rational> matrix;
    for (const Exact_point& own : chosen)
      matrix.insert(matrix.end(), own.begin(), own.end());
    matrix.insert(matrix.end(), row.begin(), row.end());
    if (chosen.size() < 3 && !gauss_jordan(matrix, 3, 3, chosen.size() + 1, size_of_pivot).empty())
      chosen.push_back(std::move(row));
  }

  static Exact_point cross_product(const Exact_point& a, const Exact_point& b)
  {
    Exact_point result;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      result.emplace_back(a[k] * b[l] - a[l] * b[k]);
    }
    return result;
  }

  static Exact_point orthogonal_to(const Exact_point& row)
  {
    const auto size = [](const Exact_rational& x, const Exact_rational& y) { return CGAL::abs(x) < CGAL::abs(y); };
    Exact_point axis(3, Exact_rational(0));
    axis[static_cast<std::size_t>(std::min_element(row.begin(), row.end(), size) - row.begin())] = Exact_rational(1);
    return cross_product(row, axis);
  }

  static Exact_point scaled(Exact_point row, const std::vector<double>& lengths)
  {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
      size += std::abs(CGAL::to_double(row[k])) * lengths[k];
    for (Exact_rational& x : row)
      x *= power_of_two(-std::ilogb(size));
    return row;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ADAPTED_COORDINATES_H
