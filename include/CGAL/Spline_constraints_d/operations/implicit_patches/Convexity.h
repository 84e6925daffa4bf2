// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_CONVEXITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_CONVEXITY_H

#include <CGAL/Uncertain.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDImplicitPatches
//! What is proved of the shape of a patch, or of a function.
enum class Convexity_kind
{
  STRICTLY_CONVEX,  ///< all second derivatives, of patches those along tangents, are positive
  CONVEX,           ///< none is negative
  STRICTLY_CONCAVE, ///< all are negative
  CONCAVE,          ///< none is positive
  BOTH,             ///< all are zero: a plane, an affine function
  NEITHER,          ///< there are positive and negative ones
  EMPTY,            ///< the patch has no point
  NOT_REGULAR,      ///< the gradient is zero at a point of the patch
  UNDECIDED         ///< limits ended before that was known
};

//! \ingroup PkgSplineConstraintsDImplicitPatches
//! writes the name in words.
inline std::ostream& operator<<(std::ostream& out, Convexity_kind kind)
{
  static const char* const names[] = {"strictly convex", "convex", "strictly concave", "concave",  "convex and concave",
                                      "neither",         "empty",  "not regular",      "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

Three answers, each yes by proof, no by proof, or indeterminate where limits ended.
*/
struct Convexity
{
  CGAL::Uncertain<bool> is_convex = CGAL::Uncertain<bool>::indeterminate();  ///< no second derivative is negative
  CGAL::Uncertain<bool> is_concave = CGAL::Uncertain<bool>::indeterminate(); ///< none is positive
  CGAL::Uncertain<bool> is_strict = CGAL::Uncertain<bool>::indeterminate();  ///< the form is nowhere degenerate

  //! these in one word; `CONVEX` or `CONCAVE` also if it is not known whether they are so strictly, or both.
  Convexity_kind kind() const
  {
    const bool is_definite = CGAL::certainly(is_strict);
    if (CGAL::certainly(is_convex) && CGAL::certainly(is_concave))
      return Convexity_kind::BOTH;
    if (CGAL::certainly(is_convex))
      return is_definite ? Convexity_kind::STRICTLY_CONVEX : Convexity_kind::CONVEX;
    if (CGAL::certainly(is_concave))
      return is_definite ? Convexity_kind::STRICTLY_CONCAVE : Convexity_kind::CONCAVE;
    return CGAL::certainly(!is_convex) && CGAL::certainly(!is_concave) ? Convexity_kind::NEITHER
                                                                       : Convexity_kind::UNDECIDED;
  }

  //! whether the kind is known; all that is left open are zeros of forms then.
  bool is_decided() const { return CGAL::is_certain(is_convex) && CGAL::is_certain(is_concave); }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_CONVEXITY_H
