// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_VERIFICATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_VERIFICATION_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/irrational_multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/krawczyk_operator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

namespace verification {

// The same for all equalities and unknowns of a system.
inline Box krawczyk_image(const Constraint_system_d& system, const Box& box)
{
  Functions functions;
  for (const Spline_function& function : system.equalities())
    functions.push_back(&function);
  Axes axes(box.size());
  std::iota(axes.begin(), axes.end(), std::size_t(0));
  return krawczyk_image(functions, axes, box);
}

// A slightly larger range of simpler numbers.
inline Range simplified(const Range& range)
{
  const Exact_rational centre = (range.lower + range.upper) / Exact_rational(2),
                       radius = (range.upper - range.lower) / Exact_rational(2);
  const Exact_rational room = radius / Exact_rational(64);
  const Exact_rational middle = simplest_rational_between(Exact_rational(centre - room), Exact_rational(centre + room));
  const Exact_rational reach =
      simplest_rational_between(Exact_rational(radius + room), Exact_rational(radius + room + room));
  return {Exact_rational(middle - reach), Exact_rational(middle + reach)};
}

inline Box intersection(const Box& a, const Box& b)
{
  Box result;
  for (std::size_t j = 0; j < a.size(); ++j)
    result.push_back({(std::max)(a[j].lower, b[j].lower), (std::min)(a[j].upper, b[j].upper)});
  return result;
}

inline bool is_empty(const Box& box)
{
  return std::any_of(box.begin(), box.end(), [](const Range& range) { return range.upper < range.lower; });
}

// Grows the axes on which the image does not lie in the interior of the box: they were too thin beside the others.
inline Box inflated(const Box& box, const Box& image)
{
  const Point radius = radius_of(box);
  const Exact_rational largest = *std::max_element(radius.begin(), radius.end());
  const Exact_rational least =
      is_zero(largest) ? Exact_rational(0x1p-100) : Exact_rational(largest / Exact_rational(1 << 16));
  Box result = box;
  for (std::size_t j = 0; j < box.size(); ++j)
    if (image[j].lower <= box[j].lower || box[j].upper <= image[j].upper) {
      extend(result[j], image[j].lower, image[j].upper);
      const Exact_rational room = least + (result[j].upper - result[j].lower) / Exact_rational(8);
      result[j] = simplified(Range{Exact_rational(result[j].lower - room), Exact_rational(result[j].upper + room)});
    }
  return result;
}

// All points of the box lie in the domain and satisfy the inequalities; or `are_limits_admitted`, of points that do.
inline bool is_admissible(const Constraint_system_d& system, const Box& box, bool are_limits_admitted = false)
{
  for (std::size_t j = 0; j < box.size(); ++j) {
    const auto& domain = system.domain(static_cast<int>(j));
    if (box[j].lower < domain.first || domain.second < box[j].upper)
      return false;
  }
  for (const auto& inequality : system.inequalities()) {
    const Range range = values(inequality.function, box);
    const auto is_admitted = [&](const Exact_rational& value) {
      return is_satisfied(inequality.relation, CGAL::sign(value)) || (are_limits_admitted && is_zero(value));
    };
    if (!is_admitted(range.lower) || !is_admitted(range.upper))
      return false;
    // the only relation that does not hold for what is between
    if (inequality.relation == Relation::NOT_EQUAL && CGAL::sign(range.lower) != CGAL::sign(range.upper))
      return false;
  }
  return true;
}

// The simplest rational point of a box, as a box.
inline Box simplest_point(const Box& box)
{
  Box result;
  for (const Range& range : box) {
    const Exact_rational x = simplest_rational_between(range.lower, range.upper);
    result.push_back({x, x});
  }
  return result;
}

inline bool satisfies_equalities(const Constraint_system_d& system, const Box& point)
{
  return std::all_of(system.equalities().begin(), system.equalities().end(), [&](const Spline_function& function) {
    const Range range = values(function, point);
    return is_zero(range.lower) && is_zero(range.upper);
  });
}

inline bool is_inside(const Box& inner, const Box& outer)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].lower < outer[j].lower || outer[j].upper < inner[j].upper)
      return false;
  return true;
}

inline bool is_in_interior(const Box& inner, const Box& outer)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].lower <= outer[j].lower || outer[j].upper <= inner[j].upper)
      return false;
  return true;
}

