// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COEFFICIENT_PACKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COEFFICIENT_PACKS_H

#include <CGAL/FPU.h>

#include <boost/config.hpp>

#ifdef CGAL_HAS_SSE2
#include <emmintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Two doubles side by side, as one instruction of every x86-64 takes them. Compilers keep packs with fixed indices in
registers; they do not keep rows of an array there, and do not change the order of a reduction to one number.
*/
constexpr int pack_size = 2;

#ifdef CGAL_HAS_SSE2

struct Pack
{
  __m128d numbers;

  Pack() = default;
  explicit Pack(__m128d given) : numbers(given) {}
  explicit Pack(double both) : numbers(_mm_set1_pd(both)) {}
  Pack(double first, double second) : numbers(_mm_set_pd(second, first)) {}

  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(_mm_add_pd(a.numbers, b.numbers)); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(_mm_sub_pd(a.numbers, b.numbers)); }
  friend Pack operator*(const Pack& a, double b) { return Pack(_mm_mul_pd(a.numbers, _mm_set1_pd(b))); }
};

inline Pack load(Pack, const double* from) { return Pack(_mm_loadu_pd(from)); }
inline void store(double* to, const Pack& pack) { _mm_storeu_pd(to, pack.numbers); }
// As for doubles below, also where a number is not one.
inline Pack lesser(const Pack& a, const Pack& b) { return Pack(_mm_min_pd(b.numbers, a.numbers)); }
inline Pack greater(const Pack& a, const Pack& b) { return Pack(_mm_max_pd(b.numbers, a.numbers)); }
inline Pack magnitude(const Pack& a) { return Pack(_mm_andnot_pd(_mm_set1_pd(-0.0), a.numbers)); }

#else

struct Pack
{
  double first, second;

  Pack() = default;
  explicit Pack(double both) : first(both), second(both) {}
  Pack(double given_first, double given_second) : first(given_first), second(given_second) {}

  friend Pack operator+(const Pack& a, const Pack& b) { return {a.first + b.first, a.second + b.second}; }
  friend Pack operator-(const Pack& a, const Pack& b) { return {a.first - b.first, a.second - b.second}; }
  friend Pack operator*(const Pack& a, double b) { return {a.first * b, a.second * b}; }
};

inline Pack load(Pack, const double* from) { return {from[0], from[1]}; }
inline void store(double* to, const Pack& pack)
{
  to[0] = pack.first;
  to[1] = pack.second;
}
inline Pack lesser(const Pack& a, const Pack& b)
{
  return {b.first < a.first ? b.first : a.first, b.second < a.second ? b.second : a.second};
}
inline Pack greater(const Pack& a, const Pack& b)
{
  return {b.first > a.first ? b.first : a.first, b.second > a.second ? b.second : a.second};
}
inline Pack magnitude(const Pack& a) { return {std::abs(a.first), std::abs(a.second)}; }

#endif

inline double load(double, const double* from) { return *from; }
inline void store(double* to, double number) { *to = number; }
inline double lesser(double a, double b) { return b < a ? b : a; }
inline double greater(double a, double b) { return b > a ? b : a; }
inline double magnitude(double a) { return std::abs(a); }

// step(k) for k = 0..count-1, with k known to the compiler.
template <int count, class Step>
inline void unroll(const Step& step)
{
  [&]<int... k>(std::integer_sequence<int, k...>) { (step(std::integral_constant<int, k>()), ...); }
  (std::make_integer_sequence<int, count>());
}

// Calls run(integral_constant<int, k>) for the k between 1 and `most` that `value` is; otherwise for k = 0.
template <int most, class Run>
inline void run_with_constant(std::size_t value, const Run& run)
{
  if constexpr (most == 0)
    run(std::integral_constant<int, 0>());
  else if (value == most)
    run(std::integral_constant<int, most>());
  else
    run_with_constant<most - 1>(value, run);
}

// Packs of the numbers of so many interleaved functions: after how many the functions come round, and how many at a
// time hide the latency of an operation.
template <int members>
constexpr int packs_per_round = std::lcm(members, pack_size) / pack_size;
template <int members>
constexpr int packs_at_a_time = packs_per_round<members>*(packs_per_round<members> >= 3 ? 1
                                                                                        : 4 / packs_per_round<members>);

// A number per function, times a factor, for a round.
template <int members>
struct Pack_round
{
  Pack packs[packs_per_round<members>];

  explicit Pack_round(const double* numbers, double factor = 1)
  {
    unroll<packs_per_round<members>>([&](auto k) {
      packs[k] = Pack(numbers[k * pack_size % members], numbers[(k * pack_size + 1) % members]) * factor;
    });
  }
};

// Ranges of places, `size` of them from every `distance`-th on.
struct Ranges
{
  std::size_t count, distance, size;
};

