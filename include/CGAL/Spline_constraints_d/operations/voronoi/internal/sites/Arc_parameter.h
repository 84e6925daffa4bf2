// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ARC_PARAMETER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ARC_PARAMETER_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The parameter of an arc, which runs from 0 to 1 on it, and that of its piece, which ends exactly there or, where curves
cross at parameters that are not rational, nearby; and that of the piece before it was cut. All ranges hold the exact
values.
*/
class Arc_parameter
{
  const Homogeneous_piece& m_piece;
  Interval m_begin, m_end;   // of the arc, in the parameter of its piece

public:
  template <Enclosing_number Number>
  Arc_parameter(const Site_graph_2<Number>& graph, std::size_t arc) : m_piece(graph.arcs()[arc].piece())
  {
    const double error = interval_of<Interval>(graph.arcs()[arc].error()).sup();
    const auto end = [&](bool is_end) {
      return Interval(is_end ? 1 : 0) + (graph.is_exact({arc, is_end}) ? Interval(0) : Interval(-error, error));
    };
    m_begin = end(false);
    m_end = end(true);
  }

  Interval to_piece(const Interval& t) const { return m_begin + t * (m_end - m_begin); }
  Interval from_piece(const Interval& s) const { return (s - m_begin) / (m_end - m_begin); }

  Interval to_uncut(const Interval& t) const
  {
    return m_piece.whole ? first() + to_piece(t) * (last() - first()) : to_piece(t);
  }
  Interval from_uncut(const Interval& s) const
  {
    return from_piece(m_piece.whole ? (s - first()) / (last() - first()) : s);
  }

  // A range of the parameter of the piece which is within one of that of the arc.
  std::optional<Range> range_of_piece_within(const Range& range) const
  {
    const double begin = to_piece(Interval(range.begin)).sup(), end = to_piece(Interval(range.end)).inf();
    return begin <= end ? std::optional(Range{begin, end}) : std::nullopt;
  }

  // The simplest number in that range.
  std::optional<Exact_rational> simplest_of_piece_within(const Range& range) const
  {
    const auto inside = range_of_piece_within(range);
    return inside ? std::optional(simplest_rational_between(Exact_rational(inside->begin), Exact_rational(inside->end)))
                  : std::nullopt;
  }

private:
  // The ends of the piece, in the parameter of the one before it was cut.
  Interval place(const Exact_rational& x) const
  {
    return interval_of<Interval>(
        Exact_rational((x - m_piece.whole->first) / (m_piece.whole->second - m_piece.whole->first)));
  }
  Interval first() const { return place(m_piece.domain.first); }
  Interval last() const { return place(m_piece.domain.second); }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ARC_PARAMETER_H
