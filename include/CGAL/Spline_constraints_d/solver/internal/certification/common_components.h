// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_COMMON_COMPONENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_COMMON_COMPONENTS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Hypersurface_cover.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_point = std::vector<Exact_rational>;

// A cell of the domain in which the equalities have a common factor, or are all zero: its zeros are solutions.
struct Common_cell
{
  Exact_box box;
  std::vector<bool> is_break;   // per axis: lower end, upper end
  Power_polynomial factor;      // square-free; zero where all equalities are
  std::vector<Power_polynomial> cofactors;
  std::vector<std::pair<Power_polynomial, Relation>> inequalities;
};

// Solutions of positive dimension: boxes that touch each other and cover them; or a segment, with its two ends in
// lexicographic order.
struct Continuum
{
  int dimension;
  std::vector<Exact_box> cover;
  std::vector<Exact_point> ends;
};

// What there is of positive dimension in a cell of the domain, as far as a common factor shows.
inline std::optional<Common_cell> common_cell(const Constraint_system_d& system,
                                              const std::vector<std::vector<Exact_rational>>& breaks, const Cell& cell)
{
  Common_cell result;
  Exact_point middle;
  for (int v = 0; v < system.dimension(); ++v) {
    const auto& [lower, upper] = system.domain(v);
    const bool has_breaks = breaks[v].size() > 2;
    result.box.emplace_back(has_breaks ? breaks[v][cell[v]] : lower, has_breaks ? breaks[v][cell[v] + 1] : upper);
    result.is_break.push_back(result.box.back().first != lower);
    result.is_break.push_back(result.box.back().second != upper);
    middle.push_back((result.box.back().first + result.box.back().second) / Exact_rational(2));
  }
  std::vector<Power_polynomial> equalities;
  for (const Spline_function& function : system.equalities())
    equalities.push_back(polynomial_at(function, middle));
  if (!std::all_of(equalities.begin(), equalities.end(), [](const Power_polynomial& f) { return f.is_zero(); })) {
    auto common = common_factor(equalities);
    if (!common || system.dimension() == 1)   // with one unknown it has zeros only
      return std::nullopt;
    result.factor = square_free_part(common->factor);
    result.cofactors = std::move(common->cofactors);
  }
  for (const auto& inequality : system.inequalities())
    result.inequalities.emplace_back(polynomial_at(inequality.function, middle), inequality.relation);
  return result;
}

/*
The only corner of a box where a polynomial may be zero there, when its Bernstein coefficients have one sign but for a
zero at that corner. A point stands for "nowhere" when none is zero: empty.
*/
inline std::optional<Exact_point> only_corner_zero(const Power_polynomial& f, const Exact_box& box)
{
  const std::size_t n = box.size();
  std::vector<int> degrees;
  std::size_t size = 1;
  for (std::size_t j = 0; j < n; ++j) {
    degrees.push_back((std::max)(1, f.degree(static_cast<int>(j))));
    size *= static_cast<std::size_t>(degrees.back()) + 1;
  }
  std::vector<Exact_rational> power(size, Exact_rational(0));
  for (const auto& [monomial, coefficient] : f.terms()) {
    std::size_t place = 0;
    for (std::size_t j = 0; j < n; ++j)
      place = place * (static_cast<std::size_t>(degrees[j]) + 1) + monomial.exponent(static_cast<int>(j));
    power[place] = coefficient;
  }
  const auto tensor = Bernstein_tensor<Exact_rational>::from_power_on_box(degrees, power, box);
  std::size_t zeros = 0, positive = 0, zero_place = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const CGAL::Sign sign = CGAL::sign(tensor.coefficients()[i]);
    positive += sign == CGAL::POSITIVE;
    if (sign == CGAL::ZERO) {
      ++zeros;
      zero_place = i;
    }
  }
  if (zeros > 1 || (positive != 0 && positive != size - zeros))
    return std::nullopt;
  Exact_point corner;
  bool is_corner = true;
  for (std::size_t j = n; zeros == 1 && j-- > 0;) {
    const std::size_t k = zero_place % (static_cast<std::size_t>(degrees[j]) + 1);
    zero_place /= static_cast<std::size_t>(degrees[j]) + 1;
    is_corner = is_corner && (k == 0 || k == static_cast<std::size_t>(degrees[j]));
    corner.insert(corner.begin(), k == 0 ? box[j].first : box[j].second);
  }
  return is_corner ? std::optional(corner) : std::nullopt;
}

