// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAPPING_PATCHES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAPPING_PATCHES_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/patch_cells.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Implicit_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Patch_inverse.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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
namespace Intersections {

/*
Whether two patches are proved to have an open part in common, by tests that take little time where they do not: they
are the same map on some ranges of their parameters, but for an affine change of these; or an inner point of one is one
of the other, and both are in the zeros of one polynomial there.
*/
class Overlapping_patches
{
  using Tensor = Bernstein_tensor<Exact_rational>;
  using Exact_point = std::array<Exact_rational, 3>;

  const Surface_equations& m_surfaces;

public:
  //! \pre Both surfaces are parametric.
  explicit Overlapping_patches(const Surface_equations& surfaces) : m_surfaces(surfaces) {}

  // `equation(k)` is the polynomial of a surface, or null; that of the second one is asked for only if the first one is
  // zero in a point of the second surface.
  template <class Equation>
  bool operator()(const Equation& equation) const
  {
    if (are_same_map())
      return true;
    const Power_polynomial* const first = equation(0);
    if (first == nullptr || !CGAL::is_zero((*first)(point_of_no_symmetry(patch(1))))) // most pairs end here
      return false;
    const Power_polynomial* const second = equation(1);
    return has_inner_point_on(0, *first) || (second != nullptr && has_inner_point_on(1, *second));
  }

private:
  const Spline_patch<3>& patch(std::size_t surface) const { return *m_surfaces.surface(surface).patch; }

  // Parameters with their meaning, or the whole domains onto each other; in both cases exchanged or not.
  bool are_same_map() const
  {
    const std::array<Parameter_range, 2> a{patch(0).domain(0), patch(0).domain(1)},
        b{patch(1).domain(0), patch(1).domain(1)};
    for (const bool is_exchanged : {false, true}) {
      const std::size_t first = is_exchanged ? 1 : 0;
      const std::array<Parameter_range, 2> common{intersection_of(a[0], b[first]), intersection_of(a[1], b[1 - first])};
      const auto exchanged = is_exchanged ? std::array{common[1], common[0]} : common;
      if (is_range(common[0]) && is_range(common[1]) && have_equal_middles(common, exchanged) &&
          is_same_map(common, exchanged, is_exchanged, {false, false}))
        return true;
    }
    if (!have_equal_middles(a, b))
      return false;
    for (const bool is_exchanged : {false, true})
      for (const bool is_first_reversed : {false, true})
        for (const bool is_second_reversed : {false, true})
          if (is_same_map(a, b, is_exchanged, {is_first_reversed, is_second_reversed}))
            return true;
    return false;
  }

  // The middle of a surface is often on another one.
  static Exact_point point_of_no_symmetry(const Spline_patch<3>& surface)
  {
    const auto at = [&](int axis, int share) {
      const auto [begin, end] = surface.domain(axis);
      return Exact_rational(begin + (end - begin) * share / 32);
    };
    return surface(std::array<Exact_rational, 2>{at(0, 11), at(1, 19)});
  }

  static Parameter_range intersection_of(const Parameter_range& a, const Parameter_range& b)
  {
    return {(std::max)(a.first, b.first), (std::min)(a.second, b.second)};
  }

  static bool is_range(const Parameter_range& range) { return range.first < range.second; }

  // Up to rounding.
  bool have_equal_middles(const std::array<Parameter_range, 2>& a, const std::array<Parameter_range, 2>& b) const
  {
    const auto middle = [&](std::size_t surface, const std::array<Parameter_range, 2>& ranges) {
      return m_surfaces.surface(surface).point(
          std::vector<double>{to_nearest_double(middle_of(ranges[0])), to_nearest_double(middle_of(ranges[1]))});
    };
    const std::array<double, 3> p = middle(0, a), q = middle(1, b);
    double size = 0, difference = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      size = (std::max)({size, std::abs(p[i]), std::abs(q[i])});
      difference = (std::max)(difference, std::abs(p[i] - q[i]));
    }
    return difference <= 0x1p-30 * size;
  }

  bool is_same_map(const std::array<Parameter_range, 2>& a, const std::array<Parameter_range, 2>& b, bool is_exchanged,
                   const std::array<bool, 2>& is_reversed) const
  {
    const Spline_patch<3> first = patch(0).part({a[0], a[1]}), second = patch(1).part({b[0], b[1]});
    const auto on_first = [&](Exact_function f) {
      if (is_exchanged)
        f = internal::transposed(f);
      for (int axis = 0; axis < 2; ++axis) {
        if (is_reversed[static_cast<std::size_t>(axis)])
          f = internal::reversed(f, axis);
        const auto& [begin, end] = a[static_cast<std::size_t>(axis)];
        if (f.domain(axis) != Parameter_range(begin, end))
          f = internal::with_domain(f, axis, begin, end);
      }
      return f;
    };
    const Exact_function weight = on_first(second.weight());
    for (int i = 0; i < 3; ++i)
      if (!(first.numerators()[i] * weight == on_first(second.numerators()[i]) * first.weight()))
        return false;
    return true;
  }

