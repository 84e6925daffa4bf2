// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_CROSSINGS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_CROSSINGS_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Pairwise_common_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Crossing_refinement.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Curve_overlaps_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_curve_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The points in which the curves of a collection cross each other or themselves, touch, end on another one, or pass
through given points, as cuts of the curves. Cuts at rational parameters are exact; others are known by ranges of the
parameters, which are proved to hold one crossing. Crossings too near to each other or to a break to be told apart are
left out, and so are footpoints at parameters that are not rational.

Where curves overlap, both are cut at the ends, and the part of the second one is marked as redundant; what crosses it
crosses the first one.
*/
class Curve_crossings_2
{
public:
  struct Cut
  {
    Parameter_range parameter;
    std::size_t crossing;

    bool is_exact() const { return parameter.first == parameter.second; }
    Exact_rational middle() const { return Exact_rational((parameter.first + parameter.second) / 2); }
    Exact_rational width() const { return Exact_rational(parameter.second - parameter.first); }
  };

private:
  using Pairs_of_curves = std::vector<Pair_with_common_points>;

  static constexpr int least_gap = 1 << 12;   // between cuts and breaks, in units of their widths

  std::vector<std::optional<Exact_pair>> m_points;   // of the crossings, where they are known exactly
  std::vector<Exact_pair> m_near_points;
  const std::vector<Site_curve_2>& m_sites;
  std::vector<Spline_patch<2>> m_curves;
  std::vector<std::vector<Cut>> m_cuts;              // of each curve, by increasing parameters
  std::vector<Coincident_parts_2> m_coincident_parts;
  Search_control* m_control;                         // none: nothing ends the search
  bool m_are_overlaps_proved = true, m_are_cut_everywhere = true, m_are_cut = true;

public:
  template <class Concurrency_tag>
  static Curve_crossings_2 of(const std::vector<Site_curve_2>& curves, const std::vector<Exact_pair>& points,
                              Search_control* control = nullptr)
  {
    Curve_crossings_2 result(curves, control);
    const auto pairs = result.intersecting_pairs<Concurrency_tag>();
    result.add_overlaps(pairs);
    result.add_crossings(pairs);
    result.add_points<Concurrency_tag>(points);
    result.close();
    return result;
  }

  // Only the overlaps, and their ends as cuts; the others only if curves touch.
  template <class Concurrency_tag>
  static Curve_crossings_2 overlaps_of(const std::vector<Site_curve_2>& curves, Search_control* control = nullptr)
  {
    Curve_crossings_2 result(curves, control);
    const auto pairs = result.intersecting_pairs<Concurrency_tag>();
    result.add_overlaps(pairs);
    result.m_are_cut = result.have_footpoints(pairs);
    if (result.m_are_cut)
      result.add_crossings(pairs);
    result.close();
    return result;
  }

  std::size_t size() const { return m_points.size(); }
  const std::optional<Exact_pair>& point(std::size_t crossing) const { return m_points[crossing]; }
  const Exact_pair& near_point(std::size_t crossing) const { return m_near_points[crossing]; }

  // Those of a curve within an open range.
  std::vector<Cut> cuts(std::size_t curve, const Parameter_range& range) const
  {
    std::vector<Cut> result;
    for (const Cut& cut : m_cuts[curve])
      if (range.first < cut.parameter.first && cut.parameter.second < range.second)
        result.push_back(cut);
    return result;
  }

  // Whether a range of a curve is within one that a curve before has in common with it.
  bool is_redundant(std::size_t curve, const Parameter_range& range) const
  {
    return std::any_of(m_coincident_parts.begin(), m_coincident_parts.end(),
                       [&](const Coincident_parts_2& parts) { return parts.hold(1, curve, range); });
  }

  const std::vector<Coincident_parts_2>& coincident_parts() const { return m_coincident_parts; }

  // Whether curves are cut at crossings, too.
  bool are_cut() const { return m_are_cut; }

