// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The inner loops of the solver. A tensor is a contiguous array; one axis of it is seen as `outer` x (degree + 1) x
`inner` numbers, where `inner` counts everything that varies faster, interleaved functions included, so that each step
runs over contiguous rows.
*/
struct Axis_view
{
  std::size_t outer;
  int degree;
  std::size_t inner;
};

/*
De Casteljau's scheme on rows of numbers, for all number types and degrees: a pass over the rows per level.
*/

// Replaces `data` by the part before the parameter and writes the part after it to `after`, when that is not null.
// `mean(previous, number)` is the mean of two neighbours.
template <class NT, class Mean>
inline void split_rows(NT* data, NT* after, const Axis_view& view, const Mean& mean)
{
  const std::size_t line = view.inner * (view.degree + 1);
  for (std::size_t o = 0; o < view.outer; ++o, data += line) {
    NT* last = data + view.inner * view.degree;
    NT* target = after == nullptr ? nullptr : after + o * line + view.inner * view.degree;
    if (target != nullptr)
      std::copy_n(last, view.inner, target);
    for (int r = 1; r <= view.degree; ++r) {
      for (int k = view.degree; k >= r; --k) {
        NT* row = data + view.inner * k;
        const NT* previous = row - view.inner;
        for (std::size_t i = 0; i < view.inner; ++i)
          row[i] = mean(previous[i], row[i]);
      }
      if (target != nullptr) {
        target -= view.inner;
        std::copy_n(last, view.inner, target);
      }
    }
  }
}

// Replaces `data` by the part after the parameter: the same triangle, run from the other end.
template <class NT, class Mean>
inline void keep_after_in_rows(NT* data, const Axis_view& view, const Mean& mean)
{
  const std::size_t line = view.inner * (view.degree + 1);
  for (std::size_t o = 0; o < view.outer; ++o, data += line)
    for (int r = 1; r <= view.degree; ++r)
      for (int k = 0; k <= view.degree - r; ++k) {
        NT* row = data + view.inner * k;
        const NT* next = row + view.inner;
        for (std::size_t i = 0; i < view.inner; ++i)
          row[i] = mean(row[i], next[i]);
      }
}

/*
The same for doubles of low degree: the control points of two neighbouring lines along the axis fit into the registers
of the machine, where the whole triangle is formed before anything is stored. The same operations in the same order.
*/
constexpr int most_degree_in_registers = 10;

template <int degree, class Number, class Mean, class Keep>
inline void keep_before(Number (&b)[degree + 1], const Mean& mean, const Keep& keep)
{
  keep(std::integral_constant<int, degree>(), b[degree]);
  unroll<degree>([&](auto level) {
    unroll<degree - level>([&](auto i) { b[degree - i] = mean(b[degree - i - 1], b[degree - i]); });
    keep(std::integral_constant<int, degree - 1 - level>(), b[degree]);
  });
}

template <int degree, class Number, class Mean>
inline void keep_after(Number (&b)[degree + 1], const Mean& mean)
{
  unroll<degree>([&](auto level) { unroll<degree - level>([&](auto k) { b[k] = mean(b[k], b[k + 1]); }); });
}

// Calls change(b, position, inner) for the control points of every line along the axis, or of two neighbouring ones,
// the first of which is at `position`. Two lines that make up a pack (`is_pack`), as those of planar curves, have
// places that are known to the compiler.
template <int degree, bool is_pack, class Change>
BOOST_FORCEINLINE void change_lines(double* data, const Axis_view& view, const Change& change)
{
  const std::size_t outer = view.outer;
  const auto change_at = [&]<class Number>(const Number&, std::size_t position, auto inner) {
    Number b[degree + 1];
    unroll<degree + 1>([&](auto k) { b[k] = load(Number(), data + position + k * inner); });
    change(b, position, inner);
    unroll<degree + 1>([&](auto k) { store(data + position + k * inner, b[k]); });
  };
  if constexpr (is_pack) {
    for (std::size_t o = 0; o < outer; ++o)
      change_at(Pack(), o * pack_size * (degree + 1), std::integral_constant<std::size_t, pack_size>());
  } else {
    const std::size_t inner = view.inner;
    for (std::size_t o = 0; o < outer; ++o) {
      std::size_t position = o * inner * (degree + 1);
      const std::size_t end = position + inner;
      for (; position + pack_size <= end; position += pack_size)
        change_at(Pack(), position, inner);
      for (; position < end; ++position)
        change_at(0.0, position, inner);
    }
  }
}

