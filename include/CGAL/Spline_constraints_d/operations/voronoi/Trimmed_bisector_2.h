// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

A trimmed bisector: all points that have the same distance from two curves or points, or the same least distance from
two points of one curve.

It is a part of a Voronoi diagram: those of its edges that have one of the two on each side, joined to chains. What is
not decided is not decided in the diagram either; then `is_complete()` is false, and chains end there.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Trimmed_bisector_2
{
public:
  using Diagram = Voronoi_diagram_of_curves_2<Kernel>;
  using Sample = Voronoi_sample_2<Kernel>;

  using Chain = Trimmed_bisector_chain_2;
  using Arc = Chain::Arc;

private:
  Diagram m_diagram;
  std::vector<Chain> m_chains;

public:
  //! a bisector without chains. Others are made by `trimmed_bisector()` and `trimmed_self_bisector()`.
  Trimmed_bisector_2() = default;

  //! a bisector that an operation has found.
  explicit Trimmed_bisector_2(internal::Voronoi::Bisecting_chains chains)
    : m_diagram(std::move(chains.diagram)), m_chains(std::move(chains.chains))
  {}

  //! the Voronoi diagram that the bisector is a part of. Its curves are numbered in the order in which they were given;
  //! in what is undecided, so are operands.
  const Diagram& diagram() const { return m_diagram; }

  //! the chains of the bisector.
  const std::vector<Chain>& chains() const { return m_chains; }

  //! whether all of the diagram is proved, and so all of the bisector.
  bool is_complete() const { return m_diagram.is_complete(); }

  //! the parts of the operands, 0 and 1, beside which the diagram is not decided.
  const std::vector<Undecided_part>& undecided() const { return m_diagram.undecided(); }

  //! the work.
  const Summary& summary() const { return m_diagram.summary(); }

  /*!
  points along a chain, so many that it passes the middles of their chords at no more than a given distance; in several
  polylines, where the chain is too far away between them. The parameters of a point are those of the first curve, on
  the right, and of the second one, on the left.

  \param chain the chain.
  \param error the distance; positive.
  \param most_radius the chain is cut where its distance from the curves is larger; positive and finite.
  \throws Invalid_input when the error is not positive, or the radius is not positive or not finite.
  */
  std::vector<std::vector<Sample>> polylines(const Chain& chain, double error, double most_radius) const
  {
    if (!(most_radius > 0 && std::isfinite(most_radius)))
      throw Invalid_input("Trimmed_bisector_2: the radius must be positive and finite");
    std::vector<std::vector<Sample>> result;
    bool goes_on = false;
    for (const Arc& arc : chain.arcs) {
      const std::vector<Sample> samples = polyline(arc, error, most_radius);
      if (!goes_on && !samples.empty())
        result.emplace_back();
      if (!samples.empty())
        // the first one ends the arc before
        result.back().insert(result.back().end(), samples.begin() + goes_on, samples.end());
      const std::optional<double>& radius = m_diagram.vertices()[vertex(arc, 1)].radius;
      goes_on = radius && *radius <= most_radius;
    }
    return result;
  }

private:
  std::size_t vertex(const Arc& arc, std::size_t end) const
  {
    return m_diagram.edges()[arc.edge].vertices[arc.is_reversed ? 1 - end : end];
  }

  std::vector<Sample> polyline(const Arc& arc, double error, double most_radius) const
  {
    std::vector<Sample> result = m_diagram.polyline(arc.edge, error, most_radius);
    if (arc.is_reversed) {
      std::reverse(result.begin(), result.end());
      for (Sample& sample : result)
        std::swap(sample.parameters[0], sample.parameters[1]);
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H
