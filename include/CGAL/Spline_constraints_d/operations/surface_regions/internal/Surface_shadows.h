// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_SHADOWS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_SHADOWS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Jet_sheet.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Monotone_cell.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_bundle.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_events.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Rim_shadow.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

/*
Where the rays from a surface meet other surfaces, or the surface itself: on a rectangle of parameters, everywhere or
nowhere, or the directions in which they can only come to meet them.
*/
class Surface_shadows
{
  // The rays of a cell, in its local parameters.
  struct Source
  {
    Interval_piece origin, direction;
    std::array<Interval, 4> domain; // the ends of its parameters
    Cell_polynomial slope;          // <O,N>, up to a positive factor; zero where a side of the cell is a silhouette
    std::array<std::array<bool, 2>, 2> is_rim;
  };

  // A part of a sheet that rays may meet.
  struct Candidate
  {
    std::size_t sheet;
    const Jet_sheet::Node* node;
  };
  using Candidates = std::vector<Candidate>;

  struct Known_rectangle
  {
    std::size_t cell;
    Parameter_rectangle box;
    Candidates candidates;
  };

  static constexpr std::size_t most_candidates = 600, most_on_a_ray = 64, most_examined = 100, most_kept = 40;

  std::vector<Source> m_sources;
  std::vector<std::unique_ptr<Jet_sheet>> m_sheets;
  std::optional<std::size_t> m_own; // the sheet that is the surface itself
  std::optional<Interval_vector> m_eye;
  std::vector<Known_rectangle> m_known; // each in the one before, or of another cell
  Candidates m_all;

public:
  //! \pre In an Upward_rounding_guard, as all functions.
  explicit Surface_shadows(const std::optional<std::array<Exact_rational, 3>>& eye)
  {
    if (eye)
      m_eye = Interval_vector{interval_of((*eye)[0]), interval_of((*eye)[1]), interval_of((*eye)[2])};
  }

  void add_surface(const Spline_patch<3>& surface, bool is_own)
  {
    if (is_own)
      m_own = m_sheets.size();
    m_sheets.push_back(std::make_unique<Jet_sheet>(surface));
    for (const Jet_sheet::Node* root : m_sheets.back()->roots())
      m_all.push_back({m_sheets.size() - 1, root});
  }

  // The rays from the next cell.
  void add_source(const Surface_cell_3& cell, const Cell_vector& direction)
  {
    const Cell_polynomial slope = dot(normal_of(cell), direction);
    std::array<std::array<bool, 2>, 2> is_rim{};
    for (const int axis : {0, 1})
      for (const int side : {0, 1})
        is_rim[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)] =
            m_own && !is_zero(slope) && is_zero(slope.face(axis, side));
    const std::array<Surface_cell_3::Range, 2> unit{Surface_cell_3::Range(0, 1), Surface_cell_3::Range(0, 1)};
    m_sources.push_back(
        {Interval_piece(cell.coordinates, unit),
         Interval_piece({direction[0], direction[1], direction[2], Cell_polynomial::constant(2, Exact_rational(1))},
                        unit),
         {interval_of(cell.domain[0].first), interval_of(cell.domain[0].second), interval_of(cell.domain[1].first),
          interval_of(cell.domain[1].second)},
         slope,
         is_rim});
  }

  // In local parameters of a cell; what is found is kept for rectangles in this one if it is to be cut.
  Box_answer operator()(std::size_t cell, const Parameter_rectangle& box, bool is_kept)
  {
    while (!m_known.empty() && !(m_known.back().cell == cell && contains(m_known.back().box, box)))
      m_known.pop_back();
    const Ray_bundle rays{m_sources[cell].origin.jet(box, false), m_sources[cell].direction.jet(box, false), m_eye};
    const std::optional<Parameter_rectangle> own_box = m_own ? std::optional(global(cell, box)) : std::nullopt;
    Candidates candidates = m_known.empty() ? m_all : m_known.back().candidates;
    Candidates kept = candidates;
    Direction_set directions;
    constexpr int most_rounds = 44;
    for (int round = 0; round < most_rounds; ++round) {
      std::erase_if(candidates, [&](const Candidate& c) { return is_missed(rays, c, own_box); });
      if (candidates.empty())
        return {false, {}};
      if (candidates.size() <= most_kept)
        kept = candidates;
      if (is_hit(rays, candidates))
        return {true, {}};
      if (!is_number(box) && candidates.size() <= most_examined) {
        if (const auto label = label_beside_rim(rays, candidates, cell, box))
          return {*label, {}};
        directions = directions_into(rays, candidates, cell, box);
      }
      if ((is_enough(directions, box) && !is_beside_rim(cell, box)) ||
          candidates.size() > (is_number(box) ? most_on_a_ray : most_candidates) ||
          !refine(rays, candidates, is_number(box)))
        break;
    }
    if (is_number(box))
      return {label_beside_fold(rays, candidates, cell, box), {}};
    if (directions.is_empty() && is_wound_around(rays, candidates))
      return {true, {}};
    const auto fold = directions.is_empty() ? fold_at_edge(rays, candidates, cell, box) : std::nullopt;
    if (is_kept)
      m_known.push_back({cell, box, std::move(kept)});
    return {std::nullopt, directions, fold};
  }

  // The sign of <O,n> at a point or all along a segment, exactly; 0 if there is none.
  int side_of_silhouette(std::size_t cell, const Parameter_rectangle& segment) const
  {
    const Cell_polynomial& slope = m_sources[cell].slope;
    const std::size_t across = segment[0].first == segment[0].second ? 0 : 1, along = 1 - across;
    const Exact_rational at(segment[across].first), begin(segment[along].first), end(segment[along].second);
    if (begin < end && !has_no_zero(slice_of(slope, static_cast<int>(across), at), begin, end))
      return 0;
    Parameters place;
    place[across] = at;
    place[along] = begin;
    return static_cast<int>(CGAL::sign(slope(place)));
  }

