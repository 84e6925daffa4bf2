// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_HYPERSURFACE_COVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_HYPERSURFACE_COVER_H

#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Boxes that cover the zeros of one polynomial h that satisfy some inequalities. A box is

- regular, when a derivative of h has no zero in it, so that the zeros are part of the graph of a function of the other
  unknowns, and h has both signs at its corners: the zeros
  separate these, so their dimension is one less than that of the box; all of the box satisfies the inequalities;
- or small, and nothing else is known of it: where h is singular or touches zero, or on the boundary of an inequality.

The size of regular boxes follows from the polynomial alone. Where h is zero everywhere, all boxes are regular that
satisfy the inequalities.
*/
class Hypersurface_cover
{
  const Exact_box m_box;
  Constraint_system_d m_system;   // on the unit cube
  System_layout m_layout;
  Exact_source m_source;
  Node_view m_view;
  Power_polynomial m_polynomial;
  std::vector<double> m_coefficients, m_errors;
  std::vector<long> m_scale;
  double m_least_width;
  std::size_t m_nodes = 0;
  std::vector<Exact_box> m_regular, m_small;
  static constexpr std::size_t m_most_nodes = 20000;

public:
  Hypersurface_cover(const Power_polynomial& h, const std::vector<std::pair<Power_polynomial, Relation>>& inequalities,
                     const Exact_box& box)
    : m_box(box), m_system(on_unit_cube(h, inequalities, box)), m_layout(m_system), m_source(m_system, m_layout),
      m_view(m_layout), m_polynomial(on_unit_cube(h, box)), m_coefficients(m_layout.size), m_errors(m_layout.errors),
      m_least_width(box.size() == 2 && !h.is_zero() ? 0x1p-20 : 0x1p-7)
  {
    const std::vector<double> lower(box.size(), 0.0), upper(box.size(), 1.0);
    visit(lower, upper);
  }

  const std::vector<Exact_box>& regular_boxes() const { return m_regular; }
  const std::vector<Exact_box>& small_boxes() const { return m_small; }
  std::size_t nodes() const { return m_nodes; }

private:
  static Power_polynomial on_unit_cube(Power_polynomial f, const Exact_box& box)
  {
    for (std::size_t j = 0; j < box.size(); ++j) {
      const int v = static_cast<int>(j);
      f = f.substituted(v,
                        Power_polynomial(box[j].first) +
                            Power_polynomial(Exact_rational(box[j].second - box[j].first)) *
                                Power_polynomial::variable(v));
    }
    return f;
  }

  static Constraint_system_d on_unit_cube(const Power_polynomial& h,
                                          const std::vector<std::pair<Power_polynomial, Relation>>& inequalities,
                                          const Exact_box& box)
  {
    Constraint_system_d result(
        std::vector<Constraint_system_d::Domain>(box.size(), {Exact_rational(0), Exact_rational(1)}));
    result.add(on_unit_cube(h, box), Relation::EQUAL);
    for (const auto& [function, relation] : inequalities)
      result.add(on_unit_cube(function, box), relation);
    return result;
  }

  void visit(const std::vector<double>& lower, const std::vector<double>& upper)
  {
    ++m_nodes;
    m_source.bernstein_coefficients(Cell(lower.size(), 0), std::span<const double>(lower),
                                    std::span<const double>(upper), m_coefficients.data(), m_errors.data(), m_scale);
    m_view.reset(m_coefficients.data(), m_errors.data());
    if (is_certainly_violated(Relation::EQUAL, m_view.lower(0), m_view.upper(0)))
      return;
    bool is_feasible = true;
    for (std::size_t g = 0; g < m_system.inequalities().size(); ++g) {
      const Relation relation = m_system.inequalities()[g].relation;
      const int f = static_cast<int>(g) + 1;
      if (is_certainly_violated(relation, m_view.lower(f), m_view.upper(f)))
        return;
      is_feasible = is_feasible && is_certainly_satisfied(relation, m_view.lower(f), m_view.upper(f));
    }
    const std::size_t axis = widest_axis(lower, upper);
    const bool is_last = upper[axis] - lower[axis] <= m_least_width || m_nodes >= m_most_nodes;
    const bool is_regular =
        is_feasible && (m_polynomial.is_zero() || ((is_graph() || is_last) && has_both_signs(lower, upper)));
    if (is_regular || is_last) {
      (is_regular ? m_regular : m_small).push_back(box_of(lower, upper));
      return;
    }
    std::vector<double> middle_lower(lower), middle_upper(upper);
    middle_lower[axis] = middle_upper[axis] = 0.5 * (lower[axis] + upper[axis]);
    visit(lower, middle_upper);
    visit(middle_lower, upper);
  }

  bool is_graph()
  {
    const double *lower = m_view.derivative_lower(0), *upper = m_view.derivative_upper(0);
    for (int j = 0; j < m_layout.dimension; ++j)
      if (lower[j] > 0 || upper[j] < 0)
        return true;
    return false;
  }

  bool has_both_signs(const std::vector<double>& lower, const std::vector<double>& upper) const
  {
    bool is_positive = false, is_negative = false;
    std::vector<Exact_rational> corner(lower.size());
    for (std::size_t bits = 0; bits >> lower.size() == 0 && !(is_positive && is_negative); ++bits) {
      for (std::size_t j = 0; j < lower.size(); ++j)
        corner[j] = Exact_rational((bits >> j & 1) != 0 ? upper[j] : lower[j]);
      const CGAL::Sign sign = CGAL::sign(m_polynomial(corner));
      is_positive = is_positive || sign == CGAL::POSITIVE;
      is_negative = is_negative || sign == CGAL::NEGATIVE;
    }
    return is_positive && is_negative;
  }

  static std::size_t widest_axis(const std::vector<double>& lower, const std::vector<double>& upper)
  {
    std::size_t widest = 0;
    for (std::size_t j = 1; j < lower.size(); ++j)
      if (upper[j] - lower[j] > upper[widest] - lower[widest])
        widest = j;
    return widest;
  }

  Exact_box box_of(const std::vector<double>& lower, const std::vector<double>& upper) const
  {
    Exact_box result;
    for (std::size_t j = 0; j < lower.size(); ++j) {
      const Exact_rational width = m_box[j].second - m_box[j].first;
      result.emplace_back(m_box[j].first + width * Exact_rational(lower[j]),
                          m_box[j].first + width * Exact_rational(upper[j]));
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_HYPERSURFACE_COVER_H
