// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_BOUNDARY_LOOP_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_BOUNDARY_LOOP_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/bezier_chords.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/integral_of_quotient.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

using Exact_tensor = Bernstein_tensor<Exact_rational>;

// A polynomial or rational piece of a boundary on [0,1], and where it comes from.
struct Boundary_piece
{
  std::array<Exact_tensor, 3> coordinates;   // x, y, w of one degree, w > 0
  std::size_t curve;
  // of the curve at the begin and end of the piece, decreasing where it is run backwards
  std::array<Exact_rational, 2> parameters;

  Exact_pair at(const Exact_rational& t) const;

  bool is_polynomial() const
  {
    const std::vector<Exact_rational>& w = coordinates[2].coefficients();
    return std::all_of(w.begin(), w.end(), [&](const Exact_rational& x) { return x == w.front(); });
  }

  // The corners between chords with an error at most, rounded, without the ends.
  std::vector<std::array<double, 2>> inner_corners(double error) const;

  // The part between two parameters of the curve.
  Boundary_piece between(const Exact_rational& begin, const Exact_rational& end) const;

  // A box around the control points, of parts with positive weights.
  std::array<std::pair<double, double>, 2> box() const;

  Boundary_piece reversed() const;
};

// A box around two boxes, of which the first one is empty if it has no ranges.
std::vector<std::pair<double, double>> united_box(std::vector<std::pair<double, double>> box,
                                                  const std::array<std::pair<double, double>, 2>& other);

// The pieces of a curve, of one degree.
template <class Curve>
std::vector<Boundary_piece> boundary_pieces(const Curve& curve, std::size_t index)
{
  std::vector<Boundary_piece> result;
  for (Homogeneous_piece& piece : homogeneous_pieces(curve, Planar_map(curve))) {
    int degree = 1;
    for (const Exact_tensor& tensor : piece.coordinates)
      degree = (std::max)(degree, tensor.degree(0));
    for (Exact_tensor& tensor : piece.coordinates)
      tensor = tensor.elevated({degree});
    result.push_back({std::move(piece.coordinates), index, {piece.domain.first, piece.domain.second}});
  }
  return result;
}

// The pieces of all curves of a range.
template <class Range>
std::vector<std::vector<Boundary_piece>> pieces_of_curves(const Range& curves)
{
  std::vector<std::vector<Boundary_piece>> result;
  for (const auto& curve : curves)
    result.push_back(boundary_pieces(curve, result.size()));
  return result;
}

// A box around curves, each of which is given as its pieces.
std::vector<std::pair<double, double>> box_of_pieces(const std::vector<std::vector<Boundary_piece>>& curves);

/*
A closed curve of pieces, each of which begins in the point where the one before ends. Piece i is where the parameter is
between i and i + 1.
*/
class Boundary_loop_2
{
  std::vector<Boundary_piece> m_pieces;

public:
  explicit Boundary_loop_2(std::vector<Boundary_piece> pieces) : m_pieces(std::move(pieces)) {}

  const std::vector<Boundary_piece>& pieces() const { return m_pieces; }
  Exact_pair source() const { return m_pieces.front().at(0); }

  // One in which no two curves meet, unless this was not found.
  Exact_pair inner_point() const { return m_pieces.front().at(Exact_rational(1) / 2); }

  void reverse();

  // As one spline. Weights are multiplied so that they are continuous.
  Bspline_curve_2<Exact_kernel> curve() const;

  // The curve, and its parameter, that a parameter stands for.
  std::pair<std::size_t, Exact_rational> origin(const Exact_rational& parameter) const;

  Exact_pair at(const Exact_rational& parameter) const
  {
    const auto [piece, t] = place(parameter);
    return piece->at(t);
  }

  // Bounds of the enclosed area, negative for a clockwise loop, at most 2 `error` apart: half of the integral of x y' -
  // y x', which is (X Y' - Y X') / W^2 in homogeneous coordinates.
  Rational_interval signed_area(const Exact_rational& error) const;

  // The greatest absolute value of a coordinate of ends and middles of pieces, as seen from a point.
  Exact_rational greatest_coordinate(const Exact_pair& origin = {Exact_rational(0), Exact_rational(0)}) const;

  // Whether a simple loop is run counterclockwise: its area is not zero. Bounds are as close as its size asks for.
  bool is_counterclockwise() const;

  // Whether a point is on the loop, or next to it: it is not told apart from a part that remains after so many
  // halvings.
  bool may_contain(const Exact_pair& point, int halvings) const;

  // How often the loop runs counterclockwise around a point that is not on it: the signed number of its crossings of
  // the ray in the direction of the x-axis. Ends of parts are above the ray or not, so that none is counted twice.
  int winding_number(const Exact_pair& point) const;

private:
  std::pair<const Boundary_piece*, Exact_rational> place(const Exact_rational& parameter) const;

