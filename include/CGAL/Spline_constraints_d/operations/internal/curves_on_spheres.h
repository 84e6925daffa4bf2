// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_ON_SPHERES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_ON_SPHERES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>
#include <CGAL/Spline_constraints_d/operations/internal/Tangent_planes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline Exact_rational determinant_of(const std::array<std::array<Exact_rational, 3>, 3>& rows)
{
  const auto& [a, b, c] = rows;
  return Exact_rational(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]));
}

// A sphere that holds all points of a patch, decided exactly.
class Exact_sphere
{
  using Point = std::array<Exact_rational, 3>;

  Point m_center;
  Exact_rational m_squared_radius;

  Exact_sphere(Point center, Exact_rational squared_radius) : m_center(std::move(center)), m_squared_radius(std::move(squared_radius)) {}

public:
  // Of a surface.
  static std::optional<Exact_sphere> around(const Spline_patch<3>& surface)
  {
    std::vector<Point> points;
    for (const auto& [i, j] : {std::pair(1, 2), std::pair(4, 1), std::pair(2, 4), std::pair(3, 3)}) {
      const auto at = [&](int axis, int k) { return Exact_rational(surface.domain(axis).first + (surface.domain(axis).second - surface.domain(axis).first) * k / 5); };
      points.push_back(surface(std::array{at(0, i), at(1, j)}));
    }
    std::array<Point, 3> rows;   // <2 (p_k - p_0), center> = |p_k|^2 - |p_0|^2
    Point right;
    const Point origin{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        rows[k][i] = Exact_rational(2 * (points[k + 1][i] - points[0][i]));
      right[k] = Exact_rational(squared_distance_of<3>(points[k + 1], origin) - squared_distance_of<3>(points[0], origin));
    }
    const Exact_rational determinant = determinant_of(rows);
    if (determinant == 0)
      return std::nullopt;
    Point center;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Point, 3> replaced = rows;
      for (std::size_t k = 0; k < 3; ++k)
        replaced[k][i] = right[k];
      center[i] = Exact_rational(determinant_of(replaced) / determinant);
    }
    const Exact_sphere result(center, squared_distance_of<3>(points[0], center));
    return result.holds(surface) ? std::optional(result) : std::nullopt;
  }

  bool holds(const Spline_patch<3>& patch) const
  {
    if (squared_distance_of<3>(patch(patch.middle()), m_center) != m_squared_radius)   // most patches end here
      return false;
    const Vector_of_functions<3> offset = from_center(patch);
    return offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2] == patch.weight() * patch.weight() * m_squared_radius;
  }

  // Points of a patch minus the center, times the weight.
  Vector_of_functions<3> from_center(const Spline_patch<3>& patch) const
  {
    Vector_of_functions<3> result = patch.numerators();
    for (int i = 0; i < 3; ++i)
      result[i] = result[i] - patch.weight() * m_center[i];
    return result;
  }
};

/*
A curve on a sphere and a surface that is a part of this sphere. Away from its edges the surface is proved to be regular, so around each of its points there it is all of the sphere. Between two common points with the edges the curve
therefore runs within the surface, or outside of it, which is decided at one of its points.
*/
class Curve_on_sphere
{
  // Where the curve meets an edge; or may do so in one point at most, if that is undecided.
  struct Event
  {
    Parameter_range range;
    Common_point point;
  };

  struct Stretch
  {
    std::size_t next_event;
    bool is_on_surface;
  };

  const Patch_pair<3>& m_pair;
  std::size_t m_curve_index;
  const Spline_patch<3>&m_curve, &m_surface;
  Summing_solver& m_solve;

public:
  Curve_on_sphere(const Patch_pair<3>& pair, Summing_solver& solve)
    : m_pair(pair), m_curve_index(pair[0].number_of_parameters() == 1 ? 0 : 1), m_curve(pair[m_curve_index]), m_surface(pair[1 - m_curve_index]), m_solve(solve)
  {}

