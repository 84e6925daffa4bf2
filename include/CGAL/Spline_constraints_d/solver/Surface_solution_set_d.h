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

  //! index of the vertex in which all solutions in the box meet, the only singular one, if the patch has an apex. If no
  //! arc ends there, the solutions but for it are a cylinder over the boundary. Otherwise faces of the domain cross
  //! there: the boundary goes through it, and the solutions are a cone over the arcs that do not lie on these faces.
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

  //! index of the system that it solves, see `Surface_solution_set_d::systems()`.
  std::size_t system = 0;

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

Where surfaces meet that solve different factors of an equality.
*/
struct Surface_crossing
{
  //! indices of the systems that they solve.
  std::array<std::size_t, 2> systems;

  //! the common solutions, in the unknowns of the problem: curves, and points where surfaces touch.
  Curve_solution_set_d curves;
};

/*!
\ingroup PkgSplineConstraintsDSolver

All solutions of a system with two equalities less than unknowns: surfaces, whose topology is proved.

A surface is a complex of vertices, arcs and patches, which neighbours share. Nothing in it is joined by distance.
An inequality \f$g \geq 0\f$ is the equality \f$g = s\f$ with one more unknown, \f$s \geq 0\f$, and the other ones
likewise: so the boxes have one more range, that of \f$s\f$, for each inequality that does not hold everywhere in the
domain.

Where an equality is a product whose factors have common curves of zeros, or has a factor that is zero on a face of the
domain, each surface solves one of several systems, with one factor each; `crossings()` tells where those of two systems
meet. Surfaces of different systems do not share cells.
*/
class Surface_solution_set_d
{
  std::vector<std::shared_ptr<const Constraint_system_d>> m_systems; // equalities with the unknowns of the boxes
  int m_dimension;
  std::vector<Curve_vertex> m_vertices;
  std::vector<Surface_arc> m_arcs;
  std::vector<Surface_patch> m_patches;
  std::vector<Solution_surface> m_surfaces;
  std::vector<std::size_t> m_points, m_singular_points;
  std::vector<Undecided_surface_region> m_undecided;
  Summary m_summary;
  std::vector<Surface_crossing> m_crossings;
  std::vector<Curve_solution_set_d> m_lone_curves;

public:
  //! the parts of a solution, which refer to each other by indices. `system`: the equalities that the boxes belong to;
  //! `dimension`: how many of their unknowns are those of the problem.
  Surface_solution_set_d(std::shared_ptr<const Constraint_system_d> system, int dimension,
                         std::vector<Curve_vertex> vertices, std::vector<Surface_arc> arcs,
                         std::vector<Surface_patch> patches, std::vector<Solution_surface> surfaces,
                         std::vector<std::size_t> points, std::vector<std::size_t> singular_points,
                         std::vector<Undecided_surface_region> undecided, const Summary& summary)
    : m_systems{std::move(system)}, m_dimension(dimension), m_vertices(std::move(vertices)), m_arcs(std::move(arcs)),
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

  //! the equalities that the boxes belong to: with one unknown more for each inequality. The first of the systems.
  const Constraint_system_d& system() const { return *m_systems.front(); }

  //! all systems, one as a rule. In one that stands for a face of the domain, the range of its unknown is wider.
  const std::vector<std::shared_ptr<const Constraint_system_d>>& systems() const { return m_systems; }

  //! the system that a patch solves.
  const Constraint_system_d& system_of_patch(std::size_t patch) const
  {
    return *m_systems[m_surfaces[m_patches[patch].surface].system];
  }

  //! where surfaces of two systems that differ in one factor have common points. Those of others meet there only, too.
  const std::vector<Surface_crossing>& crossings() const { return m_crossings; }

  //! curves that no surface is around, in the unknowns of the boxes: a surface of solutions of the equalities only
  //! touches a face of the domain there, or an edge, from outside. One set for each such face or edge.
  const std::vector<Curve_solution_set_d>& lone_curves() const { return m_lone_curves; }

  //! adds the surfaces of other systems with the same unknowns.
  void add(const Surface_solution_set_d& others);

  //! adds what is known of common points of surfaces of two systems.
  void add(Surface_crossing crossing);

  //! adds curves that no surface is around.
  void add_lone_curves(Curve_solution_set_d curves) { m_lone_curves.push_back(std::move(curves)); }

  //! adds a point where surfaces of two systems touch.
  void add_singular_point(Curve_vertex point)
  {
    m_singular_points.push_back(m_vertices.size());
    m_vertices.push_back(std::move(point));
  }

