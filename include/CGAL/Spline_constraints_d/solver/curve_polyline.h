// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_factors.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point of a curve of solutions, and what is computed from its unknowns, once.
template <class Image>
struct Curve_sample
{
  std::vector<double> unknowns;
  Image image;
};

// Finds the points of pieces for given values of their parameters.
class Curve_sampler
{
  using Point = std::vector<double>;

  const Constraint_system_d m_system;
  System_layout m_layout;
  Exact_source m_source;
  std::vector<Exact_source::Value> m_values;
  Cell m_cell;   // that the source is at home in
  bool m_is_simple = false;
  std::unique_ptr<Curve_sampler> m_simpler;   // of the system with simple factors, when it was needed

public:
  explicit Curve_sampler(const Constraint_system_d& system)
    : m_system(equalities_of(system)), m_layout(m_system), m_source(m_system, m_layout)
  {}

  // Appends the samples of a piece behind `from`, until each chord is one by `is_chord(from, sample of the curve
  // between, to)`; `to` is the last one.
  template <class Image, class Image_of, class Is_chord>
  void append(std::vector<Curve_sample<Image>>& samples, const Curve_piece& piece, const Curve_sample<Image>& from,
              const Curve_sample<Image>& to, const Image_of& image_of, const Is_chord& is_chord, int depth = 0)
  {
    constexpr int least_depth = 1, most_depth = 20;
    if (piece.parameter < 0) {
      samples.push_back(to);
      return;
    }
    Point middle(from.unknowns.size());
    for (std::size_t j = 0; j < middle.size(); ++j)
      middle[j] = 0.5 * (from.unknowns[j] + to.unknowns[j]);
    const Point point = on_curve(piece, middle);
    const Curve_sample<Image> sample{point, image_of(point)};
    if (depth >= most_depth || (depth >= least_depth && is_chord(from, sample, to))) {
      samples.push_back(to);
      return;
    }
    append(samples, piece, from, sample, image_of, is_chord, depth + 1);
    append(samples, piece, sample, to, image_of, is_chord, depth + 1);
  }

private:
  int n() const { return m_system.dimension(); }

  // The point of a piece with the same parameter as one near it. Where Newton's method does not find it, the solver
  // does.
  Point on_curve(const Curve_piece& piece, const Point& near)
  {
    Point result = near;
    const bool has_moved = move_to_curve(piece.parameter, result);
    for (std::size_t j = 0; j < result.size(); ++j)
      if (piece.box[j].first == piece.box[j].second)
        result[j] = near[j];   // in a face of the domain
    if (has_moved && is_in(piece.box, result))
      return result;
    if (Curve_sampler* const sampler = has_moved ? nullptr : simpler())
      return sampler->on_curve(piece, near);
    const auto slice = Subdivision_solver_d<Certified_solver_traits>()(
        on_plane(m_system, piece.box, piece.parameter, Exact_rational(near[piece.parameter])));
    if (slice.empty())
      return near;   // beside the end of the piece, since the ends are rounded
    result = slice.begin()->point();
    result.insert(result.begin() + piece.parameter, near[piece.parameter]);
    return result;
  }

  // Newton's method does not converge along curves that are there several times.
  Curve_sampler* simpler()
  {
    if (!std::exchange(m_is_simple, true))
      if (const Simple_factors factors(m_system); factors.is_simpler()) {
        m_simpler = std::make_unique<Curve_sampler>(factors.system());
        m_simpler->m_is_simple = true;
      }
    return m_simpler.get();
  }

