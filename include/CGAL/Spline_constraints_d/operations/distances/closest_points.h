// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CLOSEST_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CLOSEST_POINTS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/nearest_points_in_doubles.h>
#endif

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

A point of each of two operands, known by ranges of their parameters, and their distance.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Point_pair
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  using Parameter = internal::Distances::Located_parameter;

  Solution_kind m_kind;
  std::array<boost::container::small_vector<Parameter, 2>, 2> m_parameters;
  std::pair<internal::Deferred_rational, internal::Deferred_rational> m_squared_distance;
  std::array<Point, 2> m_points;
  std::optional<Solution_d<double>> m_solution;

public:
  //! a pair of points that an operation has found.
  explicit Point_pair(internal::Distances::Located_distance<d> found)
    : m_kind(found.kind), m_parameters(std::move(found.parameters)),
      m_squared_distance(std::move(found.squared_distance)),
      m_points(std::visit(
          [](const auto& points) {
            return std::array{internal::kernel_object<Kernel, Point>(points[0]),
                              internal::kernel_object<Kernel, Point>(points[1])};
          },
          found.points)),
      m_solution(std::move(found.solution))
  {}

  //! what is proved: with `CERTIFIED`, the ranges hold the parameters of exactly one pair of points where the
  //! derivatives of the distance are as they were asked for; in a `CONTINUUM` there are infinitely many; of `CLUSTER`
  //! and `UNDECIDED` see `Solution_kind`.
  Solution_kind kind() const { return m_kind; }

  //! the range of a parameter of the first (0) or second (1) operand; one number where it is known exactly. As that of
  //! the squared distance, it is made of doubles when it is asked for, where doubles have found it.
  Range parameter_range(std::size_t operand, std::size_t axis = 0) const
  {
    const Parameter& parameter = m_parameters[operand][axis];
    return {parameter.lower.exact(), parameter.upper.exact()};
  }

  //! a number in that range, rounded to double.
  double parameter(std::size_t operand, std::size_t axis = 0) const
  {
    return m_parameters[operand][axis].sample.nearest();
  }

  //! the point of an operand with parameters in the ranges, rounded where doubles have found it; of a segment of
  //! solutions, in its middle. Where the ranges are numbers and the kernel is exact, the point itself.
  const Point& point(std::size_t operand) const { return m_points[operand]; }

  //! the square of the distance lies between these numbers.
  Range squared_distance_range() const { return {m_squared_distance.first.exact(), m_squared_distance.second.exact()}; }

  //! the answer of the solver, with its proof; none where all parameters are ends of domains or knots, or where doubles
  //! with error bounds have proved it. The unknowns are the parameters that are none of these.
  const std::optional<Solution_d<double>>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDDistances

The feet of the perpendiculars from a point: pairs of that point, which is operand 0, and a foot, operand 1.
*/
template <SplineKernel Kernel, int d>
class Projections : public Answer_list<Point_pair<Kernel, d>>
{
public:
  using Answer_list<Point_pair<Kernel, d>>::Answer_list;

  //! the feet, by increasing distance.
  const std::vector<Point_pair<Kernel, d>>& feet() const { return this->answers(); }
};

/*!
\ingroup PkgSplineConstraintsDDistances

Where two operands are closest to each other: all pairs of points that may be, and the distance.
*/
template <SplineKernel Kernel, int d>
class Closest_points : public Answer_list<Point_pair<Kernel, d>>
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  std::pair<internal::Deferred_rational, internal::Deferred_rational> m_squared_distance;

public:
  //! pairs that an operation has found, and a range of the square of the distance. Every pair of closest points is one
  //! of the pairs, or belongs to a continuum that is one. Never empty.
  Closest_points(std::vector<Point_pair<Kernel, d>> pairs, std::vector<Undecided_part> undecided, const Summary& work,
                 std::pair<internal::Deferred_rational, internal::Deferred_rational> squared_distance)
    : Answer_list<Point_pair<Kernel, d>>(std::move(pairs), std::move(undecided), work),
      m_squared_distance(std::move(squared_distance))
  {}

  //! whether there is just one pair of closest points, by proof.
  bool is_unique() const { return this->size() == 1 && (*this)[0].kind() == Solution_kind::CERTIFIED; }

  //! the square of the distance of the operands lies between these numbers; they are equal where it is known exactly.
  Range squared_distance_range() const { return {m_squared_distance.first.exact(), m_squared_distance.second.exact()}; }

  //! the distance of the operands lies between these doubles.
  std::pair<double, double> distance_range() const { return internal::Distances::root_range(m_squared_distance); }
};

