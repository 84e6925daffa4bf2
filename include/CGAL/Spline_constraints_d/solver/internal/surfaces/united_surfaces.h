// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_UNITED_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_UNITED_SURFACES_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Graph_box_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Factor_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/lone_curves.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Vertices of curves that no curve ends in.
inline std::vector<std::size_t> lone_points(const Curve_solution_set_d& set)
{
  std::set<std::size_t> ends;
  for (const Solution_curve& curve : set.curves())
    for (const Curve_piece& piece : curve.pieces)
      ends.insert(piece.ends.begin(), piece.ends.end());
  std::vector<std::size_t> result;
  for (const std::vector<std::size_t>* points : {&set.points(), &set.singular_points()})
    for (const std::size_t i : *points)
      if (ends.insert(i).second)
        result.push_back(i);
  return result;
}

// The solutions of a part in a face have the value of the face, exactly.
inline Surface_solution_set_d moved_to_faces(const Surface_solution_set_d& found, const Factor_system& part)
{
  std::vector<Surface_arc> arcs = found.arcs();
  std::vector<Surface_patch> patches = found.patches();
  std::vector<Curve_vertex> vertices = found.vertices();
  for (const auto& [axis, value] : part.faces) {
    for (Curve_vertex& vertex : vertices)
      vertex.box[axis] = {value, value};
    for (Surface_arc& arc : arcs)
      arc.box[axis] = {value, value};
    for (Surface_patch& patch : patches)
      patch.box[axis] = {value, value};
  }
  Surface_solution_set_d result{found.systems().front(), found.dimension(),       std::move(vertices),
                                std::move(arcs),         std::move(patches),      found.surfaces(),
                                found.points(),          found.singular_points(), found.undecided_regions(),
                                found.summary()};
  for (const Curve_solution_set_d& curves : found.lone_curves())
    result.add_lone_curves(moved_to_faces(curves, part.faces));
  return result;
}

// Where the surfaces of two parts of a system meet.
struct Meetings_of_parts
{
  std::vector<Surface_crossing> crossings;
  std::vector<Curve_vertex> touching; // points in which they have no more in common
  bool has_curves;                    // or faces, or this is not known
};

template <class Concurrency_tag>
Meetings_of_parts meetings_of(const std::vector<Factor_system>& parts, const Solver_options& options,
                              Run_control& control, Summary& work)
{
  Meetings_of_parts result{
      {}, {}, std::any_of(parts.begin(), parts.end(), [](const Factor_system& part) { return !part.faces.empty(); })};
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size(); ++k)
      if (const auto common = common_system(parts[i], parts[k])) {
        result.crossings.push_back(
            {{i, k},
             all_curves<Certified_solver_traits, Concurrency_tag>(*common, rest_of(options, work), control, {})});
        const Curve_solution_set_d& curves = result.crossings.back().curves;
        work.nodes += curves.summary().nodes;
        result.has_curves = result.has_curves || !curves.curves().empty() || !curves.is_complete();
        for (const std::size_t v : lone_points(curves))
          result.touching.push_back(curves.vertices()[v]);
      }
  return result;
}

// The surfaces of a system as it is, if they do not take many boxes.
template <class Traits, class Concurrency_tag>
std::optional<Surface_solution_set_d> surfaces_of_few_nodes(const Constraint_system_d& system,
                                                            const Solver_options& options, Run_control& control,
                                                            Summary& work)
{
  constexpr std::size_t few_nodes = 60000;
  Solver_options few = rest_of(options, work);
  few.node_limit = few.node_limit == 0 ? few_nodes : (std::min)(few.node_limit, few_nodes);
  Surface_solution_set_d result = all_surfaces<Traits, Concurrency_tag>(system, few, control);
  work.nodes += result.summary().nodes;
  if (!result.is_complete())
    return std::nullopt;
  result.set_work(work.nodes, control.seconds());
  return result;
}

// All of them side by side, each with the topology that it has alone.
template <class Traits, class Concurrency_tag>
Surface_solution_set_d surfaces_of_parts(const Constraint_system_d& system, const std::vector<Factor_system>& parts,
                                         const Solver_options& options, Run_control& control, Summary& work)
{
  std::optional<Surface_solution_set_d> result;
  for (const Factor_system& part : parts) {
    Surface_solution_set_d own = all_surfaces<Traits, Concurrency_tag>(part.system, rest_of(options, work), control);
    work.nodes += own.summary().nodes;
    own = moved_to_faces(own, part);
    if (result)
      result->add(own);
    else
      result = std::move(own);
  }
  if (!result) // there are no solutions
    result.emplace(std::make_shared<const Constraint_system_d>(system), system.dimension(), std::vector<Curve_vertex>(),
                   std::vector<Surface_arc>(), std::vector<Surface_patch>(), std::vector<Solution_surface>(),
                   std::vector<std::size_t>(), std::vector<std::size_t>(), std::vector<Undecided_surface_region>(),
                   Summary());
  return *std::move(result);
}

/*
The surfaces of the parts of a system, and the curves where two of them meet. Where they have no common curves but touch
in points, the system is solved as it is, if that does not take many boxes: then the disks that end in these points are
known.
*/
template <class Traits, class Concurrency_tag>
Surface_solution_set_d united_surfaces(const Constraint_system_d& system, const std::vector<Factor_system>& parts,
                                       const Solver_options& options, Run_control& control)
{
  Summary work;
  Meetings_of_parts meetings = meetings_of<Concurrency_tag>(parts, options, control, work);
  if (!meetings.has_curves && !meetings.touching.empty())
    if (auto whole = surfaces_of_few_nodes<Traits, Concurrency_tag>(system, options, control, work))
      return *std::move(whole);
  auto result = surfaces_of_parts<Traits, Concurrency_tag>(system, parts, options, control, work);
  for (Surface_crossing& crossing : meetings.crossings)
    result.add(std::move(crossing));
  result.set_work(work.nodes, control.seconds());
  if (result.system().dimension() == system.dimension())
    for (Curve_vertex& point : meetings.touching) {
      point.is_singular = true;
      result.add_singular_point(std::move(point));
    }
  return result;
}

template <class Traits, class Concurrency_tag>
Surface_solution_set_d surfaces_of_factors(const Constraint_system_d& system, const Solver_options& options,
                                           Run_control& control)
{
  check_codimension(system, 2, "solve_surfaces");
  const std::vector<Factor_system> parts = factor_systems(system);
  return is_split(system, parts) ? united_surfaces<Traits, Concurrency_tag>(system, parts, options, control)
                                 : all_surfaces<Traits, Concurrency_tag>(system, options, control);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_UNITED_SURFACES_H
