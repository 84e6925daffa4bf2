// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/geometry/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
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

An intersection of two curves in the plane or in space: parameters on both, within ranges that are proved to hold those of the common point, or of the common piece.
*/
template <SplineKernel Kernel, int d>
class Curve_intersection
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  Intersection_kind m_kind;
  std::array<Point_on_spline<Kernel, 1, d>, 2> m_points;
  std::array<bool, 2> m_is_at_end;
  Solution_d<double> m_solution;

public:
#ifndef DOXYGEN_RUNNING
  Curve_intersection(Intersection_kind kind, std::array<Point_on_spline<Kernel, 1, d>, 2> points, const std::array<bool, 2>& is_at_end, Solution_d<double> solution)
    : m_kind(kind), m_points(std::move(points)), m_is_at_end(is_at_end), m_solution(std::move(solution))
  {}
#endif

  //! what is proved.
  Intersection_kind kind() const { return m_kind; }

  //! the parameters on the first (0) or second (1) curve: those of a common point lie in the range; those of an overlap, proved to be a segment, are the range.
  const Range& parameter_range(std::size_t curve) const { return m_points[curve].parameter_range(); }

  //! the middle of the range, rounded to double.
  double parameter(std::size_t curve) const { return m_points[curve].parameter(); }

  //! the point of the first curve in the middle of its range. Where the range is one number and the kernel exact, it is the common point itself.
  const typename internal::Ambient_space<Kernel, d>::Point& point() const { return m_points[0].point(); }

  //! whether the common point is an end of the first (0) or second (1) curve, decided exactly; the seam of a closed curve is one.
  bool is_at_end(std::size_t curve) const { return m_is_at_end[curve]; }

  //! how often the common point counts; 1 when the curves cross, 0 when not known.
  int multiplicity() const { return m_solution.multiplicity(); }

  //! the answer of the solver, with its proof: the unknowns are the two parameters.
  const Solution_d<double>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDOperations

The intersections of two curves, those of one kind after another.
*/
template <SplineKernel Kernel, int d>
class Curve_intersections
{
  std::vector<Curve_intersection<Kernel, d>> m_intersections;
  Summary m_summary;

public:
  using const_iterator = typename std::vector<Curve_intersection<Kernel, d>>::const_iterator;

#ifndef DOXYGEN_RUNNING
  Curve_intersections(std::vector<Curve_intersection<Kernel, d>> intersections, const Summary& summary)
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
  const Curve_intersection<Kernel, d>& operator[](std::size_t i) const { return m_intersections[i]; }

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

namespace internal {

/*
The intersections of two curves: solutions of C1(u) = C2(v), told apart by what is known of the ends of the curves. Whether an end of one curve lies on the other one is a system in one
unknown, all of whose solutions are found exactly.
*/
template <SplineKernel Kernel, int d>
class Curve_intersector
{
  using Map = Spline_map<1, d>;
  using Solution = Solution_d<double>;
  using Box = Solution::Exact_box;
  using Range = std::pair<Exact_rational, Exact_rational>;
  using Parameter = std::array<Exact_rational, 1>;

  // An end of a curve, and a range of parameters of the other one that holds just one with this point.
  struct Incidence
  {
    std::size_t curve;
    bool is_upper;
    Exact_rational end;
    Range range;
  };

  std::array<Map, 2> m_curves;
  Subdivision_solver_d<Certified_solver_traits> m_solver;
  std::vector<Incidence> m_incidences;

public:
  Curve_intersector(const Map& c1, const Map& c2, const Solver_options& options)
    : m_curves{c1, c2}, m_solver(options)
  {}

  Curve_intersections<Kernel, d> operator()()
  {
    const auto [u, v] = parameters(m_curves[0], m_curves[1]);
    const Solution_set_d<double> solutions = m_solver(equality(m_curves[0](u), m_curves[1](v)));
    if (!solutions.empty())
      find_incidences();
    std::vector<Curve_intersection<Kernel, d>> result;
    for (const Solution& solution : solutions)
      if (auto intersection = classified(solution))
        result.push_back(std::move(*intersection));
    return Curve_intersections<Kernel, d>(std::move(result), solutions.summary());
  }

private:
  const Exact_rational& end(std::size_t curve, bool is_upper) const { return is_upper ? m_curves[curve].domain(0).second : m_curves[curve].domain(0).first; }
  std::array<Exact_rational, d> end_point(std::size_t curve, bool is_upper) const { return m_curves[curve](Parameter{end(curve, is_upper)}); }

  // Of points: an equation for each coordinate, without those in space that are satisfied anyway.
  static Constraint_system_d equality(const Vector_expression<d>& a, const Vector_expression<d>& b)
  {
    std::vector<Constraint> constraints;
    for (int i = 0; i < d; ++i)
      constraints.push_back(a[i] == b[i]);
    const auto trivial = std::find_if(constraints.begin(), constraints.end(), [](const Constraint& constraint) { return constraint.function.is_zero(); });
    if (d > 2 && trivial != constraints.end())
      constraints.erase(trivial);
    return make_system(constraints);
  }

  static Vector_expression<d> constant(const std::array<Exact_rational, d>& point)
  {
    return vector_of<d>([&](std::size_t i) { return Expression(point[i]); });
  }

