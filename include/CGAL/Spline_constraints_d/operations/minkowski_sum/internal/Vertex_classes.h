// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_CLASSES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_CLASSES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// Which of the numbers 0, 1, ... stand for the same vertex.
class Vertex_classes
{
  std::vector<std::size_t> m_parents;

public:
  explicit Vertex_classes(std::size_t size) : m_parents(size)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  std::size_t add()
  {
    m_parents.push_back(m_parents.size());
    return m_parents.back();
  }

  void join(std::size_t a, std::size_t b) { m_parents[of(a)] = of(b); }

  // The same for all numbers of a class.
  std::size_t of(std::size_t a) const
  {
    while (m_parents[a] != a)
      a = m_parents[a];
    return a;
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_CLASSES_H
