// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_CELL_LABELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_CELL_LABELS_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/Swept_volume_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/Sweep_membership.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Shell_samples.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Simple_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Thin_handles.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/features_away.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Which cells of triangles are swept: by a certified test of their deepest points. Cells that are no deeper than the
// chord error are taken as their neighbours are.
class Cell_labels
{
  const Triangle_complex& m_complex;
  const Triangle_shells& m_shells;
  std::vector<bool> m_is_inside;
  std::vector<std::pair<std::size_t, double>> m_thin; // shells, and bounds of their depths
  std::vector<std::vector<std::size_t>> m_clusters;   // of thin cells
  Boundary_of_cells::Mesh m_mesh;
  std::vector<Thin_cell> m_thin_cells;
  std::vector<Undecided_part> m_undecided;
  double m_chord_error;
  double m_rounding = 0; // of points

public:
  Cell_labels(const Triangle_complex& complex, const Triangle_shells& shells, double chord_error,
              Sweep_membership is_swept)
    : m_complex(complex), m_shells(shells), m_is_inside(shells.number_of_shells(), false), m_chord_error(chord_error)
  {
    const Shell_samples samples(complex, shells);
    for (std::size_t shell = 0; shell < m_is_inside.size(); ++shell)
      label(shell, samples, is_swept);
    join_thin_cells();
    find_clusters();
    choose_thin_cells(is_swept);
    check_thin_cells(samples, is_swept);
  }

  // The boundary of what is swept; handles that are thinner than the chord error may be closed.
  Boundary_of_cells::Mesh& mesh() { return m_mesh; }
  const std::vector<Thin_cell>& thin_cells() const { return m_thin_cells; }
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

private:
  using Topology = Boundary_of_cells::Topology;

  static constexpr int m_of_sphere = 2; // complexity

