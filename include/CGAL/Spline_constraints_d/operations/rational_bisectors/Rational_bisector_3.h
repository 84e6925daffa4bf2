// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_3_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_piece_3.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

A rational bisector in space, untrimmed, with exact coefficients: one piece for each pair of polynomial pieces of the
operands, by increasing parameters, those of the second one fastest.
*/
class Rational_bisector_3
{
public:
  //! the kernel of points and surfaces.
  using Kernel = Rational_bisector_piece_3::Kernel;
  //! a range of a parameter.
  using Range = Rational_bisector_piece_3::Range;

private:
  std::vector<Rational_bisector_piece_3> m_pieces;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what an operation has found.
  Rational_bisector_3(std::vector<Rational_bisector_piece_3> pieces, std::vector<Undecided_part> undecided,
                      const Summary& work)
    : m_pieces(std::move(pieces)), m_undecided(std::move(undecided)), m_summary(work)
  {
    m_summary.is_complete = m_undecided.empty();
  }

  //! the pieces.
  const std::vector<Rational_bisector_piece_3>& pieces() const { return m_pieces; }

  //! whether all pieces are there, which only a limit or a visitor prevents.
  bool is_complete() const { return m_summary.is_complete; }

  //! the pairs of pieces of the operands whose bisector was not computed.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work: its nodes are pieces.
  const Summary& summary() const { return m_summary; }

  //! the largest degree of a piece in a parameter.
  int degree(int axis) const;

  //! whether all pieces are there and this is proved for each. \sa Rational_bisector_piece_3::is_free_of_poles()
  bool is_free_of_poles() const
  {
    return is_complete() && std::ranges::all_of(m_pieces, [](const auto& piece) { return piece.is_free_of_poles(); });
  }

  //! the point at parameters. \throws Invalid_input when they are outside of all pieces, or at a pole.
  Kernel::Point_3 point(const Exact_rational& u, const Exact_rational& v) const
  {
    return piece_with({Range(u, u), Range(v, v)}).point(u, v);
  }

  //! the foot on operand 0 or 1 at parameters. \throws Invalid_input when they are outside of all pieces.
  Kernel::Point_3 foot(int operand, const Exact_rational& u, const Exact_rational& v) const
  {
    return piece_with({Range(u, u), Range(v, v)}).foot(operand, u, v);
  }

  /*!
  the part over a box of parameters, as a surface with the same parameters.
  \throws Invalid_input when the box is empty or not within the domain of one piece, or it is not proved that the weight
  has no zero there.
  */
  Bspline_surface_3<Kernel> part(const std::array<Range, 2>& box) const { return piece_with(box).part(box); }

private:
  const Rational_bisector_piece_3& piece_with(const std::array<Range, 2>& box) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE int Rational_bisector_3::degree(int axis) const
{
  int result = 0;
  for (const Rational_bisector_piece_3& piece : m_pieces)
    result = (std::max)(result, piece.degree(axis));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Rational_bisector_piece_3&
Rational_bisector_3::piece_with(const std::array<Range, 2>& box) const
{
  const auto contains_box = [&](const Rational_bisector_piece_3& piece) {
    const auto contains = [&](int axis) {
      const auto& [begin, end] = piece.domain()[axis];
      return begin <= box[axis].first && box[axis].second <= end;
    };
    return contains(0) && contains(1);
  };
  const auto position = std::ranges::find_if(m_pieces, contains_box);
  if (position == m_pieces.end())
    throw Invalid_input("Rational_bisector_3: parameters that are not within one piece");
  return *position;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_3_H
