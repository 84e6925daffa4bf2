// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_POINTS_H

#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_image.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point of a mesh: its unknowns, where it lies in space, and the unknowns that planes fix, with a patch beside it.
struct Mesh_point
{
  std::vector<double> unknowns;
  Surface_image::Point image;
  std::size_t patch;
  std::vector<int> fixed = {};
};

// The points of a mesh, and what makes triangles fine enough.
class Mesh_points
{
  const Surface_solution_set_d& m_set;
  Surface_mesh_options m_options;
  Surface_points m_surface;
  Surface_image m_image;
  std::vector<Mesh_point> m_points;
  double m_extent = 0; // the greatest coordinate of an image
  std::vector<Surface_points::Double_ranges> m_around_arc, m_around_patch; // their boxes, where they were needed
  std::vector<std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>>> m_inside; // see add_inside()

public:
  Mesh_points(const Surface_solution_set_d& set, const Image_functions* image, const Surface_mesh_options& options)
    : m_set(set), m_options(options), m_surface(set), m_image(set, m_surface, image), m_around_arc(set.arcs().size()),
      m_around_patch(set.patches().size()), m_inside(set.patches().size())
  {}

  const Surface_solution_set_d& set() const { return m_set; }
  const Surface_mesh_options& options() const { return m_options; }

  // Triangles are as fine as these options ask for; or just so fine that neighbours turn by no more than an angle.
  void set_options(const Surface_mesh_options& options) { m_options = options; }
  void set_angle_only(double angle)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    m_options = {.chord_error = infinity, .angle = angle, .edge_length = infinity};
  }
  bool has_angle_only() const { return !std::isfinite(m_options.chord_error); }
  Surface_points& surface() { return m_surface; }
  Surface_image& image() { return m_image; }
  std::size_t size() const { return m_points.size(); }
  const Mesh_point& operator[](std::size_t i) const { return m_points[i]; }

  std::size_t add(std::size_t patch, std::vector<double> unknowns, std::vector<int> fixed = {})
  {
    const Surface_image::Point image = m_image(patch, unknowns);
    for (int k = 0; k < 3; ++k)
      m_extent = (std::max)(m_extent, std::abs(image[k]));
    m_points.push_back({std::move(unknowns), image, patch, std::move(fixed)});
    return m_points.size() - 1;
  }

  // Keeps a place free that no triangle needs.
  void add_unused() { m_points.push_back({{}, Surface_image::Point(0, 0, 0), 0, {}}); }

  // Adds the point of an arc whose parameter is in the middle between those of two others; none if they are too near.
  std::optional<std::size_t> add_between(std::size_t arc, std::size_t patch, std::size_t a, std::size_t b)
  {
    const Surface_arc& own = m_set.arcs()[arc];
    const auto parameter = static_cast<std::size_t>(own.parameter);
    std::vector<double> middle = middle_of(a, b);
    if (middle[parameter] == m_points[a].unknowns[parameter] || middle[parameter] == m_points[b].unknowns[parameter])
      return std::nullopt;
    std::optional<std::vector<double>> point = m_surface.solution(patch, own.box, around(m_around_arc[arc], own.box),
                                                                  {own.plane, own.parameter}, std::move(middle));
    return point ? std::optional(add(patch, *std::move(point), {own.plane})) : std::nullopt;
  }

  // Adds the point of a patch above the middle of two others, the first time; none if it is not there.
  std::optional<std::size_t> add_inside(std::size_t patch, std::size_t a, std::size_t b)
  {
    const auto [place, is_new] = m_inside[patch].try_emplace(std::minmax(a, b));
    if (is_new) {
      const Surface_patch& own = m_set.patches()[patch];
      std::optional<std::vector<double>> point =
          m_surface.solution(patch, own.box, around(m_around_patch[patch], own.box), own.parameters, middle_of(a, b));
      if (point)
        place->second = add(patch, *std::move(point));
    }
    return place->second;
  }

  // Whether the surface above the middle of a chord of an arc is near enough to the chord: on a steep patch it is far
  // away although the arc is near. It may be beyond the arc. Where the image of the arc is one point but for rounding,
  // lengths say nothing.
  bool is_near_chord(std::size_t patch, std::size_t a, std::size_t b)
  {
    std::vector<double> point = middle_of(a, b);
    if (!m_surface.move_to_surface(patch, m_set.patches()[patch].parameters, point))
      return false;
    const Surface_image::Point &p = m_points[a].image, &q = m_points[b].image;
    const double distance = distance_from_chord(p, m_image(patch, point), q);
    constexpr double share = 0.25;
    return distance <= m_options.chord_error &&
        (distance <= share * std::sqrt(CGAL::squared_distance(p, q)) || is_rounding(distance));
  }

  // Whether the chord between two points is near enough to a point of the surface between them, and short enough. Where
  // the surface turns in a point or a short curve, angles do not matter in the end; nor do they where the image of an
  // arc is one point, but for rounding.
  bool is_fine(std::size_t a, std::size_t middle, std::size_t b) const
  {
    return is_fine(m_points[a].image, m_points[middle].image, m_points[b].image);
  }
  bool is_fine(const Surface_image::Point& p, const Surface_image::Point& middle, const Surface_image::Point& q) const
  {
    constexpr double share = 1.0 / 16;
    const double length = std::sqrt(CGAL::squared_distance(p, q)), distance = distance_from_chord(p, middle, q);
    const bool is_flat =
        8 * distance <= m_options.angle * length; // a circle turns by 8 times its sagitta over the chord
    const bool is_tiny =
        !has_angle_only() && (distance <= share * m_options.chord_error || length <= m_options.chord_error);
    return distance <= m_options.chord_error && length <= m_options.edge_length &&
        (is_flat || is_tiny || is_rounding(distance));
  }

  static double distance_from_chord(const Surface_image::Point& p, const Surface_image::Point& middle,
                                    const Surface_image::Point& q)
  {
    const Surface_image::Vector chord = q - p, rest = middle - p;
    const double square = chord.squared_length(), place = square > 0 ? chord * rest / square : 0;
    return Surface_image::length(rest - (std::min)(1.0, (std::max)(0.0, place)) * chord);
  }

  // Whether two points lie on a plane that an unknown has the same value on.
  bool are_on_one_plane(std::size_t a, std::size_t b) const
  {
    const Mesh_point &p = m_points[a], &q = m_points[b];
    return std::any_of(p.fixed.begin(), p.fixed.end(), [&](int j) {
      return std::find(q.fixed.begin(), q.fixed.end(), j) != q.fixed.end() &&
          p.unknowns[static_cast<std::size_t>(j)] == q.unknowns[static_cast<std::size_t>(j)];
    });
  }

private:
  bool is_rounding(double distance) const
  {
    constexpr double rounding = 0x1p-44;
    return distance <= rounding * m_extent;
  }

  static const Surface_points::Double_ranges& around(Surface_points::Double_ranges& own, const Exact_ranges& box)
  {
    if (own.empty())
      own = Surface_points::around(box);
    return own;
  }

  std::vector<double> middle_of(std::size_t a, std::size_t b) const
  {
    std::vector<double> result = m_points[a].unknowns;
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] = 0.5 * (result[j] + m_points[b].unknowns[j]);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_POINTS_H
