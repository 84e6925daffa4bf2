// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LINES_OF_SPHERES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LINES_OF_SPHERES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_spheres.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
The lines of a surface along which spheres touch it, and a band of cells around those of some feet: all that have nearly
the same parameter across the lines, in all pieces that the lines go through.

If all spheres are one, the band is all of the surface that is on it.

Let D be the squared distance from the center of such a sphere minus its squared radius. It is zero on its line, and so
is its derivative, since the sphere touches the surface there. Where the second derivative across the lines is positive
on all cells of a band, D is positive but for the line itself. So nothing in the band is inside of the sphere, nor of a
smaller ball that touches it from within in a foot; while a greater one has all other points of the line inside.
*/
class Lines_of_spheres
{
  using Interval = CGAL::Interval_nt<false>;
  using Cell = Foot_grid::Cell;

  // First and second derivatives across lines, and points.
  struct Bend
  {
    Interval_vector point, first, second;
  };

  const Foot_grid& m_grid;
  std::array<std::size_t, 2> m_shape;
  std::vector<std::array<std::optional<Touching_spheres>, 2>> m_spheres; // of the pieces
  std::vector<std::array<std::size_t, 2>>
      m_class; // of the pieces: the first one with the same spheres, or their number
  std::vector<std::array<std::vector<Interval_net>, 2>> m_first, m_second; // derivatives by both parameters
  std::vector<std::array<std::vector<std::optional<Bend>>, 2>> m_bends;    // of cells

public:
  // \pre rounding is upwards, here and below
  Lines_of_spheres(const Foot_grid& grid, const std::vector<Polynomial_piece>& surface, const Operation_budget& budget)
    : m_grid(grid), m_shape(grid.shape_of_pieces()), m_bends(surface.size())
  {
    for (const Polynomial_piece& piece : surface) {
      budget.check();
      auto& spheres = m_spheres.emplace_back();
      auto &first = m_first.emplace_back(), &second = m_second.emplace_back();
      for (const std::size_t along : {0, 1}) {
        spheres[along] = Touching_spheres::of(piece.coordinates, along);
        if (!spheres[along])
          continue;
        // numerators of X / w, over w^2 and w^3
        const int across = 1 - static_cast<int>(along);
        const Power_polynomial& w = piece.weight();
        Homogeneous_polynomials once, twice;
        for (const std::size_t c : {0, 1, 2}) {
          const Power_polynomial& x = piece.coordinates[c];
          once.push_back(w * x.derivative(across) - w.derivative(across) * x);
          twice.push_back(w * once.back().derivative(across) -
                          Power_polynomial(2) * w.derivative(across) * once.back());
        }
        once.push_back(w * w);
        twice.push_back(w * w * w);
        for (const Tensor& f : tensors_of(once))
          first[along].emplace_back(f);
        for (const Tensor& f : tensors_of(twice))
          second[along].emplace_back(f);
      }
    }
    for (std::size_t piece = 0; piece < surface.size(); ++piece) {
      m_class.push_back({surface.size(), surface.size()});
      for (const std::size_t along : {0, 1}) {
        if (!m_spheres[piece][along])
          continue;
        m_bends[piece][along].resize(static_cast<std::size_t>(grid.size() * grid.size()));
        for (std::size_t other = piece + 1; other-- > 0;)
          if (m_spheres[other][along] && m_spheres[piece][along]->are_same(*m_spheres[other][along]))
            m_class[piece][along] = other;
      }
    }
    for (std::size_t piece = 0; piece < surface.size(); ++piece)
      for (const std::size_t along : {0, 1})
        if (!is_same_on_line(piece, along))
          m_spheres[piece][along].reset();
  }

  // Those that touch along lines of a parameter, or none.
  const Touching_spheres* spheres(std::size_t piece, std::size_t along) const
  {
    return m_spheres[piece][along] ? &*m_spheres[piece][along] : nullptr;
  }

  // Whether a square of cells is in the band of feet that has so many cells on both sides of theirs.
  bool are_nearby(const Touching_balls& balls, std::size_t along, int margin, const Cell& cell, int size) const
  {
    const std::size_t across = 1 - along;
    if (m_class[cell.piece][along] != m_class[balls.piece][along])
      return false;
    if (m_spheres[balls.piece][along]->are_one())
      return true;
    const auto [first, last] = band(balls, across, margin);
    return place(cell.piece)[across] == place(balls.piece)[across] && first <= cell.at[across] &&
        cell.at[across] + size - 1 <= last;
  }

  // Whether all of the band is outside of spheres with centers in a box, but for their lines.
  bool are_outside_nearby(const Touching_balls& balls, std::size_t along, int margin, const Interval_vector& center)
  {
    if (m_spheres[balls.piece][along]->are_one())
      return true;
    const std::size_t across = 1 - along;
    const auto [first, last] = band(balls, across, margin);
    for (std::size_t piece = 0; piece < m_spheres.size(); ++piece) {
      if (place(piece)[across] != place(balls.piece)[across])
        continue;
      for (int i = first; i <= last; ++i)
        for (int j = 0; j < m_grid.size(); ++j) {
          Cell cell{piece, {i, i}};
          cell.at[along] = j;
          const Bend& own = bend(cell, along);
          const Interval_vector way = combination(own.point, Interval(-1), center);
          const Interval square = CGAL::square(own.first[0]) + CGAL::square(own.first[1]) + CGAL::square(own.first[2]);
          if (!((square + dot(way, own.second)).inf() > 0))
            return false;
        }
    }
    return true;
  }

private:
  std::array<std::size_t, 2> place(std::size_t piece) const { return {piece / m_shape[1], piece % m_shape[1]}; }

  bool is_same_on_line(std::size_t piece, std::size_t along) const
  {
    for (std::size_t other = 0; other < m_spheres.size(); ++other)
      if (place(other)[1 - along] == place(piece)[1 - along] && m_class[other][along] != m_class[piece][along])
        return false;
    return true;
  }

  std::array<int, 2> band(const Touching_balls& balls, std::size_t across, int margin) const
  {
    const int n = m_grid.size();
    const auto at = [&](double t) { return static_cast<int>(std::floor(t * n)); };
    return {(std::max)(at(balls.box[across][0]) - margin, 0), (std::min)(at(balls.box[across][1]) + margin, n - 1)};
  }

  const Bend& bend(const Cell& cell, std::size_t along)
  {
    std::optional<Bend>& result =
        m_bends[cell.piece][along][static_cast<std::size_t>(cell.at[0] * m_grid.size() + cell.at[1])];
    if (!result) {
      const auto box = m_grid.box(cell);
      const auto quotients = [&](const std::vector<Interval_net>& nets) {
        std::vector<Interval_net> part;
        for (const Interval_net& net : nets)
          part.push_back(net.restricted(0, box[0][0], box[0][1]).restricted(1, box[1][0], box[1][1]));
        return Foot_grid::hull_of_quotients(part);
      };
      result = Bend{quotients(m_grid.nets(cell.piece)), quotients(m_first[cell.piece][along]),
                    quotients(m_second[cell.piece][along])};
    }
    return *result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_LINES_OF_SPHERES_H
