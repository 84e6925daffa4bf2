// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_LOCATED_FOOTPOINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_LOCATED_FOOTPOINT_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_expansion.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Tangent_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/second_derivatives.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// What the maximal disks of an envelope arc touch besides the element: the inner points of an arc, a vertex, the whole
// circle that the element lies on, or, where disks are half-planes, nothing.
struct Disk_footpoint
{
  enum class Kind { ARC, VERTEX, CIRCLE, NOTHING };

  Kind kind = Kind::NOTHING;
  std::size_t index = 0;
  int side = 0;   // of footpoints on the arc of the element itself: 1 after the parameter of the element, -1 before

  bool operator==(const Disk_footpoint&) const = default;
};

template <Enclosing_number Interval>
bool is_scaled(const Disk_curvature<Interval>& curvature, const Disk_footpoint& footpoint)
{
  return footpoint.kind == Disk_footpoint::Kind::ARC
      ? curvature.is_arc_scaled(footpoint.index)
      : footpoint.kind == Disk_footpoint::Kind::VERTEX && curvature.is_vertex_scaled(footpoint.index);
}

// By which squared distances from a footpoint are divided.
template <Enclosing_number Interval>
Exact_rational squared_factor(const Disk_curvature<Interval>& curvature, const Disk_footpoint& footpoint)
{
  return is_scaled(curvature, footpoint) ? curvature.scaled_sites()->squared_factor : Exact_rational(1);
}

// In a corner the curvature is not less than some number divided by the distance from it, in the parameter of the
// element; in a cusp, by a power of it; and where a derivative is zero, by a power of its root.
struct Corner_of_disks
{
  double parameter = 0, least = 0;
  int power = 1;
  bool is_root = false;

  double least_curvature(double u) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Interval way = CGAL::abs(Interval(u) - Interval(parameter)), distance = is_root ? CGAL::sqrt(way) : way;
    Interval result(least);
    for (int i = 0; i < power && u != parameter; ++i)
      result /= distance;
    return !(least > 0) ? -infinity : u == parameter ? infinity : result.inf();
  }
};

// A footpoint, and where it is on an arc: the curvature has one maximum in that range, or one that is not less than
// some numbers.
struct Located_footpoint
{
  Disk_footpoint footpoint;
  Range range{};
  double least = -std::numeric_limits<double>::infinity();
  Corner_of_disks corner{};
};

// The curvature of a disk, and for footpoints in an arc a range that holds the parameter there, and one with the
// greatest curvature that is known.
template <Enclosing_number Interval = Common::Interval>
struct Attained_curvature
{
  Interval curvature;
  Range range{};
  double parameter = range.middle();
  bool is_attained = true;   // else it may be less than the lower bound, and does not matter then
};

// A maximum of the curvature in a range of an arc: Newton's method for k_v = 0, or k_v / m = 0, with bisection where
// that leaves the range in which k_v changes its sign. It has these signs for certain at the ends of the range that is
// returned, but for those of the whole range.
template <Enclosing_number Interval, class Curvature_at>
Attained_curvature<Interval> maximal_curvature(const Curvature_at& at, const Range& range)
{
  constexpr int most_steps = 60;
  const auto middle = [](const Interval& x) { return x.inf() / 2 + x.sup() / 2; };
  Range bracket = range;
  double v = bracket.middle();
  for (int step = 0; step < most_steps; ++step) {
    const auto k = at({v, v});
    const double slope = middle(k.dv), newton = v - slope / middle(k.dvv);
    if (std::isnan(slope))
      break;
    (slope > 0 ? bracket.begin : bracket.end) = v;
    const double next = bracket.begin < newton && newton < bracket.end && middle(k.dvv) < 0 ? newton : bracket.middle();
    if (!(std::abs(next - v) > 0x1p-52))
      break;
    v = next;
  }
  for (double width = 0x1p-51; width < 1; width *= 16) {
    const Range around{(std::max)(v - width, range.begin), (std::min)(v + width, range.end)};
    const bool grows_before = around.begin == range.begin || at({around.begin, around.begin}).dv.inf() > 0,
               falls_behind = around.end == range.end || at({around.end, around.end}).dv.sup() < 0;
    if (!grows_before || !falls_behind)
      continue;
    const auto k = at(around), here = at({v, v});
    const Interval step = interval_of<Interval>(around) - Interval(v);
    Interval greatest = common_part(k.value, here.value + k.factor * k.dv * step);
    // a concave function is below its tangents, and below the parabola with the least second derivative; else k_v is as
    // much as m times the derivative of such a function
    if (k.dvv.sup() < 0)
      greatest = common_part(greatest,
                             here.value +
                                 k.factor *
                                     common_part(hull(Interval(0), here.dv * step),
                                                 Interval(0, (CGAL::square(here.dv) / (Interval(-2) * k.dvv)).sup())));
    return {greatest, around, v};
  }
  return {any_number<Interval>(), {v, v}};
}

