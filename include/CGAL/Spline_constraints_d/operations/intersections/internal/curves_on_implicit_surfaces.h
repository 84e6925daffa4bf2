// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_SURFACES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The polynomial F of least degree, up to four, that is zero at all points of a surface, if there is one up to a factor:
linear algebra in its coefficients finds it from points of the surface, and it is proved exactly. So planes, quadrics
and tori are found. It is homogeneous in the numerators and the weight.
*/
class Implicit_form
{
  static constexpr int m_most_degree = 4;

  int m_degree;
  std::vector<std::array<int, 4>> m_exponents;
  std::vector<Exact_rational> m_coefficients;

  explicit Implicit_form(int degree) : m_degree(degree)
  {
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k)
          m_exponents.push_back({i, j, k, degree - i - j - k});
  }

public:
  static std::optional<Implicit_form> of(const Spline_patch<3>& surface)
  {
    for (int degree = 1; degree <= m_most_degree; ++degree) {
      Implicit_form form(degree);
      if (form.find_coefficients(surface))
        return form.holds(surface) ? std::optional(form) : std::nullopt;
    }
    return std::nullopt;
  }

  bool holds(const Spline_patch<3>& patch) const
  {
    const std::vector<Exact_rational> monomials = monomials_at(patch(patch.middle()));
    Exact_rational value(0);   // most patches end here
    for (std::size_t i = 0; i < monomials.size(); ++i)
      value += m_coefficients[i] * monomials[i];
    if (value != 0)
      return false;
    const Exact_function f = derivative(powers_in(patch), 4);
    return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                       [](const Exact_rational& c) { return c == 0; });
  }

  // The gradient of F along a patch, times a power of the weight.
  Vector_of_functions<3> gradient(const Spline_patch<3>& patch) const
  {
    const auto powers = powers_in(patch);
    return {derivative(powers, 0), derivative(powers, 1), derivative(powers, 2)};
  }

private:
  using Powers = std::array<std::vector<Exact_function>, 4>;   // of the numerators and the weight

  std::vector<Exact_rational> monomials_at(const std::array<Exact_rational, 3>& point) const
  {
    std::vector<Exact_rational> result;
    for (const std::array<int, 4>& e : m_exponents) {
      Exact_rational product(1);
      for (std::size_t i = 0; i < 3; ++i)
        for (int k = 0; k < e[i]; ++k)
          product *= point[i];
      result.push_back(std::move(product));
    }
    return result;
  }

  // Such that F is zero at points of the surface; false if there is no such F, by ranks modulo a prime, or more than
  // one. A conic on the surface is on F if 2 degree + 1 of its points are.
  bool find_coefficients(const Spline_patch<3>& surface)
  {
    const std::size_t n = m_exponents.size();
    std::vector<std::vector<Big_integer>> independent;
    std::vector<Exact_rational> rows;
    for (int i = 0; i <= 2 * m_degree; ++i)
      for (int j = 0; j <= 2 * m_degree; ++j) {
        const auto at = [&](int axis, int k) {
          return Exact_rational(surface.domain(axis).first +
                                (surface.domain(axis).second - surface.domain(axis).first) * (2 * k + 1) / 32);
        };
        const std::vector<Exact_rational> monomials = monomials_at(surface(std::array{at(0, i), at(1, j)}));
        Big_integer denominator(1);
        for (const Exact_rational& m : monomials)
          extend_common_denominator(denominator, m);
        auto& row = independent.emplace_back();
        for (const Exact_rational& m : monomials)
          row.push_back(numerator_over(m, denominator));
        if (rank_modulo(independent, Prime_sequence().next()) < independent.size())
          independent.pop_back();
        else if (independent.size() == n)
          return false;
        else
          rows.insert(rows.end(), monomials.begin(), monomials.end());
      }
    return independent.size() + 1 == n && set_null_vector(std::move(rows));
  }

  bool set_null_vector(std::vector<Exact_rational> rows)
  {
    const std::size_t n = m_exponents.size();
    const auto size = [](const Exact_rational& x) {
      return x == 0 ? 0.0 : 1.0 / static_cast<double>(bit_length(numerator_of(x)) + bit_length(denominator_of(x)));
    };
    const std::vector<int> row_of = gauss_jordan(rows, n, n, n - 1, size);
    const auto free = std::find(row_of.begin(), row_of.end(), -1);
    if (row_of.empty() || free == row_of.end())
      return false;
    m_coefficients.assign(n, Exact_rational(0));
    for (std::size_t j = 0; j < n; ++j)
      m_coefficients[j] = row_of[j] < 0
          ? Exact_rational(1)
          : Exact_rational(
                -rows[static_cast<std::size_t>(row_of[j]) * n + static_cast<std::size_t>(free - row_of.begin())]);
    return true;
  }

  Powers powers_in(const Spline_patch<3>& patch) const
  {
    Powers result;
    for (int i = 0; i < 4; ++i) {
      const Exact_function& f = i < 3 ? patch.numerators()[i] : patch.weight();
      result[i].push_back(f);   // instead of one, which is never used
      for (int k = 1; k <= m_degree; ++k)
        result[i].push_back(k == 1 ? f : result[i].back() * f);
    }
    return result;
  }

  // By one of the first three coordinates; by none, F itself.
  Exact_function derivative(const Powers& powers, std::size_t axis) const
  {
    std::optional<Exact_function> sum;
    for (std::size_t k = 0; k < m_exponents.size(); ++k) {
      std::array<int, 4> e = m_exponents[k];
      const int factor = axis < 3 ? e[axis]-- : 1;
      if (m_coefficients[k] == 0 || factor == 0)
        continue;
      std::optional<Exact_function> term;
      for (std::size_t i = 0; i < 4; ++i)
        if (e[i] > 0)
          term = term ? *term * powers[i][e[i]] : powers[i][e[i]];
      const Exact_rational coefficient(m_coefficients[k] * factor);
      const Exact_function scaled =
          term ? *term * coefficient : Exact_function(powers[3][1] * Exact_rational(0) + coefficient);
      sum = sum ? *sum + scaled : scaled;
    }
    return sum ? *sum : Exact_function(powers[3][1] * Exact_rational(0));
  }
};

