// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_UNIVARIATE_VERIFICATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_UNIVARIATE_VERIFICATION_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/exact_enclosures.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace verification {

/*
Proofs about systems in one unknown by Sturm's theorem, in rational arithmetic. The solver isolates roots by Descartes'
rule instead, so that an error there cannot hide here.
*/
namespace univariate {

// In power form; the last coefficient is not zero.
using Coefficients = std::vector<Exact_rational>;

inline void trim(Coefficients& p)
{
  while (!p.empty() && is_zero(p.back()))
    p.pop_back();
}

// Multiplied by a positive number, with integers without a common divisor: keeps remainders short.
inline Coefficients primitive(const Coefficients& p)
{
  Exact_integer denominator(1), divisor(0);
  for (const Exact_rational& c : p) {
    const Rational_parts parts = parts_of(c);
    const Exact_integer common = CGAL::gcd(denominator, parts.denominator);
    denominator = CGAL::integral_division(denominator, common) * parts.denominator;
  }
  const Exact_rational factor = compose(denominator, Exact_integer(1));
  for (const Exact_rational& c : p)
    divisor = CGAL::gcd(divisor, parts_of(Exact_rational(c * factor)).numerator);
  Coefficients result;
  for (const Exact_rational& c : p)
    result.push_back(c * factor / absolute(compose(divisor, Exact_integer(1))));
  return result;
}

inline CGAL::Sign sign_at(const Coefficients& p, const Exact_rational& x)
{
  Exact_rational sum(0);
  for (std::size_t k = p.size(); k-- > 0;)
    sum = sum * x + p[k];
  return CGAL::sign(sum);
}

inline Coefficients derivative(const Coefficients& p)
{
  Coefficients result;
  for (std::size_t k = 1; k < p.size(); ++k)
    result.push_back(p[k] * Exact_rational(static_cast<int>(k)));
  return result;
}

inline Coefficients product(const Coefficients& p, const Coefficients& q)
{
  Coefficients result(p.empty() || q.empty() ? 0 : p.size() + q.size() - 1, Exact_rational(0));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < q.size(); ++k)
      result[i + k] += p[i] * q[k];
  return result;
}

// Divides p by q, not zero: p becomes the remainder, and the quotient is returned.
inline Coefficients divide(Coefficients& p, const Coefficients& q)
{
  Coefficients quotient(p.size() < q.size() ? 0 : p.size() - q.size() + 1, Exact_rational(0));
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = p[k + q.size() - 1] / q.back();
    for (std::size_t i = 0; i < q.size(); ++i)
      p[k + i] -= quotient[k] * q[i];
  }
  trim(p);
  return quotient;
}

inline Coefficients common_divisor(Coefficients p, Coefficients q)
{
  while (!q.empty()) {
    divide(p, q);
    p = primitive(p);
    std::swap(p, q);
  }
  return p;
}

// Counts the distinct roots of a polynomial that is not zero.
class Sturm_chain
{
  std::vector<Coefficients> m_chain;

public:
  explicit Sturm_chain(const Coefficients& polynomial)
  {
    Coefficients rest = polynomial;
    m_chain.push_back(primitive(divide(rest, common_divisor(polynomial, derivative(polynomial)))));
    m_chain.push_back(derivative(m_chain[0]));
    while (!m_chain.back().empty()) {
      Coefficients next = m_chain[m_chain.size() - 2];
      divide(next, m_chain.back());
      for (Exact_rational& c : next)
        c = -c;
      m_chain.push_back(primitive(next));
    }
  }

  CGAL::Sign sign_at(const Exact_rational& x) const { return univariate::sign_at(m_chain[0], x); }

  // In the open interval.
  int roots_between(const Exact_rational& lower, const Exact_rational& upper) const
  {
    return lower < upper ? variations_at(lower) - variations_at(upper) - (sign_at(upper) == CGAL::ZERO) : 0;
  }

private:
  int variations_at(const Exact_rational& x) const
  {
    int result = 0, last = 0;
    for (const Coefficients& p : m_chain)
      if (const int sign = univariate::sign_at(p, x); sign != 0) {
        result += sign * last < 0;
        last = sign;
      }
    return result;
  }
};

// A function between two neighbouring breaks, where it is one polynomial; beyond the first and the last one the next
// piece.
inline Coefficients piece_at(const Spline_function& function, const Exact_rational& x, bool is_from_left)
{
  Coefficients sum;
  for (const Spline_term& term : function.terms()) {
    std::size_t cell = 0;
    if (!term.variables.empty())
      while (cell + 1 < term.cells(0) && (is_from_left ? term.breaks[0][cell + 1] < x : term.breaks[0][cell + 1] <= x))
        ++cell;
    const Coefficients& piece = term.pieces[cell];
    sum.resize((std::max)(sum.size(), piece.size()), Exact_rational(0));
    for (std::size_t k = 0; k < piece.size(); ++k)
      sum[k] += piece[k];
  }
  trim(sum);
  return sum;
}

