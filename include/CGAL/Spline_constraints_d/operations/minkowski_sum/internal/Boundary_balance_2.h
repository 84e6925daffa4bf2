// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_BOUNDARY_BALANCE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_BOUNDARY_BALANCE_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
Which curves between vertices are boundaries of a region that is on the left of these, as far as it follows from what is
known of others: the boundary of a region is made of cycles, so as many of its curves end in each vertex as begin there.
What ends where nothing begins is no boundary.

A vertex may stand for several points that are not told apart, with all that is between them.
*/
class Boundary_balance_2
{
  struct Curve
  {
    std::array<std::size_t, 2> vertices;
    std::optional<bool> is_boundary{};
  };

  std::vector<Curve> m_curves;
  // of each vertex, the curves that begin there and those that end
  std::map<std::size_t, std::array<std::vector<std::size_t>, 2>> m_stars;
  std::set<std::size_t> m_exceptions;

public:
  // Curves by the vertices at their begins and ends, and vertices where there may be others.
  Boundary_balance_2(const std::vector<std::array<std::size_t, 2>>& curves, std::set<std::size_t> exceptions)
    : m_exceptions(std::move(exceptions))
  {
    for (const std::array<std::size_t, 2>& vertices : curves) {
      for (const std::size_t e : {0, 1})
        if (vertices[0] != vertices[1])   // a closed one is balanced
          m_stars[vertices[e]][e].push_back(m_curves.size());
      m_curves.push_back({vertices});
    }
    std::vector<std::size_t> all;
    for (const auto& [vertex, star] : m_stars)
      all.push_back(vertex);
    conclude_at(std::move(all));
  }

  // Whether a curve is a boundary, if that is known.
  std::optional<bool> is_boundary(std::size_t curve) const { return m_curves[curve].is_boundary; }

  void set(std::size_t curve, bool is_boundary)
  {
    m_curves[curve].is_boundary = is_boundary;
    conclude_at({m_curves[curve].vertices[0], m_curves[curve].vertices[1]});
  }

private:
  // Settles what follows at some vertices, and then at others.
  void conclude_at(std::vector<std::size_t> vertices)
  {
    while (!vertices.empty()) {
      const std::size_t vertex = vertices.back();
      vertices.pop_back();
      const auto star = m_stars.find(vertex);
      if (star == m_stars.end() || m_exceptions.contains(vertex))
        continue;
      const auto& [begins, ends] = star->second;
      const auto [beginning, may_begin] = numbers(begins);
      const auto [ending, may_end] = numbers(ends);
      if (may_begin + may_end > 0 && ending + may_end == beginning)   // even if all end here that may
        settle(ends, true, begins, false, vertices);
      else if (may_begin + may_end > 0 && ending == beginning + may_begin)
        settle(ends, false, begins, true, vertices);
    }
  }

  // How many are boundaries, and how many others may be.
  std::pair<std::size_t, std::size_t> numbers(const std::vector<std::size_t>& curves) const
  {
    std::pair<std::size_t, std::size_t> result{0, 0};
    for (const std::size_t i : curves)
      if (!m_curves[i].is_boundary)
        ++result.second;
      else if (*m_curves[i].is_boundary)
        ++result.first;
    return result;
  }

  void settle(const std::vector<std::size_t>& ends, bool are_ends_boundaries, const std::vector<std::size_t>& begins,
              bool are_begins_boundaries, std::vector<std::size_t>& vertices)
  {
    for (const auto& [curves, value] :
         {std::pair(&ends, are_ends_boundaries), std::pair(&begins, are_begins_boundaries)})
      for (const std::size_t i : *curves)
        if (Curve& curve = m_curves[i]; !curve.is_boundary) {
          curve.is_boundary = value;
          vertices.insert(vertices.end(), curve.vertices.begin(), curve.vertices.end());
        }
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_BOUNDARY_BALANCE_2_H
