// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_PARTS_OF_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_PARTS_OF_BISECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/functions_on_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_face_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_triangulation.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// A box of parameters of a piece, in its unit box; its quarters, for any cuts, if it is cut.
struct Box_of_block
{
  std::array<std::array<double, 2>, 2> ranges{{{0, 1}, {0, 1}}};
  bool is_within = false; // reach, certainly
  std::vector<Box_of_block> quarters = {};
};

// A block of a piece of a bisector.
struct Bisector_block
{
  Surface_cell_3 cell;
  std::size_t piece;   // of the continuous part
  std::size_t own = 0; // the piece of the bisector
  Box_of_block box = {};

  bool is_whole() const { return box.ranges == Box_of_block().ranges; }

  std::vector<Surface_cell_3::Range> range() const
  {
    std::vector<Surface_cell_3::Range> result;
    for (const std::array<double, 2>& side : box.ranges)
      result.emplace_back(Exact_rational(side[0]), Exact_rational(side[1]));
    return result;
  }
};

// The parts of a cell before and after a number between 0 and 1.
inline std::array<Surface_cell_3, 2> parts_of_cell(const Surface_cell_3& cell, int axis, const Exact_rational& at)
{
  std::array<Surface_cell_3, 2> result{cell, cell};
  const std::size_t own = static_cast<std::size_t>(axis);
  result[0].domain[own].second = result[1].domain[own].first = cell.parameter(axis, at);
  for (std::size_t c = 0; c < 4; ++c)
    std::tie(result[0].coordinates[c], result[1].coordinates[c]) = cell.coordinates[c].split(axis, at);
  return result;
}

// Adds a block, or its quarters, theirs and so on.
inline void add_blocks(std::vector<Bisector_block>& result, Bisector_block block, const Operation_budget& budget)
{
  if (block.box.quarters.empty()) {
    result.push_back(std::move(block));
    return;
  }
  budget.check();
  const auto cut = [&](std::size_t axis) {
    const Exact_rational begin(block.box.ranges[axis][0]), end(block.box.ranges[axis][1]),
        at(block.box.quarters.front().ranges[axis][1]);
    return Exact_rational((at - begin) / Exact_rational(end - begin));
  };
  const std::array<Surface_cell_3, 2> columns = parts_of_cell(block.cell, 0, cut(0));
  for (const std::size_t a : {0, 1}) {
    const std::array<Surface_cell_3, 2> cells = parts_of_cell(columns[a], 1, cut(1));
    for (const std::size_t b : {0, 1})
      add_blocks(result, {cells[b], block.piece, block.own, block.box.quarters[2 * a + b]}, budget);
  }
}

// The pieces of a continuous part, whose weights have no jumps, as blocks.
inline std::vector<Bisector_block> pieces_of(const Cell_functions<4>& part)
{
  std::array<std::vector<Cell_polynomial>, 4> pieces;
  for (std::size_t i = 0; i < 4; ++i)
    pieces[i] = part.pieces(i);
  std::vector<Bisector_block> result;
  std::size_t k = 0;
  for (std::size_t i = 1; i < part.breaks(0).size(); ++i)
    for (std::size_t j = 1; j < part.breaks(1).size(); ++j, ++k)
      result.push_back({{{Surface_cell_3::Range(part.breaks(0)[i - 1], part.breaks(0)[i]),
                          Surface_cell_3::Range(part.breaks(1)[j - 1], part.breaks(1)[j])},
                         {pieces[0][k], pieces[1][k], pieces[2][k], pieces[3][k]}},
                        k});
  return result;
}

