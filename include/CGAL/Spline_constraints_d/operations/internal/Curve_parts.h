// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_PARTS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/univariate_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/internal/elimination_2.h>

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

using Exact_parameters = std::vector<Exact_rational>;

inline bool is_part_of(const Parameter_box& box, const Parameter_box& outer)
{
  for (std::size_t j = 0; j < box.size(); ++j)
    if (box[j].first < outer[j].first || outer[j].second < box[j].second)
      return false;
  return true;
}

/*
Two curves, for proofs that a box of their parameters holds no common points but known ones: the box is cut at breaks and at these points, then into quarters, and each part is looked at.
*/
template <int d>
class Curve_parts
{
  using Cells = std::array<std::size_t, 2>;

  const Patch_pair<d>& m_pair;
  std::array<std::vector<Exact_rational>, 2> m_breaks;
  std::map<Cells, std::array<std::optional<Exact_function>, 2>> m_eliminated;   // of the parameters of the first and the second curve, on their cells

public:
  // \pre the operands are curves.
  explicit Curve_parts(const Patch_pair<d>& pair) : m_pair(pair), m_breaks{pair[0].breaks(0), pair[1].breaks(0)} {}

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

  // Those that are a break of one curve alone, which a piece of the other one passes through once, and no end of an overlap: a parameter and a range.
  std::vector<Parameter_box> points_at_one_break(const Parameter_box& box)
    requires (d == 2)
  {
    std::vector<Parameter_box> result;
    for (const std::size_t k : {0, 1})
      for (std::size_t i = 0; i < m_breaks[k].size(); ++i) {
        const Exact_rational& t = m_breaks[k][i];
        if (t < box[k].first || box[k].second < t || !passes_through(1 - k, box[1 - k], m_pair[k](Exact_parameters{t})) || may_run_along(k, i - 1, box) || may_run_along(k, i, box))
          continue;
        result.push_back(box);
        result.back()[k] = {t, t};
      }
    return result;
  }

  // Whether all common points in a box are given ones, with both parameters or one, or belong to an overlap, where there is one.
  bool holds_only(const Parameter_box& box, const std::vector<Exact_parameters>& points, const Parameter_box* overlap = nullptr, const std::vector<Parameter_box>& ranges = {})
  {
    const auto is_known = [&](const Parameter_box& part) { return (overlap && is_part_of(part, *overlap)) || leads_apart_from_one(part, points); };
    const auto is_settled = [&](const auto& self, const Parameter_box& part, int depth) -> bool {
      if (is_known(part) || are_apart(part) || is_settled_by_elimination(part, points, ranges) || is_in_overlap(part))
        return true;
      return depth > 0 && all_parts(part, {Exact_parameters{middle_of(part[0])}, Exact_parameters{middle_of(part[1])}}, [&](const Parameter_box& quarter) { return self(self, quarter, depth - 1); });
    };
    const auto is_settled_between_breaks = [&](const Parameter_box& part) {
      constexpr int depth = 6;
      return has_few_cells(part) && all_parts(part, m_breaks, [&](const Parameter_box& piece) { return is_settled(is_settled, piece, depth); });
    };
    return all_parts(box, {parameters(points, 0), parameters(points, 1)}, [&](const Parameter_box& part) { return is_known(part) || is_settled_between_breaks(part); });
  }

private:
  // Whether a curve has a point in a range inside of one cell, and has it once: its coordinates without those of the point have a common factor with one zero there.
  bool passes_through(std::size_t curve, const Parameter_range& range, const std::array<Exact_rational, 2>& point) const
    requires (d == 2)
  {
    const std::size_t cell = cell_of(curve, range);
    if (!(m_breaks[curve][cell] < range.first && range.first < range.second && range.second < m_breaks[curve][cell + 1]))
      return false;
    const Spline_patch<2> part = m_pair[curve].part(0, range);
    if (!(squared_norm(part.tangents(0)).lower > 0))
      return false;
    std::vector<Power_polynomial> coordinates;
    for (const std::size_t i : {0, 1})
      if (Power_polynomial f = univariate_polynomial(part.numerators()[i] - part.weight() * point[i]); !f.is_constant() || f.constant_term() != 0)
        coordinates.push_back(std::move(f));
    const std::optional<Common_factor> common = common_factor(coordinates);
    const auto sign_at = [&](int t) { return common ? CGAL::sign(common->factor(Exact_parameters{Exact_rational(t)})) : CGAL::ZERO; };
    return sign_at(0) * sign_at(1) < 0;
  }

  // Whether a cell of one curve, if there is one, may be on the curve that the other one is on in a box.
  bool may_run_along(std::size_t k, std::size_t cell, const Parameter_box& box)
    requires (d == 2)
  {
    if (!(cell < m_breaks[k].size() - 1))
      return false;
    Cells cells{cell, cell};
    cells[1 - k] = cell_of(1 - k, box[1 - k]);
    const std::optional<Exact_function>& f = eliminated(cells)[k];
    return !f || std::all_of(f->coefficients().begin(), f->coefficients().end(), [](const Exact_rational& x) { return x == 0; });
  }

  // The parts of a box between some values of the parameters.
  template <class Predicate>
  static bool all_parts(const Parameter_box& box, const std::array<std::vector<Exact_rational>, 2>& cuts, const Predicate& is_true)
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

  static bool is_end(const Exact_rational& x, const Parameter_range& range) { return x == range.first || x == range.second; }

