// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Convolution_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Crossing_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Sum_interior_2.h>

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
The boundary of the Minkowski sum of two regions, as sections of the pieces of their convolution.

The pieces are cut where they cross. Then each section, together with those that it goes on as, is on the boundary as a whole, or inside of the sum as a whole: the boundary, which has no ends, is made of sections, and can leave
one only in a crossing. One point beside a section tells which.
*/
class Sum_boundary_2
{
public:
  struct Section
  {
    std::size_t piece;
    Range range;                                         // of the parameter of the piece; up to small ranges at the ends
    std::array<std::optional<std::size_t>, 2> crossings; // at the begin and end, where these are not those of the piece
  };

  struct Chain
  {
    std::vector<Section> sections;
    bool is_closed;
  };

private:
  static constexpr int most_trials = 16;
  static constexpr double least_width = 0x1p-20;

  const Convolution_2& m_convolution;
  const Sum_interior_2& m_interior;
  std::vector<Traced_curve_2> m_curves;          // of the pieces
  double m_size = 0;
  std::vector<std::vector<std::pair<Range, std::size_t>>> m_cuts;   // of each piece, with the number of the crossing
  std::size_t m_crossings = 0;
  std::vector<Section> m_sections;
  std::vector<Chain> m_chains;
  std::vector<Interval_pair> m_undecided;

public:
  Sum_boundary_2(const Convolution_2& convolution, const Sum_interior_2& interior) : m_convolution(convolution), m_interior(interior), m_cuts(convolution.pieces().size())
  {
    for (const Convolution_piece_2& piece : convolution.pieces())
      m_curves.emplace_back([&piece](const Range& range) { return piece(range); }, piece.range(), piece.inner_range());
    m_undecided = convolution.doubtful();
    m_size = size_of_all();
    find_crossings();
    const std::vector<Section> all = all_sections();
    for (const Chain& chain : linked(all, &Sum_boundary_2::goes_on_as))
      if (is_on_boundary(chain))
        m_sections.insert(m_sections.end(), chain.sections.begin(), chain.sections.end());
    m_chains = linked(m_sections, &Sum_boundary_2::is_followed_by);
    check_chains();
  }

  const std::vector<Chain>& chains() const { return m_chains; }
  const Convolution_piece_2& piece(const Section& section) const { return m_convolution.pieces()[section.piece]; }

  // Boxes with points that may be on the boundary and are not on the chains, or where these may not be the boundary.
  const std::vector<Interval_pair>& undecided() const { return m_undecided; }

private:
  double size_of_all() const
  {
    Interval_pair box = m_curves.front().whole().box();
    for (const Traced_curve_2& curve : m_curves)
      box = hull(box, curve.whole().box());
    return (std::max)(box[0].sup() - box[0].inf(), box[1].sup() - box[1].inf());
  }

  bool is_inside(const Interval_pair& box) const { return CGAL::certainly(m_interior.contains(box)); }

  void find_crossings()
  {
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (std::size_t j = i + 1; j < m_curves.size(); ++j)
        if (may_meet(m_curves[i].whole().box(), m_curves[j].whole().box()))
          for (const Crossing_2& crossing : Crossing_finder_2(Traced_view_2(m_curves[i]), Traced_view_2(m_curves[j]), common_end(i, j))())
            add_crossing(i, j, crossing);
  }

  // Inside of the sum it does not matter what is not decided.
  void add_crossing(std::size_t i, std::size_t j, const Crossing_2& crossing)
  {
    if (!crossing.is_certain) {
      const Interval_pair p = m_curves[i](crossing.ranges[0]).point, q = m_curves[j](crossing.ranges[1]).point;
      if (!may_meet(p, q) || is_inside(common_part(p, q)))
        return;
      m_undecided.push_back(common_part(p, q));
    }
    m_cuts[i].emplace_back(crossing.ranges[0], m_crossings);
    m_cuts[j].emplace_back(crossing.ranges[1], m_crossings);
    ++m_crossings;
  }

  // The ends of two pieces that are the same, one of which goes on as the other one.
  std::optional<std::array<int, 2>> common_end(std::size_t i, std::size_t j) const
  {
    for (const int end : {0, 1})
      if (Convolution_piece_2::are_same(m_convolution.pieces()[i], end, m_convolution.pieces()[j], 1 - end))
        return std::array<int, 2>{end, 1 - end};
    return std::nullopt;
  }

