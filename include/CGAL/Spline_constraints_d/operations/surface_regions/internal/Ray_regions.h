// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_REGIONS_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Monotone_parts.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Own_shadow.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Surface_shadows.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Thick_rays.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/access_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/surface_cells.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
The rays from the points S = X/w of a surface, with the directions O, and what is in their way. With e = w c - X for the
center c of a ball, the ray of a point or its line touches it where |e x O|^2 = r^2 w^2 |O|^2, and the point is on the
ball where |e|^2 = r^2 w^2. Between these curves, a ray is free as a whole or not at all. The radius of the tool is
added to r; if r is the root of a number R that is no square, f = sqrt(R) g is replaced by f^2 = R g^2.
*/
class Ray_regions
{
  const Spline_patch<3> m_surface;
  std::vector<Exact_sphere> m_spheres;
  std::optional<Thick_rays> m_triangles;
  std::vector<Spline_patch<3>> m_surfaces;
  Sight m_sight;
  Operation_budget m_budget;
  std::vector<Surface_cell_3> m_cells;
  std::vector<Cell_vector> m_directions; // of the rays in each cell
  std::optional<Own_shadow> m_shadow;

public:
  Ray_regions(const Exact_map<3>& surface, const Exact_obstacles& obstacles, const Sight& sight,
              const Solver_options& options)
    : m_surface(surface), m_spheres(obstacles.spheres), m_sight(sight), m_budget(options), m_cells(cells_of(m_surface)),
      m_directions(m_cells.size())
  {
    const auto& axis = m_sight.axis;
    for (const Exact_map<3>& map : obstacles.surfaces)
      m_surfaces.emplace_back(map);
    if (!obstacles.triangles.empty())
      m_triangles.emplace(obstacles.triangles, axis.radius, axis.direction);
    if (!axis.field)
      return;
    const Exact_map<3>& field = *axis.field;
    if (axis.direction || field.weight.domain(0) != m_surface.domain(0) ||
        field.weight.domain(1) != m_surface.domain(1))
      throw Invalid_input("accessible_regions: a field of directions has another domain than the surface, or there is "
                          "a direction beside it");
    cut_at_breaks_of(Spline_patch<3>(field));
  }

  Trimmed_surface_3 regions()
  {
    try {
      if (m_sight.is_own_shadow_seen)
        m_shadow.emplace(m_surface, m_budget);
    } catch (const Run_stopped& stop) {
      return undecided(in_words(stop.reason));
    }
    if ((m_shadow && !m_shadow->is_supported()) || !m_surfaces.empty())
      return regions_past_surfaces();
    Trimming trimming{m_cells, {m_surface.is_closed(0), m_surface.is_closed(1)}, {}, {}};
    trimming.zeros = [this](std::size_t cell) { return zeros(cell); };
    trimming.label = [this](std::size_t cell, const Parameters& p) {
      const std::optional<Access> result = access(cell, p);
      return result ? std::optional(static_cast<int>(*result)) : std::nullopt;
    };
    return trimmed_by_zeros(trimming, m_budget);
  }

private:
  // Past surfaces, of which no polynomials in the two parameters are known whose zeros bound the regions.
  Trimmed_surface_3 regions_past_surfaces()
  {
    const Exact_tool_axis& axis = m_sight.axis;
    std::vector<Spline_patch<3>> checks = m_surfaces;
    bool is_supported = axis.radius == 0 && !axis.hemisphere && !m_triangles;
    for (const Exact_sphere& sphere : m_spheres) {
      const auto radius = rational_square_root(sphere.squared_radius);
      is_supported = is_supported && radius && !has_eye_in(sphere);
      if (is_supported)
        checks.push_back(ball_as_surface(sphere.center, *radius));
    }
    if (!is_supported)
      return undecided("beside surfaces in the way, which a surface that is on no plane or quadric may be itself, only "
                       "balls with rational radii and without the eye are supported");
    const Upward_rounding_guard guard;
    Surface_shadows shadows(m_sight.eye);
    try {
      for (const Spline_patch<3>& check : checks)
        shadows.add_surface(check, false);
      if (m_sight.is_own_shadow_seen)
        shadows.add_surface(m_surface, true);
      for (const Surface_cell_3& cell : m_cells) {
        m_budget.check();
        shadows.add_source(cell, direction_in(cell));
      }
    } catch (const Run_stopped& stop) {
      return undecided(in_words(stop.reason));
    }
    Trimming trimming{m_cells, {m_surface.is_closed(0), m_surface.is_closed(1)}, {}, {}};
    trimming.parts = [&](std::size_t cell) {
      const Monotone_parts::Oracle oracle = [&](const Parameter_rectangle& box, bool is_kept) {
        return shadows(cell, box, is_kept);
      };
      const Monotone_cell::Side_oracle side_oracle = [&](const Parameter_rectangle& segment) {
        return shadows.side_of_silhouette(cell, segment);
      };
      return Monotone_parts(oracle, side_oracle, {static_cast<int>(Access::FREE), static_cast<int>(Access::OBSTRUCTED)},
                            "more than one boundary of a region, or an end of one, may be there", m_budget)
          .parts(0x1p-10);
    };
    return trimmed_by_zeros(trimming, m_budget);
  }