/*
A curve and a surface on which a polynomial F is zero. Away from the edges of the surface its normal and the gradient of
F are proved not to be zero, so around each of its points there it is all of the zeros of F. Between two common points
with the edges the curve therefore runs within the surface, or outside of it, which is decided at one of its points.
*/
class Curve_on_implicit_surface
{
  // Where the curve meets an edge; or may do so in one point at most, if that is undecided.
  struct Event
  {
    Parameter_range range;
    Common_point point;
  };

  // Up to the next event, or to the end of the curve.
  struct Arc_between_events
  {
    std::size_t next_event;
    bool is_on_surface;
  };

  const Patch_pair<3>& m_pair;
  std::size_t m_curve_index;
  const Spline_patch<3>&m_curve, &m_surface;
  Budgeted_solver& m_solve;

public:
  Curve_on_implicit_surface(const Patch_pair<3>& pair, Budgeted_solver& solve)
    : m_pair(pair), m_curve_index(pair[0].number_of_parameters() == 1 ? 0 : 1), m_curve(pair[m_curve_index]),
      m_surface(pair[1 - m_curve_index]), m_solve(solve)
  {}

  // None if they are not of this kind, or something is not decided.
  std::optional<std::vector<Common_point>> operator()() const
  {
    const std::optional<Implicit_form> form = Implicit_form::of(m_surface);
    if (!form || !form->holds(m_curve) || !is_regular(*form))
      return std::nullopt;
    const auto events = events_by_parameter();
    const auto arcs = events ? arcs_between(*events) : std::nullopt;
    return arcs ? std::optional(common_points(*events, *arcs)) : std::nullopt;
  }

private:
  // Whether det(S_u, S_v, grad F) has one sign within the edges, by its Bernstein coefficients, and no tangent jumps.
  bool is_regular(const Implicit_form& form) const
  {
    int sign = 0;
    const auto is_edge = [&](int axis, bool is_at_end) { return is_at_end && !m_surface.is_closed(axis); };
    for (const int axis : {0, 1})
      if (parts_of(m_surface, axis, perpendicular_before).size() != 1)
        return false;
    const std::vector<Exact_rational> u = m_surface.breaks(0), v = m_surface.breaks(1);
    for (std::size_t i = 1; i < u.size(); ++i)
      for (std::size_t j = 1; j < v.size(); ++j) {
        const Spline_patch<3> cell = m_surface.part({{u[i - 1], u[i]}, {v[j - 1], v[j]}});
        const Vector_of_functions<3> a = tangent_direction(cell, 0), b = tangent_direction(cell, 1),
                                     c = form.gradient(cell);
        const Exact_function determinant = c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) +
            c[2] * (a[0] * b[1] - a[1] * b[0]);
        if (!has_one_sign(
                determinant.restricted(0, u[i - 1], u[i]).restricted(1, v[j - 1], v[j]),
                {is_edge(0, i == 1), is_edge(0, i + 1 == u.size()), is_edge(1, j == 1), is_edge(1, j + 1 == v.size())},
                sign))
          return false;
      }
    return true;
  }

  // No coefficient has the other sign, and on the cell, and each of its sides and corners that is not on an edge of the
  // surface, one is not zero: there f is not zero but at the ends.
  static bool has_one_sign(const Exact_function& f, const std::array<bool, 4>& is_edge, int& sign)
  {
    const std::size_t rows = f.size(0), columns = f.size(1);
    for (const Exact_rational& c : f.coefficients()) {
      const int own = static_cast<int>(CGAL::sign(c));
      if (own * sign < 0)
        return false;
      sign = own == 0 ? sign : own;
    }
    const auto ranges = [](std::size_t size, bool begins_at_edge, bool ends_at_edge) {
      std::vector<std::pair<std::size_t, std::size_t>> result{{0, size}};
      if (!begins_at_edge)
        result.emplace_back(0, 1);
      if (!ends_at_edge)
        result.emplace_back(size - 1, size);
      return result;
    };
    for (const auto& [first_row, end_of_rows] : ranges(rows, is_edge[0], is_edge[1]))
      for (const auto& [first_column, end_of_columns] : ranges(columns, is_edge[2], is_edge[3])) {
        bool is_zero = true;
        for (std::size_t i = first_row; i < end_of_rows; ++i)
          for (std::size_t j = first_column; j < end_of_columns; ++j)
            is_zero = is_zero && f.coefficients()[i * columns + j] == 0;
        if (is_zero)
          return false;
      }
    return true;
  }

  // None if one is undecided, or two of them are not told apart. The seam of a closed parameter is no edge.
  std::optional<std::vector<Event>> events_by_parameter() const
  {
    std::vector<Event> result;
    for (const int axis : {0, 1})
      for (const bool is_upper : {false, true}) {
        if (m_surface.is_closed(axis))
          continue;
        const auto [begin, end] = m_surface.domain(axis);
        const Exact_rational& value = is_upper ? end : begin;
        Spline_patch<3> edge = m_surface.part(axis, {value, value});
        if (edge.is_one_point())
          edge = Spline_patch<3>(edge(edge.first_corner()));
        for (const Common_point& found : Intersection_finder<3>(Patch_pair<3>(m_curve, edge), m_solve)()) {
          if (!is_one_point_at_most(found))
            return std::nullopt;
          result.push_back({found.parameters[0], on_surface(found, axis, value)});
        }
      }
    std::sort(result.begin(), result.end(), [](const Event& x, const Event& y) { return x.range < y.range; });
    // at a corner
    const auto are_same = [](const Event& x, const Event& y) {
      return x.range == y.range && x.range.first == x.range.second;
    };
    result.erase(std::unique(result.begin(), result.end(), are_same), result.end());
    for (std::size_t i = 1; i < result.size(); ++i)
      if (!(result[i - 1].range.second < result[i].range.first))
        return std::nullopt;
    return result;
  }

  // Of two curves in space the solver finds the regular solutions of two equations, and may not decide the third one.
  static bool is_one_point_at_most(const Common_point& point)
  {
    switch (point.kind) {
    case Intersection_kind::TRANSVERSAL:
    case Intersection_kind::END_POINT: return true;
    case Intersection_kind::TANGENT: return point.parameters[0].first == point.parameters[0].second;
    case Intersection_kind::UNDECIDED:
      return point.solution && point.solution->reason() == Undecided_reason::OVERDETERMINED;
    case Intersection_kind::OVERLAP: break;
    }
    return false;
  }

  // A common point with an edge, with all parameters; at a pole one of them is free.
  Common_point on_surface(const Common_point& found, int axis, const Exact_rational& value) const
  {
    Common_point result{found.kind == Intersection_kind::TRANSVERSAL ? Intersection_kind::END_POINT : found.kind,
                        {},
                        std::vector<bool>(3, false),
                        std::nullopt,
                        false};
    Parameter_box own{m_surface.domain(0), m_surface.domain(1)};
    own[axis] = {value, value};
    if (found.parameters.size() > 1)
      own[1 - axis] = found.parameters[1];
    result.parameters = with_curve(found.parameters[0], own);
    result.is_at_end[m_pair.first_parameter(m_curve_index)] = found.is_at_end[0];
    result.is_at_end[m_pair.first_parameter(1 - m_curve_index) + static_cast<std::size_t>(axis)] = true;
    if (found.parameters.size() > 1)
      result.is_at_end[m_pair.first_parameter(1 - m_curve_index) + static_cast<std::size_t>(1 - axis)] =
          found.is_at_end[1];
    return result;
  }

  Parameter_box with_curve(const Parameter_range& of_curve, Parameter_box of_surface) const
  {
    of_surface.insert(m_curve_index == 0 ? of_surface.begin() : of_surface.end(), of_curve);
    return of_surface;
  }

  // If it is decided of each one whether it is on the surface.
  std::optional<std::vector<Arc_between_events>> arcs_between(const std::vector<Event>& events) const
  {
    std::vector<Arc_between_events> result;
    const auto [begin, end] = m_curve.domain(0);
    for (std::size_t i = 0; i <= events.size(); ++i) {
      const Parameter_range range(i == 0 ? begin : events[i - 1].range.second,
                                  i == events.size() ? end : events[i].range.first);
      if (!(range.first < range.second))
        continue;
      const Exact_rational third((range.second - range.first) / 3);
      const Exact_rational t =
          simplest_rational_between(Exact_rational(range.first + third), Exact_rational(range.second - third));
      const std::vector<Common_point> found =
          Intersection_finder<3>(Patch_pair<3>(Spline_patch<3>(m_curve(std::array{t})), m_surface), m_solve)();
      const bool is_on_surface = std::any_of(
          found.begin(), found.end(), [](const Common_point& x) { return x.kind != Intersection_kind::UNDECIDED; });
      if (!is_on_surface && !found.empty())
        return std::nullopt;
      result.push_back({i, is_on_surface});
    }
    return result;
  }

  std::vector<Common_point> common_points(const std::vector<Event>& events,
                                          const std::vector<Arc_between_events>& arcs) const
  {
    const auto [begin, end] = m_curve.domain(0);
    std::vector<Common_point> result;
    std::vector<bool> is_on_overlap(events.size(), false);
    for (std::size_t k = 0; k < arcs.size();) {
      if (!arcs[k++].is_on_surface)
        continue;
      const std::size_t first = arcs[k - 1].next_event;
      while (k < arcs.size() && arcs[k].is_on_surface)
        ++k;
      const std::size_t last = arcs[k - 1].next_event;
      for (std::size_t i = first == 0 ? 0 : first - 1; i < events.size() && i <= last; ++i)
        is_on_overlap[i] = true;
      const Parameter_range range(first == 0 ? begin : events[first - 1].range.first,
                                  last == events.size() ? end : events[last].range.second);
      result.push_back({Intersection_kind::OVERLAP, with_curve(range, {m_surface.domain(0), m_surface.domain(1)}),
                        std::vector<bool>(3, false), std::nullopt, false});
    }
    for (std::size_t i = 0; i < events.size(); ++i)
      if (!is_on_overlap[i])
        result.push_back(events[i].point);
    std::sort(result.begin(), result.end(),
              [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CURVES_ON_IMPLICIT_SURFACES_H
