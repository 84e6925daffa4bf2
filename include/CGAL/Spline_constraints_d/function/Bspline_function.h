// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BSPLINE_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BSPLINE_FUNCTION_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/internal/Local_weights.h>
#include <CGAL/Spline_constraints_d/function/internal/common_knots.h>
#include <CGAL/Spline_constraints_d/function/internal/spline_cells.h>
#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A continuous piecewise polynomial in any number of variables, as a tensor product of B-splines.

Axis \f$j\f$ of degree \f$d\f$ with \f$n\f$ control points has \f$n+d+1\f$ knots \f$t_0 \le \dots \le t_{n+d}\f$,
clamped or not, uniform or not; its domain is
\f$[t_d, t_n]\f$. Inside the domain a knot may occur up to \f$d\f$ times: \f$d\f$ times leaves a continuous function
with a kink, more would tear it, which is rejected since a root could hide in the gap. Control points are stored
row-major, the last axis fastest.

All operations are exact when `NT` is; they go through Bézier pieces and the blossom of the pieces (Ramshaw, 1987), so
that sums and products keep the smoothness of their operands at every knot. Results of sums, products, elevations and
restrictions have clamped knots.

\tparam NT a field number type whose comparisons are certain: a floating point type or an exact rational, no interval.

\cgalModels{MultivariateFunction,MultivariateSpline}
*/
template <class NT>
  requires internal::Totally_comparable<NT>
class Bspline_function
{
  using Axis = internal::Knot_axis<NT>;
  using Breaks = std::vector<internal::Break<NT>>;

  std::vector<Axis> m_axes;
  internal::Shared_vector<NT> m_coefficients;

  // Results of operations: nothing left to check.
  struct Unchecked {};
  Bspline_function(Unchecked, std::vector<Axis> axes, std::vector<NT> coefficients)
    : m_axes(std::move(axes)), m_coefficients(std::move(coefficients))
  {}

public:
  //! the type of coefficients, knots, parameters and values.
  using Number_type = NT;

  //! the constant zero without axes.
  Bspline_function() : m_coefficients(std::vector<NT>(1, NT(0))) {}

