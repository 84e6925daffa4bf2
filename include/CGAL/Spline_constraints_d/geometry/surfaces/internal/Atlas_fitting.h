// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_ATLAS_FITTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_ATLAS_FITTING_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Surface_atlas_d.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Chart_fitting.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Chart_square.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Edge_directions.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Mesh_charts.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Square_parametrization.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Fits splines to all surfaces of a mesh.
class Atlas_fitting
{
  using Vertex = Mesh_charts::Vertex;
  using Halfedge = Mesh_charts::Halfedge;

  const Solution_surface_mesh& m_mesh;
  Surface_projection& m_projection;
  Chart_fitting m_fitting, m_edge_fitting;
  Run_control& m_control;
  Mesh_charts m_charts;
  std::optional<Chart_network> m_network;
  std::vector<std::optional<Spline_curve>> m_curves; // of edges
  std::vector<double> m_errors;
  std::vector<std::optional<Chart_square>> m_squares;   // of charts
  std::vector<std::optional<Tensor_spline>> m_surfaces; // the first ones
  Surface_atlas_d m_result;

  // Edges are nearer to the surface than charts need to be, so that these are not held off by them.
  static constexpr double share_of_edges = 0.25;

public:
  Atlas_fitting(const Solution_surface_mesh& mesh, Surface_projection& projection, const Fit_limits& limits,
                Run_control& control)
    : m_mesh(mesh), m_projection(projection), m_fitting(projection, limits),
      m_edge_fitting(projection, {limits.degree, share_of_edges * limits.tolerance, limits.most_spans}),
      m_control(control), m_charts(mesh, projection)
  {}

  // Charts whose surfaces have folds are divided, and all is done again; the best of these atlases is the answer.
  Surface_atlas_d operator()()
  {
    constexpr int most_rounds = 2;
    std::optional<Surface_atlas_d> best;
    std::size_t folds = 0;
    for (int round = 0;; ++round) {
      find_charts();
      fit_edges();
      const std::set<std::size_t> folded = fit_charts();
      add_edges();
      const std::pair own(m_result.undecided_parts.size(), folded.size());
      if (!best || own < std::pair(best->undecided_parts.size(), folds)) {
        best = std::move(m_result);
        folds = folded.size();
      }
      if (folded.empty() || round == most_rounds || m_control.must_stop(false) || !m_charts.refine(folded))
        return *std::move(best);
    }
  }

private:
  // Divides charts until all have a first surface.
  void find_charts()
  {
    constexpr int most_rounds = 12;
    for (int round = 0;; ++round) {
      find_edges();
      m_squares.assign(m_charts.size(), std::nullopt);
      m_surfaces.assign(m_charts.size(), std::nullopt);
      std::set<std::size_t> failed;
      for (std::size_t chart = 0; chart < m_charts.size() && !m_control.must_stop(true); ++chart)
        if (!first_surface(chart))
          failed.insert(chart);
      if (failed.empty() || round == most_rounds || m_control.must_stop(false) || !m_charts.refine(failed))
        return;
    }
  }

  void find_edges()
  {
    m_network.emplace(m_charts, [this](Halfedge h) { return fixed_along(h); });
    m_curves.clear();
    const Edge_directions directions(m_charts, *m_network, m_projection,
                                     [this](const Chart_edge& edge) { look_near(edge); });
    for (std::size_t e = 0; e < m_network->edges().size(); ++e) {
      const Chart_edge& edge = m_network->edges()[e];
      look_near(edge);
      m_curves.push_back(
          m_edge_fitting.first_curve(parameters_along(edge), points_of(edge), edge.fixed, directions[e]));
    }
  }

  std::vector<int> fixed_along(Halfedge h) const
  {
    const auto& mesh = m_mesh.mesh;
    if (!m_mesh.is_feature[mesh.edge(h)])
      return {};
    return m_projection.fixed_between(m_mesh.unknowns[mesh.source(h)], m_mesh.unknowns[mesh.target(h)]);
  }

  void look_near(const Chart_edge& edge)
  {
    std::vector<Surface_projection::Coordinates> points;
    for (const Vertex v : edge.vertices)
      points.push_back(m_charts.points()[v]);
    m_projection.look_near(m_mesh.surface[face_beside(edge)], points);
  }

  Mesh_charts::Face face_beside(const Chart_edge& edge) const
  {
    const Halfedge h = m_mesh.mesh.halfedge(edge.vertices[0], edge.vertices[1]);
    return m_mesh.mesh.face(m_mesh.mesh.is_border(h) ? m_mesh.mesh.opposite(h) : h);
  }

