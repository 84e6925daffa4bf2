// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_SHAPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_SHAPE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Convexity.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Point_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Uncertain.h>
#include <CGAL/Vector_3.h>

#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

A proof that a patch is not convex, or not concave, in rational numbers: a segment from a point where the function
\f$f\f$ is not positive to one where it is not negative, so that it has a point of the patch, and a vector \f$c\f$,
such that in all points of the segment the second derivative of \f$f\f$ along \f$\nabla f \times c\f$, which is a
tangent on the patch, has one sign: negative against convexity, positive against concavity. It has the length 0 where
the point is rational.
*/
struct Curvature_witness
{
  //! the kernel.
  using Kernel = internal::Exact_kernel;

  Kernel::Point_3 first;  ///< where \f$f \le 0\f$
  Kernel::Point_3 second; ///< where \f$f \ge 0\f$
  Kernel::Vector_3 axis;  ///< \f$c\f$
};

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

Which shape an implicit patch has, by proof, and where that is not known.
*/
class Patch_shape
{
public:
  //! the kernel.
  using Kernel = internal::Exact_kernel;

#ifndef DOXYGEN_RUNNING
  // What is found.
  struct Found
  {
    Convexity convexity;
    CGAL::Uncertain<bool> is_empty = CGAL::Uncertain<bool>::indeterminate();
    CGAL::Uncertain<bool> is_regular = CGAL::Uncertain<bool>::indeterminate();
    std::optional<Curvature_witness> against_convexity, against_concavity;
    std::optional<Kernel::Segment_3> against_strictness;
    std::optional<Kernel::Point_3> singular_point;
    std::vector<Kernel::Tetrahedron_3> tetrahedra;
    std::vector<Undecided_part> undecided;
    Summary summary;
  };
#endif

private:
  Found m_found;

public:
#ifndef DOXYGEN_RUNNING
  explicit Patch_shape(Found found) : m_found(std::move(found)) {}
#endif

  //! what is known, in one word.
  Convexity_kind kind() const
  {
    if (CGAL::certainly(m_found.is_empty))
      return Convexity_kind::EMPTY;
    if (m_found.singular_point)
      return Convexity_kind::NOT_REGULAR;
    return m_found.convexity.kind();
  }

  //! whether second derivatives along tangents are nowhere negative, nowhere positive, nowhere degenerate. An empty
  //! patch is all of this.
  const Convexity& convexity() const { return m_found.convexity; }

  //! whether there is no point in the tetrahedron.
  CGAL::Uncertain<bool> is_empty() const { return m_found.is_empty; }

  //! whether the gradient is nowhere zero on the patch; not looked for any more where the patch is proved to be neither
  //! convex nor concave.
  CGAL::Uncertain<bool> is_regular() const { return m_found.is_regular; }

  //! why the patch is not convex.
  const std::optional<Curvature_witness>& witness_against_convexity() const { return m_found.against_convexity; }

  //! why it is not concave.
  const std::optional<Curvature_witness>& witness_against_concavity() const { return m_found.against_concavity; }

  //! why it is not strictly so, unless another witness tells: a segment with a point of the patch, on which the
  //! Gaussian curvature of the level surfaces is zero.
  const std::optional<Kernel::Segment_3>& witness_against_strictness() const { return m_found.against_strictness; }

  //! a point of the patch with gradient 0.
  const std::optional<Kernel::Point_3>& singular_point() const { return m_found.singular_point; }

  //! whether nothing is undecided.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the parts of the tetrahedron where an answer is missing, with boxes around them and reasons.
  const std::vector<Undecided_part>& undecided() const { return m_found.undecided; }

  //! the same parts as tetrahedra, in the same order.
  const std::vector<Kernel::Tetrahedron_3>& undecided_tetrahedra() const { return m_found.tetrahedra; }

  //! the work; nodes are parts of the tetrahedron that were looked at.
  const Summary& summary() const { return m_found.summary; }
};

//! \ingroup PkgSplineConstraintsDImplicitPatches
//! writes the kind, and the summary.
inline std::ostream& operator<<(std::ostream& out, const Patch_shape& patch)
{
  return out << patch.kind() << "; " << patch.summary();
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_SHAPE_H
