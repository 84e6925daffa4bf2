// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

inline Exact_rational inverse_power_of_two(int k)
{
  Exact_rational result(1);
  for (int i = 0; i < k; ++i)
    result /= 2;
  return result;
}

// A dyadic number inside of a range, with few digits.
inline Exact_rational simple_number_between(const Surface_cell_3::Range& range)
{
  Exact_rational lower(0), upper(1), middle(Exact_rational(1) / 2);
  while (!(range.first < middle && middle < range.second)) {
    (middle <= range.first ? lower : upper) = middle;
    middle = Exact_rational((lower + upper) / 2);
  }
  return middle;
}

inline bool is_zero(const Cell_polynomial& f)
{
  return std::ranges::all_of(f.coefficients(), [](const Exact_rational& c) { return c == 0; });
}

// Whether all coefficients have one sign, so that there is no zero.
inline bool has_one_sign(const Cell_polynomial& f)
{
  const auto [least, greatest] = f.bounds();
  return least > 0 || greatest < 0;
}

// With the parameter of an axis at a number, as a polynomial in the other one.
inline Cell_polynomial slice_of(const Cell_polynomial& f, int axis, const Exact_rational& at)
{
  return at == 0 || at == 1 ? f.face(axis, at == 0 ? 0 : 1) : f.split(axis, at).first.face(axis, 1);
}

// Whether a polynomial in one parameter certainly has no zero in a closed range.
inline bool has_no_zero(const Cell_polynomial& f, const Exact_rational& begin, const Exact_rational& end)
{
  constexpr int most_splits = 6;
  std::vector<std::pair<Cell_polynomial, int>> open{{f.restricted(0, begin, end), 0}};
  while (!open.empty()) {
    const auto [part, depth] = std::move(open.back());
    open.pop_back();
    if (has_one_sign(part))
      continue;
    const std::vector<Exact_rational>& values = part.coefficients();
    if (depth == most_splits || values.front() == 0 || values.back() == 0 ||
        (values.front() < 0) != (values.back() < 0))
      return false;
    auto [first, second] = part.split(0);
    open.emplace_back(std::move(first), depth + 1);
    open.emplace_back(std::move(second), depth + 1);
  }
  return true;
}

// Divided by the distance from a side on which it vanishes: t B_{i-1}^{n-1}(t) = (i/n) B_i^n(t).
inline Cell_polynomial divided_by_side(const Cell_polynomial& f, int axis, int side)
{
  std::vector<int> degrees = f.degrees();
  const int n = degrees[static_cast<std::size_t>(axis)]--;
  const int columns = f.degree(1) + 1;
  std::vector<Exact_rational> coefficients;
  for (int i = 0; i <= f.degree(0); ++i)
    for (int j = 0; j < columns; ++j) {
      const int index = axis == 0 ? i : j, factor = side == 0 ? index : n - index;
      if (factor > 0)
        coefficients.push_back(
            Exact_rational(f.coefficients()[static_cast<std::size_t>(i * columns + j)] * n / factor));
    }
  return Cell_polynomial(std::move(degrees), std::move(coefficients));
}

// \pre It is not zero.
inline Cell_polynomial without_sides(Cell_polynomial f)
{
  for (const int axis : {0, 1})
    for (const int side : {0, 1})
      while (is_zero(f.face(axis, side)))
        f = divided_by_side(f, axis, side);
  return f;
}

// Whether they are equal up to a constant factor.
inline bool are_proportional(const Cell_polynomial& f, const Cell_polynomial& g)
{
  std::vector<int> degrees = f.degrees();
  for (std::size_t axis = 0; axis < degrees.size(); ++axis)
    degrees[axis] = (std::max)(degrees[axis], g.degrees()[axis]);
  const std::vector<Exact_rational> a = f.elevated(degrees).coefficients(), b = g.elevated(degrees).coefficients();
  const auto pivot = std::ranges::find_if(a, [](const Exact_rational& c) { return c != 0; });
  if (pivot == a.end())
    return is_zero(g);
  const std::size_t p = static_cast<std::size_t>(pivot - a.begin());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] * b[p] != b[i] * a[p])
      return false;
  return b[p] != 0;
}

// Those of some polynomials that have zeros in the unit box, each once, and without factors that vanish on its sides
// only; none if one is zero.
inline std::optional<std::vector<Cell_polynomial>> curves_of(const std::vector<Cell_polynomial>& polynomials)
{
  std::vector<Cell_polynomial> result;
  for (const Cell_polynomial& f : polynomials) {
    if (is_zero(f))
      return std::nullopt;
    Cell_polynomial factor = without_sides(f);
    const auto is_same = [&](const Cell_polynomial& known) { return are_proportional(known, factor); };
    if (!has_one_sign(factor) && std::ranges::none_of(result, is_same))
      result.push_back(std::move(factor));
  }
  return result;
}

inline int sum_of_degrees(const std::vector<Cell_polynomial>& polynomials)
{
  int result = 0;
  for (const Cell_polynomial& f : polynomials)
    result += f.degree(0) + f.degree(1);
  return result;
}

inline Cell_polynomial product_of(const std::vector<Cell_polynomial>& factors)
{
  Cell_polynomial result = Cell_polynomial::constant(2, Exact_rational(1));
  for (const Cell_polynomial& factor : factors)
    result *= factor;
  return result;
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_POLYNOMIALS_H
