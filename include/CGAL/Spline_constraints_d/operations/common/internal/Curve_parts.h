// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_PARTS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/univariate_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/elimination_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Exact_parameters = std::vector<Exact_rational>;

inline bool is_part_of(const Parameter_box& box, const Parameter_box& outer)
{
  for (std::size_t j = 0; j < box.size(); ++j)
    if (box[j].first < outer[j].first || outer[j].second < box[j].second)
      return false;
  return true;
}

// A box of parameters that has one common point, a crossing in a smaller box, or none.
struct Settled_part
{
  Parameter_box box;
  std::optional<Parameter_box> crossing;
};

/*
Two curves, for proofs that a box of their parameters holds no common points but known ones: the box is cut at breaks
and at these points, then into quarters, and each part is looked at.
*/
template <int d>
class Curve_parts
{
  using Cells = std::array<std::size_t, 2>;

  const Patch_pair<d>& m_pair;
  std::vector<Parameter_box> m_overlaps;
  std::array<std::vector<Exact_rational>, 2> m_breaks;
  // of the parameters of the first and the second curve, on their cells
  std::map<Cells, std::array<std::optional<Exact_function>, 2>> m_eliminated;

public:
  // With the overlaps among what is known. \pre the operands are curves.
  Curve_parts(const Patch_pair<d>& pair, const std::vector<Common_point>& points)
    : m_pair(pair), m_breaks{pair[0].breaks(0), pair[1].breaks(0)}
  {
    for (const Common_point& point : points)
      if (point.kind == Intersection_kind::OVERLAP)
        m_overlaps.push_back(point.parameters);
  }

  // The common points in a box that are breaks of both curves.
  std::vector<Exact_parameters> common_breaks(const Parameter_box& box) const
  {
    std::vector<Exact_parameters> result;
    for (const Exact_rational& t : m_breaks[0])
      for (const Exact_rational& s : m_breaks[1])
        if (is_part_of({{t, t}, {s, s}}, box) && m_pair[0](Exact_parameters{t}) == m_pair[1](Exact_parameters{s}))
          result.push_back({t, s});
    return result;
  }

  // Those that are a break of one curve alone, which a piece of the other one passes through once, and no end of an
  // overlap: a parameter and a range.
  std::vector<Parameter_box> points_at_one_break(const Parameter_box& box)
    requires (d == 2)
  {
    std::vector<Parameter_box> result;
    for (const std::size_t k : {0, 1})
      for (std::size_t i = 0; i < m_breaks[k].size(); ++i) {
        const Exact_rational& t = m_breaks[k][i];
        if (t < box[k].first || box[k].second < t ||
            !passes_through(1 - k, box[1 - k], m_pair[k](Exact_parameters{t})) || may_run_along(k, i - 1, box) ||
            may_run_along(k, i, box))
          continue;
        result.push_back(box);
        result.back()[k] = {t, t};
      }
    return result;
  }

  /*
  Parts of a box in which all common points are known: one crossing, or none. Each is a range of the first parameter
  around a simple zero of the eliminated polynomial, with the range of the second one inside of a cell.
  */
  std::vector<Settled_part> parts_at_simple_zeros(const Parameter_box& box)
    requires (d == 2)
  {
    std::vector<Settled_part> result;
    if (has_few_cells(box))
      for (const Parameter_range& t : parts(box[0], m_breaks[0]))
        for (const Parameter_range& s : parts(box[1], m_breaks[1]))
          if (t.first < t.second && s.first < s.second)
            for (Settled_part& part : parts_at_simple_zeros(t, s))
              result.push_back(std::move(part));
    return result;
  }

