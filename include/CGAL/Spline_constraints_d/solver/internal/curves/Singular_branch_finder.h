// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_BRANCH_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_BRANCH_FINDER_H

#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Conic_structure_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Singular_point_test.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The vertex of a singular point, and those at the other ends of the pieces that end there.
struct Singular_branches
{
  std::size_t centre;
  std::vector<std::size_t> ends;
};

/*
Finishes boxes whose only solutions are proved to be branches that end in one singular point: in a rational point, which
may lie on the boundary of the box, where inequalities are zero; or where two curves cross, or in an isolated solution,
at any place inside.
*/
class Singular_branch_finder
{
  using Indices = std::vector<std::size_t>;

  // Relative to the domain. In moderate boxes a rational point is looked for, so that they are not split near it.
  // Pieces in small boxes are drawn as chords.
  static constexpr double moderate = 0x1p-4, small = 0x1p-6, very_small = 0x1p-10;

  const Constraint_system_d& m_system; // without breaks
  const std::vector<double>& m_domain_widths;
  Curve_vertices& m_vertices;
  Run_control& m_control;
  const bool m_is_short;                         // the minors are no long polynomials
  std::optional<Curve_polynomials> m_curves;     // made when they are needed
  std::deque<Conic_structure_test> m_structures; // at the rational points that were found
  std::size_t m_calls = 0, m_work = 0, m_attempts = 0, m_successes = 0;

public:
  Singular_branch_finder(const Constraint_system_d& system, const std::vector<double>& domain_widths,
                         Curve_vertices& vertices, Run_control& control)
    : m_system(system), m_domain_widths(domain_widths), m_vertices(vertices), m_control(control),
      m_is_short(are_minors_short(system))
  {}

  // In a box with these vertices on its boundary, and inequalities that neither hold everywhere nor exclude it.
  std::optional<Singular_branches> operator()(const Exact_ranges& box, const Indices& vertices,
                                              const Indices& open_inequalities)
  {
    constexpr std::size_t largest_dimension = 4;
    if (box.size() > largest_dimension || !is_smaller(box, moderate))
      return std::nullopt;
    ++m_calls;
    const Conic_structure_test* const structure = m_is_short ? structure_around(box) : nullptr;
    if (structure && !is_within(as_box(structure->point()), box))
      return std::nullopt; // there is no singular point
    std::optional<Singular_branches> result;
    if (structure && is_smaller(box, small))
      result = branches_of(*structure, box, vertices, open_inequalities);
    if (!result && open_inequalities.empty() && is_smaller(box, very_small))
      result = branches_of_double_point(box, vertices);
    m_successes += result.has_value();
    return result;
  }

  // A rational singular point in a box, if one is known.
  const Exact_point* known_point_in(const Exact_ranges& box) const
  {
    const auto found =
        std::find_if(m_structures.begin(), m_structures.end(),
                     [&](const Conic_structure_test& structure) { return is_within(as_box(structure.point()), box); });
    return found == m_structures.end() ? nullptr : &found->point();
  }

private:
  // By the number of products of coefficients in them.
  static bool are_minors_short(const Constraint_system_d& system)
  {
    constexpr double largest_number = 2000;
    double number = 1;
    for (const Spline_function& function : system.equalities()) {
      std::ptrdiff_t coefficients = 0;
      for (const Spline_term& term : function.terms())
        coefficients += std::count_if(term.pieces.front().begin(), term.pieces.front().end(),
                                      [](const Exact_rational& x) { return !CGAL::is_zero(x); });
      number *= static_cast<double>(coefficients);
    }
    return number <= largest_number;
  }

  const Curve_polynomials& curves()
  {
    if (!m_curves) {
      m_curves.emplace(m_system);
      charge_polynomials();
    }
    return *m_curves;
  }

  // For what takes as long as about all coefficients of the equations and minors.
  void charge_polynomials() const
  {
    constexpr std::size_t work_of_box = 256;
    m_control.charge(1 + m_curves->work_of_step() / work_of_box);
  }

