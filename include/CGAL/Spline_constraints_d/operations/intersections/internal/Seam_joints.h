// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SEAM_JOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SEAM_JOINTS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
Joins curves of solutions where they cross the seam of a closed surface.

On the faces of the domain at both ends of a closed unknown, the equations have the same solutions. All of them are
known, so if the box of a vertex on one face meets the box of just one vertex on the other face, and the other way
round, the two are the same point: its vertex on the other face has a box that holds it too. What is not that clear is
not joined.

A pole is a face of the domain that is one point in space. Two curves that end there, and no others, are joined.

Where solutions are unordered pairs of points, of both orders of a pair only one satisfies the inequality of the system,
but for those where it is zero: there both do. So what a solution is the same point as may have its unknowns exchanged.
*/
class Seam_joints
{
  using Box = Curve_vertex::Exact_box;

  const Curve_solution_set_d& m_set;
  // of each vertex, a vertex that is the same point in space
  std::vector<std::size_t> m_point;
  std::vector<std::vector<Curve_end>> m_ends;   // per such point: those of curves that lie there
  std::vector<std::size_t> m_unmatched, m_equal_pairs;
  Box m_domain;
  std::vector<std::size_t> m_exchange;

  // A vertex on a face of the domain, where this unknown is at an end.
  struct Place
  {
    std::size_t vertex, unknown;
  };

public:
  // A face of the domain: an unknown and its value.
  using Face = std::pair<std::size_t, Exact_rational>;

  // `exchange`: of unordered pairs, for each unknown the one that takes its place in the other order.
  Seam_joints(const Constraint_system_d& system, const Curve_solution_set_d& set,
              const std::vector<std::size_t>& closed_unknowns, const std::vector<Face>& poles = {},
              std::vector<std::size_t> exchange = {});

  // The vertices on a seam for which there is not just one on its other side.
  const std::vector<std::size_t>& unmatched() const { return m_unmatched; }

  // The vertices that are pairs of equal points.
  const std::vector<std::size_t>& equal_pairs() const { return m_equal_pairs; }

  // Vertices, each of those that are the same point once.
  std::vector<std::size_t> without_repetitions(const std::vector<std::size_t>& vertices) const;

  // A vertex that stands for all that are the same point in space as a given one.
  std::size_t representative(std::size_t vertex) const { return m_point[vertex]; }

  std::vector<Intersection_curve> curves() const;

  // The points without curves, each once; what is unmatched is reported as undecided.
  std::vector<std::size_t> points() const;

private:
  void add_unmatched(std::size_t vertex)
  {
    if (std::find(m_unmatched.begin(), m_unmatched.end(), vertex) == m_unmatched.end())
      m_unmatched.push_back(vertex);
  }

  std::size_t root(std::size_t i) const;

  std::size_t point_at(std::size_t curve, int side) const
  {
    const std::vector<Curve_piece>& pieces = m_set.curves()[curve].pieces;
    return m_point[side == 0 ? pieces.front().ends[0] : pieces.back().ends[1]];
  }

  // Two curves end there, neither in a singular point nor in an undecided region, nor where they were cut.
  bool goes_on(std::size_t point) const;

  std::optional<Curve_end> next(const Curve_end& end) const;

  void identify(std::size_t unknown, bool is_upper, std::vector<Place>& unmatched);

  // Whether a vertex without curves is the same point, across another seam, as one of a curve along this seam, which is
  // there once.
  bool is_point_of_curve_along_seam(const Place& place) const;

  // Which vertices are on pieces in a face, and on no others: curves along a seam are there once.
  std::vector<bool> along_face(std::size_t unknown, bool is_upper) const;

  // The vertices on the other side of a seam that may be the same point.
  std::vector<Place> across(const Place& place, bool is_upper) const;

  // Where the inequality is zero, the pair is there in both orders, or both of its points are the same.
  void identify_orders();

  Box exchanged(const Box& box) const;