  // Whether all common points in a box are given ones, with both parameters or in some parts, or belong to an overlap,
  // where there is one.
  bool holds_only(const Parameter_box& box, const std::vector<Exact_parameters>& points,
                  const Parameter_box* overlap = nullptr, const std::vector<Parameter_box>& known = {})
  {
    const auto is_known = [&](const Parameter_box& part) {
      return (overlap && is_part_of(part, *overlap)) || is_part_of_any(part, known) ||
          leads_apart_from_one(part, points);
    };
    const auto is_settled = [&](const auto& self, const Parameter_box& part, int depth) -> bool {
      if (is_known(part) || are_apart(part) || is_settled_by_elimination(part, points, known) ||
          is_in_overlap(part, points))
        return true;
      return depth > 0 &&
          all_parts(part, {Exact_parameters{middle_of(part[0])}, Exact_parameters{middle_of(part[1])}},
                    [&](const Parameter_box& quarter) { return self(self, quarter, depth - 1); });
    };
    const auto is_settled_between_breaks = [&](const Parameter_box& part) {
      constexpr int depth = 6;
      return has_few_cells(part) &&
          all_parts(part, m_breaks, [&](const Parameter_box& piece) { return is_settled(is_settled, piece, depth); });
    };
    return all_parts(box, {cuts(points, known, 0), cuts(points, known, 1)},
                     [&](const Parameter_box& part) { return is_known(part) || is_settled_between_breaks(part); });
  }

private:
  // Whether a curve has a point in a range inside of one cell, and has it once: its coordinates without those of the
  // point have a common factor with one zero there.
  bool passes_through(std::size_t curve, const Parameter_range& range, const std::array<Exact_rational, 2>& point) const
    requires (d == 2)
  {
    const std::size_t cell = cell_of(curve, range);
    if (!(m_breaks[curve][cell] < range.first && range.first < range.second &&
          range.second < m_breaks[curve][cell + 1]))
      return false;
    const Spline_patch<2> part = m_pair[curve].part(0, range);
    if (!(squared_norm(part.tangents(0)).lower > 0))
      return false;
    std::vector<Power_polynomial> coordinates;
    for (const std::size_t i : {0, 1})
      if (Power_polynomial f = univariate_polynomial(part.numerators()[i] - part.weight() * point[i]);
          !f.is_constant() || f.constant_term() != 0)
        coordinates.push_back(std::move(f));
    const std::optional<Common_factor> common = common_factor(coordinates);
    const auto sign_at = [&](int t) {
      return common ? CGAL::sign(common->factor(Exact_parameters{Exact_rational(t)})) : CGAL::ZERO;
    };
    return sign_at(0) * sign_at(1) < 0;
  }

  // Whether a cell of one curve, if there is one, may be on the curve that the other one is on in a box.
  bool may_run_along(std::size_t k, std::size_t cell, const Parameter_box& box)
    requires (d == 2)
  {
    return cell < m_breaks[k].size() - 1 && lies_on(k, cell, cell_of(1 - k, box[1 - k])).value_or(true);
  }

  // \pre The ranges are inside of cells.
  std::vector<Settled_part> parts_at_simple_zeros(const Parameter_range& t, const Parameter_range& s)
    requires (d == 2)
  {
    const Cells cells{cell_of(0, t), cell_of(1, s)};
    const std::optional<Exact_function>& all = eliminated(cells)[0];
    if (!all)
      return {};
    const Exact_function f = all->restricted(0, t.first, t.second), slope = f.derivative(0);
    const Exact_rational begin = m_breaks[1][cells[1]], length(m_breaks[1][cells[1] + 1] - begin);
    std::vector<std::array<Exact_function, 2>> quotients;
    std::vector<Settled_part> result;
    for (Exact_root& root :
         inner_roots(Bernstein_tensor<Exact_rational>({f.degree(0)}, f.coefficients()), power_of_two(-16))) {
      if (quotients.empty())
        quotients = parameter_quotients(piece(0, cells[0]), piece(1, cells[1]));
      constexpr int most_bits = 512;
      for (int bits = 32; bits <= most_bits; bits *= 2) {
        const Parameter_range around = range_around(root, power_of_two(-bits), t);
        if (!has_one_sign(range_of(slope, around)))
          continue;
        const std::optional<Rational_interval> partner = range_of_quotient(quotients, around);
        if (!partner)
          continue;
        const Parameter_range other{Exact_rational(begin + length * partner->lower),
                                    Exact_rational(begin + length * partner->upper)};
        const bool is_inside = s.first < other.first && other.second < s.second;
        if (!is_inside && !(other.second < s.first || s.second < other.first))
          continue;
        result.push_back({{around, s}, is_inside ? std::optional(Parameter_box{around, other}) : std::nullopt});
        break;
      }
    }
    return result;
  }

