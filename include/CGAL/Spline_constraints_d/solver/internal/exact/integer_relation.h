// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_INTEGER_RELATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_INTEGER_RELATION_H

#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Reduction of a basis of a lattice of integer vectors (Lenstra, Lenstra, Lovasz 1982), in integers: d[i] is the
determinant of the Gram matrix of the first i vectors, and lambda[i][j] / d[j+1] the coefficient of the Gram-Schmidt
process.
*/
class Reduced_lattice
{
  using Vector = std::vector<Big_integer>;

  std::vector<Vector> m_basis, m_lambda;
  Vector m_d;

public:
  // The vectors are independent.
  explicit Reduced_lattice(std::vector<Vector> basis)
    : m_basis(std::move(basis)), m_lambda(m_basis.size(), Vector(m_basis.size())),
      m_d(m_basis.size() + 1, Big_integer(1))
  {
    orthogonalize();
    for (std::size_t k = 1; k < m_basis.size();) {
      make_short(k, k - 1);
      if (4 * m_d[k + 1] * m_d[k - 1] < 3 * m_d[k] * m_d[k] - 4 * m_lambda[k][k - 1] * m_lambda[k][k - 1]) {
        swap_with_previous(k);
        k = (std::max)(k - 1, std::size_t(1));
        continue;
      }
      for (std::size_t l = k - 1; l-- > 0;)
        make_short(k, l);
      ++k;
    }
  }

  // Not much longer than the shortest one.
  const Vector& first() const { return m_basis[0]; }

private:
  void orthogonalize()
  {
    for (std::size_t k = 0; k < m_basis.size(); ++k)
      for (std::size_t j = 0; j <= k; ++j) {
        Big_integer u = 0;
        for (std::size_t i = 0; i < m_basis[k].size(); ++i)
          u += m_basis[k][i] * m_basis[j][i];
        for (std::size_t i = 0; i < j; ++i)
          u = (m_d[i + 1] * u - m_lambda[k][i] * m_lambda[j][i]) / m_d[i];
        (j < k ? m_lambda[k][j] : m_d[k + 1]) = u;
      }
  }

  // Takes the multiple of vector l from vector k that leaves a coefficient of at most one half.
  void make_short(std::size_t k, std::size_t l)
  {
    if (2 * abs(m_lambda[k][l]) <= m_d[l + 1])
      return;
    const Big_integer sum = 2 * abs(m_lambda[k][l]) + m_d[l + 1],
                      q = m_lambda[k][l] < 0 ? Big_integer(-(sum / (2 * m_d[l + 1])))
                                             : Big_integer(sum / (2 * m_d[l + 1]));
    for (std::size_t i = 0; i < m_basis[k].size(); ++i)
      m_basis[k][i] -= q * m_basis[l][i];
    m_lambda[k][l] -= q * m_d[l + 1];
    for (std::size_t i = 0; i < l; ++i)
      m_lambda[k][i] -= q * m_lambda[l][i];
  }

  void swap_with_previous(std::size_t k)
  {
    std::swap(m_basis[k], m_basis[k - 1]);
    for (std::size_t j = 0; j + 1 < k; ++j)
      std::swap(m_lambda[k][j], m_lambda[k - 1][j]);
    const Big_integer lambda = m_lambda[k][k - 1], d = (m_d[k - 1] * m_d[k + 1] + lambda * lambda) / m_d[k];
    for (std::size_t i = k + 1; i < m_basis.size(); ++i) {
      const Big_integer t = m_lambda[i][k];
      m_lambda[i][k] = (m_d[k + 1] * m_lambda[i][k - 1] - lambda * t) / m_d[k];
      m_lambda[i][k - 1] = (d * t + lambda * m_lambda[i][k]) / m_d[k + 1];
    }
    m_d[k] = d;
  }
};

/*
Integers c, not all zero and much smaller than those that there are by chance, such that the sum of all c x is zero up
to about 2^-bits; none when there seem to be none. It is a guess.
*/
inline std::vector<Big_integer> integer_relation(const std::vector<Exact_rational>& x, long bits)
{
  const std::size_t n = x.size();
  std::vector<std::vector<Big_integer>> basis(n, std::vector<Big_integer>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const Exact_rational scaled = x[i] * power_of_two(bits);
    basis[i][i] = 1;
    basis[i][n] = numerator_of(scaled) / denominator_of(scaled);
  }
  std::vector<Big_integer> result = Reduced_lattice(std::move(basis)).first();
  const bool is_short = std::all_of(result.begin(), result.end(), [&](const Big_integer& c) {
    return bit_length(c) * 2 * static_cast<long>(n) < bits;
  });
  result.pop_back();
  return is_short ? result : std::vector<Big_integer>();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_INTEGER_RELATION_H
