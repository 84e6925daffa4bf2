// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_SPLINE_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

What spline curves and surfaces have in common: a map from a box of parameters into the plane or into space, given by
numerators and a weight that are `Bspline_function`s on the same degrees and knots. Objects are values and never change;
operations return new ones.

Inside, numbers are doubles where those of the kernel are floating point numbers, else `Exact_rational`. With the latter
all operations are exact, with doubles each rounds as the operation of `Bspline_function` it is made of; decisions
(`operator==`, `is_closed()`, `without_knot()`, the sign of the weight) are exact for both: they are about the numbers
stored.

The weight is positive on the whole domain. That is proved when an object is made (its sign is changed together with
that of the numerators where needed), and refuted or unproved weights are rejected with `Invalid_input`.

\tparam Derived the curve or surface.
\tparam Kernel_ a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <class Derived, SplineKernel Kernel_, int d>
class Parametric_spline
{
  using Ambient = internal::Ambient_space<Kernel_, d>;

public:
  //! the kernel of points and parameters.
  using Kernel = Kernel_;
  //! the number type of the kernel.
  using FT = typename Kernel::FT;
  //! the number type of the coefficients: `double` or `Exact_rational`.
  using Number_type = internal::Spline_number<FT>;
  //! the points of the kernel in dimension `d`.
  using Point = typename Ambient::Point;
  //! the vectors of the kernel in dimension `d`.
  using Vector = typename Ambient::Vector;
  //! the affine maps of the kernel in dimension `d`.
  using Aff_transformation = typename Ambient::Aff_transformation;
  //! `CGAL::Bbox_2` or `CGAL::Bbox_3`.
  using Bbox = typename Ambient::Bbox;

  //! the dimension of the space.
  static constexpr int ambient_dimension = d;

protected:
  using NT = Number_type;
  using Representation = internal::Homogeneous_spline<NT, d>;

private:
  Representation m_map;

protected:
  explicit Parametric_spline(Representation map) : m_map(std::move(map)) {}

public:
  /// \name Representation
  /// @{

  //! whether there is a weight that is not constant.
  bool is_rational() const { return m_map.is_rational(); }

  //! the numerators of the coordinates, exactly: doubles are rational numbers.
  std::array<Bspline_function<Exact_rational>, d> homogeneous_coordinates() const
  {
    const auto exact = m_map.exact();
    std::array<Bspline_function<Exact_rational>, d> result;
    for (int i = 0; i < d; ++i)
      result[i] = exact.numerator(i);
    return result;
  }

  //! the weight, exactly; the constant one, of degree 0, if the map is polynomial.
  Bspline_function<Exact_rational> weight() const { return m_map.exact().weight(); }

  //! degree along an axis.
  int degree(int axis) const { return m_map.numerator(0).degree(axis); }

  //! number of control points along an axis.
  std::size_t size(int axis) const { return m_map.numerator(0).size(axis); }

  //! the knots of an axis.
  std::vector<FT> knots(int axis) const { return kernel_numbers(m_map.numerator(0).knots(axis)); }

  //! the distinct knots in the domain of an axis, its two ends included: between them the map is one polynomial or
  //! rational function.
  std::vector<FT> breaks(int axis) const { return kernel_numbers(m_map.numerator(0).breaks(axis)); }

  //! the range of the parameter of an axis.
  std::pair<FT, FT> domain(int axis) const
  {
    const std::pair<NT, NT> range = m_map.numerator(0).domain(axis);
    return {internal::converted_number<FT>(range.first), internal::converted_number<FT>(range.second)};
  }

  //! the control points, row-major, the last axis fastest.
  //! \throws Invalid_input when one has weight 0, which only `from_homogeneous_coordinates()` and operations on such
  //! maps admit.
  std::vector<Point> control_points() const
  {
    std::vector<Point> result;
    for (std::size_t k = 0; k < m_map.numerator(0).coefficients().size(); ++k)
      result.push_back(internal::kernel_object<Kernel, Point>(m_map.control_point(k)));
    return result;
  }

  //! the weights of the control points, in their order; all one if the map is polynomial.
  std::vector<FT> control_weights() const
  {
    std::vector<FT> result;
    for (std::size_t k = 0; k < m_map.numerator(0).coefficients().size(); ++k)
      result.push_back(internal::converted_number<FT>(m_map.control_weight(k)));
    return result;
  }

  // For the package.
  const Representation& representation() const { return m_map; }

  /// @}
  /// \name Operations
  /// @{

  /*!
  a box that contains the curve or surface: the hull of its control points, rounded outwards. Where control weights are
  not positive, parts are halved until they are.
  */
  Bbox bbox() const
  {
    const auto bounds = m_map.bounds();
    if constexpr (d == 2)
      return Bbox(bounds[0].inf(), bounds[1].inf(), bounds[0].sup(), bounds[1].sup());
    else
      return Bbox(bounds[0].inf(), bounds[1].inf(), bounds[2].inf(), bounds[0].sup(), bounds[1].sup(), bounds[2].sup());
  }

  //! the image under an affine map: its control points are the images of these, with the same weights.
  Derived transformed(const Aff_transformation& map) const
  {
    return Derived(
        m_map.transformed([&](int i, int j) { return internal::converted_number<NT>(FT(map.cartesian(i, j))); }));
  }

