// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_ALL_SOLUTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_ALL_SOLUTIONS_H

#include <CGAL/Spline_constraints_d/solver/internal/certification/common_components.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Subdivision_walk.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Univariate_solver.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/clusters.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/precision_ladder.h>

#include <algorithm>
#include <concepts>
#include <iterator>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The sign of one polynomial on boxes with dyadic corners.
class Sign_on_boxes
{
  Constraint_system_d m_system;
  System_layout m_layout;
  Exact_source m_source;
  Node_view m_view;
  std::vector<double> m_coefficients, m_errors;
  std::vector<long> m_scale;

public:
  Sign_on_boxes(const Power_polynomial& polynomial, const Exact_box& domain)
    : m_system(system_of(polynomial, domain)), m_layout(m_system), m_source(m_system, m_layout), m_view(m_layout),
      m_coefficients(m_layout.size), m_errors(m_layout.errors)
  {}

  template <class Coordinate>
  bool is_certain(const std::vector<std::pair<Coordinate, Coordinate>>& box)
  {
    std::vector<Exact_rational> lower, upper;
    for (const auto& [begin, end] : box) {
      // of some width
      const auto range = dyadic_hull<Exact_rational>(Exact_rational(begin), Exact_rational(end), 1000);
      lower.push_back(range.first);
      upper.push_back(range.second);
    }
    m_source.bernstein_coefficients(Cell(box.size(), 0), std::span<const Exact_rational>(lower),
                                    std::span<const Exact_rational>(upper), m_coefficients.data(), m_errors.data(),
                                    m_scale);
    m_view.reset(m_coefficients.data(), m_errors.data());
    return is_certainly_violated(Relation::EQUAL, m_view.lower(0), m_view.upper(0));
  }

private:
  static Constraint_system_d system_of(const Power_polynomial& polynomial, const Exact_box& domain)
  {
    Constraint_system_d result(domain);
    result.add(polynomial, Relation::EQUAL);
    return result;
  }
};

template <class Traits>
struct Definitions_of_solvers
{};

template <class Traits, class Concurrency_tag>
class All_solutions;

// The answer of a run that was stopped before its system was set up.
template <class Traits>
std::vector<Solution_d<Coordinate_of<Traits>>> undecided_domain(const Constraint_system_d& system,
                                                                const Solver_options& options, Undecided_reason reason)
{
  typename Solution_d<Coordinate_of<Traits>>::Box box;
  for (int j = 0; j < system.dimension(); ++j) {
    const auto& [lower, upper] = system.domain(j);
    box.push_back(dyadic_hull<Coordinate_of<Traits>>(lower, upper, options.precision));
  }
  const char* const name = Number_traits<typename Traits::Number_type>::name;
  return {{Solution_kind::UNDECIDED, box, {}, name, reason}};
}

// All solutions of a system, in no order. With one unknown the default traits have a path of their own.
template <class Traits, class Concurrency_tag>
std::vector<Solution_d<Coordinate_of<Traits>>> all_solutions(const Constraint_system_d& system,
                                                             const Solver_options& options, Run_control& control,
                                                             Summary& summary)
{
  if constexpr (std::same_as<Traits, Certified_solver_traits>)
    if (system.dimension() == 1)
      return Univariate_solver(system, options, control, summary).solve();
  try {
    return All_solutions<Traits, Concurrency_tag>(system, options, control, summary).take();
  } catch (const Run_stopped& stopped) {
    return undecided_domain<Traits>(system, options, stopped.reason);
  }
}

/*
The parts of an answer: regular roots; what doubles leave open, through the precision ladder; and, for cells where the
equalities f = h g have a common factor h, the zeros of h and the solutions of g = 0 off them.
*/
template <class Traits, class Concurrency_tag>
class All_solutions
{
  using NT = typename Traits::Number_type;
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Solution = Solution_d<Coordinate>;