  // The sections between cuts.
  std::vector<Section> all_sections()
  {
    std::vector<Section> result;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      auto& cuts = m_cuts[i];
      std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first.begin < b.first.begin; });
      const Range range = m_curves[i].inner_range();
      Section section{i, range, {}};
      for (const auto& [cut, crossing] : cuts) {
        section.range.end = cut.begin;
        section.crossings[1] = crossing;
        add_section(section, result);
        section = {i, {cut.end, range.end}, {crossing, std::nullopt}};
      }
      add_section(section, result);
    }
    return result;
  }

  void add_section(const Section& section, std::vector<Section>& sections)
  {
    if (section.range.begin < section.range.end)
      sections.push_back(section);
    else if (const Interval_pair box = m_curves[section.piece]({section.range.end, section.range.begin}).point; !is_inside(box))   // crossings that are not told apart
      m_undecided.push_back(box);
  }

  // What is not decided is taken for a part of the boundary. Long sections tell more easily.
  bool is_on_boundary(const Chain& chain)
  {
    std::vector<Section> sections = chain.sections;
    std::sort(sections.begin(), sections.end(), [](const Section& a, const Section& b) { return a.range.width() > b.range.width(); });
    for (const Section& section : sections)
      if (const CGAL::Uncertain<bool> is_inside = has_inside_beside(section); is_inside.is_certain())
        return !is_inside.make_certain();
    m_undecided.push_back(m_curves[sections[0].piece](sections[0].range).point);
    return true;
  }

  /*
  Whether the points on the right of a section are inside of the sum, as those on the left are: by a point so near that no other piece comes between. The piece itself does not, since its directions differ by less than
  90 degrees from that in the middle of the section.
  */
  CGAL::Uncertain<bool> has_inside_beside(const Section& section) const
  {
    const double t = section.range.middle();
    const auto [point, tangent] = m_curves[section.piece]({t, t});
    const double x = tangent[0].inf(), y = tangent[1].inf(), length = std::hypot(x, y);
    if (!(length > 0) || !std::isfinite(length))
      return CGAL::Uncertain<bool>::indeterminate();
    double distance = m_size / 128;
    for (int trial = 0; trial < most_trials; ++trial, distance /= 4) {
      const Interval_pair p{Interval(point[0].inf() + distance * y / length), Interval(point[1].inf() - distance * x / length)}, between = hull(p, point);
      bool is_free = true;
      for (std::size_t i = 0; is_free && i < m_curves.size(); ++i)
        is_free = i == section.piece || is_apart(m_curves[i], m_curves[i].whole(), between);
      if (!is_free)
        continue;
      if (const CGAL::Uncertain<bool> result = m_interior.contains(p); result.is_certain())
        return result;
    }
    return CGAL::Uncertain<bool>::indeterminate();
  }

  static bool is_apart(const Traced_curve_2& curve, const Traced_curve_2::Part& part, const Interval_pair& box)
  {
    if (!may_meet(part.box(), box))
      return true;
    if (part.range().width() <= least_width)
      return false;
    const auto& halves = curve.halves(part);
    return is_apart(curve, halves[0], box) && is_apart(curve, halves[1], box);
  }

  // Whether a section ends in an end of its piece, where another one begins.
  bool goes_on_as(const Section& a, const Section& b) const { return !a.crossings[1] && !b.crossings[0] && Convolution_piece_2::are_same(piece(a), 1, piece(b), 0); }

  // The same, or in a crossing.
  bool is_followed_by(const Section& a, const Section& b) const { return (a.crossings[1] && a.crossings[1] == b.crossings[0]) || goes_on_as(a, b); }

  // Sections one after the other. Where more than one may follow, none does.
  std::vector<Chain> linked(const std::vector<Section>& sections, bool (Sum_boundary_2::*follows)(const Section&, const Section&) const) const
  {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const std::size_t n = sections.size();
    std::vector<std::size_t> next(n, none), ways_on(n, 0), ways_back(n, 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        if ((this->*follows)(sections[i], sections[k])) {
          next[i] = k;
          ++ways_on[i];
          ++ways_back[k];
        }
    for (std::size_t i = 0; i < n; ++i)
      if (next[i] != none && (ways_on[i] > 1 || ways_back[next[i]] > 1))
        next[i] = none;
    std::vector<bool> has_previous(n, false), is_used(n, false);
    for (std::size_t i = 0; i < n; ++i)
      if (next[i] != none)
        has_previous[next[i]] = true;
    std::vector<Chain> result;
    for (const bool is_closed : {false, true})
      for (std::size_t i = 0; i < n; ++i)
        if (!is_used[i] && (is_closed || !has_previous[i])) {
          result.push_back({{}, is_closed});
          for (std::size_t k = i; k != none && !is_used[k]; k = next[k]) {
            is_used[k] = true;
            result.back().sections.push_back(sections[k]);
          }
        }
    return result;
  }

  // The boundary has no ends.
  void check_chains()
  {
    for (const Chain& chain : m_chains)
      if (!chain.is_closed) {
        const Section &first = chain.sections.front(), &last = chain.sections.back();
        m_undecided.push_back(m_curves[first.piece]({first.range.begin, first.range.begin}).point);
        m_undecided.push_back(m_curves[last.piece]({last.range.end, last.range.end}).point);
      }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUM_BOUNDARY_2_H
