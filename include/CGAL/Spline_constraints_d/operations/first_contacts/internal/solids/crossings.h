// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CROSSINGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CROSSINGS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_element.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// Of functions on a part of their domain; a range may be one number.
inline Vector_bounds<3> bounds_on(Vector_of_functions<3> f, const std::vector<Parameter_range>& ranges)
{
  for (int axis = f[0].dimension(); axis-- > 0;)
    f = part_of<3>(std::move(f), axis, ranges[static_cast<std::size_t>(axis)]);
  return {Rational_interval(f[0].bounds()), Rational_interval(f[1].bounds()), Rational_interval(f[2].bounds())};
}

inline Vector_bounds<3> cross_product(const Vector_bounds<3>& a, const Vector_bounds<3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Bounds of a linear map M, by its columns, and of det(M) times the inverse of the transposed one.
class Linear_bounds_3
{
  using Columns = std::array<Vector_bounds<3>, 3>;

  Columns m_columns, m_normal_columns;

public:
  Linear_bounds_3(const Rational_motion_3& motion, const Parameter_range& time)
  {
    for (std::size_t k = 0; k < 3; ++k)
      m_columns[k] = bounds_on(motion.columns()[k], {time});
    for (std::size_t k = 0; k < 3; ++k)
      m_normal_columns[k] = cross_product(m_columns[(k + 1) % 3], m_columns[(k + 2) % 3]);
  }

  Vector_bounds<3> image(const Vector_bounds<3>& direction) const { return image(m_columns, direction); }
  Vector_bounds<3> image_of_normal(const Vector_bounds<3>& normal) const { return image(m_normal_columns, normal); }

private:
  static Vector_bounds<3> image(const Columns& columns, const Vector_bounds<3>& x)
  {
    Vector_bounds<3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = columns[0][i] * x[0] + columns[1][i] * x[1] + columns[2][i] * x[2];
    return result;
  }
};

// A part of an element.
struct Part_of_element
{
  const Solid_element& element;
  const std::vector<Parameter_range>& parameters;

  bool is_smooth() const { return element.part == Solid_part::FACE; }
  bool is_on_edge() const { return element.part == Solid_part::EDGE && element.dimension() == 1; }
  Vector_bounds<3> normal() const { return bounds_on(element.normals, parameters); }
  Vector_bounds<3> tangent() const { return bounds_on(tangents_of_curve(element.map), parameters); }
};

// Whether it is certain that the boundaries cross where they have a common point: one of them has a tangent plane, and
// the other one a tangent that is not in it. Then the solids overlapped before, and do so after.
inline bool cross_for_certain(const Part_of_element& moving, const Part_of_element& fixed, const Linear_bounds_3& map)
{
  if (moving.is_smooth() && fixed.is_smooth())
    return !may_be_parallel(map.image_of_normal(moving.normal()), fixed.normal());
  if (moving.is_smooth() && fixed.is_on_edge())
    return !has_zero(dot(map.image_of_normal(moving.normal()), fixed.tangent()));
  if (moving.is_on_edge() && fixed.is_smooth())
    return !has_zero(dot(fixed.normal(), map.image(moving.tangent())));
  return false;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_CROSSINGS_H
