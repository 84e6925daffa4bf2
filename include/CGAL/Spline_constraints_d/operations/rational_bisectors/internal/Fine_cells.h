// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FINE_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FINE_CELLS_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
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

using Parameter_box = std::array<std::array<double, 2>, 2>;

inline std::array<Parameter_box, 4> quarters_of(const Parameter_box& box)
{
  std::array<Parameter_box, 4> result{box, box, box, box};
  for (std::size_t k = 0; k < 4; ++k) {
    result[k][0][k < 2 ? 1 : 0] = 0.5 * (box[0][0] + box[0][1]);
    result[k][1][k % 2 == 0 ? 1 : 0] = 0.5 * (box[1][0] + box[1][1]);
  }
  return result;
}

// A box of parameters of a piece.
struct Part_of_piece
{
  std::size_t piece;
  Parameter_box box;
};

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
  };

  Foot_grid& m_grid;
  std::vector<std::vector<Interval_net>> m_products; // of the pieces: <X,X>, w X, w^2
  std::vector<Node> m_nodes;
  std::unordered_map<std::size_t, std::size_t> m_node_of_cell;

public:
  // \pre rounding is upwards, here and below
  Fine_cells(Foot_grid& grid, const std::vector<Polynomial_piece>& surface) : m_grid(grid)
  {
    for (const Polynomial_piece& piece : surface) {
      const Polynomial_vector x = piece.numerators();
      const Power_polynomial& w = piece.weight();
      auto& products = m_products.emplace_back();
      for (const Tensor& f : tensors_of({dot(x, x), w * x[0], w * x[1], w * x[2], w * w}))
        products.emplace_back(f);
    }
  }

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

  // The sign of the least power of points of a part with respect to one ball, zero if it is not known. Upper bounds of
  // it, times squared weights, make `least` less.
  int sign_of_power(const Part_of_piece& part, const Touching_ball& ball, double& least) const
  {
    constexpr std::size_t most_parts = 2000;
    const Parameter_box& box = part.box;
    std::vector<Interval_net> open{
        power(part.piece, ball).restricted(0, box[0][0], box[0][1]).restricted(1, box[1][0], box[1][1])};
    for (std::size_t count = 0; !open.empty(); ++count) {
      if (count > most_parts)
        return 0;
      const Interval_net own = std::move(open.back());
      open.pop_back();
      const double upper = own.least_corner();
      least = (std::min)(least, upper);
      if (upper < 0)
        return -1;
      if (own.bounds().inf() > 0)
        continue;
      for (const double a : {0., 0.5})
        for (const double b : {0., 0.5})
          open.push_back(own.restricted(0, a, a + 0.5).restricted(1, b, b + 0.5));
    }
    return 1;
  }

private:
  // The squared distance of points X / w from the center P of a ball minus its squared radius, times w^2:
  // <X,X> - 2 <P, w X> + (<P,P> - x^2) w^2. There is one ball, up to rounding.
  Interval_net power(std::size_t piece, const Touching_ball& ball) const
  {
    const std::vector<Interval_net>& products = m_products[piece];
    Interval_net result = products[0];
    result.add(dot(ball.center, ball.center) - CGAL::square(ball.x), products[4]);
    for (const std::size_t c : {0, 1, 2})
      result.add(Interval(-2) * ball.center[c], products[c + 1]);
    return result;
  }

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
