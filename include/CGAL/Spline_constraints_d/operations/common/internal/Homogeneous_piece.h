// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HOMOGENEOUS_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HOMOGENEOUS_PIECE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Interval_tensor = Bernstein_tensor<Interval>;
using Parameter_range = std::pair<Exact_rational, Exact_rational>;

template <class Number = Interval>
Number interval_of(const Exact_rational& x)
{
  if constexpr (std::same_as<Number, Interval>)
    return Number_traits<Number>::from_rational(x);
  else
    return Number(x);
}

template <class Number>
std::array<Number, 2> interval_pair_of(const Exact_pair& x)
{
  return {interval_of<Number>(x[0]), interval_of<Number>(x[1])};
}

inline Interval interval_of(const Parameter_range& range)
{
  return Interval(to_double_interval(range.first).first, to_double_interval(range.second).second);
}

// A polynomial piece of a curve in homogeneous coordinates x, y, w on [0,1], and whether the curve has a tangent at its
// ends.
struct Homogeneous_piece
{
  Parameter_range domain;
  std::array<Bernstein_tensor<Exact_rational>, 3> coordinates;
  bool is_smooth_at_begin = false, is_smooth_at_end = false;
  std::optional<Parameter_range> whole{};   // of a part, the domain of the piece before it was cut

  int degree() const
  {
    return (std::max)({coordinates[0].degree(0), coordinates[1].degree(0), coordinates[2].degree(0)});
  }

  Exact_rational local(const Exact_rational& t) const
  {
    return Exact_rational((t - domain.first) / (domain.second - domain.first));
  }

  // The derivative in an end, up to a positive factor.
  Exact_pair tangent_at(bool end) const;

  // Whether the derivative is zero in an end.
  bool stops_at(bool end) const { return tangent_at(end) == Exact_pair{Exact_rational(0), Exact_rational(0)}; }

  // The part within a range of the parameter.
  Homogeneous_piece within(const Parameter_range& range) const
  {
    return between({(std::max)(domain.first, range.first), (std::min)(domain.second, range.second)});
  }

  // The piece before it was cut.
  Homogeneous_piece uncut() const { return whole ? between(*whole) : *this; }

private:
  // The same polynomials on another range.
  Homogeneous_piece between(const Parameter_range& range) const;
};

// The function of 1 - u.
Bernstein_tensor<Exact_rational> reversed(const Bernstein_tensor<Exact_rational>& tensor);

// From the end of its domain to the begin.
Homogeneous_piece reversed(Homogeneous_piece piece);

// Refuses a piece of a curve that is one point: it has no sides, and goes nowhere.
void check_is_no_point(const std::array<Bernstein_tensor<Exact_rational>, 3>& coordinates,
                       const Parameter_range& domain, std::size_t curve, const std::string& prefix);

template <class Curve>
std::vector<Homogeneous_piece> homogeneous_pieces(const Curve& curve, const Planar_map& map)
{
  const auto xy = curve.homogeneous_coordinates();
  const std::array<Bspline_function<Exact_rational>, 3> functions{xy[0], xy[1], curve.weight()};
  std::vector<Exact_rational> breaks = map.breaks(0);
  for (const auto& function : functions)
    breaks = internal::united(breaks, function.breaks(0));
  std::vector<Homogeneous_piece> result;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    Homogeneous_piece& piece = result.emplace_back();
    piece.domain = {breaks[i - 1], breaks[i]};
    for (std::size_t k = 0; k < 3; ++k)
      piece.coordinates[k] = functions[k].restricted(0, breaks[i - 1], breaks[i]).bezier_pieces().front();
  }
  for (std::size_t i = map.is_closed() ? 0 : 1; i < result.size(); ++i) {
    Homogeneous_piece& before = result[(i + result.size() - 1) % result.size()];
    before.is_smooth_at_end = result[i].is_smooth_at_begin =
        are_codirectional(before.tangent_at(true), result[i].tangent_at(false));
  }
  return result;
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Homogeneous_piece::tangent_at(bool end) const
{
  const std::array<Exact_rational, 1> t{Exact_rational(end)};
  const auto& [x, y, w] = coordinates;
  const auto numerator = [&, &w = w](const Bernstein_tensor<Exact_rational>& f) {
    return Exact_rational(f.derivative(0)(t) * w(t) - f(t) * w.derivative(0)(t));
  };
  return {numerator(x), numerator(y)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Homogeneous_piece Homogeneous_piece::between(const Parameter_range& range) const
{
  if (range == domain)
    return *this;
  Homogeneous_piece result{range, coordinates, is_smooth_at_begin && range.first == domain.first,
                           is_smooth_at_end && range.second == domain.second, whole ? whole : domain};
  for (Bernstein_tensor<Exact_rational>& tensor : result.coordinates)
    tensor = tensor.restricted(0, local(range.first), local(range.second));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bernstein_tensor<Exact_rational> reversed(const Bernstein_tensor<Exact_rational>& tensor)
{
  std::vector<Exact_rational> coefficients = tensor.coefficients();
  std::reverse(coefficients.begin(), coefficients.end());
  return {tensor.degrees(), std::move(coefficients)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Homogeneous_piece reversed(Homogeneous_piece piece)
{
  for (Bernstein_tensor<Exact_rational>& coordinate : piece.coordinates)
    coordinate = reversed(coordinate);
  return piece;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void
check_is_no_point(const std::array<Bernstein_tensor<Exact_rational>, 3>& coordinates, const Parameter_range& domain,
                  std::size_t curve, const std::string& prefix)
{
  const auto& [x, y, w] = coordinates;
  const std::array<Exact_rational, 1> begin{Exact_rational(0)};
  const auto is_constant = [&, &w = w](const Bernstein_tensor<Exact_rational>& f) {
    return std::ranges::all_of((f * w(begin) - w * f(begin)).coefficients(),
                               [](const Exact_rational& c) { return sign_of(c) == 0; });
  };
  if (is_constant(x) && is_constant(y))
    throw Invalid_input(prefix + "the piece of curve " + std::to_string(curve) + " between the parameters " +
                        shortest_text(to_nearest_double(domain.first)) + " and " +
                        shortest_text(to_nearest_double(domain.second)) + " is a point");
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HOMOGENEOUS_PIECE_H
