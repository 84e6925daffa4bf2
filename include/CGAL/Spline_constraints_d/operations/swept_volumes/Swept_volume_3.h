// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUME_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUME_3_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/number_of_components.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

A cell of what a moving solid sweeps, or of what it leaves free, that is no deeper than the chord error that was asked
for: it was taken as a part of the neighbours with the largest common area, or so that the boundary is simpler.
*/
struct Thin_cell
{
  CGAL::Simple_cartesian<double>::Point_3 point; ///< a point of its boundary
  double depth; ///< how far its deepest point is from the boundary: of points that were found, or less by its volume
};

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

What a moving solid sweeps, by its boundary: see `swept_volume()`.
*/
class Swept_volume_3
{
public:
  //! the mesh, in doubles.
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

private:
  Mesh m_mesh;
  double m_error = 0;
  std::vector<Thin_cell> m_thin_cells;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what the operation has found.
  Swept_volume_3(Mesh mesh, double error, std::vector<Thin_cell> thin_cells, std::vector<Undecided_part> undecided,
                 const Summary& summary)
    : m_mesh(std::move(mesh)), m_error(error), m_thin_cells(std::move(thin_cells)), m_undecided(std::move(undecided)),
      m_summary(summary)
  {}

  //! the boundary, closed, with normals that point outwards. Edges and vertices where it touches itself are there once
  //! for each part of the inside that meets there. Handles thinner than the chord error are closed by two disks in the
  //! same place, if the center of the disk is proved to be on the other side.
  const Mesh& mesh() const { return m_mesh; }

  //! how far the triangles are from the boundary: the chord error that was asked for, or what was measured if that is
  //! more.
  double error() const { return m_error; }

  //! number of connected parts of the boundary.
  std::size_t number_of_components() const { return internal::Swept_volumes::number_of_components(m_mesh); }

  //! of the boundary.
  int euler_characteristic() const
  {
    return static_cast<int>(m_mesh.number_of_vertices()) - static_cast<int>(m_mesh.number_of_edges()) +
        static_cast<int>(m_mesh.number_of_faces());
  }

  //! the volume that the mesh bounds.
  double volume() const
  {
    double result = 0;
    for (const auto face : m_mesh.faces()) {
      const auto [p, q, r] = corners(face);
      result += CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) / 6;
    }
    return result;
  }

  //! the area of the mesh.
  double area() const
  {
    double result = 0;
    for (const auto face : m_mesh.faces()) {
      const auto [p, q, r] = corners(face);
      result += std::sqrt(CGAL::squared_area(p, q, r));
    }
    return result;
  }

  //! cells that were too thin to be decided.
  const std::vector<Thin_cell>& thin_cells() const { return m_thin_cells; }

  //! whether all of the boundary is there, as fine as was asked for; every cell deeper than the chord error was
  //! decided; and no thin cell could change the number of components or the Euler characteristic. Handles thinner than
  //! the chord error are not seen.
  bool is_complete() const { return m_undecided.empty() && m_summary.is_complete; }

  //! what is undecided.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work.
  const Summary& summary() const { return m_summary; }

private:
  std::array<Mesh::Point, 3> corners(Mesh::Face_index face) const
  {
    const auto h = m_mesh.halfedge(face);
    return {m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
            m_mesh.point(m_mesh.target(m_mesh.next(h)))};
  }
};

//! writes one line with the counts, and whether they are proved.
//! \relates Swept_volume_3
inline std::ostream& operator<<(std::ostream& out, const Swept_volume_3& volume)
{
  return out << "boundary: " << (volume.is_complete() ? "" : "not proved, ") << volume.number_of_components()
             << " components, Euler characteristic " << volume.euler_characteristic() << ", volume " << volume.volume()
             << ", area " << volume.area() << ", " << volume.thin_cells().size() << " thin cells, "
             << volume.undecided().size() << " undecided; complete: " << (volume.is_complete() ? "yes" : "no")
             << "; nodes " << volume.summary().nodes << "; seconds " << volume.summary().seconds;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUME_3_H
