// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_EQUATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_EQUATIONS_H

#include <CGAL/Spline_constraints_d/function/internal/substitution.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Height_field.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Patch_inverse.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_poles.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Whether the parameters of one of two height fields are left out, as functions of those of the other one.
enum class Unknowns_of_surfaces { FEWEST, ALL_PARAMETERS };

/*
The equations of the common points of two surfaces, in as few unknowns as there are simple ones:

- a parametric surface S and an implicit one: f(S(u,v)) = 0;
- two parametric ones: A(u,v) = B(s,t); two height fields over the same coordinates: the difference of the heights, in
  the parameters of the first one;
- two implicit ones, and one that ends at its box within a parametric one: the coordinates are unknowns, behind the
  parameters.

Or those of the pairs of points of a parametric surface that are the same point in space, see Equal_point_pairs.h: both
surfaces are this one.

- two parametric ones, where one is a part of the zeros of a polynomial: that of the other one, see Implicit_patch.

The parameters of a surface are affine functions of one unknown each, or those of the common point.
*/
class Surface_equations
{
  using Equations = std::vector<Constraint>;

  std::array<Surface_shape, 2> m_surfaces;
  std::array<std::array<Affine_function, 2>, 2> m_parameters;   // of parametric surfaces
  bool m_has_coordinates = false, m_is_self_intersection = false;
  Parameter_box m_domain;
  std::optional<Constraint_system_d> m_system;   // none: no common points
  std::shared_ptr<const Patch_inverse> m_inverse;
  std::size_t m_inverted = 0;                    // the surface of the inverse, if there is one

public:
  //! \throws Invalid_input when both surfaces are implicit and their boxes have no more than a face in common.
  Surface_equations(Surface_shape first, Surface_shape second,
                    Unknowns_of_surfaces unknowns = Unknowns_of_surfaces::FEWEST)
    : m_surfaces{std::move(first), std::move(second)}
  {
    if (are_surfaces_apart())
      return;
    const std::optional<Height_difference> heights =
        unknowns == Unknowns_of_surfaces::FEWEST ? height_difference() : std::nullopt;
    if (heights) {
      m_parameters = heights->parameters;
      m_domain = heights->domain;
    } else
      number_unknowns();
    if (std::all_of(m_domain.begin(), m_domain.end(),
                    [](const Parameter_range& range) { return range.first <= range.second; }))
      make_system(heights);
  }

  // The equations of a surface with itself, on a part of its domain: the parameters of both points come first. Where
  // pairs have no order, there is the direction in which they lie, too, whose two ends are the same. None: it does not
  // meet itself.
  Surface_equations(const Surface_shape& surface, std::optional<Constraint_system_d> pairs)
    : m_surfaces{surface, surface}, m_is_self_intersection(true), m_system(std::move(pairs))
  {
    number_unknowns();
  }

  // Other equations of the common points of two parametric surfaces, in the same unknowns.
  Surface_equations(const Surface_equations& surfaces, Constraint_system_d system) : Surface_equations(surfaces)
  {
    m_system = std::move(system);
  }

  // Other equations of two parametric surfaces, in the parameters of the one that is not given, and no others. No
  // system: no common points.
  Surface_equations(const Surface_equations& surfaces, std::size_t inverted, std::optional<Constraint_system_d> system);

  const Surface_shape& surface(std::size_t index) const { return m_surfaces[index]; }

  // Whether the unknowns are the parameters of two parametric surfaces, each of which has its own.
  bool has_all_parameters() const
  {
    return is_parametric(0) && is_parametric(1) && m_domain.size() == 4 && !m_is_self_intersection;
  }

  // Whether both are height fields over the same coordinates, whose parameters depend on the same unknowns: they have
  // neither poles nor seams.
  bool are_height_fields() const
  {
    return has_unknowns(0) && has_unknowns(1) && m_domain.size() == 2 && !m_is_self_intersection;
  }

  // Whether coordinates in space are unknowns, too.
  bool has_coordinates() const { return m_has_coordinates; }

  // Whether some boxes around the surfaces do not meet. There is no system then.
  bool has_system() const { return m_system.has_value(); }
  const Constraint_system_d& system() const { return *m_system; }

  bool is_parametric(std::size_t surface) const { return m_surfaces[surface].patch.has_value(); }

  // Whether the parameters of a surface depend on the unknowns alone.
  bool has_unknowns(std::size_t surface) const { return is_parametric(surface) && !is_inverted(surface); }

  // Whether edges of a surface are where inequalities are zero.
  bool has_edges_on_inequalities() const { return m_inverse != nullptr; }

