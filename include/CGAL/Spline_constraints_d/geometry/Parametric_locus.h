// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_LOCUS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_LOCUS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/Point_locus.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A parametric curve or surface, as constraints see it: one piece with its knots inside. `to_locus()` makes it where one
is needed.

\tparam number_of_parameters_ 1 for a curve, 2 for a surface.
\tparam d 2 or 3.

\cgalModels{Locus}
*/
template <int number_of_parameters_, int d>
class Parametric_locus
{
  Spline_map<number_of_parameters_, d> m_map;

public:
  //! number of coordinates.
  static constexpr int dimension = d;
  //! number of parameters.
  static constexpr int number_of_parameters = number_of_parameters_;
  //! number of equations that an implicit description has.
  static constexpr int codimension = d - number_of_parameters_;

  //! the points of a map.
  explicit Parametric_locus(Spline_map<number_of_parameters_, d> map) : m_map(std::move(map)) {}

  //! the range of a parameter.
  std::pair<Exact_rational, Exact_rational> domain(int axis) const { return m_map.domain(axis); }

  //! the whole curve or surface; the end of a closed axis is left to its begin.
  std::vector<Locus_piece<d>> locus_pieces() const
  {
    Locus_piece<d> piece;
    for (int axis = 0; axis < number_of_parameters; ++axis) {
      piece.parameters.push_back(m_map.domain(axis));
      piece.is_without_end.push_back(m_map.is_closed(axis));
    }
    piece.point = [map = m_map](std::span<const Unknown> u) {
      if constexpr (number_of_parameters == 1)
        return map(u[0]);
      else
        return map(u[0], u[1]);
    };
    piece.incidence = [point = piece.point](const Vector_expression<d>& p, std::span<const Unknown> u) {
      return internal::equality<d>(p, point(u));
    };
    return {piece};
  }

  //! both ends of a curve.
  std::vector<Locus_end<d>> locus_ends() const
  {
    std::vector<Locus_end<d>> result;
    if constexpr (number_of_parameters == 1)
      for (const Exact_rational& t : {domain(0).first, domain(0).second})
        result.push_back({t, Point_locus<d>(m_map(std::array{t})).locus_pieces().front()});
    return result;
  }
};

//! \relates Parametric_locus
//! a `Locus` of a model of `ParametricMap`, or the `Locus` itself. \throws Invalid_input as `Spline_map`.
template <class Operand>
  requires Locus<Operand> || ParametricMap<Operand>
auto to_locus(const Operand& operand)
{
  if constexpr (Locus<Operand>)
    return operand;
  else {
    const Spline_map map(operand);
    return Parametric_locus<decltype(map)::number_of_parameters, decltype(map)::dimension>(map);
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_LOCUS_H
