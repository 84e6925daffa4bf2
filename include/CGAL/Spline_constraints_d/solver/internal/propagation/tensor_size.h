// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_TENSOR_SIZE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_TENSOR_SIZE_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial that is compared with zero.
using Polynomial_constraint = std::pair<Power_polynomial, Relation>;

// How many coefficients the largest of some polynomials has as a sum of tensors over unknowns that its terms connect.
inline double tensor_size(const std::vector<Polynomial_constraint>& constraints)
{
  double result = 0;
  for (const auto& [polynomial, relation] : constraints) {
    const std::map<int, int> degrees = polynomial.degrees();
    std::map<int, int> linked; // to another one of the same tensor
    const auto representative = [&](int unknown) {
      while (linked.at(unknown) != unknown)
        unknown = linked[unknown] = linked.at(linked.at(unknown));
      return unknown;
    };
    for (const auto& [unknown, degree] : degrees)
      linked[unknown] = unknown;
    for (const auto& [monomial, coefficient] : polynomial.terms())
      for (std::size_t k = 1; k < monomial.powers.size(); ++k)
        linked[representative(monomial.powers[k].first)] = representative(monomial.powers[0].first);
    std::map<int, double> sizes;
    for (const auto& [unknown, degree] : degrees)
      sizes.try_emplace(representative(unknown), 1).first->second *= degree + 1;
    double size = 0;
    for (const auto& [unknown, own] : sizes)
      size += own;
    result = (std::max)(result, size);
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_TENSOR_SIZE_H