  // Where the parameters of a surface are, with the unknowns in a box. \pre It is parametric.
  std::array<Parameter_range, 2> parameter_ranges(std::size_t surface, const Parameter_box& box) const;

  // In doubles. \pre It is parametric.
  std::array<double, 2> parameters(std::size_t surface, const std::vector<double>& unknowns) const;

  // How a parameter of a surface depends on the unknowns. \pre It has unknowns.
  const Affine_function& parameter(std::size_t surface, int axis) const { return m_parameters[surface][axis]; }
  Parameter_range parameter_domain(std::size_t surface, int axis) const
  {
    return m_surfaces[surface].patch->domain(axis);
  }

  bool is_closed(std::size_t surface, int axis) const
  {
    return is_parametric(surface) && m_surfaces[surface].patch->is_closed(axis);
  }

  // The unknowns whose two ends are a seam.
  std::vector<std::size_t> closed_unknowns() const;

  // Edges that are one point in space.
  std::vector<Surface_pole> poles() const;

  // For each unknown the one that takes its place in the other order of an unordered pair; none where pairs are
  // ordered.
  std::vector<std::size_t> exchange() const
  {
    const std::vector<std::size_t> directions = directions_of_pairs();
    return directions.empty() ? directions : std::vector<std::size_t>{2, 3, 0, 1, directions.front()};
  }

  // The point in space where the unknowns have these values, exactly or in doubles.
  template <class NT>
  std::array<NT, 3> point(const std::vector<NT>& unknowns) const
  {
    if (m_has_coordinates)
      return {unknowns[unknowns.size() - 3], unknowns[unknowns.size() - 2], unknowns[unknowns.size() - 1]};
    const std::size_t surface = has_unknowns(0) ? 0 : 1;
    const std::vector<NT> parameters{m_parameters[surface][0](unknowns), m_parameters[surface][1](unknowns)};
    return m_surfaces[surface].point(parameters);
  }

  // Bounds of the points in space with the unknowns in a box.
  Vector_bounds<3> values(const Parameter_box& box) const;

private:
  bool is_inverted(std::size_t surface) const { return m_inverse && m_inverted == surface; }

  std::vector<std::size_t> directions_of_pairs() const;

  bool are_surfaces_apart() const
  {
    const auto first = m_surfaces[0].bounds(), second = m_surfaces[1].bounds();
    return first && second && are_apart(*first, *second);
  }

  std::optional<Height_difference> height_difference() const;

  // The parameters of the parametric surfaces, then the coordinates, if need be.
  void number_unknowns();

  void add_coordinates();

  void make_system(const std::optional<Height_difference>& heights);

  Vector_expression<3> point_of(std::size_t surface, std::span<const Unknown> u) const
  {
    return Parametric_vector<3>(*m_surfaces[surface].patch)(u.subspan(m_parameters[surface][0].unknown, 2));
  }

  Equations in_parameters(std::span<const Unknown> u) const;

  Equations in_coordinates(std::span<const Unknown> u) const;

