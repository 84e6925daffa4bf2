// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Rational_function.h>
#include <CGAL/Spline_constraints_d/function/concepts.h>

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <string>

namespace function_concepts_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = SC::Exact_rational;
using Interval = CGAL::Interval_nt<false>;

// The least that models MultivariateFunction: the sum of the parameters, of a box.
struct Sum_of_parameters
{
  using Number_type = double;
  std::vector<std::pair<double, double>> box;

  int dimension() const { return static_cast<int>(box.size()); }
  std::pair<double, double> domain(int axis) const { return box[axis]; }
  double operator()(std::span<const double> u) const
  {
    double sum = 0;
    for (double x : u)
      sum += x;
    return sum;
  }
  std::pair<double, double> bounds() const
  {
    std::pair<double, double> result(0, 0);
    for (const auto& range : box) {
      result.first += range.first;
      result.second += range.second;
    }
    return result;
  }
  std::pair<double, double> derivative_bounds(int) const { return {1, 1}; }
  Sum_of_parameters restricted(int axis, double begin, double end) const
  {
    Sum_of_parameters result = *this;
    result.box[axis] = {begin, end};
    return result;
  }
  std::pair<Sum_of_parameters, Sum_of_parameters> split(int axis, double t) const
  {
    return {restricted(axis, box[axis].first, t), restricted(axis, t, box[axis].second)};
  }
};

static_assert(SC::MultivariateFunction<Sum_of_parameters>);
static_assert(!SC::MultivariateSpline<Sum_of_parameters>);
static_assert(SC::MultivariateSpline<SC::Bernstein_tensor<double>>);
static_assert(SC::MultivariateSpline<SC::Bernstein_tensor<Interval>>);
static_assert(SC::MultivariateSpline<SC::Bernstein_tensor<FT>>);
static_assert(SC::MultivariateSpline<SC::Bspline_function<double>>);
static_assert(SC::MultivariateSpline<SC::Bspline_function<FT>>);
static_assert(SC::MultivariateFunction<SC::Rational_function<SC::Bernstein_tensor<double>>>);
static_assert(SC::MultivariateFunction<SC::Rational_function<SC::Bernstein_tensor<Interval>>>);
static_assert(SC::MultivariateFunction<SC::Rational_function<SC::Bspline_function<FT>>>);
static_assert(!SC::MultivariateFunction<double>);
static_assert(!SC::MultivariateFunction<std::string>);

// What any model promises, through the concept alone.
template <SC::MultivariateFunction Function>
void check_promises(const Function& function)
{
  using NT = typename Function::Number_type;
  std::vector<NT> middle;
  for (int j = 0; j < function.dimension(); ++j)
    middle.push_back((function.domain(j).first + function.domain(j).second) / NT(2));
  const auto [low, high] = function.bounds();
  EXPECT_LE(low, function(middle));
  EXPECT_LE(function(middle), high);
  for (int axis = 0; axis < function.dimension(); ++axis) {
    // The middle is the end of the first half and the begin of the second.
    const auto [before, after] = function.split(axis, middle[axis]);
    std::vector<NT> u = middle, v = middle;
    u[axis] = before.domain(axis).second;
    v[axis] = after.domain(axis).first;
    EXPECT_EQ(before(u), function(middle));
    EXPECT_EQ(after(v), function(middle));
    const NT step = function.domain(axis).second - function.domain(axis).first;
    std::vector<NT> ends = middle;
    ends[axis] = function.domain(axis).first;
    const NT first = function(ends);
    ends[axis] = function.domain(axis).second;
    const NT difference = function(ends) - first;
    const auto [least, greatest] = function.derivative_bounds(axis);
    EXPECT_LE(NT(least * step), difference);
    EXPECT_LE(difference, NT(greatest * step));
  }
}

TEST(MultivariateFunction, models_keep_the_promises_of_the_concept)
{
  check_promises(Sum_of_parameters{{{0, 1}, {2, 4}}});
  const SC::Bernstein_tensor<FT> tensor({2, 1}, {1, 5, 3, 4, 2, 8});
  check_promises(tensor);
  check_promises(SC::Bspline_function<FT>({2}, {{0, 0, 0, 1, 4, 4, 4}}, {3, 1, 2, 8}));
  check_promises(SC::Rational_function<SC::Bernstein_tensor<FT>>(tensor, SC::Bernstein_tensor<FT>({1, 0}, {1, 2})));
}

} // namespace

} // namespace function_concepts_test