  // Whether a point inside the other surface, which lies on the zeros of f around it, is inside an implicit one.
  bool has_inner_point_on(std::size_t implicit, const Power_polynomial& f) const
  {
    const Spline_patch<3>& other = patch(1 - implicit);
    const std::optional<Implicit_patch> own = Implicit_patch::make(patch(implicit), f);
    if (!own)
      return false;
    const Patch_inverse inverse(m_surfaces.surface(implicit));
    bool result = false;
    for_each_cell(other, [&](const Patch_cell& cell) {
      result = result || (vanishes(composed(f, f.total_degree(), cell.functions)) && has_point_of(*own, inverse, cell));
    });
    return result;
  }

  static bool vanishes(const Tensor& values)
  {
    return std::all_of(values.coefficients().begin(), values.coefficients().end(),
                       [](const Exact_rational& x) { return x == 0; });
  }

  static bool has_point_of(const Implicit_patch& own, const Patch_inverse& inverse, const Patch_cell& cell)
  {
    constexpr int steps = 8;
    int proofs = 2; // that are tried
    for (int i = 1; i < steps; ++i)
      for (int j = 1; j < steps; ++j) {
        const std::array<Exact_rational, 2> u{Exact_rational(i) / steps, Exact_rational(j) / steps};
        const Exact_point p = point_at(cell, u);
        const bool is_inside = std::all_of(own.sides().begin(), own.sides().end(),
                                           [&](const Power_polynomial& side) { return side(p) > 0; });
        if (!is_inside || !is_regular_at(cell, u))
          continue;
        Vector_bounds<3> bounds;
        for (std::size_t k = 0; k < 3; ++k)
          bounds[k] = Rational_interval(p[k]);
        if (own.contains(bounds, inverse({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])})))
          return true;
        if (--proofs == 0)
          return false;
      }
    return false;
  }

  static Exact_point point_at(const Patch_cell& cell, const std::array<Exact_rational, 2>& u)
  {
    const Exact_rational weight = cell.functions[3](u);
    Exact_point result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = cell.functions[i](u) / weight;
    return result;
  }

  static bool is_regular_at(const Patch_cell& cell, const std::array<Exact_rational, 2>& u)
  {
    const Exact_rational weight = cell.functions[3](u);
    std::array<Exact_point, 2> tangents;
    for (int axis = 0; axis < 2; ++axis)
      for (std::size_t i = 0; i < 3; ++i)
        tangents[static_cast<std::size_t>(axis)][i] = cell.functions[i].derivative(axis)(u) * weight -
            cell.functions[i](u) * cell.functions[3].derivative(axis)(u);
    const auto& [a, b] = tangents;
    return a[1] * b[2] != a[2] * b[1] || a[2] * b[0] != a[0] * b[2] || a[0] * b[1] != a[1] * b[0];
  }
};

// Whether two height fields over the same coordinates have an open part in common, in the parameters of one of them:
// where their difference is zero in a whole cell.
inline bool are_overlapping_height_fields(const Surface_equations& surfaces)
{
  const std::vector<Spline_function>& equations = surfaces.system().equalities();
  if (!surfaces.are_height_fields() || equations.size() != 1)
    return false;
  const auto is_zero_piece = [](const std::vector<Exact_rational>& piece) {
    return std::all_of(piece.begin(), piece.end(), [](const Exact_rational& x) { return x == 0; });
  };
  const auto& terms = equations.front().terms();
  return terms.empty() ||
      (terms.size() == 1 && std::any_of(terms[0].pieces.begin(), terms[0].pieces.end(), is_zero_piece));
}

// All is undecided of two surfaces that overlap.
inline Solved_part overlapping_part(const Surface_equations& surfaces)
{
  Parameter_box domain;
  for (int unknown = 0; unknown < surfaces.system().dimension(); ++unknown)
    domain.push_back(surfaces.system().domain(unknown));
  Summary summary;
  summary.is_complete = false;
  summary.why_not = Undecided_reason::CONTINUUM;
  Solved_part result{surfaces,
                     Curve_solution_set_d({}, {}, {}, {}, {{{domain}, {}, Undecided_reason::CONTINUUM}}, summary)};
  result.is_overlap = true;
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_OVERLAPPING_PATCHES_H
