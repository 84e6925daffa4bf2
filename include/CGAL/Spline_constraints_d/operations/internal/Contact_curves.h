// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONTACT_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONTACT_CURVES_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/internal/implicit_equation.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The common points of two parametric surfaces A(u,v) and B(s,t) that touch along a curve, where f(A) = 0 for a polynomial f.

On a contact curve the equations A = B are singular. If f(B) has repeated factors, let g be the product of its factors without the exponents. All common points satisfy

  <A - B, B_s> = <A - B, B_t> = 0, g(s,t) = 0,

and these are regular where the surfaces touch, and g is. Other solutions are pairs of points of f = 0 on a normal of B. By the mean value theorem 0 = f(A) - f(B) = lambda <grad f, n>, with n = B_s x B_t, A - B = lambda n, and the gradient at some point between: so both are the same point where <grad f, n> is not
zero around them. Along a regular curve in one cell of both surfaces A - B is analytic: it is zero everywhere, if around one vertex. Curves of other solutions are in boxes where A and B are apart.

Where a contact curve runs along a break, a seam or an edge of a surface, those equations do not say so, since no one of them is zero there. If B, too, has an equation h(B) = 0, let B be a surface on which g = 0 is such a line, with the tangent T = B_s or B_t. All common points satisfy

  g(s,t) = 0, h(A(u,v)) = 0 without repeated factors, <A - B, T> = 0,

where the lines are factors. Both points of a solution are common zeros of f and h. If these are those of a regular pair p = q = 0, and grad p, grad q and T are independent in a box around both points, they are the same point: p, q and the product with T are the same.
*/
class Contact_curves
{
  const Surface_equations& m_surfaces;
  const std::size_t m_implicit, m_other;   // the indices of A and B
  const Power_polynomial m_polynomial;
  const Simple_factors m_factors;   // of f(B)

  // What is known of contacts along a line of B.
  struct Line
  {
    int axis;                  // of the parameter along it
    Simple_factors factors;    // of h(A)
    Regular_pair common_zeros;
  };
  std::optional<Line> m_line;

public:
  // With A as the surface of an index, and the equations of both surfaces, as far as they are known. Nothing if f(B) has no repeated factors, if the tangents of B jump, or if the surfaces may touch along a break or an edge of A.
  static std::optional<Contact_curves> make(const Surface_equations& surfaces, const std::array<std::optional<Power_polynomial>, 2>& polynomials, std::size_t implicit)
  {
    const std::array<const Spline_patch<3>*, 2> patches{&*surfaces.surface(implicit).patch, &*surfaces.surface(1 - implicit).patch};
    const auto &polynomial = polynomials[implicit], &other = polynomials[1 - implicit];
    const bool is_one_piece = patches[0]->breaks(0).size() == 2 && patches[0]->breaks(1).size() == 2 && !patches[0]->is_closed(0) && !patches[0]->is_closed(1);
    if (!polynomial || has_creases(*patches[1]) || !(is_one_piece || (other && !may_vanish_on_break(*other, *patches[0]))))
      return std::nullopt;
    Contact_curves result(surfaces, implicit, *polynomial, Simple_factors(incidence(*polynomial, *patches[1])));
    return result.m_factors.is_simpler() ? std::optional(std::move(result)) : std::nullopt;
  }

  // Those for contacts along lines of B of both directions, if there are some and a regular pair is known.
  static std::vector<Contact_curves> along_lines(const Surface_equations& surfaces, const std::array<std::optional<Power_polynomial>, 2>& polynomials, std::size_t implicit,
                                                 const std::optional<Regular_pair>& common_zeros)
  {
    const Spline_patch<3>&a = *surfaces.surface(implicit).patch, &b = *surfaces.surface(1 - implicit).patch;
    std::vector<Contact_curves> result;
    if (!common_zeros || has_creases(b))
      return result;
    Contact_curves contact(surfaces, implicit, *polynomials[implicit], Simple_factors(incidence(*polynomials[implicit], b)));
    for (const int axis : {0, 1})
      if (contact.m_factors.is_simpler() && has_line(contact.m_factors.system(), axis)) {
        contact.m_line.emplace(Line{axis, Simple_factors(incidence(*polynomials[1 - implicit], a)), *common_zeros});
        result.push_back(contact);
      }
    return result;
  }

