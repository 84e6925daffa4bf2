// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SWEEP_ENVELOPES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SWEEP_ENVELOPES_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Cell_polynomials.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Envelope_collector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Motion_field.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Smooth_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
A smooth part of a surface S = X / s during a part of a motion: with the normal n and the field B, b of the motion, seen
from the moving space, the surface touches its envelope where

  F(u, v, t) = <B X + b s, n> = 0.
*/
class Moving_patch
{
  const Smooth_surface& m_surface;
  const Spline_patch<3>& m_patch;
  const Vector_of_functions<3>& m_normal;
  const Rational_motion_3& m_motion;
  const Motion_part& m_field;
  std::shared_ptr<const Cell_breaks> m_breaks;

public:
  //! \pre All arguments live longer.
  Moving_patch(const Smooth_surface& surface, const Rational_motion_3& motion, const Motion_part& field)
    : m_surface(surface), m_patch(surface.patch), m_normal(surface.normal), m_motion(motion), m_field(field),
      m_breaks(std::make_shared<Cell_breaks>(Cell_breaks{surface.breaks[0], surface.breaks[1], field.times}))
  {}

  Curve_vertex::Exact_box domain() const
  {
    return {m_patch.domain(0), m_patch.domain(1), {m_field.times.front(), m_field.times.back()}};
  }

  // F, of the sign that makes the envelope of a ball on a long path face outwards. It is divided by what is zero at all
  // times on a line of constant u or v: on an edge that is one point, or a line whose points always touch the envelope.
  struct Contact
  {
    Cell_polynomials function;
    std::vector<Constant_parameter> touching_lines;
    std::vector<Envelope_pole> poles; // those with one tangent plane
  };
  Contact contact(Envelope_use use) const
  {
    const Cell_vector n = normal(), v = velocity();
    const Cell_polynomials product = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    Contact result{product - product - product, {}, {}};
    if (result.function.is_zero())
      return result;
    if (use == Envelope_use::BOUNDARY)
      for (const std::size_t end : {std::size_t(0), result.function.last_break(2)})
        while (result.function.is_zero_on(2, end))
          result.function = result.function.divided_at(2, end);
    std::vector<Constant_parameter>& lines = result.touching_lines;
    for (const int axis : {0, 1})
      for (std::size_t k = 0; k <= result.function.last_break(axis); ++k) {
        const Constant_parameter line{axis, (*m_breaks)[static_cast<std::size_t>(axis)][k]};
        const bool is_pole = m_patch.pole(axis, line.value).has_value();
        bool is_divided = false;
        while (result.function.is_zero_on(axis, k)) {
          Cell_polynomials rest = result.function.divided_at(axis, k);
          if (!rest.is_continuous_at(axis, k))
            break;
          result.function = std::move(rest);
          is_divided = true;
        }
        if (is_divided && !is_pole)
          lines.push_back(line);
        if (is_pole && m_surface.has_one_normal(line))
          result.poles.push_back({axis, line.value, !is_divided});
      }
    std::erase_if(lines, [&](const Constant_parameter& line) { return is_copy_on_seam(line); });
    return result;
  }

  Vector_expression<3> image() const
  {
    const std::vector<Unknown> u = unknowns_in(domain());
    return moved(Parametric_vector<3>(m_patch)(std::span(u).first(2)), u[2]);
  }

  // What a line of constant u or v sweeps, as all solutions of one equation: that its parameter has this value. The
  // range of that goes beyond the value on both sides, so that the line is not on the boundary. It is oriented as F is
  // with the factor that vanishes there.
  struct Swept_line
  {
    Constraint_system_d system;
    Vector_expression<3> image;
  };
  Swept_line swept(const Constant_parameter& line, const Contact& contact) const
  {
    const auto axis = static_cast<std::size_t>(line.axis);
    Curve_vertex::Exact_box box = domain();
    Cell_breaks breaks = *m_breaks;
    box[axis] = {Exact_rational(line.value - 1), Exact_rational(line.value + 1)};
    breaks[axis] = {box[axis].first, box[axis].second};
    const int side = contact.function.sign_on(line.axis, line.value) * sign_of_factors(line, contact.touching_lines);
    const Bernstein_tensor<Exact_rational> distance({1}, {Exact_rational(-side), Exact_rational(side)});
    const std::size_t cells = (breaks[0].size() - 1) * (breaks[1].size() - 1) * (breaks[2].size() - 1);
    Constraint_system_d system(box);
    system.add(
        Spline_function::from_bezier_pieces(
            {0, 1, 2}, breaks, std::vector<Bernstein_tensor<Exact_rational>>(cells, distance.embedded(3, {line.axis}))),
        Relation::EQUAL);
    const std::vector<Unknown> u = unknowns_in(box);
    const Parametric_vector<3> curve(m_patch.part(line.axis, {line.value, line.value}));
    return {std::move(system), moved(curve(std::span(u).subspan(1 - axis, 1)), u[2])};
  }

