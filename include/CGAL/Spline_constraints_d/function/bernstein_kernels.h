// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The inner loops of the solver. A tensor is a contiguous array; one axis of it is seen as `outer` x (degree + 1) x `inner` numbers,
where `inner` counts everything that varies faster, interleaved functions included, so that each step runs over contiguous rows.
*/
struct Axis_view
{
  std::size_t outer;
  int degree;
  std::size_t inner;
};

// One de Casteljau step on a row at one half: row <- (previous + row) / 2.
template <class NT>
inline void halve_row(const NT* previous, NT* row, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
    row[i] = (previous[i] + row[i]) * NT(0.5);
}

// One de Casteljau step on a row: row <- s previous + t row, with s = 1 - t.
template <class NT>
inline void blend_row(const NT* previous, NT* row, std::size_t size, const NT& s, const NT& t)
{
  for (std::size_t i = 0; i < size; ++i)
    row[i] = s * previous[i] + t * row[i];
}

// Replaces `data` by the part before the parameter and writes the part after it to `after`, when that is not null.
// `step(previous, row, size)` is one de Casteljau step on a row.
template <class NT, class Step>
inline void de_casteljau(NT* data, NT* after, const Axis_view& view, const Step& step)
{
  const std::size_t line = view.inner * (view.degree + 1);
  for (std::size_t o = 0; o < view.outer; ++o, data += line) {
    NT* last = data + view.inner * view.degree;
    NT* target = after == nullptr ? nullptr : after + o * line + view.inner * view.degree;
    if (target != nullptr)
      for (std::size_t i = 0; i < view.inner; ++i)
        target[i] = last[i];
    for (int r = 1; r <= view.degree; ++r) {
      for (int k = view.degree; k >= r; --k)
        step(data + view.inner * (k - 1), data + view.inner * k, view.inner);
      if (target != nullptr) {
        target -= view.inner;
        for (std::size_t i = 0; i < view.inner; ++i)
          target[i] = last[i];
      }
    }
  }
}

// Replaces `data` by the part after the parameter: the same triangle, run from the other end.
template <class NT>
inline void de_casteljau_after(NT* data, const Axis_view& view, const NT& s, const NT& t)
{
  const std::size_t line = view.inner * (view.degree + 1);
  for (std::size_t o = 0; o < view.outer; ++o, data += line)
    for (int r = 1; r <= view.degree; ++r)
      for (int k = 0; k <= view.degree - r; ++k) {
        NT* row = data + view.inner * k;
        const NT* next = row + view.inner;
        for (std::size_t i = 0; i < view.inner; ++i)
          row[i] = s * row[i] + t * next[i];
      }
}

template <class NT>
inline void split_at_one_half(NT* data, NT* after, const Axis_view& view)
{
  de_casteljau(data, after, view, [](const NT* previous, NT* row, std::size_t size) { halve_row(previous, row, size); });
}

template <class NT>
inline void split_at(NT* data, NT* after, const Axis_view& view, const NT& t)
{
  const NT s = NT(1) - t;
  de_casteljau(data, after, view,
               [&](const NT* previous, NT* row, std::size_t size) { blend_row(previous, row, size, s, t); });
}

// Replaces `data` by the part between two parameters, which may lie outside [0,1]. `inner_t` is (t1 - t0) / (1 - t0), the
// place of t1 in what remains after the first cut.
template <class NT>
inline void restrict_to(NT* data, const Axis_view& view, const NT& t0, const NT& inner_t, bool cuts_before, bool cuts_after)
{
  if (cuts_before)
    de_casteljau_after(data, view, NT(NT(1) - t0), t0);
  if (cuts_after)
    split_at(data, static_cast<NT*>(nullptr), view, inner_t);
}

/*
Bounds. Comparisons run elementwise over contiguous pieces, which compilers turn into vector instructions; a reduction to one number would not be. A
piece is `stretch` numbers long: a multiple of the number of interleaved functions that divides what it is laid over.
*/

// lower <- min(lower, data), upper <- max(upper, data), elementwise.
inline void widen(const double* __restrict data, double* __restrict lower, double* __restrict upper, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i) {
    lower[i] = data[i] < lower[i] ? data[i] : lower[i];
    upper[i] = data[i] > upper[i] ? data[i] : upper[i];
  }
}

// The same for two arrays, one that bounds from below and one from above.
inline void widen(const double* __restrict data_lower, const double* __restrict data_upper, double* __restrict lower,
                  double* __restrict upper, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i) {
    lower[i] = data_lower[i] < lower[i] ? data_lower[i] : lower[i];
    upper[i] = data_upper[i] > upper[i] ? data_upper[i] : upper[i];
  }
}

inline void widen_by_differences(const double* __restrict data, std::size_t distance, double* __restrict lower,
                                 double* __restrict upper, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i) {
    const double difference = data[i + distance] - data[i];
    lower[i] = difference < lower[i] ? difference : lower[i];
    upper[i] = difference > upper[i] ? difference : upper[i];
  }
}

// Bounds per function of `size` numbers; `work` holds 2 stretch numbers.
inline void bound_functions(const double* data_lower, const double* data_upper, std::size_t size, std::size_t stretch,
                            std::size_t functions, double* work, double* lower, double* upper)
{
  const double *least = data_lower, *most = data_upper;
  if (stretch < size) {
    double *work_lower = work, *work_upper = work + stretch;
    for (std::size_t i = 0; i < stretch; ++i) {
      work_lower[i] = data_lower[i];
      work_upper[i] = data_upper[i];
    }
    for (std::size_t i = stretch; i < size; i += stretch)
      widen(data_lower + i, data_upper + i, work_lower, work_upper, stretch);
    least = work_lower;
    most = work_upper;
    size = stretch;
  }
  for (std::size_t f = 0; f < functions; ++f) {
    lower[f] = least[f];
    upper[f] = most[f];
  }
  for (std::size_t i = functions; i < size; i += functions)
    widen(least + i, most + i, lower, upper, functions);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H
