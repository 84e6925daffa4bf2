// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_ARC_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_ARC_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// Directions are numbers of [0,4), which increase counterclockwise: q + b/(a+b) for the vector (a,b), a > 0, b >= 0,
// turned by q right angles.
inline Exact_pair vector_of_direction(const Exact_rational& direction)
{
  int quadrant = 0;
  while (direction >= quadrant + 1)
    ++quadrant;
  const Exact_rational t(direction - quadrant);
  Exact_pair result{Exact_rational(1 - t), t};
  for (; quadrant > 0; --quadrant)
    result = {Exact_rational(-result[1]), result[0]};
  return result;
}

inline const Exact_rational& narrow_sight()
{
  static const Exact_rational width = power_of_two(-90);
  return width;
}

/*
An arc that is seen from a point within one quadrant, where the direction of sight increases strictly or decreases
strictly with the parameter. Its parameter is local to [0,1], the piece that it is a part of.
*/
class Sight_arc_2
{
  std::size_t m_curve;
  std::array<Exact_rational, 2> m_parameters;   // of the curve, where that of the piece is 0 and 1
  int m_quadrant;
  // the vector from the viewpoint, with the quadrant as the first one, times a positive function
  Exact_tensor m_a, m_b;
  Exact_tensor m_distance, m_weight;            // the sum of its coordinates, times the weight
  std::array<Exact_root, 2> m_ends;             // in the order of directions
  bool m_is_reversed;                           // the direction decreases with the parameter
  std::array<Rational_interval, 2> m_directions;

public:
  Sight_arc_2(const Boundary_piece& piece, int quadrant, Exact_tensor a, Exact_tensor b, Exact_tensor distance,
              std::array<Exact_root, 2> ends, bool is_reversed)
    : m_curve(piece.curve), m_parameters(piece.parameters), m_quadrant(quadrant), m_a(std::move(a)), m_b(std::move(b)),
      m_distance(std::move(distance)), m_weight(piece.coordinates[2]), m_ends(std::move(ends)),
      m_is_reversed(is_reversed)
  {
    for (int k = 0; k < 2; ++k)
      m_directions[k] = direction_of_end(k);
    if (m_is_reversed)
      std::swap(m_ends[0], m_ends[1]);
    if (m_is_reversed)
      std::swap(m_directions[0], m_directions[1]);
  }

  std::size_t curve() const { return m_curve; }
  int quadrant() const { return m_quadrant; }
  bool is_reversed() const { return m_is_reversed; }

  // In which an end is seen; 4 instead of 0 at the end of the last quadrant.
  const Rational_interval& direction(int end) const { return m_directions[end]; }

  Parameter_range range_of_end(int end) const { return {m_ends[end].lower(), m_ends[end].upper()}; }

  // Whether an end is seen exactly in this direction.
  bool is_seen_in(int end, const Exact_rational& direction) const
  {
    Exact_root root = m_ends[end];
    return root.sign_of_value(integer_polynomial(side(direction))) == CGAL::ZERO;
  }

  // The parameter that is seen in a direction. \pre the direction is certainly between those of the ends
  Exact_root root_at(const Exact_rational& direction) const
  {
    const int first = m_is_reversed ? 1 : 0;
    return Exact_root(std::make_shared<const Integer_polynomial>(integer_polynomial(side(direction))),
                      m_ends[first].upper(), m_ends[1 - first].lower(),
                      m_is_reversed ? CGAL::POSITIVE : CGAL::NEGATIVE);
  }

  // Bounds of the parameter where the direction is within bounds that no end is in.
  Parameter_range range_at(const Rational_interval& direction) const
  {
    Exact_root first = root_at(direction.lower), last = root_at(direction.upper);
    for (Exact_root* root : {&first, &last}) {
      narrow(*root, narrow_sight());
      root->settle_on_simplest_rational();
    }
    return {(std::min)(first.lower(), last.lower()), (std::max)(first.upper(), last.upper())};
  }

  // Bounds of the distance in a range, where the sum of the absolute coordinates is the distance: in one direction
  // these are in the order of lengths.
  Rational_interval distance(const Parameter_range& range) const
  {
    const Exact_tensor r = m_distance.restricted(0, range.first, range.second),
                       w = m_weight.restricted(0, range.first, range.second);
    Rational_interval result(Exact_rational(r.coefficients()[0] / w.coefficients()[0]));
    for (std::size_t k = 1; k < r.coefficients().size(); ++k)
      result = hull(result, Rational_interval(Exact_rational(r.coefficients()[k] / w.coefficients()[k])));
    return result;
  }

  // The whole of it, with what may be beyond its ends.
  Parameter_range range() const
  {
    return {(std::min)(m_ends[0].lower(), m_ends[1].lower()), (std::max)(m_ends[0].upper(), m_ends[1].upper())};
  }

  // Parameters of the curve for local ones.
  Parameter_range on_curve(const Parameter_range& range) const
  {
    const auto value = [&](const Exact_rational& t) {
      return Exact_rational(m_parameters[0] + t * (m_parameters[1] - m_parameters[0]));
    };
    return {value(range.first), value(range.second)};
  }

private:
  // Negative before a direction, and positive after it.
  Exact_tensor side(const Exact_rational& direction) const
  {
    const Exact_rational t(direction - m_quadrant);
    return m_b * Exact_rational(1 - t) - m_a * t;
  }