// Cuts a continuous part at its poles, or at a sphere.
class Bisector_trimming
{
  std::vector<Bisector_block> m_pieces, m_blocks;
  std::optional<Reach> m_reach;
  std::vector<std::optional<Cell_polynomial>> m_powers_of_pieces, m_powers; // of the blocks: positive out of reach

public:
  // `blocks_of(piece of the bisector)` is its box, with the quarters that it is cut into.
  template <class Blocks_of_piece>
  Bisector_trimming(const Rational_bisector_3& bisector, const Cell_functions<4>& part,
                    const std::optional<Reach>& reach, const Blocks_of_piece& blocks_of, const Operation_budget& budget)
    : m_pieces(pieces_of(part)), m_reach(reach), m_powers_of_pieces(m_pieces.size())
  {
    for (Bisector_block& piece : m_pieces) {
      const auto is_same = [&](const Rational_bisector_piece_3& other) { return other.domain() == piece.cell.domain; };
      piece.own =
          static_cast<std::size_t>(std::ranges::find_if(bisector.pieces(), is_same) - bisector.pieces().begin());
      Bisector_block whole(piece);
      whole.box = blocks_of(piece.own);
      add_blocks(m_blocks, std::move(whole), budget);
    }
    m_powers.resize(m_blocks.size());
  }

  const Bisector_block& block(std::size_t cell) const { return m_blocks[cell]; }

  std::vector<Surface_cell_3> cells() const
  {
    std::vector<Surface_cell_3> result;
    for (const Bisector_block& block : m_blocks)
      result.push_back(block.cell);
    return result;
  }

  std::vector<Cell_polynomial> zeros(std::size_t cell)
  {
    return {m_reach ? power(cell) : m_blocks[cell].cell.coordinates[3]};
  }

  // `label_within(cell, parameters in its unit box, whether the weight is positive)` within reach.
  template <class Label_within>
  std::optional<int> label(std::size_t cell, const Parameters& parameters, const Label_within& label_within)
  {
    const Surface_cell_3& place = m_blocks[cell].cell;
    const Parameters local{place.local_parameter(0, parameters[0]), place.local_parameter(1, parameters[1])};
    if (m_reach && power(cell)(local) > 0)
      return OUT_OF_REACH;
    return label_within(place, local, place.coordinates[3](local) > 0);
  }

private:
  // When it is asked for.
  const Cell_polynomial& power(std::size_t index)
  {
    const Bisector_block& block = m_blocks[index];
    std::optional<Cell_polynomial>& result = m_powers[index];
    if (!result)
      result = block.box.is_within || is_certainly_within(block.cell) ? Cell_polynomial::constant(2, Exact_rational(-1))
          : block.is_whole()                                          ? power_of_piece(block.piece)
                             : power_of_piece(block.piece).restricted_to_box(block.range());
    return *result;
  }

  const Cell_polynomial& power_of_piece(std::size_t piece)
  {
    std::optional<Cell_polynomial>& result = m_powers_of_pieces[piece];
    if (!result)
      result = power_of_distance(m_pieces[piece].cell.coordinates, constant_coordinates(m_reach->center),
                                 m_reach->squared_radius);
    return *result;
  }

  // By the control points, in doubles.
  bool is_certainly_within(const Surface_cell_3& cell) const
  {
    const Upward_rounding_guard guard;
    const std::array<Interval_net, 4> nets{Interval_net(cell.coordinates[0]), Interval_net(cell.coordinates[1]),
                                           Interval_net(cell.coordinates[2]), Interval_net(cell.coordinates[3])};
    const Interval_net::Interval weight = nets[3].bounds(), reach(to_double_interval(m_reach->squared_radius));
    if (weight.inf() <= 0 && weight.sup() >= 0)
      return false;
    const std::array<Exact_rational, 3> center{m_reach->center.x(), m_reach->center.y(), m_reach->center.z()};
    for (std::size_t k = 0; k < nets[3].values().size(); ++k) {
      Interval_net::Interval square(0);
      for (std::size_t c = 0; c < 3; ++c)
        square += CGAL::square(nets[c].values()[k] / nets[3].values()[k] -
                               Interval_net::Interval(to_double_interval(center[c])));
      if (!(square.sup() < reach.inf()))
        return false;
    }
    return true;
  }
};

