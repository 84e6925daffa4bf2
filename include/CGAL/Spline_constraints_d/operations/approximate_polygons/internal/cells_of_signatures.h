// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_CELLS_OF_SIGNATURES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_CELLS_OF_SIGNATURES_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/Signature_cells_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Banded_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/parts_of_plane.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

using Common::Run_of_steps;

// Parts of the plane, and of those within one zone of each band, the signatures that points have there.
class Cell_collector
{
  const Banded_polygon_2& m_polygon;
  Run_of_steps m_run;
  std::vector<Part_of_plane> m_left;
  std::map<std::string, Signature_cell_2> m_cells;

  // All signatures that differ in the edges alone whose lines pass through the part. False, if the run ends before.
  bool add_signatures(const Part_of_plane& part)
  {
    const Location_rule location(m_polygon, part);
    std::string signature(m_polygon.size(), 'L');
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < signature.size(); ++i)
      if (part.zones[i] == Zone::INNER)
        signature[i] = 'R';
      else if (part.zones[i] != Zone::OUTER)
        open.push_back(i);
    for (;;) {
      if (m_run.must_stop())
        return false;
      Signature_cell_2& cell =
          m_cells.try_emplace(signature, Signature_cell_2{signature, location(signature), {}}).first->second;
      CGAL_assertion(cell.location == location(signature));
      cell.parts.emplace_back(part.corners.begin(), part.corners.end());
      auto next = std::find_if(open.begin(), open.end(), [&](std::size_t i) { return signature[i] == 'L'; });
      std::for_each(open.begin(), next, [&](std::size_t i) { signature[i] = 'L'; });
      if (next == open.end())
        return true;
      signature[*next] = 'R';
    }
  }

public:
  Cell_collector(const Banded_polygon_2& polygon, const Solver_options& options)
    : m_polygon(polygon), m_run(options), m_left{whole_plane(polygon)}
  {}

  void run()
  {
    while (!m_left.empty() && !m_run.must_stop()) {
      const Part_of_plane part = m_left.back();
      const std::size_t band = part.zones.size();
      if (band == m_polygon.size()) {
        if (!add_signatures(part))
          return;
        m_left.pop_back();
      } else {
        m_left.pop_back();
        add_cut_parts(part, m_polygon.bands[band], std::nullopt, m_left);
      }
    }
  }

  Signature_cells_2 result() &&
  {
    std::vector<Signature_cell_2> cells;
    for (auto& [signature, cell] : m_cells)
      cells.push_back(std::move(cell));
    std::vector<Undecided_part> undecided;
    for (const Part_of_plane& part : m_left) {
      const CGAL::Bbox_2 box = CGAL::bbox_2(part.corners.begin(), part.corners.end());
      undecided.push_back({{{box.xmin(), box.xmax()}, {box.ymin(), box.ymax()}}, {}, in_words(m_run.reason())});
    }
    return {std::move(cells), m_polygon.window, std::move(undecided), m_run.summary(m_left.empty())};
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Signature_cells_2 cells_of_signatures(const Banded_polygon_2& polygon,
                                                                     const Solver_options& options)
{
  Cell_collector collector(polygon, options);
  collector.run();
  return std::move(collector).result();
}

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_CELLS_OF_SIGNATURES_H
