// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_IMPLICIT_HYPERSURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_IMPLICIT_HYPERSURFACE_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/substitution.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

An implicit algebraic curve \f$f(x,y) = 0\f$ in the plane or surface \f$f(x,y,z) = 0\f$ in space, within a closed box:
its points are the zeros of an exact polynomial there. `Implicit_curve_2` and `Implicit_surface_3` are names for the
two.

\code
auto [x, y] = SC::unknowns({-3, 3}, {-2, 2});
SC::Implicit_curve_2 ellipse(x*x/4 + y*y == 1);
auto [u] = SC::parameters(c);
auto crossings = SC::solve(ellipse(SC::Spline_map(c)(u)) == 0);
\endcode

\tparam d 2 or 3.

\cgalModels{Locus}
*/
template <int d>
class Implicit_hypersurface
{
  static_assert(d == 2 || d == 3, "Implicit_hypersurface is for the plane and for space");

public:
  //! a closed range of a coordinate.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! ranges of all coordinates.
  using Box = std::array<Range, d>;

  //! number of coordinates.
  static constexpr int dimension = d;
  //! there are no parameters.
  static constexpr int number_of_parameters = 0;
  //! one equation.
  static constexpr int codimension = 1;

private:
  Power_polynomial m_polynomial;
  std::array<Power_polynomial, d> m_gradient;
  Box m_box;

public:
  /*!
  the zeros of a polynomial, in which the unknowns 0, 1, ... are the coordinates.
  \throws Invalid_input when the polynomial is constant or has other unknowns, or a range of the box has no extent.
  */
  Implicit_hypersurface(Power_polynomial polynomial, Box box)
    : m_polynomial(std::move(polynomial)), m_box(std::move(box))
  {
    if (m_polynomial.is_constant())
      throw Invalid_input(std::string("Implicit_hypersurface: the polynomial is ") +
                          (m_polynomial.is_zero() ? "zero" : "a constant"));
    if (const int last = m_polynomial.variables().back(); last >= d)
      throw Invalid_input("Implicit_hypersurface: unknown " + std::to_string(last) + " in a polynomial of " +
                          std::to_string(d) + " coordinates");
    for (int i = 0; i < d; ++i) {
      if (!(m_box[i].first < m_box[i].second))
        throw Invalid_input("Implicit_hypersurface: the range of coordinate " + std::to_string(i) + " has no extent");
      m_gradient[i] = m_polynomial.derivative(i);
    }
  }

  //! the zeros of a formula in `d` unknowns, which are the coordinates; the box is that of their ranges.
  //! \throws Invalid_input also when the formula is no polynomial, or its unknowns were made together with more or
  //! fewer than `d`.
  explicit Implicit_hypersurface(const Expression& formula)
    : Implicit_hypersurface(formula.polynomial(), box_of(formula.domains().get()))
  {}

  //! the points that satisfy an equation: `Implicit_curve_2 circle(x*x + y*y == 1)`.
  //! \throws Invalid_input also when it is an inequality, or has divisors that may be zero.
  explicit Implicit_hypersurface(const Constraint& equation)
    : Implicit_hypersurface(polynomial_of(equation), box_of(equation.domains.get()))
  {}

  //! \f$f\f$.
  const Power_polynomial& polynomial() const { return m_polynomial; }

  //! where the zeros are looked for.
  const Box& box() const { return m_box; }

  //! the exact value of \f$f\f$ at a point. \throws Invalid_input when it has too few coordinates.
  Exact_rational operator()(std::span<const Exact_rational> point) const { return m_polynomial(point); }

  //! \f$f\f$ as a formula, for a point whose coordinates are formulas; the denominators that rational curves and
  //! surfaces have are cleared when it is compared with 0.
  Expression operator()(const Vector_expression<d>& point) const { return internal::substituted(m_polynomial, point); }

  //! the exact gradient of \f$f\f$ at a point.
  std::array<Exact_rational, d> gradient(std::span<const Exact_rational> point) const
  {
    std::array<Exact_rational, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = m_gradient[i](point);
    return result;
  }

  //! the gradient of \f$f\f$ as a formula.
  Vector_expression<d> gradient(const Vector_expression<d>& point) const
  {
    return internal::vector_of<d>([&](std::size_t i) { return internal::substituted(m_gradient[i], point); });
  }

  //! the sign of \f$f\f$ at a point, in the box or not. \throws Invalid_input when a coordinate is not finite.
  template <class Point>
    requires (Point::Ambient_dimension::value == d)
  CGAL::Sign sign_at(const Point& point) const
  {
    return CGAL::sign(m_polynomial(exact_coordinates(point)));
  }

  //! whether a point is on the curve or surface, which ends at the box. \throws Invalid_input when a coordinate is not
  //! finite.
  template <class Point>
    requires (Point::Ambient_dimension::value == d)
  bool has_on(const Point& point) const
  {
    const std::array<Exact_rational, d> x = exact_coordinates(point);
    for (int i = 0; i < d; ++i)
      if (x[i] < m_box[i].first || m_box[i].second < x[i])
        return false;
    return CGAL::sign(m_polynomial(x)) == CGAL::ZERO;
  }

  /// \name Model of Locus
  /// @{

  //! the equation.
  std::vector<Locus_piece<d>> locus_pieces() const
  {
    Locus_piece<d> piece;
    piece.incidence = [f = *this](const Vector_expression<d>& p, std::span<const Unknown>) {
      return std::vector<Constraint>{f(p) == 0};
    };
    piece.box.assign(m_box.begin(), m_box.end());
    return {piece};
  }

  //! there are none.
  std::vector<Locus_end<d>> locus_ends() const { return {}; }

  /// @}

private:
  static Box box_of(const Unknown_domains* domains)
  {
    const std::size_t count = domains == nullptr ? 0 : domains->size();
    if (count != d)
      throw Invalid_input("Implicit_hypersurface: " + std::to_string(count) + " unknowns for " + std::to_string(d) +
                          " coordinates");
    Box result;
    std::copy(domains->begin(), domains->end(), result.begin());
    return result;
  }

  static Power_polynomial polynomial_of(const Constraint& equation)
  {
    if (equation.relation != Relation::EQUAL)
      throw Invalid_input("Implicit_hypersurface: an inequality instead of an equation");
    if (!equation.conditions.empty() ||
        (equation.symbols != nullptr && !equation.symbols->has_only_unknowns(equation.function)))
      throw Invalid_input("Implicit_hypersurface: the equation is not one of polynomials");
    return equation.function;
  }

  template <class Point>
  static std::array<Exact_rational, d> exact_coordinates(const Point& point)
  {
    std::array<Exact_rational, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = internal::converted_number<Exact_rational>(point.cartesian(i));
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_IMPLICIT_HYPERSURFACE_H