  const Constraint_system_d& m_system;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;
  double m_start = m_control.seconds();   // of this run: one for each factor of the equalities shares the control
  System_layout m_layout;
  Subdivision_walk<Traits, Concurrency_tag> m_walk;
  std::vector<Solution> m_solutions;

public:
  All_solutions(const Constraint_system_d& system, const Solver_options& options, Run_control& control,
                Summary& summary)
    : m_system(system), m_options(options), m_control(control), m_summary(summary), m_layout(system),
      m_walk(system, m_layout, options, control)
  {
    summary.setup_seconds = control.seconds() - m_start;
    m_walk.run();
    m_walk.look_again([&](const auto& box) { return !is_small(box) || !rational_solution_in(system, box).empty(); });
    m_walk.add_to(summary);
    report_multiple_roots();
    report_curves();
    report_continua();
    report_open_boxes();
    report_roots();
    isolate_clusters();
  }

  std::vector<Solution> take() { return std::move(m_solutions); }

private:
  void report_multiple_roots()
  {
    std::set<std::vector<Exact_rational>> points;
    for (const Multiple_root& root : m_walk.multiple_roots())
      if (points.insert(root.point).second && is_in_domain(root.point) && satisfies(m_system, root.point)) {
        typename Solution::Box box;
        for (const Exact_rational& x : root.point)
          if constexpr (std::same_as<Coordinate, double>)
            box.push_back(to_double_interval(x));
          else
            box.emplace_back(x, x);
        m_solutions.emplace_back(Solution_kind::CLUSTER, std::move(box), typename Solution::Box(),
                                 Number_traits<NT>::name, Undecided_reason::NONE, root.multiplicity);
      }
  }

  bool is_in_domain(const Exact_point& point) const
  {
    for (int j = 0; j < m_system.dimension(); ++j)
      if (point[j] < m_system.domain(j).first || m_system.domain(j).second < point[j])
        return false;
    return true;
  }

  // What looks like curves of solutions, with the tiny open boxes that touch it.
  void report_curves()
  {
    if (m_walk.curve_boxes().empty())
      return;
    std::vector<Continuum> curves;
    std::vector<Exact_box> open;
    for (const auto& box : m_walk.curve_boxes())
      curves.push_back({1, {exact_box(box)}, {}});
    const auto is_tiny = [](const auto& box) { return box.reason == Undecided_reason::TOLERANCE && is_small(box); };
    for (const auto& box : m_walk.open_boxes())
      if (is_tiny(box))
        open.push_back(exact_box(box));
    join(curves, open);
    std::erase_if(m_walk.open_boxes(), [&](const auto& box) {
      return is_tiny(box) && std::find(open.begin(), open.end(), exact_box(box)) == open.end();
    });
    for (Continuum& curve : curves)
      m_solutions.emplace_back(Solution_kind::UNDECIDED, 1, std::move(curve.cover), std::move(curve.ends));
  }

  // All solutions lie in the boxes of the answers: around a cluster there are none up to the next box.
  void isolate_clusters()
  {
    for (Solution& cluster : m_solutions) {
      if (cluster.kind() != Solution_kind::CLUSTER)
        continue;
      const Exact_box box = cluster.exact_box();
      const auto surround = [&](double share) {
        Exact_box region;
        for (std::size_t j = 0; j < box.size(); ++j) {
          const auto& [lower, upper] = m_system.domain(static_cast<int>(j));
          const Exact_rational margin = Exact_rational(share) * (upper - lower);
          region.emplace_back(
              (std::min)(box[j].first, Exact_rational((std::max)(lower, Exact_rational(box[j].first - margin)))),
              (std::max)(box[j].second, Exact_rational((std::min)(upper, Exact_rational(box[j].second + margin)))));
        }
        return region;
      };
      const auto is_free = [&](const Exact_box& region) {
        return std::none_of(m_solutions.begin(), m_solutions.end(), [&](const Solution& other) {
          return &other != &cluster &&
              (other.cover().empty() ? boxes_touch(region, other.exact_box())
                                     : std::any_of(other.cover().begin(), other.cover().end(),
                                                   [&](const Exact_box& part) { return boxes_touch(region, part); }));
        });
      };
      double share = 1;
      while (share > 0x1p-200 && !is_free(surround(share)))
        share /= 2;
      cluster.set_uniqueness_region(share > 0x1p-200 ? surround(share) : box);
    }
  }

  static Exact_box exact_box(const Open_box<Coordinate>& box)
  {
    Exact_box result;
    for (std::size_t j = 0; j < box.lower.size(); ++j)
      result.emplace_back(Exact_rational(box.lower[j]), Exact_rational(box.upper[j]));
    return result;
  }