class Proof
{
  const Constraint_system_d& m_system;
  Range m_range;                         // of the box and the domain
  std::vector<Exact_rational> m_points;  // its ends and the breaks between

public:
  Proof(const Constraint_system_d& system, const Range& box)
    : m_system(system), m_range{(std::max)(box.lower, system.domain(0).first),
                                (std::min)(box.upper, system.domain(0).second)}
  {
    m_points = {m_range.lower, m_range.upper};
    for_each_function([&](const Spline_function& function) {
      for (const Spline_term& term : function.terms())
        for (const auto& breaks : term.breaks)
          std::copy_if(breaks.begin(), breaks.end(), std::back_inserter(m_points),
                       [&](const Exact_rational& b) { return m_range.lower < b && b < m_range.upper; });
    });
    std::sort(m_points.begin(), m_points.end());
    m_points.erase(std::unique(m_points.begin(), m_points.end()), m_points.end());
  }

  bool succeeds(Solution_kind kind) const
  {
    bool is_defined = m_range.lower <= m_range.upper;
    for_each_function(
        [&](const Spline_function& function) { is_defined = is_defined && is_continuous(function, {m_range}); });
    if (!is_defined)
      return false;
    switch (kind) {
    case Solution_kind::CERTIFIED: return has_one_solution();
    case Solution_kind::CLUSTER: return has_solution();
    case Solution_kind::CONTINUUM: return are_solutions();
    case Solution_kind::UNDECIDED: break;
    }
    return false;
  }

private:
  template <class Visitor>
  void for_each_function(const Visitor& visit) const
  {
    for (const Spline_function& function : m_system.equalities())
      visit(function);
    for (const auto& inequality : m_system.inequalities())
      visit(inequality.function);
  }

  // The common divisor of the equalities right of a point.
  Coefficients common_equality(const Exact_rational& x) const
  {
    Coefficients result;
    for (const Spline_function& function : m_system.equalities())
      result = common_divisor(result, piece_at(function, x, false));
    return result;
  }

  bool are_equalities_zero_at(const Exact_rational& x) const
  {
    return std::all_of(
        m_system.equalities().begin(), m_system.equalities().end(),
        [&](const Spline_function& function) { return sign_at(piece_at(function, x, false), x) == CGAL::ZERO; });
  }

  bool are_inequalities_satisfied_at(const Exact_rational& x) const
  {
    return std::all_of(m_system.inequalities().begin(), m_system.inequalities().end(), [&](const auto& inequality) {
      return is_satisfied(inequality.relation, sign_at(piece_at(inequality.function, x, false), x));
    });
  }

  // Some equality has slopes of one sign on both sides; at an end of the domain the side inside counts.
  bool is_regular_at(const Exact_rational& x) const
  {
    const bool has_left = m_system.domain(0).first < x, has_right = x < m_system.domain(0).second;
    return std::any_of(m_system.equalities().begin(), m_system.equalities().end(),
                       [&](const Spline_function& function) {
                         const auto slope = [&](bool is_from_left) {
                           return sign_at(derivative(piece_at(function, x, is_from_left)), x);
                         };
                         return slope(has_left) * slope(!has_right) > 0;
                       });
  }

  // The inequalities at the only root of a polynomial between two points of one piece.
  bool are_inequalities_satisfied(const Coefficients& polynomial, const Range& range) const
  {
    const Sturm_chain chain(polynomial);
    return std::all_of(m_system.inequalities().begin(), m_system.inequalities().end(), [&](const auto& inequality) {
      const Coefficients h = piece_at(inequality.function, range.lower, false);
      if (h.empty() || Sturm_chain(common_divisor(polynomial, h)).roots_between(range.lower, range.upper) > 0)
        return is_satisfied(inequality.relation, CGAL::ZERO);
      const Sturm_chain roots_of_h(h);
      Range place = range;
      for (;;) {
        const Exact_rational middle = (place.lower + place.upper) / Exact_rational(2);
        if (chain.sign_at(middle) == CGAL::ZERO || roots_of_h.roots_between(place.lower, place.upper) == 0)
          return is_satisfied(inequality.relation, sign_at(h, middle));
        (chain.roots_between(place.lower, middle) > 0 ? place.upper : place.lower) = middle;
      }
    });
  }

