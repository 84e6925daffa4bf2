// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_BOXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_BOXES_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The smallest range with dyadic ends around another one: it may be an ulp wider, roots are placed exactly later.
template <class Coordinate>
std::pair<Coordinate, Coordinate> dyadic_hull(const Exact_rational& lower, const Exact_rational& upper, int bits)
{
  if constexpr (std::is_same_v<Coordinate, double>) {
    // An axis of width zero cannot carry a polynomial: it gets the neighbouring doubles.
    double lo = to_double_interval(lower).first, hi = to_double_interval(upper).second;
    if (lo == hi) {
      lo = std::nextafter(lo, -HUGE_VAL);
      hi = std::nextafter(hi, HUGE_VAL);
    }
    if (!std::isfinite(lo) || !std::isfinite(hi))
      throw Invalid_input("Subdivision_solver_d: the domain does not fit into the range of doubles");
    return {lo, hi};
  } else {
    const Exact_rational unit = power_of_two(bits);
    const auto floor_of = [&](const Exact_rational& x) {
      const Exact_rational scaled = x * unit;
      Big_integer quotient;
      mpz_fdiv_q(quotient.backend().data(), numerator_of(scaled).backend().data(),
                 denominator_of(scaled).backend().data());
      return scaled_rational(quotient, -bits);
    };
    Exact_rational lo = floor_of(lower), hi = -floor_of(-upper);
    if (lo == hi) {
      lo -= power_of_two(-bits);
      hi += power_of_two(-bits);
    }
    return {lo, hi};
  }
}

// The part of a box in a cell, up to the rounding to dyadic ends; `range(v)` is the pair of its ends along an unknown.
template <class Coordinate, class Range>
std::pair<std::vector<Coordinate>, std::vector<Coordinate>> part_in_cell(const Exact_source& source, const Cell& cell,
                                                                         const Range& range, int bits)
{
  std::vector<Coordinate> part_lower, part_upper;
  part_lower.reserve(cell.size());
  part_upper.reserve(cell.size());
  for (int v = 0; v < static_cast<int>(cell.size()); ++v) {
    const auto& [lower, upper] = range(v);
    const std::vector<Exact_rational>& breaks = source.breaks(v);
    const bool has_breaks = breaks.size() > 2;
    const bool is_first = !has_breaks || cell[v] == 0,
               is_last = !has_breaks || cell[v] + 2 == static_cast<int>(breaks.size());
    const Exact_rational& begin = is_first ? lower : (std::max)(lower, breaks[cell[v]]);
    const Exact_rational& end = is_last ? upper : (std::min)(upper, breaks[cell[v] + 1]);
    const auto [from, to] = dyadic_hull<Coordinate>(begin, end, bits);
    part_lower.push_back(from);
    part_upper.push_back(to);
  }
  return {std::move(part_lower), std::move(part_upper)};
}

// Calls visit(cell, lower, upper) for every cell that a box meets, with the part of the box in that cell.
template <class Coordinate, class Visitor>
void visit_cell_boxes(Exact_source& source, const std::vector<Exact_rational>& lower,
                      const std::vector<Exact_rational>& upper, int bits, const Visitor& visit)
{
  const auto range = [&](int v) { return std::pair<const Exact_rational&, const Exact_rational&>(lower[v], upper[v]); };
  source.visit_cells(std::span<const Exact_rational>(lower), std::span<const Exact_rational>(upper),
                     [&](const Cell& cell) {
                       const auto [part_lower, part_upper] = part_in_cell<Coordinate>(source, cell, range, bits);
                       visit(cell, part_lower, part_upper);
                     });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_BOXES_H
