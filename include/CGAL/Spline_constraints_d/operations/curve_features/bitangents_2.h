// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_BITANGENTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_BITANGENTS_2_H

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_on_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

A line that is tangent to two curves, or to one curve twice.
*/
template <SplineKernel Kernel>
class Bitangent_2
{
  std::array<Point_on_spline<Kernel, 1, 2>, 2> m_contacts;
  Solution_d<double> m_solution;

public:
  //! a line with these contacts.
  Bitangent_2(std::array<Point_on_spline<Kernel, 1, 2>, 2> contacts, Solution_d<double> solution)
    : m_contacts(std::move(contacts)), m_solution(std::move(solution))
  {}

  //! the point where it touches the first (0) or second (1) curve; of one curve, the contact with the smaller (0) or
  //! larger (1) parameter.
  const Point_on_spline<Kernel, 1, 2>& contact(std::size_t curve) const { return m_contacts[curve]; }

  //! the answer of the solver, with its proof: the unknowns are the two parameters. Nothing is proved of an `UNDECIDED`
  //! one.
  const Solution_d<double>& solution() const { return m_solution; }
};

/*!
\ingroup PkgSplineConstraintsDCurveFeatures

The bitangents of two curves or of one.
*/
template <SplineKernel Kernel>
class Bitangents_2 : public Answer_list<Bitangent_2<Kernel>>
{
public:
  using Answer_list<Bitangent_2<Kernel>>::Answer_list;

  //! what was found: certified ones, clusters, families (a `CONTINUUM`), and what is undecided.
  const std::vector<Bitangent_2<Kernel>>& bitangents() const { return this->answers(); }
};

namespace internal {
namespace Curve_features {

template <class Kernel>
class Bitangent_finder
{
  using Range = std::pair<Exact_rational, Exact_rational>;
  using Region = std::array<Range, 2>;
  using Contact = Point_on_spline<Kernel, 1, 2>;

  // Two arcs about a common end of them such that no line is tangent to both.
  using Joint = Region;

  const std::array<const Planar_map*, 2> m_curves;
  Budgeted_solver m_solve;
  std::vector<Bitangent_2<Kernel>> m_found;
  std::vector<Undecided_part> m_undecided;
  bool m_is_stopped = false;

public:
  Bitangent_finder(const Planar_map& first, const Planar_map& second, const Solver_options& options)
    : m_curves{&first, &second}, m_solve(options)
  {}

  // Those of two curves.
  Bitangents_2<Kernel> between()
  {
    const std::vector<Smooth_part> second_parts = smooth_parts(*m_curves[1]);
    for (const Smooth_part& first : smooth_parts(*m_curves[0]))
      for (const Smooth_part& second : second_parts)
        solve_pair(first, second, whole(first, second));
    return {std::move(m_found), std::move(m_undecided), m_solve.total()};
  }

  // Those of the first curve with itself: of each polynomial piece, and of each two of them without the corners where
  // they meet.
  Bitangents_2<Kernel> within()
  {
    const std::vector<Smooth_part> pieces = smooth_parts(*m_curves[0], [](const auto&, const auto&) { return false; });
    const std::size_t n = pieces.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n && !ends(); ++j) {
        std::vector<Joint> joints;
        if (j == i + 1)
          append(joints, curved_joint(pieces[i], pieces[j], false));
        if (i == 0 && j + 1 == n && m_curves[0]->is_closed())
          append(joints, curved_joint(pieces[j], pieces[i], true));
        for (const Region& region : without(whole(pieces[i], pieces[j]), joints))
          i == j ? solve_piece(pieces[i], region) : solve_pair(pieces[i], pieces[j], {region});
      }
    return {std::move(m_found), std::move(m_undecided), m_solve.total()};
  }

private:
  static std::vector<Region> whole(const Smooth_part& first, const Smooth_part& second)
  {
    return {{first.curve.map().domain(0), second.curve.map().domain(0)}};
  }

  static std::vector<Unknown> unknowns_in(const Region& region)
  {
    return unknowns(std::vector<std::array<Bound, 2>>{{Bound(region[0].first), Bound(region[0].second)},
                                                      {Bound(region[1].first), Bound(region[1].second)}});
  }

