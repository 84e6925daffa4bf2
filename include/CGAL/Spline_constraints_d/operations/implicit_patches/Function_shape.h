// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_FUNCTION_SHAPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_FUNCTION_SHAPE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Convexity.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Point_3.h>
#include <CGAL/Vector_3.h>

#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

A proof that a function is not convex, or not concave: a point and a direction along which its second derivative is
negative, or positive.
*/
struct Hessian_witness
{
  internal::Exact_kernel::Point_3 point;      ///< the point, in the tetrahedron
  internal::Exact_kernel::Vector_3 direction; ///< the direction
};

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

Whether a polynomial is convex, or concave, on a tetrahedron, by proof.
*/
class Function_shape
{
public:
#ifndef DOXYGEN_RUNNING
  // What is found.
  struct Found
  {
    Convexity convexity;
    std::optional<Hessian_witness> against_convexity, against_concavity;
    std::vector<Undecided_part> undecided;
    Summary summary;
  };
#endif

private:
  Found m_found;

public:
#ifndef DOXYGEN_RUNNING
  explicit Function_shape(Found found) : m_found(std::move(found)) {}
#endif

  //! what is known, in one word.
  Convexity_kind kind() const { return m_found.convexity.kind(); }

  //! whether second derivatives are nowhere negative, nowhere positive, and the matrix of them nowhere singular.
  const Convexity& convexity() const { return m_found.convexity; }

  //! why the function is not convex.
  const std::optional<Hessian_witness>& witness_against_convexity() const { return m_found.against_convexity; }

  //! why it is not concave.
  const std::optional<Hessian_witness>& witness_against_concavity() const { return m_found.against_concavity; }

  //! whether nothing is undecided.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the parts of the tetrahedron where an answer is missing.
  const std::vector<Undecided_part>& undecided() const { return m_found.undecided; }

  //! the work.
  const Summary& summary() const { return m_found.summary; }
};

//! \ingroup PkgSplineConstraintsDImplicitPatches
//! writes the kind, and the summary.
inline std::ostream& operator<<(std::ostream& out, const Function_shape& function)
{
  return out << function.kind() << "; " << function.summary();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_FUNCTION_SHAPE_H
