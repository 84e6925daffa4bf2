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

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// One of the n times n equal parts of a cell.
inline Surface_cell_3 part_of_cell(const Surface_cell_3& cell, const std::array<int, 2>& at, int n)
{
  Surface_cell_3 result;
  std::vector<Surface_cell_3::Range> box;
  for (const std::size_t axis : {0, 1}) {
    box.emplace_back(Exact_rational(at[axis]) / n, Exact_rational(at[axis] + 1) / n);
    result.domain[axis] = {cell.parameter(static_cast<int>(axis), box.back().first),
                           cell.parameter(static_cast<int>(axis), box.back().second)};
  }
  for (std::size_t c = 0; c < 4; ++c)
    result.coordinates[c] = cell.coordinates[c].restricted_to_box(box);
  return result;
}

// The cells of a continuous part, whose weights have no jumps, each cut into n times n.
inline std::vector<Surface_cell_3> cells_of(const Cell_functions<4>& part, int n, const Operation_budget& budget)
{
  std::array<std::vector<Cell_polynomial>, 4> pieces;
  const std::array<Exact_function, 4> splines = part.splines();
  for (std::size_t i = 0; i < 4; ++i)
    pieces[i] = splines[i].bezier_pieces();
  std::vector<Surface_cell_3> result;
  std::size_t k = 0;
  for (std::size_t i = 1; i < part.breaks(0).size(); ++i)
    for (std::size_t j = 1; j < part.breaks(1).size(); ++j, ++k) {
      const Surface_cell_3 piece{{Surface_cell_3::Range(part.breaks(0)[i - 1], part.breaks(0)[i]),
                                  Surface_cell_3::Range(part.breaks(1)[j - 1], part.breaks(1)[j])},
                                 {pieces[0][k], pieces[1][k], pieces[2][k], pieces[3][k]}};
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          if (n > 1)
            budget.check();
          result.push_back(n == 1 ? piece : part_of_cell(piece, {a, b}, n));
        }
    }
  return result;
}

// Cuts a continuous part at its poles, or at a sphere.
class Bisector_trimming
{
  std::vector<Surface_cell_3> m_cells;
  std::optional<Reach> m_reach;
  std::vector<std::optional<Cell_polynomial>> m_powers; // of the cells: positive out of reach

public:
  Bisector_trimming(const Cell_functions<4>& part, const std::optional<Reach>& reach, int n,
                    const Operation_budget& budget)
    : m_cells(cells_of(part, n, budget)), m_reach(reach), m_powers(m_cells.size())
  {}

  const std::vector<Surface_cell_3>& cells() const { return m_cells; }

  std::vector<Cell_polynomial> zeros(std::size_t cell)
  {
    return {m_reach ? power(cell) : m_cells[cell].coordinates[3]};
  }

  // `label_within(cell, parameters in its unit box, whether the weight is positive)` within reach.
  template <class Label_within>
  std::optional<int> label(std::size_t cell, const Parameters& parameters, const Label_within& label_within)
  {
    const Surface_cell_3& place = m_cells[cell];
    const Parameters local{place.local_parameter(0, parameters[0]), place.local_parameter(1, parameters[1])};
    if (m_reach && power(cell)(local) > 0)
      return OUT_OF_REACH;
    return label_within(place, local, place.coordinates[3](local) > 0);
  }

private:
  // When it is asked for.
  const Cell_polynomial& power(std::size_t index)
  {
    const Surface_cell_3& cell = m_cells[index];
    std::optional<Cell_polynomial>& result = m_powers[index];
    if (!result)
      result = is_certainly_within(cell)
          ? Cell_polynomial::constant(2, Exact_rational(-1))
          : power_of_distance(cell.coordinates, constant_coordinates(m_reach->center), m_reach->squared_radius);
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

// The regions of all continuous parts, whose pieces are cut into n times n cells.
template <class Label_within>
std::vector<Trimmed_surface_3> parts_of_bisector(const Rational_bisector_3& bisector, const std::optional<Reach>& reach,
                                                 const Label_within& label_within, Operation_budget& budget, int n = 1)
{
  if (!bisector.is_complete())
    throw Invalid_input("bisector_parts: pieces of the bisector were not computed");
  const Cell_functions<4> all = coordinates_on_bisector(bisector);
  std::vector<Trimmed_surface_3> result;
  for (const Continuous_part<4>& part : continuous_parts(all, false)) {
    Bisector_trimming cut(part.functions, reach, n, budget);
    Trimming trimming{cut.cells(),
                      {},
                      [&](std::size_t cell) { return cut.zeros(cell); },
                      [&](std::size_t cell, const Parameters& at) { return cut.label(cell, at, label_within); }};
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
  return parts_of_bisector(bisector, reach, label, budget);
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
