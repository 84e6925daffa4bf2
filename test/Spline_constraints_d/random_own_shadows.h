// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random surfaces that hide parts of themselves, and their labels beside rays, which are intersected with proofs and
// not by cells.

#ifndef SPLINE_CONSTRAINTS_TEST_RANDOM_OWN_SHADOWS_H
#define SPLINE_CONSTRAINTS_TEST_RANDOM_OWN_SHADOWS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Access.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/visible_regions.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace random_own_shadows {

namespace SC = CGAL::Spline_constraints;
using Kernel = CGAL::Simple_cartesian<SC::Exact_rational>;
using Surface = SC::Bspline_surface_3<Kernel>;

// A surface with an eye, at infinity if there is a direction.
struct Scene
{
  Surface surface;
  std::optional<Kernel::Vector_3> direction;
  Kernel::Point_3 eye;

  Kernel::Vector_3 direction_from(const Kernel::Point_3& p) const { return direction ? *direction : eye - p; }

  SC::Trimmed_surface_3 visible_regions() const
  {
    return direction ? SC::visible_regions(surface, *direction) : SC::visible_regions(surface, eye);
  }
};

// Heights over a square grid: biquadratic ones in 4 or 9 pieces, bicubic ones in 1 or 4; eyes are at infinity, or near.
inline Scene scene(unsigned number)
{
  std::mt19937 random(1000 + number);
  const auto integer = [&](int lower, int upper) { return std::uniform_int_distribution(lower, upper)(random); };
  const int degree = number % 2 == 0 ? 2 : 3, points = number % 4 < 2 ? 4 : 5;
  std::vector<SC::Exact_rational> knots;
  for (int i = 0; i <= points + degree; ++i)
    knots.emplace_back(std::clamp(i - degree, 0, points - degree));
  std::vector<Kernel::Point_3> net;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j)
      net.emplace_back(i, j, SC::Exact_rational(integer(-8, 8)) / 4);
  Scene result{Surface({degree, degree}, knots, knots, net), {}, {}};
  const auto odd = [&] { return 2 * integer(-100, 100) + 1; };
  const int x = odd(), y = odd();
  if (number % 8 < 4)
    result.direction = Kernel::Vector_3(x, y, 25 * integer(1, 8));
  else
    result.eye = {SC::Exact_rational(x) / 50, SC::Exact_rational(y) / 50,
                  SC::Exact_rational(7 * integer(3, 8) + 1) / 7};
  return result;
}

// The label of the face with a point, by the chords of its loops; none near a chord.
inline std::optional<int> label_at(const SC::Trimmed_surface_3& surface, double u, double v,
                                   double least_distance = 4e-3)
{
  for (const auto& face : surface.faces()) {
    bool is_inside = false;
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &p = loop[i].source, &q = loop[(i + 1) % loop.size()].source;
        const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()), dx = CGAL::to_double(q.x()) - x,
                     dy = CGAL::to_double(q.y()) - y;
        const double t = std::clamp(((u - x) * dx + (v - y) * dy) / (dx * dx + dy * dy), 0., 1.);
        if (std::hypot(u - x - t * dx, v - y - t * dy) < least_distance)
          return std::nullopt;
        if ((y > v) != (y + dy > v) && u < x + (v - y) / dy * dx)
          is_inside = !is_inside;
      }
    if (is_inside)
      return face.label;
  }
  return std::nullopt;
}

struct Counts
{
  int free = 0, obstructed = 0, wrong = 0, undecided = 0; // rays; the first two are right
};

// Labels at random points beside those of rays. Direction is a function of a point.
template <class Direction>
Counts compare_with_rays(const SC::Trimmed_surface_3& regions, const Surface& surface,
                         const std::vector<Surface>& obstacles, const Direction& direction,
                         const std::optional<Kernel::Point_3>& eye, int rays, double least_distance = 1e-3)
{
  std::mt19937 random(5);
  Counts result;
  for (int i = 0; i < rays; ++i) {
    std::array<SC::Exact_rational, 2> p;
    for (const int axis : {0, 1}) {
      const auto [begin, end] = surface.domain(axis);
      p[static_cast<std::size_t>(axis)] = begin + (end - begin) * std::uniform_int_distribution(1, 1023)(random) / 1024;
    }
    const auto label = label_at(regions, CGAL::to_double(p[0]), CGAL::to_double(p[1]), least_distance);
    if (!label)
      continue;
    const Kernel::Point_3 source = surface(p[0], p[1]);
    bool is_hit = false, is_decided = true;
    for (const Surface& obstacle : obstacles)
      for (const auto& answer : SC::intersections(Kernel::Ray_3(source, direction(p)), obstacle)) {
        is_decided = is_decided && answer.kind() != SC::Intersection_kind::UNDECIDED;
        const double distance = CGAL::to_double(CGAL::squared_distance(answer.point(), source));
        is_hit =
            is_hit || (distance > 1e-12 && !(eye && distance > CGAL::to_double(CGAL::squared_distance(*eye, source))));
      }
    if (!is_decided)
      ++result.undecided;
    else if (*label != static_cast<int>(is_hit ? SC::Access::OBSTRUCTED : SC::Access::FREE))
      ++result.wrong;
    else
      ++(is_hit ? result.obstructed : result.free);
  }
  return result;
}

// The same for a scene.
inline Counts compare_with_rays(const SC::Trimmed_surface_3& regions, const Scene& scene, int rays)
{
  return compare_with_rays(
      regions, scene.surface, {scene.surface},
      [&](const auto& p) { return scene.direction_from(scene.surface(p[0], p[1])); },
      scene.direction ? std::nullopt : std::optional(scene.eye), rays);
}

} // namespace random_own_shadows

#endif // SPLINE_CONSTRAINTS_TEST_RANDOM_OWN_SHADOWS_H
