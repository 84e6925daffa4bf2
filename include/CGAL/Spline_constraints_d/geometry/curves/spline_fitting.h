// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SPLINE_FITTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SPLINE_FITTING_H

#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/periodic_knots.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Knots of a cubic spline with simple breaks: clamped, or periodic.
Knot_axis<double> cubic_axis(const std::vector<double>& breaks, bool is_closed);

// The point of a spline, whose first control points come again at the end if the knots are periodic.
std::vector<double> cubic_point(const Knot_axis<double>& axis, const std::vector<std::vector<double>>& control_points,
                                double t);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Knot_axis<double> cubic_axis(const std::vector<double>& breaks, bool is_closed)
{
  if (is_closed)
    return {3, unwrapped_knots(3, breaks, "Fitted_spline_d")};
  std::vector<double> knots(3, breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), 3, breaks.back());
  return {3, std::move(knots)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<double>
cubic_point(const Knot_axis<double>& axis, const std::vector<std::vector<double>>& control_points, double t)
{
  const std::size_t span = span_of(axis, t);
  const std::vector<double> weights = derivative_weights(axis, span, t, 0);
  std::vector<double> result(control_points.front().size(), 0);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] += weights[i] * control_points[(span - 3 + i) % control_points.size()][k];
  return result;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

A twice continuously differentiable cubic spline near a curve, in a space of any dimension, with its distance from the
curve as far as that was measured. Its parameter is the arc length of the curve, nearly.
*/
struct Fitted_spline_d
{
  //! where the polynomial pieces begin and end, increasing.
  std::vector<double> breaks;

  //! the control points: three more than pieces; of a closed spline, whose first three stand for the last ones as well,
  //! as many as pieces.
  std::vector<std::vector<double>> control_points;

  //! whether it is periodic.
  bool is_closed;

  /*!
  the largest distance between a sample of the curve and the point of the spline with the same parameter. Every second
  sample is one that took no part in the fit. It is a measurement, no proof: between samples nothing is known.
  */
  double error;

  //! the point at a parameter between the first and the last break; beyond them, the first or last polynomial is
  //! continued.
  std::vector<double> operator()(double t) const
  {
    return internal::cubic_point(internal::cubic_axis(breaks, is_closed), control_points, t);
  }

  //! the spline as a curve in the plane. \throws Invalid_input when there are not two coordinates.
  template <SplineKernel Kernel>
  Bspline_curve_2<Kernel> curve_2() const { return curve<Kernel, 2>(); }

  //! the spline as a curve in space. \throws Invalid_input when there are not three coordinates.
  template <SplineKernel Kernel>
  Bspline_curve_3<Kernel> curve_3() const { return curve<Kernel, 3>(); }

private:
  template <class Kernel, int d>
  Bspline_curve<Kernel, d> curve() const
  {
    using Curve = Bspline_curve<Kernel, d>;
    using FT = typename Kernel::FT;
    internal::check_count(control_points.front().size(), std::size_t(d), "Fitted_spline_d: coordinates");
    std::vector<typename Curve::Point> points;
    for (const std::vector<double>& p : control_points) {
      std::array<double, d> coordinates;
      std::copy(p.begin(), p.end(), coordinates.begin());
      points.push_back(internal::kernel_object<Kernel, typename Curve::Point>(coordinates));
    }
    const std::vector<double> knots = is_closed ? breaks : *internal::cubic_axis(breaks, false).knots;
    const std::vector<FT> numbers(knots.begin(), knots.end());
    return is_closed ? Curve::from_periodic(3, numbers, points) : Curve(3, numbers, points);
  }
};

namespace internal {

using Double_points = std::vector<std::vector<double>>;

double distance(const std::vector<double>& a, const std::vector<double>& b);

// Cubic splines through samples of a curve, by least squares. The samples are in order; those of a closed curve end
// with the first one.
class Spline_fitting
{
  // Each piece has so many chords at least, half of whose ends take part in the fit.
  static constexpr std::size_t least_chords = 8;

  const Double_points& m_samples;
  std::vector<double> m_parameters;
  bool m_is_closed;

public:
  Spline_fitting(const Double_points& samples, bool is_closed)
    : m_samples(samples), m_parameters(arc_lengths(samples)), m_is_closed(is_closed)
  {}

  static std::size_t least_samples() { return 4 * least_chords + 1; }

  // Splits pieces until none is further from its samples than the tolerance, or one that is has too few of them to be
  // split.
  Fitted_spline_d operator()(double tolerance) const;

private:
  // The sample next to the middle of a piece that leaves enough chords on both sides, if there are enough.
  std::size_t middle_sample(std::size_t first, std::size_t last) const;

  // Chords, each lengthened to an arc by the curvature at its ends: c (1 + (kappa c)^2 / 24).
  static std::vector<double> arc_lengths(const Double_points& points);

  // The spline with these samples as breaks that is nearest to every second sample.
  Fitted_spline_d least_squares(const std::vector<std::size_t>& breaks) const;

  int dimension() const { return static_cast<int>(m_samples.front().size()); }

  // An open spline begins and ends where the curve does.
  bool is_fixed(int control, int size) const { return !m_is_closed && (control == 0 || control == size - 1); }
  const std::vector<double>& end_of_curve(int control) const
  {
    return control == 0 ? m_samples.front() : m_samples.back();
  }

  // One for each sample that is fitted: the weights of the control points, and the sample less what the fixed control
  // points make of it.
  std::pair<Eigen::SparseMatrix<double>, Eigen::MatrixXd> equations(const Knot_axis<double>& axis, int size) const;
};

inline std::vector<double> coordinates_of(const std::vector<double>& point) { return point; }

template <class Point>
std::vector<double> coordinates_of(const Point& point)
{
  std::vector<double> result;
  for (int k = 0; k < point.dimension(); ++k)
    result.push_back(converted_number<double>(point.cartesian(k)));
  return result;
}

// Points that are apart.
template <class Points>
Double_points distinct_points(const Points& points)
{
  Double_points result;
  for (const auto& point : points)
    if (std::vector<double> next = coordinates_of(point); result.empty() || distance(result.back(), next) > 0)
      result.push_back(std::move(next));
  return result;
}

void insert_middles(Double_points& points);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE double distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    result = std::hypot(result, a[k] - b[k]);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Fitted_spline_d Spline_fitting::operator()(double tolerance) const
{
  const std::size_t last = m_samples.size() - 1;
  std::vector<std::size_t> breaks{0, last};
  if (m_is_closed) {
    const std::size_t middle = middle_sample(0, last);
    breaks = {0, middle_sample(0, middle), middle, middle_sample(middle, last), last};
  }
  for (;;) {
    Fitted_spline_d spline = least_squares(breaks);
    const Knot_axis<double> axis = cubic_axis(spline.breaks, m_is_closed);
    std::vector<std::size_t> finer(1, 0);
    bool is_fine = true;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      double error = 0;
      for (std::size_t j = breaks[i]; j <= breaks[i + 1]; ++j)
        error = (std::max)(error, distance(cubic_point(axis, spline.control_points, m_parameters[j]), m_samples[j]));
      spline.error = (std::max)(spline.error, error);
      if (error > tolerance) {
        is_fine = is_fine && breaks[i + 1] - breaks[i] >= 2 * least_chords;
        finer.push_back(middle_sample(breaks[i], breaks[i + 1]));
      }
      finer.push_back(breaks[i + 1]);
    }
    if (!is_fine || finer.size() == breaks.size())
      return spline;
    breaks = std::move(finer);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Spline_fitting::middle_sample(std::size_t first, std::size_t last) const
{
  const auto begin = m_parameters.begin();
  const std::size_t least = (std::min)(least_chords, (last - first) / 2),
                    middle = std::lower_bound(begin + first, begin + last,
                                              0.5 * (m_parameters[first] + m_parameters[last])) -
      begin;
  return (std::max)(first + least, (std::min)(middle, last - least));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<double> Spline_fitting::arc_lengths(const Double_points& points)
{
  std::vector<double> chords, squared_curvatures(points.size(), 0), result(1, 0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    chords.push_back(distance(points[i], points[i + 1]));
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    double turn = 0;
    for (std::size_t k = 0; k < points[i].size(); ++k)
      turn = std::hypot(
          turn, (points[i + 1][k] - points[i][k]) / chords[i] - (points[i][k] - points[i - 1][k]) / chords[i - 1]);
    squared_curvatures[i] = std::pow(2 * turn / (chords[i] + chords[i - 1]), 2);
  }
  squared_curvatures.front() = squared_curvatures[1];
  squared_curvatures.back() = squared_curvatures[points.size() - 2];
  for (std::size_t i = 0; i < chords.size(); ++i)
    result.push_back(result.back() +
                     chords[i] *
                         (1 + chords[i] * chords[i] * (squared_curvatures[i] + squared_curvatures[i + 1]) / 48));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Fitted_spline_d
Spline_fitting::least_squares(const std::vector<std::size_t>& breaks) const
{
  Fitted_spline_d result{{}, {}, m_is_closed, 0};
  for (const std::size_t i : breaks)
    result.breaks.push_back(m_parameters[i]);
  const Knot_axis<double> axis = cubic_axis(result.breaks, m_is_closed);
  const int size = static_cast<int>(m_is_closed ? breaks.size() - 1 : axis.size());
  const auto [matrix, right] = equations(axis, size);
  Eigen::SparseMatrix<double> normal = matrix.transpose() * matrix;
  for (int i = 0; i < size; ++i)
    if (is_fixed(i, size))
      normal.coeffRef(i, i) = 1;
  const Eigen::MatrixXd solution =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normal).solve(matrix.transpose() * right);
  for (int i = 0; i < size; ++i)
    if (is_fixed(i, size))
      result.control_points.push_back(end_of_curve(i));
    else {
      std::vector<double>& point = result.control_points.emplace_back();
      for (int k = 0; k < dimension(); ++k)
        point.push_back(solution(i, k));
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Eigen::SparseMatrix<double>, Eigen::MatrixXd>
Spline_fitting::equations(const Knot_axis<double>& axis, int size) const
{
  const int rows = static_cast<int>(m_samples.size() / 2);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right(rows, dimension());
  for (int row = 0; row < rows; ++row) {
    const std::size_t sample = 2 * static_cast<std::size_t>(row), span = span_of(axis, m_parameters[sample]);
    const std::vector<double> weights = derivative_weights(axis, span, m_parameters[sample], 0);
    for (int k = 0; k < dimension(); ++k)
      right(row, k) = m_samples[sample][k];
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const int control = static_cast<int>(span - 3 + i) % size;
      if (!is_fixed(control, size))
        entries.emplace_back(row, control, weights[i]);
      else
        for (int k = 0; k < dimension(); ++k)
          right(row, k) -= weights[i] * end_of_curve(control)[k];
    }
  }
  Eigen::SparseMatrix<double> matrix(rows, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return {std::move(matrix), std::move(right)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE void insert_middles(Double_points& points)
{
  Double_points result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    std::vector<double> middle = points[i];
    for (std::size_t k = 0; k < middle.size(); ++k)
      middle[k] = 0.5 * (middle[k] + points[i - 1][k]);
    result.push_back(std::move(middle));
    result.push_back(points[i]);
  }
  points = std::move(result);
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

a cubic spline, twice continuously differentiable, near a curve that is known by polylines: one of `solve_curves()`, in
the space of the unknowns or its image under a map, an intersection curve of surfaces, a bisector.

Every second point is fitted by least squares, all are compared with the spline. Pieces that are further away than the
tolerance are split, and where they have too few points the polyline is made finer. An open spline begins and ends where
the curve does, so that branches that meet in a singular point still do; a closed one is periodic. Corners and cusps
take many pieces.

\param polyline a function that returns points along the curve, in order, that are within a given distance of it:
`std::vector` of `std::vector<double>`, `CGAL::Point_2` or `CGAL::Point_3`. Those of a closed curve begin and end with
the same one.
\param is_closed whether the curve is closed.
\param tolerance the distance between curve and spline, positive. `Fitted_spline_d::error` tells what was measured; it
is larger only if \f$2^{15}\f$ points are not enough.
\throws Invalid_input when the tolerance is not positive, or the curve is one point.

Complexity: for each round of splitting, a banded linear system with as many unknowns as pieces; rounds are at most
logarithmic in the number of pieces as long as these are of similar length.

Source: \cgalCite{ek-gcs-01}, section 2.3; the parameter is not one of the unknowns but the arc length, so that no
choice fails where it is stationary.
*/
template <class Polyline>
  requires std::is_invocable_v<const Polyline&, double>
Fitted_spline_d fit_spline(const Polyline& polyline, bool is_closed, double tolerance)
{
  constexpr std::size_t most_samples = std::size_t(1) << 15;
  constexpr double first_error = 0x1p-8, refinement = 16;
  if (!(tolerance > 0))
    throw Invalid_input("fit_spline: the tolerance must be positive");
  double length = 0;
  const internal::Double_points rough = internal::distinct_points(polyline(std::numeric_limits<double>::infinity()));
  for (std::size_t i = 1; i < rough.size(); ++i)
    length += internal::distance(rough[i - 1], rough[i]);
  if (!(length > 0))
    throw Invalid_input("fit_spline: the curve is one point");
  for (double error = length * first_error;; error /= refinement) {
    internal::Double_points samples = internal::distinct_points(polyline(error));
    const bool is_straight = samples.size() < internal::Spline_fitting::least_samples();
    if (is_straight && error > tolerance / refinement)
      continue;
    while (samples.size() < internal::Spline_fitting::least_samples())
      internal::insert_middles(samples);
    const double chord_error = is_straight ? error : 0;   // middles of chords stand for the curve
    Fitted_spline_d result = internal::Spline_fitting(samples, is_closed)(tolerance - chord_error);
    result.error += chord_error;
    if (result.error <= tolerance || samples.size() > most_samples)
      return result;
  }
}

/*!
\ingroup PkgSplineConstraintsDGeometry

the same for a curve of solutions, in the space of the unknowns. Pieces that end in a singular point, a thousandth of
the domain long, count as straight, see `to_polyline()`.
\param system the system that was solved.
\param set its solutions.
\param curve one of their curves.
\param tolerance the distance; positive.
\throws Invalid_input when the tolerance is not positive.
*/
inline Fitted_spline_d fit_spline(const Constraint_system_d& system, const Curve_solution_set_d& set,
                                  const Solution_curve& curve, double tolerance)
{
  return fit_spline([&](double error) { return to_polyline(system, set, curve, error); }, curve.is_closed, tolerance);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SPLINE_FITTING_H
