// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECISE_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECISE_ZEROS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/Elementary_proof.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Regular zeros of equalities with elementary functions that doubles leave open: whether they are solutions is decided
by numbers of many bits, or by coordinates and values that are rational. Nothing where it is not, unknowns are too many,
or there is no time left.
*/
class Precise_zeros
{
  const std::vector<Constraint_system_d::Domain>& m_domain;
  const std::vector<Polynomial_constraint>& m_constraints;
  const Elementary_values& m_values;
  Run_control& m_control;
  int m_failures = 0;

  static constexpr int most_failures = 200; // where so many are open, the rest hardly is of another kind

public:
  struct Zero
  {
    bool is_solution;
    Proved_root root;
  };

  Precise_zeros(const std::vector<Constraint_system_d::Domain>& domain,
                const std::vector<Polynomial_constraint>& constraints, const Elementary_values& values,
                Run_control& control)
    : m_domain(domain), m_constraints(constraints), m_values(values), m_control(control)
  {}

  // Of a root whose enclosure holds no other; it may get a smaller one.
  std::optional<bool> is_solution(Proved_root& root);

  // The only zero of a region around a box.
  std::optional<Zero> around(const Box_of_ranges& box);

private:
  std::optional<verification::Elementary_proof::Zero> zero_near(const Box_of_ranges& box);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<verification::Elementary_proof::Zero>
Precise_zeros::zero_near(const Box_of_ranges& box)
{
  constexpr std::size_t most_unknowns = 128;
  if (m_domain.size() > most_unknowns || m_failures >= most_failures || m_control.reason() != Undecided_reason::NONE)
    return std::nullopt;
  verification::Elementary_ranges ranges;
  for (const Interval& range : box)
    ranges.emplace_back(Exact_rational(range.inf()), Exact_rational(range.sup()));
  try {
    const verification::Elementary_proof proof(m_domain, m_constraints, m_values, [this] { m_control.check(); });
    auto zero = proof.zero_near(ranges);
    const bool is_decided = zero && zero->is_solution;
    m_failures += !is_decided;
    return is_decided ? std::move(zero) : std::nullopt;
  } catch (const Run_stopped&) {
    return std::nullopt;
  }
}

inline Box_of_ranges enclosure_of_ranges(const verification::Elementary_ranges& ranges)
{
  Box_of_ranges result;
  for (const auto& [lower, upper] : ranges)
    result.emplace_back(enclosure_of(lower).inf(), enclosure_of(upper).sup());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<bool> Precise_zeros::is_solution(Proved_root& root)
{
  const auto zero = zero_near(root.enclosure);
  if (!zero)
    return std::nullopt;
  if (Box_of_ranges enclosure = enclosure_of_ranges(zero->enclosure); is_inside(enclosure, root.enclosure))
    root.enclosure = std::move(enclosure);
  return zero->is_solution;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Precise_zeros::Zero> Precise_zeros::around(const Box_of_ranges& box)
{
  const auto zero = zero_near(box);
  if (!zero)
    return std::nullopt;
  Zero result{*zero->is_solution, {enclosure_of_ranges(zero->enclosure), {}}};
  for (const auto& [lower, upper] : zero->region) {
    const double begin = enclosure_of(lower).sup();
    result.root.region.emplace_back(begin, (std::max)(begin, enclosure_of(upper).inf()));
  }
  if (result.is_solution && !is_inside(result.root.enclosure, result.root.region))
    return std::nullopt;
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECISE_ZEROS_H
