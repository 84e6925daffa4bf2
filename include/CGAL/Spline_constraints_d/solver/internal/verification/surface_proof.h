// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_SURFACE_PROOF_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_SURFACE_PROOF_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/krawczyk_operator.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace verification {

/*
Proves the cells of a surface of solutions once more, in exact arithmetic, from their boxes alone: that solutions in the
box of a patch are a graph over its parameters, with the sign of the minor that it has; that those in the box of an arc,
on its plane, are a graph over its parameter; that the box of a vertex holds one solution on two planes that it lies on;
and that boundaries are loops on the faces of boxes.
*/
class Surface_proof
{
  const Surface_solution_set_d& m_set;
  const Constraint_system_d& m_system; // one of those of the set
  std::size_t m_index;                 // of the system
  Functions m_functions;
  std::vector<bool> m_has_arc; // those of patches of the system

public:
  Surface_proof(const Surface_solution_set_d& set, std::size_t system)
    : m_set(set), m_system(*set.systems()[system]), m_index(system), m_has_arc(set.arcs().size(), false)
  {
    for (const Spline_function& equality : m_system.equalities())
      m_functions.push_back(&equality);
    for (const Surface_patch& patch : set.patches())
      if (is_own(patch))
        for (const Surface_patch::Side& side : patch.boundary)
          m_has_arc[side.arc] = true;
  }

  bool succeeds() const
  {
    const auto all = [](const auto& cells, const auto& is_proved) {
      return std::all_of(cells.begin(), cells.end(), is_proved);
    };
    const Surface_arc* const first = m_set.arcs().data();
    return all(m_set.patches(), [&](const Surface_patch& patch) { return !is_own(patch) || is_patch(patch); }) &&
        all(m_set.arcs(), [&](const Surface_arc& arc) { return !m_has_arc[&arc - first] || is_arc(arc); }) &&
        are_vertices();
  }

private:
  bool is_own(const Surface_patch& patch) const { return m_set.surfaces()[patch.surface].system == m_index; }

  bool is_patch(const Surface_patch& patch) const
  {
    return !patch.apex && patch.orientation != 0 &&
        sign_of_graph(box_of(patch.box), middle_of_boundary(patch), patch.parameters) == patch.orientation &&
        has_loop(patch);
  }

  bool is_arc(const Surface_arc& arc) const
  {
    if (arc.parameter < 0 ||
        arc.box[static_cast<std::size_t>(arc.plane)].first != arc.box[static_cast<std::size_t>(arc.plane)].second)
      return false;
    const auto place = [&](std::size_t end) {
      return m_set.vertices()[arc.ends[end]].box[static_cast<std::size_t>(arc.parameter)];
    };
    return (place(0).second < place(1).first || place(1).second < place(0).first) &&
        sign_of_graph(box_of(arc.box), middle_of({arc.ends[0], arc.ends[1]}), std::array{arc.plane, arc.parameter}) !=
        0;
  }

  // Of the box around the boxes of some vertices.
  Point middle_of(const std::vector<std::size_t>& vertices) const
  {
    Box around = box_of(m_set.vertices()[vertices.front()].box);
    for (const std::size_t i : vertices)
      for (std::size_t j = 0; j < around.size(); ++j)
        extend(around[j], m_set.vertices()[i].box[j].first, m_set.vertices()[i].box[j].second);
    return verification::middle_of(around);
  }

  Point middle_of_boundary(const Surface_patch& patch) const
  {
    std::vector<std::size_t> vertices;
    for (const Surface_patch::Side& side : patch.boundary)
      for (const std::size_t end : m_set.arcs()[side.arc].ends)
        vertices.push_back(end);
    return middle_of(vertices);
  }

  // The boundary of a patch: arcs that follow each other, on faces of its box.
  bool has_loop(const Surface_patch& patch) const
  {
    const std::size_t count = patch.boundary.size();
    for (std::size_t k = 0; k < count; ++k) {
      const Surface_patch::Side &side = patch.boundary[k], &next = patch.boundary[(k + 1) % count];
      const Surface_arc &arc = m_set.arcs()[side.arc], &other = m_set.arcs()[next.arc];
      const auto plane = static_cast<std::size_t>(arc.plane);
      if (arc.ends[side.is_reversed ? 0 : 1] != other.ends[next.is_reversed ? 1 : 0] ||
          (arc.box[plane].first != patch.box[plane].first && arc.box[plane].first != patch.box[plane].second))
        return false;
    }
    return count > 1;
  }

  bool are_vertices() const
  {
    std::vector<bool> is_end(m_set.vertices().size(), false);
    for (std::size_t a = 0; a < m_has_arc.size(); ++a)
      if (m_has_arc[a])
        for (const std::size_t end : m_set.arcs()[a].ends)
          is_end[end] = true;
    for (std::size_t i = 0; i < is_end.size(); ++i)
      if (is_end[i] && !is_vertex(m_set.vertices()[i].box))
        return false;
    return true;
  }

  // On two of the planes that a vertex lies on, which may be more, by chance or as one says the same as another one.
  bool is_vertex(const Exact_ranges& box) const
  {
    std::vector<int> planes;
    for (int j = 0; j < static_cast<int>(box.size()); ++j)
      if (const auto& [lower, upper] = box[static_cast<std::size_t>(j)]; lower == upper)
        planes.push_back(j);
    for (std::size_t k = planes.size(); k-- > 0;)
      for (std::size_t i = k; i-- > 0;)
        if (is_vertex_on(planes[k], planes[i], box))
          return true;
    return false;
  }

