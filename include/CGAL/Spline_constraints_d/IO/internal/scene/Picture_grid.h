// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PICTURE_GRID_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PICTURE_GRID_H

#include <CGAL/Spline_constraints_d/IO/internal/scene/Projected_facets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Scene {

/*
Which boxes meet a box: the picture is divided into equal cells, each of which knows the boxes that meet it.
*/
class Picture_grid
{
  int m_cells;
  std::array<double, 4> m_picture;
  std::vector<std::vector<std::size_t>> m_members;
  std::vector<std::array<double, 4>> m_boxes;
  mutable std::vector<std::size_t> m_last_query;
  mutable std::size_t m_queries = 0;

public:
  // For about so many boxes in a picture.
  Picture_grid(const std::array<double, 4>& picture, std::size_t boxes)
    : m_cells(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(boxes))), 1, 200)), m_picture(picture),
      m_members(static_cast<std::size_t>(m_cells) * m_cells)
  {
  }

  // Its index is the number of those before.
  void add(const std::array<double, 4>& box)
  {
    for_each_cell(box, [&](std::size_t cell) { m_members[cell].push_back(m_boxes.size()); });
    m_boxes.push_back(box);
    m_last_query.push_back(0);
  }

  // Calls visit(index) once for every box that meets another one.
  template <class Visit>
  void visit(const std::array<double, 4>& box, const Visit& visit) const
  {
    ++m_queries;
    for_each_cell(box, [&](std::size_t cell) {
      for (const std::size_t index : m_members[cell])
        if (m_last_query[index] != m_queries) {
          m_last_query[index] = m_queries;
          const auto& other = m_boxes[index];
          if (box[0] <= other[2] && other[0] <= box[2] && box[1] <= other[3] && other[1] <= box[3])
            visit(index);
        }
    });
  }

private:
  template <class Visit>
  void for_each_cell(const std::array<double, 4>& box, const Visit& visit) const
  {
    const auto cell = [&](double x, int axis) {
      const double extent = m_picture[axis + 2] - m_picture[axis];
      return static_cast<int>(std::clamp((x - m_picture[axis]) / extent * m_cells, 0., m_cells - 1.));
    };
    for (int i = cell(box[0], 0), last = cell(box[2], 0); i <= last; ++i)
      for (int j = cell(box[1], 1), top = cell(box[3], 1); j <= top; ++j)
        visit(static_cast<std::size_t>(i) * m_cells + j);
  }
};

} // namespace Scene
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SCENE_PICTURE_GRID_H