  // Last: the others ask which roots are known.
  void report_roots()
  {
    m_solutions.reserve(m_solutions.size() + m_walk.roots().roots().size());
    for (auto& root : m_walk.roots().roots())
      report_root<NT>(std::move(root), m_solutions);
  }

  void report_open_boxes()
  {
    std::erase_if(m_walk.open_boxes(), [&](const auto& box) { // whose only root is known
      return m_walk.roots().is_covered(make_box(box.lower, box.upper)) ||
          std::any_of(m_walk.multiple_roots().begin(), m_walk.multiple_roots().end(),
                      [&](const Multiple_root& root) { return root.covers(box.lower, box.upper); });
    });
    if constexpr (std::same_as<NT, double> && Traits::tracks_rounding) {
      Precision_ladder ladder(m_system, m_layout, m_walk.source(), m_walk.roots(), m_options, m_control, m_summary);
      for (auto& box : m_walk.open_boxes()) {
        if (box.reason == Undecided_reason::TOLERANCE && m_control.must_stop(true))
          box.reason = m_control.reason();   // that it does not climb
        ladder.report(box, classified<NT>(m_system, box), m_solutions);
      }
    } else
      for (const auto& box : m_walk.open_boxes())
        m_solutions.push_back(classified<NT>(m_system, box));
  }

  void report_continua()
  {
    std::vector<Continuum> continua;
    std::vector<Exact_box> open;
    for (const Common_cell& cell : m_walk.common_cells()) {
      auto found = continua_in(cell, [&](const Constraint_system_d& part) { return solve_part(part); }, open);
      std::move(found.begin(), found.end(), std::back_inserter(continua));
      report_solutions_beside(cell);
    }
    join(continua, open);
    std::erase_if(open, [&](const Exact_box& box) { return is_point_of(continua, box); });
    std::erase_if(m_walk.open_boxes(), [&](const auto& box) {
      return box.reason == Undecided_reason::TOLERANCE && holds_only(continua, exact_box(box));
    });
    for (Continuum& continuum : continua)
      m_solutions.emplace_back(Solution_kind::CONTINUUM, continuum.dimension, std::move(continuum.cover),
                               std::move(continuum.ends));
    std::vector<Open_box<Coordinate>> boxes;
    for (const Exact_box& box : open)
      boxes.push_back(open_box(box));
    merge_boxes_that_meet(boxes);
    for (const auto& box : boxes)
      m_solutions.push_back(classified<NT>(m_system, box, true));
  }

  // The box is one point, and this is the end of what is reported from another cell.
  static bool is_point_of(const std::vector<Continuum>& continua, const Exact_box& box)
  {
    Exact_point point;
    for (const auto& [lower, upper] : box) {
      if (lower != upper)
        return false;
      point.push_back(lower);
    }
    return std::any_of(continua.begin(), continua.end(),
                       [&](const Continuum& continuum) { return holds(continuum, point); });
  }

  // All solutions in a box are points of continua: in each cell that it meets, they belong to what is reported of a
  // common factor, or are one corner that lies on a continuum. Where two cells of a spline touch at a point of the
  // continuum that ends one box and begins another, there is no more.
  bool holds_only(const std::vector<Continuum>& continua, const Exact_box& box)
  {
    if (continua.empty())
      return false;
    std::vector<Exact_rational> lower, upper;
    for (std::size_t j = 0; j < box.size(); ++j) {
      lower.push_back((std::max)(box[j].first, m_system.domain(static_cast<int>(j)).first));
      upper.push_back((std::min)(box[j].second, m_system.domain(static_cast<int>(j)).second));
    }
    bool is_proved = true;
    m_walk.source().visit_cells(
        std::span<const Exact_rational>(lower), std::span<const Exact_rational>(upper), [&](const Cell& cell) {
          if (!is_proved || m_walk.is_common(cell))
            return;
          Exact_box part;
          for (int j = 0; j < m_system.dimension(); ++j) {
            const auto& breaks = m_walk.source().breaks(j);
            part.emplace_back(breaks.size() > 2 ? (std::max)(lower[j], breaks[cell[j]]) : lower[j],
                              breaks.size() > 2 ? (std::min)(upper[j], breaks[cell[j] + 1]) : upper[j]);
          }
          const auto corner = only_corner_zero(m_system, part);
          is_proved = corner &&
              (corner->empty() ||
               std::any_of(continua.begin(), continua.end(), [&](const Continuum& c) { return holds(c, *corner); }));
        });
    return is_proved;
  }

