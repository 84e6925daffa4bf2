// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PRECONDITIONED_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PRECONDITIONED_SYSTEM_H

#include <CGAL/Spline_constraints_d/solver/internal/certification/Piecewise_certification.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The equalities multiplied by a matrix C in exact arithmetic. Where the rows of the Jacobian nearly coincide, as between
two solutions of which a sheared coordinate differs in the ninth digit, a solution depends on what is left after almost
everything cancels: far too little for rows that were rounded first. C f is formed from the integer coefficients and
rounded afterwards; its Jacobian is close to the identity and doubles decide it as if the system had been well
conditioned from the start.

A root of f is a root of C f whatever C is, and the other way round when some C' C J is close to the identity. Costs an
exact rebuild per test. Only for as many equalities as unknowns.
*/
template <class NT>
class Preconditioned_system
{
  using Coordinate = typename Number_traits<NT>::Coordinate;

  // Made when it is needed for the first time.
  struct Parts
  {
    System_layout layout;
    Exact_source source;
    Node_analysis<NT> analysis;
    Piecewise_certification<NT> piecewise;
    Box_node<NT> node;

    Parts(const Constraint_system_d& system, const System_layout& original, const Exact_source& original_source,
          Summary& summary)
      : layout(System_layout::of_mixed_equalities(original)), source(system, layout, original_source.breaks()),
        analysis(layout, source, summary, true), piecewise(layout, source)
    {
      node.allocate(layout);
    }
  };

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  const Exact_source& m_source;
  Summary& m_summary;
  std::unique_ptr<Parts> m_parts;

public:
  Preconditioned_system(const Constraint_system_d& system, const System_layout& layout, const Exact_source& source,
                        Summary& summary)
    : m_system(system), m_layout(layout), m_source(source), m_summary(summary)
  {}

  bool is_applicable() const { return m_layout.equalities == m_layout.dimension; }

  // What the last test left.
  Node_analysis<NT>& analysis() { return m_parts->analysis; }
  Box_node<NT>& node() { return m_parts->node; }

  // Applies the Newton operator to the box of a node, whose linear rows tell C. C is corrected while rounding is still
  // visible: the rows that were too close to be told apart in double are, once their common part is gone.
  Image_test test_image(const Cell& cell, const Box_node<NT>& node, const Linear_enclosure& linear)
  {
    constexpr int most_corrections = 3;
    Parts& parts = make_parts();
    parts.node.lower = node.lower;
    parts.node.upper = node.upper;
    parts.source.set_matrix({});
    Image_test result{Image_test::OPEN, HUGE_VAL, HUGE_VAL};
    const double* matrix = linear.matrix();
    std::vector<long> scale(node.scale.begin(), node.scale.begin() + m_layout.equalities);
    for (int i = 0; i < most_corrections && parts.source.multiply(matrix, scale); ++i) {
      parts.analysis.rebuild(cell, parts.node);
      result = parts.analysis.test_image(parts.node);
      if (result.verdict != Image_test::OPEN || !parts.analysis.is_blurred(parts.node))
        break;
      matrix = parts.analysis.linear.matrix();
      scale = parts.node.scale;
    }
    return result;
  }

  // Decides a box that reaches over breaks, and was left open by a region's inverse.
  typename Piecewise_certification<NT>::Verdict certify(Certified_region<Coordinate>& region)
  {
    Parts& parts = make_parts();
    parts.source.set_matrix({});
    const std::vector<long> scale(region.scale.begin(), region.scale.begin() + m_layout.equalities);
    return parts.source.multiply(region.inverse.data(), scale) ? parts.piecewise.certify(region)
                                                               : Piecewise_certification<NT>::OPEN;
  }

private:
  Parts& make_parts()
  {
    if (m_parts == nullptr)
      m_parts = std::make_unique<Parts>(m_system, m_layout, m_source, m_summary);
    return *m_parts;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_PRECONDITIONED_SYSTEM_H
