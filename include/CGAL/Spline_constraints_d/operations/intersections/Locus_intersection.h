// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace Intersections {

// A range of a parameter within its domain, and whether it is one of the ends of this.
struct Locus_parameter
{
  std::pair<Exact_rational, Exact_rational> range;
  bool is_at_end;

  Locus_parameter(const std::pair<Exact_rational, Exact_rational>& enclosure,
                  const std::pair<Exact_rational, Exact_rational>& domain)
    : range((std::max)(enclosure.first, domain.first), (std::min)(enclosure.second, domain.second)),
      is_at_end(range.first == range.second && (range.first == domain.first || range.first == domain.second))
  {}
};

inline Intersection_kind intersection_kind(Solution_kind kind)
{
  switch (kind) {
  case Solution_kind::CERTIFIED: return Intersection_kind::TRANSVERSAL;
  case Solution_kind::CLUSTER: return Intersection_kind::TANGENT;
  case Solution_kind::CONTINUUM: return Intersection_kind::OVERLAP;
  case Solution_kind::UNDECIDED: break;
  }
  return Intersection_kind::UNDECIDED;
}

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

A common point, or piece, of several curves and surfaces in `d`-space: its coordinates, and the parameters on those
operands that have some, within proved ranges.
*/
template <int d>
class Locus_intersection
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! a closed range of a coordinate, its ends rounded outwards.
  using Double_range = std::pair<double, double>;

private:
  Intersection_kind m_kind;
  std::array<Double_range, d> m_coordinates;
  std::vector<std::vector<internal::Intersections::Locus_parameter>> m_parameters;   // per operand
  Solution_d<double> m_solution;

public:
#ifndef DOXYGEN_RUNNING
  Locus_intersection(Intersection_kind kind, const std::array<Double_range, d>& coordinates,
                     std::vector<std::vector<internal::Intersections::Locus_parameter>> parameters,
                     Solution_d<double> solution)
    : m_kind(kind), m_coordinates(coordinates), m_parameters(std::move(parameters)), m_solution(std::move(solution))
  {}
#endif

  //! what is proved. `END_POINT`: at an end of some operand.
  Intersection_kind kind() const { return m_kind; }

  //! a coordinate of the common point lies in the range; those of all points of an overlap do. Infinite where nothing
  //! is known.
  const Double_range& coordinate_range(std::size_t i) const { return m_coordinates[i]; }

  //! the middle of that range; not a number where nothing is known.
  double coordinate(std::size_t i) const { return m_coordinates[i].first / 2 + m_coordinates[i].second / 2; }

  //! the range of a parameter of an operand, which are numbered as they were given. \pre The operand has such a
  //! parameter: implicit ones have none.
  const Range& parameter_range(std::size_t operand, std::size_t axis = 0) const
  {
    return m_parameters[operand][axis].range;
  }

  //! the middle of that range, rounded to double.
  double parameter(std::size_t operand, std::size_t axis = 0) const
  {
    const Range& range = parameter_range(operand, axis);
    return to_nearest_double(Exact_rational((range.first + range.second) / 2));
  }

  //! whether the common point is at an end of the domain of a parameter, decided exactly; the seam of a closed curve is
  //! one. \pre The operand has such a parameter.
  bool is_at_end(std::size_t operand, std::size_t axis) const { return m_parameters[operand][axis].is_at_end; }

  //! whether it is at an end of any parameter of an operand.
  bool is_at_end(std::size_t operand) const
  {
    return std::any_of(m_parameters[operand].begin(), m_parameters[operand].end(),
                       [](const auto& parameter) { return parameter.is_at_end; });
  }

  //! how often the common point counts; 1 when the operands cross, 0 when not known.
  int multiplicity() const { return m_solution.multiplicity(); }

  //! the answer of the solver, with its proof: the unknowns are the parameters of the operands one after the other,
  //! then auxiliary ones; or the coordinates, when no operand has parameters.
  const Solution_d<double>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDIntersections

The intersections of curves and surfaces in `d`-space, those of one kind after another.
*/
template <int d>
using Locus_intersections = Intersection_set<Locus_intersection<d>>;

namespace internal {
namespace Intersections {

template <int d>
Locus_intersections<d> ordered_by_kind(std::vector<Locus_intersection<d>> intersections, const Summary& summary)
{
  std::stable_sort(intersections.begin(), intersections.end(),
                   [](const auto& a, const auto& b) { return a.kind() < b.kind(); });
  return Locus_intersections<d>(std::move(intersections), summary);
}

} // namespace Intersections
} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H
