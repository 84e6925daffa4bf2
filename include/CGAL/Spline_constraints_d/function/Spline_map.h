// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_MAP_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_MAP_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link ParametricMap `ParametricMap`\endlink: a curve or surface that
shows the splines it consists of.
*/
template <class Map>
concept ParametricMap = requires(const Map& map) {
  { Map::number_of_parameters } -> std::convertible_to<int>;
  { map.is_rational() } -> std::convertible_to<bool>;
  { map.weight() } -> std::convertible_to<Bspline_function<Exact_rational>>;
  {
    map.homogeneous_coordinates()
    }
    -> std::convertible_to<std::array<Bspline_function<Exact_rational>,
                                      std::tuple_size_v<std::remove_cvref_t<decltype(map.homogeneous_coordinates())>>>>;
};

/*!
\ingroup PkgSplineConstraintsDFunctions

A curve or surface as formulas use it: a map \f$x/w^k\f$ from one or two parameters to the plane or space, with exact
splines \f$x\f$ and \f$w\f$.

`c(u)` is the point of the curve `c` with the unknown `u` as parameter, and `derivative(c)(u)` the derivative there, so
that an equation reads `dot(p - c(u), derivative(c)(u)) == 0`. All points of one map share its weight, which cancels
where it occurs on both sides. Copies are cheap; points of equal maps are recognized to be equal, those of copies
without comparing the splines.

\tparam number_of_parameters_ the number of parameters, 1 for a curve, 2 for a surface.
\tparam dimension_ the number of coordinates, 2 or 3.

\sa `ParametricMap`
*/
template <int number_of_parameters_, int dimension_>
  requires (number_of_parameters_ == 1 || number_of_parameters_ == 2) && (dimension_ == 2 || dimension_ == 3)
class Spline_map
{
  using Spline = std::shared_ptr<const internal::Integer_spline>;

  std::array<std::pair<Exact_rational, Exact_rational>, number_of_parameters_> m_domain;
  std::array<Spline, dimension_> m_coordinates;
  Spline m_weight;   // null: none
  int m_weight_exponent = 0;

public:
  //! number of parameters.
  static constexpr int number_of_parameters = number_of_parameters_;

  //! number of coordinates.
  static constexpr int dimension = dimension_;

  //! the map with these coordinates. \throws Invalid_input when they have a wrong number of parameters or different
  //! domains.
  explicit Spline_map(const std::array<Bspline_function<Exact_rational>, dimension_>& coordinates)
  {
    for (int i = 0; i < dimension_; ++i) {
      check_parameters(coordinates[i], coordinates[0], "coordinate " + std::to_string(i));
      m_coordinates[i] = std::make_shared<const internal::Integer_spline>(coordinates[i]);
    }
    for (int j = 0; j < number_of_parameters_; ++j)
      m_domain[j] = coordinates[0].domain(j);
  }

  /*!
  the map with the coordinates `coordinates[i] / weight`.
  \throws Invalid_input also when the weight has a wrong number of parameters or another domain, vanishes, has both
  signs, or comes so close to zero that its sign cannot be proved within the limits of `Weight_options`.
  */
  Spline_map(const std::array<Bspline_function<Exact_rational>, dimension_>& coordinates,
             const Bspline_function<Exact_rational>& weight)
    : Spline_map(coordinates)
  {
    check_parameters(weight, coordinates[0], "the weight");
    const int sign = internal::certified_weight_sign(weight, {});
    m_weight = std::make_shared<const internal::Integer_spline>(weight);
    m_weight_exponent = 1;
    if (sign < 0) {
      m_weight = negative(m_weight);
      for (Spline& coordinate : m_coordinates)
        coordinate = negative(coordinate);
    }
  }

  //! the map of a curve or surface. \throws Invalid_input as the other constructors.
  template <ParametricMap Map>
  requires(!std::same_as<Map, Spline_map>) explicit Spline_map(const Map& map)
    : Spline_map(map.is_rational() ? Spline_map(map.homogeneous_coordinates(), map.weight())
                                   : Spline_map(map.homogeneous_coordinates()))
  {
    static_assert(Map::number_of_parameters == number_of_parameters_);
  }

  //! the range of a parameter.
  const std::pair<Exact_rational, Exact_rational>& domain(int axis) const { return m_domain[axis]; }

  //! where the map is cut into polynomial or rational pieces along an axis, the two ends of the domain included.
  std::vector<Exact_rational> breaks(int axis) const
  {
    std::vector<Exact_rational> result = m_coordinates[0]->breaks()[axis];
    for (const Spline& coordinate : m_coordinates)
      result = internal::united(result, coordinate->breaks()[axis]);
    return m_weight == nullptr ? result : internal::united(result, m_weight->breaks()[axis]);
  }

