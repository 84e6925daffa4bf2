// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_OFFSET_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_OFFSET_SURFACES_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Envelope_collector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// A smooth part of a surface S = X / s with the normal n, and the unknowns u, v and w = |n|.
class Offset_of_part
{
  const Smooth_surface& m_surface;
  const Exact_rational& m_distance;
  std::shared_ptr<const Cell_breaks> m_breaks;

public:
  //! \pre All arguments live longer.
  Offset_of_part(const Smooth_surface& surface, const Exact_rational& distance)
    : m_surface(surface), m_distance(distance)
  {
    Cell_breaks breaks{surface.breaks[0], surface.breaks[1], {Exact_rational(0), Exact_rational(1)}};
    breaks[2][1] = length_bound(breaks);
    m_breaks = std::make_shared<Cell_breaks>(std::move(breaks));
  }

  Curve_vertex::Exact_box domain() const
  {
    return {m_surface.patch.domain(0), m_surface.patch.domain(1), {m_breaks->at(2).front(), m_breaks->at(2).back()}};
  }

  // w^2 - |n|^2
  Spline_function length() const
  {
    const Cell_vector n = normal();
    const Cell_polynomials w = length_unknown();
    return (w * w - n[0] * n[0] - n[1] * n[1] - n[2] * n[2]).function();
  }

  Vector_expression<3> image() const
  {
    const std::vector<Unknown> u = unknowns_in(domain());
    const std::span<const Unknown> place = std::span(u).first(2);
    return Parametric_vector<3>(m_surface.patch)(place) +
        Parametric_vector<3>(m_surface.normal)(place) * (Expression(m_distance) / u[2]);
  }

  /*
  What is zero where the offset O has cuspidal edges: w^2 det(O_u, O_v, n), that is

    w^2 det(S_u, S_v, n) + r w (det(S_u, n_v, n) + det(n_u, S_v, n)) + r^2 det(n_u, n_v, n),

  divided by what vanishes at poles, where S_u or S_v is zero and n keeps its direction.
  */
  Spline_function cusps() const
  {
    const Cell_vector n = normal(), a = scaled_tangent(m_surface.patch, m_breaks, 0),
                      b = scaled_tangent(m_surface.patch, m_breaks, 1), n_u = derivative(n, 0), n_v = derivative(n, 1);
    const Exact_function& weight = m_surface.patch.weight(); // S_u is a / s^2
    const Cell_polynomials w = length_unknown(), step = of_surface(weight * weight * m_distance);
    Cell_polynomials result = w * w * determinant(a, b, n) +
        step * w * (determinant(a, n_v, n) + determinant(n_u, b, n)) + step * step * determinant(n_u, n_v, n);
    for (const Constant_parameter& pole : m_surface.poles()) {
      const std::size_t end = pole.value == m_surface.patch.domain(pole.axis).first ? 0 : result.last_break(pole.axis);
      while (!result.is_zero() && result.is_zero_on(pole.axis, end))
        result = result.divided_at(pole.axis, end);
    }
    return result.without_weights(m_surface.patch).normalized().function();
  }

  // At a pole all points of the offset are one.
  std::vector<Envelope_pole> poles() const
  {
    std::vector<Envelope_pole> result;
    for (const Constant_parameter& pole : m_surface.poles())
      result.push_back({pole.axis, pole.value, true});
    return result;
  }

private:
  Cell_polynomials of_surface(const Exact_function& f) const { return {m_breaks, f, {0, 1}}; }
  Cell_vector normal() const { return cell_vector(m_surface.normal, m_breaks); }

  Cell_polynomials length_unknown() const
  {
    const std::vector<Exact_rational>& ends = m_breaks->at(2);
    return {m_breaks, std::vector<Bernstein_tensor<Exact_rational>>{{{1}, ends}}, 2};
  }

  // A number greater than |n|, by the Bernstein coefficients of |n|^2.
  Exact_rational length_bound(const Cell_breaks& breaks) const
  {
    const auto grid = std::make_shared<Cell_breaks>(breaks);
    const auto coordinate = [&](std::size_t i) { return Cell_polynomials(grid, m_surface.normal[i], {0, 1}); };
    const Cell_polynomials x = coordinate(0), y = coordinate(1), z = coordinate(2), square = x * x + y * y + z * z;
    Exact_rational most(0);
    for (const auto& cell : square.cells())
      most = (std::max)(most, cell.bounds().second);
    Exact_rational result(1);
    while (result * result <= most)
      result *= 2;
    while (result * result > 4 * most && most > 0)
      result /= 2;
    return Exact_rational(result * 2);
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 offset_surface_of(const Exact_map<3>& surface,
                                                                    const Exact_rational& distance,
                                                                    const Solver_options& options)
{
  Envelope_collector result(options);
  const Spline_patch<3> patch(surface);
  try {
    for (const Smooth_surface& part : smooth_surfaces(patch, [&] { result.budget().check(); })) {
      if (part.is_degenerate())
        throw Invalid_input("offset_surface: a piece of the surface is a curve or a point");
      result.budget().check();
      const Offset_of_part offset(part, distance);
      Constraint_system_d system(offset.domain());
      system.add(offset.length(), Relation::EQUAL);
      result.add(
          system, [&] { return offset.cusps(); }, offset.image(), part.closed_axes(), offset.poles());
    }
  } catch (const Run_stopped& stop) {
    result.add_undecided({patch.domain(0), patch.domain(1)}, in_words(stop.reason));
  }
  return std::move(result).result();
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_OFFSET_SURFACES_H
