// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACE_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_divisions.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Found_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Joins the curves on a face, or a plane of breaks, with all other ones, which meet it in points. There the equality has
two factors that are zero, so that they are singular points; and they are solutions on the face: each of them is a
vertex there, or lies in a piece, between its ends, since this has no other solutions in its box.
*/
class Curves_on_face : Curve_divisions
{
  const Vanishing_face& m_face;
  const int m_exponent;
  std::size_t m_first_undecided;   // of the boxes on the face

public:
  // Adds `on_face` to `all`, the solutions without the face. The exponent is that of the factor of the face.
  Curves_on_face(const Vanishing_face& face, int exponent, Found_curves& all)
    : Curve_divisions(all, all.pieces.size(), {}), m_face(face), m_exponent(exponent),
      m_first_undecided(all.undecided.size())
  {}

  void add(Found_curves&& on_face)
  {
    const std::vector<bool> is_solution = m_all.solutions();
    on_face.vertices.move_to_plane(m_face.axis, m_face.value);
    for (Curve_piece& piece : on_face.pieces) {
      piece.box[m_face.axis] = {m_face.value, m_face.value};
      piece.multiplicity *= m_exponent;
    }
    for (Undecided_box& box : on_face.undecided)
      box.box[m_face.axis] = {m_face.value, m_face.value};
    m_vertices = m_all.merge(std::move(on_face));
    for (std::size_t i = 0; i < is_solution.size(); ++i)
      if (is_solution[i] && is_on_face(i) && !is_undecided(i) && !Curve_divisions::add(i))
        m_all.undecided.push_back({m_all.vertices[i].box, {i}, Undecided_reason::TOLERANCE});
  }

  // Says nothing of the face of a domain.
  void leave_undecided(Exact_ranges domain)
  {
    domain[m_face.axis] = {m_face.value, m_face.value};
    Undecided_box face{std::move(domain), {}, Undecided_reason::CONTINUUM};
    for (std::size_t i = 0; i < m_all.vertices.size(); ++i)
      if (is_on_face(i))
        face.vertices.push_back(i);
    std::erase_if(m_all.points, [&](std::size_t i) { return is_on_face(i); });
    m_all.undecided.push_back(std::move(face));
  }

private:
  bool is_on_face(std::size_t i) const
  {
    return m_all.vertices[i].is_fixed[m_face.axis] && m_all.vertices[i].box[m_face.axis].first == m_face.value;
  }

  // Nothing is known of the face there.
  bool is_undecided(std::size_t i) const
  {
    return std::any_of(m_all.undecided.begin() + static_cast<std::ptrdiff_t>(m_first_undecided), m_all.undecided.end(),
                       [&](const Undecided_box& box) { return touch(box.box, m_all.vertices[i].box); });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACE_H
