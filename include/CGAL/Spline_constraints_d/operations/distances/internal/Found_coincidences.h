// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COINCIDENCES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COINCIDENCES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/Special_point_kind.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A point of an object where it ends, may bend, or is not regular; its parameters are exact, but for those of a pole
// along its edge.
template <int d>
struct Special_point
{
  std::size_t object;
  Special_point_kind kind;
  std::vector<std::pair<Exact_rational, Exact_rational>> parameters;
  std::array<Exact_rational, d> point;
};

template <int d>
struct Found_coincidence
{
  std::array<Special_point<d>, 2> points;
  Exact_rational squared_distance;
};

template <int d>
struct Found_coincidences
{
  std::vector<Found_coincidence<d>> pairs;
  std::vector<Undecided_part> undecided;
  Summary summary;
};

// Of all objects, or of two different ones alone; defined in near_special_points.h.
template <int d>
Found_coincidences<d> near_coincidences_of(const std::vector<Exact_map<d>>& objects, bool are_different,
                                           std::optional<double> tolerance, const Solver_options& options);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template Found_coincidences<2> near_coincidences_of<2>(const std::vector<Exact_map<2>>&, bool,
                                                              std::optional<double>, const Solver_options&);
extern template Found_coincidences<3> near_coincidences_of<3>(const std::vector<Exact_map<3>>&, bool,
                                                              std::optional<double>, const Solver_options&);
#endif

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COINCIDENCES_H
