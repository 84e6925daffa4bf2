// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_GRID_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_GRID_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
A surface as a grid of n times n cells on each of its pieces, with bounds of points, normals and curvatures. Where a
piece ends at an edge of the surface, some more cells lie beyond it, on the polynomials that go on there.
*/
class Foot_grid
{
public:
  using Interval = Interval_net::Interval;
  using Box = std::array<Interval, 3>;
  using Vector = std::array<double, 3>;
  using Range = std::array<double, 2>;
  static constexpr int margin = 12;

  // Columns and rows are from -margin to n + margin.
  struct Cell
  {
    std::size_t piece;
    std::array<int, 2> at;
  };

  // Of a part of the surface: a box of its points, and a parallelogram that they are near to.
  struct Bounds
  {
    Box point;
    Vector center, first, second; // center + s first + t second with s and t in [-1,1]
    double distance;              // from there
    double radius;                // the greatest distance from the center

    // Of homogeneous coordinates.
    static Bounds of(const std::vector<Interval_net>& nets)
    {
      Bounds result;
      result.point = hull_of_quotients(nets);
      add_parallelogram(result, nets);
      return result;
    }
  };

  // How a part of the surface is bent.
  struct Shape
  {
    bool is_regular = false;            // else nothing is known
    Box normal;                         // of length one
    std::array<Interval, 2> curvatures; // the principal ones with respect to it
  };

private:
  enum class Border
  {
    EDGE,
    SMOOTH,
    POLE,
    OTHER
  };