  static std::array<Exact_rational, 3> exact(const Double_kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

  void add_undecided(const Double_kernel::Point_3& p, const std::string& reason)
  {
    m_undecided.push_back({{{p.x(), p.x()}, {p.y(), p.y()}, {p.z(), p.z()}}, {}, reason});
  }

  void label(std::size_t shell, const Shell_samples& samples, Sweep_membership& is_swept)
  {
    const auto bound = samples.depth_bound(shell);
    if (is_swept.must_stop() || (bound && *bound <= m_chord_error)) {
      m_thin.emplace_back(shell, bound ? *bound : 0);
      return;
    }
    const std::optional<Shell_sample> sample = samples(shell);
    if (!sample || sample->depth <= m_chord_error) {
      m_thin.emplace_back(shell, sample ? sample->depth : 0);
      return;
    }
    // points so near lie in the same cell; the first one may happen to lie on what an edge sweeps
    for (const Double_kernel::Vector_3& step :
         {Double_kernel::Vector_3(0, 0, 0), {0.13, -0.19, 0.11}, {-0.17, -0.05, 0.23}})
      if (const std::optional<bool> answer = is_swept(exact(sample->point + step * sample->depth))) {
        m_is_inside[shell] = *answer;
        return;
      }
    m_thin.emplace_back(shell, sample->depth);
    add_undecided(sample->point, "whether this point is swept, and the cell around it");
  }

  // Each one is as the neighbours are that it has the largest area in common with, those that are known first.
  void join_thin_cells()
  {
    std::vector<bool> is_known(m_is_inside.size(), true);
    for (const auto& [shell, depth] : m_thin)
      is_known[shell] = false;
    std::vector<std::map<std::size_t, double>> area(m_is_inside.size());
    for (std::size_t i = 0; i < m_complex.triangles.size(); ++i) {
      const std::size_t one = m_shells.shell_of(i, 0), other = m_shells.shell_of(i, 1);
      if (one == other || (is_known[one] && is_known[other]))
        continue;
      area[one][other] += area_of(i);
      area[other][one] += area_of(i);
    }
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const auto& [shell, depth] : m_thin) {
        if (is_known[shell])
          continue;
        double inside = 0, outside = 0;
        for (const auto& [next, common] : area[shell])
          if (is_known[next])
            (m_is_inside[next] ? inside : outside) += common;
        if (inside == 0 && outside == 0)
          continue;
        m_is_inside[shell] = inside > outside;
        is_known[shell] = has_changed = true;
      }
    }
  }

  double area_of(std::size_t triangle) const
  {
    const auto corner = [&](std::size_t k) { return rounded(m_complex.points[m_complex.triangles[triangle][k]]); };
    return std::sqrt(Double_kernel::Triangle_3(corner(0), corner(1), corner(2)).squared_area());
  }

  Topology topology() const { return Boundary_of_cells(m_complex, m_shells, m_is_inside).topology(); }

  void flip(std::size_t shell) { m_is_inside[shell] = !m_is_inside[shell]; }

  // Puts thin cells, alone or all of a cluster, to the other side where that leaves fewer parts, cavities and handles.
  Topology simplify(Sweep_membership& is_swept)
  {
    constexpr int most_rounds = 8;
    Topology result = topology();
    bool has_changed = true;
    const auto put = [&](const std::vector<std::size_t>& shells, bool is_inside) {
      if (result.complexity() <= m_of_sphere || is_swept.must_stop() ||
          std::all_of(shells.begin(), shells.end(), [&](std::size_t s) { return m_is_inside[s] == is_inside; }))
        return;
      const std::vector<bool> before = m_is_inside;
      for (const std::size_t shell : shells)
        m_is_inside[shell] = is_inside;
      if (const Topology other = topology(); other.complexity() < result.complexity()) {
        result = other;
        has_changed = true;
      } else
        m_is_inside = before;
    };
    for (int round = 0; round < most_rounds && std::exchange(has_changed, false); ++round) {
      for (const auto& [shell, depth] : m_thin)
        put({shell}, !m_is_inside[shell]);
      for (const std::vector<std::size_t>& cluster : m_clusters)
        for (const bool is_inside : {false, true})
          put(cluster, is_inside);
    }
    return result;
  }

  // Thin cells with common triangles.
  void find_clusters()
  {
    boost::disjoint_sets_with_storage<> clusters(m_is_inside.size());
    std::vector<bool> is_thin(m_is_inside.size(), false);
    for (const auto& [shell, depth] : m_thin)
      is_thin[shell] = true;
    for (std::size_t i = 0; i < m_complex.triangles.size(); ++i)
      if (const std::size_t one = m_shells.shell_of(i, 0), other = m_shells.shell_of(i, 1);
          is_thin[one] && is_thin[other])
        clusters.union_set(one, other);
    std::map<std::size_t, std::vector<std::size_t>> cells;
    for (const auto& [shell, depth] : m_thin)
      cells[clusters.find_set(shell)].push_back(shell);
    for (auto& [any, own] : cells)
      if (own.size() > 1)
        m_clusters.push_back(std::move(own));
  }

  // The simplest boundary that is found when thin cells begin as their neighbours are, all outside, and all inside.
  // What it has besides one sphere is doubtful where thin cells are near.
  void choose_thin_cells(Sweep_membership& is_swept)
  {
    Topology result = close_handles(simplify(is_swept), is_swept);
    std::vector<bool> chosen = m_is_inside;
    Boundary_of_cells::Mesh simplest = m_mesh;
    for (const bool is_inside : {false, true}) {
      if (result.complexity() <= m_of_sphere)
        break;
      for (const auto& [shell, depth] : m_thin)
        m_is_inside[shell] = is_inside;
      const Topology other = close_handles(simplify(is_swept), is_swept);
      if (other.complexity() < result.complexity()) {
        result = other;
        chosen = m_is_inside;
        simplest = m_mesh;
      }
    }
    m_is_inside = std::move(chosen);
    m_mesh = std::move(simplest);
    if (result.complexity() > m_of_sphere && !is_swept.must_stop() &&
        !has_all_features_away(m_mesh, result, beside_thin_cells()))
      m_undecided.push_back({{}, {}, "the topology of the boundary depends on thin cells"});
  }

  // Makes the mesh, and closes its wrong handles. The topology of the result.
  Topology close_handles(Topology topology, Sweep_membership& is_swept)
  {
    m_mesh = Boundary_of_cells(m_complex, m_shells, m_is_inside)();
    if (topology.complexity() <= m_of_sphere || is_swept.must_stop())
      return topology;
    Thin_handles handles(std::move(m_mesh), m_chord_error);
    topology.characteristic += 2 * handles.close([&](const Boundary_of_cells::Mesh::Point& p) {
      return is_swept.must_stop() ? std::nullopt : is_swept({p.x(), p.y(), p.z()});
    });
    m_mesh = std::move(handles.mesh());
    return topology;
  }

  // What is near thin cells that are not pushed in and out easily, and may be more than a cavity inside.
  Neighbourhood beside_thin_cells() const
  {
    constexpr double errors = 4;
    Neighbourhood result(errors * m_chord_error);
    const Simple_cells is_simple(m_complex, m_shells, m_is_inside);
    std::vector<bool> is_doubtful(m_is_inside.size(), false);
    for (const auto& [shell, depth] : m_thin)
      is_doubtful[shell] = !is_simple(shell) && !(m_is_inside[shell] && is_simple.is_enclosed(shell));
    for (std::size_t i = 0; i < m_complex.triangles.size(); ++i)
      if (is_doubtful[m_shells.shell_of(i, 0)] || is_doubtful[m_shells.shell_of(i, 1)])
        for (const std::size_t corner : m_complex.triangles[i])
          result.add(rounded(m_complex.points[corner]));
    return result;
  }

  // Tells which thin cells could change the topology of the boundary; but for cells that are thinner than points are
  // rounded.
  void check_thin_cells(const Shell_samples& samples, Sweep_membership& is_swept)
  {
    const Topology before = topology();
    const std::vector<Double_kernel::Point_3> places = places_of_shells();
    const Simple_cells is_simple(m_complex, m_shells, m_is_inside);
    for (const auto& [shell, depth] : m_thin) {
      m_thin_cells.push_back({{places[shell].x(), places[shell].y(), places[shell].z()}, depth});
      if (depth <= m_rounding || is_swept.must_stop() || is_simple(shell))
        continue;
      if (!m_is_inside[shell] && is_simple.is_enclosed(shell) && is_swept.is_connected())
        continue; // what is swept has one part, which is deep somewhere
      const auto sample = samples(shell);
      const Double_kernel::Point_3 p = sample ? sample->point : places[shell];
      const std::optional<bool> is_inside = is_swept(exact(p));
      if (is_inside && (*is_inside == m_is_inside[shell] || leads_to_deep_cell(p, *is_inside, samples, is_swept)))
        continue;
      flip(shell);
      if (!(topology() == before))
        add_undecided(p, "the boundary may have another topology at a thin cell");
      flip(shell);
    }
  }

  // Whether a straight way, all of which surely is swept, or is not, leads from a point to a cell that is not thin.
  bool leads_to_deep_cell(const Double_kernel::Point_3& point, bool is_inside, const Shell_samples& samples,
                          Sweep_membership& is_swept) const
  {
    constexpr std::array<double, 3> lengths{1.5, 3, 6}, parts{1, 0.25, 0.0625};
    for (int direction = 0; direction < 27; ++direction) {
      const Double_kernel::Vector_3 v(direction / 9 - 1, direction / 3 % 3 - 1, direction % 3 - 1);
      if (v == CGAL::NULL_VECTOR)
        continue;
      const Double_kernel::Vector_3 unit = v * (m_chord_error / std::sqrt(v.squared_length()));
      const auto length = std::find_if(lengths.begin(), lengths.end(),
                                       [&](double l) { return samples.distance(point + unit * l) > m_chord_error; });
      if (length == lengths.end())
        continue;
      const Double_kernel::Vector_3 way = unit * *length;
      if (std::all_of(parts.begin(), parts.end(),
                      [&](double part) { return is_swept(exact(point + way * part)) == is_inside; }) &&
          is_swept.is_swept_along(exact(point), exact(point + way), is_inside))
        return true;
    }
    return false;
  }

  // A corner of each.
  std::vector<Double_kernel::Point_3> places_of_shells()
  {
    std::vector<Double_kernel::Point_3> result(m_shells.number_of_shells());
    double extent = 0;
    for (std::size_t i = 0; i < m_complex.triangles.size(); ++i) {
      const Double_kernel::Point_3 p = rounded(m_complex.points[m_complex.triangles[i][0]]);
      for (int side : {0, 1})
        result[m_shells.shell_of(i, side)] = p;
      extent = (std::max)({extent, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    }
    m_rounding = 0x1p-40 * extent;
    return result;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_CELL_LABELS_H
