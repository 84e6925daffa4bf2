// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Label_arcs.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Label_tree.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/parts_of_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// What is known of the labels of all pieces.
class Face_trimming
{
  const Operation_budget& m_budget;
  Ball_scene m_scene;
  Foot_grid m_grid;
  Nearest_feet m_feet;
  std::vector<Label_tree> m_trees;
  std::vector<std::vector<std::size_t>> m_blocks; // nodes of the trees

public:
  // \pre rounding is upwards, here and below
  Face_trimming(const std::vector<Polynomial_piece>& surface, const Foot_pieces& feet, const Oriented_sphere& sphere,
                const Reach& reach, const Operation_budget& budget)
    : m_budget(budget), m_scene{interval_vector(sphere.center), to_double_interval(sphere.radius),
                                interval_vector(reach.center), to_double_interval(reach.squared_radius),
                                farthest(sphere, reach)},
      m_grid(feet.pieces, feet.shape, feet.pieces.size() < 8 ? 32 : 16), m_feet(m_grid, surface, budget)
  {
    for (std::size_t piece = 0; piece < surface.size(); ++piece) {
      m_trees.emplace_back(piece, surface[piece].coordinates, m_scene, m_feet, budget);
      m_blocks.push_back(m_trees.back().blocks());
    }
  }

  // The whole of a piece, with the quarters that it is cut into.
  Box_of_block blocks(std::size_t piece) const { return blocks(piece, 0); }

  std::optional<int> label(std::size_t piece, const Parameters& local) { return m_trees[piece].label(local); }

  // Those that arcs bound, or none if there are no arcs. Where their points are not found the block is undecided: one
  // sample says nothing of all of it.
  std::optional<Surface_regions::Cell_faces> faces(const Bisector_block& block)
  {
    Label_tree& tree = m_trees[block.own];
    const auto is_own = [&](std::size_t node) { return tree.node(node).box == block.box.ranges; };
    const std::size_t node = *std::ranges::find_if(m_blocks[block.own], is_own);
    if (tree.arcs(node).empty())
      return std::nullopt;
    constexpr double error = 0x1p-10;
    std::optional<Surface_regions::Cell_faces> result = Label_arcs(tree, error, m_budget).faces(node);
    return result ? std::move(*result) : Surface_regions::without_faces("a point of the border is not found");
  }

private:
  Box_of_block blocks(std::size_t piece, std::size_t node) const
  {
    const Label_tree& tree = m_trees[piece];
    Box_of_block result{tree.node(node).box, tree.is_within(node)};
    if (std::ranges::find(m_blocks[piece], node) == m_blocks[piece].end())
      for (const std::size_t child : tree.node(node).children)
        result.quarters.push_back(blocks(piece, child));
    return result;
  }

  static Interval_vector interval_vector(const Rational_bisector_3::Kernel::Point_3& p)
  {
    return {to_double_interval(p.x()), to_double_interval(p.y()), to_double_interval(p.z())};
  }

  static Ball_scene::Interval farthest(const Oriented_sphere& sphere, const Reach& reach)
  {
    return square_root(to_double_interval(reach.squared_radius)) +
        square_root(to_double_interval(CGAL::squared_distance(sphere.center, reach.center)));
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Trimmed_surface_3>
trimmed_sphere_bisector(const Oriented_sphere& sphere, const Exact_map<3>& surface, const Rational_bisector_3& bisector,
                        const Reach& reach, const Solver_options& options)
{
  Operation_budget budget(options);
  const std::vector<Polynomial_piece> pieces = pieces_in_powers(surface);
  std::optional<Face_trimming> faces;
  try {
    const Foot_pieces feet = Foot_pieces::of(pieces, budget);
    const Upward_rounding_guard guard;
    faces.emplace(pieces, feet, sphere, reach, budget);
  } catch (const Invalid_input&) { // polynomials of the curvatures would be too large
  } catch (const Run_stopped&) {
  }
  const auto blocks = [&](std::size_t piece) { return faces ? faces->blocks(piece) : Box_of_block(); };
  const auto label = [&](const Surface_cell_3& cell, const Parameters& local, bool) -> std::optional<int> {
    if (!faces)
      return std::nullopt;
    const Upward_rounding_guard guard;
    const Parameters parameters{cell.parameter(0, local[0]), cell.parameter(1, local[1])};
    const auto contains = [&](const Rational_bisector_piece_3& piece) {
      return piece.contains(0, parameters[0]) && piece.contains(1, parameters[1]);
    };
    const auto piece = std::ranges::find_if(bisector.pieces(), contains);
    return faces->label(static_cast<std::size_t>(piece - bisector.pieces().begin()),
                        {piece->local_parameter(0, parameters[0]), piece->local_parameter(1, parameters[1])});
  };
  const auto faces_of = [&](const Bisector_block& block) -> std::optional<Surface_regions::Cell_faces> {
    if (!faces)
      return std::nullopt;
    const Upward_rounding_guard guard;
    return faces->faces(block);
  };
  try {
    return parts_of_bisector(bisector, reach, label, budget, blocks, faces_of);
  } catch (const Run_stopped&) { // before there were cells
    faces.reset();
    return parts_of_bisector(bisector, reach, label, budget, blocks, faces_of);
  }
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H