// The regions of all continuous parts, whose pieces are cut into blocks; `faces_of(block)` are faces that other curves
// bound, or none.
template <class Label_within, class Blocks_of_piece, class Faces_of_block>
std::vector<Trimmed_surface_3> parts_of_bisector(const Rational_bisector_3& bisector, const std::optional<Reach>& reach,
                                                 const Label_within& label_within, Operation_budget& budget,
                                                 const Blocks_of_piece& blocks_of, const Faces_of_block& faces_of)
{
  if (!bisector.is_complete())
    throw Invalid_input("bisector_parts: pieces of the bisector were not computed");
  const Cell_functions<4> all = coordinates_on_bisector(bisector);
  std::vector<Trimmed_surface_3> result;
  for (const Continuous_part<4>& part : continuous_parts(all, false)) {
    Bisector_trimming cut(bisector, part.functions, reach, blocks_of, budget);
    Trimming trimming{cut.cells(),
                      {},
                      [&](std::size_t cell) { return cut.zeros(cell); },
                      [&](std::size_t cell, const Parameters& at) { return cut.label(cell, at, label_within); },
                      [&](std::size_t cell) -> std::optional<std::vector<Labelled_part>> {
                        std::optional<Cell_faces> faces = faces_of(cut.block(cell));
                        if (!faces)
                          return std::nullopt;
                        const Surface_cell_3::Range all(0, 1);
                        return std::vector<Labelled_part>{{{all, all}, *std::move(faces)}};
                      }};
    for (const int axis : {0, 1})
      if (part.functions.domain(axis) == all.domain(axis)) {
        const auto ratio = part.functions.ratio(axis, part.functions.size(axis) - 1, 0);
        trimming.is_closed[static_cast<std::size_t>(axis)] = ratio && *ratio > 0;
      }
    result.push_back(trimmed_by_zeros(trimming, budget));
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Trimmed_surface_3>
parts_of_bisector(const Rational_bisector_3& bisector, const std::optional<Reach>& reach, const Solver_options& options)
{
  Operation_budget budget(options);
  const auto label = [](const Surface_cell_3&, const Parameters&, bool is_positive) -> std::optional<int> {
    return is_positive ? WITH_POSITIVE_WEIGHT : WITH_NEGATIVE_WEIGHT;
  };
  const auto whole = [](std::size_t) { return Box_of_block(); };
  const auto no_faces = [](const Bisector_block&) { return std::nullopt; };
  return parts_of_bisector(bisector, reach, label, budget, whole, no_faces);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bisector_mesh_3 mesh_of_bisector(const Rational_bisector_3& bisector,
                                                                const Trimmed_surface_3& part, int label, double error,
                                                                const Solver_options& options)
{
  Bisector_mesh_3 result{mesh_of_label(part, label, error, options), {}, {}};
  auto& mesh = result.triangles.mesh;
  using Vertex = Bisector_mesh_3::Mesh::Vertex_index;
  for (const int operand : {0, 1})
    result.feet[static_cast<std::size_t>(operand)] =
        mesh.add_property_map<Vertex, Bisector_mesh_3::Point>("v:foot_" + std::to_string(operand)).first;
  result.distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  for (const Vertex vertex : mesh.vertices()) {
    const auto& parameters = result.triangles.parameters[vertex];
    for (const int operand : {0, 1}) {
      const auto foot = bisector.foot(operand, parameters.x(), parameters.y());
      result.feet[static_cast<std::size_t>(operand)][vertex] = {
          to_nearest_double(foot.x()), to_nearest_double(foot.y()), to_nearest_double(foot.z())};
    }
    result.distance[vertex] = std::sqrt(CGAL::squared_distance(mesh.point(vertex), result.feet[1][vertex]));
  }
  return result;
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_PARTS_OF_BISECTOR_H
