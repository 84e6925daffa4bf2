// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_INTERSECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_INTERSECTION_H

#include <cstddef>
#include <vector>

// What every program under comparison is asked, and how it answers: one source file per program.
namespace peers {

// The input is doubles, the same for all programs; exact ones take them for the rational numbers that they are.
struct Control_point
{
  double x, y;
};

using Bezier_curve = std::vector<Control_point>;

// What a program says of the intersections of two operands, or of the distance between them.
struct Intersections
{
  int points = 0;
  int overlaps = 0;           // common pieces of the curves
  int undecided = 0;          // places that may be intersections, and are reported as such
  bool is_overlap_suspected = false;
  bool has_failed = false;    // the program says so
  double distance = 0;        // if that is what was asked for

  friend bool operator==(const Intersections&, const Intersections&) = default;
};

// Where the time of one run went, in seconds; only `total` is filled by programs that do not tell.
struct Phases
{
  double total = 0;
  double building = 0;     // from the control points to a system of constraints
  double setup = 0;        // from the system to the integers of the solver
  double rebuilding = 0;   // exact Bernstein coefficients
  std::size_t nodes = 0, rebuilds = 0;
};

struct Run
{
  Intersections answer;
  Phases phases;
};

// One run, from the control points to the answer. The caller fills `phases.total`.
Run intersect_with_spline_constraints(const Bezier_curve& a, const Bezier_curve& b);
Run intersect_with_sisl(const Bezier_curve& a, const Bezier_curve& b);
Run intersect_with_open_cascade(const Bezier_curve& a, const Bezier_curve& b);
Run intersect_with_algebraic_kernel(const Bezier_curve& a, const Bezier_curve& b);
Run intersect_with_bezier_traits(const Bezier_curve& a, const Bezier_curve& b);

} // namespace peers

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_CURVE_INTERSECTION_H
