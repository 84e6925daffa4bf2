// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/krawczyk_operator.h>

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
  const Exact_rational centre = (range.lower + range.upper) / Exact_rational(2), radius = (range.upper - range.lower) / Exact_rational(2);
  const Exact_rational room = radius / Exact_rational(64);
  const Exact_rational middle = simplest_rational_between(Exact_rational(centre - room), Exact_rational(centre + room));
  const Exact_rational reach = simplest_rational_between(Exact_rational(radius + room), Exact_rational(radius + room + room));
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
  const Exact_rational least = is_zero(largest) ? Exact_rational(0x1p-100) : Exact_rational(largest / Exact_rational(1 << 16));
  Box result = box;
  for (std::size_t j = 0; j < box.size(); ++j)
    if (image[j].lower <= box[j].lower || box[j].upper <= image[j].upper) {
      extend(result[j], image[j].lower, image[j].upper);
      const Exact_rational room = least + (result[j].upper - result[j].lower) / Exact_rational(8);
      result[j] = simplified(Range{Exact_rational(result[j].lower - room), Exact_rational(result[j].upper + room)});
    }
  return result;
}

// All points of the box lie in the domain and satisfy the inequalities.
inline bool is_admissible(const Constraint_system_d& system, const Box& box)
{
  for (std::size_t j = 0; j < box.size(); ++j) {
    const auto& domain = system.domain(static_cast<int>(j));
    if (box[j].lower < domain.first || domain.second < box[j].upper)
      return false;
  }
  for (const auto& inequality : system.inequalities()) {
    const Range range = values(inequality.function, box);
    if (!is_satisfied(inequality.relation, CGAL::sign(range.lower)) || !is_satisfied(inequality.relation, CGAL::sign(range.upper)))
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

// A number that the coordinate of a solution may well be exactly: a rational much simpler than the range of a coordinate has to hold, or an end of the
// domain, or a break. Returns whether there is one.
inline bool guess_coordinate(const Constraint_system_d& system, std::size_t axis, const Range& range, Exact_rational& guess)
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

// Without functions that are linear combinations of others on a box, some of whose ranges are single numbers; all of them when there are breaks in it.
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
    const auto pivot = std::find_if(rows.begin() + rank, rows.end(), [k](const Point& row) { return !is_zero(row[k]); });
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
Proves that there is a solution in or near the box, some of whose coordinates are single numbers: these are guessed; some equalities are zero wherever the unknowns
have these values, or linear combinations of others, and the rest have a solution in the ranges of the remaining unknowns, each widened by its width times `widening`. Returns whether its enclosure, which
shrinks, is accepted.
*/
template <class Predicate>
bool has_partly_exact_solution(const Constraint_system_d& system, const Box& box, int widening, const Predicate& is_accepted)
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

// The only solution that the box `image` can hold, and which it does hold when there are as many equalities as unknowns, lies in `box` and is admissible.
inline bool holds_admissible(const Constraint_system_d& system, Box image, const Box& box)
{
  // A solution is in the image of every box that holds it: shrink until its place is decided.
  constexpr int rounds = 6;
  const auto is_decided = [&](const Box& enclosure) { return is_inside(enclosure, box) && is_admissible(system, enclosure); };
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
  return false;
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
  return has_partly_exact_solution(system, inside, 1, [&](const Box& b) { return is_inside(b, box) && is_admissible(system, b); });
}

} // namespace verification
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

proves one answer of the solver once more, from the system and the box of the answer alone, in exact rational arithmetic and sharing no code with the
subdivision. `true` only when the proof succeeds; `false` says nothing about the system, but no certified answer of the solver is expected to give it.

A *certified* answer with the box \f$B\f$: let \f$y\f$ be the middle and \f$r\f$ the radius of \f$B\f$, \f$J\f$ a set of matrices whose convex hull holds the derivatives on
\f$B\f$ of all pieces of the equalities \f$F\f$, and \f$C\f$ any matrix, here the inverse of a matrix amid \f$J\f$ in rationals of 128 bits. \f$I - C J\f$ is bounded by the coefficients of
\f$C F\f$ in Taylor's formula at the middle of each part of \f$B\f$ between breaks; equations that nearly coincide cancel in them. Neighbouring pieces are checked to agree where they meet, so \f$F\f$ is continuous on \f$B\f$, the mean of its derivatives along
a segment lies in \f$J\f$, and \f$x \mapsto x - C F(x)\f$ maps \f$B\f$ into
\f[ K = y - C F(y) + (I - C J)(B - y). \f]
If \f$K\f$ lies in the interior of \f$B\f$ (Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4, 1969; Moore, A test for
existence of solutions to nonlinear systems, SIAM J. Numer. Anal. 14, 1977), then \f$|I - C J|\, r < r\f$ in every coordinate: the map is a contraction of
\f$B\f$ in the maximum norm weighted by \f$1/r\f$, all matrices in \f$C J\f$ are regular, and so \f$B\f$ holds exactly one zero of \f$C F\f$, which is regular; for
as many equalities as unknowns \f$C\f$ is regular and this is exactly one zero of \f$F\f$.

The shape of \f$B\f$ may forbid this: it is very thin on some axes, or its solution lies on a face. Then it is tried on a slightly larger box (the inflation of
Rump, Solving algebraic problems with high accuracy, 1983), and the solution has to be proved to lie in \f$B\f$.

At last the operator shrinks \f$K\f$ until all of it lies in \f$B\f$ and in the domain and satisfies the inequalities. When the solution lies on the boundary of one
of them, or there are more equalities than unknowns, only exact coordinates decide: the simplest rational point of \f$K\f$ is tried; then, some coordinates that
look rational are fixed, and the operator has to prove a zero of the other coordinates and of the equalities that this leaves.

A *cluster*: proves that the box holds a solution, which is its simplest rational point in the domain, or has some coordinates that look rational and others by the
operator, as above. How many there are is not proved.

Other kinds of answers carry no proof: `false`. So do boxes with a wrong number of ranges, or empty or infinite ones.

Cost: \f$O(n^3)\f$ rational operations, and per equality \f$O(N \sum_j d_j)\f$ for pieces of \f$N\f$ coefficients, a few times over. Independent of the rounding mode.

\param system the system that was solved.
\param solution the answer; of it, `kind()` and `exact_box()` are used.
*/
template <class Coordinate>
bool verify(const Constraint_system_d& system, const Solution_d<Coordinate>& solution)
{
  if constexpr (std::is_floating_point_v<Coordinate>)
    for (const auto& [lower, upper] : solution.box())
      if (!std::isfinite(lower) || !std::isfinite(upper))
        return false;
  internal::verification::Box box;
  for (const auto& [lower, upper] : solution.exact_box()) {
    if (upper < lower)
      return false;
    box.push_back({lower, upper});
  }
  if (box.size() != static_cast<std::size_t>(system.dimension()))
    return false;
  switch (solution.kind()) {
  case Solution_kind::CERTIFIED: return internal::verification::has_one_solution(system, box);
  case Solution_kind::CLUSTER: return internal::verification::has_solution(system, box);
  case Solution_kind::CONTINUUM:
  case Solution_kind::UNDECIDED: break;
  }
  return false;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
