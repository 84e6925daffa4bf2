// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_WALK_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_WALK_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Bernstein_interval.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_root.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// One answer for a system in one unknown: an interval that touches no other one, except where both have an open end.
struct Univariate_answer
{
  Solution_kind kind;
  Undecided_reason reason;
  int multiplicity;
  std::optional<Exact_root> exact;     // the interval
  double lower = 0, upper = 0;         // or this one, of a certified root,
  CGAL::Sign lower_sign = CGAL::ZERO;  // with the sign of the polynomial at its lower end
  bool is_solution = true;             // it satisfies the inequalities; if not, it is kept as a root of the equalities

  Exact_rational begin() const { return exact ? exact->lower() : Exact_rational(lower); }
  Exact_rational end() const { return exact ? exact->upper() : Exact_rational(upper); }
};

inline Univariate_answer interval_answer(Solution_kind kind, const Exact_rational& lower, const Exact_rational& upper,
                                         Undecided_reason reason = Undecided_reason::NONE)
{
  return {kind, reason, 0, Exact_root(nullptr, lower, upper, CGAL::ZERO)};
}

/*
Finds the roots of a polynomial in an open interval, at whose ends it does not vanish, by Descartes' rule on Bernstein
coefficients in double. Intervals are cut where the polynomial has a certain sign, so each root lies in the interior of
one of them. An interval that cannot be cut any more, as around a multiple root, goes to the square-free factors and
exact arithmetic.
*/
class Univariate_walk
{
  using Clock = std::chrono::steady_clock;

  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;
  std::shared_ptr<const Integer_polynomial> m_polynomial;
  Exact_rational m_lower, m_upper;                 // the interval
  double m_inner_lower = 0, m_inner_upper = 0;     // doubles in it, next to its ends
  double m_width = 0, m_share = 0;                 // its width, and its part of the domain
  // square-free, with their exponents; made when they are needed
  std::vector<std::pair<std::shared_ptr<const Integer_polynomial>, int>> m_factors;
  std::vector<Bernstein_interval> m_stack;         // the nodes beyond the size keep their memory
  std::size_t m_size = 0;
  std::vector<double> m_work;
  Integer_polynomial::Value m_value;
  std::vector<Univariate_answer> m_answers;

public:
  Univariate_walk(const Solver_options& options, Run_control& control, Summary& summary)
    : m_options(options), m_control(control), m_summary(summary)
  {}

  // The answers from left to right. `share` is what this interval is of the domain.
  std::vector<Univariate_answer> run(Integer_polynomial polynomial, const Exact_rational& lower,
                                     const Exact_rational& upper, double share)
  {
    m_answers.clear();
    if (polynomial.degree() < 1 || lower == upper)
      return {};
    start(std::move(polynomial), lower, upper, share);
    while (m_size > 0) {
      if (is_over()) {
        leave_open();
        break;
      }
      ++m_summary.nodes;
      Bernstein_interval& node = m_stack[m_size - 1];
      const int variations = node.most_variations();
      if (variations < 2) {
        if (variations == 1)
          report_simple_root(node);
        finish(node);
      } else if (node.cuts > 0 && is_blurred(node, variations))
        rebuild(node);
      else if (is_too_narrow(node) || !split()) {
        const Bernstein_interval& same = m_stack[m_size - 1];   // the stack may have moved
        solve_exactly(same);
        finish(same);
      }
    }
    return std::exchange(m_answers, {});
  }

  // All roots of a polynomial in the open interval, each with its multiplicity, in exact arithmetic; none if a limit is
  // reached.
  std::vector<std::pair<Exact_root, int>> exact_roots(Integer_polynomial polynomial, const Exact_rational& lower,
                                                      const Exact_rational& upper)
  {
    start(std::move(polynomial), lower, upper, 0);
    m_size = 0;
    std::vector<std::pair<Exact_root, int>> roots =
        exact_roots_between(Exact_rational(m_stack[0].lower), Exact_rational(m_stack[0].upper));
    std::erase_if(roots, [&](auto& root) { return !clip(root.first); });
    m_answers.clear();
    return roots;
  }

  // The root of an answer of the last run.
  Exact_root exact_root(const Univariate_answer& answer) const
  {
    return answer.exact
        ? *answer.exact
        : Exact_root(m_polynomial, Exact_rational(answer.lower), Exact_rational(answer.upper), answer.lower_sign);
  }

  // A limit was reached. Nodes of high degree take long beside a look at the clock.
  bool is_over()
  {
    const bool is_asked = m_summary.nodes % 32 == 0 || (m_polynomial != nullptr && m_polynomial->degree() > 64);
    return m_control.must_stop(is_asked) || (m_options.node_limit > 0 && m_summary.nodes >= m_options.node_limit);
  }

