// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLUTION_SET_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLUTION_SET_D_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
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
\ingroup PkgSplineConstraintsDSolver

A point of a curve of solutions where it passes from one box to the next, or ends: on a plane where one unknown, or
several, have a known value; where an inequality is zero; or a singular point.
*/
struct Curve_vertex
{
  using Exact_box = std::vector<std::pair<Exact_rational, Exact_rational>>;

  //! a box that is proved to hold the point; the range of an unknown whose value is known exactly is one number.
  Exact_box box;

  //! whether the point lies on the boundary of the domain.
  bool is_on_boundary;

  //! whether it is a singular point, by proof the only one near it. The pieces that end there are all branches of the
  //! curves; at an isolated solution there are none.
  bool is_singular;

  //! whether an inequality is zero at the point, by proof. If it is a strict one, the point does not belong to the
  //! curves that end there.
  bool is_on_inequality;

  //! the middle of the box, rounded to doubles.
  std::vector<double> point() const
  {
    std::vector<double> result;
    for (const auto& [lower, upper] : box)
      result.push_back(to_nearest_double(Exact_rational((lower + upper) / 2)));
    return result;
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

A piece of a curve of solutions between two vertices. In its box the solutions are a graph over one of the unknowns: for
each value of it between those of the two ends the box holds exactly one solution that belongs to the piece, and no
other one.
*/
struct Curve_piece
{
  //! the box.
  Curve_vertex::Exact_box box;

  //! the unknown that the piece is a graph over; -1 for a piece that ends in a singular point, in whose box all pieces
  //! meet there and nowhere else.
  int parameter;

  //! indices of the vertices at its two ends, in the order along the curve.
  std::array<std::size_t, 2> ends;

  //! how often the equalities count the points between its ends. 1: their gradients are linearly independent there, by
  //! proof. More than 1: equalities are products with a power as a factor, the solutions of the system without the
  //! exponents are regular there, and this is the exponent, or the product of one of each equality; or it is the
  //! intersection multiplicity of two polynomials in three unknowns. 0: this is not known.
  int multiplicity = 1;
};

/*!
\ingroup PkgSplineConstraintsDSolver

A connected curve of solutions: a chain of pieces, each of which begins where the one before ends.
*/
struct Solution_curve
{
  //! the pieces, along the curve.
  std::vector<Curve_piece> pieces;

  //! whether the last piece ends where the first one begins, which is a regular point.
  bool is_closed;

  //! how often the equalities count its points, see `Curve_piece::multiplicity`; 0 where this is not known, or pieces
  //! differ.
  int multiplicity() const
  {
    const auto differs = [&](const Curve_piece& piece) { return piece.multiplicity != pieces.front().multiplicity; };
    return std::any_of(pieces.begin(), pieces.end(), differs) ? 0 : pieces.front().multiplicity;
  }

  //! indices of the vertices along the curve; of a closed curve the first one is not repeated.
  std::vector<std::size_t> vertices() const
  {
    std::vector<std::size_t> result;
    for (const Curve_piece& piece : pieces)
      result.push_back(piece.ends[0]);
    if (!is_closed)
      result.push_back(pieces.back().ends[1]);
    return result;
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

A part of the domain where nothing is proved of the solutions, but for what happens on its boundary: a singular point of
higher order at irrational coordinates, as a rule.
*/
struct Undecided_region
{
  //! boxes that are connected.
  std::vector<Curve_vertex::Exact_box> boxes;

  //! indices of the vertices where curves reach the region.
  std::vector<std::size_t> vertices;

  //! why it is undecided.
  Undecided_reason reason;
};

namespace internal {

// The box around the boxes of a region, rounded to doubles.
template <class Region>
std::vector<Undecided_part::Range> ranges_of(const Region& region)
{
  std::vector<Undecided_part::Range> result;
  for (std::size_t j = 0; j < region.boxes.front().size(); ++j) {
    Undecided_part::Range range = to_double_range(region.boxes.front()[j]);
    for (const Curve_vertex::Exact_box& box : region.boxes) {
      const auto [lower, upper] = to_double_range(box[j]);
      range = {(std::min)(range.first, lower), (std::max)(range.second, upper)};
    }
    result.push_back(range);
  }
  return result;
}

// Undecided regions, with the box around each.
template <class Region>
std::vector<Undecided_part> parts_of_regions(const std::vector<Region>& regions)
{
  std::vector<Undecided_part> result;
  for (const Region& region : regions)
    result.push_back({ranges_of(region), {}, in_words(region.reason)});
  return result;
}

template <class Curve>
std::size_t number_of_closed(const std::vector<Curve>& curves)
{
  return static_cast<std::size_t>(
      std::count_if(curves.begin(), curves.end(), [](const Curve& curve) { return curve.is_closed; }));
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

All solutions of a system with one equality less than unknowns: curves, whose topology is proved.
*/
class Curve_solution_set_d
{
  std::vector<Curve_vertex> m_vertices;
  std::vector<Solution_curve> m_curves;
  std::vector<std::size_t> m_points;
  std::vector<std::size_t> m_singular_points;
  std::vector<Undecided_region> m_undecided;
  Summary m_summary;

public:
  //! these curves and points, whose vertices are indices into `vertices`, and what is undecided; with the work.
  Curve_solution_set_d(std::vector<Curve_vertex> vertices, std::vector<Solution_curve> curves,
                       std::vector<std::size_t> points, std::vector<std::size_t> singular_points,
                       std::vector<Undecided_region> undecided, const Summary& summary)
    : m_vertices(std::move(vertices)), m_curves(std::move(curves)), m_points(std::move(points)),
      m_singular_points(std::move(singular_points)), m_undecided(std::move(undecided)), m_summary(summary)
  {}

  //! the curves. An open curve ends on the boundary of the domain, where an inequality is zero, at a singular point or
  //! at an undecided region.
  const std::vector<Solution_curve>& curves() const { return m_curves; }

  //! the vertices of all curves, which pieces refer to by their indices.
  const std::vector<Curve_vertex>& vertices() const { return m_vertices; }

  //! indices of the vertices that are single points: no other solution is near them, since a curve of solutions of the
  //! equalities only touches the domain, or what the inequalities allow, from outside. Isolated solutions of the
  //! equalities are singular points.
  const std::vector<std::size_t>& points() const { return m_points; }

  //! indices of the vertices that are singular points: where curves cross or touch each other, cusps, and isolated
  //! solutions.
  const std::vector<std::size_t>& singular_points() const { return m_singular_points; }

  //! where nothing is proved, with the boxes and the curves that end there.
  const std::vector<Undecided_region>& undecided_regions() const { return m_undecided; }

  //! the same regions, with the box around each.
  std::vector<Undecided_part> undecided() const
  {
    return internal::parts_of_regions(m_undecided);
  }

  //! number of closed curves.
  std::size_t number_of_closed_curves() const { return internal::number_of_closed(m_curves); }

  //! number of curves that are not closed.
  std::size_t number_of_open_curves() const { return m_curves.size() - number_of_closed_curves(); }

  //! whether all solutions lie on the curves and are points or singular points, by proof: nothing is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

namespace internal {

// The one line that says what a set of curves has, and how complete it is. Of an incomplete one, counts are least
// numbers, and curves that are not closed may be parts of the same one, or of a closed one.
template <class Curve_set>
std::ostream& write_counts(std::ostream& out, const Curve_set& set)
{
  const bool is_complete = set.is_complete();
  const char* const least = is_complete ? "" : "at least ";
  return out << "curves: " << least << set.number_of_closed_curves() << " closed, " << set.number_of_open_curves()
             << (is_complete ? " open, " : " open or parts of curves, ") << least << set.points().size() << " points, "
             << least << set.singular_points().size() << " singular points, " << set.undecided().size()
             << " undecided; complete: " << (is_complete ? "yes" : "no") << "; nodes " << set.summary().nodes
             << "; seconds " << set.summary().seconds;
}

} // namespace internal

//! \ingroup PkgSplineConstraintsDSolver
//! writes one line: the numbers of curves, single points, singular points and undecided regions. Where some are
//! undecided, the others are said to be least numbers, and open curves perhaps parts of others.
inline std::ostream& operator<<(std::ostream& out, const Curve_solution_set_d& set)
{
  return internal::write_counts(out, set);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLUTION_SET_D_H
