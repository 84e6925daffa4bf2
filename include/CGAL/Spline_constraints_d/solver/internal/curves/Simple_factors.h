// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_FACTORS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Regular_pair.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Separated_contact.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A spline as a product of powers in each of some cells: f = c g_1 g_2^2 ... g_m^m. Without the powers, and with constants
that make it continuous between the cells, it has the same zeros in them, none of which are singular along a whole
curve.
*/
class Factored_spline
{
  std::vector<int> m_unknowns;
  std::vector<Breaks_of_axis> m_breaks;                      // of these unknowns
  std::map<Cell, std::vector<Power_polynomial>> m_factors;   // per cell
  std::map<Cell, Power_polynomial> m_products;               // of the factors
  bool m_is_simpler = false;

public:
  // Of a function with these breaks of all unknowns, in cells which are given by their places among them. Not simpler
  // where a run ends before that is known.
  Factored_spline(const Spline_function& function, const std::vector<Breaks_of_axis>& breaks,
                  const std::vector<Cell>& cells, Run_control* control)
  {
    for (const Spline_term& term : function.terms())
      m_unknowns.insert(m_unknowns.end(), term.variables.begin(), term.variables.end());
    std::sort(m_unknowns.begin(), m_unknowns.end());
    m_unknowns.erase(std::unique(m_unknowns.begin(), m_unknowns.end()), m_unknowns.end());
    for (const int v : m_unknowns)
      m_breaks.push_back(breaks[v].size() > 2 ? breaks[v] : Breaks_of_axis());
    std::vector<Exact_rational> inside(breaks.size(), Exact_rational(0));
    for (const Cell& cell : cells) {
      Cell own;
      for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
        const int v = m_unknowns[j];
        own.push_back(m_breaks[j].empty() ? 0 : cell[v]);
        if (!m_breaks[j].empty())
          inside[v] = (m_breaks[j][own[j]] + m_breaks[j][own[j] + 1]) / 2;
      }
      if (m_factors.contains(own))
        continue;
      if (control != nullptr) {
        constexpr std::size_t boxes_of_cell = 8;
        control->charge(boxes_of_cell);
        if (control->must_stop(true))
          return;
      }
      m_factors[own] = square_free_factors(polynomial_at(function, inside));
    }
    for (const auto& [cell, factors] : m_factors) {
      Power_polynomial product(Exact_rational(1));
      for (const Power_polynomial& factor : factors)
        product *= factor;
      m_products.emplace(cell, std::move(product));
      m_is_simpler = m_is_simpler || factors.size() > 1;
    }
    m_is_simpler = m_is_simpler && make_continuous();
  }

  // Whether there are repeated factors, and the products are continuous.
  bool is_simpler() const { return m_is_simpler; }

  // The products, and 1 in all other cells, where the function has no zeros.
  Spline_function simple() const
  {
    std::vector<int> degrees(m_unknowns.size(), 0), sizes;
    for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
      sizes.push_back(m_breaks[j].empty() ? 0 : static_cast<int>(m_breaks[j].size()) - 2);
      for (const auto& [cell, product] : m_products)
        degrees[j] = (std::max)(degrees[j], product.degree(m_unknowns[j]));
    }
    Spline_term result{m_unknowns, degrees, m_breaks, {}};
    for_each_index(sizes, [&](const Cell& cell) {
      const auto place = m_products.find(cell);
      result.pieces.push_back(
          coefficients(place == m_products.end() ? Power_polynomial(Exact_rational(1)) : place->second, degrees));
    });
    return Spline_function(std::move(result));
  }

  // How often the zero of the product in a box within a cell counts; 0 if more than one factor may be zero. \pre It is
  // a regular one.
  int multiplicity(const Exact_ranges& cell, const Exact_ranges& zero) const
  {
    Cell own;
    for (std::size_t j = 0; j < m_unknowns.size(); ++j)
      own.push_back(static_cast<int>(
          cell_at(m_breaks[j], Exact_rational((cell[m_unknowns[j]].first + cell[m_unknowns[j]].second) / 2))));
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> box;
    for (const auto& [lower, upper] : zero)
      box.emplace_back(lower, upper);
    int result = 0;
    const std::vector<Power_polynomial>& factors = m_factors.at(own);
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (CGAL::certainly(factors[k].value(std::span<const Mpfr_interval>(box)).sign() != CGAL::ZERO))
        continue;
      if (result > 0)
        return 0;
      result = static_cast<int>(k) + 1;
    }
    return result;
  }

