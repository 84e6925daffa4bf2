// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_VERTICES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_VERTICES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_roots_on_line.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A solution on one or several planes, each of which fixes an unknown; on none if it is a singular point, or a zero of
// an inequality, inside of a box.
struct Plane_point
{
  // REGULAR: the curve crosses the plane. SINGULAR: it touches it, or is singular itself. UNKNOWN: nothing is proved
  enum Kind
  {
    REGULAR,
    SINGULAR,
    UNKNOWN
  };

  Kind kind;
  Exact_ranges box, region;   // in the region, there is no other one on the first of the planes
  std::vector<bool> is_fixed; // per unknown
  std::optional<std::size_t> inequality = std::nullopt; // one that is zero there
  bool is_excluded = false;                             // a strict one is
  bool is_singular = false;                             // by proof, and what ends there is known

  // On no plane.
  static Plane_point singular(const Exact_ranges& box)
  {
    return {SINGULAR, box, box, std::vector<bool>(box.size(), false), std::nullopt, false, true};
  }

  // Proved to be one point, whatever the box: two roots that were not told apart are not.
  bool is_one_point() const
  {
    return kind == REGULAR || (kind == SINGULAR && std::all_of(box.begin(), box.end(), [](const auto& range) {
                                 return range.first == range.second;
                               }));
  }

  bool is_singular_point() const { return is_singular && !is_excluded; }

  // What others have found out about the same point.
  void learn(const Plane_point& same)
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (same.is_fixed[j]) {
        box[j] = same.box[j];
        is_fixed[j] = true;
      }
    if (same.is_singular)
      box = same.box;
    if (same.inequality)
      inequality = same.inequality;
    is_excluded = is_excluded || same.is_excluded;
    is_singular = is_singular || same.is_singular;
  }

  std::size_t planes() const { return static_cast<std::size_t>(std::count(is_fixed.begin(), is_fixed.end(), true)); }

  // The unknown that the first of the planes fixes, on which the region is.
  std::optional<std::size_t> first_plane() const
  {
    for (std::size_t j = 0; j < region.size(); ++j)
      if (is_fixed[j] && region[j].first == region[j].second)
        return j;
    return std::nullopt;
  }
};

inline bool is_within(const Exact_ranges& inner, const Exact_ranges& outer)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
      return false;
  return true;
}

// Whether zero is excluded.
inline bool is_strict(Relation relation)
{
  return relation == Relation::LESS || relation == Relation::GREATER || relation == Relation::NOT_EQUAL;
}

/*
The solutions on the planes that the domain is cut along, each once. Boxes on both sides of a plane share them, so that
nothing is ever joined by its distance.

A point may lie on several planes. This is decided exactly: the equations with both unknowns fixed are one more than the
unknowns that are left.
*/
class Curve_vertices
{
  Subdivision_solver_d<Certified_solver_traits> m_solver;
  std::vector<Plane_point> m_points;
  std::vector<Exact_ranges> m_continua; // boxes on planes with infinitely many solutions, or so it seems
  Summary m_work;
  bool m_tries_doubles = false;

public:
  // `tries_doubles`: before the solver, for points on lines, whose boxes are a little wider then.
  explicit Curve_vertices(const Solver_options& options, bool tries_doubles = false)
    : m_solver(options), m_tries_doubles(tries_doubles)
  {}

  // With some of the points of others, so that a task may add what it finds, without regard to other tasks.
  Curve_vertices(const Solver_options& options, const Curve_vertices& others, const std::vector<std::size_t>& points)
    : m_solver(options), m_continua(others.m_continua)
  {
    for (const std::size_t i : points)
      m_points.push_back(others[i]);
  }

  // Takes over what a task that was given some of the points has found. Returns its points' indices here.
  std::vector<std::size_t> merge(Curve_vertices&& task, std::vector<std::size_t> points)
  {
    for (std::size_t i = 0; i < task.size(); ++i)
      if (i < points.size())
        m_points[points[i]].learn(task[i]);
      else {
        points.push_back(m_points.size());
        m_points.push_back(std::move(task.m_points[i]));
      }
    m_work += task.m_work;
    return points;
  }