  static Equations zero(const Vector_expression<3>& x) { return {x[0] == 0, x[1] == 0, x[2] == 0}; }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Surface_equations::Surface_equations(const Surface_equations& surfaces,
                                                                    std::size_t inverted,
                                                                    std::optional<Constraint_system_d> system)
  : m_surfaces(surfaces.m_surfaces), m_system(std::move(system)),
    m_inverse(std::make_shared<Patch_inverse>(surfaces.surface(inverted))), m_inverted(inverted)
{
  for (int axis = 0; axis < 2; ++axis) {
    m_parameters[1 - inverted][axis] = {m_domain.size(), Exact_rational(1), Exact_rational(0)};
    m_domain.push_back(parameter_domain(1 - inverted, axis));
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Parameter_range, 2>
Surface_equations::parameter_ranges(std::size_t surface, const Parameter_box& box) const
{
  if (is_inverted(surface))
    return m_inverse->ranges(m_surfaces[1 - surface].patch->part(box).values());
  const auto range = [&](int axis) { return parameter(surface, axis).of(box[parameter(surface, axis).unknown]); };
  return {range(0), range(1)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<double, 2>
Surface_equations::parameters(std::size_t surface, const std::vector<double>& unknowns) const
{
  return is_inverted(surface) ? (*m_inverse)(point(unknowns))
                              : std::array<double, 2>{parameter(surface, 0)(unknowns), parameter(surface, 1)(unknowns)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> Surface_equations::closed_unknowns() const
{
  std::vector<std::size_t> result;
  if (m_is_self_intersection)
    return directions_of_pairs();
  if (are_height_fields())
    return result;
  for (std::size_t surface = 0; surface < 2; ++surface)
    for (int axis = 0; axis < 2; ++axis)
      if (has_unknowns(surface) && is_closed(surface, axis))
        result.push_back(m_parameters[surface][axis].unknown);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Surface_pole> Surface_equations::poles() const
{
  std::vector<Surface_pole> result;
  if (are_height_fields())
    return result;
  for (std::size_t k = 0; k < 2; ++k)
    for (int axis = 0; axis < 2 && has_unknowns(k); ++axis)
      for (const int side : {0, 1}) {
        const Parameter_range range = parameter_domain(k, axis);
        const Exact_rational& value = side == 0 ? range.first : range.second;
        if (m_surfaces[k].patch->pole(axis, value))
          result.push_back({k, axis, side, m_parameters[k][axis].unknown, value});
      }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Vector_bounds<3> Surface_equations::values(const Parameter_box& box) const
{
  if (m_has_coordinates) {
    Vector_bounds<3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = Rational_interval(box[box.size() - 3 + i]);
    return result;
  }
  const std::size_t surface = has_unknowns(0) ? 0 : 1;
  std::array<Parameter_range, 2> ranges = parameter_ranges(surface, box);
  for (const int axis : {0, 1}) { // those of an inverse may lead out of the domain
    const auto [begin, end] = parameter_domain(surface, axis);
    auto& [lower, upper] = ranges[static_cast<std::size_t>(axis)];
    lower = (std::min)((std::max)(lower, begin), end);
    upper = (std::min)((std::max)(upper, begin), end);
  }
  return m_surfaces[surface].patch->part({ranges[0], ranges[1]}).values();
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> Surface_equations::directions_of_pairs() const
{
  constexpr int direction = 4;
  return m_is_self_intersection && m_system && m_system->dimension() > direction ? std::vector<std::size_t>{direction}
                                                                                 : std::vector<std::size_t>{};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Height_difference> Surface_equations::height_difference() const
{
  return is_parametric(0) && is_parametric(1)
      ? internal::Intersections::height_difference(*m_surfaces[0].patch, *m_surfaces[1].patch)
      : std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_equations::number_unknowns()
{
  m_has_coordinates = !is_parametric(0) && !is_parametric(1);
  for (std::size_t k = 0; k < 2; ++k) {
    if (is_parametric(k))
      for (int axis = 0; axis < 2; ++axis) {
        m_parameters[k][axis] = {m_domain.size(), Exact_rational(1), Exact_rational(0)};
        m_domain.push_back(parameter_domain(k, axis));
      }
    else if (is_parametric(1 - k) && m_surfaces[k].ends_within(*m_surfaces[1 - k].bounds()))
      m_has_coordinates = true;
  }
  if (m_has_coordinates)
    add_coordinates();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_equations::add_coordinates()
{
  for (int i = 0; i < 3; ++i) {
    std::optional<Parameter_range> range;
    for (const Surface_shape& surface : m_surfaces)
      if (const auto bounds = surface.bounds()) {
        const auto [lower, upper] = std::pair((*bounds)[i].lower, (*bounds)[i].upper);
        range = range ? Parameter_range((std::max)(range->first, lower), (std::min)(range->second, upper))
                      : Parameter_range(lower, upper);
      }
    m_domain.push_back(*range);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Surface_equations::make_system(const std::optional<Height_difference>& heights)
{
  std::vector<std::array<Bound, 2>> ranges;
  for (const auto& [lower, upper] : m_domain)
    ranges.push_back({Bound(lower), Bound(upper)});
  const std::vector<Unknown> u = unknowns(ranges);
  m_system.emplace(m_domain);
  for (const Constraint& equation : heights ? heights->equations(u)
           : m_has_coordinates              ? in_coordinates(u)
                                            : in_parameters(u))
    m_system->add(equation);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Surface_equations::Equations
Surface_equations::in_parameters(std::span<const Unknown> u) const
{
  if (is_parametric(0) && is_parametric(1))
    return zero(point_of(0, u) - point_of(1, u));
  const std::size_t surface = is_parametric(0) ? 0 : 1;
  return {substituted(m_surfaces[1 - surface].polynomial, point_of(surface, u)) == 0};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Surface_equations::Equations
Surface_equations::in_coordinates(std::span<const Unknown> u) const
{
  const Vector_expression<3> x = vector_of<3>([&](std::size_t i) { return u[u.size() - 3 + i]; });
  Equations result;
  for (std::size_t k = 0; k < 2; ++k)
    if (is_parametric(k)) {
      const Equations incidence = zero(point_of(k, u) - x);
      result.insert(result.end(), incidence.begin(), incidence.end());
    } else
      result.push_back(substituted(m_surfaces[k].polynomial, x) == 0);
  return result;
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_EQUATIONS_H