template <class Mean>
struct Split_lines
{
  template <int degree, bool is_pack>
  static void run(double* data, double* after, const Axis_view& view, Mean mean)
  {
    change_lines<degree, is_pack>(data, view, [=](auto& b, std::size_t position, auto inner) {
      keep_before<degree>(b, mean, [=](auto k, const auto& x) { store(after + position + k * inner, x); });
    });
  }
};

template <class Mean>
struct Restrict_lines
{
  template <int degree, bool is_pack>
  static void run(double* data, const Axis_view& view, Mean first, Mean second, bool cuts_before, bool cuts_after)
  {
    change_lines<degree, is_pack>(data, view, [=](auto& b, std::size_t, auto) {
      if (cuts_before)
        keep_after<degree>(b, first);
      if (cuts_after)
        keep_before<degree>(b, second, [](auto, const auto&) {});
    });
  }
};

// Runs the kernel that was compiled for the degree of an axis; false when there is none. They are functions of their
// own: in one, registers would run out, and those for few numbers would save them all.
template <class Kernel, class... Arguments>
inline bool run_in_registers(const Axis_view& view, Arguments&&... arguments)
{
  constexpr int most = most_degree_in_registers;
  static constexpr auto kernels = []<int... k>(std::integer_sequence<int, k...>)
  {
    return std::array{&Kernel::template run<k % most + 1, (k >= most)>...};
  }
  (std::make_integer_sequence<int, 2 * most>());
  if (view.degree < 1 || view.degree > most)
    return false;
  kernels[view.degree - 1 + (view.inner == pack_size ? most : 0)](arguments...);
  return true;
}

template <class NT, class Mean>
inline void split(NT* data, NT* after, const Axis_view& view, const Mean& mean)
{
  if constexpr (std::is_same_v<NT, double>)
    if (run_in_registers<Split_lines<Mean>>(view, data, after, view, mean))
      return;
  split_rows(data, after, view, mean);
}

// The middle of two numbers.
template <class NT>
struct Middle
{
  NT half = NT(0.5);

  template <class Number>
  Number operator()(const Number& a, const Number& b) const { return (a + b) * half; }
};

// s a + t b, with s = 1 - t.
template <class NT>
struct Blend
{
  NT s, t;

  explicit Blend(const NT& given_t) : s(NT(1) - given_t), t(given_t) {}

  template <class Number>
  Number operator()(const Number& a, const Number& b) const { return a * s + b * t; }
};

template <class NT>
inline void split_at_one_half(NT* data, NT* after, const Axis_view& view)
{
  split(data, after, view, Middle<NT>());
}

template <class NT>
inline void split_at(NT* data, NT* after, const Axis_view& view, const NT& t)
{
  split(data, after, view, Blend<NT>(t));
}

// Replaces `data` by the part between two parameters, which may lie outside [0,1]. `inner_t` is (t1 - t0) / (1 - t0),
// the place of t1 in what remains after the first cut.
template <class NT>
inline void restrict_to(NT* data, const Axis_view& view, const NT& t0, const NT& inner_t, bool cuts_before,
                        bool cuts_after)
{
  const Blend<NT> first(t0), second(inner_t);
  if constexpr (std::is_same_v<NT, double>)
    if (run_in_registers<Restrict_lines<Blend<NT>>>(view, data, view, first, second, cuts_before, cuts_after))
      return;
  if (cuts_before)
    keep_after_in_rows(data, view, first);
  if (cuts_after)
    split_rows(data, static_cast<NT*>(nullptr), view, second);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_KERNELS_H