  const Plane_point& operator[](std::size_t i) const { return m_points[i]; }
  std::size_t size() const { return m_points.size(); }
  const Summary& work() const { return m_work; }

  // Appends a point, and returns its index.
  std::size_t add(Plane_point&& point)
  {
    m_points.push_back(std::move(point));
    return m_points.size() - 1;
  }

  // What is known of a point by now.
  void learn(std::size_t i, const Plane_point& same) { m_points[i].learn(same); }

  // Fixes an unknown of all points.
  void move_to_plane(int axis, const Exact_rational& value)
  {
    for (Plane_point& point : m_points)
      fix(point, axis, value);
  }

  void make_singular(std::size_t i)
  {
    m_points[i].kind = Plane_point::SINGULAR;
    m_points[i].is_singular = true;
  }

  // The other one is the same point, and not used any more.
  void identify(std::size_t i, std::size_t other)
  {
    m_points[i].learn(m_points[other]);
    m_points[other].is_singular = false;
  }

  // Whether a box touches solutions on a plane that are not single points.
  bool meets_continuum(const Exact_ranges& box) const
  {
    return std::any_of(m_continua.begin(), m_continua.end(),
                       [&](const Exact_ranges& part) { return touch(part, box); });
  }

  // Forgets the last points.
  void resize(std::size_t size) { m_points.resize(size); }

  /*
  Adds to the points within a box where the solutions are a graph those where an inequality is zero, unless they are
  there: on a plane this is decided exactly, with one equality more than unknowns. Whether zeros change the sign does
  not matter, as long as each is proved to be one point: else the reason why not.
  */
  Undecided_reason add_zeros(const Constraint_system_d& equalities,
                             const std::vector<Constraint_system_d::Inequality>& inequalities, std::size_t index,
                             const Exact_ranges& box, std::vector<std::size_t>& points)
  {
    Constraint_system_d zeros = equalities_on(equalities, box);
    zeros.add(inequalities[index].function, Relation::EQUAL);
    const std::vector<std::size_t> known = points;
    for (const Solution_d<double>& solution : solve(zeros)) {
      if (solution.kind() == Solution_kind::CONTINUUM || solution.reason() == Undecided_reason::CONTINUUM)
        return Undecided_reason::CONTINUUM;
      Plane_point zero = point_of(solution);
      if (zero.kind == Plane_point::UNKNOWN || (zero.kind == Plane_point::SINGULAR && !isolate(zeros, zero)))
        return Undecided_reason::INEQUALITY;
      zero.is_fixed.assign(box.size(), false);
      const auto place = std::find_if(known.begin(), known.end(), [&](std::size_t i) {
        return touch(m_points[i].box, zero.box) && is_within(m_points[i].box, zero.region) &&
            vanishes_at(zeros, m_points[i]);
      });
      const std::size_t i = place == known.end() ? m_points.size() : *place;
      if (place == known.end()) {
        points.push_back(i);
        m_points.push_back(std::move(zero));
      }
      m_points[i].inequality = index;
      m_points[i].is_excluded = m_points[i].is_excluded || is_strict(inequalities[index].relation);
    }
    return Undecided_reason::NONE;
  }

  // Whether a point satisfies the inequalities of the system. Of the inequality that is zero there, this is known.
  CGAL::Uncertain<bool> satisfies_inequalities(const Constraint_system_d& system, std::size_t i)
  {
    const Plane_point& point = m_points[i];
    if (point.is_excluded)
      return false;
    const Exact_ranges region = clipped(point.region, system);
    Constraint_system_d others = equalities_on(system, region);
    for (std::size_t k = 0; k < system.inequalities().size(); ++k)
      others.add(system.inequalities()[k].function,
                 k == point.inequality ? Relation::EQUAL : system.inequalities()[k].relation);
    const std::optional<std::size_t> plane = point.first_plane();
    const Solution_set_d<double> found =
        solve(plane ? internal::on_plane(others, region, static_cast<int>(*plane), region[*plane].first) : others);
    if (found.empty() && found.is_complete())
      return false;
    return found.count(Solution_kind::CERTIFIED) + found.count(Solution_kind::CLUSTER) > 0
        ? CGAL::Uncertain<bool>(true)
        : CGAL::Uncertain<bool>::indeterminate();
  }

