// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_OF_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_OF_PARTS_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Found_pair_locus.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Joint_place.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

inline double cross(const Double_pair& a, const Double_pair& b) { return a[0] * b[1] - a[1] * b[0]; }
inline double dot(const Double_pair& a, const Double_pair& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Planar_map planar_map(const Exact_map<2>& map)
{
  return map.is_rational ? Planar_map(map.numerators, map.weight) : Planar_map(map.numerators);
}

inline Double_pair rounded_pair(const Exact_pair& p) { return {to_nearest_double(p[0]), to_nearest_double(p[1])}; }

// Points of two curves with the derivatives there. Their difference is rounded once, since the points may be next to
// each other.
struct Pair_of_points
{
  std::array<Double_pair, 2> points, tangents;
  Double_pair chord;                 // from the second point to the first one
  Double_pair second_derivative{};   // of the first curve, where it is known
};

inline Pair_of_points pair_of_points(const Differentiated_map& first, const Differentiated_map& second,
                                     const Double_pair& parameters)
{
  const auto place = [](const Differentiated_map& curve, double t) {
    return (std::max)(curve.begin(), (std::min)(Exact_rational(t), curve.end()));
  };
  const Exact_rational u = place(first, parameters[0]), v = place(second, parameters[1]);
  const Exact_pair p = first.at(0, u), q = second.at(0, v);
  Pair_of_points result{{rounded_pair(p), rounded_pair(q)},
                        {rounded_pair(first.at(1, u)), rounded_pair(second.at(1, v))},
                        rounded_pair({Exact_rational(p[0] - q[0]), Exact_rational(p[1] - q[1])})};
  if (first.order() >= 2)
    result.second_derivative = rounded_pair(first.at(2, u));
  return result;
}

// Two parts of curves, and how the unknowns of an equation give a parameter on each of them.
struct Pair_of_parts
{
  Differentiated_map first, second;
  std::function<Double_pair(const std::vector<double>&)> parameters;
  std::vector<std::size_t> closed_unknowns;   // those at both ends of whose ranges the equation has the same solutions
  // where a curve goes on in another part, if it may, in a solution on the boundary
  std::function<std::optional<Joint_place>(const Curve_vertex::Exact_box&)> place = {};
  // that several parts may have
  std::function<std::optional<Joint_corner>(const Curve_vertex::Exact_box&)> corner = {};
  // whether both points of a pair are one: only a limit
  std::function<bool(const Curve_vertex::Exact_box&)> is_one_point = {};
  // where both parameters are with the unknowns in a box; none: they are the first two unknowns
  std::function<std::array<Exact_range, 2>(const Curve_vertex::Exact_box&)> ranges_of = {};

  std::array<Exact_range, 2> ranges(const Curve_vertex::Exact_box& box) const
  {
    return ranges_of ? ranges_of(box) : std::array<Exact_range, 2>{box[0], box[1]};
  }

  Pair_of_points points(const std::vector<double>& unknowns) const
  {
    return pair_of_points(first, second, parameters(unknowns));
  }
};

// A range of the length of the derivative. \throws Invalid_input when it may be zero; the message says where.
inline Exact_range speed_range(const Differentiated_map& curve, const std::string& who)
{
  const Vector_formula<2> tangent = [&](std::span<const Unknown> u) { return curve(1, u[0]); };
  return length_range<2>(tangent, {curve.map().domain(0)}, who + ": the derivative of the curve");
}

// Calls visit(parts, u, v) for each two parts of two curves, whose parameters are the unknowns u and v.
template <class Visit>
void visit_pairs_of_parts(const std::vector<Smooth_part>& first_parts, const std::vector<Smooth_part>& second_parts,
                          const Visit& visit)
{
  for (const Smooth_part& first : first_parts)
    for (const Smooth_part& second : second_parts) {
      Pair_of_parts parts{first.curve,
                          second.curve,
                          [](const std::vector<double>& unknowns) {
                            return Double_pair{unknowns[0], unknowns[1]};
                          },
                          {}};
      for (const std::size_t k : {0, 1})
        if (const Differentiated_map& curve = k == 0 ? first.curve : second.curve;
            curve.map().is_closed() && have_common_tangent(curve, curve))
          parts.closed_unknowns.push_back(k);
      const auto [u, v] = Spline_constraints::parameters(first.curve.map(), second.curve.map());
      visit(parts, u, v);
    }
}

// For each two smooth parts of two curves.
template <class Visit>
void visit_pairs_of_smooth_parts(const Planar_map& first, const Planar_map& second, const Visit& visit)
{
  visit_pairs_of_parts(smooth_parts(first), smooth_parts(second), visit);
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_PAIR_OF_PARTS_H
