// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLUTION_SET_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLUTION_SET_D_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

A piece of the curve in which a surface of solutions meets a plane: an edge of the cell complex that the surface is.

Its points are a graph over one unknown in its box, as those of a `Curve_piece` are.
*/
struct Surface_arc
{
  //! the box; the range of `plane` is one number.
  Curve_vertex::Exact_box box;

  //! the unknown that the plane fixes.
  int plane;

  //! the unknown that the arc is a graph over.
  int parameter;

  //! indices of the vertices at its ends.
  std::array<std::size_t, 2> ends;

  //! number of patches that it bounds, one or two. On the boundary of the domain, or of an undecided region, it is one.
  int patches = 0;
};

/*!
\ingroup PkgSplineConstraintsDSolver

A part of a surface of solutions: a disk. In its box the solutions are a graph over two of the unknowns, above the part
of their plane that its boundary, seen along the others, is around. Or they are singular in one point inside of the box,
the apex of the patch: the cones with this apex over loops on the boundary of the box, each of which is a patch.
*/
struct Surface_patch
{
  //! an arc of the boundary, and whether it is followed from its second end to the first.
  struct Side
  {
    std::size_t arc;
    bool is_reversed;
  };

  //! the box.
  Curve_vertex::Exact_box box;

  //! the unknowns that the patch is a graph over; -1 for a patch with an apex.
  std::array<int, 2> parameters;

  //! the sign of the determinant of the derivatives of the equalities by all other unknowns, by proof the same on all
  //! of the box. It orients the patch: those that meet in an arc agree. It is 0 for a patch with an apex.
  int orientation;

  //! its boundary, one loop.
  std::vector<Side> boundary;

  //! index of the surface that it belongs to.
  std::size_t surface = 0;

  //! index of the vertex in which all solutions in the box meet, the only singular one, if the patch has an apex. It is
  //! a vertex of no arc; the solutions but for it are a cylinder over the boundary.
  std::optional<std::size_t> apex = std::nullopt;
};

/*!
\ingroup PkgSplineConstraintsDSolver

A connected surface of solutions.
*/
struct Solution_surface
{
  //! indices of its patches.
  std::vector<std::size_t> patches;

  //! vertices less arcs plus patches, where a vertex in which it meets itself counts as often as it does.
  int euler_characteristic;

  //! the loops that bound it, each with the indices of its arcs in order: on the boundary of the domain, where an
  //! inequality is zero, or around an undecided region. There are none on a closed surface.
  std::vector<std::vector<std::size_t>> boundary;

  //! whether it reaches an undecided region, so that it may go on there, and be the same as another surface.
  bool is_open_ended = false;

  //! whether it has no boundary.
  bool is_closed() const { return boundary.empty(); }

  //! number of its handles. Surfaces of solutions are orientable.
  int genus() const { return (2 - static_cast<int>(boundary.size()) - euler_characteristic) / 2; }
};

/*!
\ingroup PkgSplineConstraintsDSolver

A part of the domain where nothing is proved of a surface of solutions, but for its arcs on the boundary of the part.
*/
struct Undecided_surface_region
{
  //! boxes that are connected.
  std::vector<Curve_vertex::Exact_box> boxes;

  //! indices of the arcs where surfaces reach the region.
  std::vector<std::size_t> arcs;

  //! why it is undecided.
  Undecided_reason reason;
};

