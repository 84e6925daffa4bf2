// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTION_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

What is known of an intersection of two curves.
*/
enum class Intersection_kind {
  TRANSVERSAL,   ///< one common point, where both curves are regular and cross (on a knot, on both sides of it)
  TANGENT,       ///< one common point that counts several times: the curves touch, or one of them is singular there
  END_POINT,     ///< one common point that counts once, at an end of at least one of the curves, or on the seam of a closed one
  OVERLAP,       ///< a piece of one curve lies on the other
  UNDECIDED      ///< nothing is proved: there may be common points with these parameters
};

//! \ingroup PkgSplineConstraintsDOperations
//! writes `transversal`, `tangent`, `end point`, `overlap` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Intersection_kind kind)
{
  static const char* const names[] = {"transversal", "tangent", "end point", "overlap", "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDOperations

An intersection of two curves in the plane: parameters on both, within ranges that are proved to hold those of the common point, or of the common piece.
*/
template <SplineKernel Kernel>
class Curve_intersection_2
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  Intersection_kind m_kind;
  std::array<Range, 2> m_ranges;
  typename Kernel::Point_2 m_point;
  std::array<bool, 2> m_is_at_end;
  Solution_d<double> m_solution;

public:
#ifndef DOXYGEN_RUNNING
  Curve_intersection_2(Intersection_kind kind, const std::array<Range, 2>& ranges, const typename Kernel::Point_2& point, const std::array<bool, 2>& is_at_end,
                       Solution_d<double> solution)
    : m_kind(kind), m_ranges(ranges), m_point(point), m_is_at_end(is_at_end), m_solution(std::move(solution))
  {}
#endif

  //! what is proved.
  Intersection_kind kind() const { return m_kind; }

  //! the parameters on the first (0) or second (1) curve: those of a common point lie in the range; those of an overlap, proved to be a segment, are the range.
  const Range& parameter_range(std::size_t curve) const { return m_ranges[curve]; }

  //! the middle of the range, rounded to double.
  double parameter(std::size_t curve) const { return CGAL::to_double(Exact_rational((m_ranges[curve].first + m_ranges[curve].second) / 2)); }

  //! the point of the first curve in the middle of its range. Where the range is one number and the kernel exact, it is the common point itself.
  const typename Kernel::Point_2& point() const { return m_point; }

  //! whether the common point is an end of the first (0) or second (1) curve, decided exactly; the seam of a closed curve is one.
  bool is_at_end(std::size_t curve) const { return m_is_at_end[curve]; }

  //! how often the common point counts; 1 when the curves cross, 0 when not known.
  int multiplicity() const { return m_solution.multiplicity(); }

  //! the answer of the solver, with its proof: the unknowns are the two parameters.
  const Solution_d<double>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDOperations

The intersections of two curves in the plane, those of one kind after another.
*/
template <SplineKernel Kernel>
class Curve_intersections_2
{
  std::vector<Curve_intersection_2<Kernel>> m_intersections;
  Summary m_summary;

public:
  using const_iterator = typename std::vector<Curve_intersection_2<Kernel>>::const_iterator;

#ifndef DOXYGEN_RUNNING
  Curve_intersections_2(std::vector<Curve_intersection_2<Kernel>> intersections, const Summary& summary)
    : m_intersections(std::move(intersections)), m_summary(summary)
  {
    std::stable_sort(m_intersections.begin(), m_intersections.end(), [](const auto& a, const auto& b) { return a.kind() < b.kind(); });
    m_summary.is_complete = count(Intersection_kind::UNDECIDED) == 0;
  }
#endif

  const_iterator begin() const { return m_intersections.begin(); }
  const_iterator end() const { return m_intersections.end(); }
  std::size_t size() const { return m_intersections.size(); }
  bool empty() const { return m_intersections.empty(); }
  const Curve_intersection_2<Kernel>& operator[](std::size_t i) const { return m_intersections[i]; }

  //! number of intersections of a kind.
  std::size_t count(Intersection_kind kind) const
  {
    return std::count_if(begin(), end(), [=](const auto& intersection) { return intersection.kind() == kind; });
  }

  //! whether there are no others, by proof, and none is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTION_2_H
