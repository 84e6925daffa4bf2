// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_ELEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_ELEMENT_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/identities.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

using Box_3 = std::array<Interval, 3>;

inline Interval interval_around(const Rational_interval& bounds)
{
  return {to_double_interval(bounds.lower).first, to_double_interval(bounds.upper).second};
}

inline Box_3 interval_box_of(const Vector_bounds<3>& bounds)
{
  return {interval_around(bounds[0]), interval_around(bounds[1]), interval_around(bounds[2])};
}

inline bool do_meet(const Box_3& a, const Box_3& b)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a[axis].sup() < b[axis].inf() || b[axis].sup() < a[axis].inf())
      return false;
  return true;
}

// A polynomial or rational piece of the boundary of a solid, all on unit ranges: a face, an edge with its ends, or a
// corner. Where pieces join smoothly they have edges and corners, too.
struct Solid_element
{
  Spline_patch<3> map;                  // of its two parameters, or one, or none
  std::size_t patch;                    // one that has it
  std::array<Parameter_range, 2> place; // on the patch
  Solid_part part;                      // what its points are, but for the ends
  Box_3 box;
  std::vector<Box_3> boxes_of_parts;

  std::optional<Exact_vector> normal;    // of a plane face
  std::optional<Exact_vector> direction; // of a straight edge, or of a face that is a part of a cylinder
  Vector_of_functions<3> normals;        // of a face, a smooth edge or corner, of the own parameters
  Exact_function plane_offset;           // of a face: normals and this are its tangent planes
  bool has_pole = false;                 // a face with a side that is one point
  bool is_developable = false;           // a face along whose straight lines the tangent plane does not change

  int dimension() const { return map.number_of_parameters(); }
  bool is_straight_edge() const { return dimension() == 1 && direction; }
  Exact_vector first_point() const { return map(map.first_corner()); }
};

// Of the parts that so many halvings of each parameter give.
inline void append_boxes_of_parts(const Spline_patch<3>& map, int halvings, std::vector<Box_3>& boxes)
{
  if (halvings == 0 || map.number_of_parameters() == 0) {
    boxes.push_back(interval_box_of(map.values()));
    return;
  }
  for (const Spline_patch<3>& half : map.halves(0)) {
    if (map.number_of_parameters() == 1)
      append_boxes_of_parts(half, halvings - 1, boxes);
    else
      for (const Spline_patch<3>& quarter : half.halves(1))
        append_boxes_of_parts(quarter, halvings - 1, boxes);
  }
}

// The normal of a face, if it is plane: all tangent planes are the same.
inline std::optional<Exact_vector> normal_of_plane(const std::array<Exact_function, 4>& planes)
{
  std::array<Exact_function, 3> normals{planes[0], planes[1], planes[2]};
  std::optional<Exact_vector> result;
  for (const Exact_rational& v : sample_parameters(degree_of(normals, 1) + 1)) {
    const auto row = part_of<3>(normals, 1, {v, v});
    const auto direction = common_direction(row);
    if (!direction && std::any_of(row.begin(), row.end(), [](const auto& f) { return !vanishes(f); }))
      return std::nullopt;
    if (direction && result && !is_null(exact_cross(*result, *direction)))
      return std::nullopt;
    if (direction)
      result = direction;
  }
  return result;
}

// Whether the tangent plane is the same along all lines on which this parameter changes.
inline bool is_developable_along(const std::array<Exact_function, 4>& planes, int axis)
{
  const std::array<Exact_function, 3> normals{planes[0], planes[1], planes[2]};
  for (const Exact_rational& x :
       sample_parameters((std::max)(degree_of(normals, 1 - axis), planes[3].degree(1 - axis)) + 1)) {
    const auto row = part_of<4>(planes, 1 - axis, {x, x});
    const std::array<Exact_rational, 1> middle{Exact_rational(Exact_rational(1) / 2)};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!vanishes(row[i] * row[k](middle) - row[k] * row[i](middle)))
          return false;
  }
  return true;
}

// The direction that all lines have on which this parameter changes, if they are straight and parallel.
inline std::optional<Exact_vector> direction_of_lines(const Spline_patch<3>& patch, int axis)
{
  const Vector_of_functions<3> tangents = tangent_direction(patch, axis);
  std::optional<Exact_vector> result;
  for (const Exact_rational& x : sample_parameters(degree_of(tangents, 1 - axis) + 1)) {
    const auto direction = common_direction(part_of<3>(tangents, 1 - axis, {x, x}));
    if (!direction || (result && !is_null(exact_cross(*result, *direction))))
      return std::nullopt;
    result = direction;
  }
  return result;
}

