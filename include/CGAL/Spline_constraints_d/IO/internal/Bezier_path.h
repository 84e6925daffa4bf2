// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_BEZIER_PATH_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_BEZIER_PATH_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Bézier curves, each of which begins where the one before ends, and the B-spline curve that they are together.
class Bezier_path
{
public:
  using Point = Exact_kernel::Point_2;
  using Curve = Bspline_curve_2<Exact_kernel>;
  using Weights = std::vector<Exact_rational>;

private:
  struct Piece
  {
    std::vector<Point> points;
    Weights weights;
  };

  Point m_source, m_target;
  Exact_rational m_weight = Exact_rational(1);   // of the target
  std::vector<Piece> m_pieces;

public:
  explicit Bezier_path(const Point& source) : m_source(source), m_target(source) {}

  bool empty() const { return m_pieces.empty(); }
  const Point& source() const { return m_source; }
  const Point& target() const { return m_target; }
  const Exact_rational& weight() const { return m_weight; }

  // The next piece, of the target and more points; none where all of them are the same. Weights are scaled to fit.
  void add(std::vector<Point> points, Weights weights = {})
  {
    points.insert(points.begin(), m_target);
    if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == m_target; }))
      return;
    weights.resize(points.size(), Exact_rational(1));
    const Exact_rational scale = Exact_rational(m_weight / weights.front());
    for (Exact_rational& w : weights)
      w *= scale;
    m_target = points.back();
    m_weight = weights.back();
    m_pieces.push_back({std::move(points), std::move(weights)});
  }

  // The pieces of a curve that begins at the target.
  void add(const Curve& curve)
  {
    for (const Curve& piece : curve.bezier_pieces()) {
      std::vector<Point> points = piece.control_points();
      points.erase(points.begin());
      add(std::move(points), piece.control_weights());
    }
  }

  void close() { add({Point(m_source)}); }

  // Piece i is over [i, i+1]; all have the degree of the highest.
  Curve curve() const
  {
    std::size_t order = 0;
    bool is_rational = false;
    for (const Piece& piece : m_pieces) {
      order = (std::max)(order, piece.points.size());
      is_rational = is_rational ||
          std::any_of(piece.weights.begin(), piece.weights.end(), [](const Exact_rational& w) { return w != 1; });
    }
    const int degree = static_cast<int>(order) - 1;
    std::vector<Point> points{m_source};
    Weights weights{Exact_rational(1)};
    std::vector<Exact_rational> knots(order, Exact_rational(0));
    for (const Piece& piece : m_pieces) {
      const Piece elevated = of_degree(degree, piece);
      points.insert(points.end(), elevated.points.begin() + 1, elevated.points.end());
      weights.insert(weights.end(), elevated.weights.begin() + 1, elevated.weights.end());
      knots.insert(knots.end(), static_cast<std::size_t>(degree), Exact_rational(knots.back() + 1));
    }
    knots.push_back(Exact_rational(knots.back()));
    return Curve(degree, knots, points, is_rational ? weights : Weights{});
  }

private:
  static Piece of_degree(int degree, const Piece& piece)
  {
    if (static_cast<int>(piece.points.size()) == degree + 1)
      return piece;
    const Curve curve = bezier_curve<Exact_kernel>(piece.points, piece.weights).elevated(degree);
    Weights weights = curve.control_weights();   // of a polynomial curve: ones
    const Exact_rational scale = Exact_rational(piece.weights.front() / weights.front());
    for (Exact_rational& w : weights)
      w *= scale;
    return {curve.control_points(), std::move(weights)};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_BEZIER_PATH_H