  /*!
  the spline with one degree and one knot vector per axis, and the control points in row-major order, last axis fastest.
  \throws Invalid_input for a negative degree, knots that decrease, are not finite, too few or too often the same, an
  empty domain, a wrong number of knot vectors or control points, a control point that is not finite. The message names
  axis and index.
  */
  Bspline_function(const std::vector<int>& degrees, std::vector<std::vector<NT>> knots, std::vector<NT> coefficients)
    : m_coefficients(std::move(coefficients))
  {
    internal::check_count(knots.size(), degrees.size(), "Bspline_function: knot vectors");
    internal::checked_tensor_size<NT>(degrees, "Bspline_function");
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      m_axes.push_back({degrees[j], std::move(knots[j])});
      internal::check_knots(m_axes.back(), "Bspline_function: axis " + std::to_string(j));
    }
    const std::size_t size = internal::checked_tensor_size<NT>(internal::extents(m_axes), "Bspline_function");
    internal::check_count(m_coefficients.size(), size, "Bspline_function: number of control points");
    internal::check_finite(*m_coefficients, "Bspline_function: control point");
  }

  /*!
  a single polynomial piece on a box: `tensor` with its unit box mapped onto it.
  \throws Invalid_input when the box has the wrong number of ranges, or a range is empty or not finite.
  */
  static Bspline_function from_tensor(const Bernstein_tensor<NT>& tensor, const std::vector<std::pair<NT, NT>>& box)
  {
    internal::check_count(box.size(), tensor.degrees().size(), "Bspline_function: ranges of the box");
    std::vector<std::vector<NT>> knots;
    for (std::size_t j = 0; j < box.size(); ++j) {
      knots.emplace_back(tensor.degrees()[j] + 1, box[j].first);
      knots.back().insert(knots.back().end(), tensor.degrees()[j] + 1, box[j].second);
    }
    return Bspline_function(tensor.degrees(), std::move(knots), tensor.coefficients());
  }

  // For the package: the knots of all axes, which copies share; and the spline of valid ones.
  const std::vector<internal::Knot_axis<NT>>& axes() const { return m_axes; }
  static Bspline_function on_axes(std::vector<internal::Knot_axis<NT>> axes, std::vector<NT> coefficients)
  {
    return Bspline_function(Unchecked(), std::move(axes), std::move(coefficients));
  }

  //! number of axes.
  int dimension() const { return static_cast<int>(m_axes.size()); }

  //! degree along an axis.
  int degree(int axis) const { return at(axis).degree; }

  //! all degrees.
  std::vector<int> degrees() const
  {
    std::vector<int> result(m_axes.size());
    std::transform(m_axes.begin(), m_axes.end(), result.begin(), [](const Axis& axis) { return axis.degree; });
    return result;
  }

  //! number of control points along an axis.
  std::size_t size(int axis) const { return at(axis).size(); }

  //! the knots of an axis.
  const std::vector<NT>& knots(int axis) const { return *at(axis).knots; }

  //! the control points, row-major, last axis fastest.
  const std::vector<NT>& coefficients() const { return *m_coefficients; }

  //! the range of the parameter of an axis.
  std::pair<NT, NT> domain(int axis) const { return {at(axis).begin(), at(axis).end()}; }

  //! the distinct knots in the domain of an axis, its two ends included, increasing: between them the function is one
  //! polynomial.
  std::vector<NT> breaks(int axis) const
  {
    std::vector<NT> result;
    for (const internal::Break<NT>& entry : internal::breaks_of(at(axis)))
      result.push_back(entry.value);
    return result;
  }

  /*!
  the polynomials between the breaks, each on the unit box, in row-major order of the cells, last axis fastest. Exact
  where `NT` is. Complexity: \f$O(d_j)\f$ operations per coefficient and axis, \f$O(d_j^3)\f$ per cell of an axis.
  */
  std::vector<Bernstein_tensor<NT>> bezier_pieces() const
  {
    std::vector<Breaks> own(m_axes.size());
    std::transform(m_axes.begin(), m_axes.end(), own.begin(), internal::breaks_of<NT>);
    return pieces_on(own);
  }

  /*!
  the value at a point of the domain.
  \throws Invalid_input when the point is of the wrong dimension or outside of the domain (the message names the axis).
  */
  NT operator()(std::span<const NT> u) const
  {
    return weights_at(u, 0).value(*m_coefficients);
  }

  //! value and first derivatives; at a knot with a kink the derivative to the right. \throws Invalid_input as the
  //! evaluation.
  Value_and_gradient<NT> value_and_gradient(std::span<const NT> u) const
  {
    return weights_at(u, 1).value_and_gradient(*m_coefficients);
  }

  //! the symmetric matrix of second derivatives, row by row, from the right at knots. \throws Invalid_input as the
  //! evaluation.
  std::vector<NT> hessian(std::span<const NT> u) const
  {
    return weights_at(u, 2).hessian(*m_coefficients);
  }

  //! least and largest control point: bounds of the function on its domain. Rounding of the control points is not
  //! accounted for.
  std::pair<NT, NT> bounds() const { return internal::least_and_greatest(*m_coefficients); }

  //! bounds of the derivative along an axis on the domain, kinks included.
  std::pair<NT, NT> derivative_bounds(int axis) const
  {
    if (at(axis).degree == 0)
      return {NT(0), NT(0)};
    return internal::least_and_greatest(transformed(axis, internal::derivative_matrix(at(axis))));
  }

  /*!
  the partial derivative.
  \throws Invalid_input when it is not continuous: when a knot inside the domain occurs as often as the degree. The
  derivatives of the `bezier_pieces()` exist all the same.
  */
  Bspline_function derivative(int axis) const
  {
    const Axis& own = at(axis);
    if (own.degree == 0)
      return Bspline_function(Unchecked(), m_axes, std::vector<NT>(m_coefficients.size(), NT(0)));
    std::vector<Axis> axes = m_axes;
    axes[axis] = {own.degree - 1, std::vector<NT>(own.knots.begin() + 1, own.knots.end() - 1)};
    internal::check_knots(axes[axis], "Bspline_function: derivative along axis " + std::to_string(axis));
    return Bspline_function(Unchecked(), std::move(axes), transformed(axis, internal::derivative_matrix(own)));
  }

  /*!
  the same function with one more knot. The other knots stay, clamped or not.
  \throws Invalid_input when the knot is not inside the domain, or occurs as often as the degree already.
  */
  Bspline_function with_knot(int axis, const NT& knot) const
  {
    const Axis& own = at(axis);
    if (!(own.begin() < knot && knot < own.end()))
      throw Invalid_input("Bspline_function: a knot to insert on axis " + std::to_string(axis) +
                          " is not inside the domain");
    std::vector<NT> knots = *own.knots;
    knots.insert(std::upper_bound(knots.begin(), knots.end(), knot), knot);
    Axis refined{own.degree, std::move(knots)};
    internal::check_knots(refined, "Bspline_function: knot insertion on axis " + std::to_string(axis));
    return refined_to(axis, std::move(refined));
  }

  /*!
  the same function with higher degrees, as smooth at its knots as before.
  \throws Invalid_input when a degree is below the present one, their number differs from the dimension, or the size
  overflows.
  */
  Bspline_function elevated(const std::vector<int>& degrees) const
  {
    internal::check_count(degrees.size(), m_axes.size(), "Bspline_function: degrees to elevate to");
    std::vector<Breaks> breaks;
    for (std::size_t j = 0; j < m_axes.size(); ++j) {
      if (degrees[j] < m_axes[j].degree)
        throw Invalid_input("Bspline_function: degree " + std::to_string(m_axes[j].degree) + " of axis " +
                            std::to_string(j) + " cannot be elevated to " + std::to_string(degrees[j]));
      breaks.push_back(internal::common_breaks(degrees[j], m_axes[j], m_axes[j]));
    }
    std::vector<Bernstein_tensor<NT>> pieces = pieces_on(breaks);
    for (Bernstein_tensor<NT>& piece : pieces)
      piece = piece.elevated(degrees);
    return assembled(degrees, breaks, pieces);
  }

  /*!
  the function on a part of its domain, which becomes the domain of the result; parameters keep their meaning.
  \throws Invalid_input when the part is empty or not within the domain.
  */
  Bspline_function restricted(int axis, const NT& begin, const NT& end) const
  {
    const Axis& own = at(axis);
    if (!(own.begin() <= begin && begin < end && end <= own.end()))
      throw Invalid_input("Bspline_function: the part to restrict axis " + std::to_string(axis) +
                          " to is empty or not within the domain");
    if (own.is_clamped() && begin == own.begin() && end == own.end())
      return *this;
    const Bspline_function near = with_spans(axis, begin, end);
    Breaks breaks{{begin, 1}};
    for (const auto& entry : internal::breaks_of(near.at(axis)))
      if (begin < entry.value && entry.value < end)
        breaks.push_back(entry);
    breaks.push_back({end, 1});
    return near.refined_to(axis, internal::clamped(own.degree, breaks));
  }

  //! the parts before and after a parameter inside the domain. \throws Invalid_input when it is not inside.
  std::pair<Bspline_function, Bspline_function> split(int axis, const NT& t) const
  {
    return {restricted(axis, at(axis).begin(), t), restricted(axis, t, at(axis).end())};
  }

  //! the restriction to the first (`side` 0) or last (`side` 1) parameter of an axis, of one dimension less.
  Bspline_function face(int axis, int side) const { return slice(axis, side == 0 ? at(axis).begin() : at(axis).end()); }

  //! the restriction to a parameter of an axis, of one dimension less. \throws Invalid_input when it is not within the
  //! domain.
  Bspline_function slice(int axis, const NT& u) const
  {
    const Axis& own = at(axis);
    if (!(own.begin() <= u && u <= own.end()))
      throw Invalid_input("Bspline_function: the parameter for a slice along axis " + std::to_string(axis) +
                          " is not within the domain");
    std::vector<Axis> axes = m_axes;
    axes.erase(axes.begin() + axis);
    if (own.is_clamped() && (u == own.begin() || u == own.end()))   // there, control points are values
      return Bspline_function(Unchecked(), std::move(axes),
                              internal::tensor_range(*m_coefficients, internal::extents(m_axes), axis,
                                                     u == own.begin() ? 0 : own.size() - 1, 1));
    const std::size_t span = internal::span_of(own, u);
    internal::Band_matrix<NT> matrix = internal::band_matrix(own);
    matrix.add_row(span - own.degree, internal::derivative_weights(own, span, u, 0));
    return Bspline_function(Unchecked(), std::move(axes), transformed(axis, matrix));
  }

  /*!
  the function of as many parameters as `domain` has ranges, which depends on `axes` only: own axis `i` becomes axis
  `axes[i]`, the others get degree 0. The ranges of own axes are not looked at.
  \throws Invalid_input when an axis is missing, repeated or without a range, or another range is empty or not finite.
  */
  Bspline_function embedded(const std::vector<std::pair<NT, NT>>& domain, const std::vector<int>& axes) const
  {
    Bernstein_tensor<NT> placed = Bernstein_tensor<NT>(internal::extents(m_axes), *m_coefficients)
                                      .embedded(static_cast<int>(domain.size()), axes);
    std::vector<Axis> result;
    for (const auto& range : domain)
      result.push_back({0, std::vector<NT>{range.first, range.second}});
    for (std::size_t i = 0; i < axes.size(); ++i)
      result[axes[i]] = m_axes[i];
    for (std::size_t j = 0; j < result.size(); ++j)
      internal::check_knots(result[j], "Bspline_function: axis " + std::to_string(j));
    return Bspline_function(Unchecked(), std::move(result), std::move(placed).coefficients());
  }

  //! the spline whose control points and knots are the images of these ones. \throws Invalid_input when the images are
  //! no valid spline.
  template <class Target, class Conversion>
  Bspline_function<Target> converted(const Conversion& conversion) const
  {
    std::vector<Target> coefficients;
    for (const NT& coefficient : m_coefficients)
      coefficients.push_back(conversion(coefficient));
    std::vector<std::vector<Target>> knots(m_axes.size());
    for (std::size_t j = 0; j < m_axes.size(); ++j)
      for (const NT& knot : m_axes[j].knots)
        knots[j].push_back(conversion(knot));
    return Bspline_function<Target>(degrees(), std::move(knots), std::move(coefficients));
  }

  //! sum of two splines on the same domain, on the knots of both. \throws Invalid_input when the domains differ.
  friend Bspline_function operator+(const Bspline_function& a, const Bspline_function& b)
  {
    return combined_linearly(a, b, [](const auto& f, const auto& g) { return f + g; });
  }

  //! difference of two splines on the same domain. \throws Invalid_input when the domains differ.
  friend Bspline_function operator-(const Bspline_function& a, const Bspline_function& b)
  {
    return combined_linearly(a, b, [](const auto& f, const auto& g) { return f - g; });
  }

  //! product of two splines on the same domain; degrees add up. \throws Invalid_input when the domains differ.
  friend Bspline_function operator*(const Bspline_function& a, const Bspline_function& b)
  {
    internal::check_same_domain(a.m_axes, b.m_axes);
    if (b.m_coefficients.size() == 1 && internal::are_clamped(a.m_axes))
      return a * b.m_coefficients[0];
    if (a.m_coefficients.size() == 1 && internal::are_clamped(b.m_axes))
      return b * a.m_coefficients[0];
    std::vector<int> degrees = a.degrees();
    for (std::size_t j = 0; j < degrees.size(); ++j)
      degrees[j] += b.m_axes[j].degree;
    return combined(a, b, degrees, [](const auto& f, const auto& g) { return f * g; });
  }

  friend Bspline_function operator+(Bspline_function a, NT b) { return std::move(a.apply([&](NT& x) { x += b; })); }
  friend Bspline_function operator-(Bspline_function a, NT b) { return std::move(a.apply([&](NT& x) { x -= b; })); }
  friend Bspline_function operator*(Bspline_function a, NT b) { return std::move(a.apply([&](NT& x) { x *= b; })); }
  friend Bspline_function operator+(NT a, Bspline_function b) { return std::move(b) + a; }
  friend Bspline_function operator-(NT a, const Bspline_function& b) { return -b + a; }
  friend Bspline_function operator*(NT a, Bspline_function b) { return std::move(b) * a; }

  //! the negative.
  Bspline_function operator-() const
  {
    Bspline_function result = *this;
    return std::move(result.apply([](NT& x) { x = -x; }));
  }

  //! whether two splines are the same function on the same domain, whatever their knots and degrees. Decides only where
  //! `NT` is exact.
  friend bool operator==(const Bspline_function& a, const Bspline_function& b)
  {
    if (!internal::have_same_domain(a.m_axes, b.m_axes))
      return false;
    if (a.m_axes == b.m_axes && internal::are_clamped(a.m_axes))
      return a.m_coefficients == b.m_coefficients;
    const std::vector<Breaks> breaks =
        internal::common_break_grid(a.m_axes, b.m_axes, internal::highest_degrees(a.m_axes, b.m_axes));
    return a.pieces_on(breaks) == b.pieces_on(breaks);
  }

