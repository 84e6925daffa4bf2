// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MULTIPLICITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MULTIPLICITY_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
whether a rational point solves all equalities and inequalities, in exact arithmetic. The domain is not looked at.
*/
bool satisfies(const Constraint_system_d& system, const std::vector<Exact_rational>& point);

namespace internal {

using Taylor_terms = std::map<std::vector<int>, Exact_rational>;

// The pieces of a term that meet in a point, by their number.
std::vector<std::size_t> cells_at(const Spline_term& term, const std::vector<Exact_rational>& point);

void add_taylor_terms(const Spline_term& term, std::size_t cell, const std::vector<Exact_rational>& point, int order,
                      Taylor_terms& result);

// The Taylor coefficients of a spline at a point, up to an order; false when the point lies on a break between pieces
// where they jump.
bool taylor_expansion(const Spline_function& function, const std::vector<Exact_rational>& point, int order,
                      Taylor_terms& result);

// All exponent vectors of total degree up to an order.
std::vector<std::vector<int>> exponents_up_to(std::size_t dimension, int order);

// Rank of an integer matrix modulo a prime below 2^31.
std::size_t rank_modulo(const std::vector<std::vector<Big_integer>>& matrix, std::uint64_t prime);

// The largest primes below 2^31, one after the other.
class Prime_sequence
{
  std::uint64_t m_last = std::uint64_t(1) << 31;

public:
  std::uint64_t next()
  {
    const auto is_prime = [](std::uint64_t n) {
      for (std::uint64_t d = 3; d * d <= n; d += 2)
        if (n % d == 0)
          return false;
      return true;
    };
    for (m_last -= m_last % 2 == 0 ? 1 : 2; !is_prime(m_last);)
      m_last -= 2;
    return m_last;
  }
};

// Rows of the Macaulay matrix of some order at a point, with integer entries; false when the point lies on a break
// between pieces where derivatives up to this order jump.
bool macaulay_matrix(const Constraint_system_d& system, const std::vector<Exact_rational>& point, int order,
                     const std::vector<std::vector<int>>& exponents, std::vector<std::vector<Big_integer>>& rows);

// Whether the rank of the matrix is at most `rank`, which it is modulo some prime: a larger minor would be divisible by
// every prime modulo which the rank is the same, and Hadamard's bound ends that. Gives up (false) when that takes too
// many primes.
bool rank_is_at_most(const std::vector<std::vector<Big_integer>>& rows, std::size_t rank, Prime_sequence primes);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> cells_at(const Spline_term& term,
                                                                 const std::vector<Exact_rational>& point)
{
  std::vector<std::size_t> result{0};
  for (std::size_t j = 0; j < term.variables.size(); ++j) {
    const auto& breaks = term.breaks[j];
    const Exact_rational& x = point[term.variables[j]];
    std::size_t own = 0;
    while (own + 1 < term.cells(j) && breaks[own + 1] < x)
      ++own;
    const bool is_on_break = own + 1 < term.cells(j) && breaks[own + 1] == x;
    std::vector<std::size_t> next;
    for (const std::size_t cell : result)
      for (std::size_t side = 0; side <= (is_on_break ? 1 : 0); ++side)
        next.push_back(cell * term.cells(j) + own + side);
    result = std::move(next);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void add_taylor_terms(const Spline_term& term, std::size_t cell,
                                                     const std::vector<Exact_rational>& point, int order,
                                                     Taylor_terms& result)
{
  std::vector<Exact_rational> coefficients = term.pieces[cell];
  for (std::size_t j = 0; j < term.variables.size(); ++j)
    substitute_affine(coefficients, term.degrees, j, point[term.variables[j]], Exact_rational(1));
  std::vector<int> k(term.variables.size(), 0);
  for (const Exact_rational& coefficient : coefficients) {
    if (coefficient != Exact_rational(0) && std::accumulate(k.begin(), k.end(), 0) <= order) {
      std::vector<int> exponents(point.size(), 0);
      for (std::size_t j = 0; j < k.size(); ++j)
        exponents[term.variables[j]] = k[j];
      result[exponents] += coefficient;
    }
    for (std::size_t j = k.size(); j-- > 0 && ++k[j] > term.degrees[j];)
      k[j] = 0;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool taylor_expansion(const Spline_function& function,
                                                     const std::vector<Exact_rational>& point, int order,
                                                     Taylor_terms& result)
{
  for (const Spline_term& term : function.terms()) {
    std::optional<Taylor_terms> of_term;
    for (const std::size_t cell : cells_at(term, point)) {
      Taylor_terms own;
      add_taylor_terms(term, cell, point, order, own);
      if (of_term && *of_term != own)
        return false;
      of_term = std::move(own);
    }
    for (const auto& [exponents, coefficient] : *of_term)
      result[exponents] += coefficient;
  }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::vector<int>> exponents_up_to(std::size_t dimension, int order)
{
  std::vector<std::vector<int>> result{std::vector<int>(dimension, 0)};
  for (std::size_t first = 0, degree = 1; degree <= static_cast<std::size_t>(order); ++degree) {
    const std::size_t last = result.size();
    for (; first < last; ++first) {
      std::size_t leading = 0; // raise only from the last non-zero exponent on: each vector once
      for (std::size_t j = 0; j < dimension; ++j)
        if (result[first][j] != 0)
          leading = j;
      for (std::size_t j = leading; j < dimension; ++j) {
        std::vector<int> next = result[first];
        ++next[j];
        result.push_back(std::move(next));
      }
    }
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t rank_modulo(const std::vector<std::vector<Big_integer>>& matrix,
                                                       std::uint64_t prime)
{
  std::vector<std::vector<std::uint64_t>> rows;
  for (const auto& source : matrix) {
    auto& row = rows.emplace_back();
    for (const Big_integer& entry : source)
      row.push_back(entry == 0 ? 0 : mpz_fdiv_ui(entry.backend().data(), prime));
  }
  const auto inverse = [prime](std::uint64_t a) { // Fermat
    std::uint64_t result = 1;
    for (std::uint64_t e = prime - 2; e != 0; e >>= 1, a = a * a % prime)
      if (e & 1)
        result = result * a % prime;
    return result;
  };
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t c = 0; c < columns && rank < rows.size(); ++c) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][c] == 0)
      ++pivot;
    if (pivot == rows.size())
      continue;
    std::swap(rows[rank], rows[pivot]);
    const std::uint64_t scale = inverse(rows[rank][c]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i)
      if (rows[i][c] != 0) {
        const std::uint64_t factor = prime - rows[i][c] * scale % prime;
        for (std::size_t k = c; k < columns; ++k)
          if (rows[rank][k] != 0)
            rows[i][k] = (rows[i][k] + factor * rows[rank][k]) % prime;
      }
    ++rank;
  }
  return rank;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool macaulay_matrix(const Constraint_system_d& system,
                                                    const std::vector<Exact_rational>& point, int order,
                                                    const std::vector<std::vector<int>>& exponents,
                                                    std::vector<std::vector<Big_integer>>& rows)
{
  std::map<std::vector<int>, std::size_t> column;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    column[exponents[i]] = i;
  for (const Spline_function& function : system.equalities()) {
    Taylor_terms terms;
    if (!taylor_expansion(function, point, order, terms))
      return false;
    Big_integer denominator(1);
    for (const auto& [k, coefficient] : terms)
      denominator = lcm(denominator, denominator_of(coefficient));
    for (const auto& shift : exponents_up_to(point.size(), order - 1)) {
      std::vector<Big_integer> row(exponents.size(), Big_integer(0));
      bool is_zero = true;
      for (const auto& [k, coefficient] : terms) {
        std::vector<int> sum = k;
        for (std::size_t j = 0; j < sum.size(); ++j)
          sum[j] += shift[j];
        if (const auto place = column.find(sum); place != column.end() && coefficient != Exact_rational(0)) {
          row[place->second] = numerator_of(coefficient) * (denominator / denominator_of(coefficient));
          is_zero = false;
        }
      }
      if (!is_zero)
        rows.push_back(std::move(row));
    }
  }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool rank_is_at_most(const std::vector<std::vector<Big_integer>>& rows, std::size_t rank,
                                                    Prime_sequence primes)
{
  std::vector<long> bits; // of the row norms
  for (const auto& row : rows) {
    long largest = 0;
    for (const Big_integer& entry : row)
      largest = (std::max)(largest, bit_length(entry));
    bits.push_back(largest + static_cast<long>(std::ceil(0.5 * std::log2(static_cast<double>(row.size())))));
  }
  std::sort(bits.rbegin(), bits.rend());
  const long bound = std::accumulate(bits.begin(), bits.begin() + (std::min)(rank + 1, bits.size()), 0L);
  const double work = static_cast<double>(bound) / 30 * rows.size() * rank * (rows.empty() ? 0 : rows[0].size());
  if (work > 3e8)
    return false;
  for (long proved = 0; proved <= bound; proved += 30)
    if (rank_modulo(rows, primes.next()) > rank)
      return false;
  return true;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver
What is proved of a rational solution by `local_structure()`.
*/
struct Local_structure
{
  bool is_isolated = false;   ///< no other solution of the equalities near the point, complex ones included
  int multiplicity = 0;       ///< of the point as a solution of the equalities; 0 when not decided
};

/*!
\ingroup PkgSplineConstraintsDSolver

Whether a rational solution of the equalities is isolated, and its multiplicity, in exact arithmetic.

The nullity of the Macaulay matrix of order \f$\alpha\f$ (all \f$x^\beta f_i\f$, truncated at total degree \f$\alpha\f$
around the point) grows with \f$\alpha\f$ until it reaches the multiplicity and stays there exactly when the point is
isolated, over any field (Dayton, Zeng 2005). Ranks modulo a prime bound the true ones from below: nullities that stay
constant modulo a prime prove isolation, and so many primes that Hadamard's bound is passed prove the multiplicity.
Orders up to 500 columns are tried. A point on a break between pieces of a spline is decided if the derivatives up to
the order that is needed do not jump there: what is proved is then true on all sides. On the first and the last break of
an axis, the outermost pieces count as continued.
*/
Local_structure local_structure(const Constraint_system_d& system, const std::vector<Exact_rational>& point);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool satisfies(const Constraint_system_d& system,
                                              const std::vector<Exact_rational>& point)
{
  for (const Spline_function& function : system.equalities())
    if (!internal::vanishes_at(function, point))
      return false;
  for (const auto& inequality : system.inequalities())
    if (!is_satisfied(inequality.relation, CGAL::sign(internal::evaluate_exactly(inequality.function, point))))
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Local_structure local_structure(const Constraint_system_d& system,
                                                               const std::vector<Exact_rational>& point)
{
  constexpr std::size_t most_columns = 500;
  std::size_t previous = 1;
  for (int order = 1;; ++order) {
    const auto exponents = internal::exponents_up_to(point.size(), order);
    std::vector<std::vector<internal::Big_integer>> rows;
    if (exponents.size() > most_columns || !internal::macaulay_matrix(system, point, order, exponents, rows))
      return {};
    internal::Prime_sequence primes;
    const std::size_t rank = internal::rank_modulo(rows, primes.next()), nullity = exponents.size() - rank;
    if (nullity == previous)
      return {true, internal::rank_is_at_most(rows, rank, primes) ? static_cast<int>(nullity) : 0};
    previous = nullity;
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MULTIPLICITY_H
