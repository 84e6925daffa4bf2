// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_TENSORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_TENSORS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <random>
#include <vector>

// Seeded random exact data for the tests of the function layer.
struct Random_source
{
  using FT = CGAL::Spline_constraints::Exact_rational;
  using Tensor = CGAL::Spline_constraints::Bernstein_tensor<FT>;

  std::mt19937_64 engine;

  explicit Random_source(unsigned seed) : engine(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }

  FT rational() { return FT(integer(-60, 60)) / FT(integer(1, 12)); }

  // In [0,1].
  FT fraction()
  {
    const int below = integer(1, 24);
    return FT(integer(0, below)) / FT(below);
  }

  std::vector<FT> point(int dimension)
  {
    std::vector<FT> result;
    for (int j = 0; j < dimension; ++j)
      result.push_back(fraction());
    return result;
  }

  std::vector<int> degrees(int dimension, int highest)
  {
    std::vector<int> result;
    for (int j = 0; j < dimension; ++j)
      result.push_back(integer(0, highest));
    return result;
  }

  std::vector<FT> numbers(std::size_t count)
  {
    std::vector<FT> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(rational());
    return result;
  }

  Tensor tensor(const std::vector<int>& degrees)
  {
    std::size_t size = 1;
    for (int d : degrees)
      size *= d + 1;
    return Tensor(degrees, numbers(size));
  }

  // Degrees up to 6 on few axes, up to 2 on five.
  Tensor tensor(int dimension)
  {
    const int highest[] = {0, 6, 6, 4, 3, 2};
    return tensor(degrees(dimension, highest[dimension]));
  }
};

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_TENSORS_H
