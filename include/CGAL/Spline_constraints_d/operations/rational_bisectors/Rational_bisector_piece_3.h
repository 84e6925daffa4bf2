// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_PIECE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_PIECE_3_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

A piece of a rational bisector in space that is one rational function of two parameters, with exact coefficients. Where
its weight is zero it has poles: the bisector goes to infinity there and may come back from the other side.
*/
class Rational_bisector_piece_3
{
public:
  //! the kernel of points and surfaces.
  using Kernel = CGAL::Simple_cartesian<Exact_rational>;
  //! a range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! \f$x,y,z\f$ and the weight, on the unit box, which is mapped onto the domain; all of the same degrees.
  using Coordinates = std::array<Bernstein_tensor<Exact_rational>, 4>;

private:
  std::array<Range, 2> m_domain;
  Coordinates m_coordinates;
  std::array<Coordinates, 2> m_feet;
  bool m_is_free_of_poles;

public:
  //! a piece with its feet on the first and on the second operand, as functions of the same parameters.
  Rational_bisector_piece_3(const std::array<Range, 2>& domain, Coordinates coordinates,
                            std::array<Coordinates, 2> feet)
    : m_domain(domain), m_coordinates(std::move(coordinates)), m_feet(std::move(feet)),
      m_is_free_of_poles(has_one_sign(m_coordinates[3]))
  {}

  //! the ranges of both parameters.
  const std::array<Range, 2>& domain() const { return m_domain; }

  //! the homogeneous coordinates.
  const Coordinates& coordinates() const { return m_coordinates; }

  //! the homogeneous coordinates of the foot on operand 0 or 1.
  const Coordinates& foot_coordinates(int operand) const
  {
    CGAL_precondition(operand == 0 || operand == 1);
    return m_feet[operand];
  }

  //! the degree in a parameter.
  int degree(int axis) const { return m_coordinates[3].degree(axis); }

  //! whether it is proved, by subdivision, that the weight has no zero. If not, there are poles as a rule.
  bool is_free_of_poles() const { return m_is_free_of_poles; }

  //! the point of the bisector at parameters. \throws Invalid_input when they are outside of the domain, or at a pole.
  Kernel::Point_3 point(const Exact_rational& u, const Exact_rational& v) const { return at(m_coordinates, u, v); }

  //! the foot on operand 0 or 1 at parameters. \throws Invalid_input when they are outside of the domain.
  Kernel::Point_3 foot(int operand, const Exact_rational& u, const Exact_rational& v) const
  {
    return at(foot_coordinates(operand), u, v);
  }

  //! the piece as a surface. \throws Invalid_input unless `is_free_of_poles()`.
  Bspline_surface_3<Kernel> surface() const { return part(m_domain); }

  /*!
  the part over a box of parameters, as a surface with the same parameters.
  \throws Invalid_input when the box is empty or not within the domain, or it is not proved that the weight has no zero
  there.
  */
  Bspline_surface_3<Kernel> part(const std::array<Range, 2>& box) const;

  //! whether a parameter is within its range.
  bool contains(int axis, const Exact_rational& t) const
  {
    return m_domain[axis].first <= t && t <= m_domain[axis].second;
  }

  //! the place of a parameter in its range, from 0 to 1.
  Exact_rational local_parameter(int axis, const Exact_rational& t) const
  {
    const auto& [begin, end] = m_domain[axis];
    return Exact_rational((t - begin) / (end - begin));
  }

private:
  template <class Function>
  static bool has_one_sign(const Function& weight)
  {
    try {
      internal::certified_weight_sign(weight, {.maximal_depth = 24, .maximal_parts = 2000});
      return true;
    } catch (const Invalid_input&) {
      return false;
    }
  }

  Kernel::Point_3 at(const Coordinates& f, const Exact_rational& u, const Exact_rational& v) const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Bspline_surface_3<Rational_bisector_piece_3::Kernel>
Rational_bisector_piece_3::part(const std::array<Range, 2>& box) const
{
  for (const int axis : {0, 1})
    if (!(box[axis].first < box[axis].second) || !contains(axis, box[axis].first) || !contains(axis, box[axis].second))
      throw Invalid_input("Rational_bisector_piece_3: the box of parameters is empty or not within the domain");
  const std::vector<Range> ranges(box.begin(), box.end());
  const std::vector<Range> local{{local_parameter(0, box[0].first), local_parameter(0, box[0].second)},
                                 {local_parameter(1, box[1].first), local_parameter(1, box[1].second)}};
  const std::vector<int> degrees{(std::max)(degree(0), 1), (std::max)(degree(1), 1)};
  const auto on_box = [&](const Bernstein_tensor<Exact_rational>& f) {
    return Bspline_function<Exact_rational>::from_tensor(f.elevated(degrees).restricted_to_box(local), ranges);
  };
  const auto& [x, y, z, w] = m_coordinates;
  const Bspline_function<Exact_rational> weight = on_box(w);
  if (!has_one_sign(weight))
    throw Invalid_input("Rational_bisector_piece_3: the bisector may have poles in this box of parameters");
  return Bspline_surface_3<Kernel>::from_homogeneous_coordinates({on_box(x), on_box(y), on_box(z)}, weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_bisector_piece_3::Kernel::Point_3
Rational_bisector_piece_3::at(const Coordinates& f, const Exact_rational& u, const Exact_rational& v) const
{
  if (!contains(0, u) || !contains(1, v))
    throw Invalid_input("Rational_bisector_piece_3: parameters outside of the domain");
  const std::array<Exact_rational, 2> local{local_parameter(0, u), local_parameter(1, v)};
  const Exact_rational weight = f[3](local);
  if (weight == 0)
    throw Invalid_input("Rational_bisector_piece_3: a pole of the bisector");
  return {Exact_rational(f[0](local) / weight), Exact_rational(f[1](local) / weight),
          Exact_rational(f[2](local) / weight)};
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTOR_PIECE_3_H
