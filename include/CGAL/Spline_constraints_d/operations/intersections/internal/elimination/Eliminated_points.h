// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_ELIMINATED_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_ELIMINATED_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Points_at_breaks.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common points of two curves by elimination: for each two pieces whose boxes meet, the roots of one polynomial in the
parameter of one of them, and for each break the parameters of its point on the other curve. The work does not depend on
how near the curves are to each other, but for the lengths of numbers.

Two pieces on one algebraic curve have a zero polynomial: they overlap, or meet in their ends or in double points. These
are left to the solver, two pieces at a time, and overlaps that go on over a break are joined.

It finds all or nothing: nothing where the solver does not decide such pieces, where degrees are high, or where both
curves have several parameters for one common point.
*/
template <int d>
class Eliminated_points
{
  // A common point inside of two pieces: a parameter of one curve, which tells that of the other one.
  struct Inner_point
  {
    std::array<std::size_t, 2> pieces;
    std::size_t curve;
    Exact_root root;
    Partner partner;
    int multiplicity;
  };

public:
  // The common points in a box of parameters, by the solver.
  using Solve_part = std::function<std::vector<Common_point>(const Parameter_box&)>;

private:
  const Patch_pair<d>& m_pair;
  Curve_pieces<d> m_pieces;
  Solve_part m_solve_part;
  std::vector<Common_point> m_points, m_overlaps;

public:
  //! \pre the operands are curves. `check` is called often, and may throw.
  Eliminated_points(const Patch_pair<d>& pair, std::function<void()> check, Solve_part solve_part = {})
    : m_pair(pair), m_pieces(pair, std::move(check)), m_solve_part(std::move(solve_part))
  {}

  std::optional<std::vector<Common_point>> operator()()
  {
    if (!m_pieces.are_connected())
      return std::nullopt;
    for (const auto& [i, j] : pairs_with_meeting_boxes(patches(0), patches(1)))
      if (!have_low_degrees(i, j) || !add_inner_points({i, j}))
        return std::nullopt;
    join_overlaps();
    if (!add_points_at_breaks())
      return std::nullopt;
    std::move(m_overlaps.begin(), m_overlaps.end(), std::back_inserter(m_points));
    return std::move(m_points);
  }

private:
  std::vector<Spline_patch<d>> patches(std::size_t curve) const
  {
    std::vector<Spline_patch<d>> result;
    const std::vector<Exact_rational>& breaks = m_pieces.breaks(curve);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      result.push_back(m_pair[curve].part(0, {breaks[i], breaks[i + 1]}));
    return result;
  }

  bool have_low_degrees(std::size_t i, std::size_t j)
  {
    constexpr std::size_t most_rows = 6, most_product = 36;
    const std::size_t m = m_pieces.piece(0, i).degree(), n = m_pieces.piece(1, j).degree();
    return (std::min)(m, n) <= most_rows && m * n <= most_product;
  }

  bool add_inner_points(const std::array<std::size_t, 2>& pieces)
  {
    // the matrix has fewer rows
    const std::size_t k = m_pieces.piece(0, pieces[0]).degree() >= m_pieces.piece(1, pieces[1]).degree() ? 0 : 1;
    if (m_pieces.elimination(k, pieces[k], pieces[1 - k]).is_zero())
      return add_points_on_one_curve(pieces);
    std::vector<Exact_root> others;
    std::optional<std::vector<Inner_point>> points = points_by_roots(k, pieces, others);
    if (!points || (!others.empty() && !add_points_by_other_roots(k, pieces, others, *points)))
      return false;
    return std::all_of(points->begin(), points->end(), [&](Inner_point& point) { return add(point); });
  }

  // Of two pieces on one algebraic curve. What the solver finds at breaks is found there.
  bool add_points_on_one_curve(const std::array<std::size_t, 2>& pieces)
  {
    if (!m_solve_part)
      return false;
    Parameter_box cells;
    for (const std::size_t k : {0, 1})
      cells.push_back(m_pieces.range(k, pieces[k], {Exact_rational(0), Exact_rational(1)}));
    for (Common_point& point : m_solve_part(cells)) {
      const auto is_inside = [&](std::size_t k) {
        return cells[k].first < point.parameters[k].first && point.parameters[k].second < cells[k].second;
      };
      if (point.kind == Intersection_kind::OVERLAP)
        m_overlaps.push_back(std::move(point));
      else if (point.kind != Intersection_kind::UNDECIDED && is_inside(0) && is_inside(1))
        m_points.push_back(std::move(point));
      else if (!point.is_at_end[0] && !point.is_at_end[1])
        return false;
    }
    return true;
  }

