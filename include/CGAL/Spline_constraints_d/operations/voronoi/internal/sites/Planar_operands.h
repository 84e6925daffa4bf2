// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_PLANAR_OPERANDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_PLANAR_OPERANDS_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A curve as an operand, whatever its type and kernel: a rational map.
class Operand_curve_2
{
  using Function = Bspline_function<Exact_rational>;

  std::array<Function, 2> m_homogeneous_coordinates;
  Function m_weight;
  bool m_is_rational;

public:
  static constexpr int number_of_parameters = 1;

  // Not for copies, of which it would be asked whether they can be made to decide whether they are curves.
  template <class Curve>
    requires(!std::same_as<Curve, Operand_curve_2>) && ParametricCurve_2<Curve>
  explicit Operand_curve_2(const Curve& curve)
    : m_homogeneous_coordinates(curve.homogeneous_coordinates()), m_weight(curve.weight()),
      m_is_rational(curve.is_rational())
  {}

  const std::array<Function, 2>& homogeneous_coordinates() const { return m_homogeneous_coordinates; }
  const Function& weight() const { return m_weight; }
  bool is_rational() const { return m_is_rational; }
};

template <SplineKernel Kernel>
Exact_vector<2> exact_coordinates(const CGAL::Point_2<Kernel>& point)
{
  return {converted_number<Exact_rational>(point.x()), converted_number<Exact_rational>(point.y())};
}

// Curves, and isolated points behind them.
struct Planar_operands
{
  std::vector<Operand_curve_2> curves;
  std::vector<Exact_vector<2>> points;
};

template <class Curves, class Points>
Planar_operands planar_operands(Curves&& curves, Points&& points)
{
  Planar_operands result;
  for (auto&& curve : curves)
    result.curves.emplace_back(curve);
  for (auto&& point : points)
    result.points.push_back(exact_coordinates(point));
  return result;
}

// Two operands, or one, each a curve or a point, in order.
struct Ordered_operands : Planar_operands
{
  std::vector<std::pair<bool, std::size_t>> places{};   // of each: whether it is a point, and its index

  template <ParametricCurve_2 Curve>
  void add(const Curve& curve)
  {
    places.emplace_back(false, curves.size());
    curves.emplace_back(curve);
  }

  template <SplineKernel Kernel>
  void add(const CGAL::Point_2<Kernel>& point)
  {
    places.emplace_back(true, points.size());
    points.push_back(exact_coordinates(point));
  }
};

template <class... Operands>
Ordered_operands ordered_operands(const Operands&... operands)
{
  Ordered_operands result;
  (result.add(operands), ...);
  return result;
}

inline Ordered_operands exchanged(Ordered_operands operands)
{
  std::reverse(operands.curves.begin(), operands.curves.end());
  std::reverse(operands.points.begin(), operands.points.end());
  std::reverse(operands.places.begin(), operands.places.end());
  for (auto& [is_point, index] : operands.places)
    index = (is_point ? operands.points.size() : operands.curves.size()) - 1 - index;
  return operands;
}

// A region: its curves, and of each the arcs of its boundaries, in the direction of the curve; or why they are not
// known.
struct Region_operand
{
  struct Arc
  {
    bool is_reversed;                           // whether the region is on the right
    std::array<Exact_rational, 2> parameters;
  };

  std::vector<Operand_curve_2> curves;
  std::vector<std::vector<Arc>> arcs;
  Undecided_reason undecided = Undecided_reason::NONE;
};

template <class Region>
Region_operand region_operand(const Region& region)
{
  Region_operand result;
  for (const auto& curve : region.curves())
    result.curves.emplace_back(curve);
  if (!region.is_complete()) {
    result.undecided = region.summary().why_not;
    return result;
  }
  for (const auto& arcs : region.arcs_of_curves()) {
    result.arcs.emplace_back();
    for (const auto& arc : arcs)
      result.arcs.back().push_back({arc.is_reversed, arc.parameters});
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_PLANAR_OPERANDS_H
