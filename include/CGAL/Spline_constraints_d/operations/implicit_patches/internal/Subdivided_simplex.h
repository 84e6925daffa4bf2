// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SUBDIVIDED_SIMPLEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SUBDIVIDED_SIMPLEX_H

#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Face_signs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

// A part of a tetrahedron with functions on it, and which questions are open on it, as bits.
struct Simplex_part
{
  std::array<Form::Barycentric, 4> vertices; // in coordinates of the whole
  std::vector<Form> forms;
  unsigned open_questions = ~0u;
};

// The answer to a question that is yes if it is on all parts.
inline CGAL::Uncertain<bool> answer_of_parts(bool is_refuted, int question, const std::vector<Simplex_part>& left)
{
  if (is_refuted)
    return false;
  const bool is_open = std::any_of(
      left.begin(), left.end(), [&](const Simplex_part& part) { return (part.open_questions >> question & 1) != 0; });
  return is_open ? CGAL::Uncertain<bool>::indeterminate() : CGAL::Uncertain<bool>(true);
}

// An edge, and the square of its length, nearly, where the whole is a regular tetrahedron with edges of length sqrt(2).
// So affine maps change nothing.
struct Simplex_edge
{
  int first = 0, second = 1;
  double squared_length = 0;
};

inline Simplex_edge longest_edge(const std::array<Form::Barycentric, 4>& vertices)
{
  Simplex_edge result;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      double squared_length = 0;
      for (int k = 0; k < 4; ++k) {
        const double x = to_nearest_double(Exact_rational(vertices[j][k] - vertices[i][k]));
        squared_length += x * x;
      }
      if (squared_length > result.squared_length)
        result = {i, j, squared_length};
    }
  return result;
}

inline std::pair<Simplex_part, Simplex_part> halves(const Simplex_part& part, const Simplex_edge& edge)
{
  std::pair<Simplex_part, Simplex_part> result{{part.vertices, {}, ~0u}, {part.vertices, {}, ~0u}};
  for (int k = 0; k < 4; ++k) {
    const Exact_rational middle =
        Number_traits<Exact_rational>::half_sum(part.vertices[edge.first][k], part.vertices[edge.second][k]);
    result.first.vertices[edge.second][k] = result.second.vertices[edge.first][k] = middle;
  }
  for (const Form& form : part.forms) {
    auto halves_of_form = form.split(edge.first, edge.second);
    result.first.forms.push_back(std::move(halves_of_form.first));
    result.second.forms.push_back(std::move(halves_of_form.second));
  }
  return result;
}

/*
Cuts a tetrahedron in halves, across its longest edge each time, until `is_settled(part)`, and returns the parts that
are left without an answer: when the run ends, and those shorter than the tolerance times the whole. That grows whenever
so many parts have come to it. Nothing is left when `is_done()`. First level by level, so that large parts come first,
then one after the other, so that not too many wait.
*/
template <class IsSettled, class IsDone>
std::vector<Simplex_part> subdivided(Simplex_part whole, const Solver_options& options, Common::Run_of_steps& run,
                                     const IsSettled& is_settled, const IsDone& is_done)
{
  constexpr std::size_t most_waiting = 1024;
  double least = longest_edge(whole.vertices).squared_length * options.tolerance * options.tolerance;
  std::vector<Simplex_part> left;
  std::deque<Simplex_part> waiting;
  waiting.push_back(std::move(whole));
  while (!waiting.empty() && !is_done()) {
    const bool is_first = waiting.size() < most_waiting;
    Simplex_part part = std::move(is_first ? waiting.front() : waiting.back());
    if (is_first)
      waiting.pop_front();
    else
      waiting.pop_back();
    if (run.must_stop()) {
      left.push_back(std::move(part));
      std::move(waiting.begin(), waiting.end(), std::back_inserter(left));
      return left;
    }
    if (is_settled(part))
      continue;
    const Simplex_edge edge = longest_edge(part.vertices);
    if (edge.squared_length <= least) {
      left.push_back(std::move(part));
      if (left.size() % options.coarsening_step == 0)
        least *= 4;
      continue;
    }
    auto [first, second] = halves(part, edge);
    waiting.push_back(std::move(first));
    waiting.push_back(std::move(second));
  }
  if (is_done())
    left.clear();
  return left;
}

inline std::array<Form::Barycentric, 4> vertices_of_whole()
{
  std::array<Form::Barycentric, 4> result{};
  for (int i = 0; i < 4; ++i)
    result[i][i] = Exact_rational(1);
  return result;
}

inline std::array<Exact_rational, 3> coordinates_of(const Simplex_vertices<3>& whole, const Form::Barycentric& tau)
{
  std::array<Exact_rational, 3> result{};
  for (int i = 0; i < 4; ++i)
    for (int axis = 0; axis < 3; ++axis)
      result[axis] += Exact_rational(tau[i] * whole[i][axis]);
  return result;
}

inline Exact_kernel::Point_3 point_of(const std::array<Exact_rational, 3>& x) { return {x[0], x[1], x[2]}; }

inline Exact_kernel::Tetrahedron_3 tetrahedron_of(const Simplex_part& part, const Simplex_vertices<3>& whole)
{
  const auto vertex = [&](int i) { return point_of(coordinates_of(whole, part.vertices[i])); };
  return {vertex(0), vertex(1), vertex(2), vertex(3)};
}

inline Undecided_part undecided_part(const Simplex_part& part, const Simplex_vertices<3>& whole,
                                     const Common::Run_of_steps& run)
{
  Undecided_part result{{}, {}, in_words(run.is_stopped() ? run.reason() : Undecided_reason::TOLERANCE)};
  const auto box = tetrahedron_of(part, whole).bbox();
  for (int axis = 0; axis < 3; ++axis)
    result.place.emplace_back((box.min)(axis), (box.max)(axis));
  return result;
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SUBDIVIDED_SIMPLEX_H