  Undecided_reason reason() const
  {
    return m_control.reason() == Undecided_reason::NONE ? Undecided_reason::NODES : m_control.reason();
  }

private:
  // The first node: the interval, with ends rounded outwards, and further if the polynomial vanishes there.
  void start(Integer_polynomial polynomial, const Exact_rational& lower, const Exact_rational& upper, double share)
  {
    m_polynomial = std::make_shared<const Integer_polynomial>(std::move(polynomial));
    m_factors.clear();
    m_lower = lower;
    m_upper = upper;
    m_share = share;
    if (m_stack.empty())
      m_stack.resize(8);
    Bernstein_interval& node = m_stack[0];
    std::tie(node.lower, m_inner_lower) = to_double_interval(lower);
    std::tie(m_inner_upper, node.upper) = to_double_interval(upper);
    const auto sign_beyond = [&](double& end, double direction) {
      for (;; end = std::nextafter(end, direction)) {
        if (!std::isfinite(end))
          throw Invalid_input("Subdivision_solver_d: the domain does not fit into the range of doubles");
        if (const CGAL::Sign sign = m_polynomial->sign_at(end); sign != CGAL::ZERO)
          return static_cast<int>(sign);
      }
    };
    node.lower_sign = sign_beyond(node.lower, -HUGE_VAL);
    node.upper_sign = sign_beyond(node.upper, HUGE_VAL);
    m_width = node.upper / 2 - node.lower / 2;
    m_size = 1;
    rebuild(node);
  }

  void rebuild(Bernstein_interval& node)
  {
    const Clock::time_point begin = Clock::now();
    node.rebuild(*m_polynomial);
    ++m_summary.restarts;
    m_summary.rebuild_seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }

  // Sharper values may say more.
  static bool is_blurred(const Bernstein_interval& node, int variations)
  {
    return node.apparent_variations() != variations || node.error > 0x1p-24 * node.largest();
  }

  bool is_too_narrow(const Bernstein_interval& node) const
  {
    const double most = (std::max)(std::abs(node.lower), std::abs(node.upper));
    return node.upper / 2 - node.lower / 2 <= (std::max)(0x1p-50 * most, 0x1p-60 * m_width);
  }

  // Cuts the node on top of the stack where the polynomial does not vanish: near the middle, and the first time beside
  // it, where roots like to be. The part below is on top then.
  bool split()
  {
    if (m_size == m_stack.size())
      m_stack.resize(2 * m_size);
    Bernstein_interval &node = m_stack[m_size - 1], &below = m_stack[m_size];
    constexpr int attempts = 16;
    const double first = m_size == 1 && node.cuts == 0 ? 125.0 / 256 : 0.5;
    for (int i = 0; i < attempts; ++i) {
      const double at = node.point_at(first + i / 256.0);
      if (!(node.lower < at && at < node.upper))
        return false;
      node.split(at, below);
      const double value = below.values.back();
      const int sign = value > node.error ? 1 : value < -node.error ? -1 : static_cast<int>(m_polynomial->sign_at(at));
      if (sign != 0) {
        below.upper_sign = node.lower_sign = sign;
        m_summary.depth = (std::max)(m_summary.depth, node.cuts);
        ++m_size;
        return true;
      }
      node.lower = below.lower;   // as if nothing had happened
      rebuild(node);
    }
    return false;
  }

  // The node on top of the stack is done.
  void finish(const Bernstein_interval& node)
  {
    m_control.add_progress(m_share * ((node.upper / 2 - node.lower / 2) / m_width));
    --m_size;
  }

  void leave_open()
  {
    for (; m_size > 0; --m_size) {
      const Bernstein_interval& node = m_stack[m_size - 1];
      add_open(Exact_rational(node.lower), Exact_rational(node.upper));
    }
  }

  void add_open(const Exact_rational& lower, const Exact_rational& upper)
  {
    const Exact_rational begin = (std::max)(lower, m_lower), end = (std::min)(upper, m_upper);
    if (begin < end)
      m_answers.push_back(interval_answer(Solution_kind::UNDECIDED, begin, end, reason()));
  }

  void report_simple_root(const Bernstein_interval& node)
  {
    const auto [lower, upper] = refined(node);
    Univariate_answer answer{Solution_kind::CERTIFIED,
                             Undecided_reason::NONE,
                             1,
                             std::nullopt,
                             lower,
                             upper,
                             static_cast<CGAL::Sign>(node.lower_sign)};
    if (m_inner_lower < lower && upper < m_inner_upper)
      m_answers.push_back(std::move(answer));
    else if (Exact_root root = exact_root(answer); clip(root)) {
      answer.exact = std::move(root);
      m_answers.push_back(std::move(answer));
    }
  }

  // Cuts off what is not in the interior of the interval; false if the root is not.
  bool clip(Exact_root& root) const
  {
    if (root.compare(m_lower) == CGAL::SMALLER || root.compare(m_upper) == CGAL::LARGER)
      return false;
    while (root.lower() <= m_lower || m_upper <= root.upper())
      root.halve();
    return true;
  }

