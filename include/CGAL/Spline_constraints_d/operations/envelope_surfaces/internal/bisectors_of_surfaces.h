// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_BISECTORS_OF_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_BISECTORS_OF_SURFACES_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Envelope_collector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Part_with_normals.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Overlapping_patches.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// On which side of the first surface spheres are: 1, -1, or 0 for both; and whether they are on that side of the second
// surface, too: 1, or on the other one: -1.
struct Sides_of_spheres
{
  int first, product;
};

inline std::vector<Sides_of_spheres> sides_of_spheres(const Touched_sides& sides)
{
  const auto sign = [](Touched_side side) {
    return side == Touched_side::POSITIVE ? 1 : side == Touched_side::NEGATIVE ? -1 : 0;
  };
  const int first = sign(sides.first), second = sign(sides.second);
  if (first != 0 && second != 0)
    return {{first, first * second}};
  if (second != 0)
    return {{second, 1}, {-second, -1}};
  return {{first, 1}, {first, -1}};
}

/*
The points on normals m and n of smooth parts S(u, v) and R(s, t) of two surfaces, at distances from the points there
whose ratio is 1 : c. With d = S - R, a sign, and q > 0,

  B = S + x m = R + c q x (sign n),   that is   d + x (m - c q sign n) = 0,   |m|^2 = q^2 |n|^2.

If n is a unit vector and m is not, q is the factor of m instead:

  B = S + q x m = R + c x (sign n),   q^2 |m|^2 = 1,

and if both are, there is no q. The distance from S is |x|, or |x m| where no normals are unit vectors. For c = 1 it is
at most a radius; for others it is bounded, as |d| >= |x| |m - c q sign n| >= |x m| |1 - c|.
*/
class Sector_of_parts
{
  const Part_with_normals &m_first, &m_second;
  const Exact_rational& m_ratio;
  const std::optional<Exact_rational>& m_radius;
  Sides_of_spheres m_sides;
  std::vector<Unknown> m_unknowns;

public:
  //! \pre All arguments live longer.
  Sector_of_parts(const Part_with_normals& first, const Part_with_normals& second, const Exact_rational& ratio,
                  const std::optional<Exact_rational>& radius, const Sides_of_spheres& sides)
    : m_first(first), m_second(second), m_ratio(ratio), m_radius(radius), m_sides(sides),
      m_unknowns(unknowns_in(domain()))
  {}

  Curve_vertex::Exact_box domain() const
  {
    const Spline_patch<3>&a = m_first.surface().patch, &b = m_second.surface().patch;
    Curve_vertex::Exact_box result{a.domain(0), a.domain(1), b.domain(0), b.domain(1), steps()};
    if (has_quotient())
      result.push_back(quotients());
    return result;
  }

  Constraint_system_d system(const Operation_budget& budget) const
  {
    const auto check = [&] { budget.check(); };
    const Vector_expression<3> d = m_first.point(first()) - m_second.point(second()), m = m_first.normal(first()),
                               n = m_second.normal(second());
    const Expression x = m_unknowns[4], y = x * (m_sides.product * m_ratio);
    Constraint_system_d result(domain());
    for (std::size_t i = 0; i < 3; ++i)
      result.add(d[i] + x * (m[i] * factor_of_first()) - y * (n[i] * factor_of_second()) == 0, check);
    if (has_quotient())
      result.add(square_of(m, m_first, factor_of_first()) - square_of(n, m_second, factor_of_second()) == 0, check);
    if (m_radius && !is_distance_unknown())
      add_not_negative(*m_radius * *m_radius - square(x) * squared_norm(m), result, check);
    return result;
  }

  Vector_expression<3> image() const
  {
    return m_first.point(first()) + m_first.normal(first()) * (m_unknowns[4] * factor_of_first());
  }

  std::vector<Vector_expression<3>> feet() const { return {m_first.point(first()), m_second.point(second())}; }

private:
  std::span<const Unknown> first() const { return std::span(m_unknowns).first(2); }
  std::span<const Unknown> second() const { return std::span(m_unknowns).subspan(2, 2); }

  bool has_quotient() const { return !m_first.has_unit_normals() || !m_second.has_unit_normals(); }
  bool is_quotient_of_first() const { return !m_first.has_unit_normals() && m_second.has_unit_normals(); }
  bool is_distance_unknown() const { return m_first.has_unit_normals() || m_second.has_unit_normals(); }

  Expression factor_of_first() const { return is_quotient_of_first() ? Expression(m_unknowns[5]) : Expression(1); }
  Expression factor_of_second() const
  {
    return has_quotient() && !is_quotient_of_first() ? Expression(m_unknowns[5]) : Expression(1);
  }

  static Expression square_of(const Vector_expression<3>& normal, const Part_with_normals& part,
                              const Expression& factor)
  {
    return part.has_unit_normals() ? Expression(1) : square(factor) * squared_norm(normal);
  }

  // Of x. Surfaces reach the ends only where this is the distance and the greatest one is given.
  Parameter_range steps() const
  {
    Exact_rational most = m_radius ? *m_radius : farthest() / abs(Exact_rational(1 - m_ratio));
    if (!is_distance_unknown())
      most /= m_first.lengths().first;
    return {m_sides.first > 0 ? Exact_rational(0) : Exact_rational(-most),
            m_sides.first < 0 ? Exact_rational(0) : most};
  }

