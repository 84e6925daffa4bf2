// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_3_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_face_3.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

A rational surface with exact coefficients, and regions of its domain that curves bound. The curves are the zeros of
exact functions of the parameters, with their topology by proof. Each face that they leave has a label, decided by exact
arithmetic at one rational point of it; faces with the same label that are neighbours are one region.
*/
class Trimmed_surface_3
{
public:
  //! the kernel of points.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;

private:
  std::vector<Surface_cell_3> m_cells;
  std::vector<Surface_face_3> m_faces;
  std::vector<Surface_region_3> m_regions;
  std::vector<Surface_border_3> m_borders;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what an operation has found.
  Trimmed_surface_3(std::vector<Surface_cell_3> cells, std::vector<Surface_face_3> faces,
                    std::vector<Surface_region_3> regions, std::vector<Surface_border_3> borders,
                    std::vector<Undecided_part> undecided, const Summary& work)
    : m_cells(std::move(cells)), m_faces(std::move(faces)), m_regions(std::move(regions)),
      m_borders(std::move(borders)), m_undecided(std::move(undecided)), m_summary(work)
  {
    m_summary.is_complete = m_undecided.empty();
  }

  //! the polynomial pieces of the surface, or parts of these.
  const std::vector<Surface_cell_3>& cells() const { return m_cells; }

  //! the faces, cell by cell. Undecided cells have none.
  const std::vector<Surface_face_3>& faces() const { return m_faces; }

  //! the regions.
  const std::vector<Surface_region_3>& regions() const { return m_regions; }

  //! the borders of cells, in the order of cells.
  const std::vector<Surface_border_3>& borders() const { return m_borders; }

  //! the number of regions with this label.
  std::size_t number_of_regions(int label) const
  {
    return static_cast<std::size_t>(
        std::ranges::count_if(m_regions, [&](const Surface_region_3& region) { return region.label == label; }));
  }

  //! whether the faces cover the surface, all have labels, and it is known which are connected; by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! cells without faces, faces without labels, and borders between cells across which connections are not known, with
  //! boxes of parameters.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work.
  const Summary& summary() const { return m_summary; }

  //! the point at parameters. \throws Invalid_input when they are outside of all cells, or at a pole.
  Kernel::Point_3 point(const Exact_rational& u, const Exact_rational& v) const
  {
    const auto cell = std::ranges::find_if(m_cells, [&](const Surface_cell_3& c) { return c.contains(u, v); });
    if (cell == m_cells.end())
      throw Invalid_input("Trimmed_surface_3: parameters outside of the domain");
    const std::array<Exact_rational, 2> local{cell->local_parameter(0, u), cell->local_parameter(1, v)};
    const auto& [x, y, z, w] = cell->coordinates;
    const Exact_rational weight = w(local);
    if (weight == 0)
      throw Invalid_input("Trimmed_surface_3: a pole of the surface");
    return {Exact_rational(x(local) / weight), Exact_rational(y(local) / weight), Exact_rational(z(local) / weight)};
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_3_H