/*
The least and the largest numbers per function, for so many functions that are interleaved. below(Pack(), begin, i) and
above(Pack(), begin, i) are the numbers from place i on of a range that begins at `begin`, with the first function, and
has a multiple of `members` numbers. Because the last step over a range may take numbers a second time, a range needs
`shortest` of them.
*/
template <int members>
class Pack_bounds
{
  static constexpr int few = packs_per_round<members>, packs = packs_at_a_time<members>;

  Pack m_least[packs], m_most[packs];

public:
  static constexpr std::size_t shortest = few * pack_size, worthwhile = packs * pack_size;

  Pack_bounds()
  {
    unroll<packs>([&](auto k) {
      m_least[k] = Pack(HUGE_VAL);
      m_most[k] = Pack(-HUGE_VAL);
    });
  }

  // Takes the numbers of ranges, the first of which begins at `begin`.
  template <class Below, class Above>
  void add(std::size_t begin, const Ranges& ranges, const Below& below, const Above& above)
  {
    if (ranges.size >= packs * pack_size)
      add_steps<packs>(begin, ranges, below, above);
    else
      add_steps<few>(begin, ranges, below, above);
  }

  // Adds bounds, each less its function's base.
  void add_less(const Pack_bounds& other, const double* base)
  {
    const Pack_round<members> less(base);
    unroll<packs>([&](auto k) {
      m_least[k] = lesser(m_least[k], other.m_least[k] - less.packs[k % few]);
      m_most[k] = greater(m_most[k], other.m_most[k] - less.packs[k % few]);
    });
  }

  void get(double* least, double* most) const
  {
    double lower[shortest], upper[shortest];
    unroll<few>([&](auto k) {
      Pack low = m_least[k], high = m_most[k];
      unroll<packs / few - 1>([&](auto i) {
        low = lesser(low, m_least[(i + 1) * few + k]);
        high = greater(high, m_most[(i + 1) * few + k]);
      });
      store(lower + k * pack_size, low);
      store(upper + k * pack_size, high);
    });
    for (int m = 0; m < members; ++m) {
      least[m] = lower[m];
      most[m] = upper[m];
      for (std::size_t i = m + members; i < shortest; i += members) {
        least[m] = lesser(least[m], lower[i]);
        most[m] = greater(most[m], upper[i]);
      }
    }
  }

private:
  template <int count, class Below, class Above>
  void add_steps(std::size_t begin, const Ranges& ranges, const Below& below, const Above& above)
  {
    constexpr std::size_t step = count * pack_size;
    const std::size_t size = ranges.size;
    Pack least[count], most[count];   // not behind a pointer
    unroll<count>([&](auto k) {
      least[k] = m_least[k];
      most[k] = m_most[k];
    });
    const auto add_packs = [&](std::size_t i) {
      unroll<count>([&](auto k) {
        least[k] = lesser(least[k], below(Pack(), begin, i + k * pack_size));
        most[k] = greater(most[k], above(Pack(), begin, i + k * pack_size));
      });
    };
    for (std::size_t r = 0; r < ranges.count; ++r, begin += ranges.distance) {
      std::size_t i = 0;
      for (; i + step <= size; i += step)
        add_packs(i);
      if (i < size)
        add_packs(size - step);
    }
    unroll<count>([&](auto k) {
      m_least[k] = least[k];
      m_most[k] = most[k];
    });
  }
};

/*
Bounds per function of numbers below(type, begin, i) and above(type, begin, i) over the places i of ranges that begin at
`begin`, each less base(range)[function] when a base is given. `type` is Pack() or a double, and so is the result.
`members` is the number of functions when that is known to the compiler, else 0.
*/
template <int members, class Below, class Above, class Base = std::nullptr_t>
inline void bound_ranges(std::size_t functions, const Ranges& ranges, const Below& below, const Above& above,
                         double* __restrict lower, double* __restrict upper, const Base& base = nullptr)
{
  constexpr bool has_base = !std::is_same_v<Base, std::nullptr_t>;
  if constexpr (members > 0)
    if (ranges.size >= Pack_bounds<members>::shortest &&
        ranges.count * ranges.size >= Pack_bounds<members>::worthwhile) {
      Pack_bounds<members> bounds;
      if constexpr (has_base)
        for (std::size_t r = 0; r < ranges.count; ++r) {
          Pack_bounds<members> part;
          part.add(r * ranges.distance, {1, 0, ranges.size}, below, above);
          bounds.add_less(part, base(r));
        }
      else
        bounds.add(0, ranges, below, above);
      bounds.get(lower, upper);
      return;
    }
  const std::size_t count = members > 0 ? members : functions;
  for (std::size_t m = 0; m < count; ++m) {
    lower[m] = HUGE_VAL;
    upper[m] = -HUGE_VAL;
  }
  for (std::size_t r = 0; r < ranges.count; ++r) {
    [[maybe_unused]] const double* less = nullptr;
    if constexpr (has_base)
      less = base(r);
    for (std::size_t i = 0; i < ranges.size; i += count)
      for (std::size_t m = 0; m < count; ++m) {
        lower[m] = lesser(lower[m], below(0.0, r * ranges.distance, i + m) - (has_base ? less[m] : 0));
        upper[m] = greater(upper[m], above(0.0, r * ranges.distance, i + m) - (has_base ? less[m] : 0));
      }
  }
}

