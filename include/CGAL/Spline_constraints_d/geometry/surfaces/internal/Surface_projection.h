// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SURFACE_PROJECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SURFACE_PROJECTION_H

#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_image.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_points.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Moves points onto surfaces of solutions. A point is a row of coordinates: those of its image in space, if there is a map
to space, and all unknowns, those of inequalities at the end.
*/
class Surface_projection
{
  const Surface_solution_set_d& m_set;
  Surface_points m_points;
  Surface_image m_image;
  std::size_t m_image_coordinates;
  Surface_points::Double_ranges m_domain;
  std::map<int, std::set<double>> m_planes; // where the domain ends, and splines have breaks
  std::vector<Surface_points::Double_ranges> m_boxes;
  std::vector<std::size_t> m_near; // patches that may be near
  std::size_t m_last = 0;          // the one of the last point

public:
  using Coordinates = Eigen::RowVectorXd;

  Surface_projection(const Surface_solution_set_d& set, const Image_functions* image)
    : m_set(set), m_points(set), m_image(set, m_points, image), m_image_coordinates(image == nullptr ? 0 : 3),
      m_domain(Surface_points::around(domain_of(set.system()))), m_planes(Surface_points::breaks_of(set.system()))
  {
    for (const Surface_patch& patch : set.patches())
      m_boxes.push_back(Surface_points::around(patch.box));
    for (std::size_t j = 0; j < m_domain.size(); ++j)
      m_planes[static_cast<int>(j)].insert({m_domain[j].first, m_domain[j].second});
  }

  // How many coordinates a point has, and how many of them its place is, which distances are measured in.
  std::size_t coordinates() const { return m_image_coordinates + m_points.dimension(); }
  std::size_t place_coordinates() const
  {
    return m_image_coordinates > 0 ? m_image_coordinates : static_cast<std::size_t>(m_set.dimension());
  }

  double distance(const Coordinates& a, const Coordinates& b) const
  {
    return (a - b).head(static_cast<Eigen::Index>(place_coordinates())).norm();
  }

  // The point of a vertex of a mesh of the surfaces.
  Coordinates point_of(const Solution_surface_mesh& mesh, Solution_surface_mesh::Mesh::Vertex_index v) const
  {
    Coordinates result(static_cast<Eigen::Index>(coordinates()));
    for (std::size_t k = 0; k < m_image_coordinates; ++k)
      result[static_cast<Eigen::Index>(k)] = mesh.mesh.point(v)[static_cast<int>(k)];
    for (std::size_t j = 0; j < m_points.dimension(); ++j)
      result[static_cast<Eigen::Index>(m_image_coordinates + j)] = mesh.unknowns[v][j];
    return result;
  }

  // The unknowns that have one value at two vertices, at an end of the domain or a break of splines.
  std::vector<int> fixed_between(const std::vector<double>& a, const std::vector<double>& b) const
  {
    std::vector<int> result;
    for (const auto& [unknown, values] : m_planes) {
      const double x = a[static_cast<std::size_t>(unknown)];
      const bool is_plane = std::any_of(values.begin(), values.end(), [&](double at) {
        constexpr double rounding = 0x1p-40;
        return std::abs(x - at) <= rounding * (1 + std::abs(at));
      });
      if (is_plane && x == b[static_cast<std::size_t>(unknown)])
        result.push_back(unknown);
    }
    return result;
  }

  // Only patches of this surface whose boxes meet the box around some points are looked at from now on.
  void look_near(std::size_t surface, const std::vector<Coordinates>& points)
  {
    Surface_points::Double_ranges around(m_points.dimension());
    for (std::size_t j = 0; j < around.size(); ++j) {
      const auto k = static_cast<Eigen::Index>(m_image_coordinates + j);
      const auto [low, high] =
          std::minmax_element(points.begin(), points.end(), [k](const auto& p, const auto& q) { return p[k] < q[k]; });
      around[j] = {(*low)[k], (*high)[k]};
    }
    m_near.clear();
    for (const std::size_t p : m_set.surfaces()[surface].patches) {
      bool meets = true;
      for (std::size_t j = 0; j < around.size() && meets; ++j)
        meets = m_boxes[p][j].first <= around[j].second && around[j].first <= m_boxes[p][j].second;
      if (meets)
        m_near.push_back(p);
    }
    if (m_near.empty())
      m_near = m_set.surfaces()[surface].patches;
    m_last = m_near.front();
  }