  bool is_smaller(const Exact_ranges& box, double share) const
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (CGAL::to_double(Exact_rational(box[j].second - box[j].first)) > share * m_domain_widths[j])
        return false;
    return true;
  }

  // The known rational point whose region has a box, if there is one; or one that is found now.
  const Conic_structure_test* structure_around(const Exact_ranges& box)
  {
    const auto known = [&] {
      return std::find_if(m_structures.begin(), m_structures.end(),
                          [&](const Conic_structure_test& structure) { return is_within(box, structure.region()); });
    };
    if (known() == m_structures.end())
      find_rational_point(box);
    const auto found = known();
    return found == m_structures.end() ? nullptr : &*found;
  }

  // Near a box: what is proved there tells of many boxes around that they have no singular point.
  void find_rational_point(Exact_ranges near)
  {
    constexpr std::size_t first_work = 1000, more_work = 100; // a part of what the boxes cost
    if (m_work + curves().work_of_step() > first_work + more_work * m_calls)
      return;
    for (std::size_t j = 0; j < near.size(); ++j) {
      near[j].first -= Exact_rational(small * m_domain_widths[j]);
      near[j].second += Exact_rational(small * m_domain_widths[j]);
    }
    const std::optional<Exact_point> point = curves().rational_singular_point_in(near, m_work);
    if (point && std::none_of(m_structures.begin(), m_structures.end(), [&](const Conic_structure_test& structure) {
          return structure.point() == *point;
        }))
      m_structures.emplace_back(curves(), *point, m_domain_widths);
  }

  std::optional<Singular_branches> branches_of(const Conic_structure_test& structure, const Exact_ranges& box,
                                               const Indices& vertices, const Indices& open_inequalities)
  {
    Plane_point point = Plane_point::singular(as_box(structure.point()));
    for (const std::size_t g : open_inequalities) {
      const auto& [function, relation] = m_system.inequalities()[g];
      if (!structure.is_only_zero_of(*restricted(function, Partial_point(box.size())), box))
        return std::nullopt;
      point.inequality = g;
      point.is_excluded = point.is_excluded || is_strict(relation);
    }
    std::optional<std::size_t> centre;
    Indices ends;
    for (const std::size_t i : vertices) {
      if (is_point_of(structure, m_vertices[i])) {
        centre = i;
        continue;
      }
      if (!is_end_of_branch(structure, m_vertices[i], box))
        return std::nullopt;
      const CGAL::Uncertain<bool> is_solution =
          open_inequalities.empty() ? CGAL::Uncertain<bool>(true) : m_vertices.satisfies_inequalities(m_system, i);
      if (!CGAL::is_certain(is_solution))
        return std::nullopt;
      if (CGAL::get_certain(is_solution))
        ends.push_back(i);
    }
    if (centre)
      m_vertices.learn(*centre, point);
    else if (is_inside(structure.point(), box))
      centre = m_vertices.add(std::move(point));
    else
      return std::nullopt;
    return Singular_branches{*centre, std::move(ends)};
  }

  std::optional<Singular_branches> branches_of_double_point(const Exact_ranges& box, const Indices& vertices)
  {
    constexpr std::size_t few_attempts = 1000; // and as many more after each success
    const auto is_regular = [&](std::size_t i) { return m_vertices[i].kind == Plane_point::REGULAR; };
    if (m_attempts > few_attempts * (m_successes + 1) || (!vertices.empty() && vertices.size() != 4) ||
        !std::all_of(vertices.begin(), vertices.end(), is_regular))
      return std::nullopt;
    ++m_attempts;
    const Singular_point_test test(curves(), box, m_control);
    charge_polynomials();
    const std::optional<Proved_singularity> found = test();
    if (!found || found->branches != vertices.size())
      return std::nullopt;
    return Singular_branches{m_vertices.add(Plane_point::singular(found->box)), vertices};
  }

  // Whether a vertex is the rational point: this lies on its plane, which has no other solution in its box.
  bool is_point_of(const Conic_structure_test& structure, const Plane_point& vertex) const
  {
    const Exact_ranges point = as_box(structure.point());
    if (vertex.kind != Plane_point::SINGULAR || vertex.planes() == 0 || !is_within(point, vertex.box))
      return false;
    if (vertex.is_one_point())
      return true;
    const int axis = first_plane(vertex);
    const Power_polynomial plane =
        Power_polynomial::variable(axis) - Power_polynomial(point[static_cast<std::size_t>(axis)].first);
    return is_within(vertex.box, domain_of(m_system)) && structure.is_only_zero_of(plane, vertex.box);
  }

  // Whether a curve crosses the boundary of the box, in one face, such that it comes closer to the rational point
  // inside.
  static bool is_end_of_branch(const Conic_structure_test& structure, const Plane_point& vertex,
                               const Exact_ranges& box)
  {
    if (vertex.kind != Plane_point::REGULAR || vertex.planes() != 1)
      return false;
    const int axis = first_plane(vertex);
    const Exact_rational& value = vertex.box[static_cast<std::size_t>(axis)].first;
    const auto& [lower, upper] = box[static_cast<std::size_t>(axis)];
    return (value == lower || value == upper) && structure.approaches(vertex.box, axis, value == upper);
  }

  // The unknown that it fixes.
  static int first_plane(const Plane_point& vertex)
  {
    return static_cast<int>(std::find(vertex.is_fixed.begin(), vertex.is_fixed.end(), true) - vertex.is_fixed.begin());
  }

  static bool is_inside(const Exact_point& point, const Exact_ranges& box)
  {
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j] <= box[j].first || box[j].second <= point[j])
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SINGULAR_BRANCH_FINDER_H
