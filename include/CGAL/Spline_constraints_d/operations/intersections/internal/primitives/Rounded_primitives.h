// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PRIMITIVES_ROUNDED_PRIMITIVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PRIMITIVES_ROUNDED_PRIMITIVES_H

#include <CGAL/Spline_constraints_d/geometry/healing/internal/Primitive_healer.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/implicitization/implicit_equation.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Visitor_reference.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

struct Recognised_primitive
{
  Primitive_kind kind;
  bool is_rounded; // it is one but for rounding
};

// The primitive that a parametric surface is, if any.
inline std::optional<Recognised_primitive> recognised_primitive(const Spline_patch<3>& patch)
{
  constexpr double share = 1e-9; // of the coordinates, much more than rounding and much less than details
  double greatest = 0;
  for (const Rational_interval& range : patch.values())
    greatest = (std::max)({greatest, std::abs(CGAL::to_double(range.lower)), std::abs(CGAL::to_double(range.upper))});
  if (!(greatest > 0))
    return std::nullopt;
  using Surface = Bspline_surface_3<Exact_kernel>;
  Run_control control(Solver_options{});
  const auto healed = Healing::healed_splines(
      {}, {Surface::from_homogeneous_coordinates(patch.numerators(), patch.weight())}, share * greatest, control);
  const auto& surface = healed.surfaces.front();
  const int degree = surface.kind == Primitive_kind::PLANE ? 1 : surface.kind == Primitive_kind::TORUS ? 4 : 2;
  if (surface.kind == Primitive_kind::GENERAL)
    return std::nullopt;
  return Recognised_primitive{surface.kind, surface.displacement != 0 && !Implicit_equation(patch, degree)()};
}

/*
Watches a run, for a visitor. Surfaces as programs for CAD write them, in doubles, are primitives but for rounding:
where they would touch or coincide, or have seams and poles on the other one, they are 1e-16 apart, which equations tell
in a million boxes of a width of 1e-8, or not at all. So a run on two such surfaces ends when the visitor was asked more
often than in any on primitives that comes to an answer, and is not limited otherwise.
*/
class Rounded_primitives
{
  const std::array<const Surface_shape*, 2> m_surfaces;
  const Visitor_reference m_visitor;
  const bool m_is_limited;
  std::array<std::optional<Recognised_primitive>, 2> m_primitives;
  std::size_t m_questions = 0;
  bool m_has_ended = false;

public:
  // How often the visitor is asked at most.
  static constexpr std::size_t most_questions = 11000;

  Rounded_primitives(const Surface_shape& first, const Surface_shape& second, const Solver_options& options)
    : m_surfaces{&first, &second}, m_visitor(options.visitor),
      m_is_limited(options.time_limit > 0 || options.node_limit > 0)
  {}

  void on_progress(double share) const { m_visitor.on_progress(share); }

  bool stop()
  {
    if (!m_is_limited && ++m_questions == most_questions)
      m_has_ended = are_rounded();
    return m_has_ended || m_visitor.stop();
  }

  // Why a run ended here; empty if it did not.
  std::string reason() const
  {
    if (!m_has_ended)
      return {};
    std::ostringstream out;
    out << "rounded";
    for (std::size_t k = 0; k < 2; ++k)
      if (m_primitives[k]->is_rounded)
        out << (k == 1 && m_primitives[0]->is_rounded ? " and " : " ") << m_primitives[k]->kind;
    out << "; heal with a tolerance";
    return out.str();
  }

private:
  // Both are primitives, and one of them is rounded at least.
  bool are_rounded()
  {
    for (std::size_t k = 0; k < 2; ++k) {
      if (m_surfaces[k]->patch)
        m_primitives[k] = recognised_primitive(*m_surfaces[k]->patch);
      if (!m_primitives[k])
        return false;
    }
    return m_primitives[0]->is_rounded || m_primitives[1]->is_rounded;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_PRIMITIVES_ROUNDED_PRIMITIVES_H
