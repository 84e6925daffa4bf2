// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_MODEL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_MODEL_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/append_samples.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_of_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// A box around the sum, by the control points, and by where the operands are that are undecided.
inline Interval_pair box_of_sum(const std::array<Sum_operand_2, 2>& operands)
{
  Interval_pair result{Interval(0), Interval(0)};
  for (const Sum_operand_2& operand : operands) {
    std::vector<Undecided_part::Range> box;
    for (const Undecided_part& undecided : operand.undecided)
      box = undecided.place;
    for (const Boundary_loop_2& loop : operand.loops)
      for (const Boundary_piece& piece : loop.pieces())
        box = united_box(std::move(box), piece.box());
    if (!box.empty())
      result = result + Interval_pair{Interval(box[0].first, box[0].second), Interval(box[1].first, box[1].second)};
  }
  return result;
}

/*
The Minkowski sum of two regions: what was computed, in the order in which each refers to those before. When the run
ends earlier, what follows is not there.
*/
class Sum_model_2
{
  using Section = Sum_boundary_2::Section;
  using Chain = Sum_boundary_2::Chain;

  Run_of_steps m_run;
  std::array<Sum_operand_2, 2> m_operands;
  std::array<std::optional<Region_elements_2>, 2> m_elements;
  std::optional<Sum_interior_2> m_interior;
  std::optional<Convolution_2> m_convolution;
  std::optional<Sum_boundary_2> m_boundary;

public:
  Sum_model_2(std::array<Sum_operand_2, 2> operands, const Solver_options& options)
    : m_run(options), m_operands(std::move(operands))
  {
    try {
      for (const std::size_t k : {0, 1})
        m_elements[k].emplace(m_operands[k].loops, m_run);
      m_interior.emplace(*m_elements[0], *m_elements[1]);
      m_convolution.emplace(*m_elements[0], *m_elements[1], *m_interior, m_run);
      m_boundary.emplace(*m_convolution, *m_interior, m_run);
    } catch (const Run_stopped&) {   // without boundaries, all is undecided
    }
  }

  std::vector<Minkowski_sum_boundary_2> boundaries() const
  {
    std::vector<Minkowski_sum_boundary_2> result;
    if (m_boundary)
      for (const Chain& chain : m_boundary->chains()) {
        result.push_back({{}, chain.is_closed, chain.is_hole, chain.outer});
        for (const Section& section : chain.sections)
          result.back().arcs.push_back(arc(section));
      }
    return result;
  }

  std::vector<Undecided_part> undecided() const
  {
    if (!m_boundary)
      return {Undecided_part{place(box_of_sum(m_operands)), {}, in_words(m_run.reason())}};
    std::vector<Undecided_part> result;
    for (const auto& [box, part, reason] : m_boundary->doubts()) {
      result.push_back({place(box), {}, reason});
      if (part)
        result.back().parameters = parameters(part->first, part->second);
    }
    return result;
  }

  Summary summary(bool is_complete) const { return m_run.summary(is_complete); }

  CGAL::Uncertain<bool> has_in_interior(const Exact_pair& point) const
  {
    if (!m_interior)
      return CGAL::Uncertain<bool>::indeterminate();
    Run_of_steps run({});
    return m_interior->contains({interval_of(point[0]), interval_of(point[1])}, run);
  }

  std::vector<Sum_sample_2> samples(std::size_t boundary, std::size_t arc, double error) const
  {
    const Section& section = m_boundary->chains()[boundary].sections[arc];
    std::vector<Sum_sample_2> result;
    for (const Arc_point& place : samples_along(section, error)) {
      Sum_sample_2 sample{place.middle(), {}};
      for (const std::size_t k : {0, 1})
        sample.parameters[k] = origin(section.piece, k, place.parameter).second;
      result.push_back(sample);
    }
    return result;
  }

  std::vector<std::array<double, 2>> points(std::size_t boundary, double error) const
  {
    const Chain& chain = m_boundary->chains()[boundary];
    std::vector<std::array<double, 2>> result;
    for (const Section& section : chain.sections) {
      for (const Arc_point& sample : samples_along(section, error))
        result.push_back(sample.middle());
      if (chain.is_closed || &section != &chain.sections.back())
        result.pop_back();
    }
    return result;
  }

private:
  const Convolution_piece_2& piece(std::size_t index) const { return m_boundary->piece(index); }

  // The curve of a region, and its parameter, that a point of a piece comes from.
  std::pair<std::size_t, double> origin(std::size_t index, std::size_t region, double t) const
  {
    return m_elements[region]->origin(piece(index).element(region).arc, piece(index).parameters(t)[region]);
  }

  Minkowski_sum_arc_2 arc(const Section& section) const
  {
    Minkowski_sum_arc_2 result;
    for (const std::size_t k : {0, 1}) {
      const auto [curve, begin] = origin(section.piece, k, section.range.begin);
      result.curves[k] = curve;
      result.parameters[k] = {begin, origin(section.piece, k, section.range.end).second};
    }
    return result;
  }