  // Of q.
  Parameter_range quotients() const
  {
    const Parameter_range unit{Exact_rational(1), Exact_rational(1)};
    const Parameter_range above = is_quotient_of_first() || m_first.has_unit_normals() ? unit : m_first.lengths(),
                          below = is_quotient_of_first() ? m_first.lengths() : m_second.lengths();
    return {above.first / below.second, above.second / below.first};
  }

  // A number greater than all distances of points of both.
  Exact_rational farthest() const
  {
    const Rational_interval square = squared_norm(m_first.surface().patch.values() - m_second.surface().patch.values());
    return square.upper > 0 ? root_bounds(square.upper).second : Exact_rational(1);
  }
};

// The parts of a surface with normals. One with none somewhere is undecided, with all of the other surface.
inline std::vector<Part_with_normals> parts_with_normals(const Spline_patch<3>& surface, const Spline_patch<3>& other,
                                                         bool is_first, const std::string& operation,
                                                         Envelope_collector& result)
{
  std::vector<Part_with_normals> parts;
  for (Smooth_surface& part : smooth_surfaces(surface, [&] { result.budget().check(); })) {
    if (part.is_degenerate())
      throw Invalid_input(operation + ": a piece of a surface is a curve or a point");
    const Curve_vertex::Exact_box own{part.patch.domain(0), part.patch.domain(1)};
    if (std::optional<Part_with_normals> found = Part_with_normals::make(std::move(part)))
      parts.push_back(std::move(*found));
    else {
      const Curve_vertex::Exact_box all{other.domain(0), other.domain(1)};
      result.add_undecided(is_first ? Curve_vertex::Exact_box{own[0], own[1], all[0], all[1]}
                                    : Curve_vertex::Exact_box{all[0], all[1], own[0], own[1]},
                           "whether normals are zero");
    }
  }
  return parts;
}

// Where surfaces overlap, all spheres that touch one touch the other, and there is no surface of their centers.
inline void check_overlap(const Spline_patch<3>& first, const Spline_patch<3>& second, const std::string& operation,
                          const Operation_budget& budget)
{
  const Surface_equations surfaces{Surface_shape(first), Surface_shape(second), Unknowns_of_surfaces::ALL_PARAMETERS};
  std::array<std::optional<Power_polynomial>, 2> equations;
  const auto equation = [&](std::size_t k) {
    equations[k] = implicit_equation(*surfaces.surface(k).patch, [&] { return budget.must_stop(); });
    return equations[k] ? &*equations[k] : nullptr;
  };
  if (surfaces.has_system() && Overlapping_patches(surfaces)(equation))
    throw Invalid_input(operation + ": the surfaces overlap");
}

// The points whose distances from both surfaces, along normals, have the ratio 1 : c.
inline Envelope_surface_3 sector_of(const Exact_map<3>& first, const Exact_map<3>& second, const Exact_rational& ratio,
                                    const std::optional<Exact_rational>& radius, const Touched_sides& sides,
                                    const std::string& operation, const Solver_options& options)
{
  Envelope_collector result(options);
  const Spline_patch<3> a(first), b(second);
  try {
    check_overlap(a, b, operation, result.budget());
    const std::vector<Part_with_normals> own = parts_with_normals(a, b, true, operation, result),
                                         others = parts_with_normals(b, a, false, operation, result);
    for (const Part_with_normals& part : own)
      for (const Part_with_normals& other : others)
        for (const Sides_of_spheres& own_sides : sides_of_spheres(sides)) {
          result.budget().check();
          const Sector_of_parts sector(part, other, ratio, radius, own_sides);
          result.add(sector.system(result.budget()), {}, sector.image(),
                     closed_unknowns(part.surface(), other.surface()), poles(part.surface(), other.surface()), {}, {},
                     sector.feet(), own_sides.product);
        }
  } catch (const Run_stopped& stop) {
    result.add_undecided({a.domain(0), a.domain(1), b.domain(0), b.domain(1)}, in_words(stop.reason));
  }
  return std::move(result).result();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 surface_bisector_of(const Exact_map<3>& first,
                                                                      const Exact_map<3>& second,
                                                                      const Exact_rational& radius,
                                                                      const Touched_sides& sides,
                                                                      const Solver_options& options)
{
  if (!(radius > 0))
    throw Invalid_input("surface_bisector: the radius is not positive");
  return sector_of(first, second, Exact_rational(1), radius, sides, "surface_bisector", options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 alpha_sector_surface_of(const Exact_map<3>& first,
                                                                          const Exact_map<3>& second,
                                                                          const Exact_rational& alpha,
                                                                          const Touched_sides& sides,
                                                                          const Solver_options& options)
{
  if (!(alpha > 0 && alpha < 1))
    throw Invalid_input("alpha_sector_surface: alpha is not between 0 and 1");
  if (2 * alpha == 1)
    throw Invalid_input("alpha_sector_surface: alpha is 1/2, for which surface_bisector() has a greatest radius");
  return sector_of(first, second, Exact_rational((1 - alpha) / alpha), std::nullopt, sides, "alpha_sector_surface",
                   options);
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_BISECTORS_OF_SURFACES_H
