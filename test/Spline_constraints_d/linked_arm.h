// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_LINKED_ARM_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_LINKED_ARM_H

// Planar arms of links of length 1, whose joints are tangents of half angles, with a domain for each elbow.

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_tracker.h>

#include <array>
#include <vector>

namespace linked_arm {

namespace SC = CGAL::Spline_constraints;
using SC::Expression;
using SC::Vector_expression;

inline Vector_expression<2> direction(const Expression& half)
{
  return {(1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)};
}

inline Vector_expression<2> turned(const Vector_expression<2>& a, const Vector_expression<2>& b)
{
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

struct Arm
{
  std::vector<SC::Unknown> joints;              // and the time
  std::vector<std::vector<SC::Unknown>> elbows; // position, direction, the other joints, the time

  explicit Arm(int links)
  {
    std::vector<std::array<SC::Bound, 2>> ranges(links, {-1, 1});
    ranges.push_back({0, 1});
    joints = SC::unknowns(ranges);
    for (int k = 0; k < links; ++k) {
      std::vector<std::array<SC::Bound, 2>> own(4, {-links, links});
      own.insert(own.end(), ranges.begin() + k + 1, ranges.end());
      elbows.push_back(SC::unknowns(own));
    }
  }

  void link(SC::Constraint_tracker& tracker) const
  {
    for (std::size_t k = 0; k < elbows.size(); ++k) {
      const bool is_first = k == 0;
      const std::vector<SC::Unknown>& last = is_first ? joints : elbows[k - 1];
      const Vector_expression<2> place = is_first ? Vector_expression<2>(0, 0) : Vector_expression<2>(last[0], last[1]);
      const Vector_expression<2> before =
          is_first ? Vector_expression<2>(1, 0) : Vector_expression<2>(last[2], last[3]);
      const Vector_expression<2> own = turned(before, direction(last[is_first ? 0 : 4])), next = place + own;
      std::vector<Expression> formulas{next[0], next[1], own[0], own[1]};
      formulas.insert(formulas.end(), last.begin() + (is_first ? 1 : 5), last.end());
      tracker.link(elbows[k], formulas);
    }
  }

  Vector_expression<2> end() const { return {elbows.back()[0], elbows.back()[1]}; }
  const Expression& time() const { return elbows.back()[4]; }

  std::array<SC::Exact_rational, 2> end(const std::vector<SC::Exact_rational>& point) const
  {
    SC::Exact_rational x = 0, y = 0, c = 1, s = 0;
    for (std::size_t i = 0; i < elbows.size(); ++i) {
      const SC::Exact_rational h = point[i], cosine = (1 - h * h) / (1 + h * h), sine = 2 * h / (1 + h * h),
                               turned_c = c * cosine - s * sine;
      s = c * sine + s * cosine;
      c = turned_c;
      x += c;
      y += s;
    }
    return {x, y};
  }
};

} // namespace linked_arm

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_LINKED_ARM_H
