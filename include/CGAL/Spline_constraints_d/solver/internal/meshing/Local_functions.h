// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_LOCAL_FUNCTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_LOCAL_FUNCTIONS_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Double_word.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Functions at a point: their values, and their derivatives in rows of one function each.
struct Function_jets
{
  std::vector<double> values;
  std::vector<double> gradients; // n numbers per function
  std::vector<double> hessians;  // n * n numbers per function, symmetric
};

// A polynomial of some unknowns in powers of their distances from a place.
struct Local_term
{
  std::vector<int> variables, degrees;
  std::vector<double> coefficients; // the last axis fastest
};

/*
Polynomials near a place, in doubles, with their first and second derivatives. The coefficients are those of powers of
the distances from the place, and rounded once, so that sums which nearly cancel far away from it do not blur them.
*/
class Local_functions
{
  std::vector<double> m_place;
  std::vector<std::vector<Local_term>> m_functions;

  // Partial sums of a term, with the derivatives by the axes that have been summed over, see channel().
  mutable std::vector<double> m_sums;

public:
  Local_functions(std::vector<double> place, std::vector<std::vector<Local_term>> functions)
    : m_place(std::move(place)), m_functions(std::move(functions))
  {}

  std::size_t dimension() const { return m_place.size(); }
  std::size_t size() const { return m_functions.size(); }
  const std::vector<double>& place() const { return m_place; }

  // Values and derivatives up to an order, 1 or 2.
  void evaluate(std::span<const double> point, int order, Function_jets& result) const
  {
    const std::size_t n = dimension();
    result.values.assign(size(), 0);
    result.gradients.assign(size() * n, 0);
    result.hessians.assign(order > 1 ? size() * n * n : 0, 0);
    for (std::size_t i = 0; i < size(); ++i)
      for (const Local_term& term : m_functions[i])
        if (order > 1)
          add<2>(term, point, i, result);
        else
          add<1>(term, point, i, result);
  }

private:
  // Where sums begin, counted in numbers of coefficients: those of values at 0; behind them, for each axis i that was
  // summed over, those of its derivatives, and those of second derivatives by i and the axes k <= i.
  static std::size_t channel(std::size_t i) { return 1 + i * (i + 3) / 2; }
  static std::size_t channel(std::size_t i, std::size_t k) { return channel(i) + 1 + k; }

  // Sums over one axis after the other, the last one first. Sums take the place of what was summed, whose rows are
  // longer.
  template <int Order>
  void add(const Local_term& term, std::span<const double> point, std::size_t function, Function_jets& result) const
  {
    const std::size_t n = dimension(), axes = term.variables.size(), size = term.coefficients.size();
    m_sums.resize((std::max)(m_sums.size(), size * channel(axes)));
    const auto sums = [&](std::size_t place) { return m_sums.data() + place * size; };
    const double* values = term.coefficients.data();
    std::size_t rows = size;
    for (std::size_t i = 0; i < axes; ++i) {
      const std::size_t axis = axes - 1 - i, length = static_cast<std::size_t>(term.degrees[axis]) + 1;
      const auto v = static_cast<std::size_t>(term.variables[axis]);
      const double x = point[v] - m_place[v];
      rows /= length;
      sum<Order>(values, rows, length, x, {sums(0), sums(channel(i)), sums(channel(i, i))});
      values = sums(0);
      for (std::size_t k = 0; k < i; ++k)
        sum<Order - 1>(sums(channel(k)), rows, length, x, {sums(channel(k)), sums(channel(i, k)), nullptr});
      for (std::size_t k = 0; Order > 1 && k < i; ++k)
        for (std::size_t l = 0; l <= k; ++l)
          sum<0>(sums(channel(k, l)), rows, length, x, {sums(channel(k, l)), nullptr, nullptr});
    }
    const auto unknown = [&](std::size_t i) { return static_cast<std::size_t>(term.variables[axes - 1 - i]); };
    result.values[function] += *values;
    for (std::size_t i = 0; i < axes; ++i)
      result.gradients[function * n + unknown(i)] += *sums(channel(i));
    for (std::size_t i = 0; Order > 1 && i < axes; ++i)
      for (std::size_t k = 0; k <= i; ++k) {
        const double derivative = *sums(channel(i, k));
        result.hessians[(function * n + unknown(i)) * n + unknown(k)] += derivative;
        if (i != k)
          result.hessians[(function * n + unknown(k)) * n + unknown(i)] += derivative;
      }
  }

