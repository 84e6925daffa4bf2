// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/Values_of_symbols.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A finite end of a range; converts from the built-in numbers and from `Exact_rational`, exactly.
*/
class Bound
{
  Exact_rational m_value;

public:
  //! \throws Invalid_input when the value is not a finite number.
  template <class T>
    requires std::constructible_from<Power_polynomial, const T&> && (!std::derived_from<T, Power_polynomial>)
  Bound(const T& value) : m_value(Power_polynomial(value).constant_term()) {}

  //! the number.
  const Exact_rational& value() const { return m_value; }
};

/*!
\ingroup PkgSplineConstraintsDFunctions

An unknown number in a given range: the \f$i\f$-th of those that one call of `unknowns()` made.
*/
class Unknown
  : public Expression
{
  int m_index;

public:
  //! an unknown among the symbols that the package keeps in a table. \throws Invalid_input when the table has no such
  //! unknown.
  Unknown(std::shared_ptr<internal::Symbol_table> symbols, int index);

  //! its place among the unknowns that were made together.
  int index() const { return m_index; }

  //! its range.
  const std::pair<Exact_rational, Exact_rational>& domain() const { return symbols()->domains()[m_index]; }

#ifndef DOXYGEN_RUNNING
  // Those of formulas, which fit less well than the templates that CGAL has by these names.
  friend Expression sqrt(const Unknown& x) { return sqrt(static_cast<const Expression&>(x)); }
  friend Expression abs(const Unknown& x) { return abs(static_cast<const Expression&>(x)); }
  friend Expression square(const Unknown& x) { return square(static_cast<const Expression&>(x)); }
#endif
};

/*!
\ingroup PkgSplineConstraintsDFunctions

makes unknowns with the given ranges, as many as there are.
\throws Invalid_input when there is none, or a range is empty (the message names its index).
*/
std::vector<Unknown> unknowns(const std::vector<std::array<Bound, 2>>& ranges);

/*!
\ingroup PkgSplineConstraintsDFunctions

makes `count` unknowns with the same range: `auto x = unknowns(10, {-1, 1});`.
\throws Invalid_input when the count is zero or the range is empty.
*/
inline std::vector<Unknown> unknowns(std::size_t count, const std::array<Bound, 2>& range)
{
  return unknowns(std::vector<std::array<Bound, 2>>(count, range));
}

/*!
\ingroup PkgSplineConstraintsDFunctions

makes one unknown for each range: `auto [x, y] = unknowns({-2, 2}, {0, 0.5});`.
\throws Invalid_input when a range is empty or not finite.
*/
template <std::size_t... Sizes>
  requires (sizeof...(Sizes) > 0) && ((Sizes == 2) && ...)
std::array<Unknown, sizeof...(Sizes)> unknowns(const Bound (&...ranges)[Sizes])
{
  const std::vector<Unknown> made =
      unknowns(std::vector<std::array<Bound, 2>>{std::array<Bound, 2>{ranges[0], ranges[1]}...});
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Unknown, sizeof...(Sizes)>{made[I]...};
  }(std::make_index_sequence<sizeof...(Sizes)>());
}

/*!
\ingroup PkgSplineConstraintsDFunctions

the ranges of the unknowns that all constraints have in common.
\throws Invalid_input when unknowns come from different calls of `unknowns()` (the message names the constraint), or
there are none.
*/
const Unknown_domains& common_domains(std::span<const Constraint> constraints);

/*!
\ingroup PkgSplineConstraintsDFunctions

Constraints as polynomials in unknowns and in values of elementary functions, compared with zero on a box.
*/
struct Elementary_constraints
{
  Unknown_domains domain;                                         //!< a range for each unknown.
  std::vector<std::pair<Power_polynomial, Relation>> constraints; //!< with the conditions at the end.
  Elementary_values values;                                       //!< what the values are.
};

/*!
\ingroup PkgSplineConstraintsDFunctions
constraints written as formulas, in this form: as `Propagation_solver_d` takes them. Divisors that may vanish make
further constraints, that they do not. Splines that are one polynomial on the ranges of their unknowns are multiplied
out.
\param constraints between the unknowns of one call of `unknowns()`.
\throws Invalid_input when there are unknowns of several calls, or none; when a spline of several pieces or an unknown
without a range occurs (the message names the constraint); and as the operations of `Power_polynomial`.
*/
Elementary_constraints elementary_constraints(std::span<const Constraint> constraints);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Unknown::Unknown(std::shared_ptr<internal::Symbol_table> symbols, int index)
  : Expression(Power_polynomial::variable(index), Monomial(), std::move(symbols)), m_index(index)
{
  if (this->symbols() == nullptr || !this->symbols()->is_unknown(index))
    throw Invalid_input("Unknown: no range for index " + std::to_string(index));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Unknown> unknowns(const std::vector<std::array<Bound, 2>>& ranges)
{
  if (ranges.empty())
    throw Invalid_input("unknowns: no ranges");
  Unknown_domains domains;
  for (const auto& [lower, upper] : ranges) {
    if (upper.value() < lower.value())
      throw Invalid_input("unknowns: the range of unknown " + std::to_string(domains.size()) + " is empty");
    domains.emplace_back(lower.value(), upper.value());
  }
  const auto symbols = std::make_shared<internal::Symbol_table>(std::move(domains));
  std::vector<Unknown> result;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    result.emplace_back(symbols, static_cast<int>(i));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Unknown_domains& common_domains(std::span<const Constraint> constraints)
{
  const Unknown_domains* result = nullptr;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Unknown_domains* own = constraints[i].domains.get();
    if (own == nullptr)
      continue;
    if (result != nullptr && own != result)
      throw Invalid_input("common_domains: the unknowns of constraint " + std::to_string(i) +
                          " come from another call of unknowns()");
    result = own;
  }
  if (result == nullptr)
    throw Invalid_input("common_domains: no unknown occurs in the constraints");
  return *result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Elementary_constraints elementary_constraints(std::span<const Constraint> constraints)
{
  Elementary_constraints result;
  result.domain = common_domains(constraints);
  std::vector<Power_polynomial> conditions;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    try {
      const Constraint& constraint = constraints[i];
      const auto in_values = [&](const Power_polynomial& polynomial) {
        return constraint.symbols == nullptr
            ? polynomial
            : internal::Values_of_symbols(*constraint.symbols, result.values)(polynomial);
      };
      result.constraints.emplace_back(in_values(constraint.function), constraint.relation);
      for (const Power_polynomial& condition : constraint.conditions)
        if (Power_polynomial own = in_values(condition); std::ranges::find(conditions, own) == conditions.end())
          conditions.push_back(std::move(own));
    } catch (const Invalid_input& error) {
      throw Invalid_input("elementary_constraints: constraint " + std::to_string(i) + ": " + error.what());
    }
  for (Power_polynomial& condition : conditions)
    result.constraints.emplace_back(std::move(condition), Relation::NOT_EQUAL);
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H