// Branch and bound: the greatest curvature in a range, and a range that holds its parameters if it is not less than
// some number: no longer divided where it is known to have one maximum in the inside, or in pieces that are shorter
// than doubles tell, or too many.
template <Enclosing_number Interval, class Curvature_at>
Attained_curvature<Interval> bounded_curvature(const Curvature_at& at, const Range& range, double least)
{
  constexpr std::size_t most_pieces = 16;
  constexpr double least_width = 0x1p-50, infinity = std::numeric_limits<double>::infinity();
  std::vector<Range> pieces{range};
  double best = range.middle(), attained = -infinity;
  const auto add = [&](double v) {
    if (const double bound = at({v, v}).value.inf(); bound > attained)
      std::tie(attained, best) = std::pair(bound, v);
  };
  const auto all = [&] { return Range{pieces.front().begin, pieces.back().end}; };
  const auto slope_at = [&](double v) { return at({v, v}).dv; };
  const auto has_one_maximum = [&](const Range& r) {
    return at(r).dvv.sup() < 0 && slope_at(r.begin).inf() > 0 && slope_at(r.end).sup() < 0;
  };
  bool is_only = has_one_maximum(all());
  while (pieces.size() < most_pieces && pieces.front().width() > least_width && !is_only) {
    std::vector<Range> halves;
    for (const Range& piece : pieces) {
      const double middle = piece.middle();
      add(middle);
      halves.insert(halves.end(), {{piece.begin, middle}, {middle, piece.end}});
    }
    std::erase_if(halves, [&](const Range& half) { return at(half).value.sup() < (std::max)(least, attained); });
    if (halves.empty())
      return {Interval(attained, (std::max)(attained, least)), range, best, false};
    pieces = std::move(halves);
    is_only = has_one_maximum(all());
  }
  const Attained_curvature<Interval> top = maximal_curvature<Interval>(at, all());
  add(top.parameter);
  double most = -infinity;
  for (const Range& piece : pieces)
    if (const double bound = at(piece).value.sup(); !(bound <= most))
      most = std::isfinite(bound) ? bound : infinity;
  if (is_only)
    most = (std::min)(most, top.curvature.sup());
  return {Interval(attained, (std::max)({attained, most, least})), all(), best, attained >= least};
}

// The only maximum of the curvature in a range of an arc that is not too low.
template <Enclosing_number Interval>
Attained_curvature<Interval>
largest_curvature_on_arc(const Site_arc_2<Interval>& arc, const Disk_curvature<Interval>& curvature,
                         const Element_part<Interval>& part, const Located_footpoint& located)
{
  const auto at = [&](const Range& range) { return curvature(part, located.footpoint.index, range, arc.jet(range)); };
  // the part is one point
  const double least = (std::max)(located.least, located.corner.least_curvature(part.range.begin));
  const auto is_known = [&](const Attained_curvature<Interval>& k) {
    return k.curvature.inf() >= least && std::isfinite(k.curvature.sup() - k.curvature.inf());
  };
  Attained_curvature<Interval> result = maximal_curvature<Interval>(at, located.range);
  if (is_known(result))
    return result;
  const Attained_curvature<Interval> bounded = bounded_curvature<Interval>(at, located.range, least);
  result = maximal_curvature<Interval>(at, bounded.range);
  return is_known(result) ? result : bounded;
}

// The disks of a part that touch a footpoint, if it is on a line or circle, and certainly in the inside of its arc.
template <Enclosing_number Interval>
std::optional<Tangent_disks<Interval>>
tangent_disks(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
              const Element_part<Interval>& part, const Disk_footpoint& footpoint)
{
  return footpoint.kind == Disk_footpoint::Kind::ARC
      ? Tangent_disks<Interval>::over(graph, curvature, part, footpoint.index)
      : std::nullopt;
}

// The curvature of the disk that touches an element in one point, and a footpoint.
template <Enclosing_number Interval>
Attained_curvature<Interval> largest_curvature(const Site_graph_2<Interval>& graph,
                                               const Disk_curvature<Interval>& curvature,
                                               const Element_part<Interval>& part, const Located_footpoint& located)
{
  switch (located.footpoint.kind) {
  case Disk_footpoint::Kind::ARC:
    return largest_curvature_on_arc(graph.arcs()[located.footpoint.index], curvature, part, located);
  case Disk_footpoint::Kind::VERTEX: return {curvature(part, located.footpoint.index).value};
  case Disk_footpoint::Kind::CIRCLE: return {curvature.of_own_circle(part).value().value};
  default: return {Interval(0)};
  }
}

