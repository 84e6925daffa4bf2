// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_EVOLUTE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_EVOLUTE_2_H

#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

The evolute of a planar curve, the locus of its centers of curvature: \f$C + N\,|C'|^2 / (C' \times C'')\f$ with the
normal \f$N = (-y', x')\f$. It goes to infinity at inflections, and straight pieces have none; its cusps belong to the
vertices of the curve (`curvature_extremes()`).

A point \f$P\f$ is on it when \f$\langle P - C, C'\rangle = 0\f$ and \f$\langle P - C, C''\rangle = |C'|^2\f$, equations
without poles. Where the curvature jumps, at breaks, the evolute has a gap.

\cgalModels{Locus}
*/
class Evolute_2
{
  internal::Planar_map m_curve;
  std::vector<internal::Differentiated_map> m_pieces;   // between breaks, those that are not straight

public:
  //! number of coordinates.
  static constexpr int dimension = 2;
  //! the parameter is that of the curve.
  static constexpr int number_of_parameters = 1;
  //! a curve in the plane.
  static constexpr int codimension = 1;

  /*!
  the evolute of a curve.
  \tparam Curve a model of `ParametricCurve_2`.
  \param curve the curve.
  \throws Invalid_input when the derivative of the curve vanishes, or nearly so; the message says where.
  */
  template <class Curve>
    requires (!std::same_as<Curve, Evolute_2>) && ParametricCurve_2<Curve>
  explicit Evolute_2(const Curve& curve) : m_curve(curve)
  {
    for (const internal::Differentiated_map& piece : internal::polynomial_pieces(m_curve, 2)) {
      const Unknown_domains range{piece.map().domain(0)};
      const std::vector<Unknown> u = internal::unknowns_in(range);
      internal::length_range<2>([&](std::span<const Unknown> t) { return piece(1, t[0]); }, range,
                                "Evolute_2: the derivative of the curve");
      if (!is_zero(determinant(piece(1, u[0]), piece(2, u[0]))))
        m_pieces.push_back(piece);
    }
  }

  //! the curve itself.
  const Spline_map<1, 2>& curve() const { return m_curve; }

  //! the range of the parameter.
  std::pair<Exact_rational, Exact_rational> domain(int = 0) const { return m_curve.domain(0); }

  //! the center of curvature at a parameter, exactly; at a break, that of the piece after it. Nothing on straight
  //! pieces and at inflections.
  std::optional<std::array<Exact_rational, 2>> operator()(const Exact_rational& t) const
  {
    for (std::size_t i = m_pieces.size(); i-- > 0;)
      if (m_pieces[i].begin() <= t)
        return t <= m_pieces[i].end() ? center(m_pieces[i], t) : std::nullopt;
    return std::nullopt;
  }

  /// \name Model of Locus
  /// @{

  //! one piece for each piece of the curve between breaks that is not straight.
  std::vector<Locus_piece<2>> locus_pieces() const
  {
    std::vector<Locus_piece<2>> result;
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
      const internal::Differentiated_map& curve = m_pieces[i];
      Locus_piece<2> piece;
      piece.parameters = {curve.map().domain(0)};
      piece.is_without_end = {goes_on(i)};
      piece.point = [curve](std::span<const Unknown> u) {
        const Vector_expression<2> tangent = curve(1, u[0]);
        return curve(0, u[0]) + perpendicular(tangent) * (squared_norm(tangent) / determinant(tangent, curve(2, u[0])));
      };
      piece.incidence = [curve](const Vector_expression<2>& p, std::span<const Unknown> u) {
        const Vector_expression<2> offset = p - curve(0, u[0]), tangent = curve(1, u[0]);
        return std::vector<Constraint>{dot(offset, tangent) == 0, dot(offset, curve(2, u[0])) == squared_norm(tangent)};
      };
      result.push_back(piece);
    }
    return result;
  }

  //! the ends that have a center of curvature; the seam of a closed curve, too.
  std::vector<Locus_end<2>> locus_ends() const
  {
    std::vector<Locus_end<2>> result;
    if (!m_pieces.empty())
      for (const auto& [piece, t] :
           {std::pair(&m_pieces.front(), domain().first), std::pair(&m_pieces.back(), domain().second)})
        if (piece->begin() <= t && t <= piece->end())
          if (const auto point = center(*piece, t)) {
            Locus_piece<2> end;
            end.point = internal::constant_formula<2>(*point);
            end.incidence = [point](const Vector_expression<2>& p, std::span<const Unknown>) {
              return std::vector<Constraint>{p[0] == (*point)[0], p[1] == (*point)[1]};
            };
            result.push_back({t, end});
          }
    return result;
  }

  /// @}

private:
  static bool is_zero(const Expression& formula)
  {
    const Spline_function function = (formula == 0).spline_function();
    return std::all_of(function.terms().begin(), function.terms().end(), [](const Spline_term& term) {
      return std::all_of(term.pieces[0].begin(), term.pieces[0].end(),
                         [](const Exact_rational& coefficient) { return coefficient == 0; });
    });
  }

  static std::optional<std::array<Exact_rational, 2>> center(const internal::Differentiated_map& piece,
                                                             const Exact_rational& t)
  {
    const internal::Exact_pair p = piece.at(0, t), tangent = piece.at(1, t);
    const Exact_rational turn = internal::exact_cross(tangent, piece.at(2, t));
    if (turn == 0)
      return std::nullopt;
    const Exact_rational factor(internal::exact_dot(tangent, tangent) / turn);
    return std::array<Exact_rational, 2>{Exact_rational(p[0] - factor * tangent[1]),
                                         Exact_rational(p[1] + factor * tangent[0])};
  }

  // Whether the next piece begins with the last point of a piece; on a closed curve, the first one after the last.
  bool goes_on(std::size_t i) const
  {
    const internal::Differentiated_map &piece = m_pieces[i], &next = m_pieces[(i + 1) % m_pieces.size()];
    const bool is_next = piece.end() == next.begin() ||
        (m_curve.is_closed() && piece.end() == domain().second && next.begin() == domain().first);
    const auto end = center(piece, piece.end());
    return is_next && end && end == center(next, next.begin()) && internal::have_common_tangent(piece, next);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_EVOLUTE_2_H
