// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SURFACE_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SURFACE_ZEROS_H

#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/operations/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A bounded surface: a model of `ParametricSurface_3` or an object of CGAL that is converted to one.
template <class Surface>
concept Surface_operand = Intersection_operand<Surface>::is_bounded && Intersection_operand<Surface>::number_of_parameters == 2 && Intersection_operand<Surface>::dimension == 3;

template <class Surface>
using Operand_kernel = typename Intersection_operand<Surface>::Kernel;

/*
The tangent planes n0 x + n1 y + n2 z + n3 = 0 of a surface X/w: n is the vector at right angles to (X, w) and to its two derivatives, which is a positive multiple of the normal and without denominators. It is divided by
factors that vanish along edges of the cells, as at a pole of a sphere.
*/
inline std::vector<Continuous_part<4>> tangent_planes(const Spline_patch<3>& patch)
{
  const Cell_functions<4> planes(patch, [](const Spline_patch<3>& cell) {
    const auto derivatives = [&](int axis) {
      Vector_of_functions<3> result;
      for (int i = 0; i < 3; ++i)
        result[i] = cell.numerators()[i].derivative(axis);
      return Vector_function<3>(result);
    };
    const Vector_function<3> x(cell.numerators()), along_u = derivatives(0), along_v = derivatives(1), across = cross(along_u, along_v);
    Vector_function<3> normal = across;
    if (cell.is_rational()) {
      const Scalar_function w = cell.weight(), w_u = cell.weight().derivative(0), w_v = cell.weight().derivative(1);
      normal = across * w + cross(along_v, x) * w_u + cross(x, along_u) * w_v;
    }
    const Vector_of_functions<3> n = normal.functions();
    return std::array<Exact_function, 4>{n[0], n[1], n[2], -dot(x, across).function()};
  });
  return continuous_parts(planes, true);
}

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

inline Expression formula(const Exact_function& f, std::span<const Unknown> u)
{
  const Exact_function zero = f * Exact_rational(0);
  return Parametric_vector<3>(Vector_of_functions<3>{f, zero, zero})(u)[0];
}

// Finds the zeros of functions on a surface.
template <SplineKernel Kernel>
class Surface_zeros
{
  Spline_patch<3> m_patch;
  Solver_options m_options;
  Surface_curves_3<Kernel> m_curves;
  std::array<bool, 2> m_is_closed;

public:
  Surface_zeros(const Spline_patch<3>& patch, const Solver_options& options)
    : m_patch(patch), m_options(options), m_curves([surface = Surface_shape(patch)](const std::vector<double>& unknowns) { return surface.point(std::vector<double>(unknowns.begin(), unknowns.begin() + 2)); }),
      m_is_closed{patch.is_closed(0), patch.is_closed(1)}
  {
    m_options.check();
  }

  const Surface_curves_3<Kernel>& curves() const { return m_curves; }

  // Adds the zeros of a function.
  void add(const Cell_functions<1>& function)
  {
    for (const Continuous_part<1>& part : continuous_parts(function, false)) {
      const Curve_vertex::Exact_box domain{part.functions.domain(0), part.functions.domain(1)};
      if (part.functions.is_zero()) {
        m_curves.add_undecided(domain);
        continue;
      }
      const std::vector<Unknown> u = unknowns({{domain[0].first, domain[0].second}, {domain[1].first, domain[1].second}});
      Constraint_system_d system(domain);
      system.add(formula(part.functions.splines()[0], u) == 0);
      Curve_solution_set_d solutions = solve_curves(system, m_options);
      m_curves.add(std::move(system), std::move(solutions), joints(part.functions), lines(part));
    }
  }

private:
  Domain_joints joints(const Cell_functions<1>& part) const
  {
    Domain_joints result;
    for (const int axis : {0, 1}) {
      const std::size_t unknown = static_cast<std::size_t>(axis);
      if (m_is_closed[unknown] && part.domain(axis) == m_patch.domain(axis) && part.ratio(axis, part.size(axis) - 1, 0))
        result.closed_unknowns.push_back(unknown);
      for (const Exact_rational& end : {part.domain(axis).first, part.domain(axis).second})
        if (is_pole(part, {axis, end}))
          result.poles.emplace_back(unknown, end);
    }
    return result;
  }

  bool is_pole(const Cell_functions<1>& part, const Constant_parameter& line) const
  {
    return m_patch.part(line.axis, {line.value, line.value}).part(0, part.domain(1 - line.axis)).is_one_point();
  }

  // Those that are curves in space, each once.
  std::vector<Surface_curve> lines(const Continuous_part<1>& part) const
  {
    std::vector<Surface_curve> result;
    for (const Constant_parameter& line : part.lines) {
      const int other = 1 - line.axis;
      const bool is_closed = m_is_closed[static_cast<std::size_t>(other)] && part.functions.domain(other) == m_patch.domain(other);
      const bool is_known = std::any_of(result.begin(), result.end(), [&](const Surface_curve& curve) { return are_same(*curve.line, line); });
      if (!is_known && !is_pole(part.functions, line))
        result.push_back({0, {}, is_closed, line});
    }
    return result;
  }

  // Also on both sides of a seam.
  bool are_same(const Constant_parameter& a, const Constant_parameter& b) const
  {
    const auto [begin, end] = m_patch.domain(a.axis);
    const auto is_end = [&, begin = begin, end = end](const Exact_rational& value) { return value == begin || value == end; };
    return a.axis == b.axis && (a.value == b.value || (m_is_closed[static_cast<std::size_t>(a.axis)] && is_end(a.value) && is_end(b.value)));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SURFACE_ZEROS_H
