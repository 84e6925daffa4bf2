// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_PIECE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_PIECE_2_H

#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

inline Exact_pair sum(const Exact_pair& a, const Exact_pair& b)
{
  return {Exact_rational(a[0] + b[0]), Exact_rational(a[1] + b[1])};
}
inline Exact_pair normal_on_the_right(const Exact_pair& v) { return {v[1], Exact_rational(-v[0])}; }

// Of length one where that is the sum of the coordinates without signs.
inline Exact_pair scaled(const Exact_pair& v)
{
  const Exact_rational length = CGAL::abs(v[0]) + CGAL::abs(v[1]);
  return length == 0 ? v : Exact_pair{Exact_rational(v[0] / length), Exact_rational(v[1] / length)};
}

inline Interval_pair enclosed(const Exact_pair& point) { return {interval_of(point[0]), interval_of(point[1])}; }

Boundary_piece restricted(Boundary_piece piece, const Exact_rational& begin, const Exact_rational& end);

inline Exact_rational one_half() { return Exact_rational(1) / 2; }

// A piece of a curve whose weights are positive, so that it lies in the convex hull of its control points.
class Hull_piece_2
{
  Boundary_piece m_curve;
  int m_halvings;
  std::vector<Exact_pair> m_points;
  std::vector<Interval_pair> m_boxes;

public:
  explicit Hull_piece_2(Boundary_piece curve, int halvings = 0);

  const Boundary_piece& curve() const { return m_curve; }
  int halvings() const { return m_halvings; }

  // The control points, each different from the one before, and boxes around them.
  const std::vector<Exact_pair>& points() const { return m_points; }
  const std::vector<Interval_pair>& boxes() const { return m_boxes; }
  const Exact_pair& begin() const { return m_points.front(); }
  const Exact_pair& end() const { return m_points.back(); }

  bool is_same(const Hull_piece_2& other) const
  {
    return m_points == other.m_points && m_curve.coordinates == other.m_curve.coordinates;
  }

  Hull_piece_2 reversed() const { return Hull_piece_2(m_curve.reversed(), m_halvings); }

  // The parts between parameters of (0,1).
  std::vector<Hull_piece_2> parts(const std::set<Exact_rational>& cuts) const;
};

// Cut until all weights are positive, as the weight of a curve is.
void append_hull_pieces(const Boundary_piece& piece, std::vector<Hull_piece_2>& pieces);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Boundary_piece restricted(Boundary_piece piece, const Exact_rational& begin,
                                                         const Exact_rational& end)
{
  for (Exact_tensor& tensor : piece.coordinates)
    tensor = tensor.restricted(0, begin, end);
  const auto [first, last] = piece.parameters;
  piece.parameters = {Exact_rational(first + begin * (last - first)), Exact_rational(first + end * (last - first))};
  return piece;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Hull_piece_2::Hull_piece_2(Boundary_piece curve, int halvings)
  : m_curve(std::move(curve)), m_halvings(halvings)
{
  const auto& [x, y, w] = m_curve.coordinates;
  for (std::size_t i = 0; i < w.coefficients().size(); ++i) {
    Exact_pair point{Exact_rational(x.coefficients()[i] / w.coefficients()[i]),
                     Exact_rational(y.coefficients()[i] / w.coefficients()[i])};
    if (m_points.empty() || point != m_points.back())
      m_points.push_back(std::move(point));
  }
  for (const Exact_pair& point : m_points)
    m_boxes.push_back(enclosed(point));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Hull_piece_2> Hull_piece_2::parts(const std::set<Exact_rational>& cuts) const
{
  std::vector<Hull_piece_2> result;
  Exact_rational begin(0);
  for (auto cut = cuts.begin(); begin < 1; ++cut) {
    const Exact_rational end = cut != cuts.end() ? *cut : Exact_rational(1);
    result.emplace_back(restricted(m_curve, begin, end), m_halvings + 1);
    begin = end;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void append_hull_pieces(const Boundary_piece& piece, std::vector<Hull_piece_2>& pieces)
{
  if (piece.coordinates[2].bounds().first > 0)
    pieces.emplace_back(piece);
  else
    for (int half = 0; half < 2; ++half)
      append_hull_pieces(restricted(piece, half * one_half(), (half + 1) * one_half()), pieces);
}
#endif

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_PIECE_2_H