  // Whether overlaps are proved wherever there are any, and there are cuts in all other common points.
  bool are_complete() const { return m_are_overlaps_proved && m_are_cut_everywhere; }

private:
  Curve_crossings_2(const std::vector<Site_curve_2>& curves, Search_control* control)
    : m_sites(curves), m_cuts(curves.size()), m_control(control)
  {
    for (const Site_curve_2& curve : curves)
      m_curves.push_back(curve.patch);
  }

  void check() const
  {
    if (m_control != nullptr)
      m_control->check();
  }

  template <class Concurrency_tag>
  Pairs_of_curves intersecting_pairs() const
  {
    Search_control::Watch watch(m_control);
    return Pairwise_common_points<2>(watch.options()).template among_and_within<Concurrency_tag>(m_curves).pairs;
  }

  void add_overlaps(const Pairs_of_curves& pairs)
  {
    for (const auto& pair : pairs)
      for (const Common_point& intersection : pair.points)
        if (intersection.kind == Intersection_kind::OVERLAP)
          add_overlaps({pair.first, pair.second}, {intersection.parameters[0], intersection.parameters[1]});
  }

  void add_crossings(const Pairs_of_curves& pairs)
  {
    for (const auto& pair : pairs)
      for (const Common_point& intersection : pair.points)
        if (intersection.kind != Intersection_kind::OVERLAP &&
            !is_redundant(pair.first, intersection.parameters[0]) &&
            !is_redundant(pair.second, intersection.parameters[1]))
          add({pair.first, pair.second}, intersection);
  }