  // Those of neighbouring pieces with a common end.
  void join_overlaps()
  {
    for (std::size_t i = 0; i < m_overlaps.size(); ++i)
      for (std::size_t j = 0; j < m_overlaps.size(); ++j)
        if (i != j && go_on(m_overlaps[i].parameters, m_overlaps[j].parameters)) {
          for (const std::size_t k : {0, 1}) {
            Parameter_range& range = m_overlaps[i].parameters[k];
            const Parameter_range& next = m_overlaps[j].parameters[k];
            range = {(std::min)(range.first, next.first), (std::max)(range.second, next.second)};
          }
          m_overlaps[i].solution.reset();
          m_overlaps.erase(m_overlaps.begin() + static_cast<std::ptrdiff_t>(j));
          return join_overlaps();
        }
  }

  bool go_on(const Parameter_box& a, const Parameter_box& b) const
  {
    const Exact_rational &t = a[0].second, &s = a[1].second == b[1].first ? a[1].second : a[1].first;
    return t == b[0].first && (a[1].second == b[1].first || a[1].first == b[1].second) &&
        m_pair[0](std::array{t}) == m_pair[1](std::array{s});
  }

  // By those of one parameter. Others have several partners, or it is not known how many.
  std::optional<std::vector<Inner_point>> points_by_roots(std::size_t k, const std::array<std::size_t, 2>& pieces,
                                                          std::vector<Exact_root>& others)
  {
    Piece_elimination<d>& elimination = m_pieces.elimination(k, pieces[k], pieces[1 - k]);
    if (elimination.is_zero())
      return std::nullopt;
    std::vector<Inner_point> result;
    for (auto& [root, multiplicity] : elimination.inner_roots()) {
      m_pieces.check();
      const std::optional<Partner> partner = elimination.partner(root);
      if (!partner)
        others.push_back(std::move(root));
      else if (partner->place == Partner::Place::INSIDE) {
        std::optional<int> count = multiplicity;
        if (d == 3 && multiplicity > 1)
          count = elimination.multiplicity(root);
        if (!count)
          return std::nullopt;
        result.push_back({pieces, k, std::move(root), *partner, *count});
      }
    }
    return result;
  }

  /*
  Where a root has several partners, these have mostly one each: the points of the other piece whose parameter is one of
  these roots. What could have several partners from both sides is not told.
  */
  bool add_points_by_other_roots(std::size_t k, const std::array<std::size_t, 2>& pieces,
                                 std::vector<Exact_root>& roots, std::vector<Inner_point>& points)
  {
    std::vector<Exact_root> remaining;
    std::optional<std::vector<Inner_point>> others = points_by_roots(1 - k, pieces, remaining);
    if (!others)
      return false;
    for (Exact_root& root : roots)
      for (Exact_root& other : remaining)
        if (!are_apart(k, pieces, root, other))
          return false;
    for (Inner_point& other : *others) {
      const std::optional<bool> is_among_roots = has_parameter_among(other, roots, points);
      if (!is_among_roots)
        return false;
      if (*is_among_roots)
        points.push_back(std::move(other));
    }
    return true;
  }

  // Whether the points of two parameters are different; false where that is not seen.
  bool are_apart(std::size_t k, const std::array<std::size_t, 2>& pieces, Exact_root& root, Exact_root& other)
  {
    constexpr int most_bits = 256;
    for (int bits = 16; bits <= most_bits; bits *= 2) {
      narrow(root, power_of_two(-bits));
      narrow(other, power_of_two(-bits));
      const std::array<const Exact_root*, 2> roots{k == 0 ? &root : &other, k == 0 ? &other : &root};
      std::array<Vector_bounds<d>, 2> places;
      for (const std::size_t i : {0, 1})
        places[i] = m_pair[i].part({m_pieces.range(i, pieces[i], {roots[i]->lower(), roots[i]->upper()})}).values();
      if (Common::are_apart(places[0], places[1]))
        return true;
    }
    return false;
  }