  /*
  What is zero where the envelope has a cuspidal edge, or no tangent plane. With the velocity V, seen from the moving
  space and tangent to S where F = 0, points of the envelope do not move where

    F_t - dF(V) = 0,   |S_u x S_v| dF(V) = <V x S_v, n> F_u + <S_u x V, n> F_v   (with |n| = 1),

  which is multiplied by positive weights. At edges of S that are one point this is zero with F, as S_u or S_v is: a
  multiple of F is added so that it is zero on all of the edge, and this is divided out.
  */
  Cell_polynomials cusps(const Cell_polynomials& contact) const
  {
    const Cell_vector n = normal(), v = velocity(), a = scaled_tangent(m_patch, m_breaks, 0),
                      b = scaled_tangent(m_patch, m_breaks, 1);
    const Cell_polynomials weight = of_surface(m_patch.weight()), speed(m_breaks, m_field.speed, 2),
                           scale(m_breaks, m_field.scale, 2);
    const Cell_polynomials factor = speed * (m_field.is_translation() ? weight * weight : weight);
    const std::array<Cell_polynomials, 2> along{factor * determinant(v, b, n), factor * determinant(a, v, n)};
    Cell_polynomials result = scale * times_lengths(determinant(a, b, n) * contact.derivative(2)) -
        along[0] * contact.derivative(0) - along[1] * contact.derivative(1);
    result = without_weights(result);
    for (const int axis : {0, 1})
      for (const std::size_t end : {std::size_t(0), contact.last_break(axis)})
        if (m_patch.pole(axis, (*m_breaks)[static_cast<std::size_t>(axis)][end])) {
          if (const auto edge = along_edge(contact, axis, end); edge && !result.is_zero_on(axis, end))
            result = result * *edge + along[static_cast<std::size_t>(1 - axis)] * edge->derivative(1 - axis) * contact;
          while (!result.is_zero() && result.is_zero_on(axis, end))
            result = result.divided_at(axis, end);
        }
    return without_weights(result);
  }

  // The unknowns at both ends of which points and normals, or positions and velocities, are the same.
  std::vector<int> closed_unknowns() const
  {
    std::vector<int> result = m_surface.closed_axes();
    if (is_motion_closed())
      result.push_back(2);
    return result;
  }

private:
  // Without factors of the weights of surface and motion.
  Cell_polynomials without_weights(const Cell_polynomials& f) const
  {
    return f.without_factor(part_of(m_motion.weight(), 0, domain()[2]), 2).without_weights(m_patch);
  }

  // On each cell times its length in time: the field is that of a time that runs from 0 to 1 there.
  Cell_polynomials times_lengths(const Cell_polynomials& f) const
  {
    std::vector<Bernstein_tensor<Exact_rational>> lengths;
    for (std::size_t i = 1; i < m_field.times.size(); ++i)
      lengths.push_back(
          Bernstein_tensor<Exact_rational>::constant(1, Exact_rational(m_field.times[i] - m_field.times[i - 1])));
    return f * Cell_polynomials(m_breaks, lengths, 2);
  }

