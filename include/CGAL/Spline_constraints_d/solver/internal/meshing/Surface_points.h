// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_POINTS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Local_functions.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Finds points of a surface of solutions in doubles, by Newton's method with the polynomials near a patch.
class Surface_points
{
  const Surface_solution_set_d& m_set;
  std::vector<Local_function_source> m_sources; // per system
  std::vector<std::unique_ptr<Local_functions>> m_near_patch;
  std::map<int, std::set<double>> m_breaks; // of unknowns that have some
  Function_jets m_jets;
  std::vector<double> m_step;
  Eigen::MatrixXd m_square;
  Eigen::LDLT<Eigen::MatrixXd> m_decomposition;

public:
  using Point = std::vector<double>;
  using Double_ranges = std::vector<std::pair<double, double>>;

  explicit Surface_points(const Surface_solution_set_d& set)
    : m_set(set), m_near_patch(set.patches().size()), m_step(dimension())
  {
    for (const auto& system : set.systems()) {
      m_sources.emplace_back(system->equalities(), dimension());
      for (const auto& [unknown, breaks] : breaks_of(*system))
        m_breaks[unknown].insert(breaks.begin(), breaks.end());
    }
  }

  std::size_t dimension() const { return static_cast<std::size_t>(m_set.system().dimension()); }

  // The equalities near a patch.
  const Local_functions& functions(std::size_t patch)
  {
    std::unique_ptr<Local_functions>& own = m_near_patch[patch];
    if (own == nullptr)
      own = std::make_unique<Local_functions>(
          m_sources[m_set.surfaces()[m_set.patches()[patch].surface].system].near(m_set.patches()[patch].box));
    return *own;
  }

  // The one of two patches that a point is nearer to, so that its polynomials are more exact there. They have to be
  // those of the point, too: between the same breaks of splines.
  std::size_t nearer(std::size_t first, std::size_t second, const Point& point)
  {
    if (first == second || is_in_cell(first, point) != is_in_cell(second, point))
      return first == second || is_in_cell(first, point) ? first : second;
    return distance(first, point) <= distance(second, point) ? first : second;
  }

  // A patch between the same breaks as a point: the one that is given, if it is.
  std::size_t in_cell(std::size_t patch, const Point& point)
  {
    for (std::size_t p = 0; p < m_near_patch.size() && !is_in_cell(patch, point); ++p)
      if (is_in_cell(p, point))
        patch = p;
    return patch;
  }

  // Moves a point near a patch onto the surface, by steps of least length that leave these unknowns as they are; false
  // when Newton's method does not converge. It ends with the first step that is no longer than `enough`.
  bool move_to_surface(std::size_t patch, std::span<const int> fixed, Point& point, double enough = 0)
  {
    constexpr int most_steps = 20;
    const Local_functions& equalities = functions(patch);
    double size = 0;
    for (const double x : point)
      size = (std::max)(size, std::abs(x));
    double last = 0;
    for (int step = 0; step < most_steps; ++step) {
      equalities.evaluate(point, 1, m_jets);
      if (!set_least_step(fixed))
        return false;
      double length = 0;
      for (std::size_t j = 0; j < dimension(); ++j) {
        point[j] += m_step[j];
        length = (std::max)(length, std::abs(m_step[j]));
      }
      if (!std::isfinite(length))
        return false;
      if (length <= enough)
        return true;
      // steps become shorter at a growing rate, until they are rounding errors
      const double next = step == 0 ? length : length * (std::min)(1.0, length / last);
      if (next <= 0x1p-51 * (std::max)(size, 0x1p-20) || (step > 3 && length <= 0x1p-44 * size && length >= last / 4))
        return true;
      last = length;
    }
    return false;
  }

  // Of the equalities where the last step of the last move began.
  const std::vector<double>& last_gradients() const { return m_jets.gradients; }

  // The only solution in a box near a patch where two unknowns have the values that they have in `near`; none when
  // there is none in the box. `around`: the box in doubles.
  std::optional<Point> solution(std::size_t patch, const Exact_ranges& box, const Double_ranges& around,
                                const std::array<int, 2>& fixed, const Point& near)
  {
    Point result = near;
    if (move_to_surface(patch, fixed, result) && is_in(around, result))
      return result;
    return certified_solution(m_set.system_of_patch(patch), box, fixed, near);
  }

  static Double_ranges around(const Exact_ranges& box)
  {
    Double_ranges result;
    for (const auto& [lower, upper] : box)
      result.emplace_back(to_double_interval(lower).first, to_double_interval(upper).second);
    return result;
  }

