// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_DISTANCE_DERIVATIVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_DISTANCE_DERIVATIVES_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Power_nets.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
Second derivatives of squared distances from the points of a surface S(u, v).

The matrix of those of half of |S - P|^2 by the parameters has the entries <S_u,S_u> + <S - P,S_uu> and so on. Where it
is positive definite on a rectangle of parameters, the distance is strictly convex there. If its derivatives are zero at
a foot of P, this is nearer than all other points of the rectangle, which does not need what lies beyond edges.
*/
class Distance_derivatives
{
  using Interval = CGAL::Interval_nt<false>;

  // Of coordinates, with their denominators.
  struct Piece
  {
    std::array<std::vector<Interval_net>, 2> first;
    std::array<std::vector<Interval_net>, 3> second; // uu, uv, vv
  };

  std::vector<Piece> m_pieces;

public:
  // Over a part of a piece.
  struct Bounds
  {
    std::array<Interval_vector, 2> first;
    std::array<Interval_vector, 3> second;
  };

  //! \pre rounding is upwards, here and below.
  explicit Distance_derivatives(const std::vector<Polynomial_piece>& surface)
  {
    for (const Polynomial_piece& piece : surface)
      m_pieces.push_back(nets_of(piece));
  }

  Bounds bounds(const Part_of_piece& part) const
  {
    const Piece& piece = m_pieces[part.piece];
    const auto quotients = [&](const std::vector<Interval_net>& nets) {
      std::vector<Interval_net> own;
      for (const Interval_net& net : nets)
        own.push_back(net.restricted(0, part.box[0][0], part.box[0][1]).restricted(1, part.box[1][0], part.box[1][1]));
      return Foot_grid::hull_of_quotients(own);
    };
    return {{quotients(piece.first[0]), quotients(piece.first[1])},
            {quotients(piece.second[0]), quotients(piece.second[1]), quotients(piece.second[2])}};
  }

  // On a part with points in a box.
  static bool is_convex(const Bounds& own, const Interval_vector& points, const Interval_vector& center)
  {
    const Interval_vector way = combination(points, Interval(-1), center);
    const auto squared = [](const Interval_vector& a) {
      return CGAL::square(a[0]) + CGAL::square(a[1]) + CGAL::square(a[2]);
    };
    const Interval uu = squared(own.first[0]) + dot(way, own.second[0]),
                   uv = dot(own.first[0], own.first[1]) + dot(way, own.second[1]),
                   vv = squared(own.first[1]) + dot(way, own.second[2]);
    return uu.inf() > 0 && (uu * vv - CGAL::square(uv)).inf() > 0;
  }

private:
  static Piece nets_of(const Polynomial_piece& piece)
  {
    const Power_polynomial& w = piece.weight();
    const auto nets = [](const Homogeneous_polynomials& list) {
      const std::vector<Tensor> tensors = tensors_of(list);
      return std::vector<Interval_net>(tensors.begin(), tensors.end());
    };
    Piece result;
    for (const int axis : {0, 1}) {
      // numerators of X / w, over w^2 and w^3
      Homogeneous_polynomials once;
      for (const Power_polynomial& x : piece.numerators())
        once.push_back(w * x.derivative(axis) - w.derivative(axis) * x);
      for (int other = axis; other <= 1; ++other) {
        Homogeneous_polynomials twice;
        for (const Power_polynomial& x : once)
          twice.push_back(w * x.derivative(other) - Power_polynomial(2) * w.derivative(other) * x);
        twice.push_back(w * w * w);
        result.second[static_cast<std::size_t>(axis + other)] = nets(twice);
      }
      once.push_back(w * w);
      result.first[static_cast<std::size_t>(axis)] = nets(once);
    }
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_DISTANCE_DERIVATIVES_H
