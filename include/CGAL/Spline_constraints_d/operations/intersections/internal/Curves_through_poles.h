// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_THROUGH_POLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_THROUGH_POLES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Joined_parts.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/equations_of_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A pole of a surface that is a common point with another one.
struct Common_pole
{
  Surface_pole pole;
  Curve_vertex::Exact_box box;   // all values of the unknowns that stand for it
  // how often the equation of the other surface, put into this one, has the factor that is zero at the pole; 0 if this
  // is not known
  int order;
  bool is_certain;               // whether it is known to be a common point
  bool is_on_edge;               // whether an edge of the other surface passes it
};

/*
What becomes of curves of common points at a pole, where the equation has been divided by the factor that is zero there:
it is zero at the pole for those parameters along it that are the directions of curves.

The pole is a regular point of a curve, which goes on, if the surface has a tangent plane there, two branches end in it
in directions with an angle of more than 90 degrees, and each counts as often as the factor: the terms of the least
degree, in coordinates of the tangent plane, are then a power of one linear form, and both directions are on its line.
Otherwise it is a singular point; unless it lies on an edge, where one branch or none is no singular point.
*/
class Curves_through_poles
{
  const Surface_equations& m_surfaces;
  std::vector<Curve_vertex> m_vertices;
  std::vector<Solution_curve> m_curves;
  std::vector<std::size_t> m_points, m_singular_points;
  std::vector<Undecided_region> m_undecided;
  Summary m_summary;
  std::vector<Seam_joints::Face> m_faces;   // in which curves may be joined

  struct Branch
  {
    std::size_t vertex;
    int multiplicity;
  };

public:
  Curves_through_poles(const Surface_equations& surfaces, const Curve_solution_set_d& set)
    : m_surfaces(surfaces), m_vertices(set.vertices()), m_curves(set.curves()), m_points(set.points()),
      m_singular_points(set.singular_points()), m_undecided(set.undecided_regions()), m_summary(set.summary())
  {}

  void add(const Common_pole& common)
  {
    const auto is_near = [&](const Exact_ranges& box) { return touch(box, common.box); };
    if (std::any_of(m_undecided.begin(), m_undecided.end(), [&](const Undecided_region& region) {
          return std::any_of(region.boxes.begin(), region.boxes.end(), is_near);
        }))
      return;
    const std::optional<std::vector<Branch>> branches = branches_at(common.pole);
    if (!branches || common.order == 0 || (branches->empty() && !common.is_certain))
      return leave_undecided(common);
    for (std::vector<std::size_t>* list : {&m_points, &m_singular_points})
      std::erase_if(*list, [&](std::size_t i) { return is_at(common.pole, i); });
    m_faces.emplace_back(common.pole.unknown, common.pole.value);
    const bool is_within_surfaces =
        m_surfaces.is_closed(common.pole.surface, 1 - common.pole.axis) && !common.is_on_edge;
    if (branches->size() >= 2 ? goes_on(common, *branches) : branches->size() == 1 && !is_within_surfaces)
      return;
    const bool is_singular = !branches->empty() || is_within_surfaces;
    for (const Branch& branch : *branches)
      m_vertices[branch.vertex].is_singular = true;
    (is_singular ? m_singular_points : m_points).push_back(m_vertices.size());
    m_vertices.push_back({common.box, true, is_singular, false});
  }

  Curve_solution_set_d solutions() &&
  {
    return Curve_solution_set_d(std::move(m_vertices), std::move(m_curves), std::move(m_points),
                                std::move(m_singular_points), std::move(m_undecided), m_summary);
  }

  const std::vector<Seam_joints::Face>& faces() const { return m_faces; }

private:
  bool is_at(const Surface_pole& pole, std::size_t vertex) const
  {
    const auto& [lower, upper] = m_vertices[vertex].box[pole.unknown];
    return lower == pole.value && upper == pole.value;
  }

  // None if a curve comes back to the pole in between.
  std::optional<std::vector<Branch>> branches_at(const Surface_pole& pole) const
  {
    std::vector<Branch> result;
    for (const Solution_curve& curve : m_curves)
      for (auto piece = curve.pieces.begin(); piece != curve.pieces.end(); ++piece)
        for (const int side : {0, 1})
          if (is_at(pole, piece->ends[side])) {
            if (curve.is_closed || (side == 0 ? piece != curve.pieces.begin() : piece + 1 != curve.pieces.end()))
              return std::nullopt;
            result.push_back({piece->ends[side], curve.multiplicity()});
          }
    return result;
  }