  static bool is_in(const Double_ranges& box, const Point& point)
  {
    for (std::size_t j = 0; j < point.size(); ++j)
      if (point[j] < box[j].first || box[j].second < point[j])
        return false;
    return true;
  }

  // The places where splines of the equalities have breaks, of each unknown that has some.
  static std::map<int, std::set<double>> breaks_of(const Constraint_system_d& system)
  {
    std::map<int, std::set<double>> result;
    for (const Spline_function& function : system.equalities())
      for (const Spline_term& term : function.terms())
        for (std::size_t j = 0; j < term.variables.size(); ++j)
          for (const Exact_rational& at : term.breaks[j])
            result[term.variables[j]].insert(CGAL::to_double(at));
    return result;
  }

private:
  // Whether a point is between the same breaks of splines as a patch, up to rounding.
  bool is_in_cell(std::size_t patch, const Point& point)
  {
    for (const auto& [unknown, breaks] : m_breaks) {
      const double x = point[static_cast<std::size_t>(unknown)];
      const auto& [lower, upper] = m_set.patches()[patch].box[static_cast<std::size_t>(unknown)];
      const double middle = CGAL::to_double(Exact_rational((lower + upper) / 2));
      for (const double at : breaks)
        if (const double slack = 0x1p-40 * (1 + std::abs(at));
            (x < at - slack && at < middle) || (middle < at && at + slack < x))
          return false;
    }
    return true;
  }

  double distance(std::size_t patch, const Point& point)
  {
    const std::vector<double>& place = functions(patch).place();
    double result = 0;
    for (std::size_t j = 0; j < point.size(); ++j)
      result = (std::max)(result, std::abs(point[j] - place[j]));
    return result;
  }

  // The step of Newton's method of least length, with some unknowns held: d = -J^T (J J^T)^-1 f.
  bool set_least_step(std::span<const int> fixed)
  {
    const std::size_t n = dimension();
    for (std::size_t i = 0; i < m_jets.values.size(); ++i)
      for (const int j : fixed)
        m_jets.gradients[i * n + static_cast<std::size_t>(j)] = 0;
    return m_jets.values.size() == 1 ? set_least_step_of_one() : set_least_step_of_several();
  }

  bool set_least_step_of_one()
  {
    double square = 0;
    for (const double slope : m_jets.gradients)
      square += slope * slope;
    for (std::size_t j = 0; j < dimension(); ++j)
      m_step[j] = -m_jets.values[0] / square * m_jets.gradients[j];
    return square > 0;
  }

  bool set_least_step_of_several()
  {
    const auto n = static_cast<Eigen::Index>(dimension()), m = static_cast<Eigen::Index>(m_jets.values.size());
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<Rows> rows(m_jets.gradients.data(), m, n);
    Eigen::Map<Eigen::VectorXd> values(m_jets.values.data(), m), step(m_step.data(), n);
    for (Eigen::Index i = 0; i < m; ++i) {
      const double length = rows.row(i).norm();
      if (!(length > 0))
        return false;
      rows.row(i) /= length;
      values[i] /= length;
    }
    m_square.noalias() = rows * rows.transpose();
    m_decomposition.compute(m_square);
    step.noalias() = -(rows.transpose() * m_decomposition.solve(values));
    return step.allFinite();
  }

  std::optional<Point> certified_solution(const Constraint_system_d& system, const Exact_ranges& box,
                                          const std::array<int, 2>& fixed, const Point& near)
  {
    Exact_ranges slice = box;
    for (const int j : fixed) {
      const Exact_rational value(near[static_cast<std::size_t>(j)]);
      if (value < box[static_cast<std::size_t>(j)].first || box[static_cast<std::size_t>(j)].second < value)
        return std::nullopt;
    }
    const auto [low, high] = std::minmax(fixed[0], fixed[1]);
    const Exact_rational first(near[static_cast<std::size_t>(low)]), second(near[static_cast<std::size_t>(high)]);
    const Constraint_system_d plane = on_plane(system, slice, high, second);
    slice.erase(slice.begin() + high);
    const auto found = Subdivision_solver_d<Certified_solver_traits>()(on_plane(plane, slice, low, first));
    if (found.empty())
      return std::nullopt;
    Point result = found.begin()->point();
    result.insert(result.begin() + low, near[static_cast<std::size_t>(low)]);
    result.insert(result.begin() + high, near[static_cast<std::size_t>(high)]);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_POINTS_H
