// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UMBILIC_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UMBILIC_FINDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// L F - M E and L G - N E in each piece of a surface S = X/w, times positive factors: the derivatives of S are positive
// multiples of the tangents, and <p,(X,w)_uu> is one of L for the tangent plane p.
// Before each piece `check()` may end the work by an exception.
template <class Check>
Cell_functions<2> fundamental_form_minors(const Spline_patch<3>& surface, const Check& check)
{
  return Cell_functions<2>(surface, [&](const Spline_patch<3>& cell) {
    check();
    const Vector_function<3> along_u(tangent_direction(cell, 0)), along_v(tangent_direction(cell, 1));
    const std::array<Exact_function, 3> second = second_form(cell);
    const Exact_function first_uu = dot(along_u, along_u).function(), first_uv = dot(along_u, along_v).function(),
                         first_vv = dot(along_v, along_v).function();
    return std::array<Exact_function, 2>{second[0] * first_uv - second[1] * first_uu,
                                         second[0] * first_vv - second[2] * first_uu};
  });
}

// Finds the umbilics of a surface.
class Umbilic_finder
{
  using Box = Exact_ranges;

  const Spline_patch<3>& m_patch;
  Budgeted_solver m_solver;
  std::vector<std::pair<Box, Undecided_reason>> m_undecided;
  Found_umbilics m_found;

public:
  Umbilic_finder(const Spline_patch<3>& patch, const Solver_options& options) : m_patch(patch), m_solver(options) {}

  Found_umbilics operator()()
  {
    try {
      find();
    } catch (const Run_stopped& stop) {
      m_undecided.emplace_back(Box{m_patch.domain(0), m_patch.domain(1)}, stop.reason);
    }
    for (const auto& [box, reason] : m_undecided)
      m_found.undecided.push_back({bounds_on_surface(m_patch, box), {{0, double_ranges(box)}}, in_words(reason)});
    m_found.summary = m_solver.total();
    m_found.summary.is_complete = m_undecided.empty();
    return std::move(m_found);
  }

private:
  void find()
  {
    for (const Continuous_part<2>& part :
         continuous_parts(fundamental_form_minors(m_patch, [this] { m_solver.budget().check(); }), false)) {
      const Box domain{part.functions.domain(0), part.functions.domain(1)};
      for (const Constant_parameter& line : part.lines)
        add_line(domain, line);
      if (part.functions.is_zero())
        m_undecided.emplace_back(domain, Undecided_reason::CONTINUUM);
      else
        add_zeros(part.functions, domain);
    }
  }

  // A pole, a singular edge, or a curve of umbilics.
  void add_line(Box domain, const Constant_parameter& line)
  {
    domain[static_cast<std::size_t>(line.axis)] = {line.value, line.value};
    const auto is_it = [&](const auto& known) { return known.first == domain; };
    if (std::none_of(m_undecided.begin(), m_undecided.end(), is_it))
      m_undecided.emplace_back(std::move(domain), Undecided_reason::CONTINUUM);
  }

  void add_zeros(const Cell_functions<2>& functions, const Box& domain)
  {
    const std::vector<Unknown> u = unknowns_in(domain);
    const auto [first, second] = functions.splines();
    const std::array<bool, 2> is_seam{is_seam_of(functions, 0), is_seam_of(functions, 1)};
    const Solution_set_d<double> zeros =
        m_solver(std::vector<Constraint>{formula(first, u) == 0, formula(second, u) == 0}, u);
    for (const Solution_d<double>& zero : zeros) {
      const Box box = zero.exact_box();
      if (is_again(zeros, box, domain, is_seam))
        continue;
      const bool is_point = zero.kind() == Solution_kind::CERTIFIED || zero.kind() == Solution_kind::CLUSTER;
      if (is_point && is_regular(box))
        m_found.points.emplace_back(place_on_surface(m_patch).point(zero.point()), zero);
      else
        m_undecided.emplace_back(box,
                                 is_point                                      ? Undecided_reason::TOLERANCE
                                     : zero.kind() == Solution_kind::CONTINUUM ? Undecided_reason::CONTINUUM
                                                                               : zero.reason());
    }
  }

  bool is_seam_of(const Cell_functions<2>& functions, int axis) const
  {
    return functions.domain(axis) == m_patch.domain(axis) && m_patch.is_closed(axis) &&
        functions.ratio(axis, functions.size(axis) - 1, 0);
  }

  // What is at the upper end of a seam and at its lower end is one point, there once.
  static bool is_again(const Solution_set_d<double>& zeros, const Box& box, const Box& domain,
                       const std::array<bool, 2>& is_seam)
  {
    for (const std::size_t axis : {0, 1})
      if (is_seam[axis] && domain[axis].second <= box[axis].second) {
        Box other = box;
        other[axis] = {domain[axis].first, domain[axis].first};
        if (std::any_of(zeros.begin(), zeros.end(),
                        [&](const Solution_d<double>& zero) { return touch(zero.exact_box(), other); }))
          return true;
      }
    return false;
  }

  // Where E > 0, by proof, the third minor M G - N F vanishes with the others: all coefficients of the square of the
  // normal are positive on a box.
  bool is_regular(const Box& box) const
  {
    Box wide = box;
    for (std::size_t axis : {0, 1})
      if (const Parameter_range range = m_patch.domain(static_cast<int>(axis));
          !(box[axis].first < box[axis].second) || box[axis].first < range.first || range.second < box[axis].second) {
        const Exact_rational margin = Exact_rational((range.second - range.first) / (1 << 20));
        wide[axis] = {(std::max)(Exact_rational(box[axis].first - margin), range.first),
                      (std::min)(Exact_rational(box[axis].second + margin), range.second)};
      }
    const Spline_patch<3> part = m_patch.part({wide[0], wide[1]});
    for (int i = 0; i + 1 < static_cast<int>(part.breaks(0).size()); ++i)
      for (int j = 0; j + 1 < static_cast<int>(part.breaks(1).size()); ++j) {
        const Spline_patch<3> cell =
            part.part({{part.breaks(0)[i], part.breaks(0)[i + 1]}, {part.breaks(1)[j], part.breaks(1)[j + 1]}});
        const std::array<Exact_function, 4> plane = tangent_plane(cell);
        const Exact_function square = plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2];
        if (!std::all_of(square.coefficients().begin(), square.coefficients().end(),
                         [](const Exact_rational& x) { return x > 0; }))
          return false;
      }
    return true;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Found_umbilics umbilics_of(const Exact_map<3>& surface, const Solver_options& options)
{
  const Spline_patch<3> patch(surface);
  return Umbilic_finder(patch, options)();
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_UMBILIC_FINDER_H
