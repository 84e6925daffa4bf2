// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_TANGENT_CIRCLES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_TANGENT_CIRCLES_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/reason_of.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Circle_emptiness.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

Whether the open disk of a circle holds a point of the three curves that it touches.
*/
enum class Emptiness {
  /// it holds none, by proof: the center is at the same distance from the three curves, a point of their skeleton
  EMPTY,
  NOT_EMPTY,   ///< it holds one, by proof
  UNDECIDED    ///< neither is proved
};

//! \ingroup PkgSplineConstraintsDCurveFeatures
//! writes `empty`, `not empty` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Emptiness emptiness)
{
  static const char* const names[] = {"empty", "not empty", "undecided"};
  return out << names[static_cast<int>(emptiness)];
}

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A circle that is tangent to three curves.
*/
template <SplineKernel Kernel>
class Tangent_circle_2
{
public:
  //! a closed range of numbers; its ends are infinite where nothing is known.
  using Range = std::pair<double, double>;

private:
  std::array<Point_on_spline<Kernel, 1, 2>, 3> m_contacts;
  std::array<Range, 2> m_center;
  Range m_squared_radius;
  Emptiness m_emptiness;
  Solution_d<double> m_solution;

public:
  //! a circle that an operation has found.
  Tangent_circle_2(std::array<Point_on_spline<Kernel, 1, 2>, 3> contacts,
                   const internal::Distances::Enclosed_circle& circle, Emptiness emptiness, Solution_d<double> solution)
    : m_contacts(std::move(contacts)), m_center{circle.center[0].pair(), circle.center[1].pair()},
      m_squared_radius(circle.squared_radius.pair()), m_emptiness(emptiness), m_solution(std::move(solution))
  {}

  //! the point where it touches the first (0), second (1) or third (2) curve.
  const Point_on_spline<Kernel, 1, 2>& contact(std::size_t curve) const { return m_contacts[curve]; }

  //! a range of the \f$x\f$ (0) or \f$y\f$ (1) coordinate of the center.
  const Range& center_range(std::size_t axis) const { return m_center[axis]; }

  //! a range of the square of the radius.
  const Range& squared_radius_range() const { return m_squared_radius; }

  //! the middle of the range of a coordinate of the center; none where the range is infinite.
  std::optional<double> center(std::size_t axis) const { return middle_of(m_center[axis]); }

  //! the radius: the root of the middle of the range of its square; none where that is infinite.
  std::optional<double> radius() const
  {
    const std::optional<double> square = middle_of(m_squared_radius);
    return square ? std::optional(std::sqrt(*square)) : std::nullopt;
  }

  //! what is proved of the disk.
  Emptiness emptiness() const { return m_emptiness; }

  //! the answer of the solver, with its proof: the unknowns are the three parameters, and \f$a\f$ or \f$b\f$ as
  //! explained at `tangent_circles()`. Nothing is proved of an `UNDECIDED` one.
  const Solution_d<double>& solution() const { return m_solution; }

private:
  static std::optional<double> middle_of(const Range& range)
  {
    const double middle = range.first / 2 + range.second / 2;
    return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
  }
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

The circles that are tangent to three curves.
*/
template <SplineKernel Kernel>
class Tangent_circles_2 : public Answer_list<Tangent_circle_2<Kernel>>
{
public:
  using Answer_list<Tangent_circle_2<Kernel>>::Answer_list;

  //! what was found: certified ones, clusters, families (a `CONTINUUM`), and what is undecided.
  const std::vector<Tangent_circle_2<Kernel>>& circles() const { return this->answers(); }

  //! number of circles with this known of their disks.
  std::size_t count(Emptiness emptiness) const
  {
    return static_cast<std::size_t>(
        std::count_if(this->begin(), this->end(), [=](const auto& circle) { return circle.emptiness() == emptiness; }));
  }
};

namespace internal {
namespace Curve_features {

template <class Kernel>
class Tangent_circle_finder
{
  using Parts = std::array<const Smooth_part*, 3>;
  using Exact_box = Solution_d<double>::Exact_box;