  bool has_eye_in(const Exact_sphere& sphere) const
  {
    if (!m_sight.eye)
      return false;
    const Exact_triple from_center = difference(*m_sight.eye, sphere.center);
    return dot(from_center, from_center) <= sphere.squared_radius;
  }

  // With poles where no symmetrical scene has silhouettes: of a ray that starts outside of a ball or ends there, the
  // ball has a point if and only if its boundary has.
  static Spline_patch<3> ball_as_surface(const Exact_triple& center, const Exact_rational& radius)
  {
    const Exact_rational part(radius / 15);
    return Spline_patch<3>(sphere_surface<Exact_kernel>(
        {center[0], center[1], center[2]},
        Exact_kernel::Point_3(center[0] + 2 * part, center[1] + 10 * part, center[2] + 11 * part)));
  }

  Trimmed_surface_3 undecided(const std::string& reason) const
  {
    std::vector<Undecided_part> parts;
    for (const Surface_cell_3& cell : m_cells)
      parts.push_back({{}, {{0, {to_double_range(cell.domain[0]), to_double_range(cell.domain[1])}}}, reason});
    Summary work = m_budget.total();
    work.seconds = m_budget.seconds();
    work.why_not = m_budget.reason() == Undecided_reason::NONE ? Undecided_reason::CONTINUUM : m_budget.reason();
    return {m_cells, {}, {}, {}, std::move(parts), work};
  }

  // Such that the field is one polynomial in each cell, too.
  void cut_at_breaks_of(const Spline_patch<3>& field)
  {
    std::vector<Surface_cell_3> cells;
    for (const Surface_cell_3& cell : m_cells)
      for (const Surface_cell_3& other : cells_of(field)) {
        std::array<Surface_cell_3::Range, 2> box;
        std::vector<Surface_cell_3::Range> local;
        for (const std::size_t axis : {0, 1}) {
          box[axis] = {(std::max)(cell.domain[axis].first, other.domain[axis].first),
                       (std::min)(cell.domain[axis].second, other.domain[axis].second)};
          local.emplace_back(cell.local_parameter(static_cast<int>(axis), box[axis].first),
                             cell.local_parameter(static_cast<int>(axis), box[axis].second));
        }
        if (!(box[0].first < box[0].second) || !(box[1].first < box[1].second))
          continue;
        cells.push_back({box, cell.coordinates});
        for (Cell_polynomial& f : cells.back().coordinates)
          f = f.restricted_to_box(local);
      }
    m_cells = std::move(cells);
    m_directions.resize(m_cells.size());
  }

  // A positive multiple of the direction of the ray, in lowest terms.
  Cell_vector direction_in(const Surface_cell_3& cell) const
  {
    const Exact_tool_axis& axis = m_sight.axis;
    if (axis.direction)
      return constant_vector(*axis.direction);
    if (m_sight.eye)
      return *m_sight.eye * cell.coordinates[3] - numerators_of(cell);
    if (!axis.field)
      return normal_of(cell);
    const Spline_patch<3> part = Spline_patch<3>(*axis.field).part({cell.domain[0], cell.domain[1]});
    const auto& [x, y, z] = part.numerators();
    return without_positive_factors({x.bezier_pieces().front(), y.bezier_pieces().front(), z.bezier_pieces().front()});
  }

  std::vector<Cell_polynomial> zeros(std::size_t index)
  {
    const Surface_cell_3& cell = m_cells[index];
    m_budget.check();
    const Cell_vector direction = m_directions[index] = direction_in(cell);
    const Cell_polynomial square = dot(direction, direction),
                          squared_weight = cell.coordinates[3] * cell.coordinates[3];
    if (is_zero(square))
      return {square}; // there is no direction: the surface is a curve or a point
    std::vector<Cell_polynomial> result;
    for (const Exact_sphere& sphere : m_spheres) {
      m_budget.check();
      const Cell_vector to_center = sphere.center * cell.coordinates[3] - numerators_of(cell);
      const Cell_vector moment = cross(to_center, direction);
      result.push_back(touching(sphere, dot(moment, moment), square * squared_weight));
      result.push_back(touching(sphere, dot(to_center, to_center), squared_weight));
    }
    if (m_triangles) {
      m_budget.check();
      for (Cell_polynomial& f : m_triangles->zeros(cell, direction))
        result.push_back(std::move(f));
    }
    if (m_sight.axis.hemisphere && !m_sight.axis.direction)
      result.push_back(dot(direction, constant_vector(*m_sight.axis.hemisphere)));
    if (m_shadow)
      for (Cell_polynomial& f : m_shadow->zeros(cell, direction))
        result.push_back(std::move(f));
    // One that is zero on the whole cell parts nothing: rays that touch a ball are in its way.
    std::erase_if(result, is_zero);
    for (Cell_polynomial& f : result) {
      m_budget.check();
      f = without_factors_of(cell.coordinates[3], f);
    }
    return result;
  }

