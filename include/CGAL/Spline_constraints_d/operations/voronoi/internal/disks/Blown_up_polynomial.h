// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_BLOWN_UP_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_BLOWN_UP_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The signs that a function takes along paths, in order. Falling: from positive to negative, just once; or on some
// paths only negative. None: no piece matters.
enum class Sign_pattern { UNKNOWN, NONE, ZERO, POSITIVE, NEGATIVE, FALLING, FALLING_OR_NEGATIVE };

// The pattern of the pieces that matter, and whether the paths begin and end with some that do not.
struct Path_signs
{
  Sign_pattern pattern;
  bool begin_irrelevant = false, end_irrelevant = false;
};

/*
The signs of a polynomial p(a,b) for small a, b > 0, also where it is zero for a = b = 0. With d the lowest degree of a
term,

  p = a^d g(a,m), m = b/a,   p = b^d h(b,l), l = a/b,

with polynomials g and h that do not vanish for a = 0 or b = 0 but in the tangents of the curve p = 0, if its factors
a^i b^j, which are positive, are taken out before. The paths are those of constant a, where b grows: first m grows up to
a limit, then l decreases.
*/
class Blown_up_polynomial
{
public:
  // A piece of a path: a range of a or b, and of their ratio m or l.
  struct Chart_range
  {
    Interval radius, ratio;
    bool is_far;   // b and l
  };

private:
  static constexpr double most_ratio = 8;
  static constexpr int most_depth = 8, most_far_depth = 14;
  static constexpr double far_split = 8;

  std::size_t m_degree = 0;                      // d
  std::vector<std::vector<Interval>> m_rows;     // the coefficients of a^i b^j, in the order of i + j - d and j

  struct Value
  {
    Interval value, by_ratio, by_radius;
  };

  // What is known about a piece of a path.
  enum class Piece { POSITIVE, FALLING, NEGATIVE, UNKNOWN, IRRELEVANT };

  // The pieces of a path.
  struct Pieces
  {
    std::optional<Piece> first{}, last{};   // that matter
    bool has_sign = true;                   // all that matter have the same one
    bool begins_irrelevant = false, ends_irrelevant = false;

    // Whether a piece that matters may come next. Falling ones may have a maximum each, if there is something between
    // that does not matter.
    bool accepts(Piece piece) const
    {
      return piece != Piece::UNKNOWN &&
          (!last || *last < piece || (*last == piece && !(piece == Piece::FALLING && ends_irrelevant)));
    }

    // Returns whether their order is still that of one maximum.
    bool append(Piece piece)
    {
      const bool is_in_order = piece == Piece::IRRELEVANT || accepts(piece);
      ends_irrelevant = piece == Piece::IRRELEVANT;
      begins_irrelevant = begins_irrelevant || (ends_irrelevant && !first);
      if (ends_irrelevant)
        return true;
      has_sign = has_sign && piece != Piece::FALLING && (!last || *last == piece);
      if (!first)
        first = piece;
      last = piece;
      return is_in_order;
    }
  };

public:
  explicit Blown_up_polynomial(const Power_polynomial& p)
  {
    if (p.is_zero())
      return;
    int degree = std::numeric_limits<int>::max();
    for (const auto& [monomial, coefficient] : p.terms())
      degree = (std::min)(degree, monomial.total_degree());
    m_degree = static_cast<std::size_t>(degree);
    for (const auto& [monomial, coefficient] : p.terms()) {
      const std::size_t row = static_cast<std::size_t>(monomial.total_degree()) - m_degree;
      while (m_rows.size() <= row)
        m_rows.emplace_back(m_degree + m_rows.size() + 1, Interval(0));
      m_rows[row][static_cast<std::size_t>(monomial.exponent(1))] = interval_of(coefficient);
    }
  }

