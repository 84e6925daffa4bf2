// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>

#include <CGAL/Sphere_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

The direction in which a straight tool stands on a surface.
*/
template <SplineKernel Kernel>
struct Tool_axis
{
  //! the same direction everywhere, of any length; none: the normal \f$S_u \times S_v\f$ of the surface, unless there
  //! is a field.
  std::optional<typename Kernel::Vector_3> direction{};

  //! admits only directions \f$O\f$ with \f$\langle O, V\rangle > 0\f$ for this \f$V\f$; none: all. Curves end where
  //! this is zero; where it is, is not part of the result.
  std::optional<typename Kernel::Vector_3> hemisphere{};

  //! a field of directions over the domain of the surface, points standing for the vectors from the origin to them;
  //! none: normals. Where it is tangent to the surface the tool does not stand.
  std::optional<Bspline_surface_3<Kernel>> field{};
};

namespace internal {
namespace Surface_curves {

// Finds where a ray from a surface along the axis of the tool only touches something else.
template <SplineKernel Kernel>
class Access_boundaries
{
  using Vector = Exact_kernel::Vector_3;

  std::optional<Vector> m_direction, m_hemisphere;
  std::optional<Spline_patch<3>> m_field;
  Solver_options m_options;
  std::vector<Oriented_patch> m_parts;
  Surface_curves_3<Kernel> m_curves;

public:
  //! \throws Invalid_input when a vector is zero or not finite, or the field has another domain than the surface, or a
  //! direction beside it.
  Access_boundaries(const Spline_patch<3>& surface, const Tool_axis<Kernel>& axis, const Solver_options& options)
    : m_direction(checked(axis.direction)), m_hemisphere(checked(axis.hemisphere)), m_options(options),
      m_curves(point_on_surface(surface))
  {
    m_options.check();
    if (axis.field)
      m_field.emplace(*axis.field);
    if (m_field && (m_direction || m_field->domain(0) != surface.domain(0) || m_field->domain(1) != surface.domain(1)))
      throw Invalid_input("accessibility_boundaries: a field of directions has another domain than the surface, or "
                          "there is a direction beside it");
    if (m_direction && m_hemisphere && !(*m_direction * *m_hemisphere > 0))
      return;   // no direction is admitted
    for (Oriented_patch& part : oriented_patches(surface))
      if (part.is_degenerate)
        m_curves.add_undecided({part.patch.domain(0), part.patch.domain(1)});
      else
        m_parts.push_back(std::move(part));
  }

  const Surface_curves_3<Kernel>& curves() const { return m_curves; }

  // A ray touches a sphere if its center is ahead, at the distance of the radius from the line.
  void add_sphere(const Vector& center, const Exact_rational& squared_radius)
  {
    for (const Oriented_patch& part : m_parts)
      add(part, {}, {}, [&](std::span<const Unknown> u) {
        const Vector_expression<3> ray = constant(center) - Parametric_vector<3>(part.patch)(u),
                                   axis = tool_axis(part, u);
        return std::vector<Constraint>{squared_norm(cross(ray, axis)) == squared_radius * squared_norm(axis),
                                       dot(ray, axis) > 0};
      });
  }

  // The contours of a surface, and its edges and creases.
  void add_surface(const Spline_patch<3>& check)
  {
    for (const Oriented_patch& other : oriented_patches(check)) {
      if (other.is_degenerate)
        for (const Oriented_patch& part : m_parts)
          m_curves.add_undecided({part.patch.domain(0), part.patch.domain(1)});
      else if (m_direction)
        add_contours(other);
      else
        add_contacts(other);
      for (const int axis : {0, 1})
        for (const int side : {0, 1})
          add_edge(check, other, axis, side);
    }
  }

private:
  static std::optional<Vector> checked(const std::optional<typename Kernel::Vector_3>& vector)
  {
    if (!vector)
      return std::nullopt;
    const Vector result = exact_object(*vector);
    if (result == CGAL::NULL_VECTOR)
      throw Invalid_input("accessibility_boundaries: a direction is zero");
    return result;
  }

  static Vector_expression<3> constant(const Vector& v)
  {
    return vector_of<3>([&](std::size_t i) { return Expression(v.cartesian(static_cast<int>(i))); });
  }

  Vector_expression<3> tool_axis(const Oriented_patch& part, std::span<const Unknown> u) const
  {
    return m_direction ? constant(*m_direction)
        : m_field      ? field_vector(part)(u.first(2))
                       : Parametric_vector<3>(part.normal)(u.first(2));
  }

  Parametric_vector<3> field_vector(const Oriented_patch& part) const
  {
    return Parametric_vector<3>(m_field->part({part.patch.domain(0), part.patch.domain(1)}).numerators());
  }

