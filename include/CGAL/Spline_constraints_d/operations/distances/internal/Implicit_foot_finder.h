// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_IMPLICIT_FOOT_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_IMPLICIT_FOOT_FINDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_implicit_feet.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Finds all points of f = 0, or f = g = 0 in space, in a box where the distance to a point p is critical: inside, on
// faces and on edges.
class Implicit_foot_finder
{
  using Box = std::vector<std::pair<Exact_rational, Exact_rational>>;

  const std::vector<Power_polynomial>& m_polynomials;
  const Box& m_box;
  const std::vector<Exact_rational>& m_p;
  Budgeted_solver m_solver;
  Found_implicit_feet m_found;

public:
  Implicit_foot_finder(const std::vector<Power_polynomial>& polynomials, const Box& box,
                       const std::vector<Exact_rational>& p, const Solver_options& options)
    : m_polynomials(polynomials), m_box(box), m_p(p), m_solver(options)
  {}

  Found_implicit_feet operator()()
  {
    find_on_faces(m_box, 0);
    std::stable_sort(m_found.feet.begin(), m_found.feet.end(),
                     [](const auto& a, const auto& b) { return a.squared_distance.lower < b.squared_distance.lower; });
    m_found.summary = m_solver.total();
    m_found.summary.is_complete = m_found.undecided.empty();
    return std::move(m_found);
  }

private:
  // On all faces of a face of the box, with the coordinates before this one as they are.
  void find_on_faces(const Box& face, std::size_t axis)
  {
    if (axis == face.size()) {
      find_on(face);
      return;
    }
    find_on_faces(face, axis + 1);
    for (const Exact_rational& end : {m_box[axis].first, m_box[axis].second}) {
      Box side = face;
      side[axis] = {end, end};
      find_on_faces(side, axis + 1);
    }
  }