  // Whether curves touch in a point that is known exactly.
  bool have_footpoints(const Pairs_of_curves& pairs) const
  {
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return std::any_of(pair.points.begin(), pair.points.end(), [&](const Common_point& intersection) {
        return intersection.kind == Intersection_kind::TANGENT &&
            at(pair.first, simplest_parameter(pair.first, intersection, 0)) ==
            at(pair.second, simplest_parameter(pair.second, intersection, 1));
      });
    });
  }

  // Those that lie on curves.
  template <class Concurrency_tag>
  void add_points(const std::vector<Exact_pair>& points)
  {
    const std::vector<Spline_patch<2>> patches(points.begin(), points.end());
    Search_control::Watch watch(m_control);
    const Pairs_of_curves pairs =
        Pairwise_common_points<2>(watch.options()).template between<Concurrency_tag>(patches, m_curves).pairs;
    for (const auto& pair : pairs)
      for (const Common_point& intersection : pair.points)
        if (intersection.kind == Intersection_kind::TRANSVERSAL &&
            !is_redundant(pair.second, intersection.parameters[0]))   // that of the curve
          add_point(points[pair.first], pair.second, intersection.parameters[0]);
  }

  Exact_pair at(std::size_t curve, const Exact_rational& t) const
  {
    return m_curves[curve](std::array<Exact_rational, 1>{t});
  }

  // Of curves, or of different parts of one curve.
  void add_overlaps(const std::array<std::size_t, 2>& curves, const std::array<Parameter_range, 2>& ranges)
  {
    const auto [overlaps, are_all_proved] =
        overlaps_of_curves(m_curves[curves[0]], m_curves[curves[1]], ranges, m_control);
    m_are_overlaps_proved = m_are_overlaps_proved && are_all_proved;
    for (const Curve_overlap_2& overlap : overlaps) {
      if (curves[0] == curves[1] && overlap.parameters[1].first < overlap.parameters[0].second)
        continue;
      m_coincident_parts.push_back({curves, overlap});
      for (std::size_t k = 0; k < 2; ++k)
        for (const Exact_rational& t : {overlap.parameters[k].first, overlap.parameters[k].second}) {
          m_cuts[curves[k]].push_back({{t, t}, m_points.size()});
          m_near_points.push_back(at(curves[k], t));
          m_points.push_back(m_near_points.back());
        }
    }
  }

  void add(const std::array<std::size_t, 2>& curves, const Common_point& intersection)
  {
    check();
    std::array<Cut, 2> cuts;
    std::array<Exact_pair, 2> points;   // for the simplest parameters
    for (std::size_t k = 0; k < 2; ++k) {
      const Exact_rational t = simplest_parameter(curves[k], intersection, k);
      points[k] = at(curves[k], t);
      cuts[k] = {{t, t}, m_points.size()};
    }
    const bool is_exact = points[0] == points[1];
    if (intersection.kind == Intersection_kind::UNDECIDED ||
        (!is_exact && intersection.kind == Intersection_kind::TANGENT)) {
      m_are_cut_everywhere = false;
      return;
    }
    if (!is_exact)
      std::tie(cuts[0].parameter, cuts[1].parameter) =
          narrow_ranges(curves, with_short_ends(intersection.parameters));
    for (std::size_t k = 0; k < 2; ++k) {
      if (!intersection.is_at_end[k])
        m_cuts[curves[k]].push_back(cuts[k]);
    }
    m_near_points.push_back(points[intersection.is_at_end[1]]);
    m_points.push_back(is_exact || intersection.is_at_end[0] || intersection.is_at_end[1]
                           ? std::optional(m_near_points.back())
                           : std::nullopt);
  }

  // Those of a crossing, narrowed if each is inside of one piece of its curve.
  std::pair<Parameter_range, Parameter_range> narrow_ranges(const std::array<std::size_t, 2>& curves,
                                                            const Parameter_box& ranges) const
  {
    std::array<const Homogeneous_piece*, 2> pieces;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<Homogeneous_piece>& all = m_sites[curves[k]].pieces;
      const auto piece = std::find_if(all.begin(), all.end(), [&](const Homogeneous_piece& p) {
        return p.domain.first < ranges[k].first && ranges[k].second < p.domain.second;
      });
      if (piece == all.end())
        return {ranges[0], ranges[1]};
      pieces[k] = &*piece;
    }
    const auto [first, second] = Crossing_refinement(*pieces[0], *pieces[1])({ranges[0], ranges[1]});
    return {first, second};
  }

  void add_point(const Exact_pair& point, std::size_t curve, const Parameter_range& range)
  {
    const Exact_rational t = simplest_rational_between(range.first, range.second);
    m_cuts[curve].push_back(
        {at(curve, t) == point ? Parameter_range(t, t) : with_short_ends({range})[0], m_points.size()});
    m_near_points.push_back(point);
    m_points.push_back(point);
  }

  Exact_rational simplest_parameter(std::size_t curve, const Common_point& intersection, std::size_t operand) const
  {
    const Parameter_range& range = intersection.parameters[operand];
    const auto [begin, end] = m_curves[curve].domain(0);
    return !intersection.is_at_end[operand] ? simplest_rational_between(range.first, range.second)
        : range.first <= begin              ? begin
                                            : end;
  }

  void close()
  {
    for (auto& cuts : m_cuts)
      std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter < b.parameter; });
    remove_crossings_that_are_too_near();
  }

  void remove_crossings_that_are_too_near()
  {
    std::vector<char> is_removed(size(), false);
    for (std::size_t curve = 0; curve < m_cuts.size(); ++curve) {
      const std::vector<Exact_rational> breaks = m_curves[curve].breaks(0);
      const std::vector<Cut>& cuts = m_cuts[curve];
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (i > 0 && are_too_near(cuts[i - 1], cuts[i]))
          for (const Cut& cut : {cuts[i - 1], cuts[i]})
            is_removed[cut.crossing] = !cut.is_exact();
        for (const Exact_rational& at : breaks)
          if (!cuts[i].is_exact() &&
              (at < cuts[i].parameter.first ? are_too_near({{at, at}, 0}, cuts[i])
                                            : are_too_near(cuts[i], {{at, at}, 0})))
            is_removed[cuts[i].crossing] = true;
      }
    }
    m_are_cut_everywhere =
        m_are_cut_everywhere && std::find(is_removed.begin(), is_removed.end(), true) == is_removed.end();
    for (auto& cuts : m_cuts) {
      std::erase_if(cuts, [&](const Cut& cut) { return is_removed[cut.crossing]; });
      cuts.erase(
          std::unique(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter == b.parameter; }),
          cuts.end());
    }
  }

  static bool are_too_near(const Cut& a, const Cut& b)
  {
    return b.parameter.first - a.parameter.second < least_gap * (a.width() + b.width());
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CURVE_CROSSINGS_2_H
