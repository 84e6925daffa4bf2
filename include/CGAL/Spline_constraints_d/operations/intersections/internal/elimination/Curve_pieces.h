// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_CURVE_PIECES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_CURVE_PIECES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Piece_elimination.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A parameter of a curve: a break, or a root inside of a piece on [0,1].
struct Place_on_curve
{
  std::size_t piece; // of a break: the one that begins there, or else the last one
  std::optional<std::size_t> at_break;
  Exact_root root;

  bool is_break() const { return at_break.has_value(); }
};

// A piece, seen from its begin or its end.
struct Half_branch
{
  std::size_t piece;
  bool is_end;
};

/*
The pieces of two curves between their breaks, and what elimination tells of two of them, found once.
*/
template <int d>
class Curve_pieces
{
  const Patch_pair<d>& m_pair;
  std::function<void()> m_check;
  std::array<std::vector<Exact_rational>, 2> m_breaks;
  std::array<std::vector<std::optional<Integer_piece<d>>>, 2> m_pieces; // those that were asked for
  std::map<std::array<std::size_t, 3>, Piece_elimination<d>> m_eliminations;

public:
  //! \pre the operands are curves. `check` is called often, and may throw.
  Curve_pieces(const Patch_pair<d>& pair, std::function<void()> check) : m_pair(pair), m_check(std::move(check))
  {
    for (const std::size_t k : {0, 1}) {
      m_breaks[k] = pair[k].breaks(0);
      m_pieces[k].resize(m_breaks[k].size() - 1);
    }
  }

  const Patch_pair<d>& pair() const { return m_pair; }
  void check() const { m_check(); }
  const std::vector<Exact_rational>& breaks(std::size_t curve) const { return m_breaks[curve]; }
  std::size_t size(std::size_t curve) const { return m_pieces[curve].size(); }

  const Integer_piece<d>& piece(std::size_t curve, std::size_t index)
  {
    std::optional<Integer_piece<d>>& result = m_pieces[curve][index];
    if (!result) {
      m_check();
      result.emplace(m_pair[curve], Parameter_range{m_breaks[curve][index], m_breaks[curve][index + 1]});
    }
    return *result;
  }

  // Whether no piece is a point, and each one begins where the one before it ends.
  bool are_connected()
  {
    for (const std::size_t k : {0, 1})
      for (std::size_t i = 0; i < size(k); ++i)
        if (piece(k, i).is_point() ||
            (i > 0 && !are_same_point(piece(k, i - 1).end_point(true), piece(k, i).end_point(false))))
          return false;
    return true;
  }

  // Of the parameter of a piece of one curve, with a piece of the other one.
  Piece_elimination<d>& elimination(std::size_t curve, std::size_t index, std::size_t other)
  {
    const std::array key{curve, index, other};
    auto entry = m_eliminations.find(key);
    if (entry == m_eliminations.end())
      entry = m_eliminations.try_emplace(key, piece(curve, index), piece(1 - curve, other), m_check).first;
    return entry->second;
  }

  // On the whole curve.
  Parameter_range range(std::size_t curve, std::size_t piece, const Rational_interval& local) const
  {
    const Exact_rational &begin = m_breaks[curve][piece], length(m_breaks[curve][piece + 1] - begin);
    return {Exact_rational(begin + length * local.lower), Exact_rational(begin + length * local.upper)};
  }

  Parameter_range range(std::size_t curve, const Place_on_curve& place) const
  {
    if (!place.is_break())
      return range(curve, place.piece, {place.root.lower(), place.root.upper()});
    const Exact_rational& value = m_breaks[curve][*place.at_break];
    return {value, value};
  }

  Place_on_curve place_at_break(std::size_t curve, std::size_t index) const
  {
    const bool is_last = index == size(curve);
    return {is_last ? index - 1 : index, index, Exact_root(Exact_rational(is_last ? 1 : 0))};
  }

  // The parameters of one curve, in the pieces that meet a range, at a break of the other one; where it is closed, not
  // the last one. Breaks only where that is asked for.
  std::vector<Place_on_curve> places_of_break(std::size_t curve, const Parameter_range& range, std::size_t index,
                                              bool with_breaks)
  {
    const bool is_last = index == size(1 - curve);
    const auto point = piece(1 - curve, is_last ? index - 1 : index).end_point(is_last);
    std::vector<Place_on_curve> result;
    for (std::size_t i = 0; i < size(curve); ++i)
      if (m_breaks[curve][i] <= range.second && range.first <= m_breaks[curve][i + 1])
        for (Place_on_curve& place : places_of_point(curve, i, point))
          if (!place.is_break() ||
              (with_breaks && !(*place.at_break == size(curve) && m_pair.is_repeated_at_end(curve))))
            result.push_back(std::move(place));
    return result;
  }

  // The pieces that begin or end at a break, the last one also at the begin of a closed curve.
  std::vector<Half_branch> half_branches(std::size_t curve, const Place_on_curve& place) const
  {
    const std::size_t last = size(curve), index = *place.at_break;
    const bool is_seam = (index == 0 || index == last) && m_pair[curve].is_closed(0);
    std::vector<Half_branch> result;
    if (index > 0 || is_seam)
      result.push_back({(index > 0 ? index : last) - 1, true});
    if (index < last || is_seam)
      result.push_back({index < last ? index : 0, false});
    return result;
  }

private:
  static bool are_same_point(const std::array<Big_integer, d + 1>& p, const std::array<Big_integer, d + 1>& q)
  {
    for (std::size_t i = 0; i < d; ++i)
      if (p[i] * q[d] != q[i] * p[d])
        return false;
    return true;
  }

  // Those in a piece without its end, and the end of the last one.
  std::vector<Place_on_curve> places_of_point(std::size_t curve, std::size_t index,
                                              const std::array<Big_integer, d + 1>& point)
  {
    m_check();
    const Integer_piece<d>& own = piece(curve, index);
    const Exact_rational zero(0), one(1);
    Integer_polynomial common;
    for (std::size_t i = 0; i < d; ++i) {
      Integer_coefficients difference;
      add_multiple(difference, own[i], point[d]);
      add_multiple(difference, own.weight(), Big_integer(-point[i]));
      const Integer_polynomial f(std::move(difference));
      if (!f.is_zero()) {
        const std::vector<Big_integer> values = f.bernstein(zero, one).values;
        if (sign_variations(values) == 0 && values.front() != 0 && values.back() != 0)
          return {};
      }
      common = common_divisor(common, f);
    }
    std::vector<Place_on_curve> result;
    if (common.degree() < 1)
      return result;
    if (common.remove_root(zero) > 0)
      result.push_back(place_at_break(curve, index));
    if (common.remove_root(one) > 0 && index + 1 == size(curve))
      result.push_back(place_at_break(curve, index + 1));
    const auto go_on = [] { return false; };
    for (auto& [factor, exponent] : common.square_free_factors())
      for (Exact_root& root : isolate_roots(std::make_shared<const Integer_polynomial>(std::move(factor)), zero, one,
                                            go_on, [](const auto&, const auto&) {}))
        result.push_back({index, std::nullopt, std::move(root)});
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_CURVE_PIECES_H