  // Around a root in (0,1), within the range that stands for [0,1].
  static Parameter_range range_around(Exact_root& root, const Exact_rational& width, const Parameter_range& range)
  {
    narrow(root, width);
    const Exact_rational length(range.second - range.first), margin(root.is_point() ? width : Exact_rational(0));
    const auto value = [&](const Exact_rational& x) { return Exact_rational(range.first + length * x); };
    return {value((std::max)(Exact_rational(root.lower() - margin), Exact_rational(0))),
            value((std::min)(Exact_rational(root.upper() + margin), Exact_rational(1)))};
  }

  static Rational_interval range_of(const Exact_function& f, const Parameter_range& range)
  {
    const Exact_function part = f.restricted(0, range.first, range.second);
    const auto [least, greatest] = std::minmax_element(part.coefficients().begin(), part.coefficients().end());
    return {*least, *greatest};
  }

  static bool has_one_sign(const Rational_interval& x) { return x.lower > 0 || x.upper < 0; }

  // Of the first one that has a divisor of one sign.
  static std::optional<Rational_interval> range_of_quotient(const std::vector<std::array<Exact_function, 2>>& quotients,
                                                            const Parameter_range& range)
  {
    for (const auto& [dividend, divisor] : quotients)
      if (const Rational_interval by = range_of(divisor, range); has_one_sign(by)) {
        const Exact_rational sign(by.lower > 0 ? 1 : -1);
        return range_of(dividend * sign, range) / range_of(divisor * sign, range);
      }
    return std::nullopt;
  }

  // The parts of a box between some values of the parameters.
  template <class Predicate>
  static bool all_parts(const Parameter_box& box, const std::array<std::vector<Exact_rational>, 2>& cuts,
                        const Predicate& is_true)
  {
    for (const Parameter_range& t : parts(box[0], cuts[0]))
      for (const Parameter_range& s : parts(box[1], cuts[1]))
        if (!is_true({t, s}))
          return false;
    return true;
  }

  // \pre The cuts ascend.
  static std::vector<Parameter_range> parts(const Parameter_range& range, const std::vector<Exact_rational>& cuts)
  {
    std::vector<Parameter_range> result{range};
    for (const Exact_rational& cut : cuts)
      if (range.first < cut && cut < range.second) {
        result.back().second = cut;
        result.emplace_back(cut, range.second);
      }
    return result;
  }

  static bool is_end(const Exact_rational& x, const Parameter_range& range)
  {
    return x == range.first || x == range.second;
  }

  static bool is_part_of_any(const Parameter_box& box, const std::vector<Parameter_box>& others)
  {
    return std::any_of(others.begin(), others.end(),
                       [&](const Parameter_box& other) { return is_part_of(box, other); });
  }

  static std::vector<Exact_rational> cuts(const std::vector<Exact_parameters>& points,
                                          const std::vector<Parameter_box>& parts, std::size_t curve)
  {
    std::vector<Exact_rational> result;
    for (const Exact_parameters& point : points)
      result.push_back(point[curve]);
    for (const Parameter_box& part : parts)
      result.insert(result.end(), {part[curve].first, part[curve].second});
    std::sort(result.begin(), result.end());
    return result;
  }

  // So that a box that a limit of the solver left is not worked on without limit.
  bool has_few_cells(const Parameter_box& box) const
  {
    constexpr std::size_t most = 64;
    return (cell_of(0, box[0]) + 1 - cell_of(0, {box[0].first, box[0].first})) *
        (cell_of(1, box[1]) + 1 - cell_of(1, {box[1].first, box[1].first})) <=
        most;
  }

  bool leads_apart_from_one(const Parameter_box& part, const std::vector<Exact_parameters>& points) const
  {
    return std::any_of(points.begin(), points.end(), [&](const Exact_parameters& point) {
      return touches(part, point) && (!has_extent(part) || lead_apart(part, point));
    });
  }

  // At a corner.
  static bool touches(const Parameter_box& part, const Exact_parameters& point)
  {
    return is_end(point[0], part[0]) && is_end(point[1], part[1]);
  }