  Solution_set_d<double> solve(const Constraint_system_d& system)
  {
    Solution_set_d<double> result = m_solver(system);
    m_work.nodes += result.summary().nodes;
    return result;
  }

  /*
  The indices of the points on a plane within a box, in whose boundary all known points lie. With `needs_regular`
  nothing, if there are others than regular points, or if the plane passes too close to a known point that does not lie
  on it.
  */
  std::optional<std::vector<std::size_t>> on_plane(const Constraint_system_d& system, const Exact_ranges& box, int axis,
                                                   const Exact_rational& value, const std::vector<std::size_t>& known,
                                                   bool needs_regular)
  {
    const std::size_t before = m_points.size();
    std::vector<std::size_t> result;
    const Constraint_system_d plane = internal::on_plane(system, box, axis, value);
    if (const auto roots = simple_roots(plane))
      for (const auto& [root, region] : *roots)
        result.push_back(placed(plane,
                                on_plane({Plane_point::REGULAR, {exact(root)}, {exact(region)}, {}}, axis, value), box,
                                axis, known));
    else
      for (const Solution_d<double>& solution : solve(plane)) {
        if (needs_regular && solution.kind() != Solution_kind::CERTIFIED) {
          m_points.resize(before);
          return std::nullopt;
        }
        if (solution.kind() == Solution_kind::CONTINUUM || solution.reason() == Undecided_reason::CONTINUUM) {
          add_continuum(solution, axis, value);
          continue;
        }
        result.push_back(placed(plane, on_plane(point_of(solution), axis, value), box, axis, known));
      }
    const auto is_near = [&](std::size_t i) {
      return m_points[i].box[axis].first < value && value < m_points[i].box[axis].second &&
          std::find(result.begin(), result.end(), i) == result.end();
    };
    if (needs_regular && std::any_of(known.begin(), known.end(), is_near)) {
      m_points.resize(before);
      return std::nullopt;
    }
    for (const std::size_t i : result)
      fix(m_points[i], axis, value);
    return result;
  }

private:
  void add_continuum(const Solution_d<double>& solution, int axis, const Exact_rational& value)
  {
    for (Exact_ranges box :
         solution.cover().empty() ? std::vector<Exact_ranges>{solution.exact_box()} : solution.cover()) {
      box.insert(box.begin() + axis, {value, value});
      m_continua.push_back(std::move(box));
    }
  }

  // Proves that a multiple root is one rational point, and makes this the box and a neighbourhood without other roots
  // the region.
  static bool isolate(const Constraint_system_d& system, Plane_point& root)
  {
    std::vector<double> lower, upper, widths;
    for (const auto& [begin, end] : root.box) {
      lower.push_back(to_double_interval(begin).first);
      upper.push_back(to_double_interval(end).second);
      widths.push_back(0x1p-10 * (std::max)({1.0, std::abs(lower.back()), std::abs(upper.back())}));
    }
    const std::optional<Multiple_root> found = multiple_root_in(system, lower, upper, widths);
    for (std::size_t j = 0; found && j < lower.size(); ++j) {
      root.box[j] = {found->point[j], found->point[j]};
      root.region[j] = {Exact_rational(found->lower[j]), Exact_rational(found->upper[j])};
    }
    return found.has_value();
  }

  // To the domain of a system.
  static Exact_ranges clipped(Exact_ranges box, const Constraint_system_d& system)
  {
    for (int j = 0; j < system.dimension(); ++j)
      box[j] = {(std::max)(box[j].first, system.domain(j).first), (std::min)(box[j].second, system.domain(j).second)};
    return box;
  }

  // Whether a function that is one equality of the system more is zero at a point on a plane.
  bool vanishes_at(const Constraint_system_d& system, const Plane_point& point)
  {
    const std::optional<std::size_t> plane = point.first_plane();
    if (!plane)
      return false;
    const Solution_set_d<double> found =
        solve(internal::on_plane(system, point.region, static_cast<int>(*plane), point.region[*plane].first));
    return found.count(Solution_kind::CERTIFIED) + found.count(Solution_kind::CLUSTER) > 0;
  }