// A positive multiple of the derivative of a polynomial or rational curve.
inline Vector_of_functions<3> tangents_of_curve(const Spline_patch<3>& curve)
{
  Vector_of_functions<3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact_function &x = curve.numerators()[i], &w = curve.weight();
    result[i] = curve.is_rational() ? x.derivative(0) * w - x * w.derivative(0) : x.derivative(0);
  }
  return result;
}

// Finds the faces, edges and corners of a solid without inner breaks.
class Solid_elements
{
  using Patch_side = Swept_volumes::Patch_side;

  const Swept_volumes::Solid_boundary& m_solid;
  std::vector<Solid_element> m_elements;
  std::vector<Vector_of_functions<3>>
      m_normals; // of all patches, divided by factors that vanish along sides, as at poles
  std::map<Exact_vector, std::vector<Exact_vector>> m_sharp_tangents; // of edges that end in a point, from there

public:
  explicit Solid_elements(const Swept_volumes::Solid_boundary& solid) : m_solid(solid) {}

  // Not all, if the run has ended.
  std::vector<Solid_element> operator()(const Budgeted_solver& solve)
  {
    for (std::size_t patch = 0; patch < m_solid.size() && !solve.has_ended(); ++patch)
      append_face(patch);
    for (std::size_t patch = 0; patch < m_solid.size() && !solve.has_ended(); ++patch)
      for (int k = 0; k < 4; ++k)
        append_edge({patch, k});
    for (std::size_t patch = 0; patch < m_solid.size() && !solve.has_ended(); ++patch)
      for (const int u : {0, 1})
        for (const int v : {0, 1})
          append_corner(patch, u, v);
    return std::move(m_elements);
  }

private:
  void append(const Spline_patch<3>& map, std::size_t patch, const std::array<Parameter_range, 2>& place,
              Solid_part part)
  {
    Solid_element element{map, patch, place, part, interval_box_of(map.values()), {}, {}, {}, {}, {}};
    append_boxes_of_parts(map, map.number_of_parameters() == 1 ? 3 : 2, element.boxes_of_parts);
    if (part == Solid_part::FACE) {
      element.normals = m_normals[patch];
      for (const int axis : {1, 0})
        element.normals = part_of<3>(element.normals, axis, place[static_cast<std::size_t>(axis)]);
    }
    m_elements.push_back(std::move(element));
  }

  void append_face(std::size_t patch)
  {
    const Parameter_range all(Exact_rational(0), Exact_rational(1));
    const Spline_patch<3>& map = m_solid[patch];
    const auto [x, y, z, offset] = tangent_planes(map, [] {}).front().functions.splines();
    m_normals.push_back({x, y, z});
    append(map, patch, {all, all}, Solid_part::FACE);
    Solid_element& face = m_elements.back();
    for (int k = 0; k < 4; ++k)
      face.has_pole = face.has_pole || !m_solid.glued({patch, k});
    face.plane_offset = offset;
    const auto planes = tangent_plane(map);
    face.normal = normal_of_plane(planes);
    for (int axis = 0; axis < 2 && !face.normal && !face.is_developable; ++axis)
      if (is_developable_along(planes, axis)) {
        face.is_developable = true;
        face.direction = direction_of_lines(map, axis);
      }
  }

  // Each edge is of the patch that comes first.
  void append_edge(const Patch_side& side)
  {
    const auto& other = m_solid.glued(side);
    if (!other || other->side < side)
      return;
    const Exact_rational value(side.end());
    const Spline_patch<3> curve = m_solid[side.patch].part(side.axis(), {value, value});
    std::array<Parameter_range, 2> place;
    place[static_cast<std::size_t>(side.axis())] = {value, value};
    place[static_cast<std::size_t>(side.free_axis())] = {Exact_rational(0), Exact_rational(1)};
    const Vector_of_functions<3> tangents = tangents_of_curve(curve);
    const bool is_smooth = is_smooth_edge(side, *other, tangents);
    append(curve, side.patch, place, is_smooth ? Solid_part::FACE : Solid_part::EDGE);
    m_elements.back().direction = common_direction(tangents);
    if (!is_smooth)
      for (const int end : {0, 1}) {
        Exact_vector tangent = values_at(tangents, Exact_rational(end));
        for (Exact_rational& x : tangent)
          x = end == 0 ? x : Exact_rational(-x);
        m_sharp_tangents[curve(end == 0 ? curve.first_corner() : curve.last_corner())].push_back(tangent);
      }
  }

