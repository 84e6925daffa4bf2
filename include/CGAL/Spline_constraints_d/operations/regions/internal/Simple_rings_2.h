// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_SIMPLE_RINGS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_SIMPLE_RINGS_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/meetings_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

/*
Outlines that may touch, but do not cross, as simple rings that have no more than vertices in common.

Pieces that are there twice have the same on both sides, and are left out. What remains is cut where it meets, in
rational points, and where common parts begin and end, which are left out then; parts between cuts are strands. However
strands are put together to rings, a point is in the region if an odd number of rings go around it. So it is known on
which side of a strand the region is. An outline touches itself if this is one side of all of a curve; if it is not, the
curve crosses another one.
*/
class Simple_rings_2
{
public:
  // A part of a curve, in its direction.
  using Strand = std::vector<Boundary_piece>;

  // The strands of a ring in order, by their indices, and whether they are run backwards.
  using Ring = std::vector<Intersection_arc>;

private:
  std::vector<Strand> m_strands;
  std::vector<std::array<std::size_t, 2>> m_vertices;   // of each strand, at its begin and end
  std::vector<std::vector<Curve_end>> m_ends;           // of strands, in each vertex
  std::vector<char> m_is_region_on_left;                // of each strand
  std::vector<Ring> m_rings;

public:
  // \throws Invalid_input as `Planar_region_2`, and Run_stopped
  Simple_rings_2(std::vector<Strand> curves, Run_of_steps& run)
  {
    check_ends(curves);
    const auto in_any_direction = [](const Curve_end&) { return true; };
    make_strands(without_doubled_pieces(std::move(curves)));
    m_rings = rings(in_any_direction);
    for (Meetings meetings = cut_where_rings_meet(run, true); meetings != Meetings::NONE; ) {
      make_strands(without_doubled_pieces(std::move(m_strands)));
      m_rings = rings(in_any_direction);
      // none of which is left
      meetings = meetings == Meetings::PARTS ? cut_where_rings_meet(run, false) : Meetings::NONE;
    }
    find_sides(run);
    if (!std::all_of(m_rings.begin(), m_rings.end(), [&](const Ring& ring) { return has_region_on_one_side(ring); }))
      m_rings = rings([&](const Curve_end& begin) { return has_region_on_left({begin.curve, begin.side == 1}); });
  }

  const std::vector<Strand>& strands() const { return m_strands; }
  const std::vector<Ring>& rings() const { return m_rings; }

  bool has_region_on_left(const Intersection_arc& arc) const
  {
    return static_cast<bool>(m_is_region_on_left[arc.index]) != arc.is_reversed;
  }

  // Whether rings touch.
  bool has_rings_that_touch() const
  {
    return std::any_of(m_ends.begin(), m_ends.end(), [](const auto& ends) { return ends.size() > 2; });
  }

  Boundary_loop_2 loop(const Ring& ring) const
  {
    Strand pieces;
    for (const Intersection_arc& arc : ring) {
      Boundary_loop_2 part(m_strands[arc.index]);
      if (arc.is_reversed)
        part.reverse();
      pieces.insert(pieces.end(), part.pieces().begin(), part.pieces().end());
    }
    return Boundary_loop_2(std::move(pieces));
  }

private:
  static std::string name(std::size_t curve, const Exact_rational& parameter)
  {
    return "curve " + std::to_string(curve) + " at parameter " + shortest_text(to_nearest_double(parameter));
  }
  static std::string name_of_end(const Strand& strand, int side)
  {
    return name(strand.front().curve, side == 0 ? strand.front().parameters[0] : strand.back().parameters[1]);
  }
  static Exact_pair end_point(const Strand& strand, int side)
  {
    return side == 0 ? strand.front().at(0) : strand.back().at(1);
  }
  static Exact_pair middle(const Strand& strand) { return strand.front().at(Exact_rational(1) / 2); }

