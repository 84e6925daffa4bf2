// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PARAMETER_GRID_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PARAMETER_GRID_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

The points of a grid over ranges of parameters, with exact coordinates, one for each system of a family:
`grid[0]`, ..., `grid[grid.size() - 1]`. The last parameter runs fastest.
*/
class Parameter_grid
{
public:
  //! `count` values of one parameter, the same distance apart, with both ends; or `first` alone.
  struct Range
  {
    Exact_rational first, last;
    std::size_t count;
  };

private:
  std::vector<Range> m_ranges;

public:
  //! \throws Invalid_input when a range has no values.
  explicit Parameter_grid(std::vector<Range> ranges) : m_ranges(std::move(ranges))
  {
    for (std::size_t i = 0; i < m_ranges.size(); ++i)
      if (m_ranges[i].count == 0)
        throw Invalid_input("Parameter_grid: range " + std::to_string(i) + " has no values");
  }

  //! the number of points.
  std::size_t size() const
  {
    std::size_t result = 1;
    for (const Range& range : m_ranges)
      result *= range.count;
    return result;
  }

  //! the values of all parameters at a point.
  std::vector<Exact_rational> operator[](std::size_t point) const
  {
    std::vector<Exact_rational> result(m_ranges.size());
    for (std::size_t i = m_ranges.size(); i-- > 0; point /= m_ranges[i].count) {
      const auto& [first, last, count] = m_ranges[i];
      const std::size_t step = point % count;
      result[i] = first;
      if (step > 0)
        result[i] +=
            (last - first) * Exact_rational(static_cast<double>(step)) / Exact_rational(static_cast<double>(count - 1));
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PARAMETER_GRID_H
