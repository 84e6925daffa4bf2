// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `SplineKernel` describes a kernel of CGAL whose number type holds rational numbers and can say which. Curves
and surfaces take their points, vectors and affine maps from it.

Coordinates are taken exactly. Those of points that are computed are exact where the number type is, else the doubles of
a computation in doubles.

Kernels with integer or interval coordinates, or with numbers that are roots, as
`CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt` has them, are no models.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Exact_predicates_inexact_constructions_kernel}
\cgalHasModels{CGAL::Exact_predicates_exact_constructions_kernel}
\cgalHasModels{CGAL::Simple_cartesian<double>}
\cgalHasModels{CGAL::Simple_cartesian<Exact_rational>}
\cgalHasModels{CGAL::Simple_cartesian<CGAL::Gmpq>}
\cgalHasModelsEnd
*/
class SplineKernel
{
public:
  //! a floating point type; a fraction of integers, by `CGAL::Fraction_traits`, such as `Exact_rational` and
  //! `CGAL::Gmpq`; or a lazy number over `Exact_rational`, which its member `exact()` gives.
  typedef unspecified_type FT;

  //! points, vectors and affine maps in the plane, as in the concept `Kernel` of CGAL.
  typedef unspecified_type Point_2;
  typedef unspecified_type Vector_2;
  typedef unspecified_type Aff_transformation_2;

  //! points, vectors and affine maps in space.
  typedef unspecified_type Point_3;
  typedef unspecified_type Vector_3;
  typedef unspecified_type Aff_transformation_3;
};
