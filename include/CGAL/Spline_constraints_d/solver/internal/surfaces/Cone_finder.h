// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_FINDER_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Gauss_newton_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Quadratic_cone_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Space_equation.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Weighted_cone_test.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The singular points that are known in a cell.
struct Known_cones
{
  std::vector<Cone_point> points = {};
  std::vector<Exact_point> places = {}; // of singular points, or near them, proved or not
  std::size_t calls = 0, steps = 0, attempts = 0;

  // Adds what a task has found that began with what was known before.
  void learn(const Known_cones& task, const Known_cones& before)
  {
    for (std::size_t i = before.points.size(); i < task.points.size(); ++i)
      if (std::none_of(points.begin(), points.end(),
                       [&](const Cone_point& own) { return own.middle == task.points[i].middle; }))
        points.push_back(task.points[i]);
    for (std::size_t i = before.places.size(); i < task.places.size(); ++i)
      if (std::find(places.begin(), places.end(), task.places[i]) == places.end())
        places.push_back(task.places[i]);
    calls += task.calls - before.calls;
    steps += task.steps - before.steps;
    attempts += task.attempts - before.attempts;
  }
};

/*
Finds singular points of the surface of one equality in three unknowns, in one cell: rational ones, and others where
the second derivative is regular. It knows which of them are proved to be cones or isolated. Boxes are those of the
whole system, points and regions are in space.
*/
class Cone_finder
{
  // Relative to the cell. In large boxes points are looked for, so that planes keep away from them. Boxes around points
  // where surfaces touch may be moderate: to tell the sheets apart costs many boxes for each smaller one.
  static constexpr double large = 0x1p-2, moderate = 0x1p-4, small = 0x1p-6;

  std::optional<Space_equation> m_space; // none where there is no such equality
  Exact_ranges m_cell;
  std::vector<double> m_lengths;
  std::optional<Power_polynomial> m_equation; // made when it is needed
  std::vector<Power_polynomial> m_conditions; // it and its derivatives
  Polynomials_with_gradients<double> m_rounded;
  Polynomials_with_gradients<Exact_rational> m_exact;
  Known_cones m_known;

public:
  // Without breaks.
  explicit Cone_finder(const Constraint_system_d& system) : m_space(Space_equation::of(system))
  {
    if (!m_space)
      return;
    m_cell = domain_of(system);
    for (const auto& [lower, upper] : m_space->part_of(m_cell))
      m_lengths.push_back(CGAL::to_double(Exact_rational(upper - lower)));
  }

  // What is known to begin with, and by now.
  void learn(const Known_cones& known) { m_known = known; }
  const Known_cones& known() const { return m_known; }

  // The equality in space, if there is one.
  const std::optional<Space_equation>& space() const { return m_space; }

  // A point that is the only singular one in a box, if the box is small, and nothing cuts off solutions in it but
  // faces of the domain that hold no other solution there.
  // \pre there is an equality in space.
  const Cone_point* operator()(const Exact_ranges& whole, const Exact_ranges& domain)
  {
    const Exact_ranges box = m_space->part_of(whole);
    if (!is_smaller(box, large))
      return nullptr;
    ++m_known.calls;
    if (!known_in(box))
      search(box);
    const Cone_point* const result = known_in(box);
    return result && is_smaller(box, result->is_quadratic() && !is_on_face(*result, domain) ? small : moderate) &&
            m_space->is_free_but_for(result->point, whole, m_cell, domain)
        ? result
        : nullptr;
  }

  // Whether the face of the domain on which an unknown is as at a singular point crosses the cone in lines that meet
  // there alone.
  bool is_crossed(const Cone_point& point, const Exact_ranges& whole, int unknown) const
  {
    const Exact_ranges box = m_space->part_of(whole);
    return point.is_quadratic() && m_equation &&
        Quadratic_cone_test(*m_equation, point.middle)
            .is_crossed(point, box, m_lengths, m_space->gradient_of(unknown, point.point),
                        m_space->gradient_of(unknown, box));
  }