  // What vanishes where a squared length is that of the radii of a ball and the tool together, times a square.
  Cell_polynomial touching(const Exact_sphere& sphere, const Cell_polynomial& length, const Cell_polynomial& unit) const
  {
    const Exact_rational& radius = m_sight.axis.radius;
    const Cell_polynomial rest = length - unit * Exact_rational(sphere.squared_radius + radius * radius);
    if (radius == 0)
      return rest;
    if (const auto root = rational_square_root(sphere.squared_radius))
      return rest - unit * Exact_rational(2 * radius * *root);
    return rest * rest - unit * unit * Exact_rational(4 * radius * radius * sphere.squared_radius);
  }

  // Whether a squared length, as a multiple of a square, is less than or equal to that of both radii together.
  bool is_within(const Exact_sphere& sphere, const Exact_rational& length, const Exact_rational& unit) const
  {
    const Exact_rational& radius = m_sight.axis.radius;
    const Exact_rational rest(length - unit * (sphere.squared_radius + radius * radius));
    return rest <= 0 || rest * rest <= 4 * radius * radius * sphere.squared_radius * unit * unit;
  }

  std::optional<Access> access(std::size_t index, const Parameters& parameters)
  {
    const Surface_cell_3& cell = m_cells[index];
    const Parameters local{cell.local_parameter(0, parameters[0]), cell.local_parameter(1, parameters[1])};
    const Exact_triple direction = value_of(m_directions[index], local);
    if (m_sight.axis.hemisphere && !(dot(direction, *m_sight.axis.hemisphere) > 0))
      return Access::NOT_ADMITTED;
    const Exact_rational weight = cell.coordinates[3](local);
    Exact_triple point = value_of(numerators_of(cell), local);
    for (Exact_rational& x : point)
      x /= weight;
    for (const Exact_sphere& sphere : m_spheres)
      if (is_in_the_way(sphere, point, direction))
        return Access::OBSTRUCTED;
    if (m_triangles && m_triangles->is_hit(point, direction))
      return Access::OBSTRUCTED;
    if (!m_shadow)
      return Access::FREE;
    const std::optional<bool> is_hit = m_shadow->is_hit(point, direction, m_sight.eye, m_budget);
    return is_hit ? std::optional(*is_hit ? Access::OBSTRUCTED : Access::FREE) : std::nullopt;
  }

  // Whether a ray, or its part before the eye, has a point in a ball: the squared distance of p + t d from the center
  // is t^2 |d|^2 - 2 t <c-p,d> + |c-p|^2.
  bool is_in_the_way(const Exact_sphere& sphere, const Exact_triple& p, const Exact_triple& d) const
  {
    const auto& c = sphere.center;
    const Exact_triple to_center{Exact_rational(c[0] - p[0]), Exact_rational(c[1] - p[1]), Exact_rational(c[2] - p[2])};
    const Exact_rational square = dot(d, d), ahead = dot(to_center, d), distance = dot(to_center, to_center);
    if (is_within(sphere, distance, Exact_rational(1)))
      return true;
    if (!(ahead > 0) || !is_within(sphere, Exact_rational(distance * square - ahead * ahead), square))
      return false;
    if (!m_sight.eye)
      return true;
    const auto& e = *m_sight.eye;
    const Exact_triple to_eye{Exact_rational(e[0] - p[0]), Exact_rational(e[1] - p[1]), Exact_rational(e[2] - p[2])};
    // The foot of the center is before the eye, or the eye is in the ball.
    const Exact_triple beyond{Exact_rational(c[0] - e[0]), Exact_rational(c[1] - e[1]), Exact_rational(c[2] - e[2])};
    return dot(to_center, to_eye) < dot(to_eye, to_eye) || dot(beyond, beyond) <= sphere.squared_radius;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_surface_3 ray_regions(const Exact_map<3>& surface,
                                                             const Exact_obstacles& obstacles, const Sight& sight,
                                                             const Solver_options& options)
{
  return Ray_regions(surface, obstacles, sight, options).regions();
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_RAY_REGIONS_H