  // There the system has as many equalities as unknowns. The second plane is of an earlier unknown, which keeps its
  // number.
  bool is_vertex_on(int first, int second, Exact_ranges box) const
  {
    Constraint_system_d system = equalities_of(m_system);
    for (const int j : {first, second}) {
      system = on_plane(system, domain_of(system), j, box[static_cast<std::size_t>(j)].first);
      // no plane of a cut, but that of a face which is an equality
      if (std::any_of(system.equalities().begin(), system.equalities().end(), is_zero_everywhere))
        return false;
      box.erase(box.begin() + j);
    }
    return is_proved(system, Solution_kind::CERTIFIED, box, {});
  }

  static Box box_of(const Exact_ranges& ranges)
  {
    Box result;
    for (const auto& [lower, upper] : ranges)
      result.push_back({lower, upper});
    return result;
  }

  // The sign of the determinant of the derivatives by all unknowns but two, which is the same in the parts of the box
  // that may hold solutions if |I - C J| < 1 there in weighted row sums; 0 where that is not proved. C is near a share
  // of the inverse at a point amid the solutions, or amid the box: derivatives may be greater elsewhere.
  int sign_of_graph(const Box& box, const Point& middle, const std::array<int, 2>& parameters) const
  {
    const Exact_rational share = Exact_rational(1) / 16;
    Axes axes;
    for (int j = 0; j < m_system.dimension(); ++j)
      if (std::find(parameters.begin(), parameters.end(), j) == parameters.end())
        axes.push_back(j);
    for (const Point& point : {middle, verification::middle_of(box)}) {
      const Matrix jacobian = Part(m_functions, point_box(point)).jacobian(m_functions.size(), axes);
      Matrix inverse = rounded_left_inverse(jacobian, digits_for(box));
      for (Exact_rational& entry : inverse.entries)
        entry *= share;
      std::size_t parts = 0;
      if (inverse.rows > 0 && is_near_identity(inverse, axes, box, parts))
        return sign_of_determinant(jacobian.entries, axes.size());
    }
    return 0;
  }

  bool is_near_identity(const Matrix& inverse, const Axes& axes, const Box& box, std::size_t& parts) const
  {
    constexpr std::size_t most_parts = 4096;
    if (++parts > most_parts)
      return false;
    for (const Spline_function* function : m_functions)
      if (const Range range = values(*function, box); range.lower > 0 || range.upper < 0)
        return true;
    const Part part(m_functions, box);
    if (has_no_zero(part, inverse) || is_contraction(part.distance_from_identity(inverse, axes), axes))
      return true;
    const Point radius = radius_of(box);
    const auto widest = std::max_element(radius.begin(), radius.end()) - radius.begin();
    Box lower = box, upper = box;
    lower[widest].upper = upper[widest].lower = verification::middle_of(box)[widest];
    return is_near_identity(inverse, axes, lower, parts) && is_near_identity(inverse, axes, upper, parts);
  }

  // Whether a row of C F is bounded away from zero.
  static bool has_no_zero(const Part& part, const Matrix& inverse)
  {
    for (std::size_t i = 0; i < inverse.rows; ++i) {
      Exact_rational middle(0), deviation(0);
      for (const auto& [exponents, coefficients] : part.coefficients) {
        Exact_rational combined(0);
        for (std::size_t k = 0; k < inverse.columns; ++k)
          combined += inverse(i, k) * coefficients[k];
        bool is_constant = true;
        for (std::size_t j = 0; j < exponents.size(); ++j)
          for (int power = exponents[j]; power > 0; --power) {
            combined *= part.radius[j];
            is_constant = false;
          }
        (is_constant ? middle : deviation) += absolute(combined);
      }
      if (middle > deviation)
        return true;
    }
    return false;
  }

  static Box point_box(const Point& point)
  {
    Box result;
    for (const Exact_rational& x : point)
      result.push_back({x, x});
    return result;
  }

  // Whether weighted row sums are below the weights, for some weights. Unknowns that stand for values of inequalities
  // depend on others, and no others on them: they have a great weight. If that is not enough, weights are tried that
  // the sums are to be less than by one.
  bool is_contraction(const Matrix& distances, const Axes& axes) const
  {
    const auto size = static_cast<Eigen::Index>(distances.rows);
    Eigen::VectorXd weights(size);
    Eigen::MatrixXd rest(size, size); // that is to map weights to ones
    for (std::size_t i = 0; i < distances.rows; ++i) {
      weights[static_cast<Eigen::Index>(i)] = axes[i] < static_cast<std::size_t>(m_set.dimension()) ? 1 : 1024;
      for (std::size_t j = 0; j < distances.columns; ++j)
        rest(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            (i == j ? 1 : 0) - CGAL::to_double(distances(i, j));
    }
    if (are_sums_below(distances, weights))
      return true;
    weights = rest.partialPivLu().solve(Eigen::VectorXd::Ones(size));
    return weights.allFinite() && weights.minCoeff() > 0 && are_sums_below(distances, weights);
  }

  static bool are_sums_below(const Matrix& distances, const Eigen::VectorXd& weights)
  {
    const auto weight = [&](std::size_t j) { return to_rational(weights[static_cast<Eigen::Index>(j)]); };
    for (std::size_t i = 0; i < distances.rows; ++i) {
      Exact_rational sum(0);
      for (std::size_t j = 0; j < distances.columns; ++j)
        sum += distances(i, j) * weight(j);
      if (!(sum < weight(i)))
        return false;
    }
    return true;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE bool are_surfaces_proved(const Surface_solution_set_d& set)
{
  for (std::size_t k = 0; k < set.systems().size(); ++k)
    if (!Surface_proof(set, k).succeeds())
      return false;
  return true;
}

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_SURFACE_PROOF_H
