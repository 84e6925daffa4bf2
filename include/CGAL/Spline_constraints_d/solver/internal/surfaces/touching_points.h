// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point on a face of a cell where the curves on the face have a singular point without branches.
struct Touching_point
{
  Plane_point vertex;
  std::size_t index; // of the vertex
};

enum class Touching_position
{
  INSIDE,  // a surface touches the face from within the domain
  OUTSIDE, // from the other side: the point is all of it in the domain
  UNKNOWN
};

/*
The surface of polynomial equalities near a rational point at which they are zero: two of the n unknowns are parameters,
the others depend on them. The derivatives of the unknowns are given by the equalities, by a linear system for each
order.
*/
class Surface_near_point
{
  std::size_t m_dimension;
  std::vector<std::size_t> m_parameters;
  std::vector<int> m_row_of;          // of the unknowns that depend
  std::vector<Exact_rational> m_rows; // of the Jacobian, eliminated, with what that makes of the unit matrix
  std::array<std::vector<Exact_rational>, 3> m_curvatures; // of the equalities along the tangents

public:
  // How an unknown changes: along the two parameters, and with the second derivatives by both.
  struct Height
  {
    std::array<Exact_rational, 2> slope;
    std::array<Exact_rational, 3> curvature;

    bool is_tangent() const { return slope[0] == 0 && slope[1] == 0; }

    // That of the second derivatives, if they are definite; 0 else.
    int sign() const
    {
      const auto& [a, b, c] = curvature;
      return Exact_rational(a * c - b * b) > 0 ? (a > 0 ? 1 : -1) : 0;
    }
  };

  // None if the equalities are not zero, or not regular there.
  static std::optional<Surface_near_point> of(const std::vector<Power_polynomial>& equalities, const Exact_point& point)
  {
    Surface_near_point result(equalities, point);
    const bool are_zero = std::all_of(equalities.begin(), equalities.end(),
                                      [&](const Power_polynomial& equality) { return equality(point) == 0; });
    return are_zero && !result.m_row_of.empty() ? std::optional(std::move(result)) : std::nullopt;
  }

  Height height(std::size_t k) const
  {
    Height result;
    for (std::size_t a = 0; a < 2; ++a)
      result.slope[a] = tangent(a)[k];
    if (m_row_of[k] >= 0)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < m_curvatures[c].size(); ++i)
          result.curvature[c] -= row(m_row_of[k])[m_dimension + i] * m_curvatures[c][i];
    return result;
  }

private:
  Surface_near_point(const std::vector<Power_polynomial>& equalities, const Exact_point& point)
    : m_dimension(point.size())
  {
    const std::size_t n = m_dimension, m = equalities.size();
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        m_rows.push_back(equalities[i].derivative(static_cast<int>(j))(point));
      for (std::size_t k = 0; k < m; ++k)
        m_rows.emplace_back(k == i ? 1 : 0);
    }
    m_row_of = gauss_jordan(m_rows, n + m, n, m, size_of_pivot);
    if (m_row_of.empty())
      return;
    for (std::size_t j = 0; j < n; ++j)
      if (m_row_of[j] < 0)
        m_parameters.push_back(j);
    const Exact_point first = tangent(0), second = tangent(1);
    for (const Power_polynomial& equality : equalities) {
      m_curvatures[0].push_back(second_derivative(equality, point, first, first));
      m_curvatures[1].push_back(second_derivative(equality, point, first, second));
      m_curvatures[2].push_back(second_derivative(equality, point, second, second));
    }
  }

  const Exact_rational* row(int i) const { return m_rows.data() + static_cast<std::size_t>(i) * (2 * m_dimension - 2); }

  // The derivatives of all unknowns by a parameter.
  Exact_point tangent(std::size_t parameter) const
  {
    Exact_point result(m_dimension);
    for (std::size_t j = 0; j < m_dimension; ++j)
      if (m_row_of[j] >= 0)
        result[j] = -row(m_row_of[j])[m_parameters[parameter]];
    result[m_parameters[parameter]] = 1;
    return result;
  }

  static Exact_rational second_derivative(const Power_polynomial& function, const Exact_point& point,
                                          const Exact_point& a, const Exact_point& b)
  {
    Exact_rational result(0);
    for (std::size_t i = 0; i < point.size(); ++i)
      for (std::size_t j = 0; j < point.size(); ++j)
        if (a[i] != 0 && b[j] != 0)
          result += a[i] * b[j] * function.derivative(static_cast<int>(i)).derivative(static_cast<int>(j))(point);
    return result;
  }
};

/*
Where surfaces lie beside the faces of the domain that a rational point is on, around which no curve on them ends. Near
it the surface is a disk, which has no other point on these faces, so that all or nothing of it lies in the domain. If
an unknown that is constant on one of several faces has a slope, the surface leaves the domain there. If not, and its
second derivatives are definite, it is on one side of the face.
*/
inline Touching_position position_of(const Touching_point& point, const Constraint_system_d& system)
{
  const Plane_point& vertex = point.vertex;
  Exact_point place;
  std::vector<std::size_t> faces;
  for (std::size_t j = 0; j < vertex.box.size(); ++j) {
    const auto& [lower, upper] = vertex.box[j];
    const auto& [begin, end] = system.domain(static_cast<int>(j));
    const bool is_at_end = lower == begin || lower == end;
    if (lower != upper || (vertex.is_fixed[j] && !is_at_end))
      return Touching_position::UNKNOWN; // irrational, or on a break
    place.push_back(lower);
    if (is_at_end)
      faces.push_back(j);
  }
  std::vector<Power_polynomial> equalities;
  const Constraint_system_d polynomials = on_cell(system, vertex.box);
  for (const Spline_function& equality : polynomials.equalities())
    equalities.push_back(*restricted(equality, Partial_point(place.size())));
  const std::optional<Surface_near_point> surface = Surface_near_point::of(equalities, place);
  if (!surface)
    return Touching_position::UNKNOWN;
  Touching_position result = Touching_position::INSIDE;
  for (const std::size_t j : faces) {
    const Surface_near_point::Height height = surface->height(j);
    const bool is_lower_face = place[j] == system.domain(static_cast<int>(j)).first;
    if (!height.is_tangent())
      return faces.size() > 1 ? Touching_position::OUTSIDE : Touching_position::UNKNOWN;
    if (height.sign() == (is_lower_face ? -1 : 1))
      return Touching_position::OUTSIDE;
    if (height.sign() == 0)
      result = Touching_position::UNKNOWN;
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
