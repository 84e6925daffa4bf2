// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_LOCUS_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_LOCUS_SYSTEM_H

#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

template <int d>
using Coordinate_ranges = std::array<std::pair<double, double>, d>;

// Bounds of the coordinates of a point with unknowns in a box, which may reach over their ranges; rounded outwards,
// infinite where there are none.
template <int d>
Coordinate_ranges<d> coordinate_ranges(const Vector_expression<d>& point, const std::vector<Unknown>& unknowns,
                                       Unknown_domains box)
{
  for (std::size_t k = 0; k < box.size(); ++k) {
    const auto& [lower, upper] = unknowns[k].domain();
    box[k] = {(std::min)((std::max)(box[k].first, lower), upper), (std::max)((std::min)(box[k].second, upper), lower)};
  }
  Coordinate_ranges<d> result;
  for (int i = 0; i < d; ++i) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto range = bounds(point[i], box);
    result[i] = range ? std::pair(to_double_interval(range->first).first, to_double_interval(range->second).second)
                      : std::pair(-infinity, infinity);
  }
  return result;
}

/*
The constraints of a common point of pieces. It is written as the formula of one of them, the carrier, and incident with
the others; where none has a formula, its coordinates are unknowns. So auxiliary unknowns are needed for the carrier
only.
*/
template <int d>
class Locus_system
{
  std::vector<Unknown> m_unknowns;
  std::vector<std::size_t> m_first_unknown;   // per piece
  std::optional<Vector_expression<d>> m_point;
  std::vector<Constraint> m_constraints;

public:
  explicit Locus_system(const std::vector<Locus_piece<d>>& pieces)
  {
    const std::size_t carrier = carrier_among(pieces);
    const bool has_carrier = carrier < pieces.size();
    Unknown_domains ranges;
    for (const Locus_piece<d>& piece : pieces) {
      m_first_unknown.push_back(ranges.size());
      ranges.insert(ranges.end(), piece.parameters.begin(), piece.parameters.end());
    }
    const std::size_t count = ranges.size();
    const Unknown_domains others = has_carrier ? pieces[carrier].auxiliaries : common_box(pieces);
    ranges.insert(ranges.end(), others.begin(), others.end());
    if (std::any_of(ranges.begin(), ranges.end(), [](const auto& range) { return range.second < range.first; }))
      return;   // boxes that do not meet
    if (!ranges.empty())
      m_unknowns = unknowns_in(ranges);

    if (has_carrier) {
      std::vector<Unknown> u = parameters_of(pieces, carrier);
      u.insert(u.end(), m_unknowns.begin() + count, m_unknowns.end());
      m_point = pieces[carrier].point(u);
      if (pieces[carrier].constraints)
        add(pieces[carrier].constraints(u));
    } else
      m_point = vector_of<d>([&](std::size_t i) { return m_unknowns[i]; });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::vector<Unknown> u = parameters_of(pieces, i);
      if (i != carrier)
        add(pieces[i].incidence(*m_point, u));
      for (std::size_t axis = 0; axis < u.size(); ++axis)
        if (pieces[i].is_without_end[axis])
          add({u[axis] < pieces[i].parameters[axis].second});
      if (has_carrier)
        add_box(pieces[i].box);
    }
    remove_trivial_equations();
  }

  // Whether boxes do not meet: then there are no constraints, and nothing satisfies them.
  bool is_void() const { return !m_point; }

  const std::vector<Unknown>& unknowns() const { return m_unknowns; }
  const std::vector<Constraint>& constraints() const { return m_constraints; }

  // The place of the first parameter of a piece among the unknowns.
  std::size_t first_unknown(std::size_t piece) const { return m_first_unknown[piece]; }

  // Bounds of the coordinates of the points with unknowns in a box.
  Coordinate_ranges<d> coordinates(const Unknown_domains& box) const
  {
    return coordinate_ranges<d>(*m_point, m_unknowns, box);
  }

private:
  // The one with fewest auxiliary unknowns; the number of pieces when none has a formula.
  static std::size_t carrier_among(const std::vector<Locus_piece<d>>& pieces)
  {
    std::size_t result = pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].point &&
          (result == pieces.size() || pieces[i].auxiliaries.size() < pieces[result].auxiliaries.size()))
        result = i;
    return result;
  }

  static Unknown_domains common_box(const std::vector<Locus_piece<d>>& pieces)
  {
    Unknown_domains result;
    for (const Locus_piece<d>& piece : pieces)
      for (std::size_t i = 0; i < piece.box.size(); ++i)
        if (result.size() <= i)
          result.push_back(piece.box[i]);
        else
          result[i] = {(std::max)(result[i].first, piece.box[i].first),
                       (std::min)(result[i].second, piece.box[i].second)};
    return result;
  }

  std::vector<Unknown> parameters_of(const std::vector<Locus_piece<d>>& pieces, std::size_t i) const
  {
    return {m_unknowns.begin() + m_first_unknown[i],
            m_unknowns.begin() + m_first_unknown[i] + pieces[i].parameters.size()};
  }

  void add(const std::vector<Constraint>& constraints)
  {
    m_constraints.insert(m_constraints.end(), constraints.begin(), constraints.end());
  }

  // That the point is in the box, unless it always is.
  void add_box(const Unknown_domains& box)
  {
    Unknown_domains all;
    for (const Unknown& u : m_unknowns)
      all.push_back(u.domain());
    for (std::size_t i = 0; i < box.size(); ++i) {
      const auto range = bounds((*m_point)[i], all);
      if (!range || range->first < box[i].first)
        add({(*m_point)[i] >= box[i].first});
      if (!range || box[i].second < range->second)
        add({(*m_point)[i] <= box[i].second});
    }
  }

  // Those that are satisfied anyway, unless there would be too few equations then.
  void remove_trivial_equations()
  {
    std::size_t count = std::count_if(m_constraints.begin(), m_constraints.end(),
                                      [](const Constraint& c) { return c.relation == Relation::EQUAL; });
    const auto is_removed = [&](const Constraint& c) {
      return c.relation == Relation::EQUAL && c.function.is_zero() && count > m_unknowns.size() && count-- > 0;
    };
    std::erase_if(m_constraints, is_removed);
  }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_LOCUS_SYSTEM_H
