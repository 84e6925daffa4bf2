// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TRACED_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TRACED_CURVE_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Fine_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

inline bool may_meet(const Interval& a, const Interval& b) { return a.inf() <= b.sup() && b.inf() <= a.sup(); }
inline bool may_meet(const Interval_pair& a, const Interval_pair& b)
{
  return may_meet(a[0], b[0]) && may_meet(a[1], b[1]);
}

// A point of a curve, its direction, its derivative divided by this, and its curvature, if needed, or enclosures of
// them over a range. The direction is known well where the derivative is nearly zero, as near a cusp.
struct Traced_jet
{
  Interval_pair point, direction;
  Interval speed, curvature;
};

using Fine_pair = std::array<Fine_interval, 2>;

/*
A curve that is known by enclosures of its points and derivatives over ranges of its parameter, which are kept for the
ranges that halving makes. Its points may be known on the level above doubles, too. This is enough to decide with more
precision: what is between the points of two curves is small there, and is multiplied by little that is not.
*/
class Traced_curve_2
{
public:
  using Evaluation = std::function<Traced_jet(const Range&)>;
  using Fine_evaluation = std::function<Fine_pair(double)>;

  // A range with what is known there.
  class Part
  {
    friend Traced_curve_2;

    Range m_range;
    Interval_pair m_middle_point;
    Traced_jet m_jet;
    mutable std::unique_ptr<std::array<Part, 2>> m_halves;
    mutable std::unique_ptr<const Fine_pair> m_fine_middle_point;

  public:
    const Range& range() const { return m_range; }
    const Interval_pair& middle_point() const { return m_middle_point; }
    const Interval_pair& box() const { return m_jet.point; }
    const Interval_pair& direction() const { return m_jet.direction; }
    const Interval& speed() const { return m_jet.speed; }
    const Interval& curvature() const { return m_jet.curvature; }
  };

private:
  Evaluation m_evaluation;
  Fine_evaluation m_fine_evaluation;
  Range m_inner;
  std::unique_ptr<const Part> m_whole;

public:
  // The curve over a range. Its ends may be known up to small ranges only: between these is the inner range.
  Traced_curve_2(Evaluation evaluation, const Range& range, const Range& inner, Fine_evaluation fine_evaluation = {})
    : m_evaluation(std::move(evaluation)), m_fine_evaluation(std::move(fine_evaluation)), m_inner(inner),
      m_whole(std::make_unique<Part>(part(range)))
  {}

  const Part& whole() const { return *m_whole; }
  const Range& range() const { return m_whole->range(); }
  const Range& inner_range() const { return m_inner; }
  Traced_jet operator()(const Range& range) const { return m_evaluation(range); }

  const std::array<Part, 2>& halves(const Part& of) const
  {
    if (!of.m_halves) {
      const auto& [begin, end] = of.m_range;
      const double middle = of.m_range.middle();
      of.m_halves =
          std::make_unique<std::array<Part, 2>>(std::array<Part, 2>{part({begin, middle}), part({middle, end})});
    }
    return *of.m_halves;
  }

  // On the level above doubles, if the curve is known there.
  const Fine_pair& fine_middle_point(const Part& of) const
  {
    if (!of.m_fine_middle_point)
      of.m_fine_middle_point = std::make_unique<const Fine_pair>(
          m_fine_evaluation ? m_fine_evaluation(of.m_range.middle())
                            : Fine_pair{Fine_interval(of.m_middle_point[0]), Fine_interval(of.m_middle_point[1])});
    return *of.m_fine_middle_point;
  }

  Part part(const Range& range) const
  {
    Part result;
    result.m_range = range;
    result.m_jet = m_evaluation(range);
    result.m_middle_point = m_evaluation({range.middle(), range.middle()}).point;
    return result;
  }
};

// A curve, or its reflection in a point p: offset - C(t), where the offset is 2 p.
class Traced_view_2
{
  const Traced_curve_2* m_curve;
  std::optional<Interval_pair> m_offset;

public:
  using Part = Traced_curve_2::Part;

  explicit Traced_view_2(const Traced_curve_2& curve, std::optional<Interval_pair> offset = std::nullopt)
    : m_curve(&curve), m_offset(offset)
  {}

  const Traced_curve_2& curve() const { return *m_curve; }
  Interval_pair box(const Part& part) const { return seen(part.box()); }

  template <Enclosing_number Number = Interval>
  std::array<Number, 2> middle_point(const Part& part) const
  {
    if constexpr (std::same_as<Number, Interval>)
      return seen(part.middle_point());
    else
      return seen(m_curve->fine_middle_point(part));
  }

  Interval_pair direction(const Part& part) const { return seen_direction(part.direction()); }

  // The same over any range.
  Interval_pair point(const Range& range) const { return seen((*m_curve)(range).point); }
  Interval_pair direction(const Range& range) const { return seen_direction((*m_curve)(range).direction); }

private:
  Interval_pair seen_direction(const Interval_pair& direction) const
  {
    return m_offset ? Interval_pair{-direction[0], -direction[1]} : direction;
  }

  template <Enclosing_number Number>
  std::array<Number, 2> seen(const std::array<Number, 2>& point) const
  {
    return m_offset ? std::array<Number, 2>{Number((*m_offset)[0]) - point[0], Number((*m_offset)[1]) - point[1]}
                    : point;
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TRACED_CURVE_2_H
