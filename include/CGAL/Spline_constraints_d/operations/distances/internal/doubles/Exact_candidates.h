// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_EXACT_CANDIDATES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_EXACT_CANDIDATES_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Distance_operand.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Nearest_search.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Spline_jet.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// What is asked of an operand.
template <class NT, int d>
class Located_operand
{
  const Distance_operand<NT, d>& m_operand;

public:
  explicit Located_operand(const Distance_operand<NT, d>& operand) : m_operand(operand) {}

  int number_of_axes() const { return m_operand.spline == nullptr ? 0 : m_operand.spline->dimension(); }

  bool is_finite() const
  {
    return m_operand.spline != nullptr || std::all_of(m_operand.point.begin(), m_operand.point.end(), [](const NT& x) {
             return std::isfinite(nearest_double(x));
           });
  }

  // Calls a function with it in a form that can be searched.
  template <class Function>
  void visit_prepared(const Function& function) const
  {
    if (m_operand.spline == nullptr)
      function(Point_operand<d>(m_operand.point));
    else if (m_operand.rounded != nullptr)
      function(*m_operand.rounded);
    else
      function(Rounded_spline<d>(*m_operand.spline, &scratch_memory()));
  }

  // The parameter at a place in a cell.
  Deferred_rational parameter(int axis, int cell, const Fraction& place) const
  {
    const std::vector<NT>& knots = m_operand.spline->functions()[0].knots(axis);
    const std::size_t span = span_of_cell(knots, m_operand.spline->functions()[0].degree(axis), cell);
    if constexpr (std::is_same_v<NT, double>)
      return Deferred_rational::between(knots[span], knots[span + 1], place.numerator, place.denominator);
    else {
      const Exact_rational in_cell = Deferred_rational::between(0, 1, place.numerator, place.denominator).exact();
      return Deferred_rational(Exact_rational(knots[span] + in_cell * (knots[span + 1] - knots[span])));
    }
  }

  // At a fraction of a cell along each axis.
  template <class Field>
  Spline_jet<Field, d> jet(const std::array<int, 2>& cells, const std::array<Fraction, 2>& at) const
  {
    return m_operand.spline == nullptr ? Spline_jet<Field, d>(m_operand.point)
                                       : Spline_jet<Field, d>(*m_operand.spline, cells, at);
  }
};

/*
The answers of a `Nearest_search`, in exact numbers. Those whose parameters are ends of pieces or small fractions, by
proof, have exact points and distances, as have answers of the solver.
*/
template <class NT, int d>
class Exact_candidates
{
  using Candidate = Nearest_candidate<d>;
  using Fractions = std::array<Fraction, 2>; // of all parameters, or of those of one operand
  template <class Field>
  using Jets = std::array<Spline_jet<Field, d>, 2>;

  // An irrational number hardly ever has a smaller denominator within its range.
  static constexpr double greatest_denominator = 0x1p22;

  const std::array<Located_operand<NT, d>, 2>& m_operands;
  std::array<int, 2> m_axes;

public:
  explicit Exact_candidates(const std::array<Located_operand<NT, d>, 2>& operands)
    : m_operands(operands), m_axes{operands[0].number_of_axes(), operands[1].number_of_axes()}
  {}

  Located_distance<d> operator()(const Candidate& candidate) const
  {
    if (const std::optional<Fractions> fractions = fractions_of(candidate);
        fractions && may_be_critical(candidate, *fractions)) {
      if (const auto points = points_in_doubles(candidate, *fractions))
        return exact(candidate, *fractions, *points);
      const Jets<Exact_rational> jets = jets_of<Exact_rational>(candidate, *fractions);
      if (is_critical(candidate, jets))
        return exact(candidate, *fractions, std::array{point_of(jets[0]), point_of(jets[1])});
    }
    return enclosed(candidate);
  }

private:
  int number_of_parameters() const { return m_axes[0] + m_axes[1]; }

  std::size_t parameter_of(std::size_t operand, int axis) const
  {
    return static_cast<std::size_t>(operand == 0 ? axis : m_axes[0] + axis);
  }

