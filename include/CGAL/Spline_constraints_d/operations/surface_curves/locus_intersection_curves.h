// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_LOCUS_INTERSECTION_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_LOCUS_INTERSECTION_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/Parametric_locus.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Solved_part.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_curve_collector.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

template <class T>
concept Surface_locus = requires(const T& operand)
{
  to_locus(operand);
}
&&decltype(to_locus(std::declval<const T&>()))::dimension == 3 &&
    decltype(to_locus(std::declval<const T&>()))::codimension == 1;

template <class T>
concept Procedural_surface = Surface_locus<T> && Locus<T> && T::number_of_parameters == 2;

// The kernel of a parametric surface, else none.
template <class T>
struct Kernel_of_surface
{
  using type = void;
};

template <ParametricSurface_3 T>
struct Kernel_of_surface<T>
{
  using type = typename T::Kernel;
};

// Of the one that is parametric, if there is one.
template <class A, class B>
using Kernel_of_loci = std::conditional_t<
    ParametricSurface_3<A>, typename Kernel_of_surface<A>::type,
    std::conditional_t<ParametricSurface_3<B>, typename Kernel_of_surface<B>::type, CGAL::Simple_cartesian<double>>>;

// The constraints of a common point of two surfaces, each of one piece, whose closed axes have both of their ends.
class Locus_pair
{
  std::vector<Locus_piece<3>> m_pieces;
  std::vector<std::pair<std::size_t, std::size_t>> m_closed;   // surface and axis
  Locus_system<3> m_system;

public:
  template <class A, class B>
  Locus_pair(const A& a, const B& b)
    : m_pieces{only_piece(a), only_piece(b)}, m_closed(opened(m_pieces)), m_system(m_pieces)
  {}

  const Locus_system<3>& system() const { return m_system; }

  // What the unknowns are in space.
  static Place_of_unknowns place(const std::shared_ptr<const Locus_pair>& pair);

  Domain_joints joints() const;

private:
  std::vector<std::size_t> numbers_of_parameters() const
  {
    return {m_pieces[0].is_without_end.size(), m_pieces[1].is_without_end.size()};
  }

  template <class Surface>
  static Locus_piece<3> only_piece(const Surface& surface)
  {
    std::vector<Locus_piece<3>> pieces = to_locus(surface).locus_pieces();
    if (pieces.size() != 1)
      throw Invalid_input("intersection_curves: a surface has several pieces");
    return std::move(pieces.front());
  }

  static std::vector<std::pair<std::size_t, std::size_t>> opened(std::vector<Locus_piece<3>>& pieces);
};

// A rational or implicit surface; also an offset, if it is rational.
template <class Surface>
Shape rational_shape(const Surface& surface)
{
  if constexpr (std::same_as<Surface, Offset_surface_3>) {
    const auto rational = rational_offset(surface);
    return rational ? surface_shape(*rational) : nullptr;
  } else if constexpr (Procedural_surface<Surface>)
    return nullptr;
  else
    return surface_shape(surface);
}

// The curves of two surfaces, if both are rational, or implicit without an end within the other one, so that parameters
// are all unknowns.
std::optional<Found_surface_curves> rational_curves(const Surface_shape& first, const Surface_shape& second,
                                                    Operation_budget& budget);