  int m_size;
  std::array<std::size_t, 2> m_shape{};
  std::vector<Foot_piece> m_pieces;
  std::vector<std::array<std::array<Border, 2>, 2>> m_borders; // of a piece: axis, side
  std::vector<std::vector<Interval_net>> m_nets;               // of a piece: coordinates
  std::vector<std::vector<Interval_net>> m_shape_nets;         // of a piece: normal, curvatures
  std::vector<std::vector<Interval_net>> m_columns;            // of coordinates, over a column of cells
  std::vector<std::vector<Interval_net>> m_shape_columns;
  std::vector<std::optional<Bounds>> m_bounds;
  std::vector<std::optional<Shape>> m_shapes;

public:
  // \pre rounding is upwards, here and below; the pieces are those of a grid of this shape, in row-major order.
  Foot_grid(std::vector<Foot_piece> pieces, const std::array<std::size_t, 2>& shape, int size)
    : m_size(size), m_shape(shape), m_pieces(std::move(pieces)), m_columns(m_pieces.size() * columns()),
      m_shape_columns(m_columns.size()), m_bounds(m_pieces.size() * columns() * columns()), m_shapes(m_bounds.size())
  {
    for (std::size_t p = 0; p < m_pieces.size(); ++p) {
      m_nets.emplace_back(m_pieces[p].coordinates.begin(), m_pieces[p].coordinates.end());
      auto& nets = m_shape_nets.emplace_back();
      for (const auto* list : {&m_pieces[p].normal, &m_pieces[p].squared_sum, &m_pieces[p].product,
                               &m_pieces[p].sign_of_sum, &m_pieces[p].orientation})
        for (const Tensor& f : *list)
          nets.emplace_back(f);
      auto& borders = m_borders.emplace_back();
      for (const int axis : {0, 1})
        for (const int side : {0, 1})
          borders[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)] = border(p, axis, side);
    }
  }

  int size() const { return m_size; }
  const std::array<std::size_t, 2>& shape_of_pieces() const { return m_shape; }
  std::size_t number_of_pieces() const { return m_pieces.size(); }
  std::size_t number_of_cells() const { return m_bounds.size(); }
  bool is_inside(const Cell& cell) const { return is_inside(cell.at[0]) && is_inside(cell.at[1]); }

  std::size_t index(const Cell& cell) const
  {
    return (cell.piece * columns() + static_cast<std::size_t>(cell.at[0] + margin)) * columns() +
        static_cast<std::size_t>(cell.at[1] + margin);
  }

  const Bounds& bounds(const Cell& cell)
  {
    std::optional<Bounds>& result = m_bounds[index(cell)];
    if (!result)
      result = Bounds::of(nets_of(cell, m_nets, m_columns));
    return *result;
  }

  const Shape& shape(const Cell& cell)
  {
    std::optional<Shape>& result = m_shapes[index(cell)];
    if (!result)
      result = shape_of(m_pieces[cell.piece], nets_of(cell, m_shape_nets, m_shape_columns));
    return *result;
  }

  // The parameters of a cell.
  std::array<Range, 2> box(const Cell& cell) const
  {
    const auto range = [&](std::size_t axis) {
      return Range{static_cast<double>(cell.at[axis]) / m_size, static_cast<double>(cell.at[axis] + 1) / m_size};
    };
    return {range(0), range(1)};
  }

  // Homogeneous coordinates over a cell.
  std::vector<Interval_net> nets_of(const Cell& cell) { return nets_of(cell, m_nets, m_columns); }

  // The cells behind a side of a cell: one, or at a pole all those around it; none where the surface is not known to be
  // smooth, or the margin ends.
  std::vector<Cell> neighbours(const Cell& cell, int axis, int side) const
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    Cell next = cell;
    next.at[own] += side == 0 ? -1 : 1;
    if (next.at[own] < -margin || next.at[own] >= m_size + margin)
      return {};
    if (is_inside(next.at[own]) || !is_inside(cell.at[own]))
      return {next}; // in the same piece, or beyond an edge
    switch (m_borders[cell.piece][own][static_cast<std::size_t>(side)]) {
    case Border::EDGE:
      return {next};
    case Border::SMOOTH:
      next.piece = piece_behind(cell.piece, axis, side);
      next.at[own] = side == 0 ? m_size - 1 : 0;
      return is_beyond_same_edge(cell.piece, next.piece, cell.at[1 - own], 1 - axis) ? std::vector{next}
                                                                                     : std::vector<Cell>();
    case Border::POLE:
      return is_inside(cell.at[1 - own]) ? around_pole(cell, axis) : std::vector<Cell>();
    default:
      return {};
    }
  }

  // A corner of a cell on the surface, and how far it may be from there.
  std::pair<Vector, double> corner(const Cell& cell, int i, int j) const
  {
    const double u = static_cast<double>(cell.at[0] + i) / m_size, v = static_cast<double>(cell.at[1] + j) / m_size;
    const Interval weight = m_nets[cell.piece][3](u, v);
    if (weight.inf() <= 0 && weight.sup() >= 0)
      return {{}, std::numeric_limits<double>::infinity()};
    Vector result;
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Interval x = m_nets[cell.piece][c](u, v) / weight;
      result[c] = midpoint(x);
      error += x.sup() - x.inf();
    }
    return {result, error};
  }

  static double midpoint(const Interval& x) { return 0.5 * (x.inf() + x.sup()); }

