// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_PARTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Monotone_cell.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Cuts the unit box until a label is the same on all of a part, or parts are `Monotone_cell`s; those that are small and
// neither are undecided.
class Monotone_parts
{
public:
  // The last argument says whether parts of the rectangle will be asked for.
  using Oracle = std::function<Box_answer(const Parameter_rectangle&, bool)>;

private:
  static constexpr int most_depth = 20, halvings_beside_the_middle = 4;

  const Oracle& m_oracle;
  const Monotone_cell::Oracle m_inner_oracle;
  const Monotone_cell::Side_oracle m_side_oracle;
  Operation_budget& m_budget;
  std::array<int, 2> m_labels; // of false and true
  std::string m_reason;
  std::vector<Labelled_part> m_parts;

public:
  //! \pre The oracle needs no other rounding mode than that of the calling thread.
  Monotone_parts(const Oracle& oracle, Monotone_cell::Side_oracle side_oracle, const std::array<int, 2>& labels,
                 std::string reason, Operation_budget& budget)
    : m_oracle(oracle), m_inner_oracle([this](const Parameter_rectangle& box) { return m_oracle(box, false); }),
      m_side_oracle(std::move(side_oracle)), m_budget(budget), m_labels(labels), m_reason(std::move(reason))
  {}

  std::vector<Labelled_part> parts(double error)
  {
    add({{{0, 1}, {0, 1}}}, {0, 0}, error);
    return std::move(m_parts);
  }

private:
  void add(const Parameter_rectangle& box, const std::array<int, 2>& depths, double error)
  {
    try {
      m_budget.check();
      Summary work;
      work.nodes = 1;
      m_budget.add(work);
      if (m_budget.has_reached_node_limit())
        throw Run_stopped{Undecided_reason::NODES};
      const Box_answer answer = m_oracle(box, true);
      std::optional<Cell_faces> found;
      if (answer.label)
        found = Monotone_cell::whole(box, *answer.label);
      else if (!answer.directions.is_empty())
        found = Monotone_cell(m_inner_oracle, box, answer.directions, error).faces();
      else if (answer.fold)
        found = Monotone_cell(m_inner_oracle, m_side_oracle, box, *answer.fold, error).faces();
      if (found) {
        for (Surface_face_3& face : found->faces)
          face.label = m_labels[static_cast<std::size_t>(*face.label)];
        m_parts.push_back({exact(box), std::move(*found)});
        return;
      }
      if (depths[0] + depths[1] < most_depth) {
        cut(box, depths, answer.directions, error);
        return;
      }
      add_undecided(box, m_reason);
    } catch (const Run_stopped& stop) {
      add_undecided(box, in_words(stop.reason));
    }
  }

  // Across the axis that is longer, or along which the label is not known to change once only. Not in the middle at
  // first, where lines of symmetry are.
  void cut(const Parameter_rectangle& box, std::array<int, 2> depths, const Direction_set& directions, double error)
  {
    const auto is_monotone = [&](std::size_t axis) {
      return directions.contains_axis(axis, true) || directions.contains_axis(axis, false);
    };
    constexpr int most_difference = 6;
    std::size_t axis = depths[0] <= depths[1] ? 0 : 1;
    for (const std::size_t other : {0, 1})
      if (is_monotone(1 - other) && !is_monotone(other) && depths[other] < depths[1 - other] + most_difference)
        axis = other;
    const auto [begin, end] = box[axis];
    const double place = depths[axis] < halvings_beside_the_middle ? 0.46875 : 0.5;
    const double middle = begin + place * (end - begin);
    ++depths[axis];
    Parameter_rectangle lower = box, upper = box;
    lower[axis].second = upper[axis].first = middle;
    add(lower, depths, error);
    add(upper, depths, error);
  }

  static std::array<Surface_cell_3::Range, 2> exact(const Parameter_rectangle& box)
  {
    return {Surface_cell_3::Range(box[0].first, box[0].second), Surface_cell_3::Range(box[1].first, box[1].second)};
  }

  void add_undecided(const Parameter_rectangle& box, const std::string& reason)
  {
    Cell_faces nothing;
    nothing.undecided.push_back({{box[0], box[1]}, {}, reason});
    m_parts.push_back({exact(box), std::move(nothing)});
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_MONOTONE_PARTS_H