// The same for the equalities, when one of them, a polynomial around an inner point of the box, proves it.
inline std::optional<Exact_point> only_corner_zero(const Constraint_system_d& system, const Exact_box& box)
{
  Exact_point middle;
  for (const auto& [lower, upper] : box)
    middle.push_back((lower + upper) / Exact_rational(2));
  for (const Spline_function& function : system.equalities())
    if (const auto corner = only_corner_zero(polynomial_at(function, middle), box))
      return corner;
  return std::nullopt;
}

// The part of the line through two points in a box; empty when it has no length.
inline std::vector<Exact_point> line_in_box(const Exact_point& a, const Exact_point& b, const Exact_box& box)
{
  std::optional<Exact_rational> first, last;   // a + t (b - a)
  for (std::size_t j = 0; j < box.size(); ++j) {
    const Exact_rational step = b[j] - a[j];
    if (CGAL::is_zero(step)) {
      if (a[j] < box[j].first || box[j].second < a[j])
        return {};
      continue;
    }
    Exact_rational t0 = (box[j].first - a[j]) / step, t1 = (box[j].second - a[j]) / step;
    if (t1 < t0)
      std::swap(t0, t1);
    first = first ? (std::max)(*first, t0) : t0;
    last = last ? (std::min)(*last, t1) : t1;
  }
  if (!first || !(*first < *last))
    return {};
  std::vector<Exact_point> ends(2);   // in the order of a and b
  for (std::size_t j = 0; j < box.size(); ++j) {
    ends[0].push_back(a[j] + *first * (b[j] - a[j]));
    ends[1].push_back(a[j] + *last * (b[j] - a[j]));
  }
  return ends;
}

inline Exact_box hull(const Exact_point& a, const Exact_point& b)
{
  Exact_box result;
  for (std::size_t j = 0; j < a.size(); ++j)
    result.emplace_back((std::min)(a[j], b[j]), (std::max)(a[j], b[j]));
  return result;
}

inline Exact_rational zero_of_linear(const Power_polynomial& polynomial)
{
  const Exact_rational at_zero = polynomial(std::vector<Exact_rational>{Exact_rational(0)}),
                       slope = polynomial(std::vector<Exact_rational>{Exact_rational(1)}) - at_zero;
  return Exact_rational(-at_zero / slope);
}

// The zeros of a polynomial of one unknown in a range that are rational, and whether these are all. `solve(system)`
// gives all zeros.
template <class Solve>
std::pair<std::vector<Exact_rational>, bool> rational_zeros(const Power_polynomial& polynomial,
                                                            const std::pair<Exact_rational, Exact_rational>& range,
                                                            const Solve& solve)
{
  std::vector<Exact_rational> zeros;
  bool are_all = true;
  if (polynomial.is_constant())
    return {zeros, are_all};
  Constraint_system_d system({range});
  system.add(square_free_part(polynomial), Relation::EQUAL);
  for (const auto& solution : solve(system)) {
    are_all = are_all && solution.is_certified();   // another answer may hold more than one zero
    const auto [lower, upper] = solution.exact_box()[0];
    const Exact_rational first = (std::max)(lower, range.first), last = (std::min)(upper, range.second);
    const Exact_rational zero = polynomial.degree(0) == 1 ? zero_of_linear(polynomial)
        : first <= last                                   ? simplest_rational_between(first, last)
                                                          : first;
    if (CGAL::is_zero(polynomial(std::vector<Exact_rational>{zero})))
      zeros.push_back(zero);
    else
      are_all = false;
  }
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  return {zeros, are_all};
}

// The rational zeros of a polynomial of two unknowns on the boundary of a box.
template <class Solve>
std::vector<Exact_point> rational_boundary_points(const Power_polynomial& h, const Exact_box& box, const Solve& solve)
{
  std::vector<Exact_point> result;
  for (const int fixed : {0, 1})
    for (const Exact_rational& value : {box[fixed].first, box[fixed].second}) {
      // A line along the side is found from the two other sides.
      const Power_polynomial side =
          h.substituted(fixed, Power_polynomial(value)).substituted(1 - fixed, Power_polynomial::variable(0));
      for (const Exact_rational& zero : rational_zeros(side, box[1 - fixed], solve).first) {
        Exact_point point(2, value);
        point[1 - fixed] = zero;
        if (std::find(result.begin(), result.end(), point) == result.end())
          result.push_back(point);
      }
    }
  return result;
}

inline Exact_point point_between(const Exact_point& a, const Exact_point& b, const Exact_rational& t)
{
  Exact_point result;
  for (std::size_t j = 0; j < a.size(); ++j)
    result.push_back(a[j] + t * (b[j] - a[j]));
  return result;
}