private:
  std::size_t columns() const { return static_cast<std::size_t>(m_size + 2 * margin); }
  bool is_inside(int i) const { return 0 <= i && i < m_size; }

  std::array<std::size_t, 2> place(std::size_t piece) const { return {piece / m_shape[1], piece % m_shape[1]}; }

  // The next piece along an axis, across the seam from the last one to the first one.
  std::size_t piece_behind(std::size_t piece, int axis, int side) const
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    std::array<std::size_t, 2> at = place(piece);
    at[own] = (at[own] + (side == 0 ? m_shape[own] - 1 : 1)) % m_shape[own];
    return at[0] * m_shape[1] + at[1];
  }

  bool is_at_end(std::size_t piece, int axis, int side) const
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    return place(piece)[own] == (side == 0 ? 0 : m_shape[own] - 1);
  }

  // Whether cells at a place of an axis are inside of both of two pieces, or beyond an edge of both.
  bool is_beyond_same_edge(std::size_t a, std::size_t b, int at, int axis) const
  {
    const auto border = [&](std::size_t piece) {
      return m_borders[piece][static_cast<std::size_t>(axis)][at < 0 ? 0 : 1];
    };
    return is_inside(at) || (border(a) == Border::EDGE && border(b) == Border::EDGE);
  }

  // Whether the surface goes on smoothly behind a side of a piece: points and normals are the same.
  bool is_smooth(std::size_t piece, int axis, int side) const
  {
    const Foot_piece &own = m_pieces[piece], &other = m_pieces[piece_behind(piece, axis, side)];
    for (const auto list : {&Foot_piece::coordinates, &Foot_piece::normal}) {
      const auto ratio = ratio_of_sides(own.*list, side, other.*list, 1 - side, axis);
      if (!ratio || !(*ratio > 0))
        return false;
    }
    return true;
  }

  bool is_pole(std::size_t piece, int axis, int side) const
  {
    const std::vector<Tensor>& x = m_pieces[piece].coordinates;
    std::vector<Tensor> constant;
    const Exact_rational weight = x[3].face(axis, side).coefficients().front();
    for (const Tensor& f : x)
      constant.push_back(x[3] * Exact_rational(f.face(axis, side).coefficients().front() / weight));
    for (std::size_t i = 0; i < 3; ++i)
      if (!(x[i].face(axis, side) == constant[i].face(axis, side)))
        return false;
    return true;
  }

  Border border(std::size_t piece, int axis, int side) const
  {
    if (is_pole(piece, axis, side)) {
      const std::size_t other = static_cast<std::size_t>(1 - axis);
      for (std::size_t p = piece, k = 0; k < m_shape[other]; p = piece_behind(p, 1 - axis, 1), ++k)
        if (!is_smooth(p, 1 - axis, 1))
          return Border::OTHER; // not all around it
      return Border::POLE;
    }
    if (is_smooth(piece, axis, side))
      return Border::SMOOTH;
    return is_at_end(piece, axis, side) ? Border::EDGE : Border::OTHER;
  }

  std::vector<Cell> around_pole(const Cell& cell, int axis) const
  {
    const std::size_t own = static_cast<std::size_t>(axis);
    std::vector<Cell> result;
    for (std::size_t p = cell.piece, k = 0; k < m_shape[1 - own]; p = piece_behind(p, 1 - axis, 1), ++k)
      for (int i = 0; i < m_size; ++i) {
        Cell next{p, cell.at};
        next.at[1 - own] = i;
        result.push_back(next);
      }
    return result;
  }

  std::vector<Interval_net> nets_of(const Cell& cell, const std::vector<std::vector<Interval_net>>& pieces,
                                    std::vector<std::vector<Interval_net>>& columns_of_pieces) const
  {
    const std::array<Range, 2> ranges = box(cell);
    std::vector<Interval_net>& column =
        columns_of_pieces[cell.piece * columns() + static_cast<std::size_t>(cell.at[0] + margin)];
    if (column.empty())
      for (const Interval_net& net : pieces[cell.piece])
        column.push_back(net.restricted(0, ranges[0][0], ranges[0][1]));
    std::vector<Interval_net> result;
    for (const Interval_net& net : column)
      result.push_back(net.restricted(1, ranges[1][0], ranges[1][1]));
    return result;
  }

  static Shape shape_of(const Foot_piece& piece, const std::vector<Interval_net>& nets)
  {
    Shape result;
    const Box n{nets[0].bounds(), nets[1].bounds(), nets[2].bounds()};
    const Interval squared_length = CGAL::square(n[0]) + CGAL::square(n[1]) + CGAL::square(n[2]);
    const std::size_t first = 3, second = first + piece.squared_sum.size();
    const std::optional<Interval> squared_sum = quotient(nets, first, piece.squared_sum.size(), 2),
                                  product = quotient(nets, second, piece.product.size(), 1);
    // Where the parametrisation folds, the cross product of the derivatives turns to the other side of the normal.
    result.is_regular = squared_length.inf() > 0 && squared_sum && product && nets.back().bounds().inf() >= 0;
    if (result.is_regular) {
      const Interval length = square_root(squared_length);
      for (std::size_t c = 0; c < 3; ++c)
        result.normal[c] = n[c] / length;
      result.curvatures =
          principal_curvatures(nets[nets.size() - 3].bounds() * nets[nets.size() - 2].bounds(), *squared_sum, *product);
    }
    return result;
  }

  // Of two nets, or of the power of a quotient and a third one; none if a denominator may be zero.
  static std::optional<Interval> quotient(const std::vector<Interval_net>& nets, std::size_t first, std::size_t number,
                                          int power)
  {
    const Interval denominator = CGAL::abs(nets[first + 1].bounds());
    if (!(denominator.inf() > 0))
      return std::nullopt;
    Interval result = Interval_net::quotients(nets[first], nets[first + 1]);
    if (number == 2)
      return result;
    const Interval length = nets[first + 2].bounds();
    if (!(length.inf() > 0))
      return std::nullopt;
    return (power == 2 ? CGAL::square(result) : result) / length;
  }

  // Half of their sum, minus and plus the root of its square without the product. The sign of the sum is that of
  // another number, if it has one.
  static std::array<Interval, 2> principal_curvatures(const Interval& sign, const Interval& squared_sum,
                                                      const Interval& product)
  {
    const auto positive = [](const Interval& x) {
      return Interval((std::max)(x.inf(), 0.0), (std::max)(x.sup(), 0.0));
    };
    const Interval square = positive(squared_sum) / Interval(4), size = square_root(square),
                   radius = square_root(positive(square - product));
    const Interval half = sign.inf() >= 0 ? size : sign.sup() <= 0 ? -size : Interval(-size.sup(), size.sup());
    return {half - radius, half + radius};
  }

  static void add_parallelogram(Bounds& result, const std::vector<Interval_net>& nets)
  {
    const auto point = [&](double u, double v) {
      const double weight = midpoint(nets[3](u, v));
      return Vector{midpoint(nets[0](u, v)) / weight, midpoint(nets[1](u, v)) / weight,
                    midpoint(nets[2](u, v)) / weight};
    };
    const auto half_difference = [](const Vector& a, const Vector& b) {
      return Vector{0.5 * (b[0] - a[0]), 0.5 * (b[1] - a[1]), 0.5 * (b[2] - a[2])};
    };
    result.center = point(0.5, 0.5);
    result.first = half_difference(point(0, 0.5), point(1, 0.5));
    result.second = half_difference(point(0.5, 0), point(0.5, 1));
    std::array<Vector, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        corners[k][c] =
            result.center[c] + (k < 2 ? -1 : 1) * result.first[c] + (k % 2 == 0 ? -1 : 1) * result.second[c];
    const Interval weight = CGAL::abs(nets[3].bounds());
    const double error = Interval_net::distance({&nets[0], &nets[1], &nets[2]}, nets[3], corners);
    // corners are rounded, which is far below this
    result.distance = weight.inf() > 0 ? (Interval(error) / Interval(weight.inf())).sup() * (1 + 0x1p-40) +
            0x1p-40 * (norm(result.center) + norm(result.first) + norm(result.second))
                                       : std::numeric_limits<double>::infinity();
    result.radius = result.distance + norm(result.first) + norm(result.second);
  }

public:
  static double norm(const Vector& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

  // Those of the homogeneous coordinates of a piece.
  const std::vector<Interval_net>& nets(std::size_t piece) const { return m_nets[piece]; }

  // Bounds of the points of homogeneous coordinates: those of the control points, if all weights have one sign.
  static Box hull_of_quotients(const std::vector<Interval_net>& nets)
  {
    Box result;
    const Interval weight = nets[3].bounds();
    const bool has_one_sign = weight.inf() > 0 || weight.sup() < 0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!has_one_sign) {
        result[c] = Interval::largest();
        continue;
      }
      result[c] = Interval_net::quotients(nets[c], nets[3]);
    }
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_GRID_H
