// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_HULL_CONTACTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_HULL_CONTACTS_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What a line touches: a piece of a curve, or a point.
struct Hull_contact_operand
{
  const Hull_piece_2* piece;   // null: a point
  Exact_pair point;
};

// What is asked of the solver for the hull of curves.
class Hull_contacts_2
{
  Solver_options m_options;
  Summing_solver m_solve;

public:
  explicit Hull_contacts_2(const Solver_options& options) : m_options(options), m_solve(options) {}

  const Summary& work() const { return m_solve.total(); }
  bool is_exhausted() const { return m_solve.has_reached_node_limit() || m_solve.is_out_of_time(); }

  /*
  A line from the first operand to the last one that touches all, in the direction in which pieces run: their parameters on [0,1], if there is one, and
  all are in these ranges. Where a line touches more operands than two, there are
  more equations than unknowns.
  */
  std::optional<std::vector<Parameter_range>> common_tangent(const std::vector<Hull_contact_operand>& operands)
  {
    const std::vector<Unknown> u = unknowns(std::vector<std::array<Bound, 2>>(number_of_pieces(operands), {Bound(0), Bound(1)}));
    std::vector<Vector_expression<2>> points, tangents;
    std::size_t next = 0;
    for (const auto& [piece, point] : operands) {
      const Unknown* parameter = piece != nullptr ? &u[next++] : nullptr;
      const auto curve = piece != nullptr ? std::optional<Differentiated_map>(std::in_place, Planar_map(exact_curve(*piece)), 1) : std::nullopt;
      points.push_back(curve ? (*curve)(0, *parameter) : Vector_expression<2>(point[0], point[1]));
      tangents.push_back(curve ? (*curve)(1, *parameter) : Vector_expression<2>(0, 0));
    }
    const Vector_expression<2> line = points.back() - points.front();
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (i > 0 && i + 1 < operands.size())
        constraints.push_back(cross(line, points[i] - points.front()) == 0);
      if (operands[i].piece != nullptr) {
        constraints.push_back(cross(line, tangents[i]) == 0);
        constraints.push_back(dot(line, tangents[i]) > 0);
      }
    }
    const auto solutions = m_solve(constraints);
    if (solutions.size() != 1 || solutions[0].kind() == Solution_kind::UNDECIDED || solutions[0].kind() == Solution_kind::CONTINUUM)
      return std::nullopt;
    const auto box = solutions[0].exact_box();
    std::vector<Parameter_range> result;
    for (const auto& [lower, upper] : box)
      result.emplace_back((std::max)(lower, Exact_rational(0)), (std::min)(upper, Exact_rational(1)));
    return result;
  }

  // Whether two pieces have one common point at most, or the first one is a part of the second one.
  bool meet_once_or_overlap(const Hull_piece_2& piece, const Hull_piece_2& other) const
  {
    const auto common = intersections(exact_curve(piece), exact_curve(other), m_options);
    if (!common.is_complete())
      return false;
    if (common.count(Intersection_kind::OVERLAP) == 0)
      return common.size() <= 1;
    return common.size() == 1 && common[0].parameter_range(0) == Parameter_range(0, 1);
  }

  bool has_point(const Hull_piece_2& piece, const Exact_pair& point) const
  {
    const auto common = intersections(Exact_kernel::Point_2(point[0], point[1]), exact_curve(piece), m_options);
    return common.is_complete() && !common.empty();
  }

private:
  static Bspline_curve_2<Exact_kernel> exact_curve(const Hull_piece_2& piece) { return Boundary_loop_2({piece.curve()}).curve(); }

  static std::size_t number_of_pieces(const std::vector<Hull_contact_operand>& operands)
  {
    return std::count_if(operands.begin(), operands.end(), [](const Hull_contact_operand& operand) { return operand.piece != nullptr; });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_HULL_CONTACTS_2_H
