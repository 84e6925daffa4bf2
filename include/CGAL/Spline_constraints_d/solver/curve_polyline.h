// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_points.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  Point_on_piece m_point;

public:
  explicit Curve_sampler(const Constraint_system_d& system) : m_point(points_on_pieces(system)) {}

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
    std::vector<double> middle(from.unknowns.size());
    for (std::size_t j = 0; j < middle.size(); ++j)
      middle[j] = 0.5 * (from.unknowns[j] + to.unknowns[j]);
    const std::vector<double> point = m_point(piece, middle);
    const Curve_sample<Image> sample{point, image_of(point)};
    if (depth >= most_depth || (depth >= least_depth && is_chord(from, sample, to))) {
      samples.push_back(to);
      return;
    }
    append(samples, piece, from, sample, image_of, is_chord, depth + 1);
    append(samples, piece, sample, to, image_of, is_chord, depth + 1);
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
std::vector<std::vector<double>> to_polyline(const Constraint_system_d& system, const Curve_solution_set_d& set,
                                             const Solution_curve& curve, double error, double angle = 4);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::vector<double>> to_polyline(const Constraint_system_d& system,
                                                                            const Curve_solution_set_d& set,
                                                                            const Solution_curve& curve, double error,
                                                                            double angle)
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
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_POLYLINE_H