  // An even number of ends in each point.
  static void check_ends(const std::vector<Strand>& curves)
  {
    constexpr std::size_t most_names = 8;
    std::string open;   // ends
    std::size_t names = 0;
    for (const auto& [point, ends] : ends_at(curves)) {
      const auto name = [&](std::size_t k) { return name_of_end(curves[ends[k].curve], ends[k].side); };
      if (ends.size() == 1 && ++names <= most_names)
        open += (open.empty() ? "" : ", ") + name(0);
      if (ends.size() > 1 && ends.size() % 2 == 1)
        throw Invalid_input("Planar_region_2: an odd number of ends of curves are the same point: " + name(0) + ", " +
                            name(1) + ", " + name(2) + (ends.size() > 3 ? " and others" : ""));
    }
    if (names > 0)
      throw Invalid_input("Planar_region_2: the boundary is open: no other curve goes on from " + open +
                          (names > most_names ? " and others" : ""));
  }

  static std::map<Exact_pair, std::vector<Curve_end>> ends_at(const std::vector<Strand>& strands)
  {
    std::map<Exact_pair, std::vector<Curve_end>> result;
    for (std::size_t i = 0; i < strands.size(); ++i)
      for (const int side : {0, 1})
        result[end_point(strands[i], side)].push_back({i, side});
    return result;
  }

  // Equal for pieces that are the same, in the same or in opposite directions.
  static std::vector<Exact_pair> key(const Boundary_piece& piece)
  {
    const auto points = [](const Boundary_piece& p) {
      const auto& [x, y, w] = p.coordinates;
      std::vector<Exact_pair> result;
      for (std::size_t k = 0; k < w.coefficients().size(); ++k) {
        result.push_back({Exact_rational(x.coefficients()[k] / w.coefficients()[k]),
                          Exact_rational(y.coefficients()[k] / w.coefficients()[k])});
        result.push_back({Exact_rational(w.coefficients()[k] / w.coefficients().front()), Exact_rational(0)});
      }
      return result;
    };
    return (std::min)(points(piece), points(piece.reversed()));
  }

  // The remaining parts of the curves.
  static std::vector<Strand> without_doubled_pieces(std::vector<Strand> curves)
  {
    std::map<std::vector<Exact_pair>, std::vector<const Boundary_piece*>> same;
    for (const Strand& curve : curves)
      for (const Boundary_piece& piece : curve)
        same[key(piece)].push_back(&piece);
    std::vector<const Boundary_piece*> doubled;
    for (const auto& [key, pieces] : same)
      doubled.insert(doubled.end(), pieces.begin() + static_cast<std::ptrdiff_t>(pieces.size() % 2), pieces.end());
    if (doubled.empty())
      return curves;
    std::sort(doubled.begin(), doubled.end(), std::less<>());
    std::vector<Strand> result;
    for (const Strand& curve : curves) {
      bool goes_on = false;
      for (const Boundary_piece& piece : curve)
        if (std::binary_search(doubled.begin(), doubled.end(), &piece, std::less<>()))
          goes_on = false;
        else {
          if (!std::exchange(goes_on, true))
            result.emplace_back();
          result.back().push_back(piece);
        }
      if (end_point(curve, 0) == end_point(curve, 1) &&
          (result.empty() || result.back().front().curve != curve.front().curve))
        throw Invalid_input("Planar_region_2: all of the boundary " + name_of_end(curve, 0) + " is there twice");
    }
    if (result.empty())
      throw Invalid_input("Planar_region_2: all curves are there twice, from " + name_of_end(curves[0], 0) + " on");
    return result;
  }