  // The center is C1 + a N, with a normal N, in the direct form, and C1 + N / b in the reciprocal one.
  enum class Form { DIRECT, RECIPROCAL };

  std::array<Planar_map, 3> m_curves;
  std::array<std::vector<Homogeneous_piece>, 3> m_pieces;
  Exact_rational m_scale;   // of the normal: the length of the domain
  Budgeted_solver m_solve;
  std::vector<Tangent_circle_2<Kernel>> m_found;
  std::vector<Undecided_part> m_undecided;

public:
  template <class C1, class C2, class C3>
  Tangent_circle_finder(const C1& c1, const C2& c2, const C3& c3, const Solver_options& options)
    : m_curves{Planar_map(c1), Planar_map(c2), Planar_map(c3)}, m_pieces{homogeneous_pieces(c1, m_curves[0]),
                                                                         homogeneous_pieces(c2, m_curves[1]),
                                                                         homogeneous_pieces(c3, m_curves[2])},
      m_scale(m_curves[0].domain(0).second - m_curves[0].domain(0).first), m_solve(options)
  {}

  Tangent_circles_2<Kernel> operator()()
  {
    const std::vector<Smooth_part> first = smooth_parts(m_curves[0]), second = smooth_parts(m_curves[1]),
                                   third = smooth_parts(m_curves[2]);
    for (const Smooth_part& a : first)
      for (const Smooth_part& b : second)
        for (const Smooth_part& c : third) {
          if (m_solve.must_stop()) { // one part stands for all that follows
            add_undecided({m_curves[0].domain(0), m_curves[1].domain(0), m_curves[2].domain(0)},
                          in_words(m_solve.reason()));
            return result();
          }
          solve({&a, &b, &c});
        }
    return result();
  }

private:
  Tangent_circles_2<Kernel> result() { return {std::move(m_found), std::move(m_undecided), m_solve.total()}; }

  void add_undecided(const std::array<Parameter_range, 3>& ranges, std::string reason)
  {
    m_undecided.push_back(undecided_on_curves(
        {{m_curves[0], 0, ranges[0]}, {m_curves[1], 1, ranges[1]}, {m_curves[2], 2, ranges[2]}}, std::move(reason)));
    m_undecided.back().place.clear(); // centers may be anywhere
  }

  // Ranges that overlap, so that no circle is at the end of both; what is found twice is reported once.
  static Exact_rational limit() { return Exact_rational(17) / 16; }

  void solve(const Parts& parts)
  {
    std::vector<const Solution_d<double>*> on_the_limit;
    const Solution_set_d<double> direct = m_solve(constraints(parts, Form::DIRECT)),
                                 reciprocal = m_solve(constraints(parts, Form::RECIPROCAL));
    for (const Solution_d<double>& solution : direct) {
      const auto [lower, upper] = solution.exact_box()[3];
      if (lower > 1 || upper < -1)
        continue;
      if (upper >= 1 || lower <= -1)
        on_the_limit.push_back(&solution);
      report(solution, parts, Form::DIRECT);
    }
    for (const Solution_d<double>& solution : reciprocal) {
      const auto [lower, upper] = solution.exact_box()[3];
      if (!(lower >= 1 || upper <= -1) &&
          std::none_of(on_the_limit.begin(), on_the_limit.end(),
                       [&](const auto* known) { return is_same(*known, solution); }))
        report(solution, parts, Form::RECIPROCAL);
    }
  }