  static bool is_in(const Exact_ranges& box, const Point& point)
  {
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j] < to_double_interval(box[j].first).first || to_double_interval(box[j].second).second < point[j])
        return false;
    return true;
  }

  // Newton's method with values that are exact for doubles, and differences of these for derivatives.
  bool move_to_curve(int parameter, Point& point)
  {
    constexpr int most_steps = 12;
    double last = 0;
    for (int step = 0; step < most_steps; ++step) {
      const std::vector<double> values = values_at(point);
      const std::size_t length = static_cast<std::size_t>(n());   // n - 1 unknowns and the values
      std::vector<double> rows((length - 1) * length);
      double size = 0;
      for (int j = 0, column = 0; j < n(); ++j) {
        if (j == parameter)
          continue;
        size = (std::max)(size, std::abs(point[j]));
        Point moved = point;
        moved[j] += 0x1p-20 * (std::max)(std::abs(point[j]), 0x1p-10);
        const double distance = moved[j] - point[j];
        const std::vector<double> other = values_at(moved);
        for (std::size_t i = 0; i + 1 < length; ++i)
          rows[i * length + column] = (other[i] - values[i]) / distance;
        ++column;
      }
      for (std::size_t i = 0; i + 1 < length; ++i)
        rows[i * length + length - 1] = values[i];
      const std::vector<int> row_of =
          gauss_jordan(rows, length, length - 1, length - 1, [](double x) { return std::abs(x); });
      if (row_of.empty())
        return false;
      double longest = 0;
      for (int j = 0, column = 0; j < n(); ++j)
        if (j != parameter) {
          const double change = rows[row_of[column++] * length + length - 1];
          point[j] -= change;
          longest = (std::max)(longest, std::abs(change));
        }
      if (!std::isfinite(longest))
        return false;
      // if steps become shorter at the same rate; they do so faster
      const double next = step == 0 ? longest : longest * (longest / last);
      if (next <= 0x1p-50 * (std::max)(size, 0x1p-20))
        return true;
      last = longest;
    }
    return false;
  }

  // Makes values in a cell cheap: exact ones take several times as long, and those with 127 bits are more than doubles
  // need.
  void enter(const Cell& cell)
  {
    m_cell = cell;
    std::vector<double> lower, upper;
    for (int v = 0; v < n(); ++v) {
      const std::vector<Exact_rational>& breaks = m_source.breaks()[v];
      const auto [begin, end] = breaks.empty() ? m_system.domain(v) : std::pair(breaks[cell[v]], breaks[cell[v] + 1]);
      lower.push_back(to_double_interval(begin).first);
      upper.push_back(to_double_interval(end).second);
    }
    m_source.set_home(cell, std::span<const double>(lower), std::span<const double>(upper));
  }

  // Of the equalities, up to a power of two.
  std::vector<double> values_at(const Point& point)
  {
    constexpr long largest_exponent = 900;
    const Cell cell = m_source.cell_of(std::span<const double>(point));
    if (cell != m_cell)
      enter(cell);
    m_source.evaluate_closely(cell, std::span<const double>(point), m_values);
    std::vector<double> result;
    for (const Exact_source::Value& value : m_values)
      result.push_back(
          std::ldexp(value.mantissa,
                     static_cast<int>((std::max)(-largest_exponent, (std::min)(value.exponent, largest_exponent)))));
    return result;
  }
};

// The distance of a point from the middle of two others.
template <class Point>
double distance_from_middle(const Point& from, const Point& point, const Point& to)
{
  double result = 0;
  for (std::size_t j = 0; j < point.size(); ++j)
    result = std::hypot(result, point[j] - 0.5 * (from[j] + to[j]));
  return result;
}

// The angle between the chords from one point to the next and on to the third; 0 if two are the same.
template <class Point>
double angle_between_chords(const Point& from, const Point& point, const Point& to)
{
  double product = 0, first = 0, second = 0;
  for (std::size_t j = 0; j < point.size(); ++j) {
    const double a = point[j] - from[j], b = to[j] - point[j];
    product += a * b;
    first = std::hypot(first, a);
    second = std::hypot(second, b);
  }
  return first == 0 || second == 0 ? 0 : std::acos((std::min)(1.0, (std::max)(-1.0, product / first / second)));
}

// Samples along a curve with their images by `image_of(unknowns)`, and a chord between each two by `is_chord(from,
// sample between, to)`.
template <class Image_of, class Is_chord>
auto curve_samples(const Constraint_system_d& system, const Curve_solution_set_d& set, const Solution_curve& curve,
                   const Image_of& image_of, const Is_chord& is_chord)
{
  using Sample = Curve_sample<decltype(image_of(std::vector<double>()))>;
  const auto sample_at = [&](std::size_t vertex) {
    const std::vector<double> unknowns = set.vertices()[vertex].point();
    return Sample{unknowns, image_of(unknowns)};
  };
  Curve_sampler sampler(system);
  std::vector<Sample> result{sample_at(curve.pieces.front().ends[0])};
  for (const Curve_piece& piece : curve.pieces)
    sampler.append(result, piece, Sample(result.back()), sample_at(piece.ends[1]), image_of, is_chord);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

points along a curve of solutions: its vertices, and between them so many others that the curve passes the middle of
each chord at no more than a given distance. Every one is a solution up to rounding: the points between vertices are
found by Newton's method in the boxes of the pieces, where they are unique. The points of a closed curve begin and end
with the same one. Pieces that end in a singular point, at most a sixtieth of the domain long, are one chord.

\param system the system that was solved.
\param set its solutions.
\param curve one of their curves.
\param error the distance, in the space of the unknowns; positive.
\param angle in radians, positive: the chords to a point of the curve between the ends of a chord, and from it, differ
in direction by no more. So the chords on both sides of a point differ by about twice as much at most. By default the
directions do not matter.
\throws Invalid_input when the distance or the angle is not positive.
*/
inline std::vector<std::vector<double>> to_polyline(const Constraint_system_d& system, const Curve_solution_set_d& set,
                                                    const Solution_curve& curve, double error, double angle = 4)
{
  internal::check_error(error, "to_polyline");
  if (!(angle > 0))
    throw Invalid_input("to_polyline: the angle must be positive");
  const auto nothing = [](const std::vector<double>&) { return 0; };
  const auto is_chord = [&](const auto& from, const auto& sample, const auto& to) {
    return internal::distance_from_middle(from.unknowns, sample.unknowns, to.unknowns) <= error &&
        internal::angle_between_chords(from.unknowns, sample.unknowns, to.unknowns) <= angle;
  };
  std::vector<std::vector<double>> result;
  for (const auto& sample : internal::curve_samples(system, set, curve, nothing, is_chord))
    result.push_back(sample.unknowns);
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H