  static std::vector<Exact_rational> parameters(const std::vector<Exact_parameters>& points, std::size_t curve)
  {
    std::vector<Exact_rational> result;
    for (const Exact_parameters& point : points)
      result.push_back(point[curve]);
    std::sort(result.begin(), result.end());
    return result;
  }

  // So that a box that a limit of the solver left is not worked on without limit.
  bool has_few_cells(const Parameter_box& box) const
  {
    constexpr std::size_t most = 64;
    return (cell_of(0, box[0]) + 1 - cell_of(0, {box[0].first, box[0].first})) * (cell_of(1, box[1]) + 1 - cell_of(1, {box[1].first, box[1].first})) <= most;
  }

  bool leads_apart_from_one(const Parameter_box& part, const std::vector<Exact_parameters>& points) const
  {
    return std::any_of(points.begin(), points.end(), [&](const Exact_parameters& point) { return touches(part, point) && (!has_extent(part) || lead_apart(part, point)); });
  }

  // At a corner.
  static bool touches(const Parameter_box& part, const Exact_parameters& point) { return is_end(point[0], part[0]) && is_end(point[1], part[1]); }

  bool are_apart(const Parameter_box& part) const
  {
    const Vector_bounds<d> difference = m_pair[0].part(0, part[0]).values() - m_pair[1].part(0, part[1]).values();
    return std::any_of(difference.begin(), difference.end(), [](const Rational_interval& x) { return !has_zero(x); });
  }

  // By the mean value theorem, the points of a part with a known corner are there plus something times a vector within the bounds of the derivative. Whether no vectors of the two parts have the same direction.
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
  bool is_settled_by_elimination(const Parameter_box& part, const std::vector<Exact_parameters>& points, const std::vector<Parameter_box>& ranges)
  {
    if constexpr (d == 2) {
      std::array<Zero_places, 2> zeros;
      for (const std::size_t k : {0, 1}) {
        const std::optional<Exact_function>& f = eliminated({cell_of(0, part[0]), cell_of(1, part[1])})[k];
        zeros[k] = !f ? Zero_places{true, true, true} : part[k].first < part[k].second ? zero_places(f->restricted(0, part[k].first, part[k].second)) : Zero_places{true, false, false};
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
            return is_end_of_overlap(part, k, end) || std::any_of(ranges.begin(), ranges.end(), [&](const Parameter_box& range) { return is_part_of(face, range); });
          });
        };
        return has_known_ends(0) || has_known_ends(1);
      }
      for (const Exact_rational& t : values(0))
        for (const Exact_rational& s : values(1))
          if (std::find(points.begin(), points.end(), Exact_parameters{t, s}) == points.end() && m_pair[0](Exact_parameters{t}) == m_pair[1](Exact_parameters{s}))
            return false;
      return true;
    }
    return false;
  }

  // Whether all common points in a part belong to overlaps of straight pieces, which are answers themselves.
  bool is_in_overlap(const Parameter_box& part) const
  {
    if constexpr (d == 2)
      return runs_along(0, cell_of(0, part[0]), part) || runs_along(1, cell_of(1, part[1]), part);
    return false;
  }

  // The same for those at an end of the range of one curve, where the overlap ends.
  bool is_end_of_overlap(const Parameter_box& part, std::size_t k, const Exact_rational& end) const
    requires (d == 2)
  {
    const std::size_t cell = cell_of(k, part[k]);
    return (end == m_breaks[k][cell] && cell > 0 && runs_along(k, cell - 1, part)) || (end == m_breaks[k][cell + 1] && cell + 2 < m_breaks[k].size() && runs_along(k, cell + 1, part));
  }

  // Whether a cell of one curve lies on the line of the straight piece of the other one that a part is inside of, without a point twice: next to each common point in the part there are others.
  bool runs_along(std::size_t k, std::size_t cell, const Parameter_box& part) const
    requires (d == 2)
  {
    const Spline_patch<2> straight = piece(1 - k, cell_of(1 - k, part[1 - k]));
    const auto [begin, end] = straight.domain(0);
    const auto a = straight(Exact_parameters{begin}), b = straight(Exact_parameters{end});
    const Exact_rational dx(b[0] - a[0]), dy(b[1] - a[1]), offset(a[0] * dy - a[1] * dx);
    const auto is_on_chord = [&](const Spline_patch<2>& curve) {
      const Exact_function distance = curve.numerators()[1] * dx - curve.numerators()[0] * dy + curve.weight() * offset;
      return std::all_of(distance.coefficients().begin(), distance.coefficients().end(), [](const Exact_rational& x) { return x == 0; });
    };
    return begin < part[1 - k].first && part[1 - k].second < end && a != b && is_on_chord(straight) && is_on_chord(piece(k, cell)) && squared_norm(m_pair[1 - k].part(0, part[1 - k]).tangents(0)).lower > 0;
  }

  const std::array<std::optional<Exact_function>, 2>& eliminated(const Cells& cells)
    requires (d == 2)
  {
    const auto [entry, is_new] = m_eliminated.try_emplace(cells);
    if (is_new) {
      const std::array<Spline_patch<2>, 2> pieces{piece(0, cells[0]), piece(1, cells[1])};
      for (const std::size_t k : {0, 1})
        entry->second[k] = internal::eliminated(pieces[k], pieces[1 - k]);
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

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVE_PARTS_H
