// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/reason_of.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_solution.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <iterator>
#include <optional>
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
  //! a common point that an operation has found, with ranges of its coordinates and of the parameters of each operand.
  Locus_intersection(Intersection_kind kind, const std::array<Double_range, d>& coordinates,
                     std::vector<std::vector<internal::Intersections::Locus_parameter>> parameters,
                     Solution_d<double> solution)
    : m_kind(kind), m_coordinates(coordinates), m_parameters(std::move(parameters)), m_solution(std::move(solution))
  {}

  //! what is proved. `END_POINT`: at an end of some operand.
  Intersection_kind kind() const { return m_kind; }

  //! a coordinate of the common point lies in the range; those of all points of an overlap do. Infinite where nothing
  //! is known.
  const Double_range& coordinate_range(std::size_t i) const { return m_coordinates[i]; }

  //! the middle of that range; none where nothing is known.
  std::optional<double> coordinate(std::size_t i) const
  {
    const double middle = m_coordinates[i].first / 2 + m_coordinates[i].second / 2;
    return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
  }

  //! number of operands.
  std::size_t number_of_operands() const { return m_parameters.size(); }

  //! number of parameters of an operand; 0 of an implicit one.
  std::size_t number_of_parameters(std::size_t operand) const { return m_parameters[operand].size(); }

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
Undecided_part undecided_part(const Locus_intersection<d>& answer)
{
  Undecided_part result{{}, {}, reason_of(answer.solution())};
  for (std::size_t i = 0; i < d; ++i)
    result.place.push_back(answer.coordinate_range(i));
  for (std::size_t operand = 0; operand < answer.number_of_operands(); ++operand)
    if (answer.number_of_parameters(operand) > 0) {
      result.parameters.push_back({operand, {}});
      for (std::size_t axis = 0; axis < answer.number_of_parameters(operand); ++axis)
        result.parameters.back().ranges.push_back(double_range(answer.parameter_range(operand, axis)));
    }
  return result;
}

// What stands for all common points with parameters in these ranges of each operand, where none were looked for.
template <int d>
Locus_intersection<d>
undecided_locus_intersection(const std::vector<std::vector<std::pair<Exact_rational, Exact_rational>>>& ranges,
                             Undecided_reason reason)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::pair<double, double>, d> coordinates;
  coordinates.fill({-infinity, infinity});
  std::vector<std::vector<Locus_parameter>> parameters;
  std::vector<std::pair<Exact_rational, Exact_rational>> box;
  for (const auto& operand : ranges) {
    parameters.emplace_back();
    for (const auto& range : operand) {
      parameters.back().emplace_back(range, range);
      box.push_back(range);
    }
  }
  return {Intersection_kind::UNDECIDED, coordinates, std::move(parameters), undecided_solution(box, reason)};
}

template <int d>
Locus_intersections<d> ordered_by_kind(std::vector<Locus_intersection<d>> intersections, const Summary& summary)
{
  std::stable_sort(intersections.begin(), intersections.end(),
                   [](const auto& a, const auto& b) { return a.kind() < b.kind(); });
  return Locus_intersections<d>(
      {std::make_move_iterator(intersections.begin()), std::make_move_iterator(intersections.end())}, summary,
      undecided_part<d>);
}

} // namespace Intersections
} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_LOCUS_INTERSECTION_H
