// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

The closed ranges of all unknowns that were made by one call of `unknowns()`, in their order.
*/
using Unknown_domains = std::vector<std::pair<Exact_rational, Exact_rational>>;

/*!
\ingroup PkgSplineConstraintsDFunctions

A polynomial equation or inequality in unknowns, as a user writes it: `x*x + y*y == 2` is the constraint `function relation 0`
with the function \f$x^2+y^2-2\f$ and the relation `EQUAL`.
*/
struct Constraint
{
  //! left side minus right side; its unknowns are indices into `*domains`.
  Power_polynomial function;

  //! how the function compares with zero.
  Relation relation;

  //! the ranges of the unknowns, shared by all that were made together; null when no unknown occurs in the formula.
  std::shared_ptr<const Unknown_domains> domains;

  //! writes, for example, `-2 + x0^2 + x1^2 = 0`.
  friend std::ostream& operator<<(std::ostream& out, const Constraint& constraint)
  {
    return out << constraint.function << ' ' << constraint.relation << " 0";
  }
};

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

A formula in unknowns: what `+`, `-`, `*`, `/` (by a constant) and `pow` make of `Unknown`s and numbers. Comparing two expressions
makes a `Constraint`.

\throws Invalid_input from every operation on two expressions whose unknowns come from different calls of `unknowns()`; and see `Power_polynomial`.
*/
class Expression
{
  Power_polynomial m_polynomial;
  std::shared_ptr<const Unknown_domains> m_domains;

protected:
  Expression(Power_polynomial polynomial, std::shared_ptr<const Unknown_domains> domains)
    : m_polynomial(std::move(polynomial)), m_domains(std::move(domains)) {}

public:
  //! a constant: a built-in number or an `Exact_rational`, exactly.
  //! \throws Invalid_input when the value is not a finite number.
  template <class T>
    requires std::convertible_to<const T&, Power_polynomial> && (!std::derived_from<T, Power_polynomial>)
  Expression(const T& constant) : m_polynomial(constant) {}

  //! the expanded formula.
  const Power_polynomial& polynomial() const { return m_polynomial; }

  //! the ranges of the unknowns that were made together with those in the formula; null when none occurs.
  const std::shared_ptr<const Unknown_domains>& domains() const { return m_domains; }

  Expression& operator+=(const Expression& other) { join(other); m_polynomial += other.m_polynomial; return *this; }
  Expression& operator-=(const Expression& other) { join(other); m_polynomial -= other.m_polynomial; return *this; }
  Expression& operator*=(const Expression& other) { join(other); m_polynomial *= other.m_polynomial; return *this; }

  //! division by a constant.
  //! \throws Invalid_input when the divisor is zero or not a constant.
  Expression& operator/=(const Expression& other) { join(other); m_polynomial /= other.m_polynomial; return *this; }

  friend Expression operator+(Expression a, const Expression& b) { return std::move(a += b); }
  friend Expression operator-(Expression a, const Expression& b) { return std::move(a -= b); }
  friend Expression operator*(Expression a, const Expression& b) { return std::move(a *= b); }
  friend Expression operator/(Expression a, const Expression& b) { return std::move(a /= b); }
  friend Expression operator+(Expression a) { return a; }
  friend Expression operator-(Expression a)
  {
    a.m_polynomial = -std::move(a.m_polynomial);
    return a;
  }

  //! a power with a non-negative exponent.
  //! \throws Invalid_input when the exponent is negative.
  friend Expression pow(const Expression& base, int exponent)
  {
    return Expression(pow(base.m_polynomial, exponent), base.m_domains);
  }

  //! the square.
  friend Expression square(const Expression& a) { return pow(a, 2); }