  bool has_one_solution() const
  {
    int roots = 0;
    bool is_proved = false;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (are_equalities_zero_at(m_points[i])) {
        ++roots;
        is_proved = is_regular_at(m_points[i]) && are_inequalities_satisfied_at(m_points[i]);
      }
      if (i + 1 == m_points.size())
        break;
      const Coefficients common = common_equality(m_points[i]);
      if (common.empty())
        return false;
      const int inside = Sturm_chain(common).roots_between(m_points[i], m_points[i + 1]);
      roots += inside;
      if (inside == 1)
        is_proved =
            Sturm_chain(common_divisor(common, derivative(common))).roots_between(m_points[i], m_points[i + 1]) == 0 &&
            are_inequalities_satisfied(common, {m_points[i], m_points[i + 1]});
    }
    return roots == 1 && is_proved;
  }

  bool has_solution() const
  {
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if ((are_equalities_zero_at(m_points[i]) && are_inequalities_satisfied_at(m_points[i])) ||
          (i + 1 < m_points.size() && has_solution_between({m_points[i], m_points[i + 1]})))
        return true;
    return false;
  }

  // Where all equalities are zero, the roots of the inequalities are tried.
  bool has_solution_between(const Range& part) const
  {
    Coefficients polynomial = common_equality(part.lower);
    if (polynomial.empty()) {
      polynomial.emplace_back(1);
      for (const auto& inequality : m_system.inequalities())
        if (const Coefficients h = piece_at(inequality.function, part.lower, false); !h.empty())
          polynomial = product(polynomial, h);
    }
    const Sturm_chain chain(polynomial);
    std::vector<Range> stack{part};
    while (!stack.empty()) {
      const Range range = stack.back();
      stack.pop_back();
      const int roots = chain.roots_between(range.lower, range.upper);
      if (roots == 1 && are_inequalities_satisfied(polynomial, range))
        return true;
      if (roots < 2)
        continue;
      const Exact_rational middle = (range.lower + range.upper) / Exact_rational(2);
      if (chain.sign_at(middle) == CGAL::ZERO && are_inequalities_satisfied_at(middle))
        return true;
      stack.push_back({range.lower, middle});
      stack.push_back({middle, range.upper});
    }
    return false;
  }

  // All points of the interval are solutions, up to a rounding error at its ends.
  bool are_solutions() const
  {
    const Exact_rational size = (std::max)(absolute(m_range.lower), absolute(m_range.upper)),
                         domain = m_system.domain(0).second - m_system.domain(0).first;
    const Exact_rational margin = size * Exact_rational(0x1p-50) + domain * Exact_rational(0x1p-100);
    if (m_range.upper - m_range.lower <= margin + margin)
      return false;
    for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
      const Range part{i == 0 ? Exact_rational(m_points[i] + margin) : m_points[i],
                       i + 2 == m_points.size() ? Exact_rational(m_points[i + 1] - margin) : m_points[i + 1]};
      if (!common_equality(m_points[i]).empty())
        return false;
      for (const auto& inequality : m_system.inequalities())
        if (part.lower < part.upper &&
            !is_satisfied_on(piece_at(inequality.function, m_points[i], false), inequality.relation, part))
          return false;
    }
    return true;
  }

  // A polynomial satisfies a relation to zero on an interval: its signs between its roots do, and, if it has any, zero
  // does.
  static bool is_satisfied_on(const Coefficients& polynomial, Relation relation, const Range& part)
  {
    if (polynomial.empty())
      return is_satisfied(relation, CGAL::ZERO);
    const Sturm_chain chain(polynomial);
    std::vector<Range> stack{part};
    while (!stack.empty()) {
      const Range range = stack.back();
      stack.pop_back();
      const int roots = chain.roots_between(range.lower, range.upper);
      const CGAL::Sign signs[] = {sign_at(polynomial, range.lower), sign_at(polynomial, range.upper)};
      const bool is_zero_at_end = signs[0] == CGAL::ZERO || signs[1] == CGAL::ZERO;
      const Exact_rational middle = (range.lower + range.upper) / Exact_rational(2);
      if ((roots > 0 || is_zero_at_end) && !is_satisfied(relation, CGAL::ZERO))
        return false;
      if (roots == 0) {
        if (!is_satisfied(relation, sign_at(polynomial, middle)))
          return false;
      } else if (roots == 1 && !is_zero_at_end) {
        if (!is_satisfied(relation, signs[0]) || !is_satisfied(relation, signs[1]))
          return false;
      } else {
        stack.push_back({range.lower, middle});
        stack.push_back({middle, range.upper});
      }
    }
    return true;
  }
};

} // namespace univariate
} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_UNIVARIATE_VERIFICATION_H
