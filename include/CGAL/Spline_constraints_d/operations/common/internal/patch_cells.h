// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_CELLS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// One of the polynomial pieces of a surface.
struct Patch_cell
{
  std::array<Bernstein_tensor<Exact_rational>, 4> functions;   // numerators and weight
  std::array<std::array<bool, 2>, 2> is_at_edge;               // per axis and end
};

template <class Visit>
void for_each_cell(const Spline_patch<3>& patch, const Visit& visit)
{
  const std::array<std::vector<Exact_rational>, 2> breaks{patch.breaks(0), patch.breaks(1)};
  const std::array<int, 2> last{static_cast<int>(breaks[0].size()) - 2, static_cast<int>(breaks[1].size()) - 2};
  for_each_index({last[0], last[1]}, [&](const std::vector<int>& place) {
    const auto range = [&](int axis) {
      return Parameter_range(breaks[axis][static_cast<std::size_t>(place[axis])],
                             breaks[axis][static_cast<std::size_t>(place[axis]) + 1]);
    };
    const Spline_patch<3> part = patch.part({range(0), range(1)});
    const auto piece = [](const Exact_function& f) { return f.bezier_pieces().front(); };
    visit(Patch_cell{
        {piece(part.numerators()[0]), piece(part.numerators()[1]), piece(part.numerators()[2]), piece(part.weight())},
        {{{place[0] == 0, place[0] == last[0]}, {place[1] == 0, place[1] == last[1]}}}});
  });
}

// w^d f(X/w) for numerators X, a weight w and a polynomial of the degree d at most.
inline Bernstein_tensor<Exact_rational> composed(const Power_polynomial& f, int degree,
                                                 const std::array<Bernstein_tensor<Exact_rational>, 4>& functions)
{
  using Tensor = Bernstein_tensor<Exact_rational>;
  std::array<std::vector<Tensor>, 4> powers;
  for (std::size_t i = 0; i < 4; ++i) {
    powers[i].push_back(Tensor::constant(2, Exact_rational(1)));
    for (int k = 0; k < degree; ++k)
      powers[i].push_back(powers[i].back() * functions[i]);
  }
  Tensor result = Tensor::constant(2, Exact_rational(0));
  for (const auto& [monomial, coefficient] : f.terms()) {
    Tensor term = powers[3][static_cast<std::size_t>(degree - monomial.total_degree())] * coefficient;
    for (int i = 0; i < 3; ++i)
      if (const int exponent = monomial.exponent(i); exponent > 0)
        term *= powers[static_cast<std::size_t>(i)][static_cast<std::size_t>(exponent)];
    result += term;
  }
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_PATCH_CELLS_H
