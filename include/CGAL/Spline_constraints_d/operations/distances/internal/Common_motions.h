// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_MOTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_MOTIONS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
Whether some rotation, translation or helical motion moves surfaces along themselves, as it does with coaxial surfaces
of revolution: with the velocities b + a x p of its points p, it does where <N, b> + <p x N, a> = 0 for all points p
with their normals N. These are linear equations for a and b; as polynomials in two parameters, they hold everywhere if
they do on a grid with more values of each parameter than its degree.
*/
class Common_motions
{
  static constexpr std::size_t unknowns = 6;
  using Row = std::array<Exact_rational, unknowns>;

  std::vector<std::pair<std::size_t, Row>> m_rows; // with their pivots, where they are one

public:
  // `check` is called between points and may throw.
  void add(const Oriented_patch& patch, const std::function<void()>& check)
  {
    const auto degree = [&](int axis) {
      int result = patch.patch.weight().degree(axis), of_normal = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        result = (std::max)(result, patch.patch.numerators()[i].degree(axis));
        of_normal = (std::max)(of_normal, patch.normal[i].degree(axis));
      }
      return result + of_normal;
    };
    const std::array<std::vector<Exact_rational>, 2> breaks{patch.patch.breaks(0), patch.patch.breaks(1)};
    for (std::size_t i = 1; i < breaks[0].size(); ++i)
      for (std::size_t j = 1; j < breaks[1].size(); ++j)
        for (int k = 0; k <= degree(0); ++k)
          for (int l = 0; l <= degree(1); ++l) {
            if (are_none())
              return;
            check();
            add_point(patch,
                      {between(breaks[0][i - 1], breaks[0][i], k, degree(0)),
                       between(breaks[1][j - 1], breaks[1][j], l, degree(1))});
          }
  }

  bool are_none() const { return m_rows.size() == unknowns; }

private:
  static Exact_rational between(const Exact_rational& begin, const Exact_rational& end, int i, int number)
  {
    return Exact_rational(begin + (end - begin) * (i + 1) / (number + 2));
  }

  void add_point(const Oriented_patch& patch, const std::array<Exact_rational, 2>& at)
  {
    const std::array<Exact_rational, 3> p = patch.patch(at);
    std::array<Exact_rational, 3> n;
    for (std::size_t i = 0; i < 3; ++i)
      n[i] = patch.normal[i](at);
    Row row;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      row[i] = n[i];
      row[3 + i] = p[j] * n[k] - p[k] * n[j];
    }
    for (const auto& [pivot, known] : m_rows)
      if (const Exact_rational factor = row[pivot]; factor != 0)
        for (std::size_t i = 0; i < unknowns; ++i)
          row[i] -= factor * known[i];
    for (std::size_t pivot = 0; pivot < unknowns; ++pivot)
      if (const Exact_rational value = row[pivot]; value != 0) {
        for (Exact_rational& x : row)
          x /= value;
        m_rows.emplace_back(pivot, std::move(row));
        return;
      }
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_MOTIONS_H
