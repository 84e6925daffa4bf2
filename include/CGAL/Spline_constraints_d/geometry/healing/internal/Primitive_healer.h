// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_PRIMITIVE_HEALER_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_PRIMITIVE_HEALER_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/healing/Primitive_kind.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Known_frames.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/closed_splines.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/exact_shapes.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/healed_splines.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/measured_shapes.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/movement_bound.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

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
namespace Healing {

// Curves in d-space, and surfaces if that is space, that are made exact together.
template <int d>
class Primitive_healer
{
public:
  using Curve = Bspline_curve<Exact_kernel, d>;

  // Unless it is stopped, all are done.
  Primitive_healer(std::vector<Curve> curves, std::vector<Exact_surface> surfaces, double tolerance,
                   Run_control& control)
    : m_tolerance(tolerance), m_control(&control)
  {
    for (Curve& curve : curves)
      m_curves.push_back({{std::move(curve)}});
    for (Exact_surface& surface : surfaces)
      m_surfaces.push_back({{std::move(surface)}});
    if (!for_each_job([&](auto& job) { measure(job); }))
      return;
    const double extent = (std::max)(greatest_extent(), m_tolerance);
    Known_frames frames(m_tolerance / 32, extent);
    // Those that say most on where others are come first.
    const bool is_complete =
        for_each_surface([&](Surface_job& job) {
          if (job.revolution && job.revolution->kind != Primitive_kind::SPHERE)
            take_revolution(job, frames);
        }) &&
        for_each_curve([&](Curve_job& job) {
          if (job.arc)
            take_arc(job, frames);
        }) &&
        for_each_surface([&](Surface_job& job) {
          if (job.revolution && job.revolution->kind == Primitive_kind::SPHERE)
            take_revolution(job, frames);
        }) &&
        for_each_surface([&](Surface_job& job) {
          if (job.plane && !job.result.is_done())
            take(job, Primitive_kind::PLANE, exact_plane(*job.clamped, job.points, *job.plane, frames));
        }) &&
        for_each_curve([&](Curve_job& job) {
          if (!job.points.empty() && !job.result.is_done())
            if (const auto line = exact_line<d>(*job.clamped, job.points, frames))
              take(job, Primitive_kind::LINE, *line);
        });
    m_frame = frames.simplest_frame();
    if (is_complete)
      close_general(m_tolerance / extent, frames);
  }

  Healed_splines<d> result() const
  {
    return {results<Healed_spline<Curve>>(m_curves), results<Healed_spline<Exact_surface>>(m_surfaces), m_frame.axes(),
            m_frame.origin()};
  }

private:
  template <class Spline>
  struct Job
  {
    Healed_spline<Spline> result;
    std::optional<Spline> clamped = {};     // none where a weight of a control point is not positive
    std::vector<Rounded_point> points = {};   // its control points
  };

  struct Curve_job : Job<Curve>
  {
    std::optional<Measured_arc> arc = {};
  };

  struct Surface_job : Job<Exact_surface>
  {
    std::optional<Measured_revolution> revolution = {};
    std::optional<Measured_pose> plane = {};
  };

  double m_tolerance;
  Run_control* m_control;
  std::vector<Curve_job> m_curves;
  std::vector<Surface_job> m_surfaces;
  Rational_frame m_frame = Rational_frame::identity();

  // Whether it was not stopped.
  template <class Jobs, class Work>
  bool for_each_of(Jobs& jobs, const Work& work)
  {
    for (auto& job : jobs) {
      if (m_control->must_stop(true))
        return false;
      work(job);
    }
    return true;
  }
  template <class Work>
  bool for_each_curve(const Work& work)
  {
    return for_each_of(m_curves, work);
  }
  template <class Work>
  bool for_each_surface(const Work& work)
  {
    return for_each_of(m_surfaces, work);
  }
  template <class Work>
  bool for_each_job(const Work& work)
  {
    return for_each_curve(work) && for_each_surface(work);
  }

  template <class Result, class Jobs>
  static std::vector<Result> results(const Jobs& jobs)
  {
    std::vector<Result> result;
    for (const auto& job : jobs)
      result.push_back(job.result);
    return result;
  }

  template <class Spline>
  void clamp(Job<Spline>& job)
  {
    const auto& map = job.result.spline.representation();
    for (std::size_t k = 0; k < map.numerator(0).coefficients().size(); ++k)
      if (!(map.control_weight(k) > 0))
        return;
    Spline clamped = job.result.spline;
    for (int axis = 0; axis < map.dimension(); ++axis) {
      const std::vector<Exact_rational> knots = map.numerator(0).knots(axis);
      const auto [begin, end] = map.numerator(0).domain(axis);
      if (knots.front() != begin || knots.back() != end)
        clamped = Spline(clamped.representation().mapped(
            [&, axis, first = begin, last = end](const auto& f) { return f.restricted(axis, first, last); }));
    }
    job.clamped = std::move(clamped);
    job.points = rounded_control_points(job.clamped->representation());
  }

  // What rounded to doubles is no spline was not written by a program that computes with doubles: it is general.
  template <class Any_job>
  void measure(Any_job& job)
  {
    clamp(job);
    try {
      if (job.clamped)
        look_at(job);
    } catch (const Invalid_input&) {
    }
  }

