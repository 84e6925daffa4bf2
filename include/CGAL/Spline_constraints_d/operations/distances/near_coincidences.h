// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_NEAR_COINCIDENCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_NEAR_COINCIDENCES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/Special_point_kind.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_coincidences.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/near_special_points.h>
#endif

#include <cmath>
#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

Two special points of curves or surfaces that nearly are the same point, but are not.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Near_coincidence
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  internal::Distances::Found_coincidence<d> m_found;

public:
  //! a pair of points that an operation has found.
  explicit Near_coincidence(internal::Distances::Found_coincidence<d> found) : m_found(std::move(found)) {}

  //! the index of the object that the first (0) or second (1) point belongs to: 0 or 1 of two operands.
  std::size_t object(std::size_t i) const { return m_found.points[i].object; }

  //! what the point is on its object.
  Special_point_kind kind(std::size_t i) const { return m_found.points[i].kind; }

  //! its parameter, exactly; along the edge that a pole consists of, all of them.
  const Range& parameter_range(std::size_t i, std::size_t axis = 0) const { return m_found.points[i].parameters[axis]; }

  //! the point: exact if the kernel is.
  Point point(std::size_t i) const { return internal::kernel_object<Kernel, Point>(m_found.points[i].point); }

  //! the square of the distance of both points, exactly. It is positive.
  const Exact_rational& squared_distance() const { return m_found.squared_distance; }

  //! the distance lies between these doubles.
  std::pair<double, double> distance_range() const
  {
    return internal::Distances::root_range(std::pair(squared_distance(), squared_distance()));
  }
};

namespace internal {
namespace Distances {

template <SplineKernel Kernel, int d>
Answer_list<Near_coincidence<Kernel, d>> near_coincidences_of_maps(const std::vector<Exact_map<d>>& objects,
                                                                   bool are_different, std::optional<double> tolerance,
                                                                   const Solver_options& options)
{
  if (tolerance && !(0 <= *tolerance && std::isfinite(*tolerance)))
    throw Invalid_input("near_coincidences: the tolerance is " + std::to_string(*tolerance) +
                        ", it has to be a number that is not negative");
  Found_coincidences<d> found = near_coincidences_of<d>(objects, are_different, tolerance, options);
  std::vector<Near_coincidence<Kernel, d>> pairs;
  for (Found_coincidence<d>& pair : found.pairs)
    pairs.emplace_back(std::move(pair));
  return {std::move(pairs), std::move(found.undecided), found.summary};
}

template <class Object>
concept Has_special_points = Common::Spline_operand<Object>::number_of_parameters >= 1;

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

special points of two curves or surfaces that are the same point but for the last digits of coordinates: all pairs of
one point of each whose distance is positive, and at most the tolerance.

Special points are ends, breaks, corners, seams and poles, see `Special_point_kind`. Curves that end in the same point
of a drawing, written with rounded numbers, do not meet there, or meet next to it, and `intersections()` says so. This
says what was meant, perhaps: it is information beside the exact answers, and changes none of them. Points that are
exactly the same are not named; `intersections()` has them. `with_exact_joints()` and `with_exact_primitives()` move
such points onto each other.

\tparam A,B models of `ParametricCurve_2`, `ParametricCurve_3` or `ParametricSurface_3`, of the same kernel in the
same dimension.
\param a the first object.
\param b the second object.
\param tolerance the greatest distance; without one, \f$2^{-48}\f$ of the greatest coordinate of a control point,
sixteen units in the last place, but that weights that differ make it smaller.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\returns a list of `Near_coincidence`, in the order of the parameters of `a`. When the run was stopped, there is none,
and both objects are undecided.
\throws Invalid_input when the tolerance is negative or not finite, a weight is not proved to have one sign, or an
option makes no sense.

Complexity: \f$O(n \log n + k)\f$ for \f$n\f$ special points, each evaluated exactly, of which \f$k\f$ pairs are near.
*/
template <class A, class B>
requires internal::Common::Spline_operands<A, B> && internal::Distances::Has_special_points<A> &&
    internal::Distances::Has_special_points<B>
auto near_coincidences(const A& a, const B& b, std::optional<double> tolerance = {}, const Solver_options& options = {})
{
  using Operand = internal::Common::Spline_operand<A>;
  constexpr int d = Operand::dimension;
  return internal::Distances::near_coincidences_of_maps<typename Operand::Kernel, d>(
      {Operand::map(a), internal::Common::Spline_operand<B>::map(b)}, true, tolerance, options);
}

/*!
\ingroup PkgSplineConstraintsDDistances

the same of all pairs of special points in a range of objects of one type, those of one and the same object included: a
curve that nearly closes, an edge of a surface that nearly is a pole.
*/
template <std::ranges::input_range Objects>
requires internal::Distances::Has_special_points<std::ranges::range_value_t<Objects>>
auto near_coincidences(const Objects& objects, std::optional<double> tolerance = {}, const Solver_options& options = {})
{
  using Operand = internal::Common::Spline_operand<std::ranges::range_value_t<Objects>>;
  constexpr int d = Operand::dimension;
  std::vector<internal::Common::Exact_map<d>> maps;
  for (const auto& object : objects)
    maps.push_back(Operand::map(object));
  return internal::Distances::near_coincidences_of_maps<typename Operand::Kernel, d>(maps, false, tolerance, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_NEAR_COINCIDENCES_H
