// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

A number type the solver can compute with: a field, together with a specialisation of
`CGAL::Spline_constraints::Number_traits` that says what its values
are worth. The same solver source runs on every model; what differs is what a result proves.

A model is of one of three kinds, told apart by two constants of its traits:

- *exact* (`is_exact`): operations make no error, so every sign is certain;
- an *enclosure* (`is_enclosure`): a value is an interval that contains the number it stands for, and a sign is
  certain if all of the interval
  has it;
- *rounded* (neither): a value is near the number it stands for. Whoever computes with it keeps a bound on the error,
  from `unit_roundoff` and
  `underflow_error`, and a sign is certain if the value exceeds the bound.

`int`, `CGAL::Mpzf` and the other rings of CGAL have no division that inverts the product and are no models; neither
are `float` and
`CGAL::Interval_nt<true>`, which have nothing over `double` and `CGAL::Interval_nt<false>`. The language concept
`CGAL::Spline_constraints::SplineNumberType` checks all that is below, and
`CGAL::Spline_constraints::assert_spline_number_type()` turns a failure into
one sentence that names what is missing.

\cgalHeading{Number traits}

`Number_traits<NT>` of a model `NT` has these members; their meaning stands with the class.

| Member | Requirement |
| ------ | ----------- |
| `is_exact`, `is_enclosure` | constants of type `bool`, not both `true` |
| `name` | constant, convertible to `std::string_view` |
| `unit_roundoff` | `double` constant: bounds the relative error of an operation in any rounding mode |
| `Coordinate` | the type of the coordinates of boxes: default constructible and copyable |
| `Rounding_guard` | default constructible; alive while the operators are used |
| `from_double(double)` | the number, exactly; throws `Invalid_input` for infinities and NaN |
| `from_rational(Exact_rational)` | the number: exactly, as the tightest enclosure, or as a neighbouring value |
| `enclosure(NT)` | `CGAL::Interval_nt<false>` that contains the value, infinite where doubles end |
| `sign(NT)` | `CGAL::Uncertain<CGAL::Sign>` of the value |
| `scale_by_power_of_two(NT&, int)` | multiplies by a power of two, without error |
| `half_sum(NT, NT)` | half the sum, with the error of one addition |

The traits of the package's own models also have `underflow_error`, which bounds the absolute error that underflow
adds to one product.

\cgalHeading{Threads}

Different objects can be used by different threads at the same time. A `Rounding_guard` works for the thread that
makes it.

\cgalHasModelsBegin
\cgalHasModels{double}
\cgalHasModels{CGAL::Interval_nt<false>}
\cgalHasModels{CGAL::Spline_constraints::Mpfr_interval}
\cgalHasModels{CGAL::Exact_rational}
\cgalHasModelsEnd

\sa `CGAL::Spline_constraints::Number_traits`
*/
class SplineNumberType
{
public:
  /// \name Creation
  /// Models are default constructible (with any value), copyable and assignable.
  /// @{

  /// default constructor.
  SplineNumberType();
  /// @}

  /// \name Operations
  /// What they return may be another type (an expression) that converts to the number type. They are to be used while a
  /// `Number_traits<NT>::Rounding_guard` is alive.
  /// @{

  /// the sum.
  SplineNumberType operator+(SplineNumberType a, SplineNumberType b);

  /// the difference.
  SplineNumberType operator-(SplineNumberType a, SplineNumberType b);

  /// the product.
  SplineNumberType operator*(SplineNumberType a, SplineNumberType b);

  /// the quotient. Where `b` is 0 or an enclosure that contains 0, an enclosure returns one of the entire line; the
  /// other kinds have `b != 0` for a
  /// precondition.
  SplineNumberType operator/(SplineNumberType a, SplineNumberType b);

  /// the opposite number.
  SplineNumberType operator-(SplineNumberType a);

  /// adds `b` to `a`.
  SplineNumberType& operator+=(SplineNumberType& a, SplineNumberType b);

  /// subtracts `b` from `a`.
  SplineNumberType& operator-=(SplineNumberType& a, SplineNumberType b);

  /// multiplies `a` by `b`.
  SplineNumberType& operator*=(SplineNumberType& a, SplineNumberType b);
  /// @}
};
