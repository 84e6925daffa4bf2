// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_NORMAL_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_NORMAL_FINDER_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Common_motions.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distance.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_common_normals.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
Finds the common normals of two surfaces: A - B is orthogonal to both tangents of A, and the normal of A to both
tangents of B. Common points of the surfaces are solutions only where they touch, other than with the gradient of
|A - B|^2.
*/
class Common_normal_finder
{
  using Box = Parameter_box;

  const std::array<Spline_patch<3>, 2>& m_surfaces;
  Budgeted_solver m_solver;
  std::vector<Critical_distance> m_found;
  std::vector<Undecided_part> m_undecided;

public:
  Common_normal_finder(const std::array<Spline_patch<3>, 2>& surfaces, const Solver_options& options)
    : m_surfaces(surfaces), m_solver(options)
  {}

  Found_common_normals operator()()
  {
    try {
      const auto check = [this] { m_solver.budget().check(); };
      const std::array<std::vector<Oriented_patch>, 2> parts{oriented_patches(m_surfaces[0], check),
                                                             oriented_patches(m_surfaces[1], check)};
      const bool are_moved = have_common_motion(parts, check);
      for (const Oriented_patch& a : parts[0])
        for (const Oriented_patch& b : parts[1])
          add_normals_of(a, b, are_moved);
    } catch (const Run_stopped& stop) {
      add_undecided(
          {m_surfaces[0].domain(0), m_surfaces[0].domain(1), m_surfaces[1].domain(0), m_surfaces[1].domain(1)},
          stop.reason);
    }
    std::ranges::stable_sort(m_found, {}, [](const Critical_distance& x) { return x.squared_distance.lower; });
    Found_common_normals result{{}, std::move(m_undecided), m_solver.total()};
    for (const Critical_distance& normal : m_found)
      result.pairs.push_back(located<3>(normal, {m_surfaces[0](normal.sample[0]), m_surfaces[1](normal.sample[1])}));
    return result;
  }

private:
  static Box domain_of(const Oriented_patch& a, const Oriented_patch& b)
  {
    return {a.patch.domain(0), a.patch.domain(1), b.patch.domain(0), b.patch.domain(1)};
  }

  static bool have_common_motion(const std::array<std::vector<Oriented_patch>, 2>& parts,
                                 const std::function<void()>& check)
  {
    Common_motions motions;
    for (const std::vector<Oriented_patch>& of_one : parts)
      for (const Oriented_patch& part : of_one)
        if (!part.is_degenerate)
          motions.add(part, check);
    return !motions.are_none();
  }

  // If a motion moves both surfaces along themselves, it moves common normals, too: there are infinitely many, unless
  // all are along its axis. The latter takes few nodes; otherwise, no time would suffice.
  Solution_set_d<double> solutions(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns,
                                   bool are_moved)
  {
    if (!are_moved)
      return m_solver(constraints, unknowns);
    constexpr std::size_t most_nodes = 1000;
    Budgeted_solver few = m_solver.limited(most_nodes);
    Solution_set_d<double> result = few(constraints, unknowns);
    m_solver.add_work_of(few);
    return result;
  }

  void add_normals_of(const Oriented_patch& a, const Oriented_patch& b, bool are_moved)
  {
    const Box domain = domain_of(a, b);
    if (a.is_degenerate || b.is_degenerate) {
      add_undecided(domain, Undecided_reason::CONTINUUM);
      return;
    }
    const std::vector<Unknown> u = unknowns_in(domain);
    const Solution_set_d<double> solutions = this->solutions(equations(a, b, u), u, are_moved);
    const std::array<bool, 4> is_seam{a.is_seam[0], a.is_seam[1], b.is_seam[0], b.is_seam[1]};
    for (const Solution_d<double>& solution : solutions) {
      if (is_again(solutions, solution, domain, is_seam))
        continue;
      if (solution.kind() == Solution_kind::UNDECIDED)
        add_undecided(solution.exact_box(),
                      are_moved && !m_solver.has_ended() ? Undecided_reason::CONTINUUM : solution.reason());
      else
        add(solution, domain);
    }
  }

