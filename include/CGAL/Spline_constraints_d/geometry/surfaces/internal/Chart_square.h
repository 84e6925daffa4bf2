// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_SQUARE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_SQUARE_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Spline_surfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
How the edges around a chart lie around the unit square. The four vertices that become corners are those where the
angles of the chart are nearest to right ones, so that the others are nearest to straight ones and opposite sides are of
similar length. Edges on a side get parts nearly in the ratio of their lengths: the places where they meet have few
bits, so that those on opposite sides are the same or clearly apart, and so are the breaks of curves between them.
*/
class Chart_square
{
public:
  using Curves = std::vector<std::optional<Spline_curve>>;

  struct Edge
  {
    std::size_t edge;
    bool is_reversed;
    double length;
  };

  // An edge on a side: where it begins and ends along it, counterclockwise.
  struct Part
  {
    std::size_t edge;
    bool is_reversed;
    std::size_t side; // from (0, 0) to (1, 0) is the first
    double from, to;

    // How far along the side a parameter of the edge is.
    double along_side(double t) const
    {
      const double s = is_reversed ? 1 - t : t;
      return s == 1 ? to : from + s * (to - from);
    }

    // Where a parameter of the edge is in the square.
    std::array<double, 2> place(double t) const
    {
      const double s = along_side(t);
      return side == 0 ? std::array{s, 0.}
          : side == 1  ? std::array{1., s}
          : side == 2  ? std::array{1 - s, 1.}
                       : std::array{0., 1 - s};
    }
  };

private:
  std::vector<Part> m_parts;

public:
  // The edges counterclockwise around the chart, four at least.
  Chart_square(std::vector<Edge> edges, const Curves& curves, std::size_t place_coordinates)
  {
    const std::array<std::size_t, 4> corners = best_corners(edges, angles_of(edges, curves, place_coordinates));
    for (std::size_t side = 0; side < 4; ++side) {
      const std::vector<std::size_t> own = range(corners[side], corners[(side + 1) % 4], edges.size());
      std::vector<double> lengths;
      for (const std::size_t k : own)
        lengths.push_back(edges[k].length);
      const std::vector<double> joints = joints_of(lengths);
      for (std::size_t k = 0; k < own.size(); ++k)
        m_parts.push_back({edges[own[k]].edge, edges[own[k]].is_reversed, side, joints[k], joints[k + 1]});
    }
  }

  // Counterclockwise from (0, 0).
  const std::vector<Part>& parts() const { return m_parts; }

  // Along both axes: those of the curves on both sides; where edges meet, splines may have a kink.
  std::array<Spline_breaks, 2> breaks(const Curves& curves) const
  {
    std::array<Spline_breaks, 2> result;
    const int degree = curves[m_parts.front().edge]->axis.degree;
    for (std::size_t axis = 0; axis < 2; ++axis)
      result[axis] = common_breaks(breaks_of_side(axis, curves), breaks_of_side(axis + 2, curves), degree);
    return result;
  }

  // The curves on the sides, exactly, with breaks that are finer.
  Square_boundary boundary(const std::array<Spline_breaks, 2>& breaks, const Curves& curves) const
  {
    return {{curve_on_side(0, breaks[0], curves), curve_on_side(2, breaks[0], curves)},
            {curve_on_side(3, breaks[1], curves), curve_on_side(1, breaks[1], curves)}};
  }

private:
  // Of edges from one up to another, around the chart.
  static std::vector<std::size_t> range(std::size_t first, std::size_t last, std::size_t size)
  {
    std::vector<std::size_t> result;
    for (std::size_t k = first; k != last; k = (k + 1) % size)
      result.push_back(k);
    return result;
  }