// The closure of what the inequalities leave of a segment: segments, and single points. False where they cut it at
// irrational points.
template <class Solve>
bool clip_segment(const std::vector<Exact_point>& ends, const Common_cell& cell, const Solve& solve,
                  std::vector<Continuum>& segments, std::vector<Exact_box>& points)
{
  std::vector<Exact_rational> cuts{Exact_rational(0), Exact_rational(1)};
  for (const auto& [function, relation] : cell.inequalities) {
    const int n = static_cast<int>(cell.box.size()), parameter = n;
    Power_polynomial along = function;
    for (int j = 0; j < n; ++j)
      along = along.substituted(j,
                                Power_polynomial(ends[0][j]) +
                                    Power_polynomial(Exact_rational(ends[1][j] - ends[0][j])) *
                                        Power_polynomial::variable(parameter));
    const auto [zeros, are_all] = rational_zeros(along.substituted(parameter, Power_polynomial::variable(0)),
                                                 {Exact_rational(0), Exact_rational(1)}, solve);
    if (!are_all)
      return false;
    cuts.insert(cuts.end(), zeros.begin(), zeros.end());
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const auto is_feasible = [&](const Exact_rational& t) {
    const Exact_point point = point_between(ends[0], ends[1], t);
    return std::all_of(cell.inequalities.begin(), cell.inequalities.end(), [&](const auto& inequality) {
      return is_satisfied(inequality.second, CGAL::sign(inequality.first(point)));
    });
  };
  bool is_in_segment = false;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const bool goes_on =
        i + 1 < cuts.size() && is_feasible(Exact_rational((cuts[i] + cuts[i + 1]) / Exact_rational(2)));
    const Exact_point point = point_between(ends[0], ends[1], cuts[i]);
    if (goes_on) {
      const Exact_point next = point_between(ends[0], ends[1], cuts[i + 1]);
      segments.push_back({1, {hull(point, next)}, {point, next}});
    } else if (!is_in_segment && is_feasible(cuts[i]))
      points.push_back(hull(point, point));
    is_in_segment = goes_on;
  }
  return true;
}

// Takes the lines through rational boundary points out of a square-free polynomial of two unknowns, with the segments
// that they are in the box.
template <class Solve>
std::vector<Continuum> take_segments(Power_polynomial& h, const Common_cell& cell, const Solve& solve,
                                     std::vector<Exact_box>& open)
{
  std::vector<Continuum> result;
  const std::vector<Exact_point> points = rational_boundary_points(h, cell.box, solve);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      const Exact_point &a = (std::min)(points[i], points[k]), &b = (std::max)(points[i], points[k]);
      const Power_polynomial line =
          (Power_polynomial::variable(0) - Power_polynomial(a[0])) * Power_polynomial(Exact_rational(b[1] - a[1])) -
          (Power_polynomial::variable(1) - Power_polynomial(a[1])) * Power_polynomial(Exact_rational(b[0] - a[0]));
      const std::vector<Exact_point> ends = line_in_box(a, b, cell.box);
      if (ends.empty())
        continue;
      const auto common = common_factor({h, line});
      if (common && clip_segment(ends, cell, solve, result, open))
        h = common->cofactors[0];
    }
  return result;
}

/*
The solutions that a common factor makes in a cell. Small boxes beside them, in which nothing is proved, are appended to
`open`: there the factor may have an isolated zero. A box that is a point is one, and the only zero near by.
*/
template <class Solve>
std::vector<Continuum> continua_in(const Common_cell& cell, const Solve& solve, std::vector<Exact_box>& open)
{
  const int n = static_cast<int>(cell.box.size());
  std::vector<Continuum> result;
  Power_polynomial h = cell.factor;
  // where a side is a line of zeros, other lines that end there are found without it
  for (Power_polynomial before; n == 2 && !h.is_zero() && !(h == before);) {
    before = h;
    const std::vector<Continuum> segments = take_segments(h, cell, solve, open);
    result.insert(result.end(), segments.begin(), segments.end());
  }
  if (h.is_constant() && !h.is_zero())
    return result;
  if (const auto corner = only_corner_zero(h, cell.box)) {
    if (!corner->empty())
      open.push_back(hull(*corner, *corner));
    return result;
  }
  const Hypersurface_cover cover(h, cell.inequalities, cell.box);
  for (const Exact_box& box : cover.regular_boxes())
    result.push_back({h.is_zero() ? n : n - 1, {box}, {}});
  open.insert(open.end(), cover.small_boxes().begin(), cover.small_boxes().end());
  return result;
}

inline bool boxes_touch(const Exact_box& a, const Exact_box& b)
{
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j].second < b[j].first || b[j].second < a[j].first)
      return false;
  return true;
}

