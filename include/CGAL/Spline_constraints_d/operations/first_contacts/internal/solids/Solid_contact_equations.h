// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_EQUATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_EQUATIONS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Moving_space.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_element.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/identities.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A solution of the equations of two elements: their parameters, and the time.
struct Solid_candidate
{
  std::array<std::size_t, 2> elements;                    // of the moving solid, and of the fixed one
  std::array<std::vector<Parameter_range>, 2> parameters; // as many as the element has
  Parameter_range time;
  Solution_d<double> solution;
  bool is_alone = true; // or else there may be others in the enclosure

  // Whether there is a contact.
  bool is_proved() const { return solution.kind() != Solution_kind::UNDECIDED; }
};

/*
The equations of a contact of an element of the moving solid with one of the fixed one, in a part of the time. All
solutions are points that the boundaries have in common at that time: equal points, and

  two faces             the tangent plane of the fixed one holds both tangents of the moving one,
  an edge and a face    the tangent plane holds the tangent of the edge,

which are as many equations as unknowns; so are equal points of two edges, or of a corner and a face. There are more
equations where a corner meets an edge or a corner, and where the tangent of an edge is in the plane of a smooth one.
*/
class Solid_contact_equations
{
  const Solid_element &m_moving, &m_fixed;
  const Moving_space& m_motion;

public:
  Solid_contact_equations(const Solid_element& moving, const Solid_element& fixed, const Moving_space& motion)
    : m_moving(moving), m_fixed(fixed), m_motion(motion)
  {}

  /*
  Whether there is nothing to solve: solids that were apart before and meet now in such a pair meet at the same time in
  a pair of elements one of which has fewer dimensions. That is so if each contact of the pair lies in a segment, or a
  plane curve, of contacts, which ends where one of both elements ends; and if two elements slide in a common line or
  plane, in which they first meet with an end.
  */
  bool are_void() const
  {
    const int moving = m_moving.dimension(), fixed = m_fixed.dimension();
    if (moving + fixed > 2 && slide_on_plane())
      return true;
    if (moving == 2 && fixed == 2)
      return share_lines(m_moving, m_fixed);
    if (moving + fixed == 3)
      return moving == 2 ? edge_stays_along(m_fixed, m_moving, true) : edge_stays_along(m_moving, m_fixed, false);
    if (moving == 1 && fixed == 1)
      return m_moving.is_straight_edge() && m_fixed.is_straight_edge() && lines_stay_in_plane();
    if (moving == 0 && fixed == 2)
      return m_fixed.normal && vanishes(dot_of(way_between_first_points(), *m_fixed.normal));
    if (moving == 2 && fixed == 0)
      return m_moving.normal && stays_orthogonal(m_motion.image_of_normal(*m_moving.normal));
    if (moving == 0 && fixed == 1)
      return m_fixed.is_straight_edge() && stay_parallel(way_between_first_points(), *m_fixed.direction);
    if (moving == 1 && fixed == 0)
      return m_moving.is_straight_edge() &&
          stay_parallel(m_motion.image_of_direction(*m_moving.direction), way_between_first_points());
    return false;
  }

  // The unknowns are the parameters of the moving element, those of the fixed one, and the time.
  Solution_set_d<double> solutions(Budgeted_solver& solve) const
  {
    std::vector<Parameter_range> domain(static_cast<std::size_t>(m_moving.dimension() + m_fixed.dimension()),
                                        {Exact_rational(0), Exact_rational(1)});
    domain.push_back(m_motion.time());
    const std::vector<Unknown> x = unknowns_in(domain);
    const Unknown& time = x.back();
    const std::span own = std::span(x).first(static_cast<std::size_t>(m_moving.dimension())),
                    other = std::span(x).subspan(own.size(), static_cast<std::size_t>(m_fixed.dimension()));
    const Homogeneous_expression p = m_motion.image(point(m_moving.map, own), time), q = point(m_fixed.map, other);
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < 3; ++i)
      constraints.push_back(p.x[i] * q.w == q.x[i] * p.w);
    if (own.size() + other.size() > 2 && other.size() == 2) {
      const Homogeneous_expression plane{values(m_fixed.normals, other), values(m_fixed.plane_offset, other)};
      for (std::size_t axis = 0; axis < own.size(); ++axis) {
        const Homogeneous_expression along = m_motion.image(derivative_of(m_moving.map, axis, own), time);
        constraints.push_back(dot(plane.x, along.x) + plane.w * along.w == 0);
      }
    } else if (own.size() + other.size() > 2) {
      const Vector_expression<3> normal = m_motion.image_of_normal(values(m_moving.normals, own), time),
                                 tangent = Spline_map<1, 3>(tangents_of_curve(m_fixed.map))(other[0]);
      constraints.push_back(dot(normal, tangent) == 0);
    } else if (own.size() == 1 && other.size() == 1 && (is_smooth(m_moving) || is_smooth(m_fixed))) {
      const Vector_expression<3> a = m_motion.image_of_direction(values(tangents_of_curve(m_moving.map), own), time),
                                 b = values(tangents_of_curve(m_fixed.map), other);
      // the tangents of both are in the tangent plane of the smooth one, whose normals along the edge are known
      const Solid_element& smooth = is_smooth(m_fixed) ? m_fixed : m_moving;
      const Vector_expression<3> normal = values(smooth.normals, is_smooth(m_fixed) ? other : own);
      constraints.push_back(is_smooth(m_fixed) ? dot(normal, a) == 0
                                               : dot(m_motion.image_of_normal(normal, time), b) == 0);
    }
    if (!m_moving.has_pole && !m_fixed.has_pole)
      return solve(constraints, x);
    // In a pole one parameter is free, and two where poles meet: there may be a curve or a surface of solutions.
    Budgeted_solver limited = solve.limited(m_moving.has_pole && m_fixed.has_pole ? 512 : 4096);
    Solution_set_d<double> result = limited(constraints, x);
    solve.add_work_of(limited);
    return result;
  }

