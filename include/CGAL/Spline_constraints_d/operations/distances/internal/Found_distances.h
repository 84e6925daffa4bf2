// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_DISTANCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_DISTANCES_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distance.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Distance_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A range of a parameter, and a number in it.
struct Located_parameter
{
  Deferred_rational lower, upper, sample;
};

// A pair of points of two operands; doubles next to them where they are not known exactly.
template <int d>
struct Located_distance
{
  using Exact_points = std::array<std::array<Exact_rational, d>, 2>;
  using Double_points = std::array<std::array<double, d>, 2>;

  Solution_kind kind;
  std::array<boost::container::small_vector<Located_parameter, 2>, 2> parameters; // of each operand
  std::pair<Deferred_rational, Deferred_rational> squared_distance;               // a range
  std::variant<Exact_points, Double_points> points;
  std::optional<Solution_d<double>> solution;
};

// One that the solver has found, at points that have been made.
template <int d>
Located_distance<d> located(const Critical_distance& found, typename Located_distance<d>::Exact_points points)
{
  const Rational_interval& square = found.squared_distance;
  Located_distance<d> result{found.kind,
                             {},
                             {Deferred_rational(square.lower), Deferred_rational(square.upper)},
                             std::move(points),
                             found.solution};
  for (const std::size_t operand : {0, 1})
    for (std::size_t axis = 0; axis < found.ranges[operand].size(); ++axis) {
      const auto& [lower, upper] = found.ranges[operand][axis];
      result.parameters[operand].push_back(
          {Deferred_rational(lower), Deferred_rational(upper), Deferred_rational(found.sample[operand][axis])});
    }
  return result;
}

template <int d>
struct Found_distances
{
  Scratch_vector<Located_distance<d>> pairs;
  std::pair<Deferred_rational, Deferred_rational> squared_distance; // of the nearest ones
  std::vector<Undecided_part> undecided;
  Summary summary;
};

// All feet of perpendiculars from a point, and the nearest points of two operands; defined in Critical_distances.h.
template <int d>
Found_distances<d> projections_of(const Exact_map<d>& point, const Exact_map<d>& object, const Solver_options& options);
template <int d>
Found_distances<d> nearest_points_of(const Exact_map<d>& first, const Exact_map<d>& second,
                                     const Solver_options& options);

// The same where doubles decide; defined in doubles/nearest_points_in_doubles.h.
template <class NT, int d>
std::optional<Found_distances<d>> nearest_points_in_doubles(const Distance_operand<NT, d>& first,
                                                            const Distance_operand<NT, d>& second,
                                                            const Solver_options& options);

template <class NT, int d>
std::optional<Found_distances<d>> projections_in_doubles(const Distance_operand<NT, d>& point,
                                                         const Distance_operand<NT, d>& object,
                                                         const Solver_options& options);

#define CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(EXTERN, NT, d)                                               \
  EXTERN template std::optional<Found_distances<d>> nearest_points_in_doubles<NT, d>(                                  \
      const Distance_operand<NT, d>&, const Distance_operand<NT, d>&, const Solver_options&);                          \
  EXTERN template std::optional<Found_distances<d>> projections_in_doubles<NT, d>(                                     \
      const Distance_operand<NT, d>&, const Distance_operand<NT, d>&, const Solver_options&);

// The Hausdorff distance of two curves, or that of the first one from the second one.
template <int d>
struct Found_hausdorff_distance
{
  std::pair<Exact_rational, Exact_rational> squared_distance;
  std::size_t curve; // that has the far point
  std::array<Exact_rational, 2> parameters;
  std::array<std::array<Exact_rational, d>, 2> points;
  std::vector<Undecided_part> undecided;
  Summary summary;
};

// Defined in Farthest_point_search.h.
template <int d>
Found_hausdorff_distance<d> hausdorff_distance_of(const Exact_map<d>& first, const Exact_map<d>& second,
                                                  double tolerance, bool is_one_sided, const Solver_options& options);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template Found_distances<2> projections_of<2>(const Exact_map<2>&, const Exact_map<2>&, const Solver_options&);
extern template Found_distances<3> projections_of<3>(const Exact_map<3>&, const Exact_map<3>&, const Solver_options&);
extern template Found_distances<2> nearest_points_of<2>(const Exact_map<2>&, const Exact_map<2>&,
                                                        const Solver_options&);
extern template Found_distances<3> nearest_points_of<3>(const Exact_map<3>&, const Exact_map<3>&,
                                                        const Solver_options&);
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(extern, double, 2)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(extern, double, 3)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(extern, Exact_rational, 2)
CGAL_SPLINE_CONSTRAINTS_NEAREST_POINTS_IN_DOUBLES(extern, Exact_rational, 3)
extern template Found_hausdorff_distance<2> hausdorff_distance_of<2>(const Exact_map<2>&, const Exact_map<2>&, double,
                                                                     bool, const Solver_options&);
extern template Found_hausdorff_distance<3> hausdorff_distance_of<3>(const Exact_map<3>&, const Exact_map<3>&, double,
                                                                     bool, const Solver_options&);
#endif

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_DISTANCES_H
