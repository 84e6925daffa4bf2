// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_CHART_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_CHART_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_composition.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

/*
A bilinear map from unknowns s, h in [0,1] to pairs of parameters, by the images of the corners. Where a side of the
square is mapped to one pair that satisfies an equation by nature, or to the diagonal u = v, what is left of the
equation after division by the distance from the side tells how the other solutions go on there: a blow-up.
*/
class Pair_chart
{
  std::array<Exact_pair, 4> m_corners;   // at (s,h) = (0,0), (1,0), (0,1), (1,1)
  std::vector<Unknown> m_unknowns = Spline_constraints::unknowns(2, {0, 1});

public:
  explicit Pair_chart(std::array<Exact_pair, 4> corners) : m_corners(std::move(corners)) {}

  const std::vector<Unknown>& unknowns() const { return m_unknowns; }

  Double_pair parameters(const std::vector<double>& unknowns) const
  {
    const auto corner = [&](std::size_t k, std::size_t i) { return to_nearest_double(m_corners[k][i]); };
    const auto parameter = [&](std::size_t i) {
      return std::lerp(std::lerp(corner(0, i), corner(1, i), unknowns[0]),
                       std::lerp(corner(2, i), corner(3, i), unknowns[0]), unknowns[1]);
    };
    return {parameter(0), parameter(1)};
  }

  // Where both parameters are in a box. The extreme values of a bilinear function are those in the corners.
  std::array<std::pair<Exact_rational, Exact_rational>, 2> image(const Curve_vertex::Exact_box& box) const
  {
    std::array<std::pair<Exact_rational, Exact_rational>, 2> result;
    for (const std::size_t i : {0, 1}) {
      std::vector<Exact_rational> values;
      for (const Exact_rational& s : {box[0].first, box[0].second})
        for (const Exact_rational& h : {box[1].first, box[1].second}) {
          const auto side = [&](std::size_t k) {
            return Exact_rational((1 - s) * m_corners[k][i] + s * m_corners[k + 1][i]);
          };
          values.push_back(Exact_rational((1 - h) * side(0) + h * side(2)));
        }
      const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
      result[i] = {*least, *greatest};
    }
    return result;
  }

  // The image of a box on one side of the square only, and of that side.
  std::optional<Joint_place> place(const Curve_vertex::Exact_box& box) const
  {
    std::optional<Joint_place> result;
    for (const std::size_t unknown : {0, 1})
      for (const std::size_t end : {0, 1})
        if (box[unknown].first == static_cast<int>(end) && box[unknown].second == box[unknown].first) {
          if (result)
            return std::nullopt;
          const std::size_t first = unknown == 0 ? end : 2 * end;
          result = {image(box), {m_corners[first], m_corners[unknown == 0 ? first + 2 : first + 1]}};
        }
    return result;
  }

  // The pair that a box is mapped to, if it is one.
  std::optional<Exact_pair> pair(const Curve_vertex::Exact_box& box) const
  {
    const auto [u, v] = image(box);
    return u.first == u.second && v.first == v.second ? std::optional(Exact_pair{u.first, v.first}) : std::nullopt;
  }

  // Whether all of a box is mapped to the diagonal.
  bool is_on_diagonal(const Curve_vertex::Exact_box& box) const
  {
    for (const Exact_rational& s : {box[0].first, box[0].second})
      for (const Exact_rational& h : {box[1].first, box[1].second})
        if (const auto [u, v] = image({{s, s}, {h, h}}); u != v)
          return false;
    return true;
  }

  // The numerator of a formula in both parameters as one in the unknowns, without all factors h and 1 - h.
  Expression operator()(const Expression& formula) const
  {
    const Power_polynomial s = Power_polynomial::variable(0), h = Power_polynomial::variable(1), one(Exact_rational(1));
    std::vector<Power_polynomial> parameters;
    for (const std::size_t i : {0, 1}) {
      const auto side = [&](std::size_t k) {
        return (one - s) * Power_polynomial(m_corners[k][i]) + s * Power_polynomial(m_corners[k + 1][i]);
      };
      parameters.push_back((one - h) * side(0) + h * side(2));
    }
    const Power_polynomial composition = composed(numerator_polynomial(formula), parameters);
    return Expression(without_factor(without_factor(composition, h), one - h), Monomial(), m_unknowns[0].symbols());
  }
};

// The pairs u <= v on one piece of a curve. The side h = 0 is the diagonal, the side h = 1 is the pair of the two ends.
inline Pair_chart chart_of_piece(const Differentiated_map& piece)
{
  const Exact_rational &a = piece.begin(), &b = piece.end();
  return Pair_chart({Exact_pair{a, a}, Exact_pair{b, b}, Exact_pair{a, b}, Exact_pair{a, b}});
}

// The pairs on two different pieces, in the order of the curve. Common ends of them are blown up.
inline std::vector<Pair_chart> charts_of_pieces(const Differentiated_map& first, const Differentiated_map& second,
                                                bool is_next, bool is_next_across_seam)
{
  std::vector<Pair_chart> result;
  // The corner and the one opposite to it.
  const auto add_triangles = [&](const Exact_pair& corner, const Exact_pair& other) {
    result.push_back(Pair_chart({corner, corner, Exact_pair{corner[0], other[1]}, other}));
    result.push_back(Pair_chart({corner, corner, Exact_pair{other[0], corner[1]}, other}));
  };
  const auto add_rectangle = [&](const Exact_rational& begin, const Exact_rational& end) {
    result.push_back(Pair_chart({Exact_pair{begin, second.begin()}, Exact_pair{end, second.begin()},
                                 Exact_pair{begin, second.end()}, Exact_pair{end, second.end()}}));
  };
  if (!is_next && !is_next_across_seam) {
    add_rectangle(first.begin(), first.end());
    return result;
  }
  // not the whole: symmetric curves have solutions along the diagonal of the rectangle
  const Exact_rational share = Exact_rational(5) / 7, length = first.end() - first.begin();
  const Exact_rational cut =
      is_next ? Exact_rational(first.end() - share * length) : Exact_rational(first.begin() + share * length);
  if (is_next_across_seam)
    add_triangles({first.begin(), second.end()}, {cut, second.begin()});
  else
    add_rectangle(first.begin(), cut);
  if (is_next)
    add_triangles({first.end(), second.begin()}, {cut, second.end()});
  else
    add_rectangle(cut, first.end());
  return result;
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_CHART_H