  // The derivatives of a patch along a side, into the patch.
  Vector_of_functions<3> inward(const Patch_side& side) const
  {
    Vector_of_functions<3> result =
        m_solid[side.patch].one_sided_tangent(side.axis(), {Exact_rational(0), Exact_rational(1)}, side.end());
    for (Exact_function& f : result)
      if (side.end() == 1)
        f = -f;
    return result;
  }

  // Whether both patches have the same tangent plane in each point, and lie on different sides of the edge.
  bool is_smooth_edge(const Patch_side& side, const Swept_volumes::Glued_side& other,
                      const Vector_of_functions<3>& tangents) const
  {
    const Vector_of_functions<3> own = inward(side), beyond = inward(other.side);
    const int degree = degree_of(own) + degree_of(beyond) + degree_of(tangents);
    for (const Exact_rational& x : sample_parameters(degree + 1)) {
      const Exact_vector along = values_at(tangents, x), normal = exact_cross(along, values_at(own, x)),
                         opposite = exact_cross(along, values_at(beyond, other.parameter(x)));
      if (!is_null(exact_cross(normal, opposite)) || exact_dot(normal, opposite) > 0)
        return false;
    }
    return true;
  }

  // Each point once.
  void append_corner(std::size_t patch, int u, int v)
  {
    const Parameter_range at_u{Exact_rational(u), Exact_rational(u)}, at_v{Exact_rational(v), Exact_rational(v)};
    const Spline_patch<3> point = m_solid[patch].part({at_u, at_v});
    const Exact_vector x = point({});
    for (const Solid_element& element : m_elements)
      if (element.dimension() == 0 && element.first_point() == x)
        return;
    append(point, patch, {at_u, at_v}, part_of_corner(x, patch));
  }

  Solid_part part_of_corner(const Exact_vector& point, std::size_t patch) const
  {
    const auto tangents = m_sharp_tangents.find(point);
    if (tangents == m_sharp_tangents.end())
      return is_smooth_pole(point, patch) ? Solid_part::FACE : Solid_part::CORNER;
    const std::vector<Exact_vector>& t = tangents->second;
    return t.size() == 2 && !is_null(t[0]) && !is_null(t[1]) && is_null(exact_cross(t[0], t[1])) &&
            exact_dot(t[0], t[1]) < 0
        ? Solid_part::EDGE
        : Solid_part::CORNER;
  }

  // Of a point in which no sharp edge ends: whether it is no pole, or all tangents there lie in one plane.
  bool is_smooth_pole(const Exact_vector& point, std::size_t first) const
  {
    std::vector<Exact_vector> tangents;
    for (std::size_t patch = first; patch < m_solid.size(); ++patch)
      for (int k = 0; k < 4; ++k) {
        const Patch_side side{patch, k};
        const Exact_rational value(side.end());
        const Spline_patch<3> curve = m_solid[patch].part(side.axis(), {value, value});
        if (m_solid.glued(side) || curve(curve.first_corner()) != point)
          continue;
        const Vector_of_functions<3> own = inward(side);
        for (const Exact_rational& x : sample_parameters(degree_of(own) + 1))
          tangents.push_back(values_at(own, x));
      }
    if (tangents.empty())
      return true;
    Exact_vector normal{Exact_rational(0), Exact_rational(0), Exact_rational(0)};
    for (const Exact_vector& t : tangents)
      if (is_null(normal))
        normal = exact_cross(tangents.front(), t);
    return !is_null(normal) &&
        std::all_of(tangents.begin(), tangents.end(), [&](const Exact_vector& t) { return exact_dot(normal, t) == 0; });
  }
};

inline std::vector<Solid_element> elements_of(const Swept_volumes::Solid_boundary& solid, const Budgeted_solver& solve)
{
  return Solid_elements(solid)(solve);
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_ELEMENT_H
