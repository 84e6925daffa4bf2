// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_LOOP_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_LOOP_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// parallel_for() with a tag that is known where this is made, for code that is compiled once for all tags.
class Parallel_loop
{
public:
  using Body = std::function<void(std::size_t index, std::size_t slot)>;

private:
  std::size_t (*m_slots)();
  void (*m_run)(std::size_t count, const Body& body);

  Parallel_loop(std::size_t (*slots)(), void (*run)(std::size_t, const Body&)) : m_slots(slots), m_run(run) {}

public:
  template <class Concurrency_tag>
  static Parallel_loop of()
  {
    return {&slots_of<Concurrency_tag>, &parallel_for<Concurrency_tag, Body>};
  }

  // How many different slots there are at most.
  std::size_t slots() const { return m_slots(); }
  // Calls body(i, slot) for i = 0, ..., count - 1.
  void operator()(std::size_t count, const Body& body) const { m_run(count, body); }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_LOOP_H