private:
  // Multiplies the products by constants; false where they have no common boundary values.
  bool make_continuous()
  {
    std::map<Cell, Exact_rational> factors;
    for (const auto& [first, product] : m_products) {
      std::vector<Cell> front;
      if (factors.try_emplace(first, Exact_rational(1)).second)
        front.push_back(first);
      while (!front.empty()) {
        const Cell cell = front.back();
        front.pop_back();
        for (std::size_t j = 0; j < cell.size(); ++j)
          for (const int step : {-1, 1}) {
            Cell next = cell;
            next[j] += step;
            if (!m_products.contains(next))
              continue;
            const std::optional<Exact_rational> ratio = ratio_between(cell, next, j);
            if (!ratio)
              return false;
            const auto [place, is_new] = factors.try_emplace(next, Exact_rational(factors[cell] * *ratio));
            if (is_new)
              front.push_back(next);
            else if (place->second != factors[cell] * *ratio)
              return false;
          }
      }
    }
    for (auto& [cell, product] : m_products)
      product *= Power_polynomial(factors[cell]);
    return true;
  }

  // Of the products of two neighbouring cells where they meet, or of their derivatives, if the products are zero there;
  // nothing if they are not multiples of each other.
  std::optional<Exact_rational> ratio_between(const Cell& cell, const Cell& next, std::size_t axis) const
  {
    const Power_polynomial value(m_breaks[axis][static_cast<std::size_t>((std::max)(cell[axis], next[axis]))]);
    const auto on_break = [&](const Power_polynomial& polynomial) {
      return polynomial.substituted(m_unknowns[axis], value);
    };
    const auto slope = [&](const Cell& which) { return on_break(m_products.at(which).derivative(m_unknowns[axis])); };
    Power_polynomial a = on_break(m_products.at(cell)), b = on_break(m_products.at(next));
    if (a.is_zero() && b.is_zero())
      std::tie(a, b) = std::pair(slope(cell), slope(next));
    if (a.is_zero() || b.is_zero())
      return std::nullopt;
    const Exact_rational ratio(a.terms().begin()->second / b.terms().begin()->second);
    return a == Power_polynomial(ratio) * b ? std::optional(ratio) : std::nullopt;
  }

  // Of the monomials up to some degrees, in row-major order.
  std::vector<Exact_rational> coefficients(const Power_polynomial& polynomial, const std::vector<int>& degrees) const
  {
    const std::vector<std::size_t> strides = tensor_strides(degrees);
    std::vector<Exact_rational> result(tensor_size(degrees), Exact_rational(0));
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      std::size_t position = 0;
      for (std::size_t j = 0; j < m_unknowns.size(); ++j)
        position += strides[j] * static_cast<std::size_t>(monomial.exponent(m_unknowns[j]));
      result[position] = coefficient;
    }
    return result;
  }
};

// The equalities, if they are two polynomials in three unknowns.
inline std::optional<std::array<Power_polynomial, 2>> two_polynomials_in_space(const Constraint_system_d& system)
{
  const std::vector<Spline_function>& equalities = system.equalities();
  const auto is_polynomial = [](const Spline_function& f) {
    return std::all_of(f.terms().begin(), f.terms().end(),
                       [](const Spline_term& term) { return term.pieces.size() == 1; });
  };
  if (system.dimension() != 3 || equalities.size() != 2 || !is_polynomial(equalities[0]) ||
      !is_polynomial(equalities[1]))
    return std::nullopt;
  const std::vector<Exact_rational> origin(3, Exact_rational(0));
  return std::array{polynomial_at(equalities[0], origin), polynomial_at(equalities[1], origin)};
}

