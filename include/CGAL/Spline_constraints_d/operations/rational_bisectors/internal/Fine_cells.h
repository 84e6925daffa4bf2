// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FINE_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FINE_CELLS_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Distance_derivatives.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Power_nets.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

inline std::array<Parameter_rectangle, 4> quarters_of(const Parameter_rectangle& box)
{
  std::array<Parameter_rectangle, 4> result{box, box, box, box};
  for (std::size_t k = 0; k < 4; ++k) {
    result[k][0][k < 2 ? 1 : 0] = 0.5 * (box[0][0] + box[0][1]);
    result[k][1][k % 2 == 0 ? 1 : 0] = 0.5 * (box[1][0] + box[1][1]);
  }
  return result;
}

// The cells of a grid, their quarters, theirs and so on, made when they are asked for.
class Fine_cells
{
public:
  using Interval = CGAL::Interval_nt<false>;

private:
  struct Node
  {
    Part_of_piece part;
    std::vector<Interval_net> nets;
    Foot_grid::Bounds bounds;
    Interval_vector sample; // of a point in the middle
    int depth;
    std::optional<std::array<std::size_t, 4>> quarters = {};
    std::optional<Distance_derivatives::Bounds> derivatives = {};
  };

  Foot_grid& m_grid;
  Power_nets m_powers;
  Distance_derivatives m_derivatives;
  std::vector<Node> m_nodes;
  std::unordered_map<std::size_t, std::size_t> m_node_of_cell;

public:
  // \pre rounding is upwards, here and below
  Fine_cells(Foot_grid& grid, const std::vector<Polynomial_piece>& surface)
    : m_grid(grid), m_powers(surface), m_derivatives(surface)
  {}

  std::size_t of_cell(const Foot_grid::Cell& cell)
  {
    const auto [known, is_new] = m_node_of_cell.try_emplace(m_grid.index(cell), m_nodes.size());
    const std::size_t result = known->second;
    if (is_new)
      add_node({cell.piece, m_grid.box(cell)}, m_grid.nets_of(cell), 0);
    return result;
  }

  const Part_of_piece& part(std::size_t node) const { return m_nodes[node].part; }
  const Foot_grid::Bounds& bounds(std::size_t node) const { return m_nodes[node].bounds; }
  const Interval_vector& sample(std::size_t node) const { return m_nodes[node].sample; }
  int depth(std::size_t node) const { return m_nodes[node].depth; }

  std::array<std::size_t, 4> quarters(std::size_t node)
  {
    if (!m_nodes[node].quarters) {
      const std::size_t first = m_nodes.size();
      m_nodes[node].quarters = {first, first + 1, first + 2, first + 3};
      const Part_of_piece whole = m_nodes[node].part;
      for (std::size_t k = 0; k < 4; ++k) {
        const double a = k < 2 ? 0 : 0.5, b = k % 2 == 0 ? 0 : 0.5;
        std::vector<Interval_net> part;
        for (const Interval_net& net : m_nodes[node].nets)
          part.push_back(net.restricted(0, a, a + 0.5).restricted(1, b, b + 0.5));
        add_node({whole.piece, quarters_of(whole.box)[k]}, std::move(part), m_nodes[node].depth + 1);
      }
    }
    return *m_nodes[node].quarters;
  }

  // Whether the squared distance from all points of a box is strictly convex in the parameters.
  bool is_distance_convex(std::size_t node, const Interval_vector& center)
  {
    Node& own = m_nodes[node];
    if (!own.derivatives)
      own.derivatives = m_derivatives.bounds(own.part);
    return Distance_derivatives::is_convex(*own.derivatives, own.bounds.point, center);
  }

  // See `Power_nets`.
  int sign_of_power(const Part_of_piece& part, const Touching_ball& ball, double& least) const
  {
    return m_powers.sign_of_power(part, ball, least);
  }

private:
  void add_node(const Part_of_piece& part, std::vector<Interval_net> nets, int depth)
  {
    Interval_vector sample;
    const Interval weight = nets[3](0.5, 0.5);
    for (const std::size_t c : {0, 1, 2})
      sample[c] = weight.inf() > 0 || weight.sup() < 0 ? nets[c](0.5, 0.5) / weight : Interval::largest();
    Foot_grid::Bounds bounds = Foot_grid::Bounds::of(nets);
    m_nodes.push_back({part, std::move(nets), bounds, sample, depth});
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FINE_CELLS_H
