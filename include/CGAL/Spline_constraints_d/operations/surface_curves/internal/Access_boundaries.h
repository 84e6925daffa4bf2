// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ACCESS_BOUNDARIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ACCESS_BOUNDARIES_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// Finds where a ray from a surface along the axis of the tool only touches something else.
class Access_boundaries
{
  using Vector = Exact_kernel::Vector_3;

  std::optional<Vector> m_direction, m_hemisphere;
  std::optional<Spline_patch<3>> m_field;
  Exact_rational m_radius;
  std::set<Exact_triple> m_corners; // that have their curves
  Operation_budget m_budget;
  std::vector<Oriented_patch> m_parts;
  Parameter_box m_domain;
  Surface_curve_collector m_curves;

public:
  //! \throws Invalid_input when the field has another domain than the surface, or a direction beside it.
  Access_boundaries(const Spline_patch<3>& surface, const Exact_tool_axis& axis, const Solver_options& options)
    : m_direction(vector(axis.direction)), m_hemisphere(vector(axis.hemisphere)), m_radius(axis.radius),
      m_budget(options), m_domain{surface.domain(0), surface.domain(1)}, m_curves(place_on_surface(surface))
  {
    if (axis.field)
      m_field.emplace(*axis.field);
    if (m_field && (m_direction || m_field->domain(0) != m_domain[0] || m_field->domain(1) != m_domain[1]))
      throw Invalid_input("accessibility_boundaries: a field of directions has another domain than the surface, or "
                          "there is a direction beside it");
    if (m_direction && m_hemisphere && !(*m_direction * *m_hemisphere > 0))
      return; // no direction is admitted
    try {
      for (Oriented_patch& part : oriented_patches(surface, check()))
        if (part.is_degenerate)
          m_curves.add_undecided({part.patch.domain(0), part.patch.domain(1)});
        else
          m_parts.push_back(std::move(part));
    } catch (const Run_stopped& stop) {
      m_curves.add_undecided(m_domain, stop.reason);
    }
  }

  const Found_surface_curves& curves() const { return m_curves.found(); }

  // A ray touches a sphere if its center is ahead, at the distance of the radius from the line.
  void add_sphere(const Exact_triple& center, const Exact_rational& squared_radius)
  {
    if (m_radius != 0) {
      add_thick_sphere(center, squared_radius);
      return;
    }
    for (const Oriented_patch& part : m_parts)
      add(part, {}, {}, [&](std::span<const Unknown> u) {
        const Vector_expression<3> ray = constant(*vector(center)) - Parametric_vector<3>(part.patch)(u),
                                   axis = tool_axis(part, u);
        return std::vector<Constraint>{squared_norm(cross(ray, axis)) == squared_radius * squared_norm(axis),
                                       dot(ray, axis) > 0};
      });
  }

  // The contours of a surface, and its edges and creases.
  void add_surface(const Spline_patch<3>& other_surface)
  {
    try {
      add_parts(other_surface, oriented_patches(other_surface, check()));
    } catch (const Run_stopped& stop) {
      m_curves.add_undecided(m_domain, stop.reason);
    }
  }

private:
  // What is asked before each cell.
  std::function<void()> check()
  {
    return [this] { m_budget.check(); };
  }

  void add_parts(const Spline_patch<3>& check, const std::vector<Oriented_patch>& parts)
  {
    for (const Oriented_patch& other : parts) {
      if (other.is_degenerate)
        for (const Oriented_patch& part : m_parts)
          m_curves.add_undecided({part.patch.domain(0), part.patch.domain(1)});
      else if (m_radius != 0)
        add_thick_contacts(other);
      else if (m_direction)
        add_contours(other);
      else
        add_contacts(other);
      for (const int axis : {0, 1})
        for (const int side : {0, 1})
          add_edge(check, other, axis, side);
    }
  }