  std::vector<std::size_t> on_face(std::size_t unknown, bool is_upper) const
  {
    return on_face(unknown, is_upper ? m_domain[unknown].second : m_domain[unknown].first);
  }

  std::vector<std::size_t> on_face(std::size_t unknown, const Exact_rational& value) const;

  // Those of some vertices whose boxes meet another one, apart from one unknown.
  std::vector<std::size_t> meeting(const Box& box, const std::vector<std::size_t>& others, std::size_t unknown) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE
Seam_joints::Seam_joints(const Constraint_system_d& system, const Curve_solution_set_d& set,
                         const std::vector<std::size_t>& closed_unknowns, const std::vector<Face>& poles,
                         std::vector<std::size_t> exchange)
  : m_set(set), m_point(set.vertices().size()), m_ends(set.vertices().size()), m_domain(domain_of(system)),
    m_exchange(std::move(exchange))
{
  std::iota(m_point.begin(), m_point.end(), 0);
  std::vector<Place> unmatched;
  for (const std::size_t unknown : closed_unknowns)
    for (const bool is_upper : {false, true})
      identify(unknown, is_upper, unmatched);
  for (const Place& place : unmatched)
    if (!is_point_of_curve_along_seam(place))
      add_unmatched(place.vertex);
  if (!m_exchange.empty())
    identify_orders();
  for (const auto& [unknown, value] : poles)
    if (const std::vector<std::size_t> all = on_face(unknown, value); !all.empty())
      for (const std::size_t i : all)
        m_point[root(i)] = root(all.front());
  for (std::size_t i = 0; i < m_point.size(); ++i)
    m_point[i] = root(i);
  for (std::size_t c = 0; c < set.curves().size(); ++c)
    for (const int side : {0, 1})
      if (!set.curves()[c].is_closed)
        m_ends[point_at(c, side)].push_back({c, side});
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t>
Seam_joints::without_repetitions(const std::vector<std::size_t>& vertices) const
{
  std::vector<std::size_t> result;
  for (const std::size_t i : vertices)
    if (std::none_of(result.begin(), result.end(), [&](std::size_t k) { return m_point[k] == m_point[i]; }))
      result.push_back(i);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Intersection_curve> Seam_joints::curves() const
{
  std::vector<bool> is_closed;
  for (const Solution_curve& curve : m_set.curves())
    is_closed.push_back(curve.is_closed);
  return chains_of_curves(is_closed, [&](const Curve_end& end) { return next(end); });
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> Seam_joints::points() const
{
  std::vector<bool> is_taken(m_point.size(), false);
  for (const Solution_curve& curve : m_set.curves())
    for (const std::size_t i : curve.vertices())
      is_taken[m_point[i]] = true;
  std::vector<std::size_t> result;
  for (const std::size_t i : m_set.points())
    if (!is_taken[m_point[i]] && std::find(m_unmatched.begin(), m_unmatched.end(), i) == m_unmatched.end()) {
      is_taken[m_point[i]] = true;
      result.push_back(i);
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Seam_joints::root(std::size_t i) const
{
  while (m_point[i] != i)
    i = m_point[i];
  return i;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Seam_joints::goes_on(std::size_t point) const
{
  const auto is_it = [&](std::size_t i) { return m_point[i] == point; };
  const std::vector<Undecided_region>& regions = m_set.undecided_regions();
  return m_ends[point].size() == 2 && !m_set.vertices()[point].is_singular &&
      (!m_exchange.empty() || !m_set.vertices()[point].is_on_inequality) &&
      std::none_of(regions.begin(), regions.end(), [&](const Undecided_region& region) {
           return std::any_of(region.vertices.begin(), region.vertices.end(), is_it);
         });
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Curve_end> Seam_joints::next(const Curve_end& end) const
{
  const std::size_t point = point_at(end.curve, end.side);
  if (!goes_on(point))
    return std::nullopt;
  return m_ends[point][m_ends[point][0] == end ? 1 : 0];
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Seam_joints::identify(std::size_t unknown, bool is_upper,
                                                          std::vector<Place>& unmatched)
{
  const std::vector<bool> is_along_seam = along_face(unknown, is_upper);
  for (const std::size_t i : on_face(unknown, is_upper)) {
    if (is_along_seam[i])
      continue;
    const std::vector<Place> partners = across({i, unknown}, is_upper);
    if (partners.size() == 1 && across(partners[0], !is_upper).size() == 1)
      m_point[root(partners[0].vertex)] = root(i);
    else
      unmatched.push_back({i, unknown});
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Seam_joints::is_point_of_curve_along_seam(const Place& place) const
{
  const std::vector<std::size_t>& points = m_set.points();
  if (std::find(points.begin(), points.end(), place.vertex) == points.end())
    return false;
  const std::vector<bool> is_lower = along_face(place.unknown, false), is_upper = along_face(place.unknown, true);
  for (std::size_t i = 0; i < m_point.size(); ++i)
    if ((is_lower[i] || is_upper[i]) && root(i) == root(place.vertex))
      return true;
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<bool> Seam_joints::along_face(std::size_t unknown, bool is_upper) const
{
  const Exact_rational& value = is_upper ? m_domain[unknown].second : m_domain[unknown].first;
  std::vector<bool> result(m_set.vertices().size(), false), is_on_others(m_set.vertices().size(), false);
  for (const Solution_curve& curve : m_set.curves())
    for (const Curve_piece& piece : curve.pieces)
      for (const std::size_t i : piece.ends) {
        const bool is_in_face = piece.box[unknown].first == value && piece.box[unknown].second == value;
        result[i] = result[i] || is_in_face;
        is_on_others[i] = is_on_others[i] || !is_in_face;
      }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = result[i] && !is_on_others[i];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Seam_joints::Place> Seam_joints::across(const Place& place,
                                                                                   bool is_upper) const
{
  const Box& box = m_set.vertices()[place.vertex].box;
  std::vector<Place> result;
  for (const std::size_t i : meeting(box, on_face(place.unknown, !is_upper), place.unknown))
    result.push_back({i, place.unknown});
  if (!m_exchange.empty())
    for (const std::size_t i :
         meeting(exchanged(box), on_face(m_exchange[place.unknown], !is_upper), m_exchange[place.unknown]))
      result.push_back({i, m_exchange[place.unknown]});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Seam_joints::identify_orders()
{
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < m_set.vertices().size(); ++i)
    if (m_set.vertices()[i].is_on_inequality)
      all.push_back(i);
  for (const std::size_t i : all) {
    const std::vector<std::size_t> partners = meeting(exchanged(m_set.vertices()[i].box), all, m_domain.size());
    if (partners.size() != 1)
      add_unmatched(i);
    else if (partners[0] == i)
      m_equal_pairs.push_back(i);
    else
      m_point[root(partners[0])] = root(i);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Seam_joints::Box Seam_joints::exchanged(const Box& box) const
{
  Box result;
  for (const std::size_t unknown : m_exchange)
    result.push_back(box[unknown]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> Seam_joints::on_face(std::size_t unknown,
                                                                             const Exact_rational& value) const
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < m_set.vertices().size(); ++i)
    if (const auto& [lower, upper] = m_set.vertices()[i].box[unknown]; lower == value && upper == value)
      result.push_back(i);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t>
Seam_joints::meeting(const Box& box, const std::vector<std::size_t>& others, std::size_t unknown) const
{
  std::vector<std::size_t> result;
  std::copy_if(others.begin(), others.end(), std::back_inserter(result), [&](std::size_t i) {
    const Box& other = m_set.vertices()[i].box;
    for (std::size_t j = 0; j < box.size(); ++j)
      if (j != unknown && (box[j].second < other[j].first || other[j].second < box[j].first))
        return false;
    return true;
  });
  return result;
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SEAM_JOINTS_H
