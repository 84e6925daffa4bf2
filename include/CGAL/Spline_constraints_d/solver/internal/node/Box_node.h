// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_BOX_NODE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_BOX_NODE_H

#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A place strictly between the ends of a range, near lower + t (upper - lower); `lower` itself when there is none.
inline double place_between(double lower, double upper, double t)
{
  const double c = lower + t * (upper - lower);
  return lower < c && c < upper ? c : lower;
}

inline Exact_rational place_between(const Exact_rational& lower, const Exact_rational& upper, double t)
{
  return lower + Exact_rational(std::ldexp(std::nearbyint(std::ldexp(t, 12)), -12)) * (upper - lower);
}

// A coordinate at or below lower + t (upper - lower), for any t in about [-1, 2].
inline double place_below(double lower, double upper, double t)
{
  const double slack = 0x1p-45 * (1 + std::abs(t));
  return next_below(lower + (t - slack) * (upper - lower));
}

inline double place_above(double lower, double upper, double t)
{
  const double slack = 0x1p-45 * (1 + std::abs(t));
  return next_above(lower + (t + slack) * (upper - lower));
}

// The last coordinate of few digits at or below x, for a range of the given width, which grows by no more than a
// thousandth: the fewer digits the ends of boxes have, the shorter are the numbers where functions are built on them
// exactly.
// \pre 2^-900 < width < 2^1000
inline double short_below(double x, double width)
{
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(width) & 0x7ff0000000000000;   // alone: a power of two
  const double unit = 0x1p-10 * std::bit_cast<double>(exponent),
               inverse = 0x1p10 * std::bit_cast<double>(0x7fe0000000000000 - exponent);
  return std::floor(x * inverse) * unit;
}

inline double short_above(double x, double width) { return -short_below(-x, width); }

inline Exact_rational place_below(const Exact_rational& lower, const Exact_rational& upper, double t)
{
  return lower + Exact_rational(std::ldexp(std::floor(std::ldexp(t, 30)) - 1, -30)) * (upper - lower);
}

inline Exact_rational place_above(const Exact_rational& lower, const Exact_rational& upper, double t)
{
  return lower + Exact_rational(std::ldexp(std::ceil(std::ldexp(t, 30)) + 1, -30)) * (upper - lower);
}

// (c - lower) / (upper - lower) as a number of the solver.
template <class NT, class Coordinate>
NT local_parameter(const Coordinate& lower, const Coordinate& upper, const Coordinate& c)
{
  if constexpr (std::is_same_v<NT, double>)
    return (c - lower) / (upper - lower);   // relative error of a few units: part of the bound on a restriction
  else if constexpr (std::is_same_v<Coordinate, double>)
    return (NT(c) - NT(lower)) / (NT(upper) - NT(lower));
  else
    return Number_traits<NT>::from_rational((Exact_rational(c) - Exact_rational(lower)) /
                                            (Exact_rational(upper) - Exact_rational(lower)));
}

template <class NT>
bool is_one_half(const NT& parameter)
{
  if constexpr (std::is_same_v<NT, double>)
    return parameter == 0.5;
  else {
    const auto enclosure = Number_traits<NT>::enclosure(parameter);
    return enclosure.inf() == 0.5 && enclosure.sup() == 0.5;
  }
}

// Few numbers, as are those of most nodes of curves, are copied in whole steps, some behind the last one too, and
// without a call of a library function: it would cost more than they do.
constexpr std::size_t copied_at_a_time = 4 * pack_size;

template <class NT>
void copy_with_some_behind(const NT* from, std::size_t count, NT* to)
{
  constexpr std::size_t few = 64;
  if constexpr (std::is_same_v<NT, double>)
    if (count <= few) {
      for (const double* const end = from + count; from < end; from += copied_at_a_time, to += copied_at_a_time)
        unroll<copied_at_a_time / pack_size>(
            [=](auto k) { store(to + k * pack_size, load(Pack(), from + k * pack_size)); });
      return;
    }
  std::copy_n(from, count, to);
}

/*
A box of the subdivision with the Bernstein coefficients of all functions on exactly this box. Doubles carry a bound on
their error per block and function (unpadded doubles lose roots); other number types carry their error themselves.
*/
template <class NT>
class Box_node
{
public:
  using Coordinate = typename Number_traits<NT>::Coordinate;

  std::vector<long> scale;     // per function: the coefficients are those of the function times 2^-scale
  std::vector<Coordinate> lower, upper;

private:
  static constexpr bool has_errors = std::is_same_v<NT, double>;