  // The coordinates relative to a point, times the weight, which is positive.
  static std::pair<Exact_tensor, Exact_tensor> seen_from(const Exact_pair& point, const Boundary_piece& piece)
  {
    const auto& [x, y, w] = piece.coordinates;
    return {x - w * point[0], y - w * point[1]};
  }

  static bool is_positive(const Exact_tensor& f) { return f.bounds().first > 0; }
  static bool is_negative(const Exact_tensor& f) { return f.bounds().second < 0; }

  static bool may_have_common_zero(const Exact_tensor& x, const Exact_tensor& y, int halvings);

  // Whether a piece at these heights does not pass from points that are not above the ray to others, or back.
  static bool misses_ray(const Exact_tensor& y)
  {
    const auto [lower, upper] = y.bounds();
    return lower > 0 || upper <= 0;
  }

  static int crossings_of_ray(const Exact_tensor& x, const Exact_tensor& y);
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Boundary_piece::at(const Exact_rational& t) const
{
  const std::array<Exact_rational, 1> u{t};
  const Exact_rational w = coordinates[2](u);
  return {Exact_rational(coordinates[0](u) / w), Exact_rational(coordinates[1](u) / w)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::array<double, 2>> Boundary_piece::inner_corners(double error) const
{
  const auto& [x, y, w] = coordinates;
  Rounded_bezier bezier;
  for (std::size_t k = 0; k < w.coefficients().size(); ++k)
    bezier.push_back({to_nearest_double(x.coefficients()[k]), to_nearest_double(y.coefficients()[k]),
                      to_nearest_double(w.coefficients()[k])});
  std::vector<std::array<double, 2>> result;
  append_chords(result, std::move(bezier), error);
  result.pop_back();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Boundary_piece Boundary_piece::between(const Exact_rational& begin,
                                                                      const Exact_rational& end) const
{
  if (parameters == std::array<Exact_rational, 2>{begin, end})
    return *this;
  const auto local = [&](const Exact_rational& t) {
    return Exact_rational((t - parameters[0]) / (parameters[1] - parameters[0]));
  };
  Boundary_piece result(*this);
  for (Exact_tensor& tensor : result.coordinates)
    tensor = tensor.restricted(0, local(begin), local(end));
  result.parameters = {begin, end};
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<std::pair<double, double>, 2> Boundary_piece::box() const
{
  std::array<std::pair<double, double>, 2> result;
  const std::vector<Exact_rational>& w = coordinates[2].coefficients();
  if (!(coordinates[2].bounds().first > 0)) {
    const Exact_rational middle((parameters[0] + parameters[1]) / 2);
    const auto first = between(parameters[0], middle).box(), second = between(middle, parameters[1]).box();
    for (const std::size_t axis : {0, 1})
      result[axis] = {(std::min)(first[axis].first, second[axis].first),
                      (std::max)(first[axis].second, second[axis].second)};
    return result;
  }
  for (const std::size_t axis : {0, 1})
    for (std::size_t i = 0; i < w.size(); ++i) {
      const auto [lower, upper] = to_double_interval(Exact_rational(coordinates[axis].coefficients()[i] / w[i]));
      result[axis] = i == 0 ? std::pair(lower, upper)
                            : std::pair((std::min)(result[axis].first, lower), (std::max)(result[axis].second, upper));
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Boundary_piece Boundary_piece::reversed() const
{
  Boundary_piece result(*this);
  for (Exact_tensor& tensor : result.coordinates)
    tensor = tensor.restricted(0, 1, 0);
  std::swap(result.parameters[0], result.parameters[1]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<double, double>>
united_box(std::vector<std::pair<double, double>> box, const std::array<std::pair<double, double>, 2>& other)
{
  if (box.empty())
    return {other.begin(), other.end()};
  for (std::size_t axis = 0; axis < 2; ++axis)
    box[axis] = {(std::min)(box[axis].first, other[axis].first), (std::max)(box[axis].second, other[axis].second)};
  return box;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<double, double>>
box_of_pieces(const std::vector<std::vector<Boundary_piece>>& curves)
{
  std::vector<std::pair<double, double>> result;
  for (const std::vector<Boundary_piece>& curve : curves)
    for (const Boundary_piece& piece : curve)
      result = united_box(std::move(result), piece.box());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Boundary_loop_2::reverse()
{
  std::reverse(m_pieces.begin(), m_pieces.end());
  for (Boundary_piece& piece : m_pieces)
    piece = piece.reversed();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bspline_curve_2<Exact_kernel> Boundary_loop_2::curve() const
{
  int degree = 1;
  for (const Boundary_piece& piece : m_pieces)
    degree = (std::max)(degree, piece.coordinates[0].degree(0));
  std::vector<Exact_rational> breaks(1, Exact_rational(0));
  std::array<std::vector<Exact_tensor>, 3> tensors;
  Exact_rational weight(1);
  for (const Boundary_piece& piece : m_pieces) {
    breaks.push_back(Exact_rational(breaks.back() + 1));
    const Exact_rational factor(weight / piece.coordinates[2].coefficients().front());
    for (std::size_t k = 0; k < 3; ++k)
      tensors[k].push_back(piece.coordinates[k].elevated({degree}) * factor);
    weight = tensors[2].back().coefficients().back();
  }
  const auto function = [&](std::size_t k) {
    return joined(tensors[k], breaks, "Boundary_loop_2: pieces do not meet");
  };
  return Bspline_curve_2<Exact_kernel>::from_homogeneous_coordinates({function(0), function(1)}, function(2));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<std::size_t, Exact_rational>
Boundary_loop_2::origin(const Exact_rational& parameter) const
{
  const auto [piece, t] = place(parameter);
  const auto& [begin, end] = piece->parameters;
  return {piece->curve, Exact_rational(begin + t * (end - begin))};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_interval Boundary_loop_2::signed_area(const Exact_rational& error) const
{
  Rational_interval result(Exact_rational(0), Exact_rational(0));
  const Exact_rational part(error / Exact_rational(static_cast<int>(m_pieces.size())));
  for (const Boundary_piece& piece : m_pieces) {
    const auto& [x, y, w] = piece.coordinates;
    const Exact_tensor n = x * y.derivative(0) - y * x.derivative(0);
    const Exact_rational w0 = w.coefficients().front();
    result = result +
        (piece.is_polynomial() ? Rational_interval(Exact_rational(integral(n) / (w0 * w0)))
                               : integral_of_quotient(n, w * w, part));
  }
  return {Exact_rational(result.lower / 2), Exact_rational(result.upper / 2)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Boundary_loop_2::greatest_coordinate(const Exact_pair& origin) const
{
  Exact_rational result(0);
  for (const Boundary_piece& piece : m_pieces)
    for (const int halves : {0, 1, 2}) {
      const Exact_pair point = piece.at(Exact_rational(halves) / 2);
      for (const std::size_t axis : {0, 1})
        result = (std::max)(result, Exact_rational(CGAL::abs(Exact_rational(point[axis] - origin[axis]))));
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Boundary_loop_2::is_counterclockwise() const
{
  const Exact_rational size = greatest_coordinate(source());
  Exact_rational error(size * size);
  Rational_interval area = signed_area(error);
  for (; has_zero(area); area = signed_area(error))
    error /= 1024;
  return area.lower > 0;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Boundary_loop_2::may_contain(const Exact_pair& point, int halvings) const
{
  return std::any_of(m_pieces.begin(), m_pieces.end(), [&](const Boundary_piece& piece) {
    const auto [x, y] = seen_from(point, piece);
    return may_have_common_zero(x, y, halvings);
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Boundary_loop_2::winding_number(const Exact_pair& point) const
{
  int result = 0;
  for (const Boundary_piece& piece : m_pieces) {
    const auto& [x, y, w] = piece.coordinates;
    if (const Exact_tensor height = y - w * point[1]; !misses_ray(height))
      result += crossings_of_ray(x - w * point[0], height);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<const Boundary_piece*, Exact_rational>
Boundary_loop_2::place(const Exact_rational& parameter) const
{
  std::size_t i = 0;
  Exact_rational t = parameter;
  for (; i + 1 < m_pieces.size() && t >= 1; ++i)
    t -= 1;
  return {&m_pieces[i], t};
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Boundary_loop_2::may_have_common_zero(const Exact_tensor& x, const Exact_tensor& y,
                                                                          int halvings)
{
  if (is_positive(x) || is_negative(x) || is_positive(y) || is_negative(y))
    return false;
  if (halvings == 0)
    return true;
  const auto [x0, x1] = x.split(0);
  const auto [y0, y1] = y.split(0);
  return may_have_common_zero(x0, y0, halvings - 1) || may_have_common_zero(x1, y1, halvings - 1);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Boundary_loop_2::crossings_of_ray(const Exact_tensor& x, const Exact_tensor& y)
{
  if (is_negative(x) || misses_ray(y))
    return 0;
  if (is_positive(x))
    return int(y.coefficients().back() > 0) - int(y.coefficients().front() > 0);
  const auto [x0, x1] = x.split(0);
  const auto [y0, y1] = y.split(0);
  return crossings_of_ray(x0, y0) + crossings_of_ray(x1, y1);
}
#endif

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_BOUNDARY_LOOP_2_H
