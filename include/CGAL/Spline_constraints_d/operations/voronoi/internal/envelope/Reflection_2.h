// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_REFLECTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_REFLECTION_2_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Control_points_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

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

  // That of a piece to another one, or to itself, against its direction or along it; none if there is none.
  static std::optional<Reflection_2> of_pieces(const Homogeneous_piece& a, const Homogeneous_piece& b, bool is_reversed)
  {
    const auto point = [](const Homogeneous_piece& piece, bool is_end) {
      const Control_points_2 points(piece);
      return points.point(is_end ? points.size() - 1 : 0);
    };
    for (const bool is_end : {false, true})
      if (const auto result = of_points(point(a, is_end), point(b, is_end != is_reversed)))
        return result->maps(a, b, is_reversed) ? result : std::nullopt;
    return std::nullopt;
  }

  // Those that map the line of a straight arc to that of another one; none if they are not rational.
  static std::vector<Reflection_2> of_lines(const Exact_arc_2& a, const Exact_arc_2& b)
  {
    const auto vector = [](const Exact_pair& p, const Exact_pair& q) {
      return Exact_pair{Exact_rational(q[0] - p[0]), Exact_rational(q[1] - p[1])};
    };
    const Exact_pair p = a.at(0), q = b.at(0), d = vector(p, a.at(1)), e = vector(q, b.at(1));
    const Exact_rational sine = exact_cross(d, e);
    if (sign_of(sine) == 0) {
      const Exact_rational s = exact_dot(vector(p, q), d) / exact_dot(d, d);
      const auto result = of_points(Exact_pair{Exact_rational(p[0] + s * d[0]), Exact_rational(p[1] + s * d[1])}, q);
      return result ? std::vector{*result} : std::vector<Reflection_2>{};
    }
    const auto ratio = rational_square_root(Exact_rational(exact_dot(d, d) / exact_dot(e, e)));
    if (!ratio)
      return {};
    const Exact_rational t = exact_cross(vector(p, q), e) / sine;
    const Exact_pair common{Exact_rational(p[0] + t * d[0]), Exact_rational(p[1] + t * d[1])};
    const Exact_pair sum{Exact_rational(d[0] + *ratio * e[0]), Exact_rational(d[1] + *ratio * e[1])};
    return {in_line(common, sum), in_line(common, Exact_pair{Exact_rational(-sum[1]), sum[0]})};
  }

  Exact_pair operator()(const Exact_pair& p) const
  {
    const Exact_rational s = 2 * (exact_dot(m_normal, p) - m_offset) / exact_dot(m_normal, m_normal);
    return {Exact_rational(p[0] - s * m_normal[0]), Exact_rational(p[1] - s * m_normal[1])};
  }

  // Whether the line passes through a point, perpendicularly to a direction.
  bool is_perpendicular(const Exact_pair& p, const Exact_pair& direction) const
  {
    return exact_dot(m_normal, p) == m_offset && sign_of(exact_cross(m_normal, direction)) == 0;
  }

  // Whether the image of a piece is another one, or itself, with the parameter 1 - t or t.
  bool maps(const Homogeneous_piece& a, const Homogeneous_piece& b, bool is_reversed) const
  {
    return is_image(a, *this, b, is_reversed);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_REFLECTION_2_H