// Those of others.
Found_surface_curves procedural_curves(const std::shared_ptr<const Locus_pair>& pair, Operation_budget& budget);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Place_of_unknowns Locus_pair::place(const std::shared_ptr<const Locus_pair>& pair)
{
  const auto point = [pair](const std::vector<double>& unknowns) {
    Unknown_domains box;
    for (const double x : unknowns)
      box.emplace_back(x, x);
    std::array<double, 3> result;
    const Coordinate_ranges<3> ranges = pair->m_system.coordinates(box);
    std::transform(ranges.begin(), ranges.end(), result.begin(),
                   [](const std::pair<double, double>& range) { return 0.5 * (range.first + range.second); });
    return result;
  };
  const auto bounds = [pair](const Curve_vertex::Exact_box& box) {
    const Coordinate_ranges<3> ranges = pair->m_system.coordinates(Unknown_domains(box.begin(), box.end()));
    return std::vector<Undecided_part::Range>(ranges.begin(), ranges.end());
  };
  return {point, bounds, pair->numbers_of_parameters()};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Domain_joints Locus_pair::joints() const
{
  Domain_joints result;
  for (const auto& [surface, axis] : m_closed)
    result.closed_unknowns.push_back(m_system.first_unknown(surface) + axis);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<std::size_t, std::size_t>>
Locus_pair::opened(std::vector<Locus_piece<3>>& pieces)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t axis = 0; axis < pieces[i].is_without_end.size(); ++axis)
      if (pieces[i].is_without_end[axis]) {
        result.emplace_back(i, axis);
        pieces[i].is_without_end[axis] = false;
      }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Found_surface_curves>
rational_curves(const Surface_shape& first, const Surface_shape& second, Operation_budget& budget)
{
  const Surface_equations surfaces(first, second, Unknowns_of_surfaces::ALL_PARAMETERS);
  if (surfaces.has_coordinates())
    return std::nullopt;
  Solved_part part = curves_in_all_parameters(surfaces, budget);
  const auto place = std::make_shared<const Surface_equations>(part.surfaces);
  Surface_curve_collector result(
      {[place](const std::vector<double>& unknowns) { return place->point(unknowns); },
       [place](const Curve_vertex::Exact_box& box) { return double_ranges(place->values(box)); },
       {surfaces.is_parametric(0) ? 2u : 0u, surfaces.is_parametric(1) ? 2u : 0u}});
  if (part.surfaces.has_system())
    result.add(part.surfaces.system(), std::move(part.solutions), {part.surfaces.closed_unknowns(), part.poles});
  return result.found();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_surface_curves procedural_curves(const std::shared_ptr<const Locus_pair>& pair,
                                                                      Operation_budget& budget)
{
  Surface_curve_collector result(Locus_pair::place(pair));
  if (pair->system().is_void())
    return result.found();
  Constraint_system_d system = make_system(pair->system().constraints());
  if (std::any_of(system.equalities().begin(), system.equalities().end(),
                  [](const Spline_function& f) { return f.terms().empty(); })) {
    result.add_undecided(internal::domain_of(system));
    return result.found();
  }
  Curve_solution_set_d solutions = curves_within_budget(system, budget);
  result.add(std::move(system), std::move(solutions), pair->joints());
  return result.found();
}
#endif

} // namespace Surface_curves
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

all curves that two surfaces have in common, of which one at least is procedural, such as `Offset_surface_3`: no closed
curve is lost, however small, and nothing is joined by distance.

The constraints are those of `intersections()` with such operands, one less than there are unknowns: an offset and an
implicit surface have three, its parameters and the length of the normal; an offset and another parametric or procedural
surface the four parameters, and one auxiliary one if both are procedural. The unknowns of the result are the parameters
of the first surface, those of the second one, then auxiliary ones. Curves are joined across the seams of closed
surfaces.

An offset that has a `rational_offset()` is taken as this rational surface, with the same parameters and no auxiliary
unknown, if the other surface is such an offset too, parametric, or implicit with a box that the offset does not leave.
Then all is decided as by the function for such surfaces, and contact curves are found where that finds them:
`Surface_curve::multiplicity` is at least two.

Otherwise, what touches is a singular point if it is proved to be one, with at most four unknowns; curves of contact are
undecided, and curves along an edge or a seam are not supported. Where surfaces coincide the answer is undecided.

\tparam A,B a model of `Locus` with two parameters, as `Offset_surface_3`; the other one too, or a model of
`ParametricSurface_3`, or `Implicit_surface_3`. The result has the kernel of the parametric surface, else
`CGAL::Simple_cartesian<double>`.
\param a the first surface.
\param b the second surface.
\param options those of `solve_curves()`.
\throws Invalid_input when a surface has several pieces, a coordinate is not finite, a weight is not proved to have one
sign, or an option makes no sense.

Complexity: that of `solve_curves()`. Source: the classification of intersections by rational, procedural and implicit
representations, \cgalCite{p-cgl-03}.
*/
template <class A, class B>
requires(internal::Surface_curves::Surface_locus<A>&& internal::Surface_curves::Surface_locus<B> &&
         (internal::Surface_curves::Procedural_surface<A> || internal::Surface_curves::Procedural_surface<B>))
    Surface_curves_3<internal::Surface_curves::Kernel_of_loci<A, B>> intersection_curves(
        const A& a, const B& b, const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_curves;
  using Result = Surface_curves_3<Kernel_of_loci<A, B>>;
  internal::Common::Operation_budget budget(options);
  const internal::Intersections::Shape first = rational_shape(a), second = first ? rational_shape(b) : nullptr;
  if (second)
    if (std::optional<Found_surface_curves> found = rational_curves(*first, *second, budget))
      return Result(std::move(*found));
  return Result(procedural_curves(std::make_shared<const Locus_pair>(a, b), budget));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_LOCUS_INTERSECTION_CURVES_H