  // Multiples of a power of two from 0 to 1, all different, nearly in the ratio of these lengths.
  static std::vector<double> joints_of(const std::vector<double>& lengths)
  {
    double total = 0, sum = 0;
    for (const double length : lengths)
      total += length;
    std::size_t grid = 32;
    while (grid < 4 * lengths.size())
      grid *= 2;
    std::vector<double> result{0};
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      sum += lengths[k];
      const double least = result.back() + 1, most = static_cast<double>(grid - (lengths.size() - 1 - k));
      result.push_back(k + 1 == lengths.size()
                           ? static_cast<double>(grid)
                           : (std::clamp)(std::round(sum / total * static_cast<double>(grid)), least, most));
    }
    for (double& joint : result)
      joint /= static_cast<double>(grid);
    return result;
  }

  // At the beginning of each edge.
  static std::vector<double> angles_of(const std::vector<Edge>& edges, const Curves& curves,
                                       std::size_t place_coordinates)
  {
    std::vector<double> result;
    // away from the end of an edge that is its first one around the chart, or from the other one
    const auto direction = [&](const Edge& edge, bool is_first) -> Eigen::RowVectorXd {
      const Eigen::MatrixXd& points = curves[edge.edge]->control_points;
      const Eigen::Index last = points.rows() - 1;
      return (is_first != edge.is_reversed ? points.row(1) - points.row(0) : points.row(last - 1) - points.row(last))
          .head(static_cast<Eigen::Index>(place_coordinates));
    };
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Eigen::RowVectorXd out = direction(edges[k], true),
                               back = direction(edges[(k + edges.size() - 1) % edges.size()], false);
      const double product = out.norm() * back.norm();
      result.push_back(product > 0 ? std::acos((std::clamp)(out.dot(back) / product, -1., 1.)) : 0);
    }
    return result;
  }

  static std::array<std::size_t, 4> best_corners(const std::vector<Edge>& edges, const std::vector<double>& angles)
  {
    const double straight = std::acos(-1.0);
    std::array<std::size_t, 4> result{}, corners{};
    double least = std::numeric_limits<double>::infinity();
    const std::size_t n = edges.size();
    for (corners[0] = 0; corners[0] < n; ++corners[0])
      for (corners[1] = corners[0] + 1; corners[1] < n; ++corners[1])
        for (corners[2] = corners[1] + 1; corners[2] < n; ++corners[2])
          for (corners[3] = corners[2] + 1; corners[3] < n; ++corners[3]) {
            double cost = 0;
            for (std::size_t k = 0; k < n; ++k)
              cost += std::pow(angles[k] - (is_one_of(corners, k) ? 0.5 * straight : straight), 2);
            std::array<double, 4> lengths{};
            for (std::size_t side = 0; side < 4; ++side)
              for (const std::size_t k : range(corners[side], corners[(side + 1) % 4], n))
                lengths[side] += edges[k].length;
            for (std::size_t side = 0; side < 2; ++side)
              cost += std::pow(std::log(lengths[side] / lengths[side + 2]), 2);
            if (cost < least) {
              least = cost;
              result = corners;
            }
          }
    return result;
  }

  static bool is_one_of(const std::array<std::size_t, 4>& corners, std::size_t k)
  {
    return std::find(corners.begin(), corners.end(), k) != corners.end();
  }

  // Parameters along a side grow with those of the square on the first two sides only.
  static bool is_opposite(std::size_t side) { return side > 1; }

  Spline_breaks breaks_of_side(std::size_t side, const Curves& curves) const
  {
    Spline_breaks result;
    for (const Part& part : m_parts)
      if (part.side == side) {
        const Spline_axis& axis = curves[part.edge]->axis;
        for (const Break<double>& entry : breaks_of(axis)) {
          const double s = part.along_side(entry.value);
          const bool is_joint = s == part.from || s == part.to;
          if (s != part.to || s == 1)
            result.push_back({is_opposite(side) ? 1 - s : s, is_joint ? axis.degree : entry.multiplicity});
        }
      }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    return result;
  }

  Spline_curve curve_on_side(std::size_t side, const Spline_breaks& breaks, const Curves& curves) const
  {
    const int degree = curves[m_parts.front().edge]->axis.degree;
    std::vector<double> parameters = Sample_parameters(breaks, degree).all;
    Eigen::MatrixXd points(static_cast<Eigen::Index>(parameters.size()),
                           curves[m_parts.front().edge]->control_points.cols());
    std::array<Eigen::MatrixXd, 2> ends;
    for (const Part& part : m_parts) {
      if (part.side != side)
        continue;
      const Spline_curve& curve = *curves[part.edge];
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        const double s = is_opposite(side) ? 1 - parameters[k] : parameters[k];
        if (part.from <= s && s <= part.to) {
          const double t = (s - part.from) / (part.to - part.from);
          points.row(static_cast<Eigen::Index>(k)) = curve.at({part.is_reversed ? 1 - t : t}).row(0);
        }
      }
      const Eigen::Index last = curve.control_points.rows() - 1;
      if (part.from == 0)
        ends[is_opposite(side) ? 1 : 0] = curve.control_points.row(part.is_reversed ? last : 0);
      if (part.to == 1)
        ends[is_opposite(side) ? 0 : 1] = curve.control_points.row(part.is_reversed ? 0 : last);
    }
    return fitted_curve(clamped(degree, breaks), parameters, points, ends);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_CHART_SQUARE_H