private:
  const Axis& at(int axis) const
  {
    CGAL_precondition(0 <= axis && axis < dimension());
    return m_axes[axis];
  }

  std::vector<NT> transformed(int axis, const internal::Band_matrix<NT>& matrix) const
  {
    return internal::transform_axis(*m_coefficients, internal::axis_view(internal::extents(m_axes), axis), matrix);
  }

  // With the knots and control points of an axis that the function depends on between two parameters.
  Bspline_function with_spans(int axis, const NT& begin, const NT& end) const
  {
    const auto [first, count] = internal::points_between(at(axis), begin, end);
    if (count == at(axis).size())
      return *this;
    std::vector<Axis> axes = m_axes;
    axes[axis] = internal::part_of_axis(at(axis), first, count);
    return Bspline_function(Unchecked(), std::move(axes),
                            internal::tensor_range(*m_coefficients, internal::extents(m_axes), axis, first, count));
  }

  Bspline_function refined_to(int axis, Axis finer) const
  {
    std::vector<NT> coefficients = transformed(axis, internal::refinement_matrix(m_axes[axis], finer));
    std::vector<Axis> axes = m_axes;
    axes[axis] = std::move(finer);
    return Bspline_function(Unchecked(), std::move(axes), std::move(coefficients));
  }

  template <class Change>
  Bspline_function& apply(const Change& change)
  {
    std::vector<NT> changed = *m_coefficients;
    std::for_each(changed.begin(), changed.end(), change);
    m_coefficients = std::move(changed);
    return *this;
  }

  internal::Local_weights<NT> weights_at(std::span<const NT> u, int order) const
  {
    return internal::Local_weights<NT>(m_axes, u, order, "Bspline_function: ");
  }

  std::vector<Bernstein_tensor<NT>> pieces_on(const std::vector<Breaks>& breaks) const
  {
    return internal::pieces_on_cells(m_axes, *m_coefficients, breaks);
  }

  static Bspline_function assembled(const std::vector<int>& degrees, const std::vector<Breaks>& breaks,
                                    const std::vector<Bernstein_tensor<NT>>& pieces)
  {
    auto [axes, coefficients] = internal::assembled_cells(degrees, breaks, pieces);
    return Bspline_function(Unchecked(), std::move(axes), std::move(coefficients));
  }

  // On the same knots, control points are combined.
  template <class Operation>
  static Bspline_function combined_linearly(const Bspline_function& a, const Bspline_function& b,
                                            const Operation& operation)
  {
    internal::check_same_domain(a.m_axes, b.m_axes);
    const std::vector<int> degrees = internal::highest_degrees(a.m_axes, b.m_axes);
    if (!(a.m_axes == b.m_axes && internal::are_clamped(a.m_axes)))
      return combined(a, b, degrees, operation);
    std::vector<NT> coefficients;
    for (std::size_t k = 0; k < a.m_coefficients.size(); ++k)
      coefficients.push_back(NT(operation(a.m_coefficients[k], b.m_coefficients[k])));
    return Bspline_function(Unchecked(), a.m_axes, std::move(coefficients));
  }

  template <class Operation>
  static Bspline_function combined(const Bspline_function& a, const Bspline_function& b,
                                   const std::vector<int>& degrees, const Operation& operation)
  {
    const std::vector<Breaks> breaks = internal::common_break_grid(a.m_axes, b.m_axes, degrees);
    std::vector<Bernstein_tensor<NT>> pieces = a.pieces_on(breaks);
    const std::vector<Bernstein_tensor<NT>> others = b.pieces_on(breaks);
    for (std::size_t c = 0; c < pieces.size(); ++c)
      pieces[c] = operation(pieces[c], others[c]);
    return assembled(degrees, breaks, pieces);
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template class Bspline_function<double>;
extern template class Bspline_function<Exact_rational>;
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BSPLINE_FUNCTION_H