  // Moves the unknowns onto the surface, some of them fixed, and the image after them; false if that fails.
  bool project(Coordinates& point, const std::vector<int>& fixed = {})
  {
    Surface_points::Point own = unknowns(point);
    m_last = nearest_patch(own);
    return m_points.move_to_surface(m_last, fixed, own) && set(point, own);
  }

  // The same, but where that leaves the domain, a point on its boundary beside it.
  bool project_into_domain(Coordinates& point)
  {
    if (!project(point))
      return false;
    Surface_points::Point own = unknowns(point);
    std::vector<int> fixed;
    for (std::size_t j = 0; j < own.size(); ++j)
      if (own[j] < m_domain[j].first || m_domain[j].second < own[j]) {
        own[j] = own[j] < m_domain[j].first ? m_domain[j].first : m_domain[j].second;
        fixed.push_back(static_cast<int>(j));
      }
    return fixed.empty() || (m_points.move_to_surface(m_last, fixed, own) && set(point, own));
  }

  // The sign of the orientation, against the gradients at a point of the surface, of two directions there.
  int orientation(const Coordinates& point, const Coordinates& first, const Coordinates& second)
  {
    const Surface_points::Point own = unknowns(point);
    const auto n = static_cast<Eigen::Index>(own.size()), shift = static_cast<Eigen::Index>(m_image_coordinates);
    Function_jets jets;
    m_points.functions(nearest_patch(own)).evaluate(own, 1, jets);
    Eigen::MatrixXd frame(n, n);
    for (Eigen::Index i = 0; i < n - 2; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        frame(i, j) = jets.gradients[static_cast<std::size_t>(i * n + j)];
    frame.row(n - 2) = first.segment(shift, n);
    frame.row(n - 1) = second.segment(shift, n);
    const double determinant = frame.determinant();
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
  }

  // Two independent directions in which a point of the surface can move, as rows.
  Eigen::MatrixXd tangents(const Coordinates& point)
  {
    const Surface_points::Point own = unknowns(point);
    const Surface_image::Tangents tangents = m_image.tangents(nearest_patch(own), own);
    Eigen::MatrixXd result(2, point.size());
    for (Eigen::Index i = 0; i < 2; ++i) {
      for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(m_image_coordinates); ++k)
        result(i, k) = tangents.images[static_cast<std::size_t>(i)][static_cast<int>(k)];
      result.row(i).tail(tangents.unknowns.rows()) = tangents.unknowns.col(i).transpose();
    }
    return result;
  }

  // The angle of a direction at a point, seen in the plane of the tangents.
  double angle(const Eigen::MatrixXd& tangents, const Coordinates& direction) const
  {
    const auto n = static_cast<Eigen::Index>(m_points.dimension());
    return std::atan2(tangents.row(1).tail(n).dot(direction.tail(n)), tangents.row(0).tail(n).dot(direction.tail(n)));
  }

private:
  Surface_points::Point unknowns(const Coordinates& point) const
  {
    return {point.data() + m_image_coordinates, point.data() + point.size()};
  }

  bool set(Coordinates& point, const Surface_points::Point& unknowns)
  {
    std::copy(unknowns.begin(), unknowns.end(), point.data() + m_image_coordinates);
    if (m_image_coordinates > 0) {
      const Surface_image::Point image = m_image(m_last, unknowns);
      for (int k = 0; k < 3; ++k)
        point[k] = image[k];
    }
    return point.allFinite();
  }

  // The first whose box has the point, or the one whose box is nearest.
  std::size_t nearest_patch(const Surface_points::Point& point) const
  {
    std::size_t result = m_last;
    double least = distance_from_box(m_last, point);
    for (std::size_t k = 0; k < m_near.size() && least > 0; ++k)
      if (const double own = distance_from_box(m_near[k], point); own < least) {
        least = own;
        result = m_near[k];
      }
    return result;
  }

  double distance_from_box(std::size_t patch, const Surface_points::Point& point) const
  {
    double result = 0;
    for (std::size_t j = 0; j < point.size(); ++j)
      result = (std::max)({result, m_boxes[patch][j].first - point[j], point[j] - m_boxes[patch][j].second});
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SURFACE_PROJECTION_H