  /*
  The only root of a node, between doubles a few units of the last place apart at which the polynomial has different
  signs, exactly; or the double that it is. Newton's method with exact residuals, and points on both sides of where it
  leads to; where that does not halve the interval, it is cut in the middle.
  */
  std::pair<double, double> refined(const Bernstein_interval& node)
  {
    double lower = node.lower, upper = node.upper, t = node.crossing_of_polygon(), slope = 0;
    for (int iteration = 0; iteration < 12; ++iteration) {
      const auto [value, slope_here] = node.value_and_slope(t, m_work);
      slope = slope_here;
      const double next = t - value / slope;
      const double step = (next > 0 && next < 1 ? next : next >= 1 ? (1 + t) / 2 : t / 2) - t;
      t += step;
      if (std::abs(step) < 0x1p-30)
        break;
    }
    slope /= upper / 2 - lower / 2;   // by x / 2
    const auto resolution = [](double x) { return std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x); };
    const auto is_inside = [&](double x) { return lower < x && x < upper; };
    std::optional<double> root;
    double step = 0;
    const auto look_at = [&](double x) {
      m_polynomial->at(x, m_value);
      if (m_value.value == 0)
        root = x;
      else
        (m_value.value.sign() == node.lower_sign ? lower : upper) = x;
      step = 2 * (to_scaled_double(m_value.value, m_value.exponent - node.scale) / slope);
    };
    double guess = node.point_at(t);
    if (is_inside(0))   // relative to another place every root can be narrow
      look_at(0);
    while (!root) {
      const double middle = lower + (upper / 2 - lower / 2), before = upper / 2 - lower / 2;
      if (!is_inside(middle) || upper - lower <= 4 * resolution(middle))
        return {lower, upper};
      look_at(is_inside(guess) ? guess : middle);
      guess -= step;
      const double room = (std::max)(1.25 * resolution(guess), 0x1p-10 * std::abs(step)), first = guess - room,
                   second = guess + room;
      for (const double x : {first, second})
        if (!root && is_inside(x))
          look_at(x);
      if (upper / 2 - lower / 2 > before / 2)
        guess = lower + (upper / 2 - lower / 2);
    }
    return {*root, *root};
  }

  void solve_exactly(const Bernstein_interval& node)
  {
    for (auto& [root, exponent] : exact_roots_between(Exact_rational(node.lower), Exact_rational(node.upper)))
      if (const Solution_kind kind = exponent == 1 ? Solution_kind::CERTIFIED : Solution_kind::CLUSTER; clip(root))
        m_answers.push_back({kind, Undecided_reason::NONE, exponent, std::move(root)});
  }

  // The roots between two dyadic points where the polynomial does not vanish, from left to right, with their
  // multiplicities.
  std::vector<std::pair<Exact_root, int>> exact_roots_between(const Exact_rational& lower, const Exact_rational& upper)
  {
    if (m_factors.empty())
      for (auto& [factor, exponent] : m_polynomial->square_free_factors())
        m_factors.emplace_back(std::make_shared<const Integer_polynomial>(std::move(factor)), exponent);
    std::vector<std::pair<Exact_root, int>> roots;
    const auto is_stopped = [&] {
      const bool result = is_over();
      ++m_summary.nodes;
      return result;
    };
    const std::size_t answers = m_answers.size();
    for (const auto& [factor, exponent] : m_factors)
      for (Exact_root& root :
           isolate_roots(factor, lower, upper, is_stopped, [&](const auto&a, const auto&b) { add_open(a, b); }))
        roots.emplace_back(std::move(root), exponent);
    if (m_answers.size() > answers) {   // stopped: what was found may lie in what was not looked at
      m_answers.erase(m_answers.begin() + static_cast<std::ptrdiff_t>(answers), m_answers.end());
      add_open(lower, upper);
      return {};
    }
    separate(roots);
    return roots;
  }

  // Narrows the intervals of different roots until they are short beside the gaps between them.
  void separate(std::vector<std::pair<Exact_root, int>>& roots) const
  {
    const auto by_place = [](const auto& a, const auto& b) { return a.first.lower() < b.first.lower(); };
    const Exact_rational share = power_of_two(-12), precision = power_of_two(-56);
    for (auto& [root, exponent] : roots) {
      root.compare(Exact_rational(0));   // relative to another place every root can be narrow
      while (root.width() > precision * (std::max)(CGAL::abs(root.lower()), CGAL::abs(root.upper())))
        root.halve();
    }
    for (bool is_done = false; !is_done;) {
      is_done = true;
      std::sort(roots.begin(), roots.end(), by_place);
      for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
        Exact_root &a = roots[i].first, &b = roots[i + 1].first;
        const Exact_rational gap = b.lower() - a.upper();
        if ((a.width() + b.width()) > share * gap) {
          a.halve();
          b.halve();
          is_done = false;
        }
      }
    }
    for (auto& [root, exponent] : roots)
      root.settle_on_simplest_rational();
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_WALK_H
