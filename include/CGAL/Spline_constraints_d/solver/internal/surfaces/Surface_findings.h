// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_FINDINGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_FINDINGS_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_finder.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A box that was left undecided, with the arcs on its boundary.
struct Undecided_surface_box
{
  Exact_ranges box;
  Arc_indices arcs;
  Undecided_reason reason;
};

// A face of the domain that has a part of its own: there the surfaces cross it where these equalities are zero, which
// are without what they only touch, and without edges.
struct Changed_face
{
  int axis;
  Exact_ranges box;           // of a cell, and where that unknown is fixed
  Constraint_system_d system; // in all unknowns

  // Whether it has a face of a box.
  bool has(int unknown, const Exact_rational& value, Exact_ranges around) const
  {
    around[unknown] = {value, value};
    return unknown == axis && is_within(around, box);
  }
};

// A box in a cell, with the arcs on its boundary.
struct Surface_task
{
  std::size_t cell;
  Exact_ranges box;
  Arc_indices arcs;
  int depth = 0;
};

// What a task may use up.
struct Task_budget
{
  std::size_t splits, nodes;
};

// What comes of a task.
struct Task_findings
{
  Arc_part arcs;
  Known_cones cones = {};
  std::vector<Surface_patch> patches = {};
  std::vector<std::size_t> points = {}; // vertices that are all of a surface in the domain
  std::vector<Undecided_surface_box> undecided = {};
  std::vector<Surface_task> pending = {}; // what is left when the budget is used up
  Summary summary = {};
};

// Whether a point on a face of the domain is the singular point of the surface that a box holds, which is exact where
// the singular point is on a face.
inline bool is_at(const Plane_point& on_face, const Exact_ranges& singular)
{
  return is_within(on_face.box, singular) || (on_face.is_singular && is_within(singular, on_face.box));
}

// What tasks know to begin with.
struct Task_environment
{
  const Exact_ranges& domain;                  // of the whole system
  const std::vector<Exact_ranges>& open_parts; // of planes: what was not decided there
  const std::vector<Plane_point>& touching;    // on faces of cells where no curve on the face ends
  const std::vector<Changed_face>& changed_faces;
  const Known_cones& cones;                    // in the cell
  std::size_t undecided;                       // boxes
  std::size_t number;                          // of the task
};

// What comes of all boxes.
struct Surface_findings
{
  Arc_store arcs = {};
  std::vector<Exact_ranges> open_parts = {}; // of planes: what was not decided there
  std::vector<Plane_point> touching = {};    // on faces of cells where no curve on the face ends
  std::vector<Changed_face> changed_faces = {};
  std::vector<Surface_patch> patches = {};
  std::vector<std::size_t> points = {}; // vertices that are all of a surface in the domain
  std::vector<Curve_solution_set_d> lone_curves = {}; // likewise
  std::vector<Undecided_surface_box> undecided = {};
  Summary summary = {};

  // Takes what a task has found; false, and only its work is counted, if its cuts of arcs do not go with those of
  // others. Then it is to be done again, after these are known.
  bool take(Task_findings& task)
  {
    summary += task.summary;
    Arc_part& part = task.arcs;
    if (!part.merge_into(arcs))
      return false;
    for (Surface_patch& patch : task.patches) {
      std::vector<Surface_patch::Side> boundary;
      for (const Surface_patch::Side& side : patch.boundary) {
        Arc_indices parts = part.parts(side.arc);
        if (side.is_reversed)
          std::reverse(parts.begin(), parts.end());
        for (const std::size_t a : parts)
          boundary.push_back({a, side.is_reversed});
      }
      patch.boundary = std::move(boundary);
      if (patch.apex)
        patch.apex = part.vertex(*patch.apex);
      patches.push_back(std::move(patch));
    }
    for (const std::size_t i : task.points)
      points.push_back(part.vertex(i));
    for (Undecided_surface_box& box : task.undecided) {
      box.arcs = part.parts(box.arcs);
      undecided.push_back(std::move(box));
    }
    for (Surface_task& pending : task.pending)
      pending.arcs = part.parts(pending.arcs);
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_FINDINGS_H