// Sums per function of value(type, i) over the places i below `size`.
template <int members, class Value>
inline void sum_range(std::size_t functions, std::size_t size, const Value& value, double* __restrict sum)
{
  const std::size_t count = members > 0 ? members : functions;
  std::fill_n(sum, count, 0.0);
  std::size_t i = 0;
  if constexpr (members > 0) {
    constexpr int packs = packs_at_a_time<members>;
    if (size >= packs * pack_size) {
      Pack sums[packs];
      unroll<packs>([&](auto k) { sums[k] = Pack(0); });
      for (; i + packs * pack_size <= size; i += packs * pack_size)
        unroll<packs>([&](auto k) { sums[k] = sums[k] + value(Pack(), i + k * pack_size); });
      double lanes[packs * pack_size];
      unroll<packs>([&](auto k) { store(lanes + k * pack_size, sums[k]); });
      unroll<packs * pack_size>([&](auto k) { sum[k % members] += lanes[k]; });
    }
  }
  for (; i < size; i += count)
    for (std::size_t m = 0; m < count; ++m)
      sum[m] += value(0.0, i + m);
}

// to[i] <- from[i] + factor addend[i modulo the number of functions] for the i below `size`.
template <int members>
inline void add_repeated(std::size_t functions, std::size_t size, const double* from, const double* addend,
                         double factor, double* to)
{
  const std::size_t count = members > 0 ? members : functions;
  std::size_t i = 0;
  if constexpr (members > 0) {
    constexpr int few = packs_per_round<members>;
    if (size >= few * pack_size) {
      const Pack_round<members> repeated(addend, factor);
      for (; i + few * pack_size <= size; i += few * pack_size)
        unroll<few>(
            [&](auto k) { store(to + i + k * pack_size, load(Pack(), from + i + k * pack_size) + repeated.packs[k]); });
    }
  }
  for (; i < size; i += count)
    for (std::size_t m = 0; m < count; ++m)
      to[i + m] = from[i + m] + factor * addend[m];
}

// change(type, i) for the places i below `size`, which it takes one by one or two by two. Inlined always: a call for a
// few numbers costs as much as they do.
template <class Change>
BOOST_FORCEINLINE void for_each_place(std::size_t size, const Change& change)
{
  std::size_t i = 0;
  for (; i + pack_size <= size; i += pack_size)
    change(Pack(), i);
  for (; i < size; ++i)
    change(0.0, i);
}

// The least and the largest of `count` numbers each, `size` places apart: bounds over an axis, whatever varies faster
// being kept.
inline void bound_over_axis(const double* data, std::size_t count, std::size_t size, double* least, double* most)
{
  for_each_place(size, [&](auto type, std::size_t i) {
    auto low = load(type, data + i), high = low;
    for (std::size_t k = i + size; k < count * size; k += size) {
      const auto x = load(type, data + k);
      low = lesser(low, x);
      high = greater(high, x);
    }
    store(least + i, low);
    store(most + i, high);
  });
}

// The same for two arrays, one that bounds from below and one from above. The results may take the places of the first
// numbers.
inline void bound_over_axis(const double* lower, const double* upper, std::size_t count, std::size_t size,
                            double* least, double* most)
{
  for_each_place(size, [&](auto type, std::size_t i) {
    auto low = load(type, lower + i), high = load(type, upper + i);
    for (std::size_t k = i + size; k < count * size; k += size) {
      low = lesser(low, load(type, lower + k));
      high = greater(high, load(type, upper + k));
    }
    store(least + i, low);
    store(most + i, high);
  });
}

// A row of fewer numbers costs more to be taken in long steps than they save.
constexpr std::size_t least_row = 48;

// Bounds per function of a row of so many numbers that bound from below and as many that bound from above.
template <int members>
inline void bound_row(std::size_t functions, std::size_t size, const double* lower, const double* upper, double* least,
                      double* most)
{
  if (size < least_row)
    bound_over_axis(lower, upper, size / functions, functions, least, most);
  else
    bound_ranges<members>(
      functions, {1, 0, size}, [&](auto type, std::size_t, std::size_t i) { return load(type, lower + i); },
      [&](auto type, std::size_t, std::size_t i) { return load(type, upper + i); }, least, most);
}

inline void sum_over_axis(const double* data, std::size_t count, std::size_t size, double* sum)
{
  for_each_place(size, [&](auto type, std::size_t i) {
    auto total = load(type, data + i);
    for (std::size_t k = i + size; k < count * size; k += size)
      total = total + load(type, data + k);
    store(sum + i, total);
  });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_COEFFICIENT_PACKS_H
