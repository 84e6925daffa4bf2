// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINE_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Distance_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// The point of a spline that is nearest to a point, in doubles.
template <int d>
struct Nearest_location
{
  std::array<double, 2> parameters{};
  std::array<std::pair<double, double>, 2> ranges{}; // of the parameters, if it is the only one
  std::array<double, d> point{};
  std::pair<double, double> squared_distance;
  bool is_unique = false;
};

// Where a ray meets a spline first, in doubles.
template <int d>
struct First_hit
{
  bool is_decided = false; // by doubles
  bool is_found = false;
  std::array<std::pair<double, double>, 2> ranges{};
  std::pair<double, double> along; // the parameter of the ray
  std::array<double, d> point{};
};

// Pieces and boxes of a spline, for many queries; defined in prepared_splines.h.
template <class NT, int d>
std::shared_ptr<const Rounded_spline<d>> prepared(const Homogeneous_spline<NT, d>& spline);

// Nothing where doubles do not tell the distance but for rounding.
template <class NT, int d>
std::optional<Nearest_location<d>> nearest_location(const std::array<NT, d>& point, const Rounded_spline<d>& spline);

// Of the ray from one point through another one.
template <class NT, int d>
First_hit<d> first_hit(const std::array<NT, d>& source, const std::array<NT, d>& second,
                       const Rounded_spline<d>& spline);

#define CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(EXTERN, NT, d)                                                         \
  EXTERN template std::shared_ptr<const Rounded_spline<d>> prepared<NT, d>(const Homogeneous_spline<NT, d>&);          \
  EXTERN template std::optional<Nearest_location<d>> nearest_location<NT, d>(const std::array<NT, d>&,                 \
                                                                             const Rounded_spline<d>&);                \
  EXTERN template First_hit<d> first_hit<NT, d>(const std::array<NT, d>&, const std::array<NT, d>&,                    \
                                                const Rounded_spline<d>&);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(extern, double, 2)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(extern, double, 3)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(extern, Exact_rational, 2)
CGAL_SPLINE_CONSTRAINTS_PREPARED_SPLINE(extern, Exact_rational, 3)
#endif

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINE_H