namespace internal {
namespace Distances {

template <SplineKernel Kernel, int d, class Located_distances>
std::vector<Point_pair<Kernel, d>> point_pairs(Located_distances found)
{
  std::vector<Point_pair<Kernel, d>> result;
  result.reserve(found.size());
  for (Located_distance<d>& pair : found)
    result.emplace_back(std::move(pair));
  return result;
}

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

all feet of perpendiculars from a point \f$P\f$ to a curve or surface: \f$\langle C(u) - P, C'(u)\rangle = 0\f$, for a
surface one equation for each of its two derivatives. Every foot is reported, near or far.

Where the tangent jumps at a knot, or at the seam of a closed curve, a foot is perpendicular to the piece on one of the
sides. The seam counts once. Points that see a whole piece at the same distance, as the center of a circle does, get a
`CONTINUUM`. What satisfies the equations because a derivative is zero, as at the poles of a sphere, is reported as
well.

\tparam Point `CGAL::Point_2` or `CGAL::Point_3`.
\tparam Object a model of `ParametricCurve_2`, `ParametricCurve_3` or `ParametricSurface_3` with the same kernel as the
point, in the same dimension.
\param point the point.
\param object the curve or surface.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, the weight of the object is not proved to have one sign, or an
option makes no sense.

Complexity: that of a system of one equation in one unknown, or two in two, for each smooth piece.
*/
template <class Point, class Object>
requires internal::Common::Spline_operands<Point, Object> &&
    (internal::Common::Spline_operand<Point>::number_of_parameters ==
     0) auto projections(const Point& point, const Object& object, const Solver_options& options = {})
{
  using Operand = internal::Common::Spline_operand<Object>;
  constexpr int d = Operand::dimension;
  using Kernel = typename Operand::Kernel;
  const auto with_feet = [](internal::Distances::Found_distances<d> found) {
    return Projections<Kernel, d>(internal::Distances::point_pairs<Kernel, d>(std::move(found.pairs)),
                                  std::move(found.undecided), found.summary);
  };
  options.check();
  if constexpr (internal::Distances::Has_coordinates<Object>)
    if (auto found = internal::Distances::projections_in_doubles(
            internal::Distances::Distance_operand_of<Point>::get(point),
            internal::Distances::Distance_operand_of<Object>::get(object), options))
      return with_feet(std::move(*found));
  return with_feet(internal::Distances::projections_of<d>(internal::Common::Spline_operand<Point>::map(point),
                                                          Operand::map(object), options));
}

/*!
\ingroup PkgSplineConstraintsDDistances

where two of {point, curve, surface} in the plane or in space are closest to each other: the pairs of parameters for
which \f$|A - B|^2\f$ is least, and a certified enclosure of that number.

A least distance is attained in the interior of smooth pieces, where all derivatives of \f$|A-B|^2\f$ are zero; or with
some parameters at an end of the domain, or at a knot or seam where the tangent jumps: there, the derivatives by these
parameters have signs that do not admit shorter distances, and those by the others are zero. Each of these cases is a
system that the solver finds all solutions of. Their distances are enclosed, and a solution is dropped if another pair
of points is nearer, for certain. What is left is reported: one pair, or several that have the same distance by symmetry
or cannot be told apart. An answer of the solver that is undecided is kept, unless all of it is farther away.

Doubles with certain error bounds decide first, where the operands are points and B-splines with two parameters together
at most: in microseconds, nearly always. The rest goes to the solver: operands that meet, nearest points on breaks where
the operand is smooth, poles, continua, curves or surfaces with surfaces.

Solutions with rational parameters are recognized and get exact distances. Where the operands cross at a regular
solution of \f$A = B\f$, the distance is exactly zero. So it is where a pair with rational parameters has it; touching
operands in other places get a range from zero on. A point on the seam of a closed curve or surface is reported with the
first parameter of the seam.

\tparam A,B `CGAL::Point_2`, `CGAL::Point_3`, or models of `ParametricCurve_2`, `ParametricCurve_3` or
`ParametricSurface_3`, of the same kernel in the same dimension.
\param a the first operand.
\param b the second operand.
\param options those of the solver; limits hold for the operation as a whole. Where one is reached, one answer is
`UNDECIDED`, with all parameters as its ranges.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of a system in as many unknowns as the operands have parameters, for each pair of smooth pieces, and of
smaller ones for their edges and corners; pairs that are too far apart are not looked at.
*/
template <class A, class B>
requires internal::Common::Spline_operands<A, B>
auto closest_points(const A& a, const B& b, const Solver_options& options = {})
{
  using Operand = internal::Common::Spline_operand<A>;
  constexpr int d = Operand::dimension;
  using Kernel = typename Operand::Kernel;
  const auto with_points = [](internal::Distances::Found_distances<d> found) {
    return Closest_points<Kernel, d>(internal::Distances::point_pairs<Kernel, d>(std::move(found.pairs)),
                                     std::move(found.undecided), found.summary, std::move(found.squared_distance));
  };
  options.check();
  if constexpr (internal::Distances::Has_coordinates<A> && internal::Distances::Has_coordinates<B>)
    if (auto found = internal::Distances::nearest_points_in_doubles(internal::Distances::Distance_operand_of<A>::get(a),
                                                                    internal::Distances::Distance_operand_of<B>::get(b),
                                                                    options))
      return with_points(std::move(*found));
  return with_points(
      internal::Distances::nearest_points_of<d>(Operand::map(a), internal::Common::Spline_operand<B>::map(b), options));
}

/*!
\ingroup PkgSplineConstraintsDDistances

two doubles between which the distance of two operands lies: `closest_points(a, b, options).distance_range()`.
*/
template <class A, class B>
requires internal::Common::Spline_operands<A, B> std::pair<double, double>
distance_range(const A& a, const B& b, const Solver_options& options = {})
{
  return closest_points(a, b, options).distance_range();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CLOSEST_POINTS_H