  void find_incidences()
  {
    for (std::size_t i = 0; i < 2; ++i)
      for (const bool is_upper : {false, true}) {
        const auto [t] = parameters(m_curves[1 - i]);
        for (const Solution& solution : m_solver(equality(m_curves[1 - i](t), constant(end_point(i, is_upper)))))
          m_incidences.push_back({i, is_upper, end(i, is_upper), solution.exact_box()[0]});
      }
  }

  // The intersection that a solution stands for; none when it is a point on the seam of a closed curve with the second parameter of that point.
  std::optional<Curve_intersection<Kernel, d>> classified(const Solution& solution) const
  {
    Box box = solution.exact_box();
    Intersection_kind kind = kind_of(solution);
    std::array<bool, 2> is_at_end{false, false};
    bool is_repeated = false;
    if (is_one_point(solution)) {
      const Box region = solution.uniqueness_region().empty() ? box : solution.exact_uniqueness_region();
      for (const Incidence& incidence : m_incidences) {
        if (!meets(box, incidence))
          continue;
        if (!holds(region, incidence))
          return made(Intersection_kind::UNDECIDED, solution, box, {false, false});   // too close to tell
        const std::size_t i = incidence.curve;
        box[i] = {incidence.end, incidence.end};
        is_at_end[i] = true;
        is_repeated = is_repeated || (incidence.is_upper && m_curves[i].is_closed());
        if (kind != Intersection_kind::TANGENT)
          kind = Intersection_kind::END_POINT;
      }
    }
    if (is_repeated)
      return std::nullopt;
    return made(kind, solution, box, is_at_end);
  }

  static Intersection_kind kind_of(const Solution& solution)
  {
    switch (solution.kind()) {
    case Solution_kind::CERTIFIED: return Intersection_kind::TRANSVERSAL;
    case Solution_kind::CLUSTER: return Intersection_kind::TANGENT;
    case Solution_kind::CONTINUUM: return Intersection_kind::OVERLAP;
    case Solution_kind::UNDECIDED: break;
    }
    return Intersection_kind::UNDECIDED;
  }

  // With an incidence, a regular solution on the boundary of the domain is decided.
  static bool is_one_point(const Solution& solution)
  {
    return solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER || solution.reason() == Undecided_reason::DOMAIN_BOUNDARY;
  }

  static bool meets(const Box& box, const Incidence& incidence)
  {
    const Range &own = box[incidence.curve], &other = box[1 - incidence.curve];
    return own.first <= incidence.end && incidence.end <= own.second && other.first <= incidence.range.second && incidence.range.first <= other.second;
  }

  // Then the incidence is the only solution in the box.
  static bool holds(const Box& box, const Incidence& incidence)
  {
    const Range &own = box[incidence.curve], &other = box[1 - incidence.curve];
    return own.first <= incidence.end && incidence.end <= own.second && other.first <= incidence.range.first && incidence.range.second <= other.second;
  }

  Curve_intersection<Kernel, d> made(Intersection_kind kind, const Solution& solution, const Box& box, const std::array<bool, 2>& is_at_end) const
  {
    using Point = Point_on_spline<Kernel, 1, d>;
    return {kind, std::array<Point, 2>{Point(m_curves[0], {box[0]}), Point(m_curves[1], {box[1]})}, is_at_end, solution};
  }
};

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDOperations

all intersections of two curves in the plane: the solutions of \f$C_1(u) = C_2(v)\f$, each common point once.

Curves are taken exactly (doubles are rational numbers), and so are all decisions. A point on a knot is found once. A point on the seam of a closed curve, where two parameters stand
for it, is reported with the first of them. Whether a common point is an end of a curve is decided exactly: the end is put into the equations of the other curve. Overlaps have
exact parameter ranges where one parameter is a linear function of the other.

\tparam C1,C2 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param options those of the solver; a tolerance concerns only what remains undecided.
\throws Invalid_input when an option makes no sense.

Complexity: that of a system of two equations in two unknowns, and of four in one unknown. Source: \cgalCite{ek-gcs-01}, section 2.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_intersections<typename C1::Kernel, 2> intersections(const C1& c1, const C2& c2, const Solver_options& options = {})
{
  return internal::Curve_intersector<typename C1::Kernel, 2>(Spline_map<1, 2>(c1), Spline_map<1, 2>(c2), options)();
}

/*!
\ingroup PkgSplineConstraintsDOperations

all intersections of two curves in space, as those in the plane: three equations in two unknowns. That a point satisfies all of them is proved by exact signs, for points with irrational parameters too;
two curves that miss each other by however little do not meet. Curves that touch at irrational parameters stay undecided.

\tparam C1,C2 models of `ParametricCurve_3`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param options those of the solver; a tolerance concerns only what remains undecided.
\throws Invalid_input when an option makes no sense.
*/
template <ParametricCurve_3 C1, ParametricCurve_3 C2>
Curve_intersections<typename C1::Kernel, 3> intersections(const C1& c1, const C2& c2, const Solver_options& options = {})
{
  return internal::Curve_intersector<typename C1::Kernel, 3>(Spline_map<1, 3>(c1), Spline_map<1, 3>(c2), options)();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_INTERSECTIONS_H
