// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>

#include <algorithm>
#include <array>
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

  //! an edge of the diagram, as a part of a chain.
  struct Arc
  {
    std::size_t edge;    ///< its index
    bool is_reversed;    ///< whether the chain runs along it from its end to its begin
  };

  //! edges that go on in each other. Chains end where the edges of the bisector at a vertex are not two, at infinity,
  //! and in vertices that are not resolved.
  struct Chain
  {
    std::vector<Arc> arcs;                   ///< in order, with the first curve on the right
    std::array<std::size_t, 2> vertices;     ///< of the diagram, where the chain begins and ends
    bool is_closed;                          ///< whether it ends where it begins, and goes on there
  };

private:
  Diagram m_diagram;
  std::vector<Chain> m_chains;

public:
#ifndef DOXYGEN_RUNNING
  // Each site belongs to the first curve (-1), the second one (1), or to both (0). Edges between sites of the same
  // number are left out; without numbers, none are.
  Trimmed_bisector_2(Diagram diagram, const std::vector<int>& sides) : m_diagram(std::move(diagram))
  {
    std::vector<int> directions;   // of the edges: negative if the first curve is on the left, 0 if they are left out
    for (const auto& edge : m_diagram.edges())
      directions.push_back(sides.empty() ? 1 : sides[edge.sites[1]] - sides[edge.sites[0]]);
    make_chains(directions);
  }
#endif

  //! the Voronoi diagram that the bisector is a part of; its curves are numbered in the order in which they were given.
  const Diagram& diagram() const { return m_diagram; }

  //! the chains of the bisector.
  const std::vector<Chain>& chains() const { return m_chains; }

  //! whether all of the diagram is proved, and so all of the bisector.
  bool is_complete() const { return m_diagram.is_complete(); }

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
      goes_on = m_diagram.vertices()[vertex(arc, 1)].radius <= most_radius;
    }
    return result;
  }

private:
  using End = internal::Intersections::Curve_end;

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

  void make_chains(const std::vector<int>& directions)
  {
    std::vector<std::size_t> kept;
    std::vector<std::vector<End>> ends_at(m_diagram.vertices().size());
    for (std::size_t e = 0; e < directions.size(); ++e)
      if (directions[e] != 0) {
        for (const int side : {0, 1})
          ends_at[m_diagram.edges()[e].vertices[static_cast<std::size_t>(side)]].push_back({kept.size(), side});
        kept.push_back(e);
      }
    const auto next = [&](const End& end) -> std::optional<End> {
      const std::size_t v = m_diagram.edges()[kept[end.curve]].vertices[static_cast<std::size_t>(end.side)];
      if (ends_at[v].size() != 2 || m_diagram.vertices()[v].is_at_infinity || !m_diagram.vertices()[v].is_resolved)
        return std::nullopt;
      return ends_at[v][ends_at[v][0] == end];
    };
    for (const Intersection_curve& joined :
         internal::Intersections::chains_of_curves(std::vector<bool>(kept.size(), false), next)) {
      Chain chain{{}, {}, joined.is_closed};
      for (const Intersection_arc& arc : joined.arcs)
        chain.arcs.push_back({kept[arc.index], arc.is_reversed});
      // then all arcs have the first curve on the left
      if ((directions[chain.arcs[0].edge] < 0) != chain.arcs[0].is_reversed)
        reverse(chain.arcs);
      chain.vertices = {vertex(chain.arcs.front(), 0), vertex(chain.arcs.back(), 1)};
      m_chains.push_back(std::move(chain));
    }
  }

  static void reverse(std::vector<Arc>& arcs)
  {
    std::reverse(arcs.begin(), arcs.end());
    for (Arc& arc : arcs)
      arc.is_reversed = !arc.is_reversed;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTOR_2_H
