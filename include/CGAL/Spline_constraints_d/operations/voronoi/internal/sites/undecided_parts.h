// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A part of an element.
struct Element_range
{
  std::size_t element;
  Range range;
};

// One that is not decided, and why: by the highest precision, or as the search was ended.
struct Undecided_range
{
  std::size_t element;
  Range range;
  Undecided_reason reason = Undecided_reason::TOLERANCE;
};

// The numbers of curves and points in the order of the operands.
class Operand_numbers
{
  std::vector<std::size_t> m_curves;
  std::map<Exact_pair, std::size_t> m_points;   // the first one in each place
  std::vector<Undecided_part::Parameters> m_all;

public:
  // Curves, and points behind them.
  explicit Operand_numbers(const Planar_operands& operands) : m_curves(operands.curves.size())
  {
    std::iota(m_curves.begin(), m_curves.end(), 0);
    for (std::size_t i = 0; i < operands.curves.size(); ++i)
      add_curve(operands.curves[i], i);
    for (std::size_t i = 0; i < operands.points.size(); ++i)
      add_point(operands.points[i], operands.curves.size() + i);
  }

  // Two operands, which may have been exchanged.
  explicit Operand_numbers(const Ordered_operands& operands, bool is_exchanged = false)
    : m_curves(operands.curves.size())
  {
    for (std::size_t k = 0; k < operands.places.size(); ++k) {
      const std::size_t number = is_exchanged ? operands.places.size() - 1 - k : k;
      const auto& [is_point, index] = operands.places[k];
      if (is_point)
        add_point(operands.points[index], number);
      else {
        m_curves[index] = number;
        add_curve(operands.curves[index], number);
      }
    }
    if (is_exchanged)
      std::reverse(m_all.begin(), m_all.end());
  }

  std::size_t of_curve(std::size_t curve) const { return m_curves[curve]; }
  std::size_t of_point(const Exact_pair& point) const { return m_points.at(point); }

  // All of all operands.
  const std::vector<Undecided_part::Parameters>& all() const { return m_all; }

private:
  void add_curve(const Operand_curve_2& curve, std::size_t number)
  {
    m_all.push_back({number, {to_double_range(curve.weight().domain(0))}});
  }

  void add_point(const Exact_pair& point, std::size_t number)
  {
    m_points.emplace(point, number);
    m_all.push_back({number, {}});
  }
};

// The part of an operand that a part of an element belongs to: of a normal cone, the end of one of the arcs there.
inline Undecided_part::Parameters part_of_operand(const Site_graph_2<>& graph, const Operand_numbers& numbers,
                                                  const Undecided_range& part)
{
  const Oriented_element<>& element = graph.elements()[part.element];
  const auto part_of_curve = [&](std::size_t arc, double begin, double end) {
    return Undecided_part::Parameters{numbers.of_curve(graph.curve_of_arc(arc)),
                                      {{graph.curve_parameter(arc, begin), graph.curve_parameter(arc, end)}}};
  };
  if (!element.is_normal_cone)
    return part_of_curve(element.object, part.range.begin, part.range.end);
  const Site_graph_2<>::Vertex& vertex = graph.vertices()[element.object];
  if (vertex.ends.empty())
    return {numbers.of_point(vertex.exact_point), {}};
  const Arc_end& end = vertex.ends.front();
  return part_of_curve(end.arc, end.parameter(), end.parameter());
}

inline std::string words_of(Undecided_reason reason)
{
  return reason == Undecided_reason::TOLERANCE ? "not decided with the highest precision" : in_words(reason);
}

inline Undecided_part::Range range_around(const Undecided_part::Range& a, const Undecided_part::Range& b)
{
  return {(std::min)(a.first, b.first), (std::max)(a.second, b.second)};
}

// Those parts of operands, in order, where parts that meet for the same reason are one. Of a graph that is not proved,
// where curves may overlap, all of each operand. `place_of(range)` is a box in the plane, or nothing.
template <class Place_of>
std::vector<Undecided_part> undecided_parts(const Site_graph_2<>& graph, const Operand_numbers& numbers,
                                            std::vector<Undecided_range> ranges, const Place_of& place_of)
{
  for (std::size_t f = 0; f < graph.elements().size() && !graph.is_proved(); ++f)
    ranges.push_back({f, Range()});
  std::vector<Undecided_part> parts, result;
  for (const Undecided_range& range : ranges)
    parts.push_back({place_of(range), {part_of_operand(graph, numbers, range)}, words_of(range.reason)});
  const auto operand = [](const Undecided_part& part) -> const Undecided_part::Parameters& {
    return part.parameters.front();
  };
  std::sort(parts.begin(), parts.end(), [&](const Undecided_part& a, const Undecided_part& b) {
    return std::tie(operand(a).operand, a.reason, operand(a).ranges) <
        std::tie(operand(b).operand, b.reason, operand(b).ranges);
  });
  for (const Undecided_part& part : parts) {
    const bool is_same = !result.empty() && operand(result.back()).operand == operand(part).operand &&
        result.back().reason == part.reason;
    if (!is_same ||
        (!operand(part).ranges.empty() && operand(result.back()).ranges[0].second < operand(part).ranges[0].first)) {
      result.push_back(part);
      continue;
    }
    if (!operand(part).ranges.empty())
      result.back().parameters[0].ranges[0] =
          range_around(operand(result.back()).ranges[0], operand(part).ranges[0]);
    for (std::size_t k = 0; k < part.place.size(); ++k)
      result.back().place[k] = range_around(result.back().place[k], part.place[k]);
  }
  return result;
}

// The same without places.
inline std::vector<Undecided_part> undecided_parts(const Site_graph_2<>& graph, const Operand_numbers& numbers,
                                                   const std::vector<Undecided_range>& ranges)
{
  return undecided_parts(graph, numbers, ranges,
                         [](const Undecided_range&) { return std::vector<Undecided_part::Range>(); });
}

// An answer of which nothing is known: all operands are undecided.
template <class Answer>
Answer without_answer(const Operand_numbers& numbers, const Run_stopped& stopped, const Search_control& control)
{
  Answer result;
  for (const Undecided_part::Parameters& operand : numbers.all())
    result.undecided.push_back({{}, {operand}, in_words(stopped.reason)});
  result.summary = control.summary(false);
  result.summary.why_not = stopped.reason;
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_UNDECIDED_PARTS_H