  // the coefficients; of doubles, also their bounds, so that what a split leaves alone lies together, and some places
  // to copy beyond the end
  std::vector<NT> m_numbers;
  std::vector<double> m_bounds;   // of other number types
  std::size_t m_size = 0, m_errors = 0;

public:
  void allocate(const System_layout& layout)
  {
    m_size = layout.size;
    m_errors = layout.errors;
    m_numbers.assign(m_size + (has_errors ? 2 * m_errors + copied_at_a_time : 0), NT(0));
    m_bounds.assign(has_errors ? 0 : 2 * m_errors, 0);
    scale.assign(layout.functions, 0);
    lower.resize(layout.dimension);
    upper.resize(layout.dimension);
  }

  std::span<NT> coefficients() { return {m_numbers.data(), m_size}; }
  std::span<const NT> coefficients() const { return {m_numbers.data(), m_size}; }

  // Per block and function, a bound on the error of its coefficients.
  std::span<double> errors() { return {bounds_of(*this), m_errors}; }
  std::span<const double> errors() const { return {bounds_of(*this), m_errors}; }

  // Per block and function, a bound on |coefficient|; of doubles only.
  std::span<double> sizes() { return {bounds_of(*this) + m_errors, m_errors}; }
  std::span<const double> sizes() const { return {bounds_of(*this) + m_errors, m_errors}; }

  // Whether an axis still has a coordinate between its ends.
  bool can_split(int axis) const { return place_between(lower[axis], upper[axis], 0.5) != lower[axis]; }

  // Keeps the lower part and writes the upper part to another node.
  void split(const System_layout& layout, int axis, double t, Box_node& above);

  // Shrinks (or slightly enlarges) the box to a part given in local coordinates, rounded outwards.
  // Axes that would lose less than `least_gain` of their width are left alone.
  void restrict_to(const System_layout& layout, const Local_box& part, double least_gain);

  void restrict_axis(const System_layout& layout, int axis, const Coordinate& new_lower, const Coordinate& new_upper);

  void copy_from(const Box_node& other)
  {
    copy_places({0, m_size + 2 * m_errors}, other);
    copy_box(other);
  }

private:
  template <class Node>
  static auto bounds_of(Node& node)
  {
    if constexpr (has_errors)
      return node.m_numbers.data() + node.m_size;
    else
      return node.m_bounds.data();
  }

  // As far as there are such places: bounds lie behind the coefficients only of doubles. Some places behind them are
  // copied as well.
  void copy_places(const Place_range& range, const Box_node& other)
  {
    const std::size_t end = has_errors ? range.end : (std::min)(range.end, m_size);
    if (range.begin < end)
      copy_with_some_behind(other.m_numbers.data() + range.begin, end - range.begin, m_numbers.data() + range.begin);
  }

  // One by one: an end that was set just now is not yet there for who reads two at a time.
  void copy_box(const Box_node& other)
  {
    for (std::size_t j = 0, dimension = lower.size(); j < dimension; ++j) {
      lower[j] = other.lower[j];
      upper[j] = other.upper[j];
    }
    for (std::size_t f = 0, functions = scale.size(); f < functions; ++f)
      scale[f] = other.scale[f];
  }

  /*
  Adds what `cuts` de Casteljau schemes of a degree d may add to the error E of coefficients bounded by M, with u =
  2^-52 for any rounding mode. A cut does d levels s a + t b, each with two products, a sum and the rounding of s = 1 -
  t: at most 3 u M a level. Its parameter is a quotient of two rounded differences, off by 3 u, and moves a coefficient
  by at most 2 d M times that: together 9 d u M. Inside the box |s| + |t| = 1; beyond it each level grows by `growth`.
  Underflow adds less than the 2^-1000 that every error starts with.
  */
  void add_error(const Block_axis& block, int cuts, double growth)
  {
    const int degree = block.view.degree;
    const double power = growth == 1 ? 1 : std::pow(growth, degree) * (1 + 0x1p-40),
                 relative = 10 * cuts * degree * 0x1p-52;
    double *error = errors().data() + block.first_error, *size = sizes().data() + block.first_error;
    for_each_place(block.functions, [=](auto type, std::size_t m) {
      const auto grown_error = load(type, error + m) * power, grown_size = load(type, size + m) * power;
      store(size + m, grown_size);
      store(error + m, grown_error + (grown_size + grown_error) * relative);
    });
  }
};

