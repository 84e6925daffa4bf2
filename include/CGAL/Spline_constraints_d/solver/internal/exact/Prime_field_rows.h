// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_ROWS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_ROWS_H

#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_polynomial.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Independent rows of a matrix modulo a prime, by elimination.
class Prime_field_rows
{
  using Field = Prime_field_polynomial;
  std::vector<std::pair<std::size_t, std::vector<Field::Number>>> m_rows;   // with the places of their ones

public:
  std::size_t rank() const { return m_rows.size(); }

  // Whether a row is no combination of those before.
  bool add(std::vector<Field::Number> row)
  {
    for (const auto& [one, other] : m_rows)
      if (const Field::Number factor = row[one]; factor != 0)
        for (std::size_t j = 0; j < row.size(); ++j)
          row[j] = Field::difference(row[j], other[j] * factor % Field::prime);
    const auto pivot = std::find_if(row.begin(), row.end(), [](Field::Number x) { return x != 0; });
    if (pivot == row.end())
      return false;
    const Field::Number factor = Field::inverse(*pivot);
    for (Field::Number& x : row)
      x = x * factor % Field::prime;
    m_rows.emplace_back(static_cast<std::size_t>(pivot - row.begin()), std::move(row));
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_ROWS_H