  // The normal with the lower degrees is that which is orthogonal to the tangents of the other surface.
  static std::vector<Constraint> equations(const Oriented_patch& a, const Oriented_patch& b,
                                           const std::vector<Unknown>& unknowns)
  {
    const std::span<const Unknown> all(unknowns), u = all.first(2), v = all.subspan(2);
    const Vector_expression<3> offset = Parametric_vector<3>(a.patch)(u) - Parametric_vector<3>(b.patch)(v);
    std::vector<Constraint> result;
    const auto add = [&](const Oriented_patch& first, std::span<const Unknown> of_first, const Oriented_patch& second,
                         std::span<const Unknown> of_second) {
      const Vector_expression<3> normal = Parametric_vector<3>(first.normal)(of_first);
      for (const auto& tangent : first.tangents)
        result.push_back(dot(offset, Parametric_vector<3>(tangent)(of_first)) == 0);
      for (const auto& tangent : second.tangents)
        result.push_back(dot(normal, Parametric_vector<3>(tangent)(of_second)) == 0);
    };
    const auto degree = [](const Oriented_patch& patch) {
      return patch.normal[0].degree(0) + patch.normal[0].degree(1);
    };
    if (degree(a) <= degree(b))
      add(a, u, b, v);
    else
      add(b, v, a, u);
    return result;
  }

  // What is at the upper end of a seam and at its lower end is one normal, there once: where both are at these ends by
  // proof, and nothing else is between them.
  static bool is_again(const Solution_set_d<double>& solutions, const Solution_d<double>& solution, const Box& domain,
                       const std::array<bool, 4>& is_seam)
  {
    if (solution.kind() != Solution_kind::CERTIFIED && solution.kind() != Solution_kind::CLUSTER)
      return false;
    const Box box = solution.exact_box();
    for (std::size_t axis = 0; axis < 4; ++axis)
      if (is_seam[axis] && box[axis].first == domain[axis].second) {
        Box other = box;
        other[axis] = {domain[axis].first, domain[axis].first};
        if (std::any_of(solutions.begin(), solutions.end(), [&](const Solution_d<double>& x) {
              const Box own = x.exact_box();
              return own[axis].second == domain[axis].first && touch(own, other);
            }))
          return true;
      }
    return false;
  }

  void add(const Solution_d<double>& solution, const Box& domain)
  {
    const Box box = clipped(solution.exact_box(), domain);
    std::vector<Box> cover = solution.cover();
    if (cover.empty())
      cover.push_back(box);
    Critical_distance result{solution.kind(), {}, {}, Rational_interval(Exact_rational(0)), solution};
    const auto& ends = solution.ends();
    for (std::size_t i = 0; i < 4; ++i) {
      const Parameter_range range =
          ends.empty() ? clipped(cover.front(), domain)[i] : Parameter_range(ends[0][i], ends[1][i]);
      result.ranges[i / 2].push_back(box[i]);
      result.sample[i / 2].push_back(middle_of(range));
    }
    for (std::size_t k = 0; k < cover.size(); ++k) {
      const Rational_interval square = squared_distance_on(clipped(cover[k], domain));
      result.squared_distance = k == 0 ? square : hull(result.squared_distance, square);
    }
    m_found.push_back(std::move(result));
  }

  // The distance is critical, so that it changes by less than the width of the box.
  Rational_interval squared_distance_on(const Box& box) const
  {
    const auto part = [&](std::size_t k) {
      Spline_patch<3> result = m_surfaces[k];
      for (int axis = 2; axis-- > 0;)
        result = result.part(axis, box[2 * k + static_cast<std::size_t>(axis)]);
      return result;
    };
    return squared_distance_bounds(part(0), part(1));
  }

  void add_undecided(const Box& box, Undecided_reason reason)
  {
    const Box first{box[0], box[1]}, second{box[2], box[3]};
    const Box domain{m_surfaces[0].domain(0), m_surfaces[0].domain(1)};
    m_undecided.push_back({double_ranges(m_surfaces[0].part(clipped(first, domain)).values()),
                           {{0, double_ranges(first)}, {1, double_ranges(second)}},
                           in_words(reason)});
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_common_normals common_normals_of(const Exact_map<3>& first,
                                                                      const Exact_map<3>& second,
                                                                      const Solver_options& options)
{
  const std::array<Spline_patch<3>, 2> surfaces{Spline_patch<3>(first), Spline_patch<3>(second)};
  return Common_normal_finder(surfaces, options)();
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_COMMON_NORMAL_FINDER_H
