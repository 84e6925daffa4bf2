// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENTS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Silhouette_event_kind.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Silhouette_event_finder.h>
#endif

#include <array>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

A time at which silhouettes change their topology, and where on the surface.
*/
template <SplineKernel Kernel>
struct Silhouette_event
{
  //! a closed range of exact numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;

  Silhouette_event_kind kind;     ///< what happens
  Range time;                     ///< a range that holds the time, by proof
  std::vector<Range> parameters;  ///< ranges of the parameters; of a pole, one is that of the whole edge
  typename Kernel::Point_3 point; ///< the point, up to rounding
};

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

The events of the silhouettes of a surface while the eye moves: between two of them, the topology of the silhouettes
does not change.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Silhouette_events_3
{
public:
  //! an event.
  using Event = Silhouette_event<Kernel>;

private:
  std::vector<Event> m_events;
  typename Event::Range m_times;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what `silhouette_events()` has found, with points of the kernel.
  explicit Silhouette_events_3(internal::Surface_curves::Found_silhouette_events found)
    : m_times(std::move(found.times)), m_undecided(std::move(found.undecided)), m_summary(found.summary)
  {
    for (const auto& [kind, box, point] : found.events)
      m_events.push_back({kind,
                          box.back(),
                          {box.begin(), box.end() - 1},
                          internal::kernel_object<Kernel, typename Kernel::Point_3>(point)});
  }

  //! the events by time. Those that come at one time, as symmetric ones do, are all there.
  const std::vector<Event>& events() const { return m_events; }

  //! a time in each of the intervals between events, in order, with those before the first and after the last one: seen
  //! from the eyes at these times, `silhouettes()` shows all topologies, if the result is complete.
  std::vector<Exact_rational> times_between() const
  {
    std::vector<Exact_rational> result;
    Exact_rational begin = m_times.first;
    const auto add_until = [&](const Exact_rational& end) {
      if (begin < end)
        result.push_back(
            simplest_rational_between(Exact_rational((3 * begin + end) / 4), Exact_rational((begin + 3 * end) / 4)));
    };
    for (const Event& event : m_events) {
      add_until(event.time.first);
      if (begin < event.time.second)
        begin = event.time.second;
    }
    add_until(m_times.second);
    return result;
  }

  //! where nothing is proved: boxes in space, with parameters of the surface, operand 0, and the time, of operand 1.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! whether these are all events, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! writes a line for each event.
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Silhouette_events_3<Kernel>& events)
{
  for (const Silhouette_event<Kernel>& event : events.events())
    out << event.kind << " at the time " << CGAL::to_double(event.time.first) << ", (" << event.point << ")\n";
  return out << events.undecided().size() << " undecided parts\n";
}

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the times at which the silhouettes of a surface change their topology while the eye moves along a path, each with what
happens there. The silhouettes are those of `silhouettes()`, curves on a transparent surface.

With the equation \f$f(u,v,t) = 0\f$ of the silhouettes seen from the path at the time \f$t\f$ they are found where
\f$f = f_u = f_v = 0\f$; on an edge or crease, where \f$f\f$ and its derivative along it are zero; and where \f$f = 0\f$
at a corner. At breaks where the derivatives jump, and at poles, the germ of \f$f\f$ tells whether something happens.
Birth and death are told from reconnection by the second derivatives, or by the signs of the first ones beside an edge,
all of them exactly or in proved intervals. Between the events the curves vary continuously on all parts of the surface
that creases bound; how curves are connected across creases does not count.

A generic event is at a parabolic point that is seen along its asymptotic direction, or where the eye passes through the
surface. Of higher singularities, those of several kinds at once, and those where breaks cross or a whole edge becomes a
silhouette, it is known that they are there, but not what happens (`DEGENERATE`). Developable surfaces, where a line
appears at once, are undecided where the eye may pass their tangent planes, and so is an eye that is on a smooth pole.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param path the path of the eye; its parameter is the time.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of three equations in three unknowns for each cell between breaks, of degrees at most \f$3d\f$ for
surfaces of degrees \f$d\f$, and the degree of the path. Source: \cgalCite{kes-gcps-05}, section 5, where the events are
seen in a picture.
*/
template <internal::Surface_curves::Surface_operand Surface>
Silhouette_events_3<internal::Surface_curves::Operand_kernel<Surface>>
silhouette_events(const Surface& surface,
                  const Bspline_curve_3<internal::Surface_curves::Operand_kernel<Surface>>& path,
                  const Solver_options& options = {})
{
  return Silhouette_events_3<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Surface_curves::silhouette_events_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                     internal::Common::exact_map<3>(path), false, options));
}

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves
the same for parallel views, while the direction changes.
\param surface,options as above.
\param directions the directions, of any length: points stand for the vectors from the origin to them. Where one is
zero, the answer is undecided.
\throws Invalid_input as above.
*/
template <internal::Surface_curves::Surface_operand Surface>
Silhouette_events_3<internal::Surface_curves::Operand_kernel<Surface>>
parallel_silhouette_events(const Surface& surface,
                           const Bspline_curve_3<internal::Surface_curves::Operand_kernel<Surface>>& directions,
                           const Solver_options& options = {})
{
  return Silhouette_events_3<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Surface_curves::silhouette_events_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                     internal::Common::exact_map<3>(directions), true, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENTS_H
