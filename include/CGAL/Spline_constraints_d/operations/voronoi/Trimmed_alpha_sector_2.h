// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Undecided_part_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Sector_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/arcs_of_chain.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

A trimmed \f$\alpha\f$-sector: all points whose distances from two curves or points, each from the nearest of its
points, have the ratio \f$\alpha : 1 - \alpha\f$.

It consists of closed curves, chains of arcs: on each, the nearest points are on the same piece of each curve, or the
same end or corner. Arcs are connected by proof, and where something is not decided, `is_complete()` is false, and
`undecided()` tells where that is; chains that are affected are not closed.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Trimmed_alpha_sector_2
{
public:
  using Point = typename Kernel::Point_2;

  //! an arc of the sector.
  struct Arc
  {
    /// for each operand, whether the nearest point is an end or a corner, or the operand itself
    std::array<bool, 2> is_point;
    /// of each operand, where the nearest points are at the begin and at the end of the arc; of points, no numbers
    std::array<std::array<double, 2>, 2> parameters;
  };

  //! arcs that go on in each other.
  struct Chain
  {
    std::vector<std::size_t> arcs;   ///< in order, with the first operand on the right
    bool is_closed;                  ///< whether it is proved to be closed
  };

  //! a point of the sector.
  struct Sample
  {
    Point point;                         ///< the point, rounded
    std::array<double, 2> distances;     ///< from both operands
    std::array<double, 2> parameters;    ///< of the nearest points; of points, no numbers
  };

private:
  internal::Voronoi::Sector_disks m_disks;
  bool m_is_exchanged;                                                      // the nearer operand is the second one
  double m_factor;                                                          // of the distances
  std::vector<Arc> m_arcs;
  // one; or several, where the normals of a vertex come in several normal cones
  std::vector<std::vector<internal::Voronoi::Sector_disks::Arc>> m_parts_of_arc;
  std::vector<Chain> m_chains;
  std::vector<Undecided_part_2> m_undecided;

public:
#ifndef DOXYGEN_RUNNING
  // Where the nearer operand is a point, there is one curve at most.
  Trimmed_alpha_sector_2(internal::Voronoi::Sector_disks disks, double factor, bool is_exchanged, bool is_nearer_point)
    : m_disks(std::move(disks)), m_is_exchanged(is_exchanged), m_factor(factor)
  {
    const Upward_rounding_guard guard;
    for (const auto& [curve, from, to] : m_disks.undecided()) {
      const bool is_of_farther = curve == (is_nearer_point ? 0 : 1);
      m_undecided.push_back({is_of_farther != is_exchanged ? std::size_t{1} : std::size_t{0}, from, to});
    }
    for (const internal::Voronoi::Free_chains::Chain& chain : m_disks.chains())
      append_chain(chain);
  }
#endif

  //! the arcs.
  const std::vector<Arc>& arcs() const { return m_arcs; }

  //! the chains; each arc belongs to one.
  const std::vector<Chain>& chains() const { return m_chains; }

  //! whether all of the sector is proved.
  bool is_complete() const { return m_undecided.empty(); }

  //! the parts of operands, whose indices are 0 and 1, beside which the sector is not proved: it is not known whether
  //! their points are nearest to points of the sector, or which chain goes on there. Of an operand that is a point,
  //! both numbers are 0. If curves are not proved to be disjoint elsewhere, all of each curve.
  const std::vector<Undecided_part_2>& undecided() const { return m_undecided; }

  /*!
  points along an arc, so many that it passes the middles of their chords at no more than a given distance.

  \param arc the index of the arc.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t arc, double error) const
  {
    internal::check_error(error, "Trimmed_alpha_sector_2");
    const Upward_rounding_guard guard;
    using Located = std::pair<double, Sample>;
    std::vector<Sample> result;
    for (const Part& part : m_parts_of_arc[arc]) {
      const auto located = [&](double u) { return Located(u, sample(part, u)); };
      const auto between = [&](const Located& from, const Located& to) {
        return located(from.first / 2 + to.first / 2);
      };
      const auto is_chord = [&](const Located& from, const Located& middle, const Located& to) {
        return internal::distance_from_middle(coordinates(from.second), coordinates(middle.second),
                                              coordinates(to.second)) <= error;
      };
      std::vector<Located> along{located(part.begin)};
      internal::Common::append_samples(along, located(part.end), between, is_chord);
      for (std::size_t i = result.empty() ? 0 : 1; i < along.size(); ++i)   // parts share their ends
        result.push_back(along[i].second);
    }
    return result;
  }

private:
  using Part = internal::Voronoi::Sector_disks::Arc;

  static double middle(const internal::Common::Interval& x) { return x.inf() / 2 + x.sup() / 2; }

  static std::array<double, 2> coordinates(const Sample& sample)
  {
    return {CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y())};
  }

  // Of an arc of the graph, or, of vertices, no number.
  double curve_parameter(bool is_point, std::size_t arc, double u) const
  {
    return is_point ? std::numeric_limits<double>::quiet_NaN() : m_disks.graph().curve_parameter(arc, u);
  }

  // In the order of the operands.
  template <class T>
  std::array<T, 2> in_order(const T& nearer, const T& farther) const
  {
    return m_is_exchanged ? std::array<T, 2>{farther, nearer} : std::array<T, 2>{nearer, farther};
  }

  Sample sample(const Part& part, double u) const
  {
    const internal::Voronoi::Oriented_element<>& element = m_disks.element(part);
    const internal::Voronoi::Sector_disks::Disk disk = m_disks.disk(part, u);
    const double radius = middle(disk.radius);
    const bool is_vertex = part.footpoint.kind == internal::Voronoi::Disk_footpoint::Kind::VERTEX;
    return {
        internal::kernel_object<Kernel, Point>(std::array<double, 2>{middle(disk.center[0]), middle(disk.center[1])}),
        in_order(radius, m_factor * radius),
        in_order(curve_parameter(element.is_normal_cone, element.object, u),
                 curve_parameter(is_vertex, part.footpoint.index, disk.parameter))};
  }

  Arc arc_of(const std::vector<Part>& parts) const
  {
    const Part& first = parts.front();
    const std::array<double, 2> begin = sample(first, first.begin).parameters,
                                end = sample(parts.back(), parts.back().end).parameters;
    return {in_order(m_disks.element(first).is_normal_cone,
                     first.footpoint.kind == internal::Voronoi::Disk_footpoint::Kind::VERTEX),
            {{{begin[0], end[0]}, {begin[1], end[1]}}}};
  }

  // Whether the nearest points go on in the next normal cone of the same vertex.
  bool goes_on(const Part& before, const Part& after) const
  {
    const internal::Voronoi::Oriented_element<> &a = m_disks.element(before), &b = m_disks.element(after);
    return before.element != after.element && a.is_normal_cone && b.is_normal_cone && a.object == b.object &&
        before.footpoint == after.footpoint;
  }

  void append_chain(const internal::Voronoi::Free_chains::Chain& chain)
  {
    std::vector<Part> parts_of_chain;
    for (const std::size_t piece : chain.pieces) {
      const std::vector<Part> parts = m_disks.arcs(piece);
      parts_of_chain.insert(parts_of_chain.end(), parts.begin(), parts.end());
    }
    std::vector<std::vector<Part>> arcs = internal::Voronoi::arcs_of_chain(
        parts_of_chain, chain.is_closed, [&](const Part& before, const Part& after) { return goes_on(before, after); });
    if (m_is_exchanged)
      reverse(arcs);
    Chain result{{}, chain.is_closed};
    for (std::vector<Part>& parts : arcs) {
      result.arcs.push_back(m_arcs.size());
      m_arcs.push_back(arc_of(parts));
      m_parts_of_arc.push_back(std::move(parts));
    }
    m_chains.push_back(std::move(result));
  }

  static void reverse(std::vector<std::vector<Part>>& arcs)
  {
    std::reverse(arcs.begin(), arcs.end());
    for (std::vector<Part>& parts : arcs) {
      std::reverse(parts.begin(), parts.end());
      for (Part& part : parts)
        std::swap(part.begin, part.end);
    }
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTOR_2_H
