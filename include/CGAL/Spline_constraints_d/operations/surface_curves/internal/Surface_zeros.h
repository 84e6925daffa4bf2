// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_ZEROS_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_curve_collector.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// The cells of a part of a grid, with one linear combination of the functions.
template <std::size_t k>
Cell_functions<1> combined(const Cell_functions<k>& functions, const std::array<Exact_rational, k>& factors)
{
  return functions.mapped([&](const std::array<Exact_function, k>& cell) {
    Exact_function result = cell[0] * factors[0];
    for (std::size_t i = 1; i < k; ++i)
      result = result + cell[i] * factors[i];
    return result;
  });
}

// A function of two unknowns.
inline Expression formula(const Exact_function& f, std::span<const Unknown> u)
{
  const Exact_function zero = f * Exact_rational(0);
  return Parametric_vector<3>(Vector_of_functions<3>{f, zero, zero})(u)[0];
}

// The parts of a surface where two of some unknowns, the first ones, are in a box.
inline std::vector<Undecided_part::Range> bounds_on_surface(const Spline_patch<3>& surface,
                                                            const Curve_vertex::Exact_box& box)
{
  const Parameter_box domain{surface.domain(0), surface.domain(1)};
  return double_ranges(surface.part(clipped({box[0], box[1]}, domain)).values());
}

// That the first two of some unknowns are the parameters of a surface, the first operand.
inline Place_of_unknowns place_on_surface(const Spline_patch<3>& patch)
{
  const Surface_shape surface(patch);
  return {[surface](const std::vector<double>& unknowns) {
            return surface.point(std::vector<double>(unknowns.begin(), unknowns.begin() + 2));
          },
          [patch](const Curve_vertex::Exact_box& box) { return bounds_on_surface(patch, box); },
          {2}};
}

// Whether a line is one point in space, over a part of the domain.
inline bool is_pole(const Spline_patch<3>& surface, const Cell_functions<1>& part, const Constant_parameter& line)
{
  return surface.part(line.axis, {line.value, line.value}).part(0, part.domain(1 - line.axis)).is_one_point();
}

// The axes along which a function has the same zeros at both ends, which are the same points in space.
inline std::array<bool, 2> seams(const Spline_patch<3>& surface, const Cell_functions<1>& part)
{
  const auto is_seam = [&](int axis) {
    return part.domain(axis) == surface.domain(axis) && surface.is_closed(axis) &&
        part.ratio(axis, part.size(axis) - 1, 0);
  };
  return {is_seam(0), is_seam(1)};
}

// Of the lines where a function vanishes, those that are curves in space, each once.
inline std::vector<Constant_parameter> lines_in_space(const Spline_patch<3>& surface, const Continuous_part<1>& part)
{
  std::vector<Constant_parameter> result;
  const auto is_end = [&](const Constant_parameter& line) {
    return line.value == surface.domain(line.axis).first || line.value == surface.domain(line.axis).second;
  };
  for (const Constant_parameter& line : part.lines) {
    const auto is_same = [&](const Constant_parameter& other) {
      return line == other ||
          (line.axis == other.axis && is_end(line) && is_end(other) && surface.is_closed(line.axis));
    };
    if (!is_pole(surface, part.functions, line) && std::none_of(result.begin(), result.end(), is_same))
      result.push_back(line);
  }
  return result;
}

// Finds the zeros of functions on a surface, within the limits of an operation.
class Surface_zeros
{
  Spline_patch<3> m_patch;
  Operation_budget& m_budget;
  Surface_curve_collector m_curves;

public:
  Surface_zeros(const Spline_patch<3>& patch, Operation_budget& budget)
    : Surface_zeros(patch, budget, place_on_surface(patch))
  {}

  // Of a surface that goes to infinity, where it is is not known from the patch.
  Surface_zeros(const Spline_patch<3>& patch, Operation_budget& budget, Place_of_unknowns place)
    : m_patch(patch), m_budget(budget), m_curves(std::move(place))
  {}

  const Found_surface_curves& curves() const { return m_curves.found(); }

  // Adds the zeros of a function. What it has at poles may be false, as where it vanishes since tangents do.
  void add(const Cell_functions<1>& function, bool has_false_poles = true)
  {
    if (m_budget.must_stop()) {
      add_undecided(m_budget.reason());
      return;
    }
    for (const Continuous_part<1>& part : continuous_parts(function, false)) {
      const Curve_vertex::Exact_box domain{part.functions.domain(0), part.functions.domain(1)};
      if (part.functions.is_zero() || m_budget.must_stop()) {
        m_curves.add_undecided(domain, part.functions.is_zero() ? Undecided_reason::CONTINUUM : m_budget.reason());
        continue;
      }
      Constraint_system_d system(domain);
      system.add(formula(part.functions.splines()[0], unknowns_in(domain)) == 0);
      Curve_solution_set_d solutions = curves_within_budget(system, m_budget);
      m_curves.add(std::move(system), std::move(solutions), joints(part.functions), lines(part));
      if (!has_false_poles)
        add_poles(part);
    }
  }

  // Where nothing is looked for: the whole surface.
  void add_undecided(Undecided_reason reason)
  {
    m_curves.add_undecided({m_patch.domain(0), m_patch.domain(1)}, reason);
  }

private:
  // Each once, though its factor may be there several times; in parts of a pole nothing is known of the others.
  void add_poles(const Continuous_part<1>& part)
  {
    for (auto line = part.lines.begin(); line != part.lines.end(); ++line)
      if (is_pole(m_patch, part.functions, *line) &&
          part.functions.domain(1 - line->axis) == m_patch.domain(1 - line->axis) &&
          std::find(part.lines.begin(), line, *line) == line)
        m_curves.add_pole(*line, !m_patch.is_closed(1 - line->axis));
  }

  Domain_joints joints(const Cell_functions<1>& part) const
  {
    Domain_joints result;
    const std::array<bool, 2> is_seam = seams(m_patch, part);
    for (const std::size_t unknown : {0, 1}) {
      const int axis = static_cast<int>(unknown);
      if (is_seam[unknown])
        result.closed_unknowns.push_back(unknown);
      for (const Exact_rational& end : {part.domain(axis).first, part.domain(axis).second})
        if (is_pole(m_patch, part, {axis, end}))
          result.poles.emplace_back(unknown, end);
    }
    return result;
  }

  std::vector<Surface_curve> lines(const Continuous_part<1>& part) const
  {
    std::vector<Surface_curve> result;
    for (const Constant_parameter& line : lines_in_space(m_patch, part)) {
      const int other = 1 - line.axis;
      result.push_back(
          {0, {}, m_patch.is_closed(other) && part.functions.domain(other) == m_patch.domain(other), line});
    }
    return result;
  }
};

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SURFACE_ZEROS_H
