// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_STACK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_STACK_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/bernstein_doubles.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A part of the unit square: ranges of the parameters, and the errors of the coefficients of two functions on it.
struct Bernstein_part
{
  Degrees degrees;
  std::array<double, 2> begin, end;
  std::array<int, 2> sides; // -1, or the end of the square at which a parameter is fixed
  std::array<double, 2> errors;

  double width(int axis) const { return end[axis] - begin[axis]; }
};

/*
The parts that a search in depth has yet to look at, with the coefficients of one or two functions of the same degrees
on each. They are divided next to the middle: solutions of symmetric problems are at halves.
*/
class Part_stack
{
  static constexpr double cut = 0.46875;
  static constexpr double least_width = 0x1p-24;
  static constexpr std::size_t most_slots = 64;

  std::vector<double> m_storage;
  std::vector<Bernstein_part> m_parts;
  std::size_t m_size = 0; // of a tensor
  int m_count = 1;        // of functions
  std::array<double, 2> m_greatest{};

public:
  // Makes room for the coefficients of the whole square: the second function is `size` behind the first one.
  double* begin(std::size_t size)
  {
    m_size = size;
    m_storage.resize((std::max)(m_storage.size(), 2 * m_size * most_slots));
    m_parts.clear();
    m_parts.reserve(most_slots);
    return m_storage.data();
  }

  // The whole square, with as many parameters, where functions have coefficients up to these.
  void push(const Degrees& degrees, int parameters, int functions, const std::array<double, 2>& errors,
            const std::array<double, 2>& greatest)
  {
    m_count = functions;
    m_greatest = greatest;
    m_parts.push_back({degrees, {0, 0}, {1, 1}, {parameters > 0 ? -1 : 0, parameters > 1 ? -1 : 0}, errors});
  }

  bool empty() const { return m_parts.empty(); }
  Bernstein_part& top() { return m_parts.back(); }
  const Bernstein_part& top() const { return m_parts.back(); }
  double* coefficients(int function = 0)
  {
    return m_storage.data() + (2 * (m_parts.size() - 1) + static_cast<std::size_t>(function)) * m_size;
  }
  void pop() { m_parts.pop_back(); }

  // The place of the last part in it.
  std::array<double, 2> parameters(const std::array<double, 2>& place) const
  {
    std::array<double, 2> result;
    for (const int axis : {0, 1})
      result[axis] = top().begin[axis] + place[axis] * top().width(axis);
    return result;
  }

  // Whether the last part may be divided again.
  bool is_divisible() const
  {
    const Bernstein_part& part = top();
    return m_parts.size() < most_slots &&
        ((part.sides[0] < 0 && part.width(0) > least_width) || (part.sides[1] < 0 && part.width(1) > least_width));
  }

  // Keeps the face of the last part at an end of the square, if it reaches that; returns whether it does.
  bool restrict_to_edge(int axis, int side)
  {
    Bernstein_part& part = top();
    if ((side == 0 ? part.begin[axis] : part.end[axis]) != side)
      return false;
    Degrees degrees = part.degrees;
    for (int function = 0; function < m_count; ++function) {
      degrees = part.degrees;
      restrict_to_face(degrees, axis, side, coefficients(function));
    }
    part.degrees = degrees;
    part.sides[axis] = side;
    part.begin[axis] = part.end[axis] = side;
    return true;
  }

  // The half with the least coefficient of the first function comes next.
  void divide(int axis)
  {
    Bernstein_part& part = top();
    double *lower = coefficients(), *upper = lower + 2 * m_size;
    for (int function = 0; function < m_count; ++function) {
      const std::size_t offset = static_cast<std::size_t>(function) * m_size;
      split(part.degrees, axis, cut, lower + offset, upper + offset);
      part.errors[function] += split_error(part.degrees, axis) * m_greatest[function];
    }
    Bernstein_part other = part;
    part.end[axis] = other.begin[axis] = part.begin[axis] + cut * part.width(axis);
    const std::size_t size = size_of(part.degrees);
    if (*std::min_element(lower, lower + size) < *std::min_element(upper, upper + size)) {
      std::swap(part, other);
      std::swap_ranges(lower, lower + 2 * m_size, upper);
    }
    m_parts.push_back(other);
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_STACK_H