// A point of a segment, or of the boxes of a cover.
inline bool holds(const Continuum& continuum, const Exact_point& point)
{
  const auto holds_point = [&](const Exact_box& box) {
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j] < box[j].first || box[j].second < point[j])
        return false;
    return true;
  };
  if (std::none_of(continuum.cover.begin(), continuum.cover.end(), holds_point))
    return false;
  for (std::size_t j = 1; !continuum.ends.empty() && j < point.size(); ++j)
    for (std::size_t l = 0; l < j; ++l) {
      const Exact_point &a = continuum.ends[0], &b = continuum.ends[1];
      if (!CGAL::is_zero(Exact_rational((b[j] - a[j]) * (point[l] - a[l]) - (b[l] - a[l]) * (point[j] - a[j]))))
        return false;
    }
  return true;
}

// Two segments of one line that share an end become one.
inline bool join_segments(Continuum& a, const Continuum& b)
{
  if (a.ends.empty() || b.ends.empty())
    return false;
  if (a.ends == b.ends)
    return true;   // on a face that two cells share
  for (const int i : {0, 1})
    for (const int k : {0, 1})
      if (a.ends[i] == b.ends[k]) {
        const Exact_point &p = a.ends[1 - i], &q = a.ends[i], &r = b.ends[1 - k];
        for (std::size_t j = 0; j < p.size(); ++j)
          for (std::size_t l = 0; l < j; ++l)
            if (!CGAL::is_zero(Exact_rational((q[j] - p[j]) * (r[l] - q[l]) - (q[l] - p[l]) * (r[j] - q[j]))))
              return false;
        for (std::size_t j = 0; j < p.size(); ++j)
          if (CGAL::is_negative(Exact_rational((q[j] - p[j]) * (r[j] - q[j]))))
            return false;
        a.cover = {hull(p, r)};
        a.ends = p < r ? std::vector<Exact_point>{p, r} : std::vector<Exact_point>{r, p};   // p and q are gone
        return true;
      }
  return false;
}

// The connected components of "touches", by a sweep along the first axis.
inline std::vector<std::vector<std::size_t>> groups_that_touch(const std::vector<std::pair<int, Exact_box>>& boxes)
{
  std::vector<std::size_t> order(boxes.size()), parent(boxes.size());
  std::vector<std::pair<double, double>> range;   // on the first axis, rounded outwards
  for (const auto& [dimension, box] : boxes)
    range.emplace_back(to_double_interval(box[0].first).first, to_double_interval(box[0].second).second);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return range[a] < range[b]; });
  const auto root = [&](std::size_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<std::size_t> active;   // boxes that the sweep has not left behind
  for (std::size_t i : order) {
    std::erase_if(active, [&](std::size_t k) { return range[k].second < range[i].first; });
    for (std::size_t k : active)
      if (root(i) != root(k) && boxes_touch(boxes[i].second, boxes[k].second))
        parent[root(i)] = root(k);
    active.push_back(i);
  }
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    groups[root(i)].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [representative, group] : groups)
    result.push_back(std::move(group));
  return result;
}

/*
Joins what is known to belong together, across cells too: segments of one line, and covers whose boxes touch. `open`,
small boxes in which nothing is proved, become part of the covers that they touch, directly or through each other;
others stay.
*/
inline void join(std::vector<Continuum>& continua, std::vector<Exact_box>& open)
{
  std::vector<Continuum> segments;
  std::vector<std::pair<int, Exact_box>> boxes;   // with the dimension
  for (Continuum& continuum : continua) {
    if (continuum.ends.empty()) {
      for (const Exact_box& box : continuum.cover)
        boxes.emplace_back(continuum.dimension, box);
      continue;
    }
    for (auto other = segments.begin(); other != segments.end();)
      if (join_segments(continuum, *other)) {
        segments.erase(other);
        other = segments.begin();
      } else
        ++other;
    segments.push_back(std::move(continuum));
  }
  for (const Exact_box& box : open)
    boxes.emplace_back(0, box);
  continua = std::move(segments);
  open.clear();
  for (const std::vector<std::size_t>& group : groups_that_touch(boxes)) {
    Continuum continuum{0, {}, {}};
    for (std::size_t k : group) {
      continuum.dimension = (std::max)(continuum.dimension, boxes[k].first);
      continuum.cover.push_back(std::move(boxes[k].second));
    }
    if (continuum.dimension > 0)
      continua.push_back(std::move(continuum));
    else
      std::move(continuum.cover.begin(), continuum.cover.end(), std::back_inserter(open));
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_COMMON_COMPONENTS_H