  // The same without its factors a^i b^j.
  static Blown_up_polynomial without_common_powers(const Power_polynomial& p)
  {
    Power_polynomial result = p;
    for (const int variable : {0, 1}) {
      int common = std::numeric_limits<int>::max();
      for (const auto& [monomial, coefficient] : result.terms())
        common = (std::min)(common, monomial.exponent(variable));
      Power_polynomial divided;
      for (const auto& [monomial, coefficient] : result.terms())
        divided += Power_polynomial(coefficient) *
            power_product(monomial.with_exponent(variable, monomial.exponent(variable) - common));
      result = std::move(divided);
    }
    return Blown_up_polynomial(result);
  }

  bool is_zero() const { return m_rows.empty(); }
  std::size_t degree() const { return m_degree; }

  // The polynomial divided by the power d of a or b.
  Interval operator()(const Chart_range& range) const { return at(range.radius, range.ratio, range.is_far).value; }

  // The same, and its derivative by the ratio.
  std::array<Interval, 2> with_slope(const Chart_range& range) const
  {
    const Value value = at(range.radius, range.ratio, range.is_far);
    return {value.value, value.by_ratio};
  }

  // The signs for all a in a range, where b runs over another one, without the pieces that do not matter; zeros of
  // factors at their begins do not count.
  template <class Is_irrelevant>
  Path_signs signs(const Range& a, const Range& b, const Is_irrelevant& is_irrelevant) const
  {
    if (is_zero())
      return {Sign_pattern::ZERO};
    Pieces pieces;
    const double first = (Interval(b.begin) / Interval(a.end)).inf();
    const double last = a.begin > 0 ? (std::min)(most_ratio, (Interval(b.end) / Interval(a.begin)).sup()) : most_ratio;
    if (first < last && !append_ratios(a, {first, last}, 0, is_irrelevant, pieces))
      return {Sign_pattern::UNKNOWN};
    const Range far{(std::max)(b.begin, (Interval(most_ratio) * Interval(a.begin)).inf()), b.end};
    if (far.begin < far.end && !append_far(a, far, {0, 1 / most_ratio}, 0, is_irrelevant, pieces))
      return {Sign_pattern::UNKNOWN};
    return {pattern(pieces, a, b, is_irrelevant), pieces.begins_irrelevant, pieces.ends_irrelevant};
  }

  Sign_pattern pattern(const Range& a, const Range& b) const
  {
    return signs(a, b, [](const Chart_range&) { return false; }).pattern;
  }

private:
  template <class Is_irrelevant>
  Sign_pattern pattern(const Pieces& pieces, const Range& a, const Range& b, const Is_irrelevant& is_irrelevant) const
  {
    if (!pieces.first)
      return pieces.begins_irrelevant ? Sign_pattern::NONE : Sign_pattern::UNKNOWN;
    if (pieces.has_sign && !pieces.begins_irrelevant && !pieces.ends_irrelevant)
      return *pieces.first == Piece::POSITIVE ? Sign_pattern::POSITIVE : Sign_pattern::NEGATIVE;
    const int begin = pieces.begins_irrelevant && !(b.begin > 0) ? 1 : sign_at(a, b.begin, 1, is_irrelevant, 0),
              end = sign_at(a, b.end, -1, is_irrelevant, 0);
    if (begin < 0 || end > 0)
      return begin < 0 ? Sign_pattern::NEGATIVE : Sign_pattern::POSITIVE;
    return end == 0 ? Sign_pattern::UNKNOWN : begin == 0 ? Sign_pattern::FALLING_OR_NEGATIVE : Sign_pattern::FALLING;
  }

  static bool is_zero_number(const Interval& x) { return x.inf() == 0 && x.sup() == 0; }

  static Power_polynomial power_product(const Monomial& monomial)
  {
    Power_polynomial result(1);
    for (const auto& [variable, exponent] : monomial.powers)
      for (int k = 0; k < exponent; ++k)
        result *= Power_polynomial::variable(variable);
    return result;
  }

