// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_CONTACTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_CONTACTS_H

#include <CGAL/Spline_constraints_d/operations/intersections/internal/Shared_edges.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/settle_undecided_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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
The contacts of two polynomial pieces that are linear in one parameter each, p(u) + x a(u) and q(s) + y b(s), in a box
where a and b are not parallel and the second piece is regular: the lines meet where F = det(q - p, a, b) = 0, and there
F_u = -det(A_u, a, b) and F_s = det(B_s, a, b), so they touch where F, F_u and F_s are zero; a system in two unknowns,
which the solver decides at irrational parameters, too. The others follow by Cramer's rule, with c = a x b: x = det(q -
p, b, c) / c^2, y = det(q - p, a, c) / c^2.
*/
class Ruled_contacts
{
  std::array<int, 2> m_axes{-1, -1};   // of the lines
  std::array<Vector_function<3>, 2> m_points, m_directions;

public:
  explicit Ruled_contacts(const Patch_pair<3>& pieces)
  {
    for (const std::size_t k : {0, 1})
      for (int axis = 0; axis < 2 && !pieces[k].is_rational(); ++axis)
        if (std::all_of(pieces[k].numerators().begin(), pieces[k].numerators().end(),
                        [&](const Exact_function& x) { return x.degree(axis) <= 1; })) {
          const auto end = [&](const Exact_rational& value) {
            return Vector_function<3>(part_of<3>(pieces[k].numerators(), axis, {value, value}));
          };
          m_axes[k] = axis;
          m_points[k] = end(pieces[k].domain(axis).first);
          m_directions[k] = end(pieces[k].domain(axis).second) - m_points[k];
        }
  }

  // Those in a box or near it, if all are decided.
  std::optional<std::vector<Common_point>> contacts(const Patch_pair<3>& pieces, const Parameter_box& box,
                                                    Budgeted_solver& solve) const
  {
    if (m_axes[0] < 0 || m_axes[1] < 0)
      return std::nullopt;
    const Parameter_box near = with_margin(box, pieces.domain());
    const Patch_pair<3> part = pieces.part(near);
    if (may_be_parallel<3>(part[0].tangents(m_axes[0]), part[1].tangents(m_axes[1])) ||
        may_be_parallel<3>(part[1].tangents(0), part[1].tangents(1)))
      return std::nullopt;
    const Parameter_box domain{near[1 - m_axes[0]], near[3 - m_axes[1]]};
    const auto on = [&](std::size_t k, const Vector_function<3>& f) {
      return Vector_function<3>(part_of<3>(f.functions(), 0, domain[k])).on_axis(domain, static_cast<int>(k));
    };
    const Vector_function<3> a = on(0, m_directions[0]), b = on(1, m_directions[1]),
                             gap = on(1, m_points[1]) - on(0, m_points[0]), c = cross(a, b);
    const Exact_function f = dot(gap, c).function();
    const std::vector<Unknown> u = unknowns(
        {{Bound(domain[0].first), Bound(domain[0].second)}, {Bound(domain[1].first), Bound(domain[1].second)}});
    const Vector_expression<3> values =
        Spline_map<2, 3>({f + f.derivative(0), f.derivative(0), f.derivative(1)})(u[0], u[1]);
    std::vector<Common_point> result;
    for (const Solution_d<double>& solution : solve({values[0] == 0, values[1] == 0, values[2] == 0}, u)) {
      if (solution.kind() != Solution_kind::CERTIFIED && solution.kind() != Solution_kind::CLUSTER)
        return std::nullopt;
      const Parameter_box own = clipped(with_short_ends(solution.exact_box()), domain);
      Parameter_box parameters = box;
      for (const std::size_t k : {0, 1}) {
        const Rational_interval share = range_of(dot(cross(gap, k == 0 ? b : a), c), own) / range_of(dot(c, c), own);
        const Parameter_range range = pieces[k].domain(m_axes[k]);
        const Exact_rational length(range.second - range.first);
        parameters[2 * k + 1 - m_axes[k]] = own[k];
        parameters[2 * k + m_axes[k]] = {Exact_rational(range.first + length * share.lower),
                                         Exact_rational(range.first + length * share.upper)};
      }
      if (!have_common_part(parameters, box))
        continue;
      if (!is_part_of(parameters, near) || !is_inside(parameters, pieces.domain()) || result.size() == 1)
        return std::nullopt;
      result.push_back({Intersection_kind::TANGENT, parameters, std::vector<bool>(4, false), std::nullopt, false});
    }
    return result;
  }

private:
  // So that enclosures of what is in the box are in the larger one.
  static Parameter_box with_margin(Parameter_box box, const Parameter_box& domain)
  {
    for (std::size_t j = 0; j < box.size(); ++j) {
      const Exact_rational margin((domain[j].second - domain[j].first) / 1024);
      box[j] = {Exact_rational(box[j].first - margin), Exact_rational(box[j].second + margin)};
    }
    return clipped(box, domain);
  }

  static bool is_inside(const Parameter_box& box, const Parameter_box& domain)
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if (!(domain[j].first < box[j].first && box[j].second < domain[j].second))
        return false;
    return true;
  }

  static Rational_interval range_of(const Scalar_function& f, const Parameter_box& box)
  {
    const Exact_function part = part_of(part_of(f.function(), 1, box[1]), 0, box[0]);
    return Rational_interval(part.bounds());
  }
};

/*
Boxes of two polynomial pieces of surfaces that the solver could not decide, as the equations of a contact are one more
than the unknowns: those with contacts on a common edge of the surfaces alone, and those of pieces of straight lines,
are systems in fewer unknowns. What these decide takes the place of the box, unless another answer may be the same one.
*/
inline void settle_undecided_contacts(const Shared_edges& edges, const Patch_pair<3>& pieces,
                                      const std::vector<bool>& is_open, std::vector<Common_point>& points,
                                      Budgeted_solver& solve)
{
  const Ruled_contacts lines(pieces);
  const std::vector<Common_point> all = points;
  std::vector<Common_point> settled;
  std::erase_if(points, [&](const Common_point& point) {
    if (point.kind != Intersection_kind::UNDECIDED)
      return false;
    std::optional<std::vector<Common_point>> found = edges.contacts(pieces, is_open, point.parameters, solve);
    if (!found)
      found = lines.contacts(pieces, point.parameters, solve);
    const auto may_be_known = [&](const Common_point& contact) {
      const auto meets = [&](const Common_point& other) {
        return have_common_part(contact.parameters, other.parameters);
      };
      return std::any_of(settled.begin(), settled.end(), meets) ||
          std::any_of(all.begin(), all.end(), [&](const Common_point& other) {
               return other.kind != Intersection_kind::UNDECIDED && meets(other);
             });
    };
    if (!found || std::any_of(found->begin(), found->end(), may_be_known))
      return false;
    settled.insert(settled.end(), found->begin(), found->end());
    return true;
  });
  points.insert(points.end(), settled.begin(), settled.end());
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_CONTACTS_H