  // None if they are not of this kind, or something is not decided.
  std::optional<std::vector<Common_point>> operator()() const
  {
    const std::optional<Exact_sphere> sphere = Exact_sphere::around(m_surface);
    if (!sphere || !sphere->holds(m_curve) || !is_regular(*sphere))
      return std::nullopt;
    const auto events = events_by_parameter();
    const auto stretches = events ? stretches_between(*events) : std::nullopt;
    return stretches ? std::optional(common_points(*events, *stretches)) : std::nullopt;
  }

private:
  // Whether det(S_u, S_v, S - center) has one sign within the edges, by its Bernstein coefficients, and no tangent jumps.
  bool is_regular(const Exact_sphere& sphere) const
  {
    int sign = 0;
    for (const int axis : {0, 1})
      if (parts_of(m_surface, axis, perpendicular_before).size() != 1)
        return false;
    const std::vector<Exact_rational> u = m_surface.breaks(0), v = m_surface.breaks(1);
    for (std::size_t i = 1; i < u.size(); ++i)
      for (std::size_t j = 1; j < v.size(); ++j) {
        const Spline_patch<3> cell = m_surface.part({{u[i - 1], u[i]}, {v[j - 1], v[j]}});
        const Vector_of_functions<3> a = tangent_direction(cell, 0), b = tangent_direction(cell, 1), c = sphere.from_center(cell);
        const Exact_function determinant = c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0]);
        if (!has_one_sign(determinant.restricted(0, u[i - 1], u[i]).restricted(1, v[j - 1], v[j]), {i == 1, i + 1 == u.size(), j == 1, j + 1 == v.size()}, sign))
          return false;
      }
    return true;
  }

  // Of the coefficients; zero is admitted in the layers at edges: of the first axis the first and last one, and of the second axis.
  static bool has_one_sign(const Exact_function& f, const std::array<bool, 4>& is_edge, int& sign)
  {
    const std::size_t rows = f.size(0), columns = f.size(1);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const int own = static_cast<int>(CGAL::sign(f.coefficients()[i * columns + j]));
        const bool is_in_layer = (is_edge[0] && i == 0) || (is_edge[1] && i + 1 == rows) || (is_edge[2] && j == 0) || (is_edge[3] && j + 1 == columns);
        if (own == 0 ? !is_in_layer : own * sign < 0)
          return false;
        sign = own == 0 ? sign : own;
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
    const auto are_same = [](const Event& x, const Event& y) { return x.range == y.range && x.range.first == x.range.second; };   // at a corner
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
    case Intersection_kind::UNDECIDED: return point.solution && point.solution->reason() == Undecided_reason::OVERDETERMINED;
    case Intersection_kind::OVERLAP: break;
    }
    return false;
  }

  // A common point with an edge, with all parameters; at a pole one of them is free.
  Common_point on_surface(const Common_point& found, int axis, const Exact_rational& value) const
  {
    Common_point result{found.kind == Intersection_kind::TRANSVERSAL ? Intersection_kind::END_POINT : found.kind, {}, std::vector<bool>(3, false), std::nullopt, false};
    Parameter_box own{m_surface.domain(0), m_surface.domain(1)};
    own[axis] = {value, value};
    if (found.parameters.size() > 1)
      own[1 - axis] = found.parameters[1];
    result.parameters = with_curve(found.parameters[0], own);
    result.is_at_end[m_pair.first_parameter(m_curve_index)] = found.is_at_end[0];
    result.is_at_end[m_pair.first_parameter(1 - m_curve_index) + static_cast<std::size_t>(axis)] = true;
    if (found.parameters.size() > 1)
      result.is_at_end[m_pair.first_parameter(1 - m_curve_index) + static_cast<std::size_t>(1 - axis)] = found.is_at_end[1];
    return result;
  }

  Parameter_box with_curve(const Parameter_range& of_curve, Parameter_box of_surface) const
  {
    of_surface.insert(m_curve_index == 0 ? of_surface.begin() : of_surface.end(), of_curve);
    return of_surface;
  }

  // The parts of the curve between events, if all are decided.
  std::optional<std::vector<Stretch>> stretches_between(const std::vector<Event>& events) const
  {
    std::vector<Stretch> result;
    const auto [begin, end] = m_curve.domain(0);
    for (std::size_t i = 0; i <= events.size(); ++i) {
      const Parameter_range range(i == 0 ? begin : events[i - 1].range.second, i == events.size() ? end : events[i].range.first);
      if (!(range.first < range.second))
        continue;
      const Exact_rational third((range.second - range.first) / 3);
      const Exact_rational t = simplest_rational_between(Exact_rational(range.first + third), Exact_rational(range.second - third));
      const std::vector<Common_point> found = Intersection_finder<3>(Patch_pair<3>(Spline_patch<3>(m_curve(std::array{t})), m_surface), m_solve)();
      const bool is_on_surface = std::any_of(found.begin(), found.end(), [](const Common_point& x) { return x.kind != Intersection_kind::UNDECIDED; });
      if (!is_on_surface && !found.empty())
        return std::nullopt;
      result.push_back({i, is_on_surface});
    }
    return result;
  }

  std::vector<Common_point> common_points(const std::vector<Event>& events, const std::vector<Stretch>& stretches) const
  {
    const auto [begin, end] = m_curve.domain(0);
    std::vector<Common_point> result;
    std::vector<bool> is_on_overlap(events.size(), false);
    for (std::size_t k = 0; k < stretches.size();) {
      if (!stretches[k++].is_on_surface)
        continue;
      const std::size_t first = stretches[k - 1].next_event;
      while (k < stretches.size() && stretches[k].is_on_surface)
        ++k;
      const std::size_t last = stretches[k - 1].next_event;
      for (std::size_t i = first == 0 ? 0 : first - 1; i < events.size() && i <= last; ++i)
        is_on_overlap[i] = true;
      const Parameter_range range(first == 0 ? begin : events[first - 1].range.first, last == events.size() ? end : events[last].range.second);
      result.push_back({Intersection_kind::OVERLAP, with_curve(range, {m_surface.domain(0), m_surface.domain(1)}), std::vector<bool>(3, false), std::nullopt, false});
    }
    for (std::size_t i = 0; i < events.size(); ++i)
      if (!is_on_overlap[i])
        result.push_back(events[i].point);
    std::sort(result.begin(), result.end(), [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_ON_SPHERES_H
