// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ECHELON_FORM_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ECHELON_FORM_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Rows of numbers in echelon form: each has a one where all others have zeros.
class Echelon_form
{
  // with the places of their ones, the first numbers in them that are not zero
  std::vector<std::pair<std::size_t, std::vector<Exact_rational>>> m_rows;

public:
  std::size_t rank() const { return m_rows.size(); }

  // In the order in which they were added.
  const std::vector<std::pair<std::size_t, std::vector<Exact_rational>>>& rows() const { return m_rows; }

  // Whether it is linearly independent of the others.
  bool add(std::vector<Exact_rational> row)
  {
    for (const auto& [place, other] : m_rows)
      subtract(row, other, place);
    const auto pivot = std::find_if(row.begin(), row.end(), [](const Exact_rational& x) { return x != 0; });
    if (pivot == row.end())
      return false;
    const auto place = static_cast<std::size_t>(pivot - row.begin());
    const Exact_rational factor(1 / *pivot);
    for (Exact_rational& x : row)
      x *= factor;
    for (auto& [own, other] : m_rows)
      subtract(other, row, place);
    m_rows.emplace_back(place, std::move(row));
    return true;
  }

  // The vector orthogonal to all rows. \pre There is one such direction.
  std::vector<Exact_rational> orthogonal_vector(std::size_t length) const
  {
    std::vector<Exact_rational> result(length, Exact_rational(1));
    for (const auto& [place, row] : m_rows)
      result[place] = 0;
    const auto free =
        static_cast<std::size_t>(std::find(result.begin(), result.end(), Exact_rational(1)) - result.begin());
    for (const auto& [place, row] : m_rows)
      result[place] = -row[free];
    return result;
  }

  // A basis of all vectors orthogonal to all rows.
  std::vector<std::vector<Exact_rational>> kernel(std::size_t length) const
  {
    std::vector<bool> is_free(length, true);
    for (const auto& [place, row] : m_rows)
      is_free[place] = false;
    std::vector<std::vector<Exact_rational>> result;
    for (std::size_t free = 0; free < length; ++free) {
      if (!is_free[free])
        continue;
      std::vector<Exact_rational>& vector = result.emplace_back(length, Exact_rational(0));
      vector[free] = 1;
      for (const auto& [place, row] : m_rows)
        vector[place] = -row[free];
    }
    return result;
  }

private:
  static void subtract(std::vector<Exact_rational>& row, const std::vector<Exact_rational>& other, std::size_t place)
  {
    const Exact_rational factor = row[place];
    if (factor != 0)
      for (std::size_t j = 0; j < row.size(); ++j)
        if (other[j] != 0)
          row[j] -= factor * other[j];
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ECHELON_FORM_H