  // Whether the partner of a point is one of some roots, and not that of one of the points; it is one of them.
  std::optional<bool> has_parameter_among(Inner_point& point, std::vector<Exact_root>& roots,
                                          std::vector<Inner_point>& points)
  {
    const Piece_elimination<d>& elimination =
        m_pieces.elimination(point.curve, point.pieces[point.curve], point.pieces[1 - point.curve]);
    constexpr int most_bits = 1 << 12;
    for (int bits = 32; bits <= most_bits; bits *= 2) {
      m_pieces.check();
      const Exact_rational width = power_of_two(-bits);
      narrow(point.root, width);
      const std::optional<Rational_interval> range = elimination.range(point.partner, point.root);
      if (!range)
        continue;
      const auto may_be = [&](Exact_root& root) {
        narrow(root, width);
        return root.lower() <= range->upper && range->lower <= root.upper();
      };
      const bool may_be_among = std::any_of(roots.begin(), roots.end(), may_be),
                 may_be_other = std::any_of(points.begin(), points.end(), [&](Inner_point&other) {
                   return other.curve != point.curve && may_be(other.root);
                 });
      if (!may_be_among || !may_be_other)
        return may_be_among;
    }
    return std::nullopt;
  }

  // With ranges as narrow as those of other answers, inside of the pieces.
  bool add(Inner_point& point)
  {
    const Piece_elimination<d>& elimination =
        m_pieces.elimination(point.curve, point.pieces[point.curve], point.pieces[1 - point.curve]);
    const Exact_rational width = power_of_two(-56);
    constexpr int most_bits = 1 << 14;
    for (int bits = 64; bits <= most_bits; bits *= 2) {
      m_pieces.check();
      narrow(point.root, power_of_two(-bits));
      point.root.settle_on_simplest_rational();
      const std::optional<Rational_interval> partner = elimination.range(point.partner, point.root);
      if (!partner || partner->upper - partner->lower > width || partner->lower <= 0 || partner->upper >= 1 ||
          (!point.root.is_point() && (point.root.lower() == 0 || point.root.upper() == 1)))
        continue;
      Parameter_box box(2);
      box[point.curve] =
          m_pieces.range(point.curve, point.pieces[point.curve], {point.root.lower(), point.root.upper()});
      box[1 - point.curve] = m_pieces.range(1 - point.curve, point.pieces[1 - point.curve], *partner);
      Common_point result{point.multiplicity == 1 ? Intersection_kind::TRANSVERSAL : Intersection_kind::TANGENT,
                          std::move(box),
                          {false, false},
                          std::nullopt,
                          false,
                          point.multiplicity};
      if (d == 2)
        result.passage = point.multiplicity % 2 != 0 ? Passage::CROSSES : Passage::TOUCHES;
      m_points.push_back(std::move(result));
      return true;
    }
    return false;
  }

  bool add_points_at_breaks()
  {
    Points_at_breaks<d> at_breaks(m_pieces);
    for (Places& places : at_breaks.places(m_pair.domain())) {
      m_pieces.check();
      for (Place_on_curve& place : places)
        if (!place.is_break()) {
          narrow(place.root, power_of_two(-64));
          place.root.settle_on_simplest_rational();
        }
      if (is_on_overlap({m_pieces.range(0, places[0]), m_pieces.range(1, places[1])}))
        continue;
      std::optional<int> multiplicity = at_breaks.multiplicity(places);
      if (!multiplicity && !at_breaks.is_end(places) && !m_overlaps.empty())
        multiplicity = 0; // some of the pieces are on one curve, but do not overlap
      if (!multiplicity)
        return false;
      m_points.push_back(point_at_breaks(at_breaks, m_pieces, places, *multiplicity));
    }
    return true;
  }

  bool is_on_overlap(const Parameter_box& point) const
  {
    return std::any_of(m_overlaps.begin(), m_overlaps.end(),
                       [&](const Common_point& overlap) { return is_part_of(point, overlap.parameters); });
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_ELIMINATED_POINTS_H