  // Where the polynomials are zero and the offset from p is a combination of their gradients in a face.
  void find_on(const Box& face)
  {
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i].first < face[i].second)
        free.push_back(i);
    std::vector<Power_polynomial> equations;
    for (const Power_polynomial& polynomial : m_polynomials) {
      Power_polynomial f = restricted(polynomial, face, free);
      if (f.is_constant() && !f.is_zero())
        return;
      if (!f.is_zero())
        equations.push_back(std::move(f));
    }
    if (equations.empty()) {
      if (free.empty())
        add(face, Solution_kind::CERTIFIED, false);
      else
        add_undecided(face, Undecided_reason::CONTINUUM);
    } else if (equations.size() == 1)
      find_on_hypersurface(equations.front(), face, free);
    else {
      if (free.size() == 3)
        equations.push_back(volume(equations, free));
      solve(equations, face, false);
    }
  }

  // On a face, as a polynomial in the coordinates that are free.
  static Power_polynomial restricted(Power_polynomial f, const Box& face, const std::vector<std::size_t>& free)
  {
    for (std::size_t i = 0; i < face.size(); ++i)
      if (!(face[i].first < face[i].second))
        f = f.substituted(static_cast<int>(i), Power_polynomial(face[i].first));
    for (std::size_t k = 0; k < free.size(); ++k)
      if (free[k] != k)
        f = f.substituted(static_cast<int>(free[k]), Power_polynomial::variable(static_cast<int>(k)));
    return f;
  }

  // The determinant of the offset and both gradients.
  Power_polynomial volume(const std::vector<Power_polynomial>& f, const std::vector<std::size_t>& free) const
  {
    Power_polynomial result;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result += (Power_polynomial::variable(i) - Power_polynomial(m_p[free[static_cast<std::size_t>(i)]])) *
          (f[0].derivative(j) * f[1].derivative(k) - f[0].derivative(k) * f[1].derivative(j));
    }
    return result;
  }

  void find_on_hypersurface(const Power_polynomial& f, const Box& face, const std::vector<std::size_t>& free)
  {
    std::vector<Power_polynomial> offset, slope;
    for (std::size_t k = 0; k < free.size(); ++k) {
      offset.push_back(Power_polynomial::variable(static_cast<int>(k)) - Power_polynomial(m_p[free[k]]));
      slope.push_back(f.derivative(static_cast<int>(k)));
    }
    if (free.size() == 1)
      solve({f}, face, false);
    else if (free.size() == 2)
      solve({f, offset[0] * slope[1] - offset[1] * slope[0]}, face, false);
    else {
      // one is a multiple of the other one, by -1 to 1
      const Power_polynomial factor = Power_polynomial::variable(static_cast<int>(free.size()));
      for (const auto& [a, b] : {std::pair(&offset, &slope), std::pair(&slope, &offset)}) {
        std::vector<Power_polynomial> equations{f};
        for (std::size_t k = 0; k < free.size(); ++k)
          equations.push_back((*a)[k] - factor * (*b)[k]);
        solve(equations, face, true);
      }
    }
  }

  void solve(const std::vector<Power_polynomial>& equations, const Box& face, bool has_factor)
  {
    Box domain;
    for (const auto& range : face)
      if (range.first < range.second)
        domain.push_back(range);
    if (has_factor)
      domain.emplace_back(-1, 1);
    Constraint_system_d system(domain);
    for (const Power_polynomial& equation : equations)
      system.add(equation, Relation::EQUAL);
    for (const Solution_d<double>& solution : m_solver(system)) {
      const auto filled = [&](const Box& part) {
        Box result = face;
        auto next = part.begin();
        for (auto& range : result)
          if (range.first < range.second)
            range = *next++;
        return result;
      };
      if (solution.kind() == Solution_kind::UNDECIDED && solution.cover().empty())
        add_undecided(filled(solution.exact_box()), solution.reason());
      else if (solution.kind() == Solution_kind::UNDECIDED)
        for (const Box& part : solution.cover())
          add_undecided(filled(part), solution.reason());
      else if (solution.kind() == Solution_kind::CONTINUUM)
        add_continuum(filled(solution.exact_box()), solution.cover(), filled, is_inside(face));
      else
        add(filled(solution.exact_box()), solution.kind(), is_inside(face));
    }
  }

  // The nearest of all of these points is no farther than some of them.
  template <class Filled>
  void add_continuum(const Box& box, const std::vector<Box>& cover, const Filled& filled, bool is_inside)
  {
    Rational_interval distance = squared_distance(filled(cover.front()));
    for (const Box& part : cover)
      distance = hull(distance, squared_distance(filled(part)));
    m_found.feet.push_back({box, distance, Solution_kind::CONTINUUM, is_inside});
  }

  void add(const Box& box, Solution_kind kind, bool is_inside)
  {
    // both systems have those with the factors 1 and -1
    const auto is_same = [&](const auto& foot) { return foot.kind == kind && touch(foot.box, box); };
    if (std::none_of(m_found.feet.begin(), m_found.feet.end(), is_same))
      m_found.feet.push_back({box, squared_distance(box), kind, is_inside});
  }

  void add_undecided(const Box& box, Undecided_reason reason)
  {
    m_found.undecided.push_back({double_ranges(box), {}, in_words(reason)});
    m_found.undecided_distances.push_back(squared_distance(box));
  }

  // Whether no coordinate is at an end of the box, as on a face.
  static bool is_inside(const Box& face)
  {
    return std::all_of(face.begin(), face.end(), [](const auto& range) { return range.first < range.second; });
  }

  Rational_interval squared_distance(const Box& box) const
  {
    Rational_interval result(Exact_rational(0));
    for (std::size_t i = 0; i < box.size(); ++i)
      result = result + square(Rational_interval(box[i]) - Rational_interval(m_p[i]));
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_implicit_feet implicit_feet_of(
    const std::vector<Power_polynomial>& polynomials, const std::vector<std::pair<Exact_rational, Exact_rational>>& box,
    const std::vector<Exact_rational>& point, const Solver_options& options)
{
  return Implicit_foot_finder(polynomials, box, point, options)();
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_IMPLICIT_FOOT_FINDER_H