  // |P - Ck|^2 = |P - C1|^2, which is linear in a, and <P - Ck, Ck'> = 0, for the second and third curve; with a = 1/b
  // multiplied by b.
  std::vector<Constraint> constraints(const Parts& parts, Form form) const
  {
    std::vector<std::array<Bound, 2>> ranges;
    for (const Smooth_part* part : parts)
      ranges.push_back({Bound(part->curve.begin()), Bound(part->curve.end())});
    ranges.push_back({Bound(Exact_rational(-limit())), Bound(limit())});
    const std::vector<Unknown> u = unknowns(ranges);
    const Expression a = form == Form::DIRECT ? Expression(u[3]) : Expression(1),
                     b = form == Form::DIRECT ? Expression(1) : Expression(u[3]);

    const Vector_expression<2> point = parts[0]->curve(0, u[0]),
                               normal = perpendicular(parts[0]->curve(1, u[0])) * Expression(m_scale);
    std::vector<Constraint> result;
    for (std::size_t k = 1; k < 3; ++k) {
      const Vector_expression<2> chord = parts[k]->curve(0, u[k]) - point;
      result.push_back(b * squared_norm(chord) == 2 * a * dot(normal, chord));
      result.push_back(dot(a * normal - b * chord, parts[k]->curve(1, u[k])) == 0);
    }
    result.push_back(u[3] != 0);
    for (std::size_t k = 0; k < 3; ++k)
      if (!parts[k]->has_end)
        result.push_back(u[k] < parts[k]->curve.end());
    return result;
  }

  // Whether a solution of the reciprocal form lies where the direct form has just one.
  static bool is_same(const Solution_d<double>& direct, const Solution_d<double>& reciprocal)
  {
    const Exact_box region = direct.exact_uniqueness_region();
    Exact_box box = reciprocal.exact_box();
    if (region.empty() || sign_of(box[3].first) * sign_of(box[3].second) <= 0)
      return false;
    box[3] = {Exact_rational(1 / box[3].second), Exact_rational(1 / box[3].first)};
    for (std::size_t k = 0; k < box.size(); ++k)
      if (box[k].first < region[k].first || region[k].second < box[k].second)
        return false;
    return true;
  }

  void report(const Solution_d<double>& solution, const Parts& parts, Form form)
  {
    using Contact = Point_on_spline<Kernel, 1, 2>;
    Exact_box box = solution.exact_box();
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = {std::clamp(box[k].first, parts[k]->curve.begin(), parts[k]->curve.end()),
                std::clamp(box[k].second, parts[k]->curve.begin(), parts[k]->curve.end())};
    std::array<Contact, 3> contacts{Contact(m_curves[0], {box[0]}), Contact(m_curves[1], {box[1]}),
                                    Contact(m_curves[2], {box[2]})};
    const Upward_rounding_guard guard;
    const Enclosed_circle circle = enclosed(contacts[0].parameter_range(), box[3], form);
    const bool is_known = solution.kind() == Solution_kind::CERTIFIED || solution.kind() == Solution_kind::CLUSTER;
    if (solution.kind() == Solution_kind::UNDECIDED)
      add_undecided({box[0], box[1], box[2]}, reason_of(solution));
    m_found.emplace_back(std::move(contacts), circle, is_known ? emptiness(circle, box, parts) : Emptiness::UNDECIDED,
                         solution);
  }

  // The circle of a range of parameters on the first curve and a range of a or b.
  Enclosed_circle enclosed(const Parameter_range& u, const Parameter_range& factor, Form form) const
  {
    const Interval a =
        (form == Form::DIRECT ? interval_of(factor) : Interval(1) / interval_of(factor)) * interval_of(m_scale);
    Enclosed_circle result;
    bool is_first = true;
    for (const Homogeneous_piece& piece : m_pieces[0]) {
      const Exact_rational begin = (std::max)(u.first, piece.domain.first),
                           end = (std::min)(u.second, piece.domain.second);
      if (begin > end)
        continue;
      const auto [point, tangent] = point_and_tangent(piece, {begin, end});
      const Interval x = point[0] - a * tangent[1], y = point[1] + a * tangent[0],
                     r = CGAL::square(a) * (CGAL::square(tangent[0]) + CGAL::square(tangent[1]));
      result = is_first
          ? Enclosed_circle{{x, y}, r}
          : Enclosed_circle{{hull(result.center[0], x), hull(result.center[1], y)}, hull(result.squared_radius, r)};
      is_first = false;
    }
    return result;
  }