/*
A system whose equalities have no repeated factors, with the same solutions as a given one: no curve is singular
everywhere. It knows how often a curve counts in the given one. Of two polynomials in three unknowns without repeated
factors it is that of a regular pair, or there are two systems with the solutions of which these are all.
*/
class Simple_factors
{
  std::vector<Factored_spline> m_equalities;
  std::optional<Regular_pair> m_pair;
  std::optional<Separated_contact> m_contact;
  Constraint_system_d m_system;
  std::optional<Constraint_system_d> m_other;
  bool m_is_simpler = false;

public:
  // In a run, or in none.
  explicit Simple_factors(const Constraint_system_d& system, Run_control* control = nullptr)
    : m_system(domain_of(system))
  {
    const System_layout layout(system);
    const std::vector<Breaks_of_axis> breaks = Exact_source(system, layout).breaks();
    std::vector<Cell> cells;
    Cell_pyramid(system, breaks).visit_possible_cells([&](const Cell& cell) { cells.push_back(cell); });
    for (const Spline_function& function : system.equalities()) {
      m_equalities.emplace_back(function, breaks, cells, control);
      m_is_simpler = m_is_simpler || m_equalities.back().is_simpler();
      m_system.add(m_equalities.back().is_simpler() ? m_equalities.back().simple() : function, Relation::EQUAL);
    }
    if (!m_is_simpler)
      use_regular_pair(system);
    for (const auto& [function, relation] : system.inequalities())
      m_system.add(function, relation);
  }

  // Whether an equality has repeated factors that were found, or a regular pair was.
  bool is_simpler() const { return m_is_simpler; }

  const Constraint_system_d& system() const { return m_system; }

  // With the other solutions, if there are two systems.
  const std::optional<Constraint_system_d>& other_system() const { return m_other; }

  // How often the curve through a vertex counts, which is a regular solution of the other system; 0 if this is not
  // known.
  int multiplicity_in_other(const Exact_ranges& vertex) const { return m_contact->multiplicity(1, vertex); }

  // How often the curve through a vertex counts, which is a regular solution of the system and lies in a box of one
  // cell; 0 if this is not known.
  int multiplicity(const Exact_ranges& box, const Exact_ranges& vertex) const
  {
    if (m_pair)
      return m_pair->multiplicity(vertex);
    if (m_contact)
      return m_contact->multiplicity(0, vertex);
    int result = 1;
    for (const Factored_spline& equality : m_equalities)
      if (equality.is_simpler())
        result *= equality.multiplicity(box, vertex);
    return result;
  }

private:
  void use_regular_pair(const Constraint_system_d& system)
  {
    const auto polynomials = two_polynomials_in_space(system);
    if (polynomials)
      m_pair = Regular_pair::make(*polynomials);
    if (polynomials && !m_pair && system.inequalities().empty() && seem_to_touch_along_curves(*polynomials))
      m_contact = Separated_contact::make(*polynomials);
    if (!m_pair && !m_contact)
      return;
    m_is_simpler = true;
    m_system = system_of(system, m_pair ? m_pair->polynomials() : m_contact->pairs()[0]);
    if (m_contact)
      m_other = system_of(system, m_contact->pairs()[1]);
  }

  static Constraint_system_d system_of(const Constraint_system_d& given, const std::array<Power_polynomial, 2>& pair)
  {
    Constraint_system_d result(domain_of(given));
    for (const Power_polynomial& polynomial : pair)
      result.add(polynomial, Relation::EQUAL);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_FACTORS_H
