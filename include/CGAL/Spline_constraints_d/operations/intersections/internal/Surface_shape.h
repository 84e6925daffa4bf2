// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H

#include <CGAL/Spline_constraints_d/function/internal/Values_at_point.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/surface_shapes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A surface, parametric or implicit, in exact numbers.
struct Surface_shape
{
  std::optional<Spline_patch<3>> patch;   // the parametric one
  std::array<Bspline_function<double>, 4> rounded = {};   // its numerators and weight

  Power_polynomial polynomial = {};               // the implicit one
  std::optional<Vector_bounds<3>> box = {};       // has all of it; none: it is unbounded
  bool ends_at_box = false;                       // or it may go on beyond the box

  explicit Surface_shape(Spline_patch<3> surface);

  explicit Surface_shape(Power_polynomial f) : polynomial(std::move(f)) {}

  Surface_shape(const Implicit_surface_3& surface, bool ends)
    : polynomial(surface.polynomial()), box(Vector_bounds<3>()), ends_at_box(ends)
  {
    for (int i = 0; i < 3; ++i)
      (*box)[i] = Rational_interval(surface.box()[i]);
  }

  // A box that has all points; none of an unbounded surface.
  std::optional<Vector_bounds<3>> bounds() const
  {
    return !patch ? box : is_in_hull() ? hull_of_control_points() : patch->values();
  }

  // Whether its zeros in other bounds are not all points of the surface.
  bool ends_within(const Vector_bounds<3>& other) const;

  // \pre It is parametric.
  std::array<Exact_rational, 3> point(const std::vector<Exact_rational>& parameters) const
  {
    return (*patch)(parameters);
  }

  std::array<double, 3> point(std::vector<double> parameters) const;

private:
  // Whether all control weights are positive.
  bool is_in_hull() const { return patch->is_rational() && patch->weight().bounds().first > 0; }

  Vector_bounds<3> hull_of_control_points() const;
};

CGAL_SPLINE_CONSTRAINTS_INLINE Shape shape_of_map(const Exact_map<3>& surface)
{
  return std::make_shared<const Surface_shape>(Spline_patch<3>(surface));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Shape shape_of_plane(const std::array<Exact_rational, 4>& coefficients)
{
  Power_polynomial f = linear_polynomial<4>(coefficients);
  if (f.is_constant())
    throw Invalid_input("intersection_curves: the plane is degenerate");
  return std::make_shared<const Surface_shape>(std::move(f));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Shape shape_of_sphere(const std::array<Exact_rational, 3>& center,
                                                     const Exact_rational& squared_radius)
{
  return std::make_shared<const Surface_shape>(implicit_sphere<3>(center, squared_radius), false);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Shape shape_of_implicit_surface(const Implicit_hypersurface<3>& surface)
{
  return std::make_shared<const Surface_shape>(surface, true);
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Surface_shape::Surface_shape(Spline_patch<3> surface) : patch(std::move(surface))
{
  const auto to_double = [](const Exact_function& f) {
    return f.converted<double>([](const Exact_rational& x) { return to_nearest_double(x); });
  };
  for (int i = 0; i < 3; ++i)
    rounded[i] = to_double(patch->numerators()[i]);
  rounded[3] = to_double(patch->weight());
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Surface_shape::ends_within(const Vector_bounds<3>& other) const
{
  for (int i = 0; ends_at_box && i < 3; ++i)
    if (other[i].lower < (*box)[i].lower || (*box)[i].upper < other[i].upper)
      return true;
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<double, 3> Surface_shape::point(std::vector<double> parameters) const
{
  for (int axis = 0; axis < 2; ++axis) { // rounding may lead out of the domain
    const auto [begin, end] = rounded[0].domain(axis);
    parameters[axis] = (std::min)((std::max)(parameters[axis], begin), end);
  }
  const Values_at_point<double> value(rounded[0], parameters);
  const double weight = patch->is_rational() ? value(rounded[3]) : 1;
  return {value(rounded[0]) / weight, value(rounded[1]) / weight, value(rounded[2]) / weight};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Vector_bounds<3> Surface_shape::hull_of_control_points() const
{
  const std::vector<Exact_rational>& weights = patch->weight().coefficients();
  Vector_bounds<3> result;
  for (int i = 0; i < 3; ++i) {
    std::vector<Exact_rational> coordinates;
    for (std::size_t k = 0; k < weights.size(); ++k)
      coordinates.emplace_back(patch->numerators()[i].coefficients()[k] / weights[k]);
    result[i] = Rational_interval(least_and_greatest(coordinates));
  }
  return result;
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H