private:
  static bool contains(const Parameter_rectangle& outer, const Parameter_rectangle& inner)
  {
    for (const std::size_t axis : {0, 1})
      if (inner[axis].first < outer[axis].first || inner[axis].second > outer[axis].second)
        return false;
    return true;
  }

  static bool is_number(const Parameter_rectangle& box)
  {
    return box[0].first == box[0].second && box[1].first == box[1].second;
  }

  // Of a segment, those along it.
  static bool is_enough(const Direction_set& directions, const Parameter_rectangle& box)
  {
    const auto contains = [&](std::size_t axis) {
      return directions.contains_axis(axis, true) || directions.contains_axis(axis, false);
    };
    const auto is_value = [&](std::size_t axis) { return box[axis].first == box[axis].second; };
    return is_value(0) ? contains(1) : is_value(1) ? contains(0) : !directions.is_empty();
  }

  bool is_own(const Candidate& c) const { return m_own == c.sheet; }

  // A rectangle of the surface around one of a cell.
  Parameter_rectangle global(std::size_t cell, const Parameter_rectangle& box) const
  {
    Parameter_rectangle result;
    for (const std::size_t axis : {0, 1}) {
      const Interval &begin = m_sources[cell].domain[2 * axis], width = m_sources[cell].domain[2 * axis + 1] - begin;
      result[axis] = {(begin + width * Interval(box[axis].first)).inf(),
                      (begin + width * Interval(box[axis].second)).sup()};
      if (m_sheets[*m_own]->period(axis) > 0)
        continue;
      const auto [least, greatest] = m_sheets[*m_own]->domain(axis); // rounding must not lead beyond the ends
      result[axis] = {(std::max)(result[axis].first, least), (std::min)(result[axis].second, greatest)};
    }
    return result;
  }

  // The rectangle of a candidate of the surface itself, one period away if it is nearer there.
  Parameter_rectangle turned_towards(const Parameter_rectangle& place, Parameter_rectangle box) const
  {
    for (const std::size_t axis : {0, 1}) {
      const double period = m_sheets[*m_own]->period(axis), distance = middle_of(box[axis]) - middle_of(place[axis]);
      if (period == 0 || std::abs(distance) <= 0.5 * period)
        continue;
      const double shift = distance > 0 ? -period : period;
      box[axis] = {(Interval(box[axis].first) + Interval(shift)).inf(),
                   (Interval(box[axis].second) + Interval(shift)).sup()};
    }
    return box;
  }

  static Parameter_rectangle hull(Parameter_rectangle a, const Parameter_rectangle& b)
  {
    for (const std::size_t axis : {0, 1})
      a[axis] = {(std::min)(a[axis].first, b[axis].first), (std::max)(a[axis].second, b[axis].second)};
    return a;
  }

  bool is_missed(const Ray_bundle& rays, const Candidate& c, const std::optional<Parameter_rectangle>& own_box) const
  {
    const Interval_jet& k = c.node->jet;
    if (rays.passes_beside(k) || Meeting_function(rays, k).has_no_zero(rays))
      return true;
    return is_own(c) && has_zero(rays.ahead(k)) && sees_once(rays, *own_box, turned_towards(*own_box, k.box));
  }

  // Whether no two points of the surface on a rectangle around two ones are on the same ray: with means of S_s and S_t,
  // each in its own range, they differ by a S_s + b S_t.
  bool sees_once(const Ray_bundle& rays, const Parameter_rectangle& a, const Parameter_rectangle& b) const
  {
    const auto jet = m_sheets[*m_own]->jet(hull(a, b), false);
    return jet && !has_zero(dot(cross(jet->first[0], jet->first[1]), rays.direction.value));
  }

  // Where a ray in the middle passes nearest, relative to the extent of a candidate.
  bool is_hit(const Ray_bundle& rays, const Candidates& candidates) const
  {
    constexpr std::size_t most = 3;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Meeting_function f(rays, candidates[i].node->jet);
      if (candidates[i].node->depth == 0 ||
          has_zero(
              dot(cross(candidates[i].node->jet.first[0], candidates[i].node->jet.first[1]), rays.direction.middle)))
        continue;
      double square = 0;
      for (const Interval& x : f.middle)
        square += middle_of(x) * middle_of(x);
      order.emplace_back(std::sqrt(square) / (f.extent_of_other(0) + f.extent_of_other(1)), i);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < (std::min)(most, order.size()); ++i) {
      const Candidate& c = candidates[order[i].second];
      if (Hit_test(rays, *m_sheets[c.sheet])(c.node->jet))
        return true;
    }
    return false;
  }

  // Cuts candidates that are larger than what the rays pass; whether there are some.
  bool refine(const Ray_bundle& rays, Candidates& candidates, bool is_one_ray) const
  {
    constexpr int most_depth = 48;
    constexpr double ratio = 0.75;
    Candidates result;
    bool is_refined = false;
    for (const Candidate& c : candidates) {
      const Meeting_function f(rays, c.node->jet);
      const std::array<double, 2> extents{f.extent_of_other(0), f.extent_of_other(1)};
      if (c.node->depth >= most_depth || (!is_one_ray && extents[0] + extents[1] <= ratio * f.extent_of_rays())) {
        result.push_back(c);
        continue;
      }
      is_refined = true;
      for (const Jet_sheet::Node* part : m_sheets[c.sheet]->halves(*c.node, extents[0] < extents[1] ? 1 : 0))
        result.push_back({c.sheet, part});
    }
    candidates = std::move(result);
    return is_refined;
  }

  // For each group of candidates that touch each other, a rectangle around it.
  bool is_wound_around(const Ray_bundle& rays, const Candidates& candidates) const
  {
    std::optional<std::size_t> along;
    for (std::size_t c = 0; c < 3; ++c)
      if (!has_zero(rays.direction.value[c]))
        along = c;
    if (!along)
      return false;
    std::vector<bool> is_done(candidates.size(), false);
    for (std::size_t first = 0; first < candidates.size(); ++first) {
      if (is_done[first])
        continue;
      Parameter_rectangle box = candidates[first].node->jet.box;
      for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = first; i < candidates.size(); ++i)
          if (!is_done[i] && candidates[i].sheet == candidates[first].sheet &&
              touches(box, candidates[i].node->jet.box)) {
            is_done[i] = grows = true;
            box = hull(box, candidates[i].node->jet.box);
          }
      }
      for (auto& range : box) {
        const double margin = 0.35 * (range.second - range.first);
        range = {range.first - margin, range.second + margin};
      }
      if (Winding_test(rays, *m_sheets[candidates[first].sheet], *along)(box))
        return true;
    }
    return false;
  }

  static bool touches(const Parameter_rectangle& a, const Parameter_rectangle& b)
  {
    for (const std::size_t axis : {0, 1})
      if (a[axis].second < b[axis].first || b[axis].second < a[axis].first)
        return false;
    return true;
  }

  Direction_set directions_into(const Ray_bundle& rays, const Candidates& candidates, std::size_t cell,
                                const Parameter_rectangle& box) const
  {
    std::array<double, 2> widths;
    for (const std::size_t axis : {0, 1})
      widths[axis] = box[axis].second > box[axis].first ? box[axis].second - box[axis].first : 1;
    // Of candidates that are not in a rectangle of the surface itself.
    const auto directions_outside = [&](const std::optional<Parameter_rectangle>& rim, Direction_set result) {
      for (const Candidate& c : candidates)
        if (!result.is_empty() && !(rim && is_own(c) && contains(*rim, turned_towards(*rim, c.node->jet.box))))
          result.restrict_to(Surface_regions::directions_into(rays, *m_sheets[c.sheet], *c.node, widths));
      return result;
    };
    std::vector<Parameter_rectangle> near; // not known to be behind or ahead
    const Parameter_rectangle place = m_own ? global(cell, box) : box;
    for (const Candidate& c : candidates)
      if (is_own(c) && has_zero(rays.ahead(c.node->jet)))
        near.push_back(turned_towards(place, c.node->jet.box));
    if (near.empty())
      return directions_outside(std::nullopt, Direction_set::all());
    std::array<double, 2> global_widths = widths;
    for (const std::size_t axis : {0, 1})
      global_widths[axis] *= middle_of(m_sources[cell].domain[2 * axis + 1] - m_sources[cell].domain[2 * axis]);
    Direction_set result;
    const auto visit = [&](const Parameter_rectangle& rim, const Direction_set& at_rim) {
      result = directions_outside(rim, at_rim);
      return !result.is_empty();
    };
    if (const auto source = m_sheets[*m_own]->jet(place, true)) {
      const Rim_shadow shadow(*m_sheets[*m_own], rays, *source);
      shadow.visit_directions(near, global_widths, visit);
      if (result.is_empty() && shadow.is_near_end())
        shadow.with_other_axes().visit_directions(near, global_widths, visit);
    }
    return result;
  }

  // At an end of the surface, if nothing else is met.
  std::optional<Fold_at_edge> fold_at_edge(const Ray_bundle& rays, const Candidates& candidates, std::size_t cell,
                                           const Parameter_rectangle& box) const
  {
    if (!m_own || candidates.size() > most_examined)
      return std::nullopt;
    const Parameter_rectangle place = global(cell, box);
    std::vector<Parameter_rectangle> near;
    for (const Candidate& c : candidates) {
      if (!is_own(c))
        return std::nullopt;
      near.push_back(turned_towards(place, c.node->jet.box));
    }
    std::array<double, 2> widths;
    for (const std::size_t axis : {0, 1})
      widths[axis] = place[axis].second - place[axis].first;
    const auto source = m_sheets[*m_own]->jet(place, true);
    if (!source)
      return std::nullopt;
    const Rim_shadow shadow(*m_sheets[*m_own], rays, *source);
    if (!shadow.is_near_end())
      return std::nullopt;
    auto result = shadow.fold_at_edge(near, widths);
    if (!result)
      result = shadow.with_other_axes().fold_at_edge(near, widths);
    if (result) {
      const auto [axis, end] = *result->edge;
      const auto domain = m_sheets[*m_own]->domain(axis);
      if (end == 0 ? place[axis].first != domain.first : place[axis].second != domain.second)
        result->edge.reset();
    }
    return result;
  }

  // Whether a side of the rectangle, which is no segment, is a silhouette.
  bool is_beside_rim(std::size_t cell, const Parameter_rectangle& box) const
  {
    bool result = false;
    for (const std::size_t axis : {0, 1}) {
      const std::array<bool, 2>& is_rim = m_sources[cell].is_rim[axis];
      result = result || (is_rim[0] && box[axis].first == 0) || (is_rim[1] && box[axis].second == 1);
    }
    return result && box[0].first < box[0].second && box[1].first < box[1].second;
  }

  // The label of a rectangle with a side that is a silhouette, if there is no other one in it and nothing else is met.
  std::optional<bool> label_beside_rim(const Ray_bundle& rays, const Candidates& candidates, std::size_t cell,
                                       const Parameter_rectangle& box) const
  {
    if (!is_beside_rim(cell, box))
      return std::nullopt;
    const std::array<Surface_cell_3::Range, 2> exact{
        Surface_cell_3::Range(Exact_rational(box[0].first), Exact_rational(box[0].second)),
        Surface_cell_3::Range(Exact_rational(box[1].first), Exact_rational(box[1].second))};
    return has_one_sign(without_sides(m_sources[cell].slope.restricted_to_box(exact)))
        ? label_beside_fold(rays, candidates, cell, box)
        : std::nullopt;
  }

  // The label of a rectangle without silhouettes inside of it, or of a point, if nothing is met but the surface near
  // it, and this is near a fold.
  std::optional<bool> label_beside_fold(const Ray_bundle& rays, const Candidates& candidates, std::size_t cell,
                                        const Parameter_rectangle& box) const
  {
    if (!m_own)
      return std::nullopt;
    std::vector<Parameter_rectangle> near;
    const Parameter_rectangle place = global(cell, box);
    for (const Candidate& c : candidates) {
      if (!is_own(c))
        return std::nullopt;
      near.push_back(turned_towards(place, c.node->jet.box));
    }
    const auto whole = m_sheets[*m_own]->jet(place, true);
    const std::array<double, 2> middle{middle_of(place[0]), middle_of(place[1])};
    const auto inside = m_sheets[*m_own]->jet({{{middle[0], middle[0]}, {middle[1], middle[1]}}}, true);
    return whole && inside ? Rim_shadow(*m_sheets[*m_own], rays, *whole).label_beside_fold(*inside, near)
                           : std::nullopt;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_SURFACE_SHADOWS_H