  // With the limits of this run.
  std::vector<Solution> solve_part(const Constraint_system_d& part)
  {
    Solver_options options = m_options;
    if (options.node_limit > 0)
      options.node_limit =
          (std::max)(options.node_limit - (std::min)(m_summary.nodes, options.node_limit), std::size_t(1));
    Summary summary;
    auto result = all_solutions<Traits, Concurrency_tag>(part, options, m_control, summary);
    m_summary += summary;
    return result;
  }

  // The solutions of f = h g with h not zero.
  void report_solutions_beside(const Common_cell& cell)
  {
    Constraint_system_d cofactors(cell.box);
    for (const Power_polynomial& g : cell.cofactors) {
      if (g.is_constant() && !g.is_zero())
        return;
      cofactors.add(g, Relation::EQUAL);
    }
    if (cell.factor.is_zero())
      return;
    for (const auto& [function, relation] : cell.inequalities)
      cofactors.add(function, relation);
    Sign_on_boxes factor(cell.factor, cell.box);
    for (Solution& solution : solve_part(cofactors))
      if (!is_known(solution))
        report_beside(cofactors, cell, factor, solution);
  }

  void report_beside(const Constraint_system_d& cofactors, const Common_cell& cell, Sign_on_boxes& factor,
                     Solution& solution)
  {
    if (solution.kind() == Solution_kind::UNDECIDED) {
      m_solutions.push_back(std::move(solution));
      return;
    }
    const auto box = solution.exact_box();
    const Open_box<Coordinate> open = open_box(box);
    if (!factor.is_certain(box) || touches_break(cell, box)) {
      const auto point = rational_solution_in(cofactors, open);
      const bool is_in_continuum = solution.is_certified() && !point.empty() && CGAL::is_zero(cell.factor(point));
      if (!is_in_continuum)
        m_solutions.push_back(classified<NT>(m_system, open, !factor.is_certain(box)));
      return;
    }
    if (solution.is_certified()) {
      auto region = solution.exact_uniqueness_region();   // of g; shrunk until h has no zero there
      for (int round = 0; round < 60 && !factor.is_certain(region); ++round)
        for (std::size_t j = 0; j < region.size(); ++j) {
          region[j].first = (region[j].first + box[j].first) / Exact_rational(2);
          region[j].second = (region[j].second + box[j].second) / Exact_rational(2);
        }
      solution.set_uniqueness_region(factor.is_certain(region) ? region : box);
    }
    m_solutions.push_back(std::move(solution));
  }

  // A root that was certified before the cell was left.
  bool is_known(const Solution& solution)
  {
    if (solution.kind() == Solution_kind::CLUSTER) {
      const Open_box<Coordinate> box = open_box(solution.exact_box());
      return std::any_of(m_walk.multiple_roots().begin(), m_walk.multiple_roots().end(),
                         [&](const Multiple_root& known) { return known.covers(box.lower, box.upper); });
    }
    if (!solution.is_certified())
      return false;
    return m_walk.roots().is_known(solution.box(), solution.uniqueness_region());
  }

  // Beyond an inner face of the cell the equalities are others.
  static bool touches_break(const Common_cell& cell, const Exact_box& box)
  {
    for (std::size_t j = 0; j < box.size(); ++j)
      if ((cell.is_break[2 * j] && box[j].first <= cell.box[j].first) ||
          (cell.is_break[2 * j + 1] && cell.box[j].second <= box[j].second))
        return true;
    return false;
  }

  Open_box<Coordinate> open_box(const Exact_box& box)
  {
    Open_box<Coordinate> result{{}, {}, Undecided_reason::TOLERANCE, {}};
    for (const auto& [lower, upper] : box) {
      const auto range = dyadic_hull<Coordinate>(lower, upper, m_options.precision);
      result.lower.push_back(range.first);
      result.upper.push_back(range.second);
    }
    result.cell = m_walk.source().cell_of(std::span<const Coordinate>(result.lower));
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_ALL_SOLUTIONS_H