  static std::array<Exact_rational, d> point_of(const Spline_jet<Exact_rational, d>& jet)
  {
    std::array<Exact_rational, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = jet.value[i] / jet.value[d];
    return result;
  }

  // The points, if intervals prove that the derivatives are zero: where no operation is rounded, these are numbers.
  std::optional<std::array<std::array<double, d>, 2>> points_in_doubles(const Candidate& candidate,
                                                                        const Fractions& fractions) const
  {
    if constexpr (std::is_same_v<NT, double>) {
      const Upward_rounding_guard rounding;
      const Jets<Interval> jets = jets_of<Interval>(candidate, fractions);
      if (!is_critical(candidate, jets))
        return std::nullopt;
      std::array<std::array<double, d>, 2> result;
      for (const std::size_t operand : {0, 1})
        for (int i = 0; i < d; ++i) {
          const Interval x = jets[operand].value[i] / jets[operand].value[d];
          if (!x.is_point())
            return std::nullopt;
          result[operand][i] = x.inf() + 0.0; // not -0
        }
      return result;
    } else
      return std::nullopt;
  }

  // Where no operation is rounded, intervals have the sum.
  static Deferred_rational squared_distance_of(const std::array<std::array<double, d>, 2>& points)
  {
    {
      const Upward_rounding_guard rounding;
      Interval square(0);
      for (int i = 0; i < d; ++i)
        square += CGAL::square(Interval(points[0][i]) - Interval(points[1][i]));
      if (square.is_point())
        return Deferred_rational(square.inf());
    }
    std::array<std::array<Exact_rational, d>, 2> exact;
    for (const std::size_t operand : {0, 1})
      for (int i = 0; i < d; ++i)
        exact[operand][i] = to_rational(points[operand][i]);
    return squared_distance_of(exact);
  }

  static Deferred_rational squared_distance_of(const std::array<std::array<Exact_rational, d>, 2>& points)
  {
    Exact_rational square(0);
    for (int i = 0; i < d; ++i) {
      const Exact_rational difference = points[0][i] - points[1][i];
      square += difference * difference;
    }
    return Deferred_rational(std::move(square));
  }

  template <class Number>
  Located_distance<d> exact(const Candidate& candidate, const Fractions& fractions,
                            const std::array<std::array<Number, d>, 2>& points) const
  {
    const Deferred_rational square = squared_distance_of(points);
    Located_distance<d> result{Solution_kind::CERTIFIED, {}, {square, square}, points, std::nullopt};
    for (const std::size_t operand : {0, 1})
      for (int axis = 0; axis < m_axes[operand]; ++axis) {
        const Deferred_rational parameter =
            m_operands[operand].parameter(axis, candidate.cells[operand][axis], fractions[parameter_of(operand, axis)]);
        result.parameters[operand].push_back({parameter, parameter, parameter});
      }
    return result;
  }

  Located_distance<d> enclosed(const Candidate& candidate) const
  {
    Located_distance<d> result{Solution_kind::CERTIFIED, {}, squared_distance_of(candidate), {}, std::nullopt};
    std::array<std::array<double, d>, 2> points;
    for (const std::size_t operand : {0, 1}) {
      for (int i = 0; i < d; ++i) {
        const Interval& x = candidate.points[operand][i];
        points[operand][i] = x.inf() / 2 + x.sup() / 2;
      }
      for (int axis = 0; axis < m_axes[operand]; ++axis) {
        const std::size_t k = parameter_of(operand, axis);
        const auto parameter = [&](double x) {
          return m_operands[operand].parameter(axis, candidate.cells[operand][axis], Fraction{x});
        };
        result.parameters[operand].push_back({parameter(candidate.ranges[k].lower),
                                              parameter(candidate.ranges[k].upper),
                                              parameter(candidate.parameters[k])});
      }
    }
    result.points = points;
    return result;
  }