  void look_at(Curve_job& job)
  {
    using Rounded_curve = Bspline_curve<Rounded_kernel, d>;
    const Rounded_curve rounded(*job.clamped);
    const auto at = [&](double u) {
      const auto p = rounded(u);
      return Rounded_point(p[0], p[1], d == 3 ? p[d - 1] : 0);
    };
    job.arc = measured_arc(at, rounded.breaks(), m_tolerance);
  }

  void look_at(Surface_job& job)
  {
    job.plane = measured_plane(job.points, m_tolerance);
    const Bspline_surface_3<Rounded_kernel> rounded(*job.clamped);
    for (int turn = 0; turn < 2 && !job.revolution; ++turn)
      job.revolution = measured_revolution(rounded, turn, m_tolerance);
  }

  double greatest_extent() const
  {
    std::array<double, 3> least, greatest;
    bool is_first = true;
    const auto add = [&](const auto& jobs) {
      for (const auto& job : jobs)
        for (const Rounded_point& p : job.points)
          for (std::size_t i = 0; i < 3; ++i) {
            const double x = p[static_cast<int>(i)];
            least[i] = is_first && &p == &job.points.front() ? x : (std::min)(least[i], x);
            greatest[i] = is_first && &p == &job.points.front() ? x : (std::max)(greatest[i], x);
            is_first = is_first && i < 2;
          }
    };
    add(m_curves);
    add(m_surfaces);
    return is_first ? 0 : (std::max)({greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]});
  }

  // Takes what was made of a spline, if it, at the same parameters, is proved to be as near as asked for; or another
  // one in its place with the same points at other parameters.
  template <class Spline>
  void take(Job<Spline>& job, Primitive_kind kind, const Spline& made)
  {
    take(job, kind, made, [&] { return made; });
  }

  template <class Spline, class Make>
  void take(Job<Spline>& job, Primitive_kind kind, const Spline& made, const Make& same_points)
  {
    const auto bound = movement_bound(job.clamped->representation(), made.representation());
    if (bound && *bound <= m_tolerance)
      job.result = {same_points(), kind, *bound};
  }

  void take_revolution(Surface_job& job, Known_frames& frames)
  {
    const Rational_frame frame = frames.placed(job.revolution->pose);
    const auto made = [&](bool has_kept_parameters) {
      return exact_revolution(*job.clamped, *job.revolution, frame, frames, has_kept_parameters);
    };
    take(job, job.revolution->kind, made(true), [&] { return made(false); });
  }

  void take_arc(Curve_job& job, Known_frames& frames)
  {
    const Rational_frame frame = frames.placed(job.arc->pose);
    const auto made = [&](bool has_kept_parameters) {
      return exact_arc<d>(*job.clamped, *job.arc, frame, frames, has_kept_parameters);
    };
    take(job, Primitive_kind::CIRCLE, made(true), [&] { return made(false); });
  }

  void close_general(double relative, const Known_frames& frames)
  {
    Known_points<d> points_of_curves(m_tolerance / 4);
    Known_points<3> points_of_surfaces(m_tolerance / 4);
    auto& own_points = [&]() -> auto&
    {
      if constexpr (d == 3)
        return points_of_surfaces;
      else
        return points_of_curves;
    }
    ();
    // Corners of what has been recognised are known before.
    for_each_curve([&](Curve_job& job) { add_corners(job, own_points); }) &&
        for_each_surface([&](Surface_job& job) { add_corners(job, points_of_surfaces); }) &&
        for_each_curve([&](Curve_job& job) { close(job, relative, frames, own_points); }) &&
        for_each_surface([&](Surface_job& job) { close(job, relative, frames, points_of_surfaces); });
  }

  template <class Spline, int n>
  void add_corners(const Job<Spline>& job, Known_points<n>& points)
  {
    if (!job.result.is_done())
      return;
    const auto& map = job.result.spline.representation();
    const Exact_function& f = map.numerator(0);
    const std::size_t rows = f.dimension() == 2 ? f.size(0) : 2, columns = f.dimension() == 2 ? f.size(1) : f.size(0);
    for (const std::size_t i : {std::size_t(0), f.dimension() == 2 ? rows - 1 : 0})
      for (const std::size_t j : {std::size_t(0), columns - 1})
        points.at(map.control_point(i * columns + j));
  }

  template <class Spline, int n>
  void close(Job<Spline>& job, double relative, const Known_frames& frames, Known_points<n>& points)
  {
    if (job.result.is_done())
      return;
    job.result.kind = Primitive_kind::GENERAL;
    if (!job.clamped)
      return;
    const Closed_spline<n> closed(job.clamped->representation(), relative, frames, m_frame, points);
    if (!closed.is_changed)
      return;
    const auto bound = movement_bound(job.clamped->representation(), closed.spline);
    if (bound && *bound <= m_tolerance)
      job.result = {Spline(closed.spline), Primitive_kind::GENERAL, *bound};
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Healed_splines<2> healed_splines(std::vector<Bspline_curve<Exact_kernel, 2>> curves,
                                                                double tolerance, Run_control& control)
{
  return Primitive_healer<2>(std::move(curves), {}, tolerance, control).result();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Healed_splines<3> healed_splines(std::vector<Bspline_curve<Exact_kernel, 3>> curves,
                                                                std::vector<Bspline_surface_3<Exact_kernel>> surfaces,
                                                                double tolerance, Run_control& control)
{
  return Primitive_healer<3>(std::move(curves), std::move(surfaces), tolerance, control).result();
}

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_PRIMITIVE_HEALER_H