  friend Constraint operator==(Expression a, const Expression& b) { return compare(std::move(a), Relation::EQUAL, b); }
  friend Constraint operator<(Expression a, const Expression& b) { return compare(std::move(a), Relation::LESS, b); }
  friend Constraint operator<=(Expression a, const Expression& b) { return compare(std::move(a), Relation::LESS_EQUAL, b); }
  friend Constraint operator>=(Expression a, const Expression& b) { return compare(std::move(a), Relation::GREATER_EQUAL, b); }
  friend Constraint operator>(Expression a, const Expression& b) { return compare(std::move(a), Relation::GREATER, b); }
  friend Constraint operator!=(const Expression&, const Expression&) = delete;   // not closed: no root of it can be certified

  //! writes the polynomial.
  friend std::ostream& operator<<(std::ostream& out, const Expression& a) { return out << a.m_polynomial; }

private:
  void join(const Expression& other)
  {
    if (m_domains == nullptr)
      m_domains = other.m_domains;
    else if (other.m_domains != nullptr && other.m_domains != m_domains)
      throw Invalid_input("Expression: unknowns from different calls of unknowns() in one formula");
  }

  static Constraint compare(Expression a, Relation relation, const Expression& b)
  {
    a -= b;
    return Constraint{std::move(a.m_polynomial), relation, std::move(a.m_domains)};
  }
};

/*!
\ingroup PkgSplineConstraintsDFunctions

An unknown number in a given range: the \f$i\f$-th of those that one call of `unknowns()` made.
*/
class Unknown
  : public Expression
{
  std::size_t m_index;

public:
  //! the unknown of an index.
  //! \throws Invalid_input when the list has no such entry.
  Unknown(std::shared_ptr<const Unknown_domains> domains, std::size_t index)
    : Expression(Power_polynomial::variable(static_cast<int>(index)), std::move(domains)), m_index(index)
  {
    if (this->domains() == nullptr || index >= this->domains()->size())
      throw Invalid_input("Unknown: no range for index " + std::to_string(index));
  }

  //! its place among the unknowns that were made together.
  int index() const { return static_cast<int>(m_index); }

  //! its range.
  const std::pair<Exact_rational, Exact_rational>& domain() const { return (*domains())[m_index]; }
};

/*!
\ingroup PkgSplineConstraintsDFunctions

makes unknowns with the given ranges, as many as there are.
\throws Invalid_input when there is none, or a range is empty (the message names its index).
*/
inline std::vector<Unknown> unknowns(const std::vector<std::array<Bound, 2>>& ranges)
{
  if (ranges.empty())
    throw Invalid_input("unknowns: no ranges");
  auto domains = std::make_shared<Unknown_domains>();
  for (const auto& [lower, upper] : ranges) {
    if (upper.value() < lower.value())
      throw Invalid_input("unknowns: the range of unknown " + std::to_string(domains->size()) + " is empty");
    domains->emplace_back(lower.value(), upper.value());
  }
  std::vector<Unknown> result;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    result.emplace_back(domains, i);
  return result;
}

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
  const std::vector<Unknown> made = unknowns(std::vector<std::array<Bound, 2>>{std::array<Bound, 2>{ranges[0], ranges[1]}...});
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Unknown, sizeof...(Sizes)>{made[I]...};
  }(std::make_index_sequence<sizeof...(Sizes)>());
}

/*!
\ingroup PkgSplineConstraintsDFunctions

the ranges of the unknowns that all constraints have in common.
\throws Invalid_input when unknowns come from different calls of `unknowns()` (the message names the constraint), or there are none.
*/
inline const Unknown_domains& common_domains(std::span<const Constraint> constraints)
{
  const Unknown_domains* result = nullptr;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Unknown_domains* own = constraints[i].domains.get();
    if (own == nullptr)
      continue;
    if (result != nullptr && own != result)
      throw Invalid_input("common_domains: the unknowns of constraint " + std::to_string(i) + " come from another call of unknowns()");
    result = own;
  }
  if (result == nullptr)
    throw Invalid_input("common_domains: no unknown occurs in the constraints");
  return *result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_UNKNOWN_EXPRESSION_H