  // The sum of both radii is r + sqrt(R) with a rational r; (r + sqrt(R))^2 = r^2 + R + 2 r sqrt(R).
  void add_thick_sphere(const Exact_triple& center, const Exact_rational& squared_radius)
  {
    const Exact_rational squares(squared_radius + m_radius * m_radius),
        product(4 * m_radius * m_radius * squared_radius);
    const auto has_distance = [&](const Expression& length, const Expression& unit) {
      if (const auto root = rational_square_root(squared_radius))
        return std::vector<Constraint>{length == Exact_rational(squares + 2 * m_radius * *root) * unit};
      const Expression rest = length - squares * unit;
      return std::vector<Constraint>{rest * rest == product * unit * unit, rest > 0};
    };
    for (const Oriented_patch& part : m_parts) {
      const auto offset = [&](std::span<const Unknown> u) {
        return constant(*vector(center)) - Parametric_vector<3>(part.patch)(u);
      };
      add(part, {}, {}, [&](std::span<const Unknown> u) {
        const Vector_expression<3> axis = tool_axis(part, u);
        std::vector<Constraint> result = has_distance(squared_norm(cross(offset(u), axis)), squared_norm(axis));
        result.push_back(dot(offset(u), axis) > 0);
        return result;
      });
      add(part, {}, {}, [&](std::span<const Unknown> u) {
        return has_distance(squared_norm(offset(u)), Expression(Exact_rational(1)));
      });
    }
  }

  // Where a thick tool touches a surface, a curve or a point: with the offset D from the source to it, the line along O
  // is at the distance r, |D x O|^2 = r^2 |O|^2, or the source, |D|^2 = r^2; both are critical. `tangents(u)` are the
  // derivatives of the other operand, by its parameters in `ranges`.
  template <class Tangents>
  void add_thick(const Spline_patch<3>& other, const Tangents& tangents, const Curve_vertex::Exact_box& ranges,
                 const std::array<bool, 2>& is_closed)
  {
    const Exact_rational square(m_radius * m_radius);
    for (const Oriented_patch& part : m_parts) {
      const auto offset = [&](std::span<const Unknown> u) {
        return Parametric_vector<3>(other)(u.subspan(2)) - Parametric_vector<3>(part.patch)(u.first(2));
      };
      add(part, ranges, is_closed, [&](std::span<const Unknown> u) {
        const Vector_expression<3> axis = tool_axis(part, u), moment = cross(offset(u), axis);
        std::vector<Constraint> result{squared_norm(moment) == square * squared_norm(axis), dot(offset(u), axis) > 0};
        for (const Vector_expression<3>& tangent : tangents(u.subspan(2)))
          result.push_back(dot(moment, cross(tangent, axis)) == 0);
        return result;
      });
      add(part, ranges, is_closed, [&](std::span<const Unknown> u) {
        std::vector<Constraint> result{squared_norm(offset(u)) == square};
        for (const Vector_expression<3>& tangent : tangents(u.subspan(2)))
          result.push_back(dot(offset(u), tangent) == 0);
        return result;
      });
    }
  }

  void add_thick_contacts(const Oriented_patch& other)
  {
    add_thick(
        other.patch,
        [&](std::span<const Unknown> u) {
          return std::vector<Vector_expression<3>>{Parametric_vector<3>(other.tangents[0])(u),
                                                   Parametric_vector<3>(other.tangents[1])(u)};
        },
        {other.patch.domain(0), other.patch.domain(1)}, other.is_seam);
  }

