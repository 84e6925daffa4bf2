// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTERRUPTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTERRUPTION_H

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Calls a function each time that some work has been done, which may end it by an exception.
class Interruption
{
  static constexpr std::size_t most_work = std::size_t(1) << 15;   // about a millisecond, in operations on integers

  std::function<void()> m_check;   // empty: none
  std::size_t m_work = 0;

public:
  explicit Interruption(std::function<void()> check) : m_check(std::move(check)) {}

  void add_work(std::size_t operations)
  {
    m_work += operations;
    if (m_check && m_work >= most_work) {
      m_work = 0;
      m_check();
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTERRUPTION_H
