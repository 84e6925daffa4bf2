// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_SPLINE_AXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_SPLINE_AXES_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_function = Bspline_function<Exact_rational>;

// The control points seen as a dense tensor: its index bounds.
template <class NT>
std::vector<int> control_extents(const Bspline_function<NT>& f)
{
  std::vector<int> result;
  for (int j = 0; j < f.dimension(); ++j)
    result.push_back(static_cast<int>(f.size(j)) - 1);
  return result;
}

template <class NT>
std::vector<std::vector<NT>> all_knots(const Bspline_function<NT>& f)
{
  std::vector<std::vector<NT>> result;
  for (int j = 0; j < f.dimension(); ++j)
    result.push_back(f.knots(j));
  return result;
}

template <class NT>
Bspline_function<NT> with_coefficients(const Bspline_function<NT>& f, std::vector<NT> coefficients)
{
  check_finite(coefficients, "Bspline_function: control point");
  return Bspline_function<NT>::on_axes(f.axes(), std::move(coefficients));
}

template <class NT>
Bspline_function<NT> with_knots(const Bspline_function<NT>& f, int axis, std::vector<NT> knots)
{
  std::vector<std::vector<NT>> all = all_knots(f);
  all[axis] = std::move(knots);
  return Bspline_function<NT>(f.degrees(), std::move(all), f.coefficients());
}

// Throws when knots that were rounded fell together: with the piece between them a part of a curve would be lost.
template <class NT, class Other>
void check_number_of_pieces(const Bspline_function<NT>& before, const Bspline_function<Other>& after, int axis)
{
  if (before.breaks(axis).size() != after.breaks(axis).size())
    throw Invalid_input("knots of axis " + std::to_string(axis) + " fall together when they are rounded");
}

// The same values on another domain, reached by an affine change of the parameter. Where numbers are rounded, the ends
// of the domain are exact and knots stay in order.
template <class NT>
Bspline_function<NT> with_domain(const Bspline_function<NT>& f, int axis, const NT& new_begin, const NT& new_end)
{
  if (!(is_finite_number(new_begin) && is_finite_number(new_end) && new_begin < new_end))
    throw Invalid_input("the new domain of axis " + std::to_string(axis) + " is empty or not finite");
  const auto [begin, end] = f.domain(axis);
  const NT factor = NT(new_end - new_begin) / NT(end - begin);
  std::vector<NT> knots;
  for (const NT& knot : f.knots(axis)) {
    const NT image = new_begin + NT(factor * NT(knot - begin));
    if (knot < begin)
      knots.push_back((std::min)(image, new_begin));
    else if (end < knot)
      knots.push_back((std::max)(image, new_end));
    else
      knots.push_back(knot == begin ? new_begin : knot == end ? new_end : (std::min)(image, new_end));
  }
  Bspline_function<NT> result = with_knots(f, axis, std::move(knots));
  check_number_of_pieces(f, result, axis);
  return result;
}

// The function u -> f(begin + end - u) on the same domain: that of -u, moved back.
template <class NT>
Bspline_function<NT> reversed(const Bspline_function<NT>& f, int axis)
{
  std::vector<NT> knots;
  for (const NT& knot : f.knots(axis))
    knots.push_back(-knot);
  std::reverse(knots.begin(), knots.end());

  const Axis_view view = axis_view(control_extents(f), axis);
  std::vector<NT> coefficients;
  for (std::size_t o = 0; o < view.outer; ++o)
    for (std::size_t k = view.degree + 1; k-- > 0;) {
      const auto row = f.coefficients().begin() + (o * (view.degree + 1) + k) * view.inner;
      coefficients.insert(coefficients.end(), row, row + view.inner);
    }
  const auto [begin, end] = f.domain(axis);
  return with_domain(with_coefficients(with_knots(f, axis, std::move(knots)), std::move(coefficients)), axis, begin,
                     end);
}

// f(v, u) of a function of two parameters.
template <class NT>
Bspline_function<NT> transposed(const Bspline_function<NT>& f)
{
  std::vector<NT> coefficients;
  for (std::size_t j = 0; j < f.size(1); ++j)
    for (std::size_t i = 0; i < f.size(0); ++i)
      coefficients.push_back(f.coefficients()[i * f.size(1) + j]);
  return Bspline_function<NT>({f.degree(1), f.degree(0)}, {f.knots(1), f.knots(0)}, std::move(coefficients));
}

/*
The function on one occurrence of a knot less, where it is one. Its control points are the blossoms at the knots that
are left; whether they stand for the same function, refinement back to all knots tells.
*/
std::optional<Exact_function> without_knot(const Exact_function& f, int axis, const Exact_rational& t);

// The continuous function of one parameter with these pieces between breaks.
Exact_function joined(const std::vector<Bernstein_tensor<Exact_rational>>& pieces,
                      const std::vector<Exact_rational>& breaks, const std::string& discontinuity);

// The functions on common degrees and knots: adding zero times each of the others brings them there.
template <class NT>
void bring_to_common_knots(std::vector<Bspline_function<NT>>& functions)
{
  const auto have_equal_knots = [](const Bspline_function<NT>& f, const Bspline_function<NT>& g) {
    return f.axes() == g.axes();
  };
  if (std::all_of(functions.begin() + 1, functions.end(),
                  [&](const auto& f) { return have_equal_knots(f, functions[0]); }))
    return;
  Bspline_function<NT> nothing = functions[0] * NT(0);
  for (std::size_t i = 1; i < functions.size(); ++i)
    nothing = nothing + functions[i] * NT(0);
  for (Bspline_function<NT>& f : functions)
    f = f + nothing;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_function> without_knot(const Exact_function& f, int axis,
                                                                          const Exact_rational& t)
{
  const Knot_axis<Exact_rational> fine{f.degree(axis), f.knots(axis)};
  std::vector<Exact_rational> fewer = *fine.knots;
  fewer.erase(std::find(fewer.begin(), fewer.end(), t));
  const Knot_axis<Exact_rational> coarse{fine.degree, std::move(fewer)};

  std::vector<int> extents = control_extents(f);
  const std::vector<Exact_rational> candidate =
      transform_axis(f.coefficients(), axis_view(extents, axis), refinement_matrix(fine, coarse));
  extents[axis] = static_cast<int>(coarse.size()) - 1;
  if (transform_axis(candidate, axis_view(extents, axis), refinement_matrix(coarse, fine)) != f.coefficients())
    return std::nullopt;
  std::vector<std::vector<Exact_rational>> knots = all_knots(f);
  knots[axis] = *coarse.knots;
  return Exact_function(f.degrees(), std::move(knots), candidate);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_function joined(const std::vector<Bernstein_tensor<Exact_rational>>& pieces,
                                                     const std::vector<Exact_rational>& breaks,
                                                     const std::string& discontinuity)
{
  const int degree = pieces[0].degree(0);
  std::vector<Exact_rational> knots(1, breaks[0]), coefficients = pieces[0].coefficients();
  for (const Exact_rational& t : breaks)
    knots.insert(knots.end(), static_cast<std::size_t>(degree), t);
  knots.push_back(breaks.back());
  for (std::size_t c = 1; c < pieces.size(); ++c) {
    const std::vector<Exact_rational>& next = pieces[c].coefficients();
    if (next.front() != coefficients.back())
      throw Invalid_input(discontinuity);
    coefficients.insert(coefficients.end(), next.begin() + 1, next.end());
  }
  return Exact_function({degree}, {knots}, std::move(coefficients));
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_SPLINE_AXES_H