  // The equations above.
  Constraint_system_d system() const
  {
    Constraint_system_d result(domain_of(m_surfaces.system()));
    for (const int axis : {0, 1})
      if (!m_line || m_line->axis == axis)
        result.add(without_poles(projection(axis)), Relation::EQUAL);
    result.add(product(m_factors, m_other), Relation::EQUAL);
    if (m_line)
      result.add(product(m_line->factors, m_implicit), Relation::EQUAL);
    return result;
  }

  // Those of the solutions of the system that are common points. What is neither proved to be that nor not to be is undecided.
  Curve_solution_set_d common_points(const Curve_solution_set_d& all) const
  {
    std::vector<Solution_curve> curves;
    std::vector<std::size_t> points, singular_points;
    std::vector<Undecided_region> undecided;
    for (const Solution_curve& curve : all.curves()) {
      const CGAL::Uncertain<bool> is_common = has_common_points(all, curve);
      if (!CGAL::is_certain(is_common))
        undecided.push_back(region_of(curve));
      else if (CGAL::get_certain(is_common))
        curves.push_back(counted(all, curve));
    }
    for (auto [from, to] : {std::pair(&all.points(), &points), std::pair(&all.singular_points(), &singular_points)})
      for (const std::size_t i : *from) {
        const CGAL::Uncertain<bool> is_common = is_common_point(all.vertices()[i].box);
        if (!CGAL::is_certain(is_common))
          undecided.push_back({{all.vertices()[i].box}, {i}, Undecided_reason::TOLERANCE});
        else if (CGAL::get_certain(is_common))
          to->push_back(i);
      }
    for (Undecided_region region : all.undecided()) {
      std::erase_if(region.boxes, [&](const Exact_ranges& box) { return are_apart(box); });
      if (!region.boxes.empty())
        undecided.push_back(std::move(region));
    }
    return with_used_vertices(all, std::move(curves), std::move(points), std::move(singular_points), std::move(undecided));
  }

private:
  Contact_curves(const Surface_equations& surfaces, std::size_t implicit, Power_polynomial polynomial, Simple_factors factors)
    : m_surfaces(surfaces), m_implicit(implicit), m_other(1 - implicit), m_polynomial(std::move(polynomial)), m_factors(std::move(factors))
  {}

  // The equation of the points of a surface where a polynomial is zero.
  static Constraint_system_d incidence(const Power_polynomial& polynomial, const Spline_patch<3>& patch) { return Surface_equations(Surface_shape(polynomial), Surface_shape(patch)).system(); }

  // Whether tangents jump.
  static bool has_creases(const Spline_patch<3>& patch)
  {
    const auto jumps = [&](int axis) {
      const std::vector<Axis_part> parts = parts_of(patch, axis, perpendicular_before);
      return std::any_of(parts.begin(), parts.end(), [](const Axis_part& part) { return part.range.first == part.range.second; });
    };
    return jumps(0) || jumps(1);
  }

  // Whether an equation of two unknowns is zero along an edge or a break on which one of them varies.
  static bool has_line(const Constraint_system_d& system, int axis)
  {
    const std::vector<Exact_rational> places = places_of_faces(system, 1 - axis);
    return std::any_of(places.begin(), places.end(), [&](const Exact_rational& place) { return Face_factor(system.equalities().front(), 1 - axis, system.domain(1 - axis), place).divides(); });
  }

