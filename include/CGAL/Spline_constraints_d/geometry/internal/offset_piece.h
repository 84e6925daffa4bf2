// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_OFFSET_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_OFFSET_PIECE_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point or vector that depends on the parameters of a piece.
template <int d>
using Vector_formula = std::function<Vector_expression<d>(std::span<const Unknown>)>;

template <int d>
Vector_formula<d> constant_formula(const std::array<Exact_rational, d>& x)
{
  return [x](std::span<const Unknown>) { return vector_of<d>([&](std::size_t i) { return Expression(x[i]); }); };
}

std::vector<Unknown> unknowns_in(const Unknown_domains& ranges);

// Positive bounds of a formula, from parts of the box that are halved until those of each part are positive. Throws
// when some part is tiny.
Exact_range positive_bounds(const Expression_bounds& formula, const Unknown_domains& box, const std::string& what,
                            int depth = 0);

// Powers of two around the square roots of the numbers in a range, none of which is one of its ends: curves of
// solutions could lie in the boundary of the domain there. \pre the range is positive
Exact_range root_range_in_powers_of_two(const Exact_range& squares);

// A range of the length of a vector. \throws Invalid_input when it may be zero; the message says `what` and where.
template <int d>
Exact_range length_range(const Vector_formula<d>& vector, const Unknown_domains& parameters, const std::string& what)
{
  const Expression square = squared_norm(vector(unknowns_in(parameters)));
  if (!parameters.empty() && square.symbols() != nullptr)
    return root_range_in_powers_of_two(positive_bounds(Expression_bounds(square), parameters, what));
  const Exact_rational value = square.numerator().constant_term();
  if (value == 0)
    throw Invalid_input(what + " is zero");
  return root_range_in_powers_of_two({value, value});
}

/*
The points at a signed distance r from a base point B along its normal N: B + r N / q with an auxiliary unknown q > 0,
q^2 = |N|^2. A given point P is one of them when P - B is orthogonal to the tangents, as long as |r|, and on the side of
r N.
*/
template <int d>
Locus_piece<d> offset_piece(const Vector_formula<d>& base, const std::vector<Vector_formula<d>>& tangents,
                            const Vector_formula<d>& normal, const Exact_rational& r, const Unknown_domains& parameters,
                            const Exact_range& length_of_normal)
{
  using Unknowns = typename Locus_piece<d>::Unknowns;
  Locus_piece<d> piece;
  piece.parameters = parameters;
  piece.is_without_end.resize(parameters.size(), false);
  piece.auxiliaries = {length_of_normal};
  piece.point = [=](Unknowns u) {
    return base(u.first(u.size() - 1)) + normal(u.first(u.size() - 1)) * (r / u.back());
  };
  piece.constraints = [=](Unknowns u) {
    return std::vector<Constraint>{u.back() * u.back() == squared_norm(normal(u.first(u.size() - 1)))};
  };
  piece.incidence = [=](const Vector_expression<d>& p, Unknowns u) {
    const Vector_expression<d> offset = p - base(u);
    std::vector<Constraint> result;
    for (const Vector_formula<d>& tangent : tangents)
      result.push_back(dot(offset, tangent(u)) == 0);
    result.push_back(squared_norm(offset) == r * r);
    result.push_back(r * dot(offset, normal(u)) > 0);
    return result;
  };
  return piece;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Unknown> unknowns_in(const Unknown_domains& ranges)
{
  std::vector<std::array<Bound, 2>> bounds;
  for (const auto& [lower, upper] : ranges)
    bounds.push_back({Bound(lower), Bound(upper)});
  return bounds.empty() ? std::vector<Unknown>() : unknowns(bounds);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_range positive_bounds(const Expression_bounds& formula, const Unknown_domains& box,
                                                           const std::string& what, int depth)
{
  constexpr int maximal_depth = 100;
  if (const std::optional<Exact_range> own = formula(box, 0); own && own->first > 0)
    return *own;
  if (depth == maximal_depth) {
    std::string place;
    for (const auto& range : box)
      place += (place.empty() ? " near the parameter " : ", ") + shortest_text(to_nearest_double(range.first));
    throw Invalid_input(what + " is zero, or too small to be told from it," + place);
  }
  const auto [first, second] = halves_of(box);
  return hull_of(positive_bounds(formula, first, what, depth + 1), positive_bounds(formula, second, what, depth + 1));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_range root_range_in_powers_of_two(const Exact_range& squares)
{
  Exact_range result(1, 1);
  while (result.first * result.first >= squares.first)
    result.first /= 2;
  while (4 * result.first * result.first < squares.first)
    result.first *= 2;
  result.second = result.first;
  while (result.second * result.second <= squares.second)
    result.second *= 2;
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_OFFSET_PIECE_H
