// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_3_H

#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

A face of the domain of the unknowns where an operand has a pole: an edge that is one point, with one tangent plane.
*/
struct Envelope_pole
{
  int unknown;          ///< the unknown that is constant
  Exact_rational value; ///< its value

  //! whether each connected curve of solutions there stands for one point of space; if not, each stands for the same
  //! curve as another one, and the surface goes on from one to the other.
  bool is_one_point;
};

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

A part of an envelope surface: the solutions of one system, and the map that takes them to space.
*/
struct Envelope_part_3
{
  //! surfaces of solutions; the unknowns are those of the operation. Where they are cut along `cusps`, the solver has
  //! one more, which is zero there.
  Surface_solution_set_d solutions;

  //! the point of space that a solution stands for.
  Vector_expression<3> image;

  //! the unknowns whose first and last value stand for the same points, with the same equations: the surface goes on
  //! there.
  std::vector<int> closed_unknowns;

  //! where operands have poles.
  std::vector<Envelope_pole> poles = {};

  //! the curves of solutions whose images are cuspidal edges, or points, where that is looked for; nothing if it is
  //! not. They are those of the same unknowns.
  std::optional<Curve_solution_set_d> cusps = std::nullopt;

  //! the unknown that has one value on all of the part, with this value: a line of a surface touches its envelope all
  //! the time.
  std::optional<std::pair<int, Exact_rational>> constant_unknown = std::nullopt;

  //! of bisectors and sectors: the points of the operands where spheres around the point of space touch them.
  std::vector<Vector_expression<3>> feet = {};

  //! of bisectors and sectors of two surfaces: 1 if the spheres are on the sides of the normals of both or of neither,
  //! -1 if they are on that of one.
  int product_of_sides = 0;
};

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

A surface in space that is the image of surfaces of solutions, with a proved topology: the envelope of a moving surface,
an offset, a bisector. It is not trimmed: it may cross itself, and have cuspidal edges.

The domain of the unknowns is cut into parts where an equation jumps, as along creases of operands.
*/
class Envelope_surface_3
{
  std::vector<Envelope_part_3> m_parts;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! exact numbers.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;

  //! what an operation has found.
  Envelope_surface_3(std::vector<Envelope_part_3> parts, std::vector<Undecided_part> undecided, const Summary& summary)
    : m_parts(std::move(parts)), m_undecided(std::move(undecided)), m_summary(summary)
  {
    for (const Envelope_part_3& part : m_parts) {
      for (Undecided_part& place : part.solutions.undecided())
        m_undecided.push_back(std::move(place));
      if (part.cusps)
        for (Undecided_part& place : part.cusps->undecided()) {
          place.reason += ", a cuspidal edge";
          m_undecided.push_back(std::move(place));
        }
    }
  }

  //! the parts.
  const std::vector<Envelope_part_3>& parts() const { return m_parts; }

  //! the point of space of unknowns of a part, exactly.
  //! \throws Invalid_input when they are outside of the domain, or the point is at infinity.
  Kernel::Point_3 point(std::size_t part, std::span<const Exact_rational> unknowns) const
  {
    const auto [x, y, z] = m_parts[part].image(unknowns);
    return {x, y, z};
  }

  //! vertices less arcs plus patches, where those on both sides of a seam or at a pole are one. Parts with a common
  //! boundary are not joined.
  int euler_characteristic() const;

  //! whether all of the surface is there, by proof: nothing is undecided.
  bool is_complete() const { return m_undecided.empty() && m_summary.is_complete; }

  //! what is undecided; places are ranges of the unknowns.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work.
  const Summary& summary() const { return m_summary; }

  /*!
  triangles, see `to_surface_mesh()`: vertices have all unknowns, the normal and the curvatures as properties, and the
  distances from the points `feet` as the property map `"v:distances"` of `std::vector<double>`. Edges on boundaries and
  breaks of splines are features. Triangles are joined across seams and poles; vertices there have the first value of an
  unknown that has two.
  \param options how fine the triangles are, in space.
  \param run the limit of time, and a visitor. What was not done in time is undecided.
  \throws Invalid_input when a bound is not positive.
  */
  Solution_surface_mesh mesh(const Surface_mesh_options& options = {}, const Solver_options& run = {}) const;
};

//! writes one line with the counts.
//! \relates Envelope_surface_3
std::ostream& operator<<(std::ostream& out, const Envelope_surface_3& surface);

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_3_H