  // C1'(u) x C2'(v) = 0 and C1'(u) x (C1(u) - C2(v)) = 0, which both hold as well where a derivative is zero.
  void solve_pair(const Smooth_part& first, const Smooth_part& second, const std::vector<Region>& regions)
  {
    for (const Region& region : regions) {
      if (ends())
        return;
      const std::vector<Unknown> u = unknowns_in(region);
      const Vector_expression<2> tangent = first.curve(1, u[0]), chord = first.curve(0, u[0]) - second.curve(0, u[1]);
      std::vector<Constraint> constraints{cross(tangent, second.curve(1, u[1])) == 0, cross(tangent, chord) == 0,
                                          squared_norm(chord) != 0};
      add_ends(constraints, {&first, &second}, region, u);
      report(m_solve(constraints));
    }
  }

  /*
  With the chord D = C(u) - C(v), H = (C'(u) x D)/(u-v)^2 and G = (C'(u) x C'(v))/(u-v) are polynomials, and H = -C' x
  C''/2, G = -C' x C'' where u = v: at inflections both are zero. But G - 2H is zero on all of u = v, so that it can be
  divided by u - v once more, which gives C' x C'''/6.
  */
  void solve_piece(const Smooth_part& piece, const Region& region)
  {
    if (ends())
      return;
    const std::vector<Unknown> u = unknowns_in(region);
    const Vector_expression<2> tangent = piece.curve(1, u[0]);
    const Expression between = u[0] - u[1];
    const Expression chord = divided_exactly(cross(tangent, piece.curve(0, u[0]) - piece.curve(0, u[1])), between, 2);
    const Expression turn = divided_exactly(cross(tangent, piece.curve(1, u[1])), between);
    std::vector<Constraint> constraints{chord == 0, divided_exactly(turn - 2 * chord, between) == 0, u[0] < u[1]};
    if (constraints[0].function.is_zero())
      return;   // straight
    add_ends(constraints, {&piece, &piece}, region, u);
    report(m_solve(constraints));
  }

  // Ends that count on the next part or region.
  static void add_ends(std::vector<Constraint>& constraints, const std::array<const Smooth_part*, 2>& parts,
                       const Region& region, const std::vector<Unknown>& u)
  {
    for (std::size_t i = 0; i < 2; ++i)
      if (!parts[i]->has_end || region[i].second != parts[i]->curve.end())
        constraints.push_back(u[i] < region[i].second);
  }

  void report(const Solution_set_d<double>& solutions)
  {
    for (const Solution_d<double>& solution : solutions) {
      const auto box = solution.exact_box();
      m_found.emplace_back(std::array<Contact, 2>{Contact(*m_curves[0], {box[0]}), Contact(*m_curves[1], {box[1]})},
                           solution);
      if (solution.kind() == Solution_kind::UNDECIDED)
        add_undecided({box[0], box[1]}, solution.reason());
    }
  }

  // Whether the run ends, so that what follows is undecided: one part stands for it.
  bool ends()
  {
    if (!m_solve.must_stop())
      return false;
    if (!std::exchange(m_is_stopped, true))
      add_undecided({m_curves[0]->domain(0), m_curves[1]->domain(0)}, m_solve.reason());
    return true;
  }

  void add_undecided(const Region& region, Undecided_reason reason)
  {
    const std::size_t second = m_curves[0] == m_curves[1] ? 0 : 1;
    m_undecided.push_back(
        undecided_on_curves({{*m_curves[0], 0, region[0]}, {*m_curves[1], second, region[1]}}, in_words(reason)));
  }

  static void append(std::vector<Joint>& joints, std::vector<Joint> more)
  {
    joints.insert(joints.end(), more.begin(), more.end());
  }

  /*
  Arcs of two pieces on both sides of their common end that are graphs over the tangent there, and curved everywhere. If
  both are curved to the same side, no two tangents of theirs have the same direction; if to different ones, tangents of
  one pass below the common end and those of the other one above it. Nothing when no such arcs are found, as where the
  curvature is zero at the end.
  */
  std::vector<Joint> curved_joint(const Smooth_part& before, const Smooth_part& after, bool is_seam)
  {
    if (!have_common_tangent(before.curve, after.curve))
      return {};
    const Differentiated_map a(before.curve.map(), 2), b(after.curve.map(), 2);
    const Exact_pair direction = a.at(1, a.end());
    if (sign_of(exact_cross(direction, a.at(2, a.end()))) == 0 ||
        sign_of(exact_cross(b.at(1, b.begin()), b.at(2, b.begin()))) == 0)
      return {};
    Exact_rational share = Exact_rational(5) / 16;
    for (int halvings = 0; halvings < 20; ++halvings, share /= 2) {
      const Range end{Exact_rational(a.end() - share * (a.end() - a.begin())), a.end()},
          begin{b.begin(), Exact_rational(b.begin() + share * (b.end() - b.begin()))};
      if (is_curved(a, end, direction) && is_curved(b, begin, direction))
        return {is_seam ? Joint{begin, end} : Joint{end, begin}};
    }
    return {};
  }