  Eigen::MatrixXd points_of(const Chart_edge& edge) const
  {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(edge.vertices.size()),
                           static_cast<Eigen::Index>(m_projection.coordinates()));
    for (std::size_t k = 0; k < edge.vertices.size(); ++k)
      result.row(static_cast<Eigen::Index>(k)) = m_charts.points()[edge.vertices[k]];
    return result;
  }

  // Lengths of chords from its beginning.
  std::vector<double> lengths_along(const Chart_edge& edge) const
  {
    std::vector<double> result{0};
    for (std::size_t k = 1; k < edge.vertices.size(); ++k)
      result.push_back(result.back() +
                       (m_charts.points()[edge.vertices[k]] - m_charts.points()[edge.vertices[k - 1]]).norm());
    return result;
  }

  std::vector<double> parameters_along(const Chart_edge& edge) const
  {
    std::vector<double> result = lengths_along(edge);
    const double length = result.back();
    for (double& t : result)
      t /= length;
    result.back() = 1;
    return result;
  }

  bool first_surface(std::size_t chart)
  {
    const std::vector<Chart_edge_use>& loop = m_network->loop(chart);
    std::vector<Chart_square::Edge> edges;
    for (const Chart_edge_use& use : loop) {
      if (!m_curves[use.edge])
        return false;
      edges.push_back({use.edge, use.is_reversed, lengths_along(m_network->edges()[use.edge]).back()});
    }
    if (edges.size() < 4)
      return false;
    const Chart_square& square = m_squares[chart].emplace(edges, m_curves, m_projection.place_coordinates());
    m_projection.look_near(m_charts.surface(chart), m_charts.points_of(chart));
    m_surfaces[chart] = m_fitting.first_surface(square.boundary(square.breaks(m_curves), m_curves),
                                                scattered_points(chart), orientation(chart));
    return m_surfaces[chart].has_value();
  }

  // The vertices inside of a chart.
  Scattered_points scattered_points(std::size_t chart) const
  {
    std::map<Vertex, std::array<double, 2>> boundary;
    for (const Chart_square::Part& part : m_squares[chart]->parts()) {
      const Chart_edge& edge = m_network->edges()[part.edge];
      const std::vector<double> t = parameters_along(edge);
      for (std::size_t k = 0; k < t.size(); ++k)
        boundary[edge.vertices[k]] = part.place(t[k]);
    }
    Scattered_points result;
    const auto inside = square_parametrization(m_charts, chart, boundary);
    result.points.resize(static_cast<Eigen::Index>(inside.size()),
                         static_cast<Eigen::Index>(m_projection.coordinates()));
    for (const auto& [v, place] : inside) {
      result.points.row(static_cast<Eigen::Index>(result.places.size())) = m_charts.points()[v];
      result.places.push_back(place);
    }
    return result;
  }

  int orientation(std::size_t chart)
  {
    const auto& mesh = m_mesh.mesh;
    const Halfedge h = mesh.halfedge(m_charts.faces(chart).front());
    const auto point = [&](Vertex v) { return m_charts.points()[v]; };
    const auto corner = point(mesh.source(h));
    return m_projection.orientation(corner, point(mesh.target(h)) - corner, point(mesh.target(mesh.next(h))) - corner);
  }

  void fit_edges()
  {
    m_errors.clear();
    for (std::size_t e = 0; e < m_curves.size(); ++e) {
      const Chart_edge& edge = m_network->edges()[e];
      look_near(edge);
      if (m_curves[e])
        m_curves[e] = m_edge_fitting.fit(*m_curves[e], edge.fixed);
      m_errors.push_back(m_edge_fitting.error());
    }
  }

  // Returns the charts that have folds.
  std::set<std::size_t> fit_charts()
  {
    m_result = {};
    std::set<std::size_t> folded;
    for (std::size_t chart = 0; chart < m_charts.size(); ++chart) {
      if (m_control.must_stop(true)) {
        add_undecided(chart, in_words(m_control.reason()));
        continue;
      }
      const std::optional<Tensor_spline> surface = fitted(chart);
      if (!surface) {
        add_undecided(chart, "a chart without a first surface that has no folds");
        continue;
      }
      add_chart(chart, *surface);
      if (m_result.charts.back().error > m_fitting.limits().tolerance)
        add_undecided(chart, "a chart that is farther away than the tolerance");
      if (!m_result.charts.back().is_regular)
        folded.insert(chart);
    }
    return folded;
  }

  std::optional<Tensor_spline> fitted(std::size_t chart)
  {
    for (const Chart_edge_use& use : m_network->loop(chart))
      if (!m_curves[use.edge])
        return std::nullopt;
    if (!m_surfaces[chart])
      return std::nullopt;
    m_projection.look_near(m_charts.surface(chart), m_charts.points_of(chart));
    const Chart_square& square = *m_squares[chart];
    return m_fitting.fit(
        *m_surfaces[chart], square.breaks(m_curves),
        [&](const std::array<Spline_breaks, 2>& breaks) { return square.boundary(breaks, m_curves); },
        orientation(chart));
  }

  void add_chart(std::size_t chart, const Tensor_spline& surface)
  {
    Fitted_surface_d result;
    result.surface = m_charts.surface(chart);
    result.degree = m_fitting.limits().degree;
    result.error = m_fitting.error();
    result.is_regular = m_fitting.is_regular();
    for (const Chart_square::Part& part : m_squares[chart]->parts())
      result.error = (std::max)(result.error, m_errors[part.edge]);
    for (std::size_t axis = 0; axis < 2; ++axis)
      result.knots[axis].assign(surface.axes[axis].knots.begin(), surface.axes[axis].knots.end());
    for (Eigen::Index i = 0; i < surface.control_points[0].rows(); ++i)
      for (Eigen::Index j = 0; j < surface.control_points[0].cols(); ++j) {
        std::vector<double>& point = result.control_points.emplace_back();
        for (const Eigen::MatrixXd& own : surface.control_points)
          point.push_back(own(i, j));
      }
    for (const Chart_square::Part& part : m_squares[chart]->parts())
      result.boundary.push_back({part.edge, part.is_reversed, {part.place(0), part.place(1)}});
    m_result.error = (std::max)(m_result.error, result.error);
    m_result.test_points += m_fitting.test_points();
    m_result.charts.push_back(std::move(result));
  }

  // Those that charts have.
  void add_edges()
  {
    std::map<std::size_t, std::size_t> index_of;
    std::map<Vertex, std::size_t> vertex_of;
    for (std::size_t chart = 0; chart < m_result.charts.size(); ++chart)
      for (Fitted_surface_d::Side& side : m_result.charts[chart].boundary) {
        const auto [place, is_new] = index_of.try_emplace(side.edge, m_result.edges.size());
        if (is_new)
          m_result.edges.push_back(edge_of(side.edge, vertex_of));
        side.edge = place->second;
        m_result.edges[side.edge].charts.push_back(chart);
      }
  }

  Fitted_edge_d edge_of(std::size_t e, std::map<Vertex, std::size_t>& vertex_of)
  {
    const std::vector<Vertex>& vertices = m_network->edges()[e].vertices;
    const auto vertex = [&](Vertex v) {
      const auto [place, is_new] = vertex_of.try_emplace(v, m_result.vertices.size());
      if (is_new) {
        const auto& point = m_charts.points()[v];
        m_result.vertices.emplace_back(point.data(), point.data() + point.size());
      }
      return place->second;
    };
    const Spline_curve& curve = *m_curves[e];
    Fitted_edge_d result{curve.axis.degree,
                         {curve.axis.knots.begin(), curve.axis.knots.end()},
                         {},
                         {vertex(vertices.front()), vertex(vertices.back())},
                         {},
                         m_errors[e]};
    for (Eigen::Index k = 0; k < curve.control_points.rows(); ++k) {
      const Eigen::RowVectorXd point = curve.control_points.row(k);
      result.control_points.emplace_back(point.data(), point.data() + point.size());
    }
    m_result.error = (std::max)(m_result.error, result.error);
    return result;
  }

  void add_undecided(std::size_t chart, const std::string& reason)
  {
    Undecided_part part;
    const std::vector<Surface_projection::Coordinates> points = m_charts.points_of(chart);
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(m_projection.place_coordinates()); ++k) {
      const auto [low, high] =
          std::minmax_element(points.begin(), points.end(), [k](const auto& p, const auto& q) { return p[k] < q[k]; });
      part.place.emplace_back((*low)[k], (*high)[k]);
    }
    part.reason = reason;
    m_result.undecided_parts.push_back(std::move(part));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_ATLAS_FITTING_H
