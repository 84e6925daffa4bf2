// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `GraphNumber` describes what formulas of an `Expression_graph` can be evaluated in: copies, `+`, `-` with
one and with two operands, `*` and `/`. Constants are converted by `Number_traits<GraphNumber>::from_rational()`, if
there is such a specialisation, and otherwise by a constructor from `Exact_rational`. Integers of the language are no
models: their division cuts off.

The language concept of the same name in `CGAL/Spline_constraints_d/function/Graph_evaluation.h` checks what a compiler
can check.

\cgalHasModelsBegin
\cgalHasModels{double}
\cgalHasModels{CGAL::Interval_nt<false>}
\cgalHasModels{CGAL::Spline_constraints::Mpfr_interval}
\cgalHasModels{CGAL::Exact_rational}
\cgalHasModels{CGAL::Spline_constraints::Expression}
\cgalHasModelsEnd
*/
class GraphNumber
{};
