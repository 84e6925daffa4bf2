// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Seam_joints.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_cuts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// A point of the plane in the stereographic projection to a sphere that lies on the origin: far points are close to
// each other there, and to the north pole, which is infinity.
inline std::array<double, 3> on_sphere(const Double_pair& point, double radius)
{
  const double x = point[0] / (2 * radius), y = point[1] / (2 * radius), share = 1 / (1 + x * x + y * y);
  if (!(share > 0))
    return {0, 0, 2 * radius};
  return {2 * radius * x * share, 2 * radius * y * share, 2 * radius * (1 - share)};
}

} // namespace Loci
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDLoci

Curves in the plane whose points belong to one point on each of two curves, or to two of one curve: their bisector, for
example. They are solutions of equations in both parameters, with a proved topology.

A curve of the result ends where one of the parameters is at the end of its part, in a singular point, or at infinity.
It goes on across the seam of a closed curve that is smooth there, and in other parts where an operation says so.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Curve_pair_locus_2
{
public:
  //! a point of a polyline.
  using Sample = Curve_pair_sample<Kernel>;

  //! a part of one of the curves without seams or breaks inside.
  struct Arc
  {
    /// the index of two parts of the operands, all with the first part of the first curve before others
    std::size_t part;
    std::size_t index;   ///< that of the curve in `solutions(part)`
    bool is_reversed;    ///< whether it is passed from its end to its begin
  };

  //! one of the curves.
  struct Curve
  {
    std::vector<Arc> arcs;   ///< in order; each begins in the point where the one before ends
    bool is_closed;          ///< whether the last arc ends where the first one begins
  };

private:
  // The point of the plane that belongs to two points, and to the unknowns of a solution.
  using Point_of_pair =
      std::function<internal::Loci::Double_pair(const internal::Loci::Pair_of_points&, const std::vector<double>&)>;

  // The curves of two parts.
  struct Part
  {
    internal::Loci::Pair_of_parts parts;
    Constraint_system_d system;
    Curve_solution_set_d solutions;
  };

  // A vertex of the solutions of one of the parts.
  struct Vertex_of_part
  {
    std::size_t part, vertex;

    friend auto operator<=>(const Vertex_of_part&, const Vertex_of_part&) = default;
  };

  Point_of_pair m_point;
  std::vector<Part> m_parts;
  std::vector<Curve> m_curves;
  std::vector<Vertex_of_part> m_point_vertices, m_singular_vertices;
  std::vector<Curve_vertex> m_points, m_singular_points;   // the same
  std::vector<Undecided_region> m_undecided;
  std::size_t m_poles = 0;
  Summary m_summary;

public:
#ifndef DOXYGEN_RUNNING
  explicit Curve_pair_locus_2(Point_of_pair point) : m_point(std::move(point)) {}

  // The solutions of an equation for two parts, cut where the point is at infinity.
  void add(const internal::Loci::Pair_of_parts& parts, const std::vector<Constraint>& constraints,
           const std::vector<Unknown>& unknowns, const Solver_options& options,
           const std::vector<Solution_d<double>>& points_at_infinity = {})
  {
    std::vector<Curve_vertex::Exact_box> poles, rest;
    for (const Solution_d<double>& point : points_at_infinity)
      (point.is_certified() ? poles : rest).push_back(point.exact_box());
    const std::size_t multiple = rest.size();
    const Constraint_system_d system = internal::Common::system_of(constraints, unknowns);
    m_parts.push_back({parts, system, internal::Curve_cuts(internal::curves_within(system, options))(poles, rest)});
    const Curve_solution_set_d& set = m_parts.back().solutions;
    const internal::Intersections::Seam_joints joints(system, set, parts.closed_unknowns);
    for (const Intersection_curve& curve : joints.curves()) {
      m_curves.push_back({{}, curve.is_closed});
      for (const Intersection_arc& arc : curve.arcs)
        m_curves.back().arcs.push_back({m_parts.size() - 1, arc.index, arc.is_reversed});
    }
    std::vector<std::size_t> points = joints.points();
    if (parts.is_one_point)
      std::erase_if(points, [&](std::size_t i) { return parts.is_one_point(set.vertices()[i].box); });
    add_special_points(points, m_point_vertices, m_points);
    add_special_points(joints.without_repetitions(set.singular_points()), m_singular_vertices, m_singular_points);
    m_undecided.insert(m_undecided.end(), set.undecided_regions().begin(), set.undecided_regions().end());
    for (const Curve_vertex::Exact_box& box : rest)
      m_undecided.push_back({{box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
    for (const std::size_t i : joints.unmatched())
      m_undecided.push_back({{set.vertices()[i].box}, {i}, Undecided_reason::DOMAIN_BOUNDARY});
    m_poles += poles.size() + multiple - rest.size();
    m_summary.nodes += set.summary().nodes;
    m_summary.seconds += set.summary().seconds;
    m_summary.is_complete = m_summary.is_complete && set.is_complete() && rest.empty() && joints.unmatched().empty();
  }

  // Joins the curves of different parts. An end that may go on in another part, but not in just one curve there, is
  // undecided.
  void join_parts()
  {
    std::vector<std::pair<internal::Intersections::Curve_end, internal::Loci::Joint_place>> ends;
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      for (const int side : {0, 1})
        if (const auto [part, vertex] = vertex_at_end(m_curves[c], side);
            !m_curves[c].is_closed && m_parts[part].parts.place && vertex->is_on_boundary && !vertex->is_on_inequality)
          if (const auto place = m_parts[part].parts.place(vertex->box))
            ends.push_back({{c, side}, *place});
    const internal::Intersections::Matched_ends matched = internal::Intersections::matched_ends(
        ends, m_curves.size(),
        [](const internal::Loci::Joint_place& a, const internal::Loci::Joint_place& b) { return a.may_be(b); });
    for (const internal::Intersections::Curve_end& end : matched.unmatched) {
      m_undecided.push_back(
          {{vertex_at_end(m_curves[end.curve], end.side).second->box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
      m_summary.is_complete = false;
    }
    m_curves = internal::Intersections::joined_curves(m_curves, matched);
    remove_repetitions();
  }

  void add_work(const Summary& work)
  {
    m_summary.nodes += work.nodes;
    m_summary.seconds += work.seconds;
    m_summary.is_complete = m_summary.is_complete && work.is_complete;
  }
#endif

  //! the curves, one after the other by parts.
  const std::vector<Curve>& curves() const { return m_curves; }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_curves.size() - number_of_closed_curves(); }

  //! single points: solutions at the end of a part that no other one is near, since a curve only touches the part from
  //! outside.
  const std::vector<Curve_vertex>& points() const { return m_points; }

  //! where curves cross in the plane of the parameters, or isolated solutions.
  const std::vector<Curve_vertex>& singular_points() const { return m_singular_points; }

  //! where nothing is proved, poles that do not find their place on a curve, and ends on a seam that were not matched
  //! with one on the other side.
  const std::vector<Undecided_region>& undecided() const { return m_undecided; }

  //! how often a curve goes to infinity and comes back from the other side: two ends each.
  std::size_t number_of_poles() const { return m_poles; }

  //! whether these are all solutions, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }

  //! the curves of two parts in the plane of the unknowns, which are their parameters unless an operation says
  //! otherwise, as the solver found them, but cut at infinity.
  const Curve_solution_set_d& solutions(std::size_t part) const { return m_parts[part].solutions; }

  //! whether the first (`side` 0) or last (`side` 1) end of a curve is at infinity.
  bool ends_at_infinity(const Curve& curve, int side) const
  {
    return !curve.is_closed && m_poles > 0 && vertex_at_end(curve, side).second->is_on_inequality;
  }

  /*!
  points along a curve, so many that it passes the middles of their chords at no more than a given distance. Far from
  the origin a larger distance will do: all is seen in the stereographic projection to a sphere of the given radius.
  Ends at infinity are left out; a point on a seam comes twice, with the parameters on both sides.
  \param curve one of the curves.
  \param error the distance; positive.
  \param radius the distance from the origin from which on less precision is needed; positive.
  \throws Invalid_input when a distance is not positive.
  */
  std::vector<Sample> polyline(const Curve& curve, double error, double radius) const
  {
    if (!(error > 0) || !(radius > 0))
      throw Invalid_input("Curve_pair_locus_2: the error and the radius must be positive");
    struct Image
    {
      internal::Loci::Double_pair point;
      std::array<double, 3> on_sphere;
    };
    const auto is_chord = [&](const auto& from, const auto& between, const auto& to) {
      return internal::distance_from_middle(from.image.on_sphere, between.image.on_sphere, to.image.on_sphere) <= error;
    };
    // points and parameters; the ends may be at infinity
    std::vector<std::pair<internal::Loci::Double_pair, std::array<double, 2>>> samples;
    for (const Arc& arc : curve.arcs) {
      const Part& part = m_parts[arc.part];
      const auto image = [&](const std::vector<double>& unknowns) {
        const internal::Loci::Double_pair p = m_point(part.parts.points(unknowns), unknowns);
        return Image{p, internal::Loci::on_sphere(p, radius)};
      };
      auto more =
          internal::curve_samples(part.system, part.solutions, part.solutions.curves()[arc.index], image, is_chord);
      if (arc.is_reversed)
        std::reverse(more.begin(), more.end());
      for (const auto& [unknowns, place] : more)
        samples.emplace_back(place.point, part.parts.parameters(unknowns));
    }
    if (ends_at_infinity(curve, 0))
      samples.erase(samples.begin());
    if (ends_at_infinity(curve, 1))
      samples.pop_back();
    std::vector<Sample> result;
    for (const auto& [point, parameters] : samples)
      result.push_back({typename Kernel::Point_2(point[0], point[1]), parameters});
    return result;
  }

private:
  // Those of the last part.
  void add_special_points(const std::vector<std::size_t>& vertices, std::vector<Vertex_of_part>& list,
                          std::vector<Curve_vertex>& points)
  {
    for (const std::size_t i : vertices) {
      list.push_back({m_parts.size() - 1, i});
      points.push_back(m_parts.back().solutions.vertices()[i]);
    }
  }

  // A point that several parts have comes once; a single one not at all if it is on a curve of another part. If it is
  // not known which point of the other part it is, it is undecided.
  void remove_repetitions()
  {
    remove_repetitions(m_point_vertices, m_points, false);
    remove_repetitions(m_singular_vertices, m_singular_points, true);
  }

  void remove_repetitions(std::vector<Vertex_of_part>& list, std::vector<Curve_vertex>& points, bool counts_on_curves)
  {
    const std::vector<Vertex_of_part> all = std::exchange(list, {});
    points.clear();
    for (const Vertex_of_part& point : all) {
      const Curve_vertex& vertex = m_parts[point.part].solutions.vertices()[point.vertex];
      const auto is_listed_before = [&](const Vertex_of_part& same) {
        return std::find(all.begin(), all.end(), same) == all.end() ? !counts_on_curves : same < point;
      };
      const std::vector<Vertex_of_part> at_place = others_at_place_of(point), in_corner = others_in_corner_of(point);
      if (at_place.size() > 1) {
        m_undecided.push_back({{vertex.box}, {}, Undecided_reason::DOMAIN_BOUNDARY});
        m_summary.is_complete = false;
      } else if (std::none_of(at_place.begin(), at_place.end(), is_listed_before) &&
                 std::none_of(in_corner.begin(), in_corner.end(), is_listed_before)) {
        list.push_back(point);
        points.push_back(vertex);
      }
    }
  }

  std::optional<internal::Loci::Joint_place> place_of(const Vertex_of_part& point) const
  {
    const auto& [parts, system, solutions] = m_parts[point.part];
    return parts.place ? parts.place(solutions.vertices()[point.vertex].box) : std::nullopt;
  }

  // The other vertices that are the same pair of parameters.
  std::vector<Vertex_of_part> others_in_corner_of(const Vertex_of_part& point) const
  {
    const auto own = corner_of(point);
    return own ? others(point, [&](const Vertex_of_part& other) { return corner_of(other) == own; })
               : std::vector<Vertex_of_part>();
  }

  std::optional<internal::Loci::Joint_corner> corner_of(const Vertex_of_part& point) const
  {
    const auto& [parts, system, solutions] = m_parts[point.part];
    return parts.corner ? parts.corner(solutions.vertices()[point.vertex].box) : std::nullopt;
  }

  // The other vertices that may be the same point, where curves may go on in another part.
  std::vector<Vertex_of_part> others_at_place_of(const Vertex_of_part& point) const
  {
    const auto own = place_of(point);
    const auto may_be_it = [&](const Vertex_of_part& other) {
      const auto place = place_of(other);
      return place && place->may_be(*own);
    };
    return own ? others(point, may_be_it) : std::vector<Vertex_of_part>();
  }

  template <class Is_same>
  std::vector<Vertex_of_part> others(const Vertex_of_part& point, const Is_same& is_same) const
  {
    std::vector<Vertex_of_part> result;
    for (std::size_t part = 0; part < m_parts.size(); ++part)
      for (std::size_t i = 0; i < m_parts[part].solutions.vertices().size(); ++i)
        if (const Vertex_of_part other{part, i}; other != point && is_same(other))
          result.push_back(other);
    return result;
  }

  // The part and the vertex where a curve that is not closed begins or ends.
  std::pair<std::size_t, const Curve_vertex*> vertex_at_end(const Curve& curve, int side) const
  {
    const Arc& arc = side == 0 ? curve.arcs.front() : curve.arcs.back();
    const Curve_solution_set_d& set = m_parts[arc.part].solutions;
    const std::vector<Curve_piece>& pieces = set.curves()[arc.index].pieces;
    return {arc.part, &set.vertices()[(side == 0) != arc.is_reversed ? pieces.front().ends[0] : pieces.back().ends[1]]};
  }
};

//! \ingroup PkgSplineConstraintsDLoci
//! writes one line: the numbers of curves, single points, singular points and undecided regions.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Curve_pair_locus_2<Kernel>& locus)
{
  return internal::write_counts(out, locus);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_LOCUS_2_H
