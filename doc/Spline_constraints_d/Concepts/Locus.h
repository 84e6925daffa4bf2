// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `Locus` describes a curve or surface by constraints: parametric, procedural (offsets, evolutes) or implicit,
so that one operation takes all of them. A model of your own, such as a pedal curve or a caustic, is its pieces: a
formula of its points, and the equations that a given point satisfies.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Implicit_hypersurface<d>}
\cgalHasModels{CGAL::Spline_constraints::Offset_curve_2}
\cgalHasModels{CGAL::Spline_constraints::Offset_surface_3}
\cgalHasModels{CGAL::Spline_constraints::Evolute_2}
\cgalHasModels{CGAL::Spline_constraints::Parametric_locus<number_of_parameters,d>}
\cgalHasModels{CGAL::Spline_constraints::Point_locus<d>}
\cgalHasModelsEnd
*/
class Locus
{
public:
  //! the dimension of the space, 2 or 3.
  static constexpr int dimension = unspecified;

  //! number of parameters: 1 for curves, 2 for surfaces, 0 for what is implicit.
  static constexpr int number_of_parameters = unspecified;

  //! the dimension of the space minus that of the curve or surface.
  static constexpr int codimension = unspecified;

  //! the range of a parameter over all pieces; needed only where there are parameters.
  std::pair<Exact_rational, Exact_rational> domain(int axis) const;

  /*!
  smooth pieces whose union is the locus. Their constraints need not have solutions for all parameters; formulas are
  continuous. A point that two pieces have in common is found on both, unless one leaves its end to the other.
  */
  std::vector<Locus_piece<dimension>> locus_pieces() const;

  //! the ends of a curve. Without them, answers that are not told apart from an end are undecided. For other loci:
  //! none.
  std::vector<Locus_end<dimension>> locus_ends() const;
};