  static Plane_point point_of(const Solution_d<double>& solution)
  {
    const Plane_point::Kind kind = solution.kind() == Solution_kind::CERTIFIED ? Plane_point::REGULAR
        : solution.kind() == Solution_kind::CLUSTER                            ? Plane_point::SINGULAR
                                                                               : Plane_point::UNKNOWN;
    return {kind,
            solution.exact_box(),
            solution.uniqueness_region().empty() ? solution.exact_box() : solution.exact_uniqueness_region(),
            {}};
  }

  static Plane_point on_plane(Plane_point point, int axis, const Exact_rational& value)
  {
    for (Exact_ranges* ranges : {&point.box, &point.region})
      ranges->insert(ranges->begin() + axis, {value, value});
    point.is_fixed.assign(point.box.size(), false);
    return point;
  }

  // Of a system in one unknown, if doubles do.
  std::optional<std::vector<Simple_roots_on_line::Root>> simple_roots(const Constraint_system_d& plane)
  {
    if (!m_tries_doubles || plane.dimension() != 1)
      return std::nullopt;
    ++m_work.nodes;
    return Simple_roots_on_line()(plane);
  }

  static Exact_ranges::value_type exact(const std::pair<double, double>& range)
  {
    return {Exact_rational(range.first), Exact_rational(range.second)};
  }

  static void fix(Plane_point& point, int axis, const Exact_rational& value)
  {
    point.box[axis] = {value, value};
    point.is_fixed[axis] = true;
  }

  // The index of a point on a plane: of a known one, if both lie on an edge of the box and are the same; else it
  // becomes known. What reaches an edge and is not proved to be one point stays unknown.
  std::size_t placed(const Constraint_system_d& plane, Plane_point point, const Exact_ranges& box, int axis,
                     const std::vector<std::size_t>& known)
  {
    std::vector<std::pair<int, Exact_rational>> edges;
    for (int k = 0; k < static_cast<int>(box.size()); ++k)
      for (const Exact_rational& end : {box[k].first, box[k].second})
        if (k != axis && point.box[k].first <= end && end <= point.box[k].second) {
          if (!point.is_one_point()) {
            point.kind = Plane_point::UNKNOWN;
            break;
          }
          const std::vector<Exact_ranges> on_edge = points_on_edge(plane, point.box, axis, k, end);
          const auto root = std::find_if(on_edge.begin(), on_edge.end(),
                                         [&](const Exact_ranges& x) { return is_within(x, point.region); });
          if (root == on_edge.end())
            continue;
          for (const std::size_t i : known)
            if (m_points[i].is_fixed[k] && m_points[i].box[k].first == end && is_within(*root, m_points[i].region))
              return i;
          edges.emplace_back(k, end);
        }
    for (const auto& [k, end] : edges)
      fix(point, k, end);
    m_points.push_back(std::move(point));
    return m_points.size() - 1;
  }

  // The solutions near a point on a plane with another unknown fixed as well.
  std::vector<Exact_ranges> points_on_edge(const Constraint_system_d& plane, Exact_ranges near, int axis, int unknown,
                                           const Exact_rational& value)
  {
    const Exact_rational fixed = near[axis].first;
    const int reduced = unknown - (unknown > axis ? 1 : 0);
    near.erase(near.begin() + axis);
    near = clipped(std::move(near), plane);
    std::vector<Exact_ranges> result;
    const auto add = [&](Exact_ranges point) {
      point.insert(point.begin() + reduced, {value, value});
      point.insert(point.begin() + axis, {fixed, fixed});
      result.push_back(std::move(point));
    };
    if (plane.dimension() == 1) {
      if (is_zero_at(plane, value))
        add({});
      return result;
    }
    for (const Solution_d<double>& solution : solve(internal::on_plane(plane, near, reduced, value)))
      if (solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER)
        add(solution.exact_box());
    return result;
  }

  static bool is_zero_at(const Constraint_system_d& line, const Exact_rational& value)
  {
    return std::all_of(line.equalities().begin(), line.equalities().end(), [&](const Spline_function& function) {
      Exact_rational sum(0);
      const Spline_function constant = with_fixed(function, 0, value);
      for (const Spline_term& term : constant.terms())
        sum += term.pieces[0][0];
      return sum == Exact_rational(0);
    });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_VERTICES_H