  static Interval hull(const Interval& a, const Interval& b)
  {
    return Interval((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
  }

  static std::pair<std::array<Interval, 2>, std::array<Interval, 2>> point_and_tangent(const Homogeneous_piece& piece,
                                                                                       const Parameter_range& range)
  {
    const Exact_rational begin = piece.local(range.first), end = piece.local(range.second);
    const auto bounded = [&](const Bernstein_tensor<Exact_rational>& tensor) {
      return interval_of(tensor.restricted(0, begin, end).bounds());
    };
    const auto& w = piece.coordinates[2];
    const Interval weight = bounded(w),
                   speed = Interval(1) / interval_of(Exact_rational(piece.domain.second - piece.domain.first));
    std::pair<std::array<Interval, 2>, std::array<Interval, 2>> result;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& x = piece.coordinates[k];
      result.first[k] = bounded(x) / weight;
      result.second[k] = bounded(x.derivative(0) * w - x * w.derivative(0)) / CGAL::square(weight) * speed;
    }
    return result;
  }

  Emptiness emptiness(const Enclosed_circle& circle, const Exact_box& box, const Parts& parts) const
  {
    if (!std::isfinite(circle.center[0].sup() - circle.center[0].inf()) ||
        !std::isfinite(circle.center[1].sup() - circle.center[1].inf()))
      return Emptiness::UNDECIDED;
    CGAL::Uncertain<bool> is_empty = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_empty = is_empty & Circle_emptiness(m_pieces[k], circle)(box[k], parts[k]->curve.map().domain(0));
    return !is_empty.is_certain() ? Emptiness::UNDECIDED
        : is_empty.make_certain() ? Emptiness::EMPTY
                                  : Emptiness::NOT_EMPTY;
  }
};

} // namespace Curve_features
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

all circles that are tangent to three curves in the plane, wherever their centers are.

With the normal \f$N = l\,(-y_1', x_1')\f$ of the first curve, \f$l\f$ being the length of its domain, the center is
\f$P = C_1(u) + a N(u)\f$, and the circle touches \f$C_2\f$ at
\f$v\f$ and \f$C_3\f$ at \f$w\f$ if
\f[ \|C_k - C_1\|^2 = 2a\,\langle N, C_k - C_1\rangle, \quad \langle a N - (C_k - C_1), C_k'\rangle = 0, \quad k = 2, 3,
\f] four equations in \f$u, v, w, a\f$ that are linear in \f$a\f$. They are solved for \f$\vert a\vert \le 1\f$, and
with \f$b = 1/a\f$ for \f$\vert b\vert < 1\f$, so no circle is too large. Lines (\f$b = 0\f$) and points where the three
curves meet (\f$a = 0\f$) are excluded. A circle through a point where two of the curves touch is a multiple solution, a
cluster or undecided.

Each disk is proved to be empty or not where this is possible in double precision. It is undecided where the circle
touches a curve at another point, too, or at a corner, or has the curvature of a curve at the contact.

A curve is split where its derivative jumps. A contact at the seam of a closed curve that has a tangent there, or at
another such break, is reported with one parameter. Ends and corners are no contacts, but count when a disk is empty or
not. Where the derivative of a curve is zero, families of circles come back that pass through the cusp.

\tparam C1,C2,C3 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param c3 the third curve.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: two systems of four equations in four unknowns for each three smooth parts. Source: \cgalCite{ek-gcs-01},
section 3.2.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2, ParametricCurve_2 C3>
Tangent_circles_2<typename C1::Kernel> tangent_circles(const C1& c1, const C2& c2, const C3& c3,
                                                       const Solver_options& options = {})
{
  return internal::Curve_features::Tangent_circle_finder<typename C1::Kernel>(c1, c2, c3, options)();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_TANGENT_CIRCLES_2_H