  //! the part over a range of the parameter of an axis; parameters keep their meaning.
  //! \throws Invalid_input when the range is empty or not within the domain.
  Derived restricted(int axis, const FT& begin, const FT& end) const
  {
    return mapped([&](const auto& f) { return f.restricted(axis, number(begin), number(end)); });
  }

  //! the parts before and after a parameter inside the domain of an axis. \throws Invalid_input when it is not inside.
  std::pair<Derived, Derived> split(int axis, const FT& t) const
  {
    const auto [begin, end] = domain(axis);
    return {restricted(axis, begin, t), restricted(axis, t, end)};
  }

  //! the same points with an axis run backwards, on the same domain. Doubles: knots inside the domain are rounded.
  //! \throws Invalid_input when rounded knots fall together.
  Derived reversed(int axis) const
  {
    return mapped([&](const auto& f) { return internal::reversed(f, axis); });
  }

  //! the same points with the domain of an axis mapped onto another. Doubles: knots inside the domain are rounded.
  //! \throws Invalid_input when the range is empty or not finite, or rounded knots fall together.
  Derived with_domain(int axis, const FT& begin, const FT& end) const
  {
    return mapped([&](const auto& f) { return internal::with_domain(f, axis, number(begin), number(end)); });
  }

  //! the same map with higher degrees. \throws Invalid_input when one is lower than the present one, or their number is
  //! wrong.
  Derived elevated(const std::vector<int>& degrees) const
  {
    return mapped([&](const auto& f) { return f.elevated(degrees); });
  }

  //! the same map with one more knot. \throws Invalid_input when it is not inside the domain, or occurs as often as the
  //! degree already.
  Derived with_knot(int axis, const FT& t) const
  {
    return mapped([&](const auto& f) { return f.with_knot(axis, number(t)); });
  }

  /*!
  the same map with one occurrence of a knot less, if it is smooth enough there; otherwise nothing. Whether it is, is
  decided exactly, for doubles too (rounded control points rarely are); in that case the control points that are
  returned are rounded.
  \throws Invalid_input when the knot does not occur inside the domain.
  */
  std::optional<Derived> without_knot(int axis, const FT& t) const
  {
    if (auto result = m_map.without_knot(axis, number(t)))
      return Derived(std::move(*result));
    return std::nullopt;
  }

  //! the pieces between the breaks, each on its own cell of the domain and with clamped knots, in row-major order of
  //! the cells.
  std::vector<Derived> bezier_pieces() const
  {
    std::vector<Derived> pieces(1, static_cast<const Derived&>(*this));
    for (int axis = 0; axis < m_map.dimension(); ++axis) {
      const std::vector<FT> own = breaks(axis);
      std::vector<Derived> finer;
      for (const Derived& piece : pieces)
        for (std::size_t c = 0; c + 1 < own.size(); ++c)
          finer.push_back(piece.restricted(axis, own[c], own[c + 1]));
      pieces = std::move(finer);
    }
    return pieces;
  }

  //! whether both ends of an axis carry the same points at the same parameters, exactly.
  bool is_closed(int axis) const
  {
    const auto end = [&](int side) { return m_map.exact().mapped([&](const auto& f) { return f.face(axis, side); }); };
    return end(0).is_same_map(end(1));
  }

  //! whether two are the same map on the same domain, exactly, whatever their knots, degrees and weights.
  friend bool operator==(const Derived& a, const Derived& b)
  {
    return a.representation().is_same_map(b.representation());
  }

  /// @}

protected:
  static NT number(const FT& x) { return internal::converted_number<NT>(x); }

  static std::vector<NT> numbers(const std::vector<FT>& values)
  {
    std::vector<NT> result;
    result.reserve(values.size());
    for (const FT& x : values)
      result.push_back(number(x));
    return result;
  }

  static std::vector<FT> kernel_numbers(const std::vector<NT>& values)
  {
    std::vector<FT> result;
    for (const NT& x : values)
      result.push_back(internal::converted_number<FT>(x));
    return result;
  }

  static std::vector<std::array<NT, d>> coordinates(const std::vector<Point>& points)
  {
    std::vector<std::array<NT, d>> result;
    result.reserve(points.size());
    for (const Point& p : points) {
      std::array<NT, d>& x = result.emplace_back();
      for (int i = 0; i < d; ++i)
        x[i] = number(p.cartesian(i));
    }
    return result;
  }

  static Representation from_functions(const std::array<Bspline_function<NT>, d>& numerators,
                                       const Bspline_function<NT>& weight, const std::string& who)
  {
    std::vector<Bspline_function<NT>> functions(numerators.begin(), numerators.end());
    functions.push_back(weight);
    for (const Bspline_function<NT>& f : functions)
      internal::check_count(static_cast<std::size_t>(f.dimension()),
                            static_cast<std::size_t>(Derived::number_of_parameters),
                            who + ": parameters of a coordinate");
    return Representation(std::move(functions), who);
  }

  template <class Operation>
  Derived mapped(const Operation& operation) const
  {
    return Derived(m_map.mapped(operation));
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_PARAMETRIC_SPLINE_H
