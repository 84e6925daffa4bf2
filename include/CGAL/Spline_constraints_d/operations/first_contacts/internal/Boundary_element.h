// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_BOUNDARY_ELEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_BOUNDARY_ELEMENT_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_cone.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// The homogeneous coordinates of a piece; where it is polynomial, the weight is one.
inline Spline_map<1, 3> map_of_piece(const Boundary_piece& piece)
{
  const Exact_rational factor(piece.is_polynomial() ? Exact_rational(1 / piece.coordinates[2].coefficients().front())
                                                    : Exact_rational(1));
  const auto function = [&](std::size_t k) {
    return Bspline_function<Exact_rational>::from_tensor(piece.coordinates[k] * factor,
                                                         {{Exact_rational(0), Exact_rational(1)}});
  };
  return Spline_map<1, 3>({function(0), function(1), function(2)});
}

// A piece of a boundary with its first point, which together are all of it.
struct Boundary_element
{
  const Boundary_piece* piece;
  std::size_t previous; // the element that ends in the first point
  std::size_t next;
  Exact_pair vertex; // the first point
  bool has_corner;   // in the first point
  bool is_straight;
  Spline_map<1, 3> map;
  std::array<Interval, 2> box;
  std::vector<std::array<Interval, 2>> boxes_of_parts;
  Contact_cone cone_in_vertex, cone_on_piece; // of all points of the piece
};

// Whether all control points are on the line through both ends.
inline bool is_straight(const Boundary_piece& piece)
{
  const auto& [x, y, w] = piece.coordinates;
  const Exact_pair a = piece.at(Exact_rational(0)), b = piece.at(Exact_rational(1)),
                   normal{Exact_rational(a[1] - b[1]), Exact_rational(b[0] - a[0])};
  const Exact_tensor distance = x * normal[0] + y * normal[1] - w * exact_dot(normal, a);
  return a != b && std::ranges::all_of(distance.coefficients(), [](const Exact_rational& c) { return c == 0; });
}

inline std::array<Interval, 2> interval_box_of(const Boundary_piece& piece)
{
  const auto box = piece.box();
  return {Interval(box[0].first, box[0].second), Interval(box[1].first, box[1].second)};
}

// Of the parts that so many halvings give.
inline void append_boxes_of_parts(const Boundary_piece& piece, int halvings,
                                  std::vector<std::array<Interval, 2>>& boxes)
{
  if (halvings == 0) {
    boxes.push_back(interval_box_of(piece));
    return;
  }
  const auto& [begin, end] = piece.parameters;
  const Exact_rational middle((begin + end) / 2);
  append_boxes_of_parts(piece.between(begin, middle), halvings - 1, boxes);
  append_boxes_of_parts(piece.between(middle, end), halvings - 1, boxes);
}

// Of boundaries; not all, if the run has ended.
inline std::vector<Boundary_element> elements_of(const std::vector<Boundary_loop_2>& loops,
                                                 const Budgeted_solver& solve)
{
  std::vector<Boundary_element> result;
  for (const Boundary_loop_2& loop : loops) {
    const std::size_t first = result.size(), n = loop.pieces().size();
    for (std::size_t i = 0; i < n && !solve.has_ended(); ++i) {
      const Boundary_piece &piece = loop.pieces()[i], &before = loop.pieces()[(i + n - 1) % n];
      std::vector<std::array<Interval, 2>> boxes;
      append_boxes_of_parts(piece, 3, boxes);
      const Exact_pair on = tangent_at_end(piece, false), from = tangent_at_end(before, true);
      const bool has_corner = !are_codirectional(from, on);
      result.push_back({&piece,
                        first + (i + n - 1) % n,
                        first + (i + 1) % n,
                        piece.at(Exact_rational(0)),
                        has_corner,
                        is_straight(piece),
                        map_of_piece(piece),
                        interval_box_of(piece),
                        std::move(boxes),
                        {bounds_of(on), opposite(bounds_of(from)), !has_corner},
                        cone_on_piece(piece, {Exact_rational(0), Exact_rational(1)})});
    }
  }
  return result;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_BOUNDARY_ELEMENT_H
