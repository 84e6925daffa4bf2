// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_SIGNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_SIGNS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/separated_simplices.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

/*
Simplices that are cut in halves until a test settles all parts, or there are too many. Parts have barycentric
coordinates of their vertices, the function on them, and maybe another one. Signs of intervals are certain.
*/
template <int d>
class Simplex_parts
{
public:
  using Interval_form = Bernstein_simplex<Interval, d>;

  struct Part
  {
    std::array<std::array<double, d + 1>, d + 1> vertices; // coordinates are multiples of powers of two
    std::array<Interval_form, 2> forms;
  };

private:
  std::vector<Part> m_left;
  std::size_t m_looked_at = 0;

public:
  Simplex_parts(Interval_form function, Interval_form other)
  {
    Part whole{{}, {std::move(function), std::move(other)}};
    for (int i = 0; i <= d; ++i)
      for (int j = 0; j <= d; ++j)
        whole.vertices[i][j] = i == j ? 1 : 0;
    m_left.push_back(std::move(whole));
  }

  // Whether all parts are settled. Each test tells nothing, or that the answer is no.
  template <class Test>
  bool are_settled(const Test& test, std::size_t most_parts)
  {
    while (!m_left.empty()) {
      const Part part = std::move(m_left.back());
      m_left.pop_back();
      ++m_looked_at;
      const CGAL::Uncertain<bool> answer = test(part);
      if (CGAL::certainly(answer))
        continue;
      if (CGAL::certainly_not(answer) || m_looked_at >= most_parts)
        return false;
      split(part);
    }
    return true;
  }

  std::size_t looked_at() const { return m_looked_at; }

private:
  // In the middle of the longest edge, in barycentric coordinates.
  void split(const Part& part)
  {
    const auto squared_length = [&](int i, int j) {
      double result = 0;
      for (int k = 0; k <= d; ++k) {
        const double x = part.vertices[i][k] - part.vertices[j][k];
        result += x * x;
      }
      return result;
    };
    int first = 0, second = 1;
    for (int i = 0; i <= d; ++i)
      for (int j = i + 1; j <= d; ++j)
        if (squared_length(i, j) > squared_length(first, second)) {
          first = i;
          second = j;
        }
    Part a = part, b = part;
    for (int k = 0; k <= d; ++k)
      a.vertices[second][k] = b.vertices[first][k] = (part.vertices[first][k] + part.vertices[second][k]) / 2;
    for (std::size_t i = 0; i < part.forms.size(); ++i)
      std::tie(a.forms[i], b.forms[i]) = part.forms[i].split(first, second);
    m_left.push_back(std::move(a));
    m_left.push_back(std::move(b));
  }
};

// Whether the function has the sign on all of a part, but where it is zero at vertices that may be so.
template <int d>
bool has_sign_but_at(const Bernstein_simplex<Interval, d>& form, const std::array<bool, d + 1>& may_be_zero,
                     CGAL::Sign sign)
{
  const auto found = form.sign_but_at_vertices();
  if (!CGAL::certainly(found.sign == sign))
    return false;
  for (int i = 0; i <= d; ++i)
    if (found.is_zero[i] && !may_be_zero[i])
      return false;
  return true;
}

// Which vertices of a part are vertices of the whole that may be zeros.
template <int d>
std::array<bool, d + 1> zeros_of_part(const typename Simplex_parts<d>::Part& part,
                                      const std::array<bool, d + 1>& may_be_zero)
{
  std::array<bool, d + 1> result{};
  for (int i = 0; i <= d; ++i)
    for (int j = 0; j <= d; ++j)
      if (part.vertices[i][j] == 1 && may_be_zero[j])
        result[i] = true;
  return result;
}

// Whether a function has a sign on a simplex but at vertices that may be zeros.
template <int d>
bool is_proved_to_have_sign(const Bernstein_simplex<Interval, d>& form, const std::array<bool, d + 1>& may_be_zero,
                            CGAL::Sign sign, std::size_t most_parts, std::size_t& parts)
{
  Simplex_parts<d> simplex(form, Bernstein_simplex<Interval, d>());
  const bool result = simplex.are_settled(
      [&](const auto& part) -> CGAL::Uncertain<bool> {
        if (has_sign_but_at<d>(part.forms[0], zeros_of_part<d>(part, may_be_zero), sign))
          return true;
        for (int i = 0; i <= d; ++i)
          if (CGAL::certainly(Number_traits<Interval>::sign(part.forms[0].at_vertex(i)) == -sign))
            return false;
        return CGAL::Uncertain<bool>::indeterminate();
      },
      most_parts);
  parts += simplex.looked_at();
  return result;
}

// Whether a derivative is positive wherever the function is zero, but at vertices that may be zeros.
inline bool is_proved_to_increase(const Bernstein_simplex<Interval, 3>& form,
                                  const Bernstein_simplex<Interval, 3>& derivative,
                                  const std::array<bool, 4>& may_be_zero, std::size_t most_parts, std::size_t& parts)
{
  Simplex_parts<3> simplex(form, derivative);
  const bool result = simplex.are_settled(
      [&](const auto& part) -> CGAL::Uncertain<bool> {
        if (CGAL::certainly(part.forms[1].sign() == CGAL::POSITIVE))
          return true;
        const auto zeros = zeros_of_part<3>(part, may_be_zero);
        if (has_sign_but_at<3>(part.forms[0], zeros, CGAL::POSITIVE) ||
            has_sign_but_at<3>(part.forms[0], zeros, CGAL::NEGATIVE))
          return true;
        return CGAL::Uncertain<bool>::indeterminate();
      },
      most_parts);
  parts += simplex.looked_at();
  return result;
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PATCH_SIGNS_H
