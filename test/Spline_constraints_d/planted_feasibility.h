// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random constraints of which it is known whether they can be satisfied, and checks of answers about them.
#ifndef PLANTED_FEASIBILITY_H
#define PLANTED_FEASIBILITY_H

#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace planted_feasibility {

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using Polynomial = SC::Power_polynomial;
using Conditions = std::vector<std::pair<Polynomial, SC::Relation>>;

struct Problem
{
  std::vector<SC::Constraint_system_d::Domain> domain;
  Conditions conditions;
  bool is_feasible;
};

class Generator
{
  std::mt19937 m_random;

public:
  explicit Generator(unsigned seed) : m_random(seed) {}

  int integer(int lower, int upper) { return lower + static_cast<int>(m_random() % (upper - lower + 1)); }
  Number fraction(int reach) { return Number(integer(-reach * 16, reach * 16)) / Number(16); }

  // With terms of all degrees up to the given one, in the unknowns before `dimension`.
  Polynomial polynomial(int dimension, int degree, int terms)
  {
    Polynomial result;
    for (int k = 0; k < terms; ++k) {
      Polynomial term(fraction(2));
      for (int d = integer(1, degree); d > 0; --d)
        term *= Polynomial::variable(integer(0, dimension - 1));
      result += term;
    }
    return result;
  }

  // The inside of a ball around a point satisfies all inequalities, and the point all equalities.
  Problem with_solutions(int dimension, int inequalities, int equalities, int degree)
  {
    Problem result{{}, {}, true};
    std::vector<Number> centre;
    for (int j = 0; j < dimension; ++j) {
      centre.push_back(fraction(1));
      result.domain.emplace_back(-2, 2);
    }
    const Number radius = Number(integer(1, 16)) / Number(64);
    for (int k = 0; k < inequalities + equalities; ++k) {
      Polynomial function = polynomial(dimension, degree, 2 * dimension + 1);
      Polynomial around = function;
      for (int j = 0; j < dimension; ++j)
        around = around.substituted(j, Polynomial::variable(j) + Polynomial(centre[j]));
      Number largest = around.constant_term();
      if (k < inequalities)
        for (const auto& [monomial, coefficient] : around.terms())
          if (!monomial.powers.empty()) {
            Number size = CGAL::abs(coefficient);
            for (int d = monomial.total_degree(); d > 0; --d)
              size *= radius;
            largest += size;
          }
      function -= Polynomial(largest);
      add(result, std::move(function), k < inequalities);
    }
    return result;
  }

  // The sum of positive multiples of all functions is a positive number plus squares.
  Problem without_solutions(int dimension, int inequalities, int equalities, int degree)
  {
    Problem result{{}, {}, false};
    for (int j = 0; j < dimension; ++j)
      result.domain.emplace_back(-2, 2);
    Polynomial sum(Number(Number(1) / Number(integer(1, 64))));
    for (int k = 0; k < 2; ++k) {
      const Polynomial root = polynomial(dimension, (std::max)(1, degree / 2), dimension) + Polynomial(fraction(1));
      sum += root * root;
    }
    for (int k = 0; k < inequalities + equalities - 1; ++k) {
      Polynomial function = polynomial(dimension, degree, 2 * dimension + 1) + Polynomial(fraction(1));
      sum -= Polynomial(Number(Number(integer(1, 8)) / Number(4))) * function;
      add(result, std::move(function), k < inequalities - 1);
    }
    add(result, std::move(sum), true);
    return result;
  }

  // Two balls with a rational common point, all of it if they are closed.
  Problem touching_balls(int dimension, bool is_closed)
  {
    Problem result{{}, {}, is_closed};
    std::vector<Number> direction; // a rational point of the unit sphere, by stereographic projection
    Number size(0);
    for (int j = 1; j < dimension; ++j) {
      direction.push_back(fraction(1));
      size += direction.back() * direction.back();
    }
    for (Number& x : direction)
      x *= Number(2) / (size + Number(1));
    direction.push_back(Number((size - Number(1)) / (size + Number(1))));
    std::vector<Number> centre;
    for (int j = 0; j < dimension; ++j) {
      centre.push_back(fraction(1));
      result.domain.emplace_back(-8, 8);
    }
    const Number first = Number(integer(1, 16)) / Number(8), second = Number(integer(1, 16)) / Number(8);
    for (const auto& [radius, distance] : {std::pair(first, Number(0)), std::pair(second, Number(first + second))}) {
      Polynomial ball(Number(-radius * radius));
      for (int j = 0; j < dimension; ++j) {
        const Polynomial difference = Polynomial::variable(j) - Polynomial(Number(centre[j] + distance * direction[j]));
        ball += difference * difference;
      }
      result.conditions.emplace_back(std::move(ball), is_closed ? SC::Relation::LESS_EQUAL : SC::Relation::LESS);
    }
    return result;
  }

private:
  // With all relations.
  void add(Problem& problem, Polynomial function, bool is_inequality)
  {
    if (!is_inequality)
      problem.conditions.emplace_back(std::move(function), SC::Relation::EQUAL);
    else if (integer(0, 1) == 0)
      problem.conditions.emplace_back(std::move(function),
                                      integer(0, 1) == 0 ? SC::Relation::LESS_EQUAL : SC::Relation::LESS);
    else
      problem.conditions.emplace_back(-std::move(function),
                                      integer(0, 1) == 0 ? SC::Relation::GREATER_EQUAL : SC::Relation::GREATER);
  }
};