  // Cuts parts of curves where more than two ends of pieces meet.
  void make_strands(std::vector<Strand> parts)
  {
    std::map<Exact_pair, int> ends;
    for (const Strand& part : parts)
      for (const Boundary_piece& piece : part)
        for (const int end : {0, 1})
          ++ends[piece.at(end)];
    m_strands.clear();
    for (Strand& part : parts)
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (i == 0 || ends[part[i].at(0)] > 2)
          m_strands.emplace_back();
        m_strands.back().push_back(std::move(part[i]));
      }
    m_vertices.resize(m_strands.size());
    m_ends.clear();
    for (auto& [point, ends_here] : ends_at(m_strands)) {
      for (const Curve_end& end : ends_here)
        m_vertices[end.curve][static_cast<std::size_t>(end.side)] = m_ends.size();
      m_ends.push_back(ends_here);
    }
  }

  bool has_region_on_one_side(const Ring& ring) const
  {
    return std::all_of(ring.begin(), ring.end(), [&](const Intersection_arc& arc) {
      return has_region_on_left(arc) == has_region_on_left(ring.front());
    });
  }

  /*
  Puts the strands together to rings that pass no point twice: what was run through since the last visit of a point is
  cut off. There is always a strand to go on with, as there are as many arrivals as departures in each point, or an even
  number of ends if `may_begin(end)` for all.
  */
  template <class May_begin>
  std::vector<Ring> rings(const May_begin& may_begin) const
  {
    std::vector<char> is_used(m_strands.size(), false);
    std::vector<std::optional<std::size_t>> departure(m_ends.size());   // from a vertex, in the ring
    std::vector<Ring> result;
    for (std::size_t first = 0; first < m_strands.size(); ++first) {
      if (is_used[first])
        continue;
      Ring ring;
      for (Curve_end begin{first, may_begin(Curve_end{first, 0}) ? 0 : 1};;
           begin = next_strand(begin, is_used, may_begin)) {
        departure[vertex(begin)] = ring.size();
        ring.push_back({begin.curve, begin.side == 1});
        is_used[begin.curve] = true;
        if (const auto since = departure[vertex({begin.curve, 1 - begin.side})]) {
          const auto cut = ring.begin() + static_cast<std::ptrdiff_t>(*since);
          for (auto arc = cut; arc != ring.end(); ++arc)
            departure[vertex({arc->index, arc->is_reversed})].reset();
          result.emplace_back(cut, ring.end());
          ring.erase(cut, ring.end());
        }
        if (ring.empty())
          break;
      }
    }
    return result;
  }

  std::size_t vertex(const Curve_end& end) const { return m_vertices[end.curve][static_cast<std::size_t>(end.side)]; }

  // Where a ring goes on: along the same curve, if it can.
  template <class May_begin>
  Curve_end next_strand(const Curve_end& begin, const std::vector<char>& is_used, const May_begin& may_begin) const
  {
    const std::vector<Curve_end>& ends = m_ends[vertex({begin.curve, 1 - begin.side})];
    const auto may_follow = [&](const Curve_end& end) { return !is_used[end.curve] && may_begin(end); };
    const auto same_curve = std::find_if(ends.begin(), ends.end(), [&](const Curve_end& end) {
      return may_follow(end) && m_strands[end.curve].front().curve == m_strands[begin.curve].front().curve;
    });
    return same_curve != ends.end() ? *same_curve : *std::find_if(ends.begin(), ends.end(), may_follow);
  }

  enum class Meetings { NONE, POINTS, PARTS };

  // Splits pieces in common points of the rings, and in the ends of common parts. Returns what there is.
  Meetings cut_where_rings_meet(Run_of_steps& run, bool may_have_common_parts)
  {
    bool have_common_parts = false;
    std::vector<Boundary_loop_2> loops;
    std::vector<Spline_patch<2>> curves;
    for (const Ring& ring : m_rings) {
      run.check();
      loops.push_back(loop(ring));
      curves.emplace_back(loops.back().curve());
    }
    std::map<std::size_t, std::vector<Exact_rational>> cuts;
    for (const Meeting_of_curves& pair : meetings_of_curves(curves, run)) {
      for (const Common_point& meeting : pair.points) {
        const std::array<const Boundary_loop_2*, 2> both{&loops[pair.first], &loops[pair.second]};
        const auto in_common_part = may_have_common_parts ? origins_in_common_part(meeting, both) : std::nullopt;
        have_common_parts = have_common_parts || in_common_part;
        for (const auto& [curve, parameter] : in_common_part ? *in_common_part : origins_of_common_point(meeting, both))
          cuts[curve].push_back(parameter);
      }
    }
    for (Strand& strand : m_strands)
      if (const auto own = cuts.find(strand.front().curve); own != cuts.end())
        strand = split(strand, own->second);
    return have_common_parts ? Meetings::PARTS : cuts.empty() ? Meetings::NONE : Meetings::POINTS;
  }

  using Origin = std::pair<std::size_t, Exact_rational>;   // a curve and its parameter

  // On both curves, the ends of a common part, if these are rational, and of its pieces.
  static std::optional<std::vector<Origin>> origins_in_common_part(const Common_point& meeting,
                                                                   const std::array<const Boundary_loop_2*, 2>& loops)
  {
    if (meeting.kind != Intersection_kind::OVERLAP)
      return std::nullopt;
    const Parameter_box& ranges = meeting.parameters;
    const auto end = [&](std::size_t k, bool is_last) {
      return loops[k]->at(is_last ? ranges[k].second : ranges[k].first);
    };
    const auto are_ends = [&](bool is_reversed) {
      return end(0, false) == end(1, is_reversed) && end(0, true) == end(1, !is_reversed);
    };
    if (!are_ends(false) && !are_ends(true))
      return std::nullopt;
    std::vector<Origin> result;
    for (std::size_t k = 0; k < 2; ++k) {
      result.insert(result.end(), {loops[k]->origin(ranges[k].first), loops[k]->origin(ranges[k].second)});
      append_ends_of_pieces(*loops[1 - k], ranges[1 - k], *loops[k], ranges[k], result);
    }
    return result;
  }

  // Where pieces of a loop within a range end in the inside of pieces of another one.
  static void append_ends_of_pieces(const Boundary_loop_2& loop, const Parameter_range& range,
                                    const Boundary_loop_2& other, const Parameter_range& other_range,
                                    std::vector<Origin>& origins)
  {
    for (std::size_t i = 0; i < loop.pieces().size(); ++i) {
      const Exact_rational first(static_cast<unsigned long>(i));
      if (!(range.first < first && first < range.second))
        continue;
      for (std::size_t j = 0; j < other.pieces().size(); ++j)
        for (const Exact_rational& t : rational_parameters(other.pieces()[j], loop.pieces()[i].at(0)))
          if (const Exact_rational parameter = t + static_cast<unsigned long>(j);
              other_range.first < parameter && parameter < other_range.second)
            origins.push_back(other.origin(parameter));
    }
  }

  // Those of a point in the inside of a piece, if they are rational.
  static std::vector<Exact_rational> rational_parameters(const Boundary_piece& piece, const Exact_pair& point)
  {
    const auto& [x, y, w] = piece.coordinates;
    const Exact_tensor dx = x - w * point[0], dy = y - w * point[1];
    const auto is_beside = [](const Exact_tensor& f) {
      const auto [least, most] = std::minmax_element(f.coefficients().begin(), f.coefficients().end());
      return *least > 0 || *most < 0;
    };
    std::vector<Exact_rational> result;
    if (is_beside(dx) || is_beside(dy))
      return result;
    const Exact_tensor& f = integer_polynomial(dx).is_zero() ? dy : dx;
    for (const Exact_root& root : inner_roots(f, width_for_rational_roots(f)))
      if (root.is_point() && piece.at(root.lower()) == point)
        result.push_back(root.lower());
    return result;
  }

  // \throws Invalid_input when it is not proved to be one rational point.
  static std::vector<Origin> origins_of_common_point(const Common_point& meeting,
                                                     const std::array<const Boundary_loop_2*, 2>& loops)
  {
    std::array<Exact_rational, 2> parameters;
    for (std::size_t k = 0; k < 2; ++k)
      parameters[k] = simplest_rational_between(meeting.parameters[k].first, meeting.parameters[k].second);
    const auto origin = [&](std::size_t k) { return loops[k]->origin(parameters[k]); };
    const bool is_one_point = meeting.kind != Intersection_kind::OVERLAP &&
        meeting.kind != Intersection_kind::UNDECIDED && loops[0]->at(parameters[0]) == loops[1]->at(parameters[1]);
    if (is_one_point)
      return {origin(0), origin(1)};
    for (std::size_t k = 0; k < 2; ++k)
      parameters[k] = middle_of(meeting.parameters[k]);
    const auto what = [&]() -> std::string {
      switch (meeting.kind) {
      case Intersection_kind::TRANSVERSAL: return " cross";
      case Intersection_kind::OVERLAP: return " meet in a common part";
      case Intersection_kind::UNDECIDED: return " are not proved not to meet";
      default: return " meet in a point that is not proved to be rational";
      }
    };
    throw Invalid_input("Planar_region_2: " + std::apply(name, origin(0)) + " and " + std::apply(name, origin(1)) +
                        what());
  }

  static Strand split(const Strand& strand, std::vector<Exact_rational> parameters)
  {
    std::sort(parameters.begin(), parameters.end());
    parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
    Strand result;
    for (const Boundary_piece& piece : strand) {
      const auto& [first, last] = piece.parameters;
      std::vector<Exact_rational> ends{first};
      for (const Exact_rational& t : parameters)
        if (t > first && t < last)
          ends.push_back(t);
      ends.push_back(last);
      for (std::size_t i = 1; i < ends.size(); ++i)
        result.push_back(piece.between(ends[i - 1], ends[i]));
    }
    return result;
  }

  // \throws Invalid_input when the region changes from one side of a curve to the other one.
  void find_sides(Run_of_steps& run)
  {
    std::vector<Boundary_loop_2> loops;
    for (const Ring& ring : m_rings)
      loops.push_back(loop(ring));
    m_is_region_on_left.resize(m_strands.size());
    // of the number of other rings around a point
    const auto parity = [&](std::size_t ring, const Exact_pair& point) {
      bool result = false;
      run.check();
      for (std::size_t k = 0; k < m_rings.size(); ++k)
        result ^= k != ring && loops[k].winding_number(point) != 0;
      return result;
    };
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
      run.check();
      const bool is_counterclockwise = loops[i].is_counterclockwise();
      bool is_on_left = false;
      for (const Intersection_arc& arc : m_rings[i]) {
        // where no rings meet the side remains
        if (&arc == &m_rings[i].front() || m_ends[vertex({arc.index, arc.is_reversed})].size() > 2)
          is_on_left = is_counterclockwise != parity(i, middle(m_strands[arc.index]));
        m_is_region_on_left[arc.index] = is_on_left != arc.is_reversed;
      }
    }
    for (std::size_t s = 1; s < m_strands.size(); ++s) {
      const Boundary_piece &before = m_strands[s - 1].back(), &after = m_strands[s].front();
      if (m_is_region_on_left[s - 1] != m_is_region_on_left[s] && before.curve == after.curve &&
          before.parameters[1] == after.parameters[0])
        throw Invalid_input("Planar_region_2: " + name_of_end(m_strands[s], 0) + " and " + name_of_other_end(s) +
                            " cross");
    }
  }

  // Of one that meets the begin of a strand, and does not go on as it.
  std::string name_of_other_end(std::size_t strand) const
  {
    const std::vector<Curve_end>& ends = m_ends[vertex({strand, 0})];
    const auto other = std::find_if(ends.begin(), ends.end(), [&](const Curve_end& end) {
      return end != Curve_end{strand, 0} && end != Curve_end{strand - 1, 1};
    });
    return name_of_end(m_strands[other->curve], other->side);
  }
};

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_SIMPLE_RINGS_2_H