  // In numbers with twice the digits of doubles at least: at the parameters that are known, it is greater or less by as
  // little as the square of their error.
  std::pair<Deferred_rational, Deferred_rational> squared_distance_of(const Candidate& candidate) const
  {
    const Fractions at{Fraction{candidate.parameters[0]}, Fraction{candidate.parameters[1]}};
    if constexpr (std::is_same_v<NT, double>) {
      const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
      const Double_word square = squared_distance_at(jets_of<Double_word>(candidate, at));
      const Interval& known = candidate.squared_distance;
      if (!(square.error_with(candidate.deviation) < (known.sup() - known.inf()) / 4))
        return {Deferred_rational(known.inf()), Deferred_rational(known.sup())};
      return square.range(candidate.deviation);
    } else {
      const Exact_rational square = squared_distance_at(jets_of<Exact_rational>(candidate, at)),
                           deviation = to_rational(candidate.deviation);
      return {Deferred_rational((std::max)(Exact_rational(square - deviation), Exact_rational(0))),
              Deferred_rational(Exact_rational(square + deviation))};
    }
  }

  template <class Field>
  static Field squared_distance_at(const Jets<Field>& jets)
  {
    Field result = field_element<Field>(0.0);
    for (int i = 0; i < d; ++i) {
      const Field difference = jets[0].value[i] / jets[0].value[d] - jets[1].value[i] / jets[1].value[d];
      result = result + difference * difference;
    }
    return result;
  }

  static double error_of(const Double_range& range) { return (range.upper - range.lower) + 4 * unit; }

  std::optional<Fractions> fractions_of(const Candidate& candidate) const
  {
    Fractions result;
    for (std::size_t k = 0; k < static_cast<std::size_t>(number_of_parameters()); ++k)
      if (candidate.sides[k] >= 0)
        result[k] = {static_cast<double>(candidate.sides[k]), 1};
      else if (const auto fraction =
                   near_fraction(candidate.parameters[k], error_of(candidate.ranges[k]), greatest_denominator))
        result[k] = *fraction;
      else
        return std::nullopt;
    return result;
  }

  template <class Field>
  Jets<Field> jets_of(const Candidate& candidate, const Fractions& fractions) const
  {
    const Fractions of_second = m_axes[0] == 0 ? fractions : Fractions{fractions[1], {}};
    return {m_operands[0].template jet<Field>(candidate.cells[0], fractions),
            m_operands[1].template jet<Field>(candidate.cells[1], of_second)};
  }

  // The same for doubles modulo a prime, which is quick.
  bool may_be_critical(const Candidate& candidate, const Fractions& fractions) const
  {
    const auto is_inside = [](int side) { return side < 0; };
    if (std::none_of(candidate.sides.begin(), candidate.sides.begin() + number_of_parameters(), is_inside))
      return true;
    if constexpr (std::is_same_v<NT, double>)
      return is_critical(candidate, jets_of<Residue>(candidate, fractions));
    else
      return true;
  }

  template <class Field>
  static bool is_zero(const Field& x)
  {
    if constexpr (std::is_same_v<Field, Interval>)
      return x.inf() == 0 && x.sup() == 0;
    else
      return x == field_element<Field>(0.0);
  }

  // Whether the derivatives by the parameters inside of pieces are zero: that of |x/w - y/v|^2 by a parameter of x/w is
  // a multiple of (x v - y w) (x' w - x w').
  template <class Field>
  bool is_critical(const Candidate& candidate, const Jets<Field>& jets) const
  {
    for (const std::size_t operand : {0, 1})
      for (int axis = 0; axis < m_axes[operand]; ++axis) {
        if (candidate.sides[parameter_of(operand, axis)] >= 0)
          continue;
        const auto &own = jets[operand].value, &slope = jets[operand].derivatives[axis];
        Field product = field_element<Field>(0.0);
        for (int i = 0; i < d; ++i)
          product = product +
              (jets[0].value[i] * jets[1].value[d] - jets[1].value[i] * jets[0].value[d]) *
                  (slope[i] * own[d] - own[i] * slope[d]);
        if (!is_zero(product))
          return false;
      }
    return true;
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_EXACT_CANDIDATES_H
