// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_COMPILED_SOLVERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_COMPILED_SOLVERS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Newton_result.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_search.h>
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>

#include <CGAL/tags.h>

#include <concepts>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class Traits>
using Coordinate_of = typename Number_traits<typename Traits::Number_type>::Coordinate;

// All solutions of a system, in no order; defined in subdivision/all_solutions.h.
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>>
all_solutions(const Constraint_system_d& system, const Solver_options& options, Run_control& control, Summary& summary);

// The same, of a system that is made smaller before; defined in decomposition/decomposed_solutions.h.
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>> decomposed_solutions(const Constraint_system_d& system,
                                                                    const Solver_options& options, Run_control& control,
                                                                    Summary& summary);

// The answers that one of these finds, alone or with other processes, with the work; defined in
// subdivision/solution_set.h.
template <class Traits>
using Solutions_finder = std::vector<Solution_d<Coordinate_of<Traits>>> (*)(const Constraint_system_d&,
                                                                            const Solver_options&, Run_control&,
                                                                            Summary&);
template <class Traits, class Concurrency_tag>
Solution_set_d<Coordinate_of<Traits>> solution_set(const Constraint_system_d& system, const Solver_options& options,
                                                   Solutions_finder<Traits> finder,
                                                   Round_distribution* distribution = nullptr);

// All curves of solutions of a system; defined in curves/all_curves.h.
template <class Traits, class Concurrency_tag>
Curve_solution_set_d all_curves(const Constraint_system_d& system, const Solver_options& options, Run_control& control,
                                const Curve_search& search);

// The same, of a system without the unknowns that equalities of degree one give; defined in
// decomposition/curves_after_elimination.h.
template <class Traits, class Concurrency_tag>
Curve_solution_set_d curves_after_elimination(const Constraint_system_d& system, const Solver_options& options,
                                              Run_control& control);

// All surfaces of solutions of a system, cut along the zeros of some functions; defined in surfaces/all_surfaces.h.
template <class Traits, class Concurrency_tag>
Surface_solution_set_d all_surfaces(const Constraint_system_d& system, const Solver_options& options,
                                    Run_control& control, const std::vector<Spline_function>& features = {});

// The same, of a system without the unknowns that equalities of degree one give; defined in
// decomposition/surfaces_after_elimination.h.
template <class Traits, class Concurrency_tag>
Surface_solution_set_d surfaces_after_elimination(const Constraint_system_d& system, const Solver_options& options,
                                                  Run_control& control, bool splits = true);

// The same of a system as it is, for each factor of its equalities; defined in surfaces/united_surfaces.h.
template <class Traits, class Concurrency_tag>
Surface_solution_set_d surfaces_of_factors(const Constraint_system_d& system, const Solver_options& options,
                                           Run_control& control);

// Newton's method from a start with as many coordinates as the system has unknowns; defined in Newton_iteration.h.
Newton_result improved_point(const Constraint_system_d& system, std::vector<double> start,
                             const Newton_options& options);

// Finds the point of a piece of a curve with the same parameter as a point near it; points_on_pieces() is defined in
// curves/Curve_points.h.
using Point_on_piece = std::function<std::vector<double>(const Curve_piece& piece, const std::vector<double>& near)>;
Point_on_piece points_on_pieces(const Constraint_system_d& system);

namespace verification {

// Whether an answer in a box, or between two ends of a segment, is proved; defined in verification/proof_of_answer.h.
bool is_proved(const Constraint_system_d& system, Solution_kind kind,
               const std::vector<std::pair<Exact_rational, Exact_rational>>& box,
               const std::vector<std::vector<Exact_rational>>& ends);

// Whether all cells of surfaces of solutions are proved; defined in verification/surface_proof.h.
bool are_surfaces_proved(const Surface_solution_set_d& set);

} // namespace verification

// Complete where solver/own_traits.h is included.
template <class Traits>
struct Definitions_of_solvers;

// Whether the compiled library has solvers of points, and of curves and surfaces.
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB
constexpr bool is_compiled_for_all_cores = true;
#else
constexpr bool is_compiled_for_all_cores = false;
#endif
template <class Traits, class Concurrency_tag>
constexpr bool are_curves_compiled = std::same_as<Traits, Certified_solver_traits> &&
    (std::same_as<Concurrency_tag, CGAL::Sequential_tag> || is_compiled_for_all_cores);
