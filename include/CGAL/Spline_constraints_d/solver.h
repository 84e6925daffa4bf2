// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_H

// All of the floor of solvers: systems, the solvers of points, of curves and of surfaces, feasibility, verification.
// For solvers with traits of your own include solver/own_traits.h as well, which has the definitions that the compiled
// library has for the others.
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_tracker.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Newton_result.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Parameter_grid.h>
#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Tracker_options.h>
#include <CGAL/Spline_constraints_d/solver/Tracking_step.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#include <CGAL/Spline_constraints_d/solver/Visitor_reference.h>
#include <CGAL/Spline_constraints_d/solver/batch.h>
#include <CGAL/Spline_constraints_d/solver/concepts.h>
#include <CGAL/Spline_constraints_d/solver/curve_extremes.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>
#include <CGAL/Spline_constraints_d/solver/newton_improvement.h>
#include <CGAL/Spline_constraints_d/solver/reductions.h>
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>
#include <CGAL/Spline_constraints_d/solver/splitters.h>
#include <CGAL/Spline_constraints_d/solver/termination_tests.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_H