  // The same, where some sign stands for what does not matter: that may be the ends of some of the paths only.
  template <class Is_irrelevant>
  int sign_at(const Range& a, double b, int irrelevant_sign, const Is_irrelevant& is_irrelevant, int depth) const
  {
    if (b > 0 && is_irrelevant(Chart_range{Interval(b), a.interval() / Interval(b), true}))
      return irrelevant_sign;
    const int sign = sign_at(a, b);
    if (sign != 0 || depth == most_depth || !(a.begin < a.end))
      return sign;
    const int first = sign_at({a.begin, a.middle()}, b, irrelevant_sign, is_irrelevant, depth + 1);
    return first != 0 && first == sign_at({a.middle(), a.end}, b, irrelevant_sign, is_irrelevant, depth + 1) ? first
                                                                                                             : 0;
  }

  // The sign for all a > 0 and one b.
  int sign_at(const Range& a, double b) const
  {
    if (b > 0)
      return certain_sign(at(Interval(b), a.interval() / Interval(b), true).value);
    // p(a,0), where a power of a may be a factor
    const auto first =
        std::find_if(m_rows.begin(), m_rows.end(), [](const auto& row) { return !is_zero_number(row.front()); });
    Interval value(0);
    for (auto row = m_rows.end(); row != first; )
      value = value * a.interval() + (--row)->front();
    return certain_sign(value);
  }

  static Piece piece(const Interval& value, const Interval& derivative)
  {
    return value.inf() > 0     ? Piece::POSITIVE
        : value.sup() < 0      ? Piece::NEGATIVE
        : derivative.sup() < 0 ? Piece::FALLING
                               : Piece::UNKNOWN;
  }

  template <class Is_irrelevant>
  bool append_ratios(const Range& a, const Range& m, int depth, const Is_irrelevant& is_irrelevant,
                     Pieces& pieces) const
  {
    if (is_irrelevant(Chart_range{a.interval(), m.interval(), false}))
      return pieces.append(Piece::IRRELEVANT);
    const Value g = at(a.interval(), m.interval(), false);
    const Interval centered =
        at(a.interval(), Interval(m.middle()), false).value + g.by_ratio * (m.interval() - Interval(m.middle()));
    Piece found = piece(common_part(g.value, centered), g.by_ratio);
    if (found == Piece::UNKNOWN && is_zero_in_corner(false) && !(a.begin > 0) && !(m.begin > 0))
      found = piece_of_dominant_sign(a.end, m.end, false);
    if (pieces.accepts(found) || depth == most_depth)   // else smaller ones may not matter
      return pieces.append(found);
    return append_ratios(a, {m.begin, m.middle()}, depth + 1, is_irrelevant, pieces) &&
        append_ratios(a, {m.middle(), m.end}, depth + 1, is_irrelevant, pieces);
  }

  // Whether g(0,0) = 0 or h(0,0) = 0.
  bool is_zero_in_corner(bool is_far) const { return is_zero_number(is_far ? m_rows[0].back() : m_rows[0].front()); }

  /*
  The sign of g or h for positive radii and ratios up to some numbers, if each term of the other sign is a multiple of a
  term of this sign, and all of these multiples are less than 1 together.
  */
  Piece piece_of_dominant_sign(double radius, double ratio, bool is_far) const
  {
    struct Term
    {
      std::size_t radius, ratio;   // exponents
      Interval coefficient;
    };
    std::array<std::vector<Term>, 2> terms;   // with negative coefficients, and with positive ones
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (std::size_t k = 0; k < m_rows[i].size(); ++k)
        if (const Interval& c = m_rows[i][k]; !is_zero_number(c) && certain_sign(c) == 0)
          return Piece::UNKNOWN;
        else if (!is_zero_number(c))
          terms[c.inf() > 0].push_back({i, is_far ? m_rows[i].size() - 1 - k : k, CGAL::abs(c)});
    const auto power = [](double x, std::size_t exponent) {
      Interval result(1);
      for (; exponent > 0; --exponent)
        result *= Interval(x);
      return result;
    };
    const auto is_dominant = [&](bool sign) {
      std::vector<Term> left = terms[sign];   // with what is left of their coefficients
      return std::all_of(terms[!sign].begin(), terms[!sign].end(), [&](const Term& other) {
        const auto is_better = [&](const Term& a, const Term& b) {
          const auto divides = [&](const Term& t) { return t.radius <= other.radius && t.ratio <= other.ratio; };
          return std::pair(divides(a), a.coefficient.inf()) < std::pair(divides(b), b.coefficient.inf());
        };
        const auto best = std::max_element(left.begin(), left.end(), is_better);
        if (best == left.end() || best->radius > other.radius || best->ratio > other.ratio)
          return false;
        best->coefficient -=
            other.coefficient * power(radius, other.radius - best->radius) * power(ratio, other.ratio - best->ratio);
        return best->coefficient.inf() > 0;
      });
    };
    return is_dominant(true) ? Piece::POSITIVE : is_dominant(false) ? Piece::NEGATIVE : Piece::UNKNOWN;
  }

