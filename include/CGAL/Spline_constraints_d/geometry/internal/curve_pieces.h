// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_CURVE_PIECES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_CURVE_PIECES_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Planar_map = Spline_map<1, 2>;
using Exact_pair = Exact_vector<2>;

inline int sign_of(const Exact_rational& x) { return static_cast<int>(CGAL::sign(x)); }

// A part of a curve, with some of its derivatives.
class Differentiated_map
{
  std::vector<Planar_map> m_derivatives;

public:
  Differentiated_map(Planar_map map, int order);

  // With a multiple of the derivative in its place.
  Differentiated_map with_tangent(Planar_map tangent) const;

  const Planar_map& map() const { return m_derivatives[0]; }
  int order() const { return static_cast<int>(m_derivatives.size()) - 1; }
  const Exact_rational& begin() const { return map().domain(0).first; }
  const Exact_rational& end() const { return map().domain(0).second; }

  Vector_expression<2> operator()(int order, const Unknown& u) const { return m_derivatives[order](u); }
  Exact_pair at(int order, const Exact_rational& t) const
  {
    return m_derivatives[order](std::array<Exact_rational, 1>{t});
  }
};

// The parts between successive breaks, where all derivatives exist.
std::vector<Differentiated_map> polynomial_pieces(const Planar_map& curve, int order);

inline bool are_codirectional(const Exact_pair& a, const Exact_pair& b)
{
  return sign_of(exact_cross(a, b)) == 0 && sign_of(exact_dot(a, b)) > 0;
}

// Whether one part goes on in the direction in which the other one ends.
inline bool have_common_tangent(const Differentiated_map& before, const Differentiated_map& after)
{
  return are_codirectional(before.at(1, before.end()), after.at(1, after.begin()));
}

// A part with a continuous derivative. Where the next part goes on in the same direction, its end is the begin of that
// one, and counts there.
struct Smooth_part
{
  Differentiated_map curve;
  bool has_end;
};

inline bool has_same_derivative(const Differentiated_map& before, const Differentiated_map& after)
{
  return before.at(1, before.end()) == after.at(1, after.begin());
}

// The parts of a curve, cut at breaks by a predicate. Single polynomials where it is never true.
template <class Joins>
std::vector<Smooth_part> smooth_parts(const Planar_map& curve, const Joins& joins)
{
  const std::vector<Differentiated_map> pieces = polynomial_pieces(curve, 1);
  std::vector<Smooth_part> result;
  for (std::size_t first = 0, last = 0; first < pieces.size(); first = ++last) {
    while (last + 1 < pieces.size() && joins(pieces[last], pieces[last + 1]))
      ++last;
    const bool is_last = last + 1 == pieces.size();
    const bool goes_on = is_last ? curve.is_closed() && have_common_tangent(pieces.back(), pieces.front())
                                 : have_common_tangent(pieces[last], pieces[last + 1]);
    result.push_back({Differentiated_map(curve.restricted(0, pieces[first].begin(), pieces[last].end()), 1), !goes_on});
  }
  return result;
}

inline std::vector<Smooth_part> smooth_parts(const Planar_map& curve)
{
  return smooth_parts(curve, has_same_derivative);
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Differentiated_map::Differentiated_map(Planar_map map, int order)
{
  m_derivatives.push_back(std::move(map));
  for (int k = 0; k < order; ++k)
    m_derivatives.push_back(derivative(m_derivatives.back()));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Differentiated_map Differentiated_map::with_tangent(Planar_map tangent) const
{
  Differentiated_map result(*this);
  result.m_derivatives[1] = std::move(tangent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Differentiated_map> polynomial_pieces(const Planar_map& curve, int order)
{
  const std::vector<Exact_rational> breaks = curve.breaks(0);
  std::vector<Differentiated_map> result;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    result.emplace_back(curve.restricted(0, breaks[i - 1], breaks[i]), order);
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_CURVE_PIECES_H
