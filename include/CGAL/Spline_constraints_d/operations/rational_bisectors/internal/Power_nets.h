// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_POWER_NETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_POWER_NETS_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

using Parameter_rectangle = std::array<std::array<double, 2>, 2>;

// A box of parameters of a piece.
struct Part_of_piece
{
  std::size_t piece;
  Parameter_rectangle box;
};

// The powers of points of the pieces of a surface, or of a curve, with respect to one ball.
class Power_nets
{
  using Interval = CGAL::Interval_nt<false>;

  std::vector<std::vector<Interval_net>> m_products; // of the pieces: <X,X>, w X, w^2

public:
  //! \pre rounding is upwards, here and below.
  explicit Power_nets(const std::vector<Polynomial_piece>& pieces)
  {
    for (const Polynomial_piece& piece : pieces) {
      const Polynomial_vector x = piece.numerators();
      const Power_polynomial& w = piece.weight();
      auto& products = m_products.emplace_back();
      for (const Tensor& f : tensors_of({dot(x, x), w * x[0], w * x[1], w * x[2], w * w}))
        products.emplace_back(f);
    }
  }

  // The sign of the least power of points of a part, zero if it is not known. Upper bounds of it, times squared
  // weights, make `least` less.
  int sign_of_power(const Part_of_piece& part, const Touching_ball& ball, double& least) const
  {
    constexpr std::size_t most_parts = 2000;
    const Parameter_rectangle& box = part.box;
    std::vector<Interval_net> open{
        power(part.piece, ball).restricted(0, box[0][0], box[0][1]).restricted(1, box[1][0], box[1][1])};
    for (std::size_t count = 0; !open.empty(); ++count) {
      if (count > most_parts)
        return 0;
      const Interval_net own = std::move(open.back());
      open.pop_back();
      const double upper = own.least_corner();
      least = (std::min)(least, upper);
      if (upper < 0)
        return -1;
      if (own.bounds().inf() > 0)
        continue;
      for (const double a : {0., 0.5}) {
        const Interval_net half = own.restricted(0, a, a + 0.5);
        if (own.degree(1) == 0)
          open.push_back(half);
        else
          for (const double b : {0., 0.5})
            open.push_back(half.restricted(1, b, b + 0.5));
      }
    }
    return 1;
  }

private:
  // The squared distance of points X / w from the center P of a ball minus its squared radius, times w^2:
  // <X,X> - 2 <P, w X> + (<P,P> - x^2) w^2. There is one ball, up to rounding.
  Interval_net power(std::size_t piece, const Touching_ball& ball) const
  {
    const std::vector<Interval_net>& products = m_products[piece];
    Interval_net result = products[0];
    result.add(dot(ball.center, ball.center) - CGAL::square(ball.x), products[4]);
    for (const std::size_t c : {0, 1, 2})
      result.add(Interval(-2) * ball.center[c], products[c + 1]);
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_POWER_NETS_H