  //! counts other work too.
  void set_work(std::size_t nodes, double seconds)
  {
    m_summary.nodes = nodes;
    m_summary.seconds = seconds;
  }

  //! the sum over all surfaces.
  int euler_characteristic() const;

  //! number of loops that bound surfaces.
  std::size_t number_of_boundary_loops() const;

  //! where nothing is proved, with the boxes and the arcs of surfaces that end there.
  const std::vector<Undecided_surface_region>& undecided_regions() const { return m_undecided; }

  //! the same regions, with the box around each.
  //! what is undecided of crossings, and of curves alone, comes last.
  std::vector<Undecided_part> undecided() const;

  //! whether all solutions lie on the surfaces, or are points and curves alone, by proof, and crossings are known:
  //! nothing is undecided.
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

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_solution_set_d::add(const Surface_solution_set_d& others)
{
  const std::size_t vertices = m_vertices.size(), arcs = m_arcs.size(), patches = m_patches.size(),
                    surfaces = m_surfaces.size(), systems = m_systems.size();
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  const auto append_shifted = [](std::vector<std::size_t>& all, const std::vector<std::size_t>& more, std::size_t by) {
    for (const std::size_t i : more)
      all.push_back(i + by);
  };
  append(m_systems, others.m_systems);
  append(m_vertices, others.m_vertices);
  for (Surface_arc arc : others.m_arcs) {
    for (std::size_t& end : arc.ends)
      end += vertices;
    m_arcs.push_back(std::move(arc));
  }
  for (Surface_patch patch : others.m_patches) {
    for (Surface_patch::Side& side : patch.boundary)
      side.arc += arcs;
    patch.surface += surfaces;
    if (patch.apex)
      *patch.apex += vertices;
    m_patches.push_back(std::move(patch));
  }
  for (Solution_surface surface : others.m_surfaces) {
    for (std::size_t& patch : surface.patches)
      patch += patches;
    for (std::vector<std::size_t>& loop : surface.boundary)
      for (std::size_t& arc : loop)
        arc += arcs;
    surface.system += systems;
    m_surfaces.push_back(std::move(surface));
  }
  append_shifted(m_points, others.m_points, vertices);
  append_shifted(m_singular_points, others.m_singular_points, vertices);
  for (Undecided_surface_region region : others.m_undecided) {
    for (std::size_t& arc : region.arcs)
      arc += arcs;
    m_undecided.push_back(std::move(region));
  }
  for (const Surface_crossing& crossing : others.m_crossings)
    m_crossings.push_back({{crossing.systems[0] + systems, crossing.systems[1] + systems}, crossing.curves});
  append(m_lone_curves, others.m_lone_curves);
  m_summary += others.m_summary;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_solution_set_d::add(Surface_crossing crossing)
{
  m_summary += crossing.curves.summary();
  const bool is_empty = crossing.curves.vertices().empty() && crossing.curves.is_complete();
  if (!is_empty)
    m_crossings.push_back(std::move(crossing));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Undecided_part> Surface_solution_set_d::undecided() const
{
  std::vector<Undecided_part> result = internal::parts_of_regions(m_undecided);
  const auto append = [&](const Curve_solution_set_d& curves) {
    for (Undecided_part& part : curves.undecided())
      result.push_back(std::move(part));
  };
  for (const Surface_crossing& crossing : m_crossings)
    append(crossing.curves);
  for (const Curve_solution_set_d& curves : m_lone_curves)
    append(curves);
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
  std::size_t crossing_curves = 0, lone_curves = 0;
  for (const Surface_crossing& crossing : set.crossings())
    crossing_curves += crossing.curves.curves().size();
  for (const Curve_solution_set_d& curves : set.lone_curves())
    lone_curves += curves.curves().size();
  out << "surfaces: " << least << set.surfaces().size() << " components, Euler characteristic "
      << set.euler_characteristic() << ", " << set.number_of_boundary_loops() << " boundary loops, " << least
      << set.points().size() + set.singular_points().size() << " singular points, " << set.undecided().size()
      << " undecided; complete: " << (is_complete ? "yes" : "no") << "; nodes " << set.summary().nodes << "; seconds "
      << set.summary().seconds;
  if (crossing_curves > 0)
    out << "; crossing in " << crossing_curves << " curves";
  if (lone_curves > 0)
    out << "; touching the domain in " << lone_curves << " curves";
  return out;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLUTION_SET_D_H
