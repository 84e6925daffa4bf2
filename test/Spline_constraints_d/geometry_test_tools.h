// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_GEOMETRY_TEST_TOOLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_GEOMETRY_TEST_TOOLS_H

#include "random_tensors.h"

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

using Exact_rational = CGAL::Spline_constraints::Exact_rational;
using Exact_cartesian = CGAL::Simple_cartesian<Exact_rational>;
using Double_cartesian = CGAL::Simple_cartesian<double>;

template <class Call>
void expect_invalid(const Call& call, const std::string& fragment)
{
  try {
    call();
    ADD_FAILURE() << "no exception; expected one naming: " << fragment;
  } catch (const CGAL::Spline_constraints::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
  }
}

// The number of edges of a kind in a boundary.
template <class Boundary, class Kind>
std::size_t count_edges(const Boundary& boundary, Kind kind)
{
  return static_cast<std::size_t>(std::count_if(boundary.edges().begin(), boundary.edges().end(),
                                                [=](const auto& edge) { return edge.kind == kind; }));
}

// Seeded random exact knots, points, weights and parameters.
struct Random_geometry
  : Random_source
{
  using Random_source::Random_source;

  // A clamped or floating vector over [0, 1] with up to three inner knots of multiplicity up to `highest`.
  std::vector<FT> knots(int degree, int highest)
  {
    std::vector<FT> inner;
    for (int k = integer(1, 3); k > 0 && highest > 0; --k) {
      const FT knot = FT(integer(1, 11)) / FT(12);
      if (std::find(inner.begin(), inner.end(), knot) == inner.end())
        inner.insert(inner.end(), integer(1, highest), knot);
    }
    std::sort(inner.begin(), inner.end());
    const bool is_clamped = integer(0, 1) == 1;
    std::vector<FT> result;
    for (int i = degree; i >= 1; --i)
      result.push_back(is_clamped ? FT(0) : FT(-i) / FT(5));
    result.push_back(FT(0));
    result.insert(result.end(), inner.begin(), inner.end());
    result.push_back(FT(1));
    for (int i = 1; i <= degree; ++i)
      result.push_back(is_clamped ? FT(1) : FT(1) + FT(i) / FT(7));
    return result;
  }

  std::vector<FT> weights(std::size_t count)
  {
    std::vector<FT> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(FT(integer(1, 30)) / FT(integer(1, 6)));
    return result;
  }

  template <class Kernel, int d>
  std::vector<typename CGAL::Spline_constraints::Bspline_curve<Kernel, d>::Point> points(std::size_t count)
  {
    using Point = typename CGAL::Spline_constraints::Bspline_curve<Kernel, d>::Point;
    std::vector<Point> result;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<FT, d> x;
      for (FT& coordinate : x)
        coordinate = rational();
      result.push_back(CGAL::Spline_constraints::internal::kernel_object<Kernel, Point>(x));
    }
    return result;
  }

  // As smooth at its knots as `smoothness` derivatives, and rational every other time.
  template <class Kernel, int d>
  CGAL::Spline_constraints::Bspline_curve<Kernel, d> curve(int highest_degree = 4, int smoothness = 0)
  {
    const int degree = integer(1, highest_degree);
    const std::vector<FT> t = knots(degree, degree - smoothness);
    const std::size_t count = t.size() - degree - 1;
    const std::vector<FT> w = integer(0, 1) == 1 ? weights(count) : std::vector<FT>();
    return {degree, kernel_numbers<Kernel>(t), points<Kernel, d>(count), kernel_numbers<Kernel>(w)};
  }

  template <class Kernel>
  static std::vector<typename Kernel::FT> kernel_numbers(const std::vector<FT>& values)
  {
    std::vector<typename Kernel::FT> result;
    for (const FT& x : values)
      result.push_back(CGAL::Spline_constraints::internal::converted_number<typename Kernel::FT>(x));
    return result;
  }
};

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_GEOMETRY_TEST_TOOLS_H
