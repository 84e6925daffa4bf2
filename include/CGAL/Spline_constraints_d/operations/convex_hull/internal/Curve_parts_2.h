// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_CURVE_PARTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_CURVE_PARTS_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

/*
Curves as pieces with positive weights: their points, and their parts between parameters.
*/
class Curve_parts_2
{
public:
  using Pieces = std::vector<Hull_piece_2>;

private:
  std::vector<Pieces> m_pieces;   // of each curve

public:
  Curve_parts_2() = default;

  // Of curves, each of which is given as its pieces.
  // \throws Run_stopped
  Curve_parts_2(const std::vector<std::vector<Boundary_piece>>& curves, Run_of_steps& run);

  const std::vector<Pieces>& pieces() const { return m_pieces; }
  std::size_t number_of_curves() const { return m_pieces.size(); }

  Exact_pair point(std::size_t curve, const Exact_rational& parameter) const;

  // A part of a curve, run backwards if parameters decrease.
  Pieces between(std::size_t curve, const Exact_rational& from, const Exact_rational& to) const;

  // Appends points of a part after its begin, so that no point of it is farther from the chords between them than the
  // error, but for the rounding of coordinates.
  template <class Kernel>
  void append_samples(std::size_t curve, const Exact_rational& from, const Exact_rational& to,
                      const Exact_rational& error, std::vector<typename Kernel::Point_2>& samples) const
  {
    for (const Hull_piece_2& piece : between(curve, from, to))
      append_samples_of<Kernel>(piece, error, samples);
  }

  /*
  For the area between a point and an arc of which the ends are known to be in ranges, and which runs counterclockwise
  around the point, or clockwise within the ranges: appends what is certainly part of the arc, with the point as the
  origin, and adds bounds of the rest.
  */
  void append_sector(std::size_t curve, const Parameter_range& source, const Parameter_range& target,
                     const Exact_pair& origin, std::vector<Boundary_piece>& arcs, Rational_interval& rest) const;

private:
  static Boundary_piece seen_from(const Exact_pair& origin, Boundary_piece piece);

  template <class Kernel>
  static void append_samples_of(const Hull_piece_2& piece, const Exact_rational& error,
                                std::vector<typename Kernel::Point_2>& samples)
  {
    const Exact_pair chord = exact_difference(piece.end(), piece.begin());
    const Exact_rational squared_length = exact_dot(chord, chord);
    const bool is_close = std::all_of(piece.points().begin(), piece.points().end(), [&](const Exact_pair& point) {
      const Exact_pair arm = exact_difference(point, piece.begin());
      const Exact_rational height = exact_cross(chord, arm), along = exact_dot(chord, arm);
      return height * height <= error * error * squared_length && along >= 0 && along <= squared_length;
    });
    if (is_close)
      samples.push_back(kernel_object<Kernel, typename Kernel::Point_2>(piece.end()));
    else
      for (const Hull_piece_2& half : piece.parts({one_half()}))
        append_samples_of<Kernel>(half, error, samples);
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Curve_parts_2::Curve_parts_2(const std::vector<std::vector<Boundary_piece>>& curves,
                                                            Run_of_steps& run)
{
  for (const std::vector<Boundary_piece>& curve : curves) {
    m_pieces.emplace_back();
    for (const Boundary_piece& piece : curve) {
      run.check();
      append_hull_pieces(piece, m_pieces.back());
    }
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Curve_parts_2::point(std::size_t curve, const Exact_rational& parameter) const
{
  const auto piece = std::find_if(m_pieces[curve].begin(), m_pieces[curve].end() - 1,
                                  [&](const Hull_piece_2& p) { return parameter <= p.curve().parameters[1]; });
  const auto& [begin, end] = piece->curve().parameters;
  return piece->curve().at(Exact_rational((parameter - begin) / (end - begin)));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Curve_parts_2::Pieces
Curve_parts_2::between(std::size_t curve, const Exact_rational& from, const Exact_rational& to) const
{
  Pieces result;
  for (const Hull_piece_2& piece : m_pieces[curve]) {
    const auto& [begin, end] = piece.curve().parameters;
    const Exact_rational lower = (std::max)(begin, (std::min)(from, to)), upper = (std::min)(end, (std::max)(from, to));
    if (!(lower < upper))
      continue;
    result.emplace_back(restricted(piece.curve(), Exact_rational((lower - begin) / (end - begin)),
                                   Exact_rational((upper - begin) / (end - begin))));
  }
  if (to < from) {
    std::reverse(result.begin(), result.end());
    for (Hull_piece_2& piece : result)
      piece = piece.reversed();
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void
Curve_parts_2::append_sector(std::size_t curve, const Parameter_range& source, const Parameter_range& target,
                             const Exact_pair& origin, std::vector<Boundary_piece>& arcs, Rational_interval& rest) const
{
  const bool is_reversed = target < source;
  for (const Hull_piece_2& piece :
       between(curve, is_reversed ? source.first : source.second, is_reversed ? target.second : target.first))
    arcs.push_back(seen_from(origin, piece.curve()));
  for (const auto& [first, last] : {source, target})
    for (const Hull_piece_2& part : between(curve, first, last)) {
      const Boundary_piece piece = seen_from(origin, part.curve());
      const auto& [x, y, w] = piece.coordinates;
      const auto [least, greatest] = (x * y.derivative(0) - y * x.derivative(0)).bounds();
      const Exact_rational weight = w.bounds().first;
      rest.upper += (std::max)(CGAL::abs(least), CGAL::abs(greatest)) / (2 * weight * weight);
    }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Boundary_piece Curve_parts_2::seen_from(const Exact_pair& origin, Boundary_piece piece)
{
  for (std::size_t k = 0; k < 2; ++k)
    piece.coordinates[k] -= piece.coordinates[2] * origin[k];
  return piece;
}
#endif

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_CURVE_PARTS_2_H
