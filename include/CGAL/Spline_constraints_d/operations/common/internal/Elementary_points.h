// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELEMENTARY_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELEMENTARY_POINTS_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The most parameters that two operands have together.
constexpr std::size_t most_parameters = 4;

// Ranges of doubles of the parameters of both operands, one after the other.
using Double_ranges = std::array<std::pair<double, double>, most_parameters>;

// A common point that was found without exact patches: by a closed form, or as a regular solution.
template <int d>
struct Elementary_point
{
  Intersection_kind kind;
  Double_ranges parameters;
  std::array<bool, most_parameters> is_at_end;
  int multiplicity;
  std::optional<Passage> passage;
  std::array<double, d> point;   // near to it
  std::optional<Solution_d<double>> solution = std::nullopt;
  std::vector<std::pair<Exact_rational, Exact_rational>> exact_parameters = {};   // none: those above are known
};

// By the parameters in their order. Ranges that meet are taken for those of one number.
template <int d>
bool is_before(const Elementary_point<d>& x, const Elementary_point<d>& y)
{
  for (std::size_t j = 0; j < most_parameters; ++j)
    if (x.parameters[j].second < y.parameters[j].first || y.parameters[j].second < x.parameters[j].first)
      return x.parameters[j].second < y.parameters[j].first;
  return false;
}

// All common points of two operands. The second one has its parameters from number `split` on.
template <int d>
struct Elementary_points
{
  std::size_t split, number_of_parameters;
  std::size_t nodes = 0;                         // that were looked at to find them
  Scratch_list<Elementary_point<d>> points = {}; // in order
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELEMENTARY_POINTS_H