  //! whether both ends of an axis carry the same points at the same parameters, exactly.
  bool is_closed(int axis = 0) const
  {
    const auto [begin, end] = m_domain[axis];
    // by the weight of the other end, so that the numerators can be compared
    const auto scaled = [&](int i, const Exact_rational& own, const Exact_rational& other) {
      internal::Integer_spline result = m_coordinates[i]->face(axis, own);
      for (int k = 0; k < m_weight_exponent; ++k)
        result = result * m_weight->face(axis, other);
      return result;
    };
    for (int i = 0; i < dimension_; ++i) {
      const internal::Integer_spline jump =
          internal::Integer_spline::difference(scaled(i, begin, end), scaled(i, end, begin), 1);
      if (!jump.is_constant() || jump.constant() != Exact_rational(0))
        return false;
    }
    return true;
  }

  //! the map on a part of its domain; parameters keep their meaning. Between successive breaks every derivative exists.
  //! \throws Invalid_input when the part is empty or not within the domain.
  Spline_map restricted(int axis, const Exact_rational& begin, const Exact_rational& end) const
  {
    if (!(m_domain[axis].first <= begin && begin < end && end <= m_domain[axis].second))
      throw Invalid_input("Spline_map: the part to restrict axis " + std::to_string(axis) +
                          " to is empty or not within the domain");
    const auto part_of = [&](const Spline& spline) {
      return std::make_shared<const internal::Integer_spline>(spline->restricted(axis, begin, end));
    };
    Spline_map result(*this);
    result.m_domain[axis] = {begin, end};
    for (Spline& coordinate : result.m_coordinates)
      coordinate = part_of(coordinate);
    if (m_weight != nullptr)
      result.m_weight = part_of(m_weight);
    return result;
  }

  //! the point with the given unknowns as parameters.
  //! \throws Invalid_input when the range of an unknown is not within that of its parameter, or the unknowns come from
  //! different calls of `unknowns()` or are the same.
  template <std::convertible_to<const Unknown&>... Parameters>
    requires (sizeof...(Parameters) == number_of_parameters_)
  Vector_expression<dimension_> operator()(const Parameters&... parameters) const
  {
    const std::array<const Unknown*, number_of_parameters_> unknowns{&static_cast<const Unknown&>(parameters)...};
    const std::vector<int> indices = checked_indices(unknowns);
    internal::Symbol_table& symbols = *unknowns[0]->symbols();
    Expression factor = 1;
    if (m_weight != nullptr) {
      const Expression weight(symbols.spline_of_unknowns(m_weight, indices, 1), Monomial(), unknowns[0]->symbols());
      factor /= pow(weight, m_weight_exponent);
    }
    return internal::vector_of<dimension_>([&](std::size_t i) {
      return Expression(symbols.spline_of_unknowns(m_coordinates[i], indices, 0), Monomial(), unknowns[0]->symbols()) *
          factor;
    });
  }

  //! the point at given parameters, exactly. \throws Invalid_input when there are too many or too few of them, or one
  //! is outside of the domain.
  std::array<Exact_rational, dimension_> operator()(std::span<const Exact_rational> parameters) const
  {
    internal::check_count(parameters.size(), number_of_parameters_, "Spline_map: parameters of a point");
    for (int j = 0; j < number_of_parameters_; ++j)
      if (parameters[j] < m_domain[j].first || m_domain[j].second < parameters[j])
        throw Invalid_input("Spline_map: parameter " + std::to_string(j) + " is outside of the domain");
    Exact_rational divisor(1);
    for (int k = 0; k < m_weight_exponent; ++k)
      divisor *= (*m_weight)(parameters);
    std::array<Exact_rational, dimension_> result;
    for (int i = 0; i < dimension_; ++i)
      result[i] = (*m_coordinates[i])(parameters) / divisor;
    return result;
  }