  // The product of the factors of an equation in the parameters of a surface, as one in all unknowns.
  Spline_function product(const Simple_factors& factors, std::size_t surface) const
  {
    Spline_function result;
    for (Spline_term term : factors.system().equalities().front().terms()) {
      for (int& v : term.variables)
        v += static_cast<int>(first_unknown(surface));
      result += Spline_function(std::move(term));
    }
    return result;
  }

  // Whether a polynomial is zero in some points of a piece of a break or an edge of a surface.
  static bool may_vanish_on_break(const Power_polynomial& polynomial, const Spline_patch<3>& surface)
  {
    constexpr int tries = 4;
    for (const int axis : {0, 1}) {
      const std::vector<Exact_rational> breaks = surface.breaks(1 - axis);
      for (const Exact_rational& end : surface.breaks(axis))
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
          int zeros = 0;
          for (int k = 0; k < tries; ++k) {
            std::vector<Exact_rational> parameters{end, Exact_rational(breaks[i] + (breaks[i + 1] - breaks[i]) * Exact_rational(2 * k + 1, 2 * tries))};
            if (axis == 1)
              std::swap(parameters[0], parameters[1]);
            zeros += CGAL::is_zero(polynomial(surface(parameters))) ? 1 : 0;
          }
          if (zeros == tries)
            return true;
        }
    }
    return false;
  }

  const Spline_patch<3>& patch(std::size_t surface) const { return *m_surfaces.surface(surface).patch; }
  std::size_t first_unknown(std::size_t surface) const { return m_surfaces.parameter(surface, 0).unknown; }

  // The product of A - B with a tangent of B.
  Spline_function projection(int axis) const
  {
    const std::vector<Unknown> unknowns = unknowns_in(domain_of(m_surfaces.system()));
    const auto of = [&](std::size_t surface) { return std::span(unknowns).subspan(first_unknown(surface), 2); };
    const Parametric_vector<3> a(patch(m_implicit)), b(patch(m_other));
    return (dot(a(of(m_implicit)) - b(of(m_other)), b.tangent(axis)(of(m_other))) == 0).spline_function();
  }

  // Where an edge of B is one point, a tangent is zero: the function is divided by its factor there.
  Spline_function without_poles(Spline_function function) const
  {
    for (const int axis : {0, 1}) {
      const Parameter_range range = patch(m_other).domain(axis);
      for (const Exact_rational& end : {range.first, range.second})
        if (patch(m_other).part(axis, {end, end}).is_one_point())
          for (const int unknown = static_cast<int>(first_unknown(m_other)) + axis; Face_factor(function, unknown, range, end).divides();)
            function = Face_factor(function, unknown, range, end).quotient();
    }
    return function;
  }

  // A part of a surface, a little larger than a box.
  Spline_patch<3> part(std::size_t surface, const Exact_ranges& box) const
  {
    constexpr double share = 0x1p-30;
    std::vector<Parameter_range> ranges;
    for (int axis = 0; axis < 2; ++axis) {
      const Parameter_range domain = patch(surface).domain(axis), range = box[first_unknown(surface) + static_cast<std::size_t>(axis)];
      const Exact_rational margin((domain.second - domain.first) * Exact_rational(share));
      ranges.emplace_back((std::max)(domain.first, Exact_rational(range.first - margin)), (std::min)(domain.second, Exact_rational(range.second + margin)));
    }
    return patch(surface).part(ranges);
  }

  bool are_apart(const Exact_ranges& box) const { return are_apart(part(m_implicit, box).values(), part(m_other, box).values()); }

  // The same, by halves of the box.
  bool are_apart_in_parts(const Exact_ranges& box, int most_halvings = 8) const
  {
    if (are_apart(box))
      return true;
    if (most_halvings == 0)
      return false;
    std::size_t longest = 0;
    Exact_rational length(0);   // a share of the domain
    for (const std::size_t surface : {m_implicit, m_other})
      for (int axis = 0; axis < 2; ++axis) {
        const std::size_t unknown = first_unknown(surface) + static_cast<std::size_t>(axis);
        const Parameter_range domain = patch(surface).domain(axis);
        const Exact_rational share((box[unknown].second - box[unknown].first) / (domain.second - domain.first));
        if (length < share) {
          length = share;
          longest = unknown;
        }
      }
    Exact_ranges lower = box, upper = box;
    lower[longest].second = upper[longest].first = (box[longest].first + box[longest].second) / 2;
    return are_apart_in_parts(lower, most_halvings - 1) && are_apart_in_parts(upper, most_halvings - 1);
  }

  static bool are_apart(const Vector_bounds<3>& a, const Vector_bounds<3>& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (a[i].upper < b[i].lower || b[i].upper < a[i].lower)
        return true;
    return false;
  }

  // Whether the solution in a box is a common point, and so are all near it.
  CGAL::Uncertain<bool> is_common_point(const Exact_ranges& solution) const
  {
    const Spline_patch<3> other = part(m_other, solution);
    const Vector_bounds<3> a = part(m_implicit, solution).values(), b = other.values();
    if (are_apart(a, b))
      return false;
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> between;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational_interval both = hull(a[i], b[i]);
      between.emplace_back(both.lower, both.upper);
    }
    if (m_line)
      return is_one_point(between, other) ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
    const std::array<Mpfr_interval, 3> gradient = gradient_of(m_polynomial, between);
    const std::vector<Exact_rational> u = other.breaks(0), v = other.breaks(1);   // on both sides of a break the tangents have other lengths
    bool is_common = true;
    for (std::size_t i = 1; i < u.size(); ++i)
      for (std::size_t j = 1; j < v.size(); ++j)
        is_common = is_common && crosses_normal(gradient, other.part({{u[i - 1], u[i]}, {v[j - 1], v[j]}}));
    return is_common ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
  }

  static std::array<Mpfr_interval, 3> gradient_of(const Power_polynomial& polynomial, const std::vector<Mpfr_interval>& box)
  {
    std::array<Mpfr_interval, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = polynomial.derivative(static_cast<int>(i)).value(std::span<const Mpfr_interval>(box));
    return result;
  }

  // Whether two common zeros of the polynomials in a box are the same, if their difference is perpendicular to the tangent of the line in a part of B.
  bool is_one_point(const std::vector<Mpfr_interval>& box, const Spline_patch<3>& part) const
  {
    const Vector_bounds<3> tangent = part.tangents(m_line->axis);
    const auto& [p, q] = m_line->common_zeros.polynomials();
    const std::array<Mpfr_interval, 3> of_p = gradient_of(p, box), of_q = gradient_of(q, box);
    Mpfr_interval determinant(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      determinant += Mpfr_interval(tangent[i].lower, tangent[i].upper) * (of_p[j] * of_q[k] - of_p[k] * of_q[j]);
    }
    return CGAL::certainly(determinant.sign() != CGAL::ZERO);
  }

  // Whether the product of a gradient with the normals of a part of a surface is not zero.
  static bool crosses_normal(const std::array<Mpfr_interval, 3>& gradient, const Spline_patch<3>& surface)
  {
    const Vector_bounds<3> s = surface.tangents(0), t = surface.tangents(1);
    Mpfr_interval slope(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Rational_interval normal = s[j] * t[k] - s[k] * t[j];
      slope += gradient[i] * Mpfr_interval(normal.lower, normal.upper);
    }
    return CGAL::certainly(slope.sign() != CGAL::ZERO);
  }

  // Whether a curve has common points only, or none.
  CGAL::Uncertain<bool> has_common_points(const Curve_solution_set_d& all, const Solution_curve& curve) const
  {
    std::optional<CGAL::Uncertain<bool>> result;
    for (auto begin = curve.pieces.begin(); begin != curve.pieces.end();) {
      const auto end = std::find_if(begin, curve.pieces.end(), [&](const Curve_piece& piece) { return cell_of(piece) != cell_of(*begin); });
      const CGAL::Uncertain<bool> is_common = has_common_points(all, std::span(begin, end));
      if (!CGAL::is_certain(is_common) || (result && CGAL::get_certain(is_common) != CGAL::get_certain(*result)))
        return CGAL::Uncertain<bool>::indeterminate();
      result = is_common;
      begin = end;
    }
    return *result;
  }

  // The same of pieces in one cell: all points are common ones, if those around a vertex are.
  CGAL::Uncertain<bool> has_common_points(const Curve_solution_set_d& all, std::span<const Curve_piece> pieces) const
  {
    for (const Curve_piece& piece : pieces)
      for (const std::size_t i : piece.ends)
        if (!all.vertices()[i].is_singular && CGAL::certainly(is_common_point(all.vertices()[i].box)))
          return true;
    return std::all_of(pieces.begin(), pieces.end(), [&](const Curve_piece& piece) { return are_apart_in_parts(piece.box); }) ? CGAL::Uncertain<bool>(false) : CGAL::Uncertain<bool>::indeterminate();
  }

  // The pieces of both surfaces that it lies on.
  std::vector<std::size_t> cell_of(const Curve_piece& piece) const
  {
    std::vector<std::size_t> result;
    for (const std::size_t surface : {m_implicit, m_other})
      for (int axis = 0; axis < 2; ++axis) {
        const auto& [lower, upper] = piece.box[first_unknown(surface) + static_cast<std::size_t>(axis)];
        result.push_back(cell_at(patch(surface).breaks(axis), Exact_rational((lower + upper) / 2)));
      }
    return result;
  }

  // With the multiplicities of its points in f(B).
  Solution_curve counted(const Curve_solution_set_d& all, Solution_curve curve) const
  {
    const auto own = [&](const Exact_ranges& box) { return Exact_ranges(box.begin() + static_cast<std::ptrdiff_t>(first_unknown(m_other)), box.begin() + static_cast<std::ptrdiff_t>(first_unknown(m_other)) + 2); };
    for (Curve_piece& piece : curve.pieces) {
      piece.multiplicity = 0;
      for (const std::size_t i : piece.ends)
        if (piece.multiplicity == 0 && !all.vertices()[i].is_singular)
          piece.multiplicity = m_factors.multiplicity(own(piece.box), own(all.vertices()[i].box));
    }
    return curve;
  }

  static Undecided_region region_of(const Solution_curve& curve)
  {
    Undecided_region result{{}, {}, Undecided_reason::TOLERANCE};
    for (const Curve_piece& piece : curve.pieces)
      result.boxes.push_back(piece.box);
    return result;
  }

  static Curve_solution_set_d with_used_vertices(const Curve_solution_set_d& all, std::vector<Solution_curve> curves, std::vector<std::size_t> points, std::vector<std::size_t> singular_points,
                                                 std::vector<Undecided_region> undecided)
  {
    std::vector<Curve_vertex> vertices;
    std::map<std::size_t, std::size_t> place;
    const auto renumber = [&](std::size_t& i) {
      const auto [entry, is_new] = place.try_emplace(i, vertices.size());
      if (is_new)
        vertices.push_back(all.vertices()[i]);
      i = entry->second;
    };
    for (Solution_curve& curve : curves)
      for (Curve_piece& piece : curve.pieces)
        std::for_each(piece.ends.begin(), piece.ends.end(), renumber);
    std::for_each(points.begin(), points.end(), renumber);
    std::for_each(singular_points.begin(), singular_points.end(), renumber);
    for (Undecided_region& region : undecided) {
      std::erase_if(region.vertices, [&](std::size_t i) { return !place.contains(i); });
      std::for_each(region.vertices.begin(), region.vertices.end(), renumber);
    }
    Summary summary = all.summary();
    summary.is_complete = undecided.empty();
    if (!undecided.empty())
      summary.why_not = undecided.front().reason;
    return Curve_solution_set_d(std::move(vertices), std::move(curves), std::move(points), std::move(singular_points), std::move(undecided), summary);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CONTACT_CURVES_H