  bool goes_on(const Common_pole& common, const std::vector<Branch>& branches) const
  {
    const auto& [surface, axis, side, unknown, value] = common.pole;
    const Spline_patch<3>& patch = *m_surfaces.surface(surface).patch;
    const auto counts_as_factor = [&](const Branch& branch) {
      return branch.multiplicity == common.order && !m_vertices[branch.vertex].is_singular;
    };
    if (branches.size() != 2 || !std::all_of(branches.begin(), branches.end(), counts_as_factor) ||
        !tangents_at_pole(patch, axis, side))
      return false;
    const std::size_t along = m_surfaces.parameter(surface, 1 - axis).unknown;
    const auto direction = [&](const Branch& branch) {
      return directions_at_pole(patch, axis, side, m_vertices[branch.vertex].box[along]);
    };
    return dot(direction(branches[0]), direction(branches[1])).upper < 0;
  }

  void leave_undecided(const Common_pole& common)
  {
    Undecided_region region{{common.box}, {}, Undecided_reason::CONTINUUM};
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      if (is_at(common.pole, i))
        region.vertices.push_back(i);
    m_undecided.push_back(std::move(region));
    m_summary.is_complete = false;
    m_summary.why_not = Undecided_reason::CONTINUUM;
  }
};

// The poles of surfaces that lie on the other one, with the equations of surfaces as far as they are known.
class Common_poles
{
  const Surface_equations& m_surfaces;
  const std::function<const Power_polynomial*(std::size_t)> m_equation;   // of a surface
  Budgeted_solver m_solve;

public:
  Common_poles(const Surface_equations& surfaces, std::function<const Power_polynomial*(std::size_t)> equation,
               const Operation_budget& budget)
    : m_surfaces(surfaces), m_equation(std::move(equation)), m_solve(budget)
  {}

  std::vector<Common_pole> operator()()
  {
    std::vector<Common_pole> result;
    for (const Surface_pole& pole : m_surfaces.poles()) {
      Common_pole common{pole, domain_of(m_surfaces.system()), 0, true, false};
      common.box[pole.unknown] = {pole.value, pole.value};
      const bool has_unknowns = m_surfaces.has_unknowns(1 - pole.surface);
      if (has_unknowns && !find_on_patch(common))
        continue;
      common.order = order_at(pole);
      if (has_unknowns || common.order > 0)
        result.push_back(std::move(common));
    }
    return result;
  }

private:
  const Spline_patch<3>& patch(std::size_t surface) const { return *m_surfaces.surface(surface).patch; }

  bool has_pole(std::size_t surface, int axis, const Parameter_range& range) const
  {
    const std::vector<Surface_pole> poles = m_surfaces.poles();
    return std::any_of(poles.begin(), poles.end(), [&](const Surface_pole& pole) {
      return pole.surface == surface && pole.axis == axis && range.first <= pole.value && pole.value <= range.second;
    });
  }

  // How often the equation of the other surface has the factor that is zero at the pole; zero if this is not known.
  int order_at(const Surface_pole& pole) const
  {
    const Power_polynomial* const polynomial = m_equation(1 - pole.surface);
    if (!polynomial)
      return 0;
    const Constraint_system_d on_surface = incidence(*polynomial, patch(pole.surface));
    Spline_function equation = on_surface.equalities().front();
    return Face_factor::divide_out(equation, pole.axis, on_surface.domain(pole.axis), pole.value);
  }

  // Whether the other surface may have it, with the parameters there.
  bool find_on_patch(Common_pole& common)
  {
    const auto& [surface, axis, side, unknown, value] = common.pole;
    const Spline_patch<3> point(
        patch(surface).part(axis, {value, value})(std::array{patch(surface).domain(1 - axis).first}));
    const std::vector<Common_point> found = Intersection_finder<3>(Patch_pair<3>(point, patch(1 - surface)), m_solve)();
    common.is_certain = std::any_of(found.begin(), found.end(),
                                    [](const Common_point& x) { return x.kind != Intersection_kind::UNDECIDED; });
    for (std::size_t i = 0; i < found.size(); ++i)
      for (int other = 0; other < 2; ++other) {
        Parameter_range& range = common.box[m_surfaces.parameter(1 - surface, other).unknown];
        const Parameter_range& own = found[i].parameters[static_cast<std::size_t>(other)];
        common.is_on_edge = common.is_on_edge ||
            (found[i].is_at_end[static_cast<std::size_t>(other)] && !m_surfaces.is_closed(1 - surface, other) &&
             !has_pole(1 - surface, other, own));
        range =
            i == 0 ? own : Parameter_range((std::min)(range.first, own.first), (std::max)(range.second, own.second));
      }
    return !found.empty();
  }
};

// Curves of common points, where these go on at poles.
inline Solved_part joined_at_poles(Surface_equations surfaces, const Curve_solution_set_d& solutions,
                                   const std::vector<Common_pole>& poles)
{
  Curves_through_poles result(surfaces, solutions);
  for (const Common_pole& pole : poles)
    result.add(pole);
  std::vector<Seam_joints::Face> faces = result.faces();
  return {std::move(surfaces), std::move(result).solutions(), std::move(faces)};
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_THROUGH_POLES_H
