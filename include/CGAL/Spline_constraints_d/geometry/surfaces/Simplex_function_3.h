// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SIMPLEX_FUNCTION_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SIMPLEX_FUNCTION_3_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/Point_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A polynomial in space in Bernstein form on a tetrahedron: an implicit patch, its zeros in the tetrahedron, with the
solid where it is negative. All of it is exact.
*/
class Simplex_function_3
{
public:
  //! the kernel of points that are made.
  using Kernel = internal::Exact_kernel;
  //! the form.
  using Form = Bernstein_simplex<Exact_rational, 3>;
  //! barycentric coordinates.
  using Barycentric = Form::Barycentric;
  //! coordinates of the vertices.
  using Vertices = Simplex_vertices<3>;

private:
  Vertices m_vertices;
  Form m_form;
  std::array<Barycentric, 3> m_axes; // barycentric coordinates of the unit vectors, as differences

public:
  //! the polynomial with these Bernstein coefficients on a tetrahedron. \throws Invalid_input when it is flat, or a
  //! coordinate not finite.
  template <SplineKernel K>
  Simplex_function_3(const CGAL::Tetrahedron_3<K>& tetrahedron, Form form)
    : Simplex_function_3(vertices_of(tetrahedron), std::move(form))
  {}

  //! a polynomial in the unknowns 0, 1, 2 on a tetrahedron. \throws Invalid_input also when it has other unknowns or a
  //! total degree above 30.
  template <SplineKernel K>
  Simplex_function_3(const CGAL::Tetrahedron_3<K>& tetrahedron, const Power_polynomial& polynomial)
    : Simplex_function_3(vertices_of(tetrahedron), polynomial)
  {}

  //! the polynomial of an implicit surface, whose box does not matter.
  template <SplineKernel K>
  Simplex_function_3(const CGAL::Tetrahedron_3<K>& tetrahedron, const Implicit_surface_3& surface)
    : Simplex_function_3(vertices_of(tetrahedron), surface.polynomial())
  {}

#ifndef DOXYGEN_RUNNING
  Simplex_function_3(const Vertices& vertices, const Power_polynomial& polynomial)
    : Simplex_function_3(vertices, to_bernstein_simplex<3>(polynomial, vertices))
  {}

  Simplex_function_3(const Vertices& vertices, Form form) : m_vertices(vertices), m_form(std::move(form))
  {
    const Barycentric origin = barycentric_coordinates<3>(m_vertices, {});
    for (int axis = 0; axis < 3; ++axis) {
      std::array<Exact_rational, 3> unit{};
      unit[axis] = Exact_rational(1);
      m_axes[axis] = barycentric_coordinates<3>(m_vertices, unit);
      for (int i = 0; i < 4; ++i)
        m_axes[axis][i] -= origin[i];
    }
  }
#endif

  //! the form on the tetrahedron.
  const Form& form() const { return m_form; }

  //! the coordinates of the vertices.
  const Vertices& vertices() const { return m_vertices; }

  //! a vertex.
  Kernel::Point_3 vertex(int i) const { return {m_vertices[i][0], m_vertices[i][1], m_vertices[i][2]}; }

  //! the polynomial in the unknowns 0, 1, 2.
  Power_polynomial polynomial() const { return to_power_polynomial<3>(m_form, m_vertices); }

  //! the barycentric coordinates of a point.
  template <SplineKernel K>
  Barycentric barycentric(const CGAL::Point_3<K>& point) const
  {
    const Kernel::Point_3 p = internal::exact_object(point);
    return barycentric_coordinates<3>(m_vertices, {p.x(), p.y(), p.z()});
  }

  //! the value at a point, in the tetrahedron or not.
  template <SplineKernel K>
  Exact_rational operator()(const CGAL::Point_3<K>& point) const
  {
    return m_form(barycentric(point));
  }

  //! the sign of that.
  template <SplineKernel K>
  CGAL::Sign sign_at(const CGAL::Point_3<K>& point) const
  {
    return CGAL::sign((*this)(point));
  }

  //! the differences of barycentric coordinates that belong to the unit vector along a coordinate axis.
  const Barycentric& direction(int axis) const { return m_axes[axis]; }

  //! the derivative along a coordinate axis, in Bernstein form.
  Form derivative(int axis) const { return m_form.derivative(m_axes[axis]); }

  //! the gradient at a point.
  template <SplineKernel K>
  Kernel::Vector_3 gradient(const CGAL::Point_3<K>& point) const
  {
    const Barycentric tau = barycentric(point);
    return {derivative(0)(tau), derivative(1)(tau), derivative(2)(tau)};
  }

  //! the gradient at a vertex \f$x_i\f$, from \f$\langle\nabla f(x_i), x_j - x_i\rangle = k\,(b_{(k-1)e_i+e_j} -
  //! b_{k e_i})\f$.
  Kernel::Vector_3 gradient_at_vertex(int i) const
  {
    std::array<Exact_rational, 3> result{};
    for (int j = 0; j < 4; ++j)
      if (j != i)
        for (int axis = 0; axis < 3; ++axis)
          result[axis] += Exact_rational(m_axes[axis][j] * m_form.derivative_at_vertex(i, j));
    return {result[0], result[1], result[2]};
  }

private:
  template <class K>
  static Vertices vertices_of(const CGAL::Tetrahedron_3<K>& tetrahedron)
  {
    Vertices result;
    for (int i = 0; i < 4; ++i) {
      const Kernel::Point_3 p = internal::exact_object(tetrahedron.vertex(i));
      result[i] = {p.x(), p.y(), p.z()};
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SIMPLEX_FUNCTION_3_H
