// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_LOCUS_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_LOCUS_PIECE_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <concepts>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A smooth piece of a curve or surface as constraints see it: a set of points in dimension `d`, described by unknowns of
its own. They are parameters, and auxiliary unknowns that the parameters determine, such as the length of a derivative.

There are two descriptions, and systems use the one that makes them smaller. `point` is a formula of all the unknowns,
which satisfy `constraints`; `incidence` says of a given point that it is the one with given parameters, without
auxiliary unknowns.
*/
template <int d>
struct Locus_piece
{
  //! unknowns made with the ranges of the piece.
  using Unknowns = std::span<const Unknown>;

  //! the ranges of the parameters; none for an implicit curve or surface.
  Unknown_domains parameters = {};

  //! for each parameter, whether the upper end of its range is left to the piece that begins there.
  std::vector<bool> is_without_end = {};

  //! the ranges of the auxiliary unknowns.
  Unknown_domains auxiliaries = {};

  //! the point as a formula of parameters and auxiliary unknowns, in this order; empty for an implicit curve or
  //! surface.
  std::function<Vector_expression<d>(Unknowns)> point = {};

  //! what parameters and auxiliary unknowns satisfy; empty: nothing.
  std::function<std::vector<Constraint>(Unknowns)> constraints = {};

  //! what a point satisfies if it is the one with these parameters. Formulas of the point have the unknowns of its
  //! coordinates.
  std::function<std::vector<Constraint>(const Vector_expression<d>&, Unknowns)> incidence = {};

  //! ranges of the coordinates that the piece is cut at; empty: none.
  Unknown_domains box = {};
};

/*!
\ingroup PkgSplineConstraintsDGeometry

An end of a curve: the parameter there, and the end point as a piece without this parameter.
*/
template <int d>
struct Locus_end
{
  Exact_rational parameter;   ///< one of the ends of the domain
  Locus_piece<d> piece;       ///< has no parameters, and as many auxiliary unknowns as the other pieces
};

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link Locus `Locus`\endlink: a curve or surface described by constraints.
*/
template <class L>
concept Locus = std::copyable<L> && requires(const L& locus) {
  { L::dimension } -> std::convertible_to<int>;
  { L::number_of_parameters } -> std::convertible_to<int>;
  { L::codimension } -> std::convertible_to<int>;
  { locus.locus_pieces() } -> std::same_as<std::vector<Locus_piece<L::dimension>>>;
  { locus.locus_ends() } -> std::same_as<std::vector<Locus_end<L::dimension>>>;
} && (L::number_of_parameters == 0 || requires(const L& locus, int axis) {
  { locus.domain(axis) } -> std::convertible_to<std::pair<Exact_rational, Exact_rational>>;
});

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_LOCUS_PIECE_H