  // Pipes around the pieces of a curve, and spheres around its ends and kinks.
  void add_thick_curve(const Spline_patch<3>& curve)
  {
    const std::vector<Exact_rational> breaks = curve.breaks(0);
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      const Spline_patch<3> piece = curve.part(0, {breaks[i - 1], breaks[i]});
      const Parametric_vector<3> tangent(tangent_direction(piece, 0));
      add_thick(piece, [&](std::span<const Unknown> u) { return std::vector<Vector_expression<3>>{tangent(u)}; },
                {piece.domain(0)}, {false, false});
    }
    std::vector<Exact_rational> corners = curve.possible_kinks(0);
    if (!is_smoothly_closed(curve, breaks)) {
      corners.push_back(breaks.front());
      corners.push_back(breaks.back());
    }
    for (const Exact_rational& corner : corners)
      if (m_corners.insert(curve(std::array{corner})).second) // which is not an end of an edge before
        add_thick(curve.part(0, {corner, corner}),
                  [](std::span<const Unknown>) { return std::vector<Vector_expression<3>>(); }, {}, {false, false});
  }

  static bool is_smoothly_closed(const Spline_patch<3>& curve, const std::vector<Exact_rational>& breaks)
  {
    const auto tangent = [&](const Parameter_range& range, int side) {
      std::array<Exact_rational, 3> result;
      const Vector_of_functions<3> at_end = curve.one_sided_tangent(0, range, side);
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = at_end[i](std::array<Exact_rational, 0>{});
      return Vector(result[0], result[1], result[2]);
    };
    const Vector first = tangent({breaks[0], breaks[1]}, 0), last = tangent({breaks.end()[-2], breaks.back()}, 1);
    return curve.is_closed(0) && CGAL::cross_product(first, last) == CGAL::NULL_VECTOR && first * last > 0;
  }

  static std::optional<Vector> vector(const std::optional<Exact_triple>& coordinates)
  {
    return coordinates ? std::optional(Vector((*coordinates)[0], (*coordinates)[1], (*coordinates)[2])) : std::nullopt;
  }

  static Vector_expression<3> constant(const Vector& v)
  {
    return vector_of<3>([&](std::size_t i) { return Expression(v.cartesian(static_cast<int>(i))); });
  }

  Vector_expression<3> tool_axis(const Oriented_patch& part, std::span<const Unknown> u) const
  {
    return m_direction ? constant(*m_direction)
        : m_field      ? field_vector(part)(u.first(2))
                       : Parametric_vector<3>(part.normal)(u.first(2));
  }

  Parametric_vector<3> field_vector(const Oriented_patch& part) const
  {
    return Parametric_vector<3>(m_field->part({part.patch.domain(0), part.patch.domain(1)}).numerators());
  }

  // That the ray meets a point: its offset is orthogonal to two vectors that are orthogonal to the axis.
  std::vector<Constraint> meeting(const Oriented_patch& part, const Parametric_vector<3>& point,
                                  std::span<const Unknown> u) const
  {
    const Vector_expression<3> ray = point(u.subspan(2)) - Parametric_vector<3>(part.patch)(u.first(2));
    const auto across = [&](int axis) {
      if (m_direction) {
        const Vector first = perpendicular(*m_direction);
        return constant(axis == 0 ? first : CGAL::cross_product(*m_direction, first));
      }
      const Vector_expression<3> tangent =
          Parametric_vector<3>(part.tangents[static_cast<std::size_t>(axis)])(u.first(2));
      return m_field ? cross(tool_axis(part, u), tangent) : tangent;
    };
    return {dot(ray, across(0)) == 0, dot(ray, across(1)) == 0, dot(ray, tool_axis(part, u)) > 0};
  }

  // Where rays along the normals touch a surface.
  void add_contacts(const Oriented_patch& other)
  {
    for (const Oriented_patch& part : m_parts)
      add(part, {other.patch.domain(0), other.patch.domain(1)}, other.is_seam, [&](std::span<const Unknown> u) {
        std::vector<Constraint> result = meeting(part, Parametric_vector<3>(other.patch), u);
        result.push_back(dot(Parametric_vector<3>(other.normal)(u.subspan(2)), tool_axis(part, u)) == 0);
        return result;
      });
  }

  // Parallel rays touch a surface along its silhouettes. A part that is parallel to them is left through its edges.
  void add_contours(const Oriented_patch& other)
  {
    const Cell_functions<1> contour =
        combined<4>(other.planes, {m_direction->x(), m_direction->y(), m_direction->z(), 0});
    for (Continuous_part<1>& contours : continuous_parts(contour, false)) {
      const Curve_vertex::Exact_box domain{contours.functions.domain(0), contours.functions.domain(1)};
      if (contours.functions.is_zero())
        contours.lines = {{0, domain[0].first}, {0, domain[0].second}, {1, domain[1].first}, {1, domain[1].second}};
      else
        for (const Oriented_patch& part : m_parts)
          add(part, domain, seams(other.patch, contours.functions),
              [&, g = contours.functions.splines()[0]](std::span<const Unknown> u) {
                std::vector<Constraint> result = meeting(part, Parametric_vector<3>(other.patch), u);
                result.push_back(formula(g, u.subspan(2)) == 0);
                return result;
              });
      for (const Constant_parameter& line : lines_in_space(other.patch, contours))
        if (!is_edge(other, line))
          add_curve(other.patch.part(line.axis, {line.value, line.value})
                        .part(0, domain[static_cast<std::size_t>(1 - line.axis)]));
    }
  }

  // Those are added anyway.
  static bool is_edge(const Oriented_patch& patch, const Constant_parameter& line)
  {
    const auto [begin, end] = patch.patch.domain(line.axis);
    return (line.value == begin || line.value == end) && !patch.is_seam[static_cast<std::size_t>(line.axis)];
  }

  // An edge of a part of a check surface, unless it is a smooth seam, a point, or the same as another one.
  void add_edge(const Spline_patch<3>& check, const Oriented_patch& other, int axis, int side)
  {
    const auto [begin, end] = other.patch.domain(axis);
    const bool is_known = side == 0 && (begin != check.domain(axis).first || check.is_closed(axis));
    const Exact_rational value = side == 0 ? begin : end;
    const Spline_patch<3> edge = other.patch.part(axis, {value, value});
    if (!is_known && !other.is_seam[static_cast<std::size_t>(axis)] && !edge.is_one_point())
      add_curve(edge);
  }

  // Where rays meet a curve; one along the rays gives one point only, where those of its ends meet.
  void add_curve(const Spline_patch<3>& curve)
  {
    if (m_radius != 0) {
      add_thick_curve(curve);
      return;
    }
    if (m_direction && is_along_direction(curve))
      return;
    for (const Oriented_patch& part : m_parts)
      add(part, {curve.domain(0)}, {curve.is_closed(0), false},
          [&](std::span<const Unknown> u) { return meeting(part, Parametric_vector<3>(curve), u); });
  }

  bool is_along_direction(const Spline_patch<3>& curve) const
  {
    const auto& [x, y, z] = curve.numerators();
    const auto d = *m_direction;
    return curve.with_numerators({y * d.z() - z * d.y(), z * d.x() - x * d.z(), x * d.y() - y * d.x()}).is_one_point();
  }

  // The solutions of constraints in the parameters of a part of the surface, and some others, which may be closed.
  template <class Constraints>
  void add(const Oriented_patch& part, const Curve_vertex::Exact_box& other_ranges,
           const std::array<bool, 2>& is_closed, const Constraints& constraints)
  {
    Curve_vertex::Exact_box domain{part.patch.domain(0), part.patch.domain(1)};
    domain.insert(domain.end(), other_ranges.begin(), other_ranges.end());
    if (m_budget.must_stop()) {
      m_curves.add_undecided(domain, m_budget.reason());
      return;
    }
    const std::vector<Unknown> u = unknowns_in(domain);
    Constraint_system_d system(domain);
    for (const Constraint& constraint : constraints(u))
      system.add(constraint);
    if (m_field)
      system.add(dot(tool_axis(part, u), Parametric_vector<3>(part.normal)(std::span<const Unknown>(u).first(2))) != 0);
    if (m_hemisphere && !m_direction)
      system.add(dot(tool_axis(part, u), constant(*m_hemisphere)) > 0);
    Domain_joints joints;
    for (std::size_t i = 0; i < domain.size(); ++i)
      if (i < 2 ? part.is_seam[i] && (!m_field || m_field->is_closed(static_cast<int>(i))) : is_closed[i - 2])
        joints.closed_unknowns.push_back(i);
    Curve_solution_set_d solutions = curves_within_budget(system, m_budget);
    m_curves.add(std::move(system), std::move(solutions), joints);
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_surface_curves access_boundaries_of(const Exact_map<3>& surface,
                                                                         const Exact_map<3>& check,
                                                                         const Exact_tool_axis& axis,
                                                                         const Solver_options& options)
{
  Access_boundaries boundaries(Spline_patch<3>(surface), axis, options);
  boundaries.add_surface(Spline_patch<3>(check));
  return boundaries.curves();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_surface_curves access_boundaries_of(const Exact_map<3>& surface,
                                                                         const Exact_triple& center,
                                                                         const Exact_rational& squared_radius,
                                                                         const Exact_tool_axis& axis,
                                                                         const Solver_options& options)
{
  Access_boundaries boundaries(Spline_patch<3>(surface), axis, options);
  boundaries.add_sphere(center, squared_radius);
  return boundaries.curves();
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ACCESS_BOUNDARIES_H