// The derivative of that curvature by the parameter of the element, over a part: where k_v = 0 it is k_u.
template <Enclosing_number Interval>
Interval slope_of_largest_curvature(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                                    const Element_part<Interval>& part, const Located_footpoint& located)
{
  const std::size_t index = located.footpoint.index;
  switch (located.footpoint.kind) {
  case Disk_footpoint::Kind::ARC: {
    // in the range, or lower than something else
    const auto tangent = tangent_disks(graph, curvature, part, located.footpoint);
    return tangent ? tangent->expansion().slope
                   : curvature(part, index, located.range, graph.arcs()[index].jet(located.range)).du;
  }
  case Disk_footpoint::Kind::VERTEX: return curvature(part, index).du;
  case Disk_footpoint::Kind::CIRCLE: return curvature.of_own_circle(part).value().du;
  default: return Interval(0);
  }
}

// The second derivative of that curvature over a part: k_uu - k_uv^2 / k_vv, where k_uv^2 / k_vv is m times what it is
// for k_v / m; k_uu where the largest one may be at an end of the range.
template <Enclosing_number Interval>
Interval second_derivative_of_largest_curvature(const Site_graph_2<Interval>& graph,
                                                const Disk_curvature<Interval>& curvature,
                                                const Element_part<Interval>& part, const Located_footpoint& located)
{
  const std::size_t index = located.footpoint.index;
  if (located.footpoint.kind == Disk_footpoint::Kind::NOTHING)
    return Interval(0);
  if (located.footpoint.kind == Disk_footpoint::Kind::VERTEX && !curvature.is_vertex_scaled(index))
    return second_derivative_of_curvature(graph, part, graph.vertices()[index].point, curvature(part, index));
  if (located.footpoint.kind != Disk_footpoint::Kind::ARC || curvature.is_arc_scaled(index))
    return any_number<Interval>();
  const Curve_jet<Interval> jet = graph.arcs()[index].jet(located.range);
  const Curvature_bounds<Interval> k = curvature(part, index, located.range, jet);
  if (!(k.dvv.sup() < 0))
    return any_number<Interval>();
  const auto slope_at = [&](double v) { return curvature(part, index, {v, v}, graph.arcs()[index].jet({v, v})).dv; };
  const bool is_inside = slope_at(located.range.begin).inf() > 0 && slope_at(located.range.end).sup() < 0;
  const Interval by_footpoint = k.factor * CGAL::square(k.duv) / -k.dvv;
  if (!(by_footpoint.inf() >= 0 && std::isfinite(by_footpoint.sup())))
    return any_number<Interval>();
  return second_derivative_of_curvature(graph, part, jet[0], k) +
      (is_inside ? by_footpoint : hull(Interval(0), by_footpoint));
}

// By the disks of one footpoint; where it is on a line or circle, by those that touch that.
template <Enclosing_number Interval>
Curvature_expansion<Interval> curvature_expansion(const Site_graph_2<Interval>& graph,
                                                  const Disk_curvature<Interval>& curvature,
                                                  const Element_part<Interval>& part, const Located_footpoint& located)
{
  if (const auto tangent = tangent_disks(graph, curvature, part, located.footpoint))
    return tangent->expansion();
  const double u = part.range.middle();
  const Element_part<Interval> middle = curvature.part(part.element, {u, u});
  const Attained_curvature<Interval> greatest = largest_curvature(graph, curvature, middle, located);
  Curvature_expansion<Interval> result;
  result.slope = slope_of_largest_curvature(graph, curvature, part, located);
  if (!greatest.is_attained || !std::isfinite(greatest.curvature.sup() - greatest.curvature.inf()))
    return result;
  Located_footpoint here = located;
  here.range = greatest.range;
  result.at_middle = greatest.curvature;
  result.slope_at_middle = slope_of_largest_curvature(graph, curvature, middle, here);
  result.second_derivative = second_derivative_of_largest_curvature(graph, curvature, part, located);
  return result;
}

// The only zero of a function in a range at whose ends it has different signs: bisection while signs are certain.
template <class Sign_at>
Range range_of_zero(Range range, const Sign_at& sign_at, int sign_at_begin)
{
  for (const double share : {0.5, 0.4375, 0.5625})
    for (;;) {
      const double u = range.begin + share * range.width();
      if (!(range.begin < u && u < range.end))
        return range;
      const int sign = sign_at(u);
      if (sign == 0)
        break;
      (sign == sign_at_begin ? range.begin : range.end) = u;
    }
  return range;
}

/*
A sign that a function finds in the expansion of the difference of the curvatures of two footpoints, k_a - k_b, times a
positive function, over a part of an element where the disks of one of them touch its line or circle; 0 if it finds
none.
*/
template <Enclosing_number Interval, class Sign_in>
int sign_by_tangent_disks(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                          const Element_part<Interval>& part, const Located_footpoint& a, const Located_footpoint& b,
                          const Sign_in& sign_in)
{
  const auto sign = [&](const Located_footpoint& tangent, const Located_footpoint& other) {
    const auto disks = tangent_disks(graph, curvature, part, tangent.footpoint);
    return disks ? sign_in(disks->difference(curvature_expansion(graph, curvature, part, other))) : 0;
  };
  const int first = sign(a, b);
  return first != 0 ? first : -sign(b, a);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_LOCATED_FOOTPOINT_H