private:
  static bool is_smooth(const Solid_element& element) { return element.part == Solid_part::FACE; }

  // Whether a plane face keeps its plane, seen from the other element, which then always touches it in the same points.
  bool slide_on_plane() const
  {
    return (m_fixed.normal && m_motion.keeps_fixed_plane(m_fixed.first_point(), *m_fixed.normal)) ||
        (m_moving.normal && m_motion.keeps_moving_plane(m_moving.first_point(), *m_moving.normal));
  }

  // Of two faces: whether a straight line on one of them, along which its tangent plane is the same, is in the other
  // face wherever they have a common tangent plane.
  bool share_lines(const Solid_element& a, const Solid_element& b) const
  {
    if ((a.normal || a.is_developable) && (b.normal || b.is_developable) && (a.normal || b.normal))
      return true;
    return a.is_developable && b.is_developable && are_always_parallel();
  }

  // Of parts of cylinders, and straight edges.
  bool are_always_parallel() const
  {
    if (!m_moving.direction || !m_fixed.direction)
      return false;
    return stay_parallel(m_motion.image_of_direction(*m_moving.direction), *m_fixed.direction);
  }

  bool stay_parallel(const Vector_of_functions<3>& a, const Exact_vector& b) const
  {
    return stay_parallel(a, weighted(b));
  }

  static bool stay_parallel(const Vector_of_functions<3>& a, const Vector_of_functions<3>& b)
  {
    return std::ranges::all_of(Moving_space::cross_of(a, b), [](const Exact_function& f) { return vanishes(f); });
  }

  // A fixed vector times w.
  Vector_of_functions<3> weighted(const Exact_vector& x) const
  {
    return {m_motion.weight() * x[0], m_motion.weight() * x[1], m_motion.weight() * x[2]};
  }

  // Of an edge and a face: the same, or whether the edge is all the time in a plane parallel to the plane face.
  bool edge_stays_along(const Solid_element& edge, const Solid_element& face, bool is_face_moving) const
  {
    if (edge.direction && (face.normal || (face.is_developable && are_always_parallel())))
      return true;
    if (!face.normal)
      return false;
    const Vector_of_functions<3> tangents = tangents_of_curve(edge.map);
    const std::vector<Exact_rational> parameters = sample_parameters(degree_of(tangents) + 1);
    return std::all_of(parameters.begin(), parameters.end(), [&](const Exact_rational& x) {
      const Exact_vector tangent = values_at(tangents, x);
      return vanishes(is_face_moving ? dot_of(m_motion.image_of_normal(*face.normal), tangent)
                                     : dot_of(m_motion.image_of_direction(tangent), *face.normal));
    });
  }

  // From the first point of the fixed element to that of the moving one, times w.
  Vector_of_functions<3> way_between_first_points() const
  {
    Vector_of_functions<3> result = m_motion.image_of_point(m_moving.first_point());
    const Vector_of_functions<3> fixed = weighted(m_fixed.first_point());
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = result[i] - fixed[i];
    return result;
  }

  bool stays_orthogonal(const Vector_of_functions<3>& normal) const
  {
    const Vector_of_functions<3> way = way_between_first_points();
    return vanishes(way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2]);
  }

  // Of straight edges, parallel ones among them.
  bool lines_stay_in_plane() const
  {
    return stays_orthogonal(
        Moving_space::cross_of(m_motion.image_of_direction(*m_moving.direction), weighted(*m_fixed.direction)));
  }

  static Vector_expression<3> values(const Vector_of_functions<3>& f, std::span<const Unknown> u)
  {
    return Common::Parametric_vector<3>(f)(u);
  }

  static Expression values(const Exact_function& f, std::span<const Unknown> u)
  {
    return Common::Parametric_vector<3>(Vector_of_functions<3>{f, f, f})(u)[0];
  }

  // Of polynomial maps the weight is one.
  static Homogeneous_expression point(const Spline_patch<3>& map, std::span<const Unknown> u)
  {
    return {values(map.numerators(), u), map.is_rational() ? values(map.weight(), u) : Expression(Exact_rational(1))};
  }

  static Homogeneous_expression derivative_of(const Spline_patch<3>& map, std::size_t axis, std::span<const Unknown> u)
  {
    const int k = static_cast<int>(axis);
    const auto& [x, y, z] = map.numerators();
    return {values({x.derivative(k), y.derivative(k), z.derivative(k)}, u),
            map.is_rational() ? values(map.weight().derivative(k), u) : Expression(Exact_rational(0))};
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_EQUATIONS_H