/*!
\ingroup PkgSplineConstraintsDSolver

All solutions of a system with two equalities less than unknowns: surfaces, whose topology is proved.

A surface is a complex of vertices, arcs and patches, which neighbours share. Nothing in it is joined by distance.
An inequality \f$g \geq 0\f$ is the equality \f$g = s\f$ with one more unknown, \f$s \geq 0\f$, and the other ones
likewise: so the boxes have one more range, that of \f$s\f$, for each inequality that does not hold everywhere in the
domain.
*/
class Surface_solution_set_d
{
  std::shared_ptr<const Constraint_system_d> m_system; // equalities with the unknowns of the boxes
  int m_dimension;
  std::vector<Curve_vertex> m_vertices;
  std::vector<Surface_arc> m_arcs;
  std::vector<Surface_patch> m_patches;
  std::vector<Solution_surface> m_surfaces;
  std::vector<std::size_t> m_points, m_singular_points;
  std::vector<Undecided_surface_region> m_undecided;
  Summary m_summary;

public:
  //! the parts of a solution, which refer to each other by indices. `system`: the equalities that the boxes belong to;
  //! `dimension`: how many of their unknowns are those of the problem.
  Surface_solution_set_d(std::shared_ptr<const Constraint_system_d> system, int dimension,
                         std::vector<Curve_vertex> vertices, std::vector<Surface_arc> arcs,
                         std::vector<Surface_patch> patches, std::vector<Solution_surface> surfaces,
                         std::vector<std::size_t> points, std::vector<std::size_t> singular_points,
                         std::vector<Undecided_surface_region> undecided, const Summary& summary)
    : m_system(std::move(system)), m_dimension(dimension), m_vertices(std::move(vertices)), m_arcs(std::move(arcs)),
      m_patches(std::move(patches)), m_surfaces(std::move(surfaces)), m_points(std::move(points)),
      m_singular_points(std::move(singular_points)), m_undecided(std::move(undecided)), m_summary(summary)
  {}

  //! the connected surfaces.
  const std::vector<Solution_surface>& surfaces() const { return m_surfaces; }

  //! the patches of all surfaces.
  const std::vector<Surface_patch>& patches() const { return m_patches; }

  //! the arcs of all patches.
  const std::vector<Surface_arc>& arcs() const { return m_arcs; }

  //! the vertices of all arcs.
  const std::vector<Curve_vertex>& vertices() const { return m_vertices; }

  //! indices of the vertices that are single points: a surface of solutions of the equalities only touches the domain
  //! there, from outside, or the point is isolated.
  const std::vector<std::size_t>& points() const { return m_points; }

  //! indices of the vertices where surfaces meet each other, or one itself, in a point, and of the apexes of patches.
  //! Singular points elsewhere are undecided.
  const std::vector<std::size_t>& singular_points() const { return m_singular_points; }

  //! number of unknowns of the problem. Ranges of boxes beyond are those of inequalities.
  int dimension() const { return m_dimension; }

  //! the equalities that the boxes belong to: with one unknown more for each inequality.
  const Constraint_system_d& system() const { return *m_system; }

  //! the sum over all surfaces.
  int euler_characteristic() const;

  //! number of loops that bound surfaces.
  std::size_t number_of_boundary_loops() const;

  //! where nothing is proved, with the boxes and the arcs of surfaces that end there.
  const std::vector<Undecided_surface_region>& undecided_regions() const { return m_undecided; }

  //! the same regions, with the box around each.
  std::vector<Undecided_part> undecided() const { return internal::parts_of_regions(m_undecided); }

  //! whether all solutions lie on the surfaces, or are points, by proof: nothing is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

//! writes one line with the counts; single points are counted as singular ones.
//! \relates Surface_solution_set_d
std::ostream& operator<<(std::ostream& out, const Surface_solution_set_d& set);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE int Surface_solution_set_d::euler_characteristic() const
{
  int result = 0;
  for (const Solution_surface& surface : m_surfaces)
    result += surface.euler_characteristic;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Surface_solution_set_d::number_of_boundary_loops() const
{
  std::size_t result = 0;
  for (const Solution_surface& surface : m_surfaces)
    result += surface.boundary.size();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Surface_solution_set_d& set)
{
  const bool is_complete = set.is_complete();
  const char* const least = is_complete ? "" : "at least ";
  return out << "surfaces: " << least << set.surfaces().size() << " components, Euler characteristic "
             << set.euler_characteristic() << ", " << set.number_of_boundary_loops() << " boundary loops, " << least
             << set.points().size() + set.singular_points().size() << " singular points, "
             << set.undecided_regions().size() << " undecided; complete: " << (is_complete ? "yes" : "no") << "; nodes "
             << set.summary().nodes << "; seconds " << set.summary().seconds;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLUTION_SET_D_H
