// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REFLECTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REFLECTION_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The reflection in a line <m, x> = c, exactly.
*/
class Reflection_2
{
  Exact_pair m_normal;
  Exact_rational m_offset;

public:
  // In the line through a point in a direction.
  static Reflection_2 in_line(const Exact_pair& point, const Exact_pair& direction)
  {
    Reflection_2 result;
    result.m_normal = {Exact_rational(-direction[1]), direction[0]};
    result.m_offset = exact_dot(result.m_normal, point);
    return result;
  }

  // That of a point to another one; none if they are the same.
  static std::optional<Reflection_2> of_points(const Exact_pair& p, const Exact_pair& q)
  {
    if (p == q)
      return std::nullopt;
    Reflection_2 result;
    result.m_normal = {Exact_rational(q[0] - p[0]), Exact_rational(q[1] - p[1])};
    result.m_offset = (exact_dot(result.m_normal, p) + exact_dot(result.m_normal, q)) / 2;
    return result;
  }

  // That of an arc to another one, or to itself, against its direction or along it; none if there is none.
  static std::optional<Reflection_2> of_arcs(const Site_arc_2& a, const Site_arc_2& b, bool is_reversed)
  {
    for (const int end : {0, 1})
      if (const auto result = of_points(a.at(end), b.at(is_reversed ? 1 - end : end)))
        return result->maps(a, b, is_reversed) ? result : std::nullopt;
    return std::nullopt;
  }

  bool operator==(const Reflection_2& other) const { return sign_of(exact_cross(m_normal, other.m_normal)) == 0 && m_offset * other.m_normal[0] == other.m_offset * m_normal[0] && m_offset * other.m_normal[1] == other.m_offset * m_normal[1]; }

  Exact_pair operator()(const Exact_pair& p) const
  {
    const Exact_rational s = 2 * (exact_dot(m_normal, p) - m_offset) / exact_dot(m_normal, m_normal);
    return {Exact_rational(p[0] - s * m_normal[0]), Exact_rational(p[1] - s * m_normal[1])};
  }

  // Whether the line passes through a point, perpendicularly to a direction.
  bool is_perpendicular(const Exact_pair& p, const Exact_pair& direction) const { return exact_dot(m_normal, p) == m_offset && sign_of(exact_cross(m_normal, direction)) == 0; }

  // Whether the image of an arc is another one, or itself, with the parameter 1 - t or t: their control points are.
  bool maps(const Site_arc_2& a, const Site_arc_2& b, bool is_reversed) const
  {
    if (a.degree() != b.degree())
      return false;
    const Control_points p(a), q(b);
    const std::size_t last = p.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const std::size_t j = is_reversed ? last - i : i, first = is_reversed ? last : 0;
      if (p.weight(i) * q.weight(first) != q.weight(j) * p.weight(0) || (*this)(p.point(i)) != q.point(j))
        return false;
    }
    return true;
  }

private:
  class Control_points
  {
    std::array<std::vector<Exact_rational>, 3> m_coefficients;

  public:
    explicit Control_points(const Site_arc_2& arc)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        const Bernstein_tensor<Exact_rational>& f = arc.piece().coordinates[k];
        m_coefficients[k] = (f.degree(0) < arc.degree() ? f.elevated({arc.degree()}) : f).coefficients();
      }
    }

    std::size_t size() const { return m_coefficients[2].size(); }
    const Exact_rational& weight(std::size_t i) const { return m_coefficients[2][i]; }
    Exact_pair point(std::size_t i) const { return {Exact_rational(m_coefficients[0][i] / weight(i)), Exact_rational(m_coefficients[1][i] / weight(i))}; }
  };
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REFLECTION_2_H