// A number that the coordinate of a solution may well be exactly: a rational much simpler than the range of a
// coordinate has to hold, or an end of the domain, or a break. Returns whether there is one.
inline bool guess_coordinate(const Constraint_system_d& system, std::size_t axis, const Range& range,
                             Exact_rational& guess)
{
  guess = simplest_rational_between(range.lower, range.upper);
  const Exact_rational denominator = compose(parts_of(guess).denominator, Exact_integer(1));
  if ((range.upper - range.lower) * denominator * denominator * Exact_rational(1 << 10) < Exact_rational(1))
    return true;
  const auto is_in_range = [&](const Exact_rational& x) {
    const bool result = range.lower <= x && x <= range.upper;
    if (result)
      guess = x;
    return result;
  };
  const auto& domain = system.domain(static_cast<int>(axis));
  if (is_in_range(domain.first) || is_in_range(domain.second))
    return true;
  for (const Spline_function& function : system.equalities())
    for (const Spline_term& term : function.terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        if (static_cast<std::size_t>(term.variables[j]) == axis &&
            std::any_of(term.breaks[j].begin(), term.breaks[j].end(), is_in_range))
          return true;
  return false;
}

// Without functions that are linear combinations of others on a box, some of whose ranges are single numbers; all of
// them when there are breaks in it.
inline Functions linearly_independent(const Functions& functions, const Box& box)
{
  if (parts_between_breaks(functions, box).size() > 1)
    return functions;
  std::vector<Point> rows;   // the coefficients of one monomial each
  for (const auto& [exponents, values] : taylor_coefficients(functions, middle_of(box))) {
    bool is_zero_there = false;
    for (std::size_t j = 0; j < box.size(); ++j)
      is_zero_there = is_zero_there || (exponents[j] > 0 && box[j].lower == box[j].upper);
    if (!is_zero_there)
      rows.push_back(values);
  }
  Functions result;
  for (std::size_t k = 0; k < functions.size() && result.size() < rows.size(); ++k) {
    const std::size_t rank = result.size();
    const auto pivot =
        std::find_if(rows.begin() + rank, rows.end(), [k](const Point& row) { return !is_zero(row[k]); });
    if (pivot == rows.end())
      continue;
    result.push_back(functions[k]);
    std::swap(rows[rank], *pivot);
    for (std::size_t i = rank + 1; i < rows.size(); ++i)
      if (const Exact_rational factor = rows[i][k] / rows[rank][k]; !is_zero(factor))
        for (std::size_t l = k; l < functions.size(); ++l)
          rows[i][l] -= factor * rows[rank][l];
  }
  return result;
}

/*
Proves that there is a solution in or near the box, some of whose coordinates are single numbers: these are guessed;
some equalities are zero wherever the unknowns have these values, or linear combinations of others, and the rest have a
solution in the ranges of the remaining unknowns, each widened by its width times `widening`. Returns whether its
enclosure, which shrinks, is accepted.
*/
template <class Predicate>
bool has_partly_exact_solution(const Constraint_system_d& system, const Box& box, int widening,
                               const Predicate& is_accepted)
{
  Box enclosure = box;
  Axes rest;
  for (std::size_t j = 0; j < box.size(); ++j) {
    Exact_rational guess;
    if (guess_coordinate(system, j, box[j], guess))
      enclosure[j] = {guess, guess};
    else {
      const Exact_rational room = (box[j].upper - box[j].lower) * Exact_rational(widening);
      enclosure[j] = {Exact_rational(box[j].lower - room), Exact_rational(box[j].upper + room)};
      rest.push_back(j);
    }
  }
  Functions functions;
  for (const Spline_function& function : system.equalities()) {
    const Range range = values(function, enclosure);
    if (!is_continuous(function, enclosure))
      return false;
    if (!is_zero(range.lower) || !is_zero(range.upper))
      functions.push_back(&function);
  }
  functions = linearly_independent(functions, enclosure);
  if (functions.size() != rest.size() || rest.size() == box.size())
    return false;
  constexpr int rounds = 4;
  for (int round = 0; round < rounds && !rest.empty(); ++round) {
    const Box image = krawczyk_image(functions, rest, enclosure);
    if (image.empty())
      return false;
    Box next = enclosure;
    for (std::size_t i = 0; i < rest.size(); ++i)
      next[rest[i]] = image[i];
    if (round == 0)
      for (std::size_t j : rest)
        if (next[j].lower <= enclosure[j].lower || enclosure[j].upper <= next[j].upper)
          return false;
    enclosure = intersection(next, enclosure);
    if (is_accepted(enclosure))
      return true;
  }
  return rest.empty() && is_accepted(enclosure);
}

// Around the box, three times as wide.
inline Exact_box surrounding(const Box& box)
{
  Exact_box result;
  for (const Range& range : box) {
    const Exact_rational room = (std::max)(Exact_rational(range.upper - range.lower), Exact_rational(0x1p-200));
    result.emplace_back(Exact_rational(range.lower - room), Exact_rational(range.upper + room));
  }
  return result;
}

// The root lies in the box and in the domain, and satisfies the inequalities.
inline bool is_admissible_root(const Constraint_system_d& system, Algebraic_root& root, const Box& box)
{
  const Exact_box own = root.box();
  for (std::size_t j = 0; j < box.size(); ++j)
    if (own[j].first < box[j].lower || box[j].upper < own[j].second)
      return false;
  return algebraic_position(system, root) == Position::INSIDE;
}

// Proves that a root of as many of the equalities as there are unknowns, beside the enclosure or in it, is one of the
// others too, lies in the box and is admissible: by exact signs.
inline bool holds_algebraic_solution(const Constraint_system_d& system, const Box& enclosure, const Box& box)
{
  const Exact_box around = surrounding(enclosure);
  const auto equalities = integer_equalities(system, around);
  if (!equalities || box.size() < 2)
    return false;
  const std::vector<Power_polynomial> ordered = independent_first(*equalities, internal::middle_of(around));
  if (ordered.empty())
    return false;
  const auto others = ordered.begin() + static_cast<std::ptrdiff_t>(box.size());
  auto root = Algebraic_root::in(Algebraic_equations({ordered.begin(), others}, false), around);
  return root && root->refine(2 * root->bits_of_width()) && is_admissible_root(system, *root, box) &&
      std::all_of(others, ordered.end(),
                  [&](const Power_polynomial& other) { return root->sign_of(other) == CGAL::ZERO; });
}

// Proves that the box holds a multiple root.
inline bool holds_multiple_root(const Constraint_system_d& system, const Box& box)
{
  Multiple_root_search search = search_multiple_root(system, surrounding(box), Multiple_root_search::most_multiplicity);
  return search.outcome == Multiple_root_search::MULTIPLE_ROOT &&
      search.root->refine(2 * search.root->bits_of_width()) && is_admissible_root(system, *search.root, box);
}

// The only solution that the box `image` can hold, and which it does hold when there are as many equalities as
// unknowns, lies in `box` and is admissible.
inline bool holds_admissible(const Constraint_system_d& system, Box image, const Box& box)
{
  // A solution is in the image of every box that holds it: shrink until its place is decided.
  constexpr int rounds = 6;
  const auto is_decided = [&](const Box& enclosure) {
    return is_inside(enclosure, box) && is_admissible(system, enclosure);
  };
  Box enclosure = image;
  for (int round = 0; round < rounds && !image.empty(); ++round) {
    std::transform(image.begin(), image.end(), image.begin(), [](const Range& range) { return simplified(range); });
    enclosure = intersection(image, enclosure);
    if (is_empty(enclosure))
      return false;
    const bool is_square = system.equalities().size() == box.size();
    if (is_square && is_decided(enclosure))
      return true;
    if (const Box point = simplest_point(enclosure); satisfies_equalities(system, point))
      return is_decided(point);
    if (is_square && has_partly_exact_solution(system, enclosure, 0, is_decided))
      return true;
    image = krawczyk_image(system, enclosure);
  }
  return holds_algebraic_solution(system, enclosure, box);
}

inline bool has_one_solution(const Constraint_system_d& system, const Box& box)
{
  if (system.equalities().size() < box.size())
    return false;
  constexpr int attempts = 8;
  Box hull = box;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    for (const Spline_function& function : system.equalities())
      if (!is_continuous(function, hull))
        return false;
    const Box image = krawczyk_image(system, hull);
    if (image.empty())
      return false;
    if (is_in_interior(image, hull))
      return holds_admissible(system, image, box);
    hull = inflated(hull, image);
  }
  return false;
}

inline bool has_solution(const Constraint_system_d& system, const Box& box)
{
  Box domain;
  for (std::size_t j = 0; j < box.size(); ++j)
    domain.push_back({system.domain(static_cast<int>(j)).first, system.domain(static_cast<int>(j)).second});
  const Box inside = intersection(box, domain);
  if (is_empty(inside))
    return false;
  const Box point = simplest_point(inside);
  if (satisfies_equalities(system, point))
    return is_admissible(system, point);
  return has_partly_exact_solution(system, inside, 1,
                                   [&](const Box& b) { return is_inside(b, box) && is_admissible(system, b); }) ||
      holds_multiple_root(system, inside);
}

} // namespace verification
} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_VERIFICATION_H