  bool is_curved(const Differentiated_map& piece, const Range& range, const Exact_pair& direction)
  {
    const std::vector<Unknown> u = unknowns({{Bound(range.first), Bound(range.second)}});
    const Vector_expression<2> tangent = piece(1, u[0]);
    const Vector_expression<2> forward(direction[0], direction[1]);
    return m_solve({cross(tangent, piece(2, u[0])) == 0}).empty() && m_solve({dot(tangent, forward) == 0}).empty();
  }

  static std::vector<Region> without(std::vector<Region> regions, const std::vector<Joint>& joints)
  {
    for (const Joint& joint : joints) {
      std::vector<Region> parts;
      for (const Region& region : regions) {
        const auto [inside, outside] = cut(region[0], joint[0]);
        for (const Range& u : outside)
          parts.push_back({u, region[1]});
        for (const Range& u : inside)
          for (const Range& v : cut(region[1], joint[1]).second)
            parts.push_back({u, v});
      }
      regions = std::move(parts);
    }
    return regions;
  }

  // The parts of a range inside and outside of another one.
  static std::pair<std::vector<Range>, std::vector<Range>> cut(const Range& range, const Range& by)
  {
    std::pair<std::vector<Range>, std::vector<Range>> result;
    const Range inside{(std::max)(range.first, by.first), (std::min)(range.second, by.second)};
    if (inside.first >= inside.second)
      return {{}, {range}};
    result.first.push_back(inside);
    if (range.first < inside.first)
      result.second.push_back({range.first, inside.first});
    if (inside.second < range.second)
      result.second.push_back({inside.second, range.second});
    return result;
  }
};

} // namespace Curve_features
} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDCurveFeatures
@{
*/

/*!
all lines that are tangent to two curves at two different points: the solutions of
\f[ C_1'(u) \times C_2'(v) = 0, \quad C_1'(u) \times (C_1(u) - C_2(v)) = 0, \quad C_1(u) \neq C_2(v). \f]
The inequality excludes the points where the curves touch.

A curve is split where its derivative jumps; at a corner the tangents of both sides count. A contact at the seam of a
closed curve that has a tangent there, or at another such break, is reported with one parameter. Where the derivative of
a curve vanishes, at a cusp, every tangent of the other one satisfies the first equation: such points come back as
families, or undecided. So does the line of a straight piece that is tangent to the other curve, as all points of the
piece are contacts.

\tparam C1,C2 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: a system of two equations in two unknowns for each two smooth parts.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Bitangents_2<typename C1::Kernel> bitangents(const C1& c1, const C2& c2, const Solver_options& options = {})
{
  const internal::Planar_map first(c1), second(c2);
  return internal::Curve_features::Bitangent_finder<typename C1::Kernel>(first, second, options).between();
}

/*!
all lines that are tangent to a curve at two different points, each once.

On one polynomial piece, \f$u = v\f$ satisfies the equations. It is divided out exactly, in such a way that inflections
are no solutions either: of
\f$H = C'(u) \times (C(u)-C(v)) / (u-v)^2\f$ and \f$G = C'(u) \times C'(v) / (u-v)\f$ the system \f$H = 0\f$, \f$(G -
2H)/(u-v) = 0\f$, \f$u < v\f$ is solved, whose second function is \f$C' \times C'''/6\f$ on the diagonal. Two pieces
with a common end are solved without two arcs around it that are proved to be curved everywhere, so that no line is
tangent to both. Where the curvature is zero at the end of one of the pieces, there are none, and the common end may
come back undecided.

Straight pieces are not reported as tangent to themselves; one that goes on smoothly into another piece is a family.

\tparam Curve a model of `ParametricCurve_2`.
\param curve the curve.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: \f$n(n+1)/2\f$ systems of two equations in two unknowns for \f$n\f$ polynomial pieces.
*/
template <ParametricCurve_2 Curve>
Bitangents_2<typename Curve::Kernel> bitangents(const Curve& curve, const Solver_options& options = {})
{
  const internal::Planar_map map(curve);
  return internal::Curve_features::Bitangent_finder<typename Curve::Kernel>(map, map, options).within();
}

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_BITANGENTS_2_H