  // That the ray meets a point: its offset is orthogonal to two vectors that are orthogonal to the axis.
  std::vector<Constraint> meeting(const Oriented_patch& part, const Parametric_vector<3>& point,
                                  std::span<const Unknown> u) const
  {
    const Vector_expression<3> ray = point(u.subspan(2)) - Parametric_vector<3>(part.patch)(u.first(2));
    const auto across = [&](int axis) {
      if (m_direction) {
        const Vector first = perpendicular(*m_direction);
        return constant(axis == 0 ? first : CGAL::cross_product(*m_direction, first));
      }
      const Vector_expression<3> tangent =
          Parametric_vector<3>(part.tangents[static_cast<std::size_t>(axis)])(u.first(2));
      return m_field ? cross(tool_axis(part, u), tangent) : tangent;
    };
    return {dot(ray, across(0)) == 0, dot(ray, across(1)) == 0, dot(ray, tool_axis(part, u)) > 0};
  }

  // Where rays along the normals touch a surface.
  void add_contacts(const Oriented_patch& other)
  {
    for (const Oriented_patch& part : m_parts)
      add(part, {other.patch.domain(0), other.patch.domain(1)}, other.is_seam, [&](std::span<const Unknown> u) {
        std::vector<Constraint> result = meeting(part, Parametric_vector<3>(other.patch), u);
        result.push_back(dot(Parametric_vector<3>(other.normal)(u.subspan(2)), tool_axis(part, u)) == 0);
        return result;
      });
  }

  // Parallel rays touch a surface along its silhouettes. A part that is parallel to them is left through its edges.
  void add_contours(const Oriented_patch& other)
  {
    const Cell_functions<1> contour =
        combined<4>(other.planes, {m_direction->x(), m_direction->y(), m_direction->z(), 0});
    for (Continuous_part<1>& contours : continuous_parts(contour, false)) {
      const Curve_vertex::Exact_box domain{contours.functions.domain(0), contours.functions.domain(1)};
      if (contours.functions.is_zero())
        contours.lines = {{0, domain[0].first}, {0, domain[0].second}, {1, domain[1].first}, {1, domain[1].second}};
      else
        for (const Oriented_patch& part : m_parts)
          add(part, domain, seams(other.patch, contours.functions),
              [&, g = contours.functions.splines()[0]](std::span<const Unknown> u) {
                std::vector<Constraint> result = meeting(part, Parametric_vector<3>(other.patch), u);
                result.push_back(formula(g, u.subspan(2)) == 0);
                return result;
              });
      for (const Constant_parameter& line : lines_in_space(other.patch, contours))
        if (!is_edge(other, line))
          add_curve(other.patch.part(line.axis, {line.value, line.value})
                        .part(0, domain[static_cast<std::size_t>(1 - line.axis)]));
    }
  }

  // Those are added anyway.
  static bool is_edge(const Oriented_patch& patch, const Constant_parameter& line)
  {
    const auto [begin, end] = patch.patch.domain(line.axis);
    return (line.value == begin || line.value == end) && !patch.is_seam[static_cast<std::size_t>(line.axis)];
  }

  // An edge of a part of a check surface, unless it is a smooth seam, a point, or the same as another one.
  void add_edge(const Spline_patch<3>& check, const Oriented_patch& other, int axis, int side)
  {
    const auto [begin, end] = other.patch.domain(axis);
    const bool is_known = side == 0 && (begin != check.domain(axis).first || check.is_closed(axis));
    const Exact_rational value = side == 0 ? begin : end;
    const Spline_patch<3> edge = other.patch.part(axis, {value, value});
    if (!is_known && !other.is_seam[static_cast<std::size_t>(axis)] && !edge.is_one_point())
      add_curve(edge);
  }

  // Where rays meet a curve; one along the rays gives one point only, where those of its ends meet.
  void add_curve(const Spline_patch<3>& curve)
  {
    if (m_direction && is_along_direction(curve))
      return;
    for (const Oriented_patch& part : m_parts)
      add(part, {curve.domain(0)}, {curve.is_closed(0), false},
          [&](std::span<const Unknown> u) { return meeting(part, Parametric_vector<3>(curve), u); });
  }

  bool is_along_direction(const Spline_patch<3>& curve) const
  {
    const auto& [x, y, z] = curve.numerators();
    const auto d = *m_direction;
    return curve.with_numerators({y * d.z() - z * d.y(), z * d.x() - x * d.z(), x * d.y() - y * d.x()}).is_one_point();
  }

