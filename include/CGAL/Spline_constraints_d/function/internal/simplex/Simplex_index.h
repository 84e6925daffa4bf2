// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_INDEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_INDEX_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Number of coefficients on a simplex.
constexpr std::size_t simplex_size(int degree, int dimension)
{
  std::size_t result = 1;
  for (int i = 1; i <= dimension; ++i)
    result = result * static_cast<std::size_t>(degree + i) / static_cast<std::size_t>(i);
  return result;
}

// The sizes of simplices of up to d dimensions.
template <int d>
class Simplex_sizes
{
  static constexpr int degrees = 122; // some more than polynomials have

  std::array<std::array<std::size_t, d + 1>, degrees> m_sizes{};

public:
  constexpr Simplex_sizes()
  {
    for (int degree = 0; degree < degrees; ++degree)
      for (int dimension = 0; dimension <= d; ++dimension)
        m_sizes[degree][dimension] = simplex_size(degree, dimension);
  }

  constexpr std::size_t operator()(int degree, int dimension) const { return m_sizes[degree][dimension]; }
};

template <int d>
inline constexpr Simplex_sizes<d> simplex_sizes{};

/*
Goes through the exponents of degree k in d + 1 barycentric coordinates, lexicographically from (k,0,...,0) down to
(0,...,0,k). What counts are the tails s_j = e_j + ... + e_d: the position of an exponent is the sum over j = 1, ..., d
of the binomials (s_j + d - j over d - j + 1). It does not depend on s_0 = k: the exponents of degree k - 1, with one
more of the first vertex, are the first ones of degree k.
*/
template <int d>
class Simplex_index
{
  std::array<int, d + 1> m_tails{};
  std::size_t m_position = 0;

public:
  explicit Simplex_index(int degree) { m_tails[0] = degree; }

  bool is_valid() const { return m_tails[1] <= m_tails[0]; }

  void operator++()
  {
    ++m_position;
    int j = d;
    for (; j > 1 && m_tails[j] == m_tails[j - 1]; --j)
      m_tails[j] = 0;
    ++m_tails[j];
  }

  std::size_t position() const { return m_position; }
  const std::array<int, d + 1>& tails() const { return m_tails; }
  int exponent(int i) const { return m_tails[i] - (i < d ? m_tails[i + 1] : 0); }

  // The set of vertices with a positive exponent, as bits.
  unsigned support() const
  {
    unsigned result = 0;
    for (int i = 0; i <= d; ++i)
      if (exponent(i) > 0)
        result |= 1u << i;
    return result;
  }

  // The positions, in the degree above, of the exponents with one more of each vertex.
  std::array<std::size_t, d + 1> raised() const
  {
    std::array<std::size_t, d + 1> result;
    result[0] = m_position;
    for (int i = 1; i <= d; ++i)
      result[i] = result[i - 1] + simplex_sizes<d>(m_tails[i], d - i);
    return result;
  }

  // The position with more of one vertex.
  std::size_t raised(int vertex, int times) const
  {
    std::array<int, d + 1> tails = m_tails;
    for (int j = 0; j <= vertex; ++j)
      tails[j] += times;
    return position_of_tails(tails);
  }

  static std::size_t position_of_tails(const std::array<int, d + 1>& tails)
  {
    std::size_t result = 0;
    for (int j = 1; j <= d; ++j)
      if (tails[j] > 0)
        result += simplex_sizes<d>(tails[j] - 1, d - j + 1);
    return result;
  }

  static std::size_t position_of(const std::array<int, d + 1>& exponents)
  {
    std::array<int, d + 1> tails = exponents;
    for (int j = d - 1; j >= 0; --j)
      tails[j] += tails[j + 1];
    return position_of_tails(tails);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_INDEX_H