  // Values of polynomials in one variable by Horner's rule, and their derivatives up to an order, each to its place.
  template <int Order>
  static void sum(const double* coefficients, std::size_t rows, std::size_t length, double x,
                  const std::array<double*, 3>& to)
  {
    for (std::size_t r = 0; r < rows; ++r, coefficients += length) {
      double value = coefficients[length - 1], first = 0, half_of_second = 0;
      for (std::size_t k = length - 1; k-- > 0;) {
        if constexpr (Order > 1)
          half_of_second = half_of_second * x + first;
        if constexpr (Order > 0)
          first = first * x + value;
        value = value * x + coefficients[k];
      }
      to[0][r] = value;
      if constexpr (Order > 0)
        to[1][r] = first;
      if constexpr (Order > 1)
        to[2][r] = 2 * half_of_second;
    }
  }
};

// Splines, of which polynomials in doubles are made near places. Coefficients are rounded to 106 bits once.
class Local_function_source
{
  std::vector<Spline_function> m_functions;
  std::size_t m_dimension;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::vector<Double_word>> m_pieces;

public:
  Local_function_source(std::vector<Spline_function> functions, std::size_t dimension)
    : m_functions(std::move(functions)), m_dimension(dimension)
  {}

  // Those of the pieces that a box is in.
  Local_functions near(const Exact_ranges& box)
  {
    std::vector<Exact_rational> middle;
    std::vector<double> place;
    for (const auto& [lower, upper] : box) {
      middle.push_back((lower + upper) / 2);
      place.push_back(to_nearest_double(middle.back()));
    }
    std::vector<std::vector<Local_term>> functions;
    for (std::size_t i = 0; i < m_functions.size(); ++i) {
      functions.emplace_back();
      for (std::size_t t = 0; t < m_functions[i].terms().size(); ++t)
        functions.back().push_back(local_term(i, t, middle, place));
    }
    return {std::move(place), std::move(functions)};
  }

private:
  Local_term local_term(std::size_t function, std::size_t t, const std::vector<Exact_rational>& middle,
                        const std::vector<double>& place)
  {
    const Spline_term& term = m_functions[function].terms()[t];
    std::size_t piece = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j)
      piece = piece * term.cells(j) + cell_at(term.breaks[j], middle[static_cast<std::size_t>(term.variables[j])]);
    std::vector<Double_word> coefficients = rounded_piece(function, t, piece);
    for (std::size_t j = 0; j < term.variables.size(); ++j)
      shift(coefficients, term.degrees, j, Double_word(place[static_cast<std::size_t>(term.variables[j])]));
    Local_term result{term.variables, term.degrees, {}};
    for (const Double_word& coefficient : coefficients)
      result.coefficients.push_back(coefficient.nearest());
    return result;
  }

  // Substitutes x -> place + x along an axis, by repeated synthetic division.
  static void shift(std::vector<Double_word>& coefficients, const std::vector<int>& degrees, std::size_t axis,
                    const Double_word& place)
  {
    const int degree = degrees[axis];
    visit_rows(coefficients, degrees, axis, [&](Double_word* a, std::size_t step) {
      for (int r = 0; r < degree; ++r)
        for (int k = degree - 1; k >= r; --k) {
          Double_word& own = a[step * static_cast<std::size_t>(k)];
          own = own + place * a[step * static_cast<std::size_t>(k + 1)];
        }
    });
  }

  const std::vector<Double_word>& rounded_piece(std::size_t function, std::size_t term, std::size_t piece)
  {
    const auto [place, is_new] = m_pieces.try_emplace({function, term, piece});
    if (is_new)
      for (const Exact_rational& exact : m_functions[function].terms()[term].pieces[piece]) {
        const double high = to_nearest_double(exact);
        place->second.push_back(Double_word(high) +
                                Double_word(to_nearest_double(Exact_rational(exact - Exact_rational(high)))));
      }
    return place->second;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_LOCAL_FUNCTIONS_H