  // The solutions of constraints in the parameters of a part of the surface, and some others, which may be closed.
  template <class Constraints>
  void add(const Oriented_patch& part, const Curve_vertex::Exact_box& other_ranges,
           const std::array<bool, 2>& is_closed, const Constraints& constraints)
  {
    Curve_vertex::Exact_box domain{part.patch.domain(0), part.patch.domain(1)};
    domain.insert(domain.end(), other_ranges.begin(), other_ranges.end());
    const std::vector<Unknown> u = unknowns_in(domain);
    Constraint_system_d system(domain);
    for (const Constraint& constraint : constraints(u))
      system.add(constraint);
    if (m_field)
      system.add(dot(tool_axis(part, u), Parametric_vector<3>(part.normal)(std::span<const Unknown>(u).first(2))) != 0);
    if (m_hemisphere && !m_direction)
      system.add(dot(tool_axis(part, u), constant(*m_hemisphere)) > 0);
    Domain_joints joints;
    for (std::size_t i = 0; i < domain.size(); ++i)
      if (i < 2 ? part.is_seam[i] && (!m_field || m_field->is_closed(static_cast<int>(i))) : is_closed[i - 2])
        joints.closed_unknowns.push_back(i);
    Curve_solution_set_d solutions = internal::curves_within(system, m_options);
    m_curves.add(std::move(system), std::move(solutions), joints);
  }
};

template <SplineKernel Kernel>
void add_check(Access_boundaries<Kernel>& boundaries, const CGAL::Sphere_3<Kernel>& sphere)
{
  if (!(sphere.squared_radius() > 0))
    throw Invalid_input("accessibility_boundaries: the sphere is degenerate");
  boundaries.add_sphere(exact_object(sphere.center()) - Exact_kernel::Point_3(CGAL::ORIGIN),
                        converted_number<Exact_rational>(sphere.squared_radius()));
}

template <SplineKernel Kernel, Surface_operand Surface>
void add_check(Access_boundaries<Kernel>& boundaries, const Surface& surface)
{
  boundaries.add_surface(Intersection_operand<Surface>::patch(surface));
}

} // namespace Surface_curves
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the curves on a surface between the places that a thin straight tool, as in 5-axis milling, can reach and those where a
check surface is in its way: where the ray from \f$S(u,v)\f$ along the axis \f$O(u,v)\f$ of the tool touches the check
surface \f$K(s,t)\f$, or meets an edge or a crease of it,
\f[ \langle K - S, O_1\rangle = \langle K - S, O_2\rangle = \langle n_K, O\rangle = 0, \quad \langle K - S, O\rangle >
0, \f] where \f$O_1\f$ and \f$O_2\f$ span the plane at a right angle to \f$O\f$; these are \f$S_u\f$ and \f$S_v\f$ for
the normal, \f$O \times S_u\f$ and \f$O \times S_v\f$ for a field. Each region of the surface between these curves is
reached as a whole or not at all. The topology of the curves is proved.

Other than in the source, the third equation has the axis in the place of \f$S - K\f$, which is parallel to it: so
points where the surfaces meet are no solutions, and the degree is lower. The inequality leaves only what is ahead of
the tool, not behind it, and edges of the check surface count, too. Of a sphere, the equation is \f$|(c - S) \times O|^2
= r^2 |O|^2\f$, with \f$c\f$ ahead, in the two parameters of the surface only.

For a tool with a radius, the check surface has to be replaced by its offset, which is a sphere for a sphere.

Both surfaces are cut where normals or tangents jump by more than a constant factor, and each two parts have curves of
their own; cuts of the check surface count as creases. Where the axis of the tool runs along an edge of the check
surface, where the surfaces touch, and in singular points of higher order the answer is undecided.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one. Its parameters are the
first two unknowns.
\param check the check surface: such a surface as well, whose parameters, or the one along its edge, are the further
unknowns; or a `CGAL::Sphere_3`, without unknowns.
\param axis the directions of the tool.
\param options those of `solve_curves()`; limits hold for each two parts.
\throws Invalid_input when a direction is zero, a field of directions has another domain than the surface or comes with
a direction, the sphere is degenerate, a coordinate is not finite, a weight is not proved to have one sign, or an option
makes no sense.

Complexity: that of `solve_curves()` with three equations in four unknowns, and of two in three for each edge; of a
sphere, of one in two. Source: \cgalCite{ek-gcs-01}, section 3.5.
*/
template <internal::Surface_curves::Surface_operand Surface, class Check>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
accessibility_boundaries(const Surface& surface, const Check& check,
                         const Tool_axis<internal::Surface_curves::Operand_kernel<Surface>>& axis = {},
                         const Solver_options& options = {.tolerance = 1e-8})
{
  internal::Surface_curves::Access_boundaries<internal::Surface_curves::Operand_kernel<Surface>> boundaries(
      internal::Common::Intersection_operand<Surface>::patch(surface), axis, options);
  internal::Surface_curves::add_check(boundaries, check);
  return boundaries.curves();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H