  Rational_interval direction_of_end(int end)
  {
    for (const int axis : {m_quadrant, m_quadrant + 1})
      if (is_seen_in(end, Exact_rational(axis)))
        return Rational_interval(Exact_rational(axis));
    for (;;) {
      const auto bounds = bounds_of_direction(range_of_end(end));
      if (bounds.lower > m_quadrant && bounds.upper < m_quadrant + 1 &&
          bounds.upper - bounds.lower <= power_of_two(-64))
        return bounds;
      m_ends[end].halve();
    }
  }

  Rational_interval bounds_of_direction(const Parameter_range& range) const
  {
    const Exact_tensor a = m_a.restricted(0, range.first, range.second),
                       b = m_b.restricted(0, range.first, range.second);
    const Rational_interval all(Exact_rational(m_quadrant), Exact_rational(m_quadrant + 1));
    Rational_interval result = all;
    for (std::size_t k = 0; k < a.coefficients().size(); ++k) {
      const Exact_rational sum(a.coefficients()[k] + b.coefficients()[k]);
      if (!(sum > 0))
        return all;
      const Rational_interval one(Exact_rational(m_quadrant + b.coefficients()[k] / sum));
      result = k == 0 ? one : hull(result, one);
    }
    return result;
  }
};

// The turned vector.
inline void turn_right(Exact_tensor& a, Exact_tensor& b)
{
  Exact_tensor before = a;
  a = b;
  b = -before;
}

// Without a factor t, or 1 - t, that both have. \pre they are zero there
inline Exact_tensor without_zero_at(int end, const Exact_tensor& f)
{
  const std::vector<Exact_rational>& c = f.coefficients();
  const int degree = f.degree(0);
  std::vector<Exact_rational> result;
  for (int k = 0; k < degree; ++k)
    result.push_back(Exact_rational(c[end == 0 ? k + 1 : k] * degree / (end == 0 ? k + 1 : degree - k)));
  return Exact_tensor({degree - 1}, std::move(result));
}

/*
Cuts a piece into arcs that are seen within one quadrant, with increasing or decreasing direction: at the roots of the
coordinates and of the cross product with the derivative. None if the piece is on a line through the viewpoint.
*/
inline void append_sight_arcs(const Boundary_piece& piece, const Exact_pair& viewpoint, std::vector<Sight_arc_2>& arcs)
{
  const auto& [x, y, w] = piece.coordinates;
  const Exact_tensor dx = x - w * viewpoint[0], dy = y - w * viewpoint[1];
  Exact_tensor a = dx, b = dy;
  for (const int end : {0, 1})
    while (a.degree(0) > 0 &&
           (end == 0 ? a.coefficients().front() == 0 && b.coefficients().front() == 0
                     : a.coefficients().back() == 0 && b.coefficients().back() == 0)) {
      a = without_zero_at(end, a);
      b = without_zero_at(end, b);
    }
  if (a.degree(0) == 0)
    return;
  const Exact_tensor turn = a * b.derivative(0) - b * a.derivative(0);
  if (power_coefficients(turn).empty())
    return;
  const auto factor = [](const Exact_tensor& f) {
    return power_coefficients(f).empty() ? Exact_tensor::constant(1, Exact_rational(1)) : f;
  };
  std::vector<Exact_root> cuts{Exact_root(Exact_rational(0))};
  for (Exact_root& root : inner_roots(factor(a) * factor(b) * turn, narrow_sight())) {
    if (root.sign_of_value(integer_polynomial(a)) == CGAL::ZERO &&
        root.sign_of_value(integer_polynomial(b)) == CGAL::ZERO) {
      const Exact_rational at(piece.parameters[0] + root.lower() * (piece.parameters[1] - piece.parameters[0]));
      if (!root.is_point())
        throw Invalid_input("visible_part: the point is on curve " + std::to_string(piece.curve) +
                            " next to parameter " + shortest_text(to_nearest_double(at)) + ", which is not rational");
      append_sight_arcs(restricted(piece, Exact_rational(0), root.lower()), viewpoint, arcs);
      append_sight_arcs(restricted(piece, root.lower(), Exact_rational(1)), viewpoint, arcs);
      return;
    }
    cuts.push_back(std::move(root));
  }
  cuts.emplace_back(Exact_rational(1));
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const std::array<Exact_rational, 1> middle{Exact_rational((cuts[i].upper() + cuts[i + 1].lower()) / 2)};
    Exact_tensor turned_a = a, turned_b = b, distance_a = dx, distance_b = dy;
    int quadrant = 0;
    for (; !(turned_a(middle) >= 0 && turned_b(middle) >= 0); ++quadrant) {
      turn_right(turned_a, turned_b);
      turn_right(distance_a, distance_b);
    }
    arcs.emplace_back(piece, quadrant, std::move(turned_a), std::move(turned_b), distance_a + distance_b,
                      std::array<Exact_root, 2>{cuts[i], cuts[i + 1]}, turn(middle) < 0);
  }
}

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_ARC_2_H
