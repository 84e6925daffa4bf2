// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_CROSSINGS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_CROSSINGS_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/pairwise_intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The points in which the curves of a collection cross each other or themselves, or end on another one, as cuts of the curves. Cuts at rational parameters are exact; others are known by ranges of the parameters, which are proved to hold one crossing. Crossings too near to each other or to a break to be told apart
are left out, and so are contacts and overlaps.
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
  static constexpr int least_gap = 1 << 12;   // between cuts and breaks, in units of their widths

  std::vector<std::optional<Exact_pair>> m_points;   // of the crossings, where they are known exactly
  std::vector<Exact_pair> m_near_points;
  std::vector<Planar_map> m_maps;                    // of the curves
  std::vector<std::vector<Cut>> m_cuts;              // of each curve, by increasing parameters

public:
  template <class Concurrency_tag, class Curves>
  static Curve_crossings_2 of(const Curves& curves)
  {
    Curve_crossings_2 result;
    for (const auto& curve : curves)
      result.m_maps.emplace_back(curve);
    result.m_cuts.resize(result.m_maps.size());
    for (const auto& pair : pairwise_intersections<Concurrency_tag>(curves, {}, Self_intersections::INCLUDED).pairs)
      for (const auto& intersection : pair.intersections)
        if (intersection.kind() == Intersection_kind::TRANSVERSAL || intersection.kind() == Intersection_kind::END_POINT)
          result.add({pair.first, pair.second}, intersection);
    for (auto& cuts : result.m_cuts)
      std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter < b.parameter; });
    result.remove_crossings_that_are_too_near();
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

private:
  Exact_pair at(std::size_t curve, const Exact_rational& t) const { return m_maps[curve](std::array<Exact_rational, 1>{t}); }

  template <class Intersection>
  void add(const std::array<std::size_t, 2>& curves, const Intersection& intersection)
  {
    std::array<Cut, 2> cuts;
    std::array<Exact_pair, 2> points;   // for the simplest parameters
    for (std::size_t k = 0; k < 2; ++k) {
      const Exact_rational t = simplest_parameter(curves[k], intersection.parameter_range(k), intersection.is_at_end(k));
      points[k] = at(curves[k], t);
      cuts[k] = {{t, t}, m_points.size()};
    }
    const bool is_exact = points[0] == points[1];
    for (std::size_t k = 0; k < 2; ++k) {
      if (!is_exact)
        cuts[k].parameter = with_short_ends({intersection.parameter_range(k)})[0];
      if (!intersection.is_at_end(k))
        m_cuts[curves[k]].push_back(cuts[k]);
    }
    m_near_points.push_back(points[intersection.is_at_end(1)]);
    m_points.push_back(is_exact || intersection.is_at_end(0) || intersection.is_at_end(1) ? std::optional(m_near_points.back()) : std::nullopt);
  }

  Exact_rational simplest_parameter(std::size_t curve, const Parameter_range& range, bool is_at_end) const
  {
    const auto& [begin, end] = m_maps[curve].domain(0);
    return !is_at_end ? simplest_rational_between(range.first, range.second) : range.first <= begin ? begin : end;
  }

  void remove_crossings_that_are_too_near()
  {
    std::vector<char> is_removed(size(), false);
    for (std::size_t curve = 0; curve < m_cuts.size(); ++curve) {
      const std::vector<Exact_rational> breaks = m_maps[curve].breaks(0);
      const std::vector<Cut>& cuts = m_cuts[curve];
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (i > 0 && are_too_near(cuts[i - 1], cuts[i]))
          is_removed[cuts[i - 1].crossing] = is_removed[cuts[i].crossing] = true;
        for (const Exact_rational& at : breaks)
          if (!cuts[i].is_exact() && (at < cuts[i].parameter.first ? are_too_near({{at, at}, 0}, cuts[i]) : are_too_near(cuts[i], {{at, at}, 0})))
            is_removed[cuts[i].crossing] = true;
      }
    }
    for (auto& cuts : m_cuts) {
      std::erase_if(cuts, [&](const Cut& cut) { return is_removed[cut.crossing]; });
      cuts.erase(std::unique(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter == b.parameter; }), cuts.end());
    }
  }

  static bool are_too_near(const Cut& a, const Cut& b) { return b.parameter.first - a.parameter.second < least_gap * (a.width() + b.width()); }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_CROSSINGS_2_H
