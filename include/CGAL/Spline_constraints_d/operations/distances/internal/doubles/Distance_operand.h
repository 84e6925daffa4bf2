// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_OPERAND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_OPERAND_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel, int d>
class Bspline_curve;
template <SplineKernel Kernel>
class Bspline_surface_3;

namespace internal {

template <class NT, int d>
class Homogeneous_spline;

namespace Distances {

template <int d>
class Rounded_spline;

// An operand whose coordinates are doubles or exact: a spline, which may have been prepared, or else a point.
template <class NT, int d>
struct Distance_operand
{
  const Homogeneous_spline<NT, d>* spline = nullptr;
  const Rounded_spline<d>* rounded = nullptr;
  std::array<NT, d> point{};
};

// How operands are taken that have coordinates. Other models of parametric curves and surfaces have not.
template <class Object>
struct Distance_operand_of
{};

template <SplineKernel Kernel>
struct Distance_operand_of<CGAL::Point_2<Kernel>>
{
  using NT = Spline_number<typename Kernel::FT>;
  static Distance_operand<NT, 2> get(const CGAL::Point_2<Kernel>& p)
  {
    return {nullptr, nullptr, {converted_number<NT>(p.x()), converted_number<NT>(p.y())}};
  }
};

template <SplineKernel Kernel>
struct Distance_operand_of<CGAL::Point_3<Kernel>>
{
  using NT = Spline_number<typename Kernel::FT>;
  static Distance_operand<NT, 3> get(const CGAL::Point_3<Kernel>& p)
  {
    return {nullptr, nullptr, {converted_number<NT>(p.x()), converted_number<NT>(p.y()), converted_number<NT>(p.z())}};
  }
};

template <SplineKernel Kernel, int d>
struct Distance_operand_of<Bspline_curve<Kernel, d>>
{
  using NT = Spline_number<typename Kernel::FT>;
  static Distance_operand<NT, d> get(const Bspline_curve<Kernel, d>& curve)
  {
    return {&curve.representation(), nullptr, {}};
  }
};

template <SplineKernel Kernel>
struct Distance_operand_of<Bspline_surface_3<Kernel>>
{
  using NT = Spline_number<typename Kernel::FT>;
  static Distance_operand<NT, 3> get(const Bspline_surface_3<Kernel>& surface)
  {
    return {&surface.representation(), nullptr, {}};
  }
};

template <class Object>
concept Has_coordinates = requires(const Object& object)
{
  Distance_operand_of<Object>::get(object);
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_DISTANCE_OPERAND_H
