// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_CURVES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// The system of one polynomial that is to vanish, on the unit box.
inline Constraint_system_d system_of_zeros(const std::vector<Cell_polynomial>& polynomials)
{
  Constraint_system_d result(Curve_vertex::Exact_box(2, {0, 1}));
  for (const Cell_polynomial& f : polynomials)
    result.add(Spline_function::from_bernstein({0, 1}, f), Relation::EQUAL);
  return result;
}

// Pieces of curves in the unit box with the points of their chords.
struct Cell_curves
{
  struct Piece
  {
    Curve_piece piece;             // with its ends in `vertices`
    std::size_t curve, polynomial; // their indices
    std::vector<std::vector<double>> points;
  };

  std::vector<Curve_vertex> vertices = {};
  std::vector<Piece> pieces = {};
  std::size_t number_of_curves = 0, number_of_polynomials = 0, number_of_crossings = 0;

  // Adds the curves of a polynomial with chords that are so near to them.
  void add(const Constraint_system_d& system, const Curve_solution_set_d& set, double error,
           const Operation_budget& budget)
  {
    using Sample = Curve_sample<std::vector<double>>;
    Curve_sampler sampler(system);
    const auto image = [](const std::vector<double>& p) { return p; };
    const auto is_chord = [error](const Sample& from, const Sample& sample, const Sample& to) {
      return distance_from_middle(from.image, sample.image, to.image) <= error;
    };
    const std::size_t first = vertices.size();
    vertices.insert(vertices.end(), set.vertices().begin(), set.vertices().end());
    for (const Solution_curve& curve : set.curves()) {
      for (Curve_piece piece : curve.pieces) {
        budget.check();
        const auto end = [&](int i) {
          const std::vector<double> p = set.vertices()[piece.ends[i]].point();
          return Sample{p, p};
        };
        std::vector<Sample> samples{end(0)};
        sampler.append(samples, piece, Sample(samples.front()), end(1), image, is_chord);
        piece.ends = {first + piece.ends[0], first + piece.ends[1]};
        pieces.push_back({piece, number_of_curves, number_of_polynomials, {}});
        for (const Sample& sample : samples)
          pieces.back().points.push_back(sample.image);
      }
      ++number_of_curves;
    }
    ++number_of_polynomials;
  }
};

/*
Finds curves of several polynomials that are arcs from one point of the sides of the unit box to another, of which each
two have one point in common at most, a simple zero of both polynomials. The common points are among the points of the
chords of both. Two such arcs cross in such a point, and the order of their ends on the sides of the box tells from
which side. So chords that have the same ends and the same common points in the same order, and no others, have the same
faces.
*/
class Crossing_arcs
{
  Operation_budget& m_budget;
  double m_error;
  Cell_curves m_curves;
  std::vector<std::size_t> m_first_piece; // of each polynomial

public:
  Crossing_arcs(double error, Operation_budget& budget) : m_budget(budget), m_error(error) {}

  // Nothing if curves are others, or that is not proved.
  std::optional<Cell_curves> operator()(const std::vector<Cell_polynomial>& polynomials)
  {
    for (const Cell_polynomial& f : polynomials) {
      const Constraint_system_d system = system_of_zeros({f});
      const Curve_solution_set_d set = curves_within_budget(system, m_budget, {});
      if (!set.is_complete() || !std::ranges::all_of(set.curves(), [&](const auto& c) { return is_arc(set, c); }))
        return std::nullopt;
      m_first_piece.push_back(m_curves.pieces.size());
      m_curves.add(system, set, m_error, m_budget);
    }
    m_first_piece.push_back(m_curves.pieces.size());
    for (std::size_t i = 0; i < polynomials.size(); ++i)
      for (std::size_t j = i + 1; j < polynomials.size(); ++j)
        if (m_first_piece[i] < m_first_piece[i + 1] && m_first_piece[j] < m_first_piece[j + 1] &&
            !add_crossings(polynomials, i, j))
          return std::nullopt;
    return std::move(m_curves);
  }

private:
  static bool is_arc(const Curve_solution_set_d& set, const Solution_curve& curve)
  {
    const auto is_regular = [&](const Curve_piece& piece) { return piece.parameter >= 0; };
    return !curve.is_closed && std::ranges::all_of(curve.pieces, is_regular) &&
        set.vertices()[curve.pieces.front().ends[0]].is_on_boundary &&
        set.vertices()[curve.pieces.back().ends[1]].is_on_boundary;
  }

  bool add_crossings(const std::vector<Cell_polynomial>& polynomials, std::size_t i, std::size_t j)
  {
    const auto solutions = Subdivision_solver_d<Certified_solver_traits>(m_budget.remaining())(
        system_of_zeros({polynomials[i], polynomials[j]}));
    m_budget.add(solutions.summary());
    std::map<std::array<std::size_t, 2>, int> crossings; // of curves
    for (const auto& solution : solutions) {
      if (!solution.is_certified() || solution.multiplicity() != 1)
        return false;
      const Curve_vertex::Exact_box box = solution.exact_box();
      std::array<std::size_t, 2> curves;
      for (const std::size_t side : {0, 1}) {
        const std::optional<std::size_t> curve = curve_with_point(side == 0 ? i : j, box, solution.point());
        if (!curve)
          return false;
        curves[side] = *curve;
      }
      if (++crossings[curves] > 1)
        return false;
      ++m_curves.number_of_crossings;
    }
    return true;
  }

  // Adds a point, in a box, to the chords of the piece that it is on: the one whose box holds it, between its ends.
  std::optional<std::size_t> curve_with_point(std::size_t polynomial, const Curve_vertex::Exact_box& box,
                                              const std::vector<double>& point)
  {
    for (std::size_t k = m_first_piece[polynomial]; k < m_first_piece[polynomial + 1]; ++k) {
      Cell_curves::Piece& own = m_curves.pieces[k];
      const std::size_t parameter = static_cast<std::size_t>(own.piece.parameter);
      const auto contains = [&](std::size_t axis) {
        return own.piece.box[axis].first <= box[axis].first && box[axis].second <= own.piece.box[axis].second;
      };
      std::pair<Exact_rational, Exact_rational> first = m_curves.vertices[own.piece.ends[0]].box[parameter],
                                                last = m_curves.vertices[own.piece.ends[1]].box[parameter];
      const bool is_increasing = first < last;
      if (!is_increasing)
        std::swap(first, last);
      if (!contains(0) || !contains(1) || !(first.second < box[parameter].first) ||
          !(box[parameter].second < last.first))
        continue;
      const auto is_before = [&](const std::vector<double>& p) {
        return is_increasing ? p[parameter] < point[parameter] : point[parameter] < p[parameter];
      };
      const auto place = std::ranges::find_if_not(own.points, is_before);
      if (place == own.points.begin() || place == own.points.end() || (*place)[parameter] == point[parameter])
        return std::nullopt;
      own.points.insert(place, point);
      return own.curve;
    }
    return std::nullopt;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_CURVES_H
