// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_MOVING_SPACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_MOVING_SPACE_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_element.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/identities.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A point or a plane in homogeneous coordinates.
struct Homogeneous_expression
{
  Vector_expression<3> x;
  Expression w;
};

// A function of the time as a formula.
inline Expression formula_of(const Exact_function& f, const Unknown& time) { return Spline_map<1, 2>({f, f})(time)[0]; }

// A motion x -> (M x + c) / w in a part of the time.
class Moving_space
{
  Parameter_range m_time;
  std::array<Vector_of_functions<3>, 4> m_columns; // of M, and c
  Exact_function m_weight;
  std::array<Vector_of_functions<3>, 3> m_normal_columns; // of det(M) times the inverse of the transposed of M
  std::array<Box_3, 4> m_entries;                         // of M / w, and c / w

public:
  Moving_space(const Rational_motion_3& motion, const Parameter_range& time)
    : m_time(time), m_weight(part_of(motion.weight(), 0, time))
  {
    const Rational_interval weights(m_weight.bounds());
    for (std::size_t k = 0; k < 4; ++k) {
      m_columns[k] = part_of<3>(motion.columns()[k], 0, time);
      for (std::size_t i = 0; i < 3; ++i)
        // The control points of the weight may have both signs, though it has not.
        m_entries[k][i] = weights.lower > 0 ? interval_around(Rational_interval(m_columns[k][i].bounds()) / weights)
                                            : any_number<Interval>();
    }
    for (std::size_t k = 0; k < 3; ++k)
      m_normal_columns[k] = cross_of(m_columns[(k + 1) % 3], m_columns[(k + 2) % 3]);
  }

  const Parameter_range& time() const { return m_time; }
  const Exact_function& weight() const { return m_weight; }

  // A box around the images of the points of a box; with upward rounding.
  Box_3 image(const Box_3& box) const
  {
    Box_3 result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = m_entries[0][i] * box[0] + m_entries[1][i] * box[1] + m_entries[2][i] * box[2] + m_entries[3][i];
    return result;
  }

  // w times the image of a point in homogeneous coordinates; of a derivative of one, too.
  Homogeneous_expression image(const Homogeneous_expression& point, const Unknown& time) const
  {
    return {combined(m_columns, point.x, time) + column(m_columns[3], time) * point.w,
            formula_of(m_weight, time) * point.w};
  }

  // w times the image of a direction.
  Vector_expression<3> image_of_direction(const Vector_expression<3>& direction, const Unknown& time) const
  {
    return combined(m_columns, direction, time);
  }

  // A multiple of the image of a normal vector; its sign is that of the determinant of M.
  Vector_expression<3> image_of_normal(const Vector_expression<3>& normal, const Unknown& time) const
  {
    return combined(m_normal_columns, normal, time);
  }

  // @{ The same of given points, directions and normals, as functions of the time.
  Vector_of_functions<3> image_of_point(const Exact_vector& x) const // times w
  {
    Vector_of_functions<3> result = image_of_direction(x);
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = result[i] + m_columns[3][i];
    return result;
  }
  Vector_of_functions<3> image_of_direction(const Exact_vector& x) const { return combined(m_columns, x); }
  Vector_of_functions<3> image_of_normal(const Exact_vector& x) const { return combined(m_normal_columns, x); }
  // @}

  // Whether the plane through a fixed point with a normal is the same at all times, seen from the moving space.
  bool keeps_fixed_plane(const Exact_vector& point, const Exact_vector& normal) const
  {
    std::array<Exact_function, 4> plane;
    for (std::size_t k = 0; k < 4; ++k)
      plane[k] = m_columns[k][0] * normal[0] + m_columns[k][1] * normal[1] + m_columns[k][2] * normal[2];
    plane[3] = plane[3] - m_weight * exact_dot(normal, point);
    return is_direction_constant(plane);
  }

  // Whether a moving plane is the same at all times.
  bool keeps_moving_plane(const Exact_vector& point, const Exact_vector& normal) const
  {
    const Vector_of_functions<3> n = image_of_normal(normal), x = image_of_point(point);
    return is_direction_constant(
        {n[0] * m_weight, n[1] * m_weight, n[2] * m_weight, n[0] * x[0] + n[1] * x[1] + n[2] * x[2]});
  }

  static Vector_of_functions<3> cross_of(const Vector_of_functions<3>& a, const Vector_of_functions<3>& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

private:
  // Whether the functions are multiples of each other by numbers.
  static bool is_direction_constant(const std::array<Exact_function, 4>& f)
  {
    const std::array<Exact_rational, 1> begin{f[0].domain(0).first};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (!vanishes(f[i] * f[k](begin) - f[k] * f[i](begin)))
          return false;
    return true;
  }

  static Vector_expression<3> column(const Vector_of_functions<3>& f, const Unknown& time)
  {
    return Spline_map<1, 3>(f)(time);
  }

  template <class Columns>
  static Vector_expression<3> combined(const Columns& columns, const Vector_expression<3>& x, const Unknown& time)
  {
    return column(columns[0], time) * x[0] + column(columns[1], time) * x[1] + column(columns[2], time) * x[2];
  }

  template <class Columns>
  static Vector_of_functions<3> combined(const Columns& columns, const Exact_vector& x)
  {
    Vector_of_functions<3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = columns[0][i] * x[0] + columns[1][i] * x[1] + columns[2][i] * x[2];
    return result;
  }
};

inline Exact_function dot_of(const Vector_of_functions<3>& f, const Exact_vector& x)
{
  return f[0] * x[0] + f[1] * x[1] + f[2] * x[2];
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_MOVING_SPACE_H