  // By the derivatives of h, where h(0,0) = 0: along the path its derivative is h_b - (l/b) h_l.
  static Piece piece_at_far_corner(const Value& h)
  {
    const int by_radius = certain_sign(h.by_radius), by_ratio = certain_sign(h.by_ratio);
    if (by_radius * by_ratio == 0)
      return Piece::UNKNOWN;
    return by_radius > 0 && by_ratio > 0 ? Piece::POSITIVE
        : by_radius > 0                  ? Piece::UNKNOWN
        : by_ratio > 0                   ? Piece::FALLING
                                         : Piece::NEGATIVE;
  }

  template <class Is_irrelevant>
  bool append_far(const Range& a, Range b, const Range& ratios, int depth, const Is_irrelevant& is_irrelevant,
                  Pieces& pieces) const
  {
    b.begin = (std::max)(b.begin, (Interval(a.begin) / Interval(ratios.end)).inf());
    if (ratios.begin > 0)
      b.end = (std::min)(b.end, (Interval(a.end) / Interval(ratios.begin)).sup());
    if (b.end < b.begin)
      return true;   // no path goes there
    const double least = (std::max)(ratios.begin, (Interval(a.begin) / Interval(b.end)).inf());
    const double most = b.begin > 0 ? (std::min)(ratios.end, (Interval(a.end) / Interval(b.begin)).sup()) : ratios.end;
    if (most < least)
      return true;
    const Interval l(least, most);
    if (is_irrelevant(Chart_range{b.interval(), l, true}))
      return pieces.append(Piece::IRRELEVANT);
    const Value h = at(b.interval(), l, true);
    const bool is_corner = is_zero_in_corner(true) && !(least > 0) && !(b.begin > 0);
    Piece found = is_corner ? piece_at_far_corner(h) : piece(h.value, b.interval() * h.by_radius - l * h.by_ratio);
    if (is_corner && found == Piece::UNKNOWN)
      found = piece_of_dominant_sign(b.end, most, true);
    if (pieces.accepts(found) || depth == most_far_depth)
      return pieces.append(found);
    // Paths pass large l and small b first.
    const double ratio = most / far_split;
    const bool is_ratio_split = depth % 2 == 0 && least < ratio;
    const auto [first_ratios, first_b] =
        is_ratio_split ? std::pair(Range{ratio, most}, b) : std::pair(ratios, Range{b.begin, b.middle()});
    const auto [last_ratios, last_b] =
        is_ratio_split ? std::pair(Range{least, ratio}, b) : std::pair(ratios, Range{b.middle(), b.end});
    return append_far(a, first_b, first_ratios, depth + 1, is_irrelevant, pieces) &&
        append_far(a, last_b, last_ratios, depth + 1, is_irrelevant, pieces);
  }

  // g or h and its derivatives, by Horner's rule.
  Value at(const Interval& radius, const Interval& ratio, bool is_inverse) const
  {
    Value result{Interval(0), Interval(0), Interval(0)};   // a default interval is no number
    for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
      Interval value(0), derivative(0);
      for (std::size_t k = row->size(); k-- > 0;) {
        derivative = derivative * ratio + value;
        value = value * ratio + (*row)[is_inverse ? row->size() - 1 - k : k];
      }
      result.by_radius = result.by_radius * radius + result.value;
      result.value = result.value * radius + value;
      result.by_ratio = result.by_ratio * radius + derivative;
    }
    return result;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_BLOWN_UP_POLYNOMIAL_H