  // Whether a plane through a box comes near to a singular point in it, for a box of that width.
  bool is_near(const Exact_ranges& box, int axis, const Exact_rational& value, double width) const
  {
    constexpr double far = 0.2;
    return std::any_of(m_known.places.begin(), m_known.places.end(), [&](const Exact_point& place) {
      const Exact_ranges point = m_space->with_values(box_around(place, Exact_point(3, Exact_rational(0))));
      const auto& [least, most] = point[static_cast<std::size_t>(axis)];
      const Exact_rational beside = (std::max)(Exact_rational(least - value), Exact_rational(value - most));
      return is_within(point, box) && CGAL::to_double(beside) < far * width;
    });
  }

private:
  // Whether a point is on a face of the domain, near which planes do not cross the curves that end there.
  bool is_on_face(const Cone_point& point, const Exact_ranges& domain) const
  {
    const Exact_ranges place = m_space->with_values(point.point);
    for (std::size_t j = 0; j < place.size(); ++j)
      if (const auto& [least, most] = place[j];
          least == most && (least == domain[j].first || least == domain[j].second))
        return true;
    return false;
  }

  bool is_smaller(const Exact_ranges& box, double share) const
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (CGAL::to_double(Exact_rational(box[j].second - box[j].first)) > share * m_lengths[j])
        return false;
    return true;
  }

  // The point whose region has a box.
  const Cone_point* known_in(const Exact_ranges& box) const
  {
    const auto found = std::find_if(m_known.points.begin(), m_known.points.end(),
                                    [&](const Cone_point& point) { return is_within(box, point.region); });
    return found == m_known.points.end() ? nullptr : &*found;
  }

  // Where there are none, or many that cannot be proved, this costs a part of what the boxes do.
  void search(const Exact_ranges& box)
  {
    constexpr std::size_t few_steps = 300, more_steps = 4, few_attempts = 8, more_attempts = 4;
    if (m_known.steps > few_steps + more_steps * m_known.calls ||
        m_known.attempts > few_attempts + more_attempts * m_known.points.size())
      return;
    prepare();
    Exact_ranges near = box;
    for (std::size_t j = 0; j < near.size(); ++j) {
      near[j].first -= Exact_rational(small * m_lengths[j]);
      near[j].second += Exact_rational(small * m_lengths[j]);
    }
    const Search_result found = quick_search(near);
    if (found.point)
      return add(box_around(*found.point, Exact_point(3, Exact_rational(0))), *found.point);
    const std::optional<std::vector<double>> critical = critical_point_in(near);
    if (critical && is_known(*critical))
      return;
    if (const auto irrational = critical ? singular_point_near(*critical) : std::nullopt) {
      Exact_point middle;
      for (const auto& [lower, upper] : *irrational)
        middle.push_back(Exact_rational((lower + upper) / 2));
      add(*irrational, middle);
    } else if (found.is_unclear && !critical && is_smaller(box, moderate))
      if (const std::optional<Exact_point> point = slow_search(near))
        add(box_around(*point, Exact_point(3, Exact_rational(0))), *point);
  }

  void prepare()
  {
    if (m_equation)
      return;
    m_equation = m_space->polynomial();
    m_conditions = {*m_equation, m_equation->derivative(0), m_equation->derivative(1), m_equation->derivative(2)};
    for (const Power_polynomial& condition : m_conditions) {
      m_rounded.add(condition);
      m_exact.add(condition);
    }
  }

  void add(const Exact_ranges& point, const Exact_point& middle)
  {
    if (std::find(m_known.places.begin(), m_known.places.end(), middle) != m_known.places.end())
      return;
    m_known.places.push_back(middle);
    ++m_known.attempts;
    std::optional<Cone_point> proved = Quadratic_cone_test(*m_equation, middle)(point, m_lengths);
    if (!proved && is_within(point, box_around(middle, Exact_point(3, Exact_rational(0)))))
      proved = weighted_cone_point(*m_equation, middle, m_lengths);
    if (proved)
      m_known.points.push_back(*std::move(proved));
  }

  // For a rational point.
  Search_result quick_search(const Exact_ranges& box)
  {
    Gauss_newton_search<double> search(m_rounded, box, [this](const Exact_point& point) { return is_singular(point); });
    const Search_result result = search();
    m_known.steps += search.steps();
    return result;
  }

  // With more digits.
  std::optional<Exact_point> slow_search(const Exact_ranges& box)
  {
    constexpr std::size_t quick_steps = 64; // that cost as much as one
    Gauss_newton_search<Exact_rational> search(m_exact, box,
                                               [this](const Exact_point& point) { return is_singular(point); });
    const Search_result result = search();
    m_known.steps += quick_steps * search.steps();
    return result.point;
  }

  bool is_singular(const Exact_point& point) const
  {
    return std::all_of(m_conditions.begin(), m_conditions.end(),
                       [&](const Power_polynomial& condition) { return CGAL::is_zero(condition(point)); });
  }

  Exact_ranges box_near(const std::vector<double>& place) const
  {
    constexpr double near = 0x1p-20;
    Exact_point distances;
    for (const double length : m_lengths)
      distances.emplace_back(near * length);
    return box_around(Exact_point(place.begin(), place.end()), distances);
  }

  bool is_known(const std::vector<double>& place) const
  {
    const Exact_ranges around = box_near(place);
    return std::any_of(m_known.places.begin(), m_known.places.end(), [&](const Exact_point& known) {
      return is_within(box_around(known, Exact_point(3, Exact_rational(0))), around);
    });
  }

  // By the solver, if the equality seems to be zero at a critical point.
  std::optional<Exact_ranges> singular_point_near(const std::vector<double>& critical) const
  {
    constexpr double seems_to_be_zero = 0x1p-30;
    constexpr std::size_t most_nodes = 1000;
    const auto value = m_rounded(critical).front();
    if (!(std::abs(value.value) <= seems_to_be_zero * value.size))
      return std::nullopt;
    Constraint_system_d system(box_near(critical));
    for (const Power_polynomial& condition : m_conditions)
      if (!condition.is_zero())
        system.add(condition, Relation::EQUAL);
    const Solution_set_d<double> points =
        Subdivision_solver_d<Certified_solver_traits>({.node_limit = most_nodes})(system);
    if (!points.is_complete() || points.size() != 1 ||
        points.count(Solution_kind::CERTIFIED) + points.count(Solution_kind::CLUSTER) != 1)
      return std::nullopt;
    return points.begin()->exact_box();
  }

  // Newton's method for the gradient.
  std::optional<std::vector<double>> critical_point_in(const Exact_ranges& box)
  {
    constexpr int most_steps = 20;
    constexpr double short_step = 0x1p-45;
    std::vector<double> place;
    for (const auto& [lower, upper] : box)
      place.push_back(CGAL::to_double(Exact_rational((lower + upper) / 2)));
    for (int step = 0; step < most_steps; ++step) {
      ++m_known.steps;
      const auto values = m_rounded(place);
      std::vector<double> rows;
      for (std::size_t i = 1; i < values.size(); ++i) {
        rows.insert(rows.end(), values[i].gradient.begin(), values[i].gradient.end());
        rows.push_back(values[i].value);
      }
      const std::vector<int> row_of = gauss_jordan(rows, 4, 3, 3, [](double x) { return std::abs(x); });
      if (row_of.empty())
        return std::nullopt;
      double longest = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        const double change = rows[static_cast<std::size_t>(4 * row_of[j] + 3)];
        place[j] -= change;
        longest = (std::max)(longest, std::abs(change) / m_lengths[j]);
        if (!std::isfinite(place[j]) || place[j] < CGAL::to_double(box[j].first) ||
            place[j] > CGAL::to_double(box[j].second))
          return std::nullopt;
      }
      if (longest < short_step)
        return place;
    }
    return std::nullopt;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_FINDER_H