  bool are_apart(const Parameter_box& part) const
  {
    const Vector_bounds<d> difference = m_pair[0].part(0, part[0]).values() - m_pair[1].part(0, part[1]).values();
    return std::any_of(difference.begin(), difference.end(), [](const Rational_interval& x) { return !has_zero(x); });
  }

  // By the mean value theorem, the points of a part with a known corner are there plus something times a vector within
  // the bounds of the derivative. Whether no vectors of the two parts have the same direction.
  bool lead_apart(const Parameter_box& part, const Exact_parameters& corner) const
  {
    std::array<Vector_bounds<d>, 2> directions;
    for (const std::size_t k : {0, 1}) {
      if (!(part[k].first < part[k].second))
        continue;
      directions[k] = m_pair[k].part(0, part[k]).tangents(0);
      if (corner[k] == part[k].second)
        directions[k] = Vector_bounds<d>{} - directions[k];
    }
    for (const std::size_t k : {0, 1})
      if (!(part[k].first < part[k].second))   // one of them is the corner alone
        return !(squared_norm(directions[1 - k]).lower == 0);
    return !may_be_parallel<d>(directions[0], directions[1]) || dot(directions[0], directions[1]).upper < 0;
  }

  // Each parameter can have no values but ends of the part, and where both have such, there are known points or none.
  bool is_settled_by_elimination(const Parameter_box& part, const std::vector<Exact_parameters>& points,
                                 const std::vector<Parameter_box>& known)
  {
    if constexpr (d == 2) {
      std::array<Zero_places, 2> zeros;
      for (const std::size_t k : {0, 1}) {
        const std::optional<Exact_function>& f = eliminated({cell_of(0, part[0]), cell_of(1, part[1])})[k];
        zeros[k] = !f                        ? Zero_places{true, true, true}
            : part[k].first < part[k].second ? zero_places(f->restricted(0, part[k].first, part[k].second))
                                             : Zero_places{true, false, false};
        if (zeros[k].are_none())
          return true;
      }
      const auto values = [&](std::size_t k) {
        std::vector<Exact_rational> result;
        if (zeros[k].at_lower_end) result.push_back(part[k].first);
        if (zeros[k].at_upper_end) result.push_back(part[k].second);
        return result;
      };
      if (zeros[0].elsewhere || zeros[1].elsewhere) {
        const auto has_known_ends = [&](std::size_t k) {
          const std::vector<Exact_rational> ends = values(k);
          return !zeros[k].elsewhere && std::all_of(ends.begin(), ends.end(), [&](const Exact_rational& end) {
            Parameter_box face = part;
            face[k] = {end, end};
            return is_end_of_overlap(part, k, end, points) || is_part_of_any(face, known) ||
                leads_apart_from_one(face, points);
          });
        };
        return has_known_ends(0) || has_known_ends(1);
      }
      for (const Exact_rational& t : values(0))
        for (const Exact_rational& s : values(1))
          if (std::find(points.begin(), points.end(), Exact_parameters{t, s}) == points.end() &&
              m_pair[0](Exact_parameters{t}) == m_pair[1](Exact_parameters{s}))
            return false;
      return true;
    }
    return false;
  }

  // Whether all common points in a part belong to known overlaps of lines or conics.
  bool is_in_overlap(const Parameter_box& part, const std::vector<Exact_parameters>& points)
  {
    if constexpr (d == 2)
      return runs_along(0, cell_of(0, part[0]), part, points) || runs_along(1, cell_of(1, part[1]), part, points);
    return false;
  }

  // The same for those at an end of the range of one curve, where the overlap ends.
  bool is_end_of_overlap(const Parameter_box& part, std::size_t k, const Exact_rational& end,
                         const std::vector<Exact_parameters>& points) requires(d == 2)
  {
    const std::size_t cell = cell_of(k, part[k]);
    return (end == m_breaks[k][cell] && cell > 0 && runs_along(k, cell - 1, part, points)) ||
        (end == m_breaks[k][cell + 1] && cell + 2 < m_breaks[k].size() && runs_along(k, cell + 1, part, points));
  }