  static std::vector<Undecided_part::Range> place(const Interval_pair& box)
  {
    return {{box[0].inf(), box[0].sup()}, {box[1].inf(), box[1].sup()}};
  }

  // Curves of the second region are counted behind those of the first one.
  std::vector<Undecided_part::Parameters> parameters(std::size_t index, const Range& range) const
  {
    std::vector<Undecided_part::Parameters> result;
    for (const std::size_t k : {0, 1}) {
      const auto [curve, begin] = origin(index, k, range.begin);
      const double end = origin(index, k, range.end).second;
      result.push_back({curve + (k == 1 ? m_operands[0].number_of_curves : 0), {std::minmax(begin, end)}});
    }
    return result;
  }

  // A point of an arc, and a direction of its tangent there.
  struct Arc_point
  {
    double parameter;
    Interval_pair point, direction;

    std::array<double, 2> middle() const
    {
      return {point[0].inf() / 2 + point[0].sup() / 2, point[1].inf() / 2 + point[1].sup() / 2};
    }
  };

  std::vector<Arc_point> samples_along(const Section& section, double error) const
  {
    constexpr Halvings halvings{2, 20};
    const Convolution_piece_2& p = piece(section.piece);
    const auto sample = [&](double t) { return Arc_point{t, p({t, t}).point, p.direction({t, t})}; };
    const auto between = [&](const Arc_point& from, const Arc_point& to) {
      return sample(from.parameter / 2 + to.parameter / 2);
    };
    const auto is_chord = [&](const Arc_point& from, const Arc_point&, const Arc_point& to) {
      return chord_error(p, from, to) <= error;
    };
    std::vector<Arc_point> result{sample(section.range.begin)};
    append_samples(result, sample(section.range.end), between, is_chord, halvings);
    return result;
  }

  /*
  A bound of the distance between a chord and its part of an arc, either way. This turns to one side, by an angle a, so
  it is in a triangle of the chord and both tangents, with a height of at most tan(a / 2) times half of the chord. Near
  an inflection it is a bound of the size of that part.
  */
  static double chord_error(const Convolution_piece_2& piece, const Arc_point& from, const Arc_point& to)
  {
    if (!piece.is_convex())
      return diameter(piece({from.parameter, to.parameter}).point).sup();
    const Interval half_chord = CGAL::sqrt(squared_norm(to.point - from.point)) / Interval(2);
    return (half_chord * CGAL::abs(tangent_of_half_angle(from.direction, to.direction)) + diameter(from.point) +
            diameter(to.point))
        .sup();
  }
};

// Of operands of which one at least is undecided: nothing is known outside of a box around the sum.
inline Sum_of_regions_2 undecided_sum(const std::array<Sum_operand_2, 2>& operands)
{
  Undecided_part part;
  Undecided_reason reason = Undecided_reason::NONE;
  for (const Interval& range : box_of_sum(operands))
    part.place.emplace_back(range.inf(), range.sup());
  for (const Sum_operand_2& operand : operands)
    for (const Undecided_part& undecided : operand.undecided) {
      part.parameters.insert(part.parameters.end(), undecided.parameters.begin(), undecided.parameters.end());
      part.reason = undecided.reason;
      reason = operand.reason;
    }
  return {nullptr, {}, {std::move(part)}, undecided_summary(reason)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Sum_of_regions_2 sum_of_regions(const std::array<Sum_operand_2, 2>& operands,
                                                               const Solver_options& options)
{
  options.check();
  Exact_rational greatest(0);
  for (const Sum_operand_2& operand : operands)
    for (const Boundary_loop_2& loop : operand.loops)
      greatest = (std::max)(greatest, loop.greatest_coordinate());
  check_greatest_coordinate(greatest, "Minkowski_sum_2");
  const Upward_rounding_guard guard;
  if (std::any_of(operands.begin(), operands.end(),
                  [](const Sum_operand_2& operand) { return !operand.undecided.empty(); }))
    return undecided_sum(operands);
  Sum_of_regions_2 result;
  result.model = std::make_shared<const Sum_model_2>(operands, options);
  result.boundaries = result.model->boundaries();
  result.undecided = result.model->undecided();
  result.summary = result.model->summary(result.undecided.empty());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool> has_in_interior(const Sum_model_2& sum, const Exact_pair& point)
{
  const Upward_rounding_guard guard;
  return sum.has_in_interior(point);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Sum_sample_2> samples_along_arc(const Sum_model_2& sum, std::size_t boundary,
                                                                           std::size_t arc, double error)
{
  const Upward_rounding_guard guard;
  return sum.samples(boundary, arc, error);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::array<double, 2>>
points_along_boundary(const Sum_model_2& sum, std::size_t boundary, double error)
{
  const Upward_rounding_guard guard;
  return sum.points(boundary, error);
}

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_SUM_MODEL_2_H