template <class NT>
void Box_node<NT>::split(const System_layout& layout, int axis, double t, Box_node& above)
{
  const Coordinate cut = place_between(lower[axis], upper[axis], t);
  const NT parameter = local_parameter<NT>(lower[axis], upper[axis], cut);
  if constexpr (has_errors)
    for (const Block_axis& affected : layout.blocks_of_axis[axis])
      add_error(affected, 1, 1);
  for (const Place_range& range : layout.ranges_without_axis[axis])   // before the blocks that may lie behind
    above.copy_places(range, *this);
  above.copy_box(*this);
  upper[axis] = cut;
  above.lower[axis] = cut;
  const bool is_middle = is_one_half(parameter);
  NT *data = m_numbers.data(), *after = above.m_numbers.data();
  for (const Block_axis& affected : layout.blocks_of_axis[axis])
    if (is_middle)
      split_at_one_half(data + affected.offset, after + affected.offset, affected.view);
    else
      split_at(data + affected.offset, after + affected.offset, affected.view, parameter);
}

template <class NT>
void Box_node<NT>::restrict_axis(const System_layout& layout, int axis, const Coordinate& new_lower,
                                 const Coordinate& new_upper)
{
  const bool cuts_before = new_lower != lower[axis], cuts_after = new_upper != upper[axis];
  if (!cuts_before && !cuts_after)
    return;
  const NT t0 = local_parameter<NT>(lower[axis], upper[axis], new_lower);
  const NT inner_t = local_parameter<NT>(new_lower, upper[axis], new_upper);
  double growth = 1;
  if constexpr (has_errors)
    if (new_lower < lower[axis] || new_upper > upper[axis]) {
      const double first = t0 < 0 ? 1 - 2 * t0 : 1, second = inner_t > 1 ? 2 * inner_t - 1 : 1;
      growth = first * second * (1 + 0x1p-40);
    }
  for (const Block_axis& affected : layout.blocks_of_axis[axis]) {
    internal::restrict_to(m_numbers.data() + affected.offset, affected.view, t0, inner_t, cuts_before, cuts_after);
    if constexpr (has_errors)
      add_error(affected, (cuts_before ? 1 : 0) + (cuts_after ? 1 : 0), growth);
  }
  lower[axis] = new_lower;
  upper[axis] = new_upper;
}

template <class NT>
void Box_node<NT>::restrict_to(const System_layout& layout, const Local_box& part, double least_gain)
{
  for (int j = 0; j < layout.dimension; ++j) {
    if (part.lower[j] >= -0.5 && part.upper[j] <= 0.5 && part.width(j) > 1 - least_gain)
      continue;
    Coordinate new_lower = part.lower[j] == -0.5 ? lower[j] : place_below(lower[j], upper[j], part.lower[j] + 0.5);
    Coordinate new_upper = part.upper[j] == 0.5 ? upper[j] : place_above(lower[j], upper[j], part.upper[j] + 0.5);
    if constexpr (std::is_same_v<Coordinate, double>)
      if (const double width = new_upper - new_lower; 0x1p-900 < width && width < 0x1p1000) {
        new_lower = short_below(new_lower, width);
        new_upper = short_above(new_upper, width);
      }
    if (part.lower[j] >= -0.5)
      new_lower = (std::max)(new_lower, lower[j]);
    if (part.upper[j] <= 0.5)
      new_upper = (std::min)(new_upper, upper[j]);
    restrict_axis(layout, j, new_lower, new_upper);
  }
}

/*
What the analysis sees of a node: for doubles the node itself, else the coefficients rounded to double, with the
rounding as the error bound.
*/
template <class NT>
class Lowered_node
{
  std::vector<double> m_coefficients, m_errors;

public:
  // The bounds per block and function, of what was lowered last.
  const double* errors([[maybe_unused]] const Box_node<NT>& node) const
  {
    if constexpr (std::is_same_v<NT, double>)
      return node.errors().data();
    else
      return m_errors.data();
  }

  void lower(const System_layout& layout, const Box_node<NT>& node, Node_view& view)
  {
    if constexpr (std::is_same_v<NT, double>)
      view.reset(node.coefficients().data(), node.errors().data());
    else {
      m_coefficients.resize(layout.size);
      m_errors.assign(layout.errors, 0);
      for (const Block& block : layout.blocks)
        for (std::size_t i = 0; i < block.size(); ++i) {
          const auto interval = Number_traits<NT>::enclosure(node.coefficients()[block.offset + i]);
          const double middle = 0.5 * (interval.inf() + interval.sup());
          m_coefficients[block.offset + i] = middle;
          double& error = m_errors[block.first_error + i % block.functions.size()];
          error =
              (std::max)(error, 0.5 * (interval.sup() - interval.inf()) * (1 + 0x1p-50) + 0x1p-51 * std::abs(middle));
        }
      view.reset(m_coefficients.data(), m_errors.data());
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_BOX_NODE_H