// How far a polynomial may be on a box from its value in the middle.
inline std::pair<Number, Number> range_of(Polynomial function, const SC::Feasibility_d::Box& box)
{
  for (std::size_t j = 0; j < box.size(); ++j)
    function = function.substituted(static_cast<int>(j),
                                    Polynomial::variable(static_cast<int>(j)) +
                                        Polynomial(Number((box[j].first + box[j].second) / Number(2))));
  Number reach(0);
  for (const auto& [monomial, coefficient] : function.terms())
    if (!monomial.powers.empty()) {
      Number size = CGAL::abs(coefficient);
      for (const auto& [unknown, exponent] : monomial.powers)
        for (int k = 0; k < exponent; ++k)
          size *= (box[unknown].second - box[unknown].first) / Number(2);
      reach += size;
    }
  return {Number(function.constant_term() - reach), Number(function.constant_term() + reach)};
}

// What is wrong with an answer that says that it is feasible; empty: nothing.
inline std::string error_of_solution(const Problem& problem, const SC::Feasibility_d& answer)
{
  for (std::size_t j = 0; j < problem.domain.size(); ++j)
    if (answer.box()[j].first < problem.domain[j].first || problem.domain[j].second < answer.box()[j].second)
      return "the box leaves the domain";
  for (std::size_t i = 0; i < problem.conditions.size(); ++i) {
    const auto& [function, relation] = problem.conditions[i];
    const auto [lower, upper] = range_of(function, answer.box());
    const bool is_right = lower == upper || relation != SC::Relation::EQUAL
        ? is_satisfied(relation, CGAL::sign(lower)) && is_satisfied(relation, CGAL::sign(upper))
        : lower <= 0 && 0 <= upper;
    if (!is_right)
      return "constraint " + std::to_string(i) + " does not hold";
  }
  return {};
}

// What is wrong with a proof, at points of the domain; empty: nothing.
inline std::string error_of_proof(const Problem& problem, const SC::Feasibility_d& answer, Generator& generator)
{
  for (int k = 0; k < 20; ++k) {
    std::vector<Number> point;
    for (const auto& [lower, upper] : problem.domain)
      point.push_back(Number(lower + (upper - lower) * Number(generator.integer(0, 997)) / Number(997)));
    bool is_covered = false;
    for (const auto& part : answer.excluded()) {
      bool is_inside = true;
      for (std::size_t j = 0; j < point.size(); ++j)
        is_inside = is_inside && Number(part.place[j].first) <= point[j] && point[j] <= Number(part.place[j].second);
      if (!is_inside)
        continue;
      is_covered = true;
      Number sum(0);
      bool is_strict = part.multipliers.empty();
      for (std::size_t i = 0; i < part.multipliers.size(); ++i) {
        const auto& [function, relation] = problem.conditions[i];
        const bool is_upper = relation == SC::Relation::GREATER || relation == SC::Relation::GREATER_EQUAL;
        if (relation != SC::Relation::EQUAL && part.multipliers[i] < 0)
          return "a negative multiplier";
        sum += part.multipliers[i] * (is_upper ? Number(-function(point)) : function(point));
        is_strict = is_strict ||
            (part.multipliers[i] > 0 && (relation == SC::Relation::LESS || relation == SC::Relation::GREATER));
      }
      if (sum < 0 || (sum == 0 && !is_strict))
        return "a combination that is not positive";
    }
    if (!is_covered)
      return "a point of the domain in no excluded part";
  }
  return {};
}

} // namespace planted_feasibility

#endif // PLANTED_FEASIBILITY_H