  /*
  Whether a known overlap holds the common points of a part with a cell of one curve, as this lies on the line or conic
  of the piece of the other one that the part is in: next to each common point inside of this piece there are others,
  for it passes through it on a smooth curve. At its ends, only a given point may be.
  */
  bool runs_along(std::size_t k, std::size_t cell, const Parameter_box& part,
                  const std::vector<Exact_parameters>& points) requires(d == 2)
  {
    const std::size_t other = cell_of(1 - k, part[1 - k]);
    const auto is_known_at = [&](const Exact_rational& end) {
      Parameter_box face = part;
      face[1 - k] = {end, end};
      return end < part[1 - k].first || part[1 - k].second < end || leads_apart_from_one(face, points);
    };
    Parameter_box common = part;
    common[k] = {(std::max)(part[k].first, m_breaks[k][cell]), (std::min)(part[k].second, m_breaks[k][cell + 1])};
    const bool is_inside = is_known_at(m_breaks[1 - k][other]) && is_known_at(m_breaks[1 - k][other + 1]);
    return is_inside && is_part_of_any(common, m_overlaps) && is_on_line_or_conic(piece(1 - k, other)) &&
        has_length(k, cell) && lies_on(k, cell, other).value_or(false) &&
        squared_norm(m_pair[1 - k].part(0, part[1 - k]).tangents(0)).lower > 0;
  }

  static bool is_on_line_or_conic(const Spline_patch<2>& piece)
    requires (d == 2)
  {
    if (power_coefficients(piece).size() <= 3)
      return true;
    const auto [begin, end] = piece.domain(0);
    const auto a = piece(Exact_parameters{begin}), b = piece(Exact_parameters{end});
    const Exact_rational dx(b[0] - a[0]), dy(b[1] - a[1]), offset(a[0] * dy - a[1] * dx);
    return a != b && is_zero(piece.numerators()[1] * dx - piece.numerators()[0] * dy + piece.weight() * offset);
  }

  static bool is_zero(const Exact_function& f)
  {
    return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                       [](const Exact_rational& x) { return x == 0; });
  }

  bool has_length(std::size_t k, std::size_t cell) const
  {
    return m_pair[k](Exact_parameters{m_breaks[k][cell]}) != m_pair[k](Exact_parameters{m_breaks[k][cell + 1]});
  }

  // Whether a cell of one curve is on the algebraic curve of a cell of the other one, if that is known.
  std::optional<bool> lies_on(std::size_t k, std::size_t cell, std::size_t other)
    requires (d == 2)
  {
    Cells cells{cell, cell};
    cells[1 - k] = other;
    const std::optional<Exact_function>& f = eliminated(cells)[k];
    return f ? std::optional(is_zero(*f)) : std::nullopt;
  }

  const std::array<std::optional<Exact_function>, 2>& eliminated(const Cells& cells)
    requires (d == 2)
  {
    const auto [entry, is_new] = m_eliminated.try_emplace(cells);
    if (is_new) {
      const std::array<Spline_patch<2>, 2> pieces{piece(0, cells[0]), piece(1, cells[1])};
      for (const std::size_t k : {0, 1})
        entry->second[k] = internal::Common::eliminated(pieces[k], pieces[1 - k]);
    }
    return entry->second;
  }

  // The cell that holds a part; of two, the first.
  std::size_t cell_of(std::size_t curve, const Parameter_range& part) const
  {
    const auto after = std::lower_bound(m_breaks[curve].begin() + 1, m_breaks[curve].end() - 1, part.second);
    return static_cast<std::size_t>(after - m_breaks[curve].begin()) - 1;
  }

  Spline_patch<d> piece(std::size_t curve, std::size_t cell) const
  {
    const Exact_rational &begin = m_breaks[curve][cell], &end = m_breaks[curve][cell + 1];
    Vector_of_functions<d> numerators = m_pair[curve].numerators();
    for (Exact_function& numerator : numerators)
      numerator = numerator.restricted(0, begin, end);
    return {std::move(numerators), m_pair[curve].weight().restricted(0, begin, end), m_pair[curve].is_rational()};
  }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVE_PARTS_H