// The default ones with the cones of normals in place of graph boxes.
using Normal_cone_solver_traits = Solver_traits<double, Normal_cone_test>;
template <class Traits, class Concurrency_tag>
constexpr bool are_points_compiled = are_curves_compiled<Traits, Concurrency_tag> ||
    (std::same_as<Concurrency_tag, CGAL::Sequential_tag> &&
     (std::same_as<Traits, Fast_solver_traits> || std::same_as<Traits, Interval_solver_traits> ||
      std::same_as<Traits, Multiprecision_solver_traits> || std::same_as<Traits, Exact_solver_traits> ||
      std::same_as<Traits, Normal_cone_solver_traits>));

template <class T>
concept Complete_type = requires
{
  sizeof(T);
};

// Fails to compile where neither the compiled library nor the program has a solver.
template <class Traits, bool is_compiled>
constexpr void check_definitions()
{
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
  static_assert(is_compiled || Complete_type<Definitions_of_solvers<Traits>>,
                "include <CGAL/Spline_constraints_d/solver/own_traits.h> for solvers that the library does not have");
#endif
}

// The solvers that the compiled library has.
#define CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, TRAITS, TAG)                                                  \
  EXTERN template std::vector<Solution_d<Coordinate_of<TRAITS>>> all_solutions<TRAITS, TAG>(                           \
      const Constraint_system_d&, const Solver_options&, Run_control&, Summary&);                                      \
  EXTERN template std::vector<Solution_d<Coordinate_of<TRAITS>>> decomposed_solutions<TRAITS, TAG>(                    \
      const Constraint_system_d&, const Solver_options&, Run_control&, Summary&);                                      \
  EXTERN template Solution_set_d<Coordinate_of<TRAITS>> solution_set<TRAITS, TAG>(                                     \
      const Constraint_system_d&, const Solver_options&, Solutions_finder<TRAITS>, Round_distribution*);
#define CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_CURVES(EXTERN, TRAITS, TAG)                                                  \
  EXTERN template Curve_solution_set_d all_curves<TRAITS, TAG>(const Constraint_system_d&, const Solver_options&,      \
                                                               Run_control&, const Curve_search&);                     \
  EXTERN template Curve_solution_set_d curves_after_elimination<TRAITS, TAG>(const Constraint_system_d&,               \
                                                                             const Solver_options&, Run_control&);

#define CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_SURFACES(EXTERN, TRAITS, TAG)                                                \
  EXTERN template Surface_solution_set_d all_surfaces<TRAITS, TAG>(const Constraint_system_d&, const Solver_options&,  \
                                                                   Run_control&, const std::vector<Spline_function>&); \
  EXTERN template Surface_solution_set_d surfaces_of_factors<TRAITS, TAG>(const Constraint_system_d&,                  \
                                                                          const Solver_options&, Run_control&);        \
  EXTERN template Surface_solution_set_d surfaces_after_elimination<TRAITS, TAG>(                                      \
      const Constraint_system_d&, const Solver_options&, Run_control&, bool);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB
#define CGAL_SPLINE_CONSTRAINTS_ON_ALL_CORES(SOLVER, EXTERN) SOLVER(EXTERN, Certified_solver_traits, CGAL::Parallel_tag)
#else
#define CGAL_SPLINE_CONSTRAINTS_ON_ALL_CORES(SOLVER, EXTERN)
#endif
#define CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_POINTS(EXTERN)                                                     \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Certified_solver_traits, CGAL::Sequential_tag)                      \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Fast_solver_traits, CGAL::Sequential_tag)                           \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Interval_solver_traits, CGAL::Sequential_tag)                       \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Multiprecision_solver_traits, CGAL::Sequential_tag)                 \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Exact_solver_traits, CGAL::Sequential_tag)                          \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(EXTERN, Normal_cone_solver_traits, CGAL::Sequential_tag)                    \
  CGAL_SPLINE_CONSTRAINTS_ON_ALL_CORES(CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS, EXTERN)
#define CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_CURVES_AND_SURFACES(EXTERN)                                        \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_CURVES(EXTERN, Certified_solver_traits, CGAL::Sequential_tag)                      \
  CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_SURFACES(EXTERN, Certified_solver_traits, CGAL::Sequential_tag)                    \
  CGAL_SPLINE_CONSTRAINTS_ON_ALL_CORES(CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_CURVES, EXTERN)                               \
  CGAL_SPLINE_CONSTRAINTS_ON_ALL_CORES(CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_SURFACES, EXTERN)

#if defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) || defined(CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_POINTS(extern)
CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_CURVES_AND_SURFACES(extern)
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_COMPILED_SOLVERS_H