  /*!
  the derivative by a parameter, \f$(x' w - k\, x w')/w^{k+1}\f$. Repeat it for higher derivatives.

  It exists as one map only if it is continuous, as a formula has to be: `x'` and `w'` may jump at a knot, the numerator
  must not.
  \throws Invalid_input when there is no such parameter, or the numerator jumps; the message says where. To use the
  derivative of such a curve, split it there by `restricted()` and write the constraints for each part.
  */
  friend Spline_map derivative(const Spline_map& map, int axis = 0)
  {
    if (axis < 0 || axis >= number_of_parameters_)
      throw Invalid_input("derivative: no parameter " + std::to_string(axis) + " among " +
                          std::to_string(number_of_parameters_));
    Spline_map result(map);
    for (int i = 0; i < dimension_; ++i) {
      internal::Integer_spline numerator = map.m_coordinates[i]->piecewise_derivative(axis);
      if (map.m_weight != nullptr)
        numerator = internal::Integer_spline::difference(
            numerator * *map.m_weight, *map.m_coordinates[i] * map.m_weight->piecewise_derivative(axis),
            map.m_weight_exponent);
      numerator.check_continuity("derivative: coordinate " + std::to_string(i));
      result.m_coordinates[i] = std::make_shared<const internal::Integer_spline>(std::move(numerator));
    }
    result.m_weight_exponent += map.m_weight != nullptr ? 1 : 0;
    return result;
  }

private:
  static Spline negative(const Spline& spline) { return std::make_shared<const internal::Integer_spline>(-*spline); }

  static void check_parameters(const Bspline_function<Exact_rational>& function,
                               const Bspline_function<Exact_rational>& first, const std::string& what)
  {
    internal::check_count(function.dimension(), number_of_parameters_, "Spline_map: parameters of " + what);
    for (int j = 0; j < number_of_parameters_; ++j)
      if (function.domain(j) != first.domain(j))
        throw Invalid_input("Spline_map: " + what + " has another domain on axis " + std::to_string(j) +
                            " than the first coordinate");
  }

  std::vector<int> checked_indices(const std::array<const Unknown*, number_of_parameters_>& unknowns) const
  {
    std::vector<int> result;
    for (int j = 0; j < number_of_parameters_; ++j) {
      internal::common_symbols(unknowns[0]->symbols(), unknowns[j]->symbols());
      const auto& [lower, upper] = unknowns[j]->domain();
      if (lower < m_domain[j].first || m_domain[j].second < upper)
        throw Invalid_input("Spline_map: the range of unknown " + std::to_string(unknowns[j]->index()) +
                            " is not within the domain of parameter " + std::to_string(j));
      if (j > 0 && result[0] == unknowns[j]->index())
        throw Invalid_input("Spline_map: the same unknown for both parameters");
      result.push_back(unknowns[j]->index());
    }
    return result;
  }
};

//! \relates Spline_map
//! the map of a curve or surface.
template <ParametricMap Map>
Spline_map(const Map&) -> Spline_map<
    Map::number_of_parameters,
    std::tuple_size_v<std::remove_cvref_t<decltype(std::declval<const Map&>().homogeneous_coordinates())>>>;

namespace internal {

template <int number_of_parameters, int dimension>
const Spline_map<number_of_parameters, dimension>& to_spline_map(const Spline_map<number_of_parameters, dimension>& map)
{
  return map;
}

template <ParametricMap Map>
auto to_spline_map(const Map& map)
{
  return Spline_map(map);
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions
makes the parameters of curves and surfaces as unknowns, with the domains of these as ranges: `auto [u, s, t] =
parameters(curve, surface);`.
\tparam Maps `Spline_map`s or models of `ParametricMap`.
*/
template <class... Maps>
  requires (sizeof...(Maps) > 0) && requires(const Maps&... maps) { (internal::to_spline_map(maps), ...); }
auto parameters(const Maps&... maps)
{
  std::vector<std::array<Bound, 2>> ranges;
  const auto add = [&](const auto& map) {
    for (int j = 0; j < map.number_of_parameters; ++j)
      ranges.push_back({Bound(map.domain(j).first), Bound(map.domain(j).second)});
  };
  (add(internal::to_spline_map(maps)), ...);
  const std::vector<Unknown> made = unknowns(ranges);
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Unknown, sizeof...(I)>{made[I]...};
  }(std::make_index_sequence<(Maps::number_of_parameters + ...)>());
}

/*!
\ingroup PkgSplineConstraintsDFunctions
the normal \f$(-y', x')\f$ of a planar curve at a parameter, not of unit length. \throws Invalid_input as
`derivative()`.
*/
inline Vector_expression<2> normal(const Spline_map<1, 2>& curve, const Unknown& u)
{
  return perpendicular(derivative(curve)(u));
}

/*!
\ingroup PkgSplineConstraintsDFunctions
the normal of a surface at a parameter, not of unit length: the cross product of its derivatives. \throws Invalid_input
as `derivative()`.
*/
inline Vector_expression<3> normal(const Spline_map<2, 3>& surface, const Unknown& u, const Unknown& v)
{
  return cross(derivative(surface, 0)(u, v), derivative(surface, 1)(u, v));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SPLINE_MAP_H