  // A function of the parameter along an edge: that at a time where it has one sign there, if there is one.
  std::optional<Cell_polynomials> along_edge(const Cell_polynomials& f, int axis, std::size_t end) const
  {
    constexpr int tries = 8;
    for (int k = 1; k < tries; ++k) {
      const std::vector<Bernstein_tensor<Exact_rational>> pieces =
          f.on_line(axis, end, Exact_rational(Exact_rational(k) / tries));
      int sign = 0;
      const bool has_one_sign = std::all_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
        const auto [least, most] = piece.bounds();
        const int own = least > 0 ? 1 : most < 0 ? -1 : 0;
        sign = sign == 0 ? own : sign;
        return own != 0 && own == sign;
      });
      if (has_one_sign)
        return Cell_polynomials(m_breaks, pieces, 1 - axis);
    }
    return std::nullopt;
  }

  Cell_polynomials of_surface(const Exact_function& f) const { return {m_breaks, f, {0, 1}}; }
  Cell_polynomials of_time(const Exact_function& f) const { return {m_breaks, f, {2}}; }
  Cell_vector normal() const { return {of_surface(m_normal[0]), of_surface(m_normal[1]), of_surface(m_normal[2])}; }
  Cell_polynomials field(std::size_t row, std::size_t column) const
  {
    return of_time(m_field.entries[column < 3 ? 3 * row + column : 9 + row]);
  }

  // B X + b s, or b where B is zero.
  Cell_vector velocity() const { return {velocity(0), velocity(1), velocity(2)}; }
  Cell_polynomials velocity(std::size_t row) const
  {
    if (m_field.is_translation())
      return field(row, 3);
    Cell_polynomials result = field(row, 3) * of_surface(m_patch.weight());
    for (std::size_t k = 0; k < 3; ++k)
      result = result + field(row, k) * of_surface(m_patch.numerators()[k]);
    return result;
  }

  Vector_expression<3> moved(const Vector_expression<3>& x, const Unknown& t) const
  {
    const auto column = [&](std::size_t k) {
      std::array<Exact_function, 3> functions;
      for (std::size_t i = 0; i < 3; ++i)
        functions[i] = part_of(m_motion.columns()[k][i], 0, domain()[2]);
      return Spline_map<1, 3>(functions, part_of(m_motion.weight(), 0, domain()[2]))(t);
    };
    return column(0) * x[0] + column(1) * x[1] + column(2) * x[2] + column(3);
  }

  // Of the derivative across a line of the product of all factors that vanish on such lines. Those of the ends of the
  // domain are positive inside.
  int sign_of_factors(const Constant_parameter& line, const std::vector<Constant_parameter>& lines) const
  {
    const auto [begin, end] = m_patch.domain(line.axis);
    int result = line.value == end ? -1 : 1;
    for (const Constant_parameter& other : lines)
      if (other.axis == line.axis && begin < other.value && other.value < end && line.value < other.value)
        result = -result;
    return result;
  }

  bool is_copy_on_seam(const Constant_parameter& line) const
  {
    return m_patch.is_closed(line.axis) && line.value == m_patch.domain(line.axis).second;
  }

  bool is_motion_closed() const
  {
    const auto [begin, end] = domain()[2];
    if (!m_motion.has_same_map(begin, end))
      return false;
    const std::array<Exact_rational, 1> first{begin}, last{end};
    std::vector<Exact_rational> before, after;
    for (const Exact_function& f : m_field.entries) {
      before.push_back(f(last));
      after.push_back(f(first));
    }
    return positive_ratio(before, after).has_value();
  }
};

// Those that a line of constant u or v ends at.
inline std::vector<Envelope_pole> poles_beside(const Constant_parameter& line, std::vector<Envelope_pole> poles)
{
  std::erase_if(poles, [&](const Envelope_pole& pole) { return pole.unknown == line.axis || pole.is_one_point; });
  return poles;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Envelope_surface_3 sweep_envelope_of(const Exact_map<3>& surface,
                                                                    const Rational_motion_3& motion,
                                                                    const Solver_options& options, Envelope_use use)
{
  Envelope_collector result(options);
  const Spline_patch<3> patch(surface);
  try {
    const std::vector<Smooth_surface> smooth = smooth_surfaces(patch, [&] { result.budget().check(); });
    for (const Motion_part& field : motion_parts(motion))
      for (const Smooth_surface& part : smooth) {
        result.budget().check();
        const Moving_patch moving(part, motion, field);
        const Moving_patch::Contact contact = moving.contact(use);
        if (contact.function.is_zero()) {
          result.add_undecided(moving.domain(), moves_along_itself);
          continue;
        }
        Constraint_system_d system(moving.domain());
        system.add(contact.function.function(), Relation::EQUAL);
        const std::vector<int> closed = moving.closed_unknowns();
        const auto cusps = [&] { return moving.cusps(contact.function).normalized().function(); };
        result.add(system, use == Envelope_use::SURFACE ? cusps : std::function<Spline_function()>(), moving.image(),
                   closed, contact.poles);
        for (const Constant_parameter& line : contact.touching_lines) {
          const Moving_patch::Swept_line swept = moving.swept(line, contact);
          std::vector<int> closed_of_line = closed;
          std::erase(closed_of_line, line.axis);
          result.add(swept.system, {}, swept.image, closed_of_line, poles_beside(line, contact.poles), {},
                     std::pair(line.axis, line.value));
        }
      }
  } catch (const Run_stopped& stop) {
    const auto [begin, end] = motion.domain();
    result.add_undecided({patch.domain(0), patch.domain(1), {begin, end}}, in_words(stop.reason));
  }
  return std::move(result).result();
}

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SWEEP_ENVELOPES_H
