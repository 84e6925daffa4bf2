// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_UNITED_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_UNITED_CURVES_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_divisions.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Found_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The curves of two systems, which meet in the solutions of both: these are singular points of the union. What is not
decided of them is undecided there.
*/
class United_curves
{
  std::array<Found_curves, 2> m_found;
  const Constraint_system_d& m_both;   // all equalities, which are polynomials
  std::vector<Undecided_box> m_undecided;

public:
  United_curves(Found_curves&& first, Found_curves&& second, const Constraint_system_d& both)
    : m_found{std::move(first), std::move(second)}, m_both(both)
  {}

  Found_curves operator()(const Solution_set_d<double>& common_points)
  {
    std::vector<std::array<std::size_t, 2>> same;
    for (const Solution_d<double>& point : common_points)
      if (point.kind() == Solution_kind::CERTIFIED)
        same.push_back(divided_at(place(point)));
      else
        m_undecided.push_back({point.exact_box(), {}, Undecided_reason::TOLERANCE});
    auto& [result, second] = m_found;
    const Vertex_indices places = result.merge(std::move(second));
    for (const auto& [i, other] : same) {
      result.vertices.identify(i, places[other]);
      result.for_each_index(
          [&, i = i, other = places[other]](std::size_t& index) { index = index == other ? i : index; });
    }
    result.undecided.insert(result.undecided.end(), m_undecided.begin(), m_undecided.end());
    return std::move(result);
  }

private:
  // The vertices of both that a point becomes.
  std::array<std::size_t, 2> divided_at(const Exact_ranges& point)
  {
    std::array<std::size_t, 2> result;
    for (const std::size_t k : {0, 1}) {
      Vertex_indices others(m_found[k].vertices.size());
      std::iota(others.begin(), others.end(), std::size_t(0));
      result[k] = m_found[k].vertices.add(Plane_point::singular(point));
      if (!Curve_divisions(m_found[k], 0, std::move(others)).add(result[k]))
        m_undecided.push_back({point, {}, Undecided_reason::TOLERANCE});
    }
    return result;
  }

  // The box of a solution; a rational point that is a singular vertex, if it is this one.
  Exact_ranges place(const Solution_d<double>& point) const
  {
    for (const Found_curves& found : m_found)
      for (std::size_t i = 0; i < found.vertices.size(); ++i)
        if (const Plane_point& vertex = found.vertices[i]; vertex.is_singular_point() &&
            is_within(vertex.box, point.exact_uniqueness_region()) && is_solution(vertex.box))
          return vertex.box;
    return point.exact_box();
  }

  bool is_solution(const Exact_ranges& box) const
  {
    std::vector<Exact_rational> point;
    for (const auto& [lower, upper] : box) {
      if (lower != upper)
        return false;
      point.push_back(lower);
    }
    return std::all_of(m_both.equalities().begin(), m_both.equalities().end(),
                       [&](const Spline_function& f) { return CGAL::is_zero(polynomial_at(f, point)(point)); });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_UNITED_CURVES_H
