// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SHARED_VECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SHARED_VECTOR_H

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A vector that never changes, so that its copies share it: those of exact numbers are costly.
template <class T>
class Shared_vector
{
  std::shared_ptr<const std::vector<T>> m_values;

public:
  Shared_vector(std::vector<T> values = {}) : m_values(std::make_shared<const std::vector<T>>(std::move(values))) {}

  const std::vector<T>& operator*() const { return *m_values; }

  std::size_t size() const { return m_values->size(); }
  const T& operator[](std::size_t i) const { return (*m_values)[i]; }
  const T& front() const { return m_values->front(); }
  const T& back() const { return m_values->back(); }
  auto begin() const { return m_values->begin(); }
  auto end() const { return m_values->end(); }

  friend bool operator==(const Shared_vector& a, const Shared_vector& b)
  {
    return a.m_values == b.m_values ||
        (a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const T& x, const T& y) { return bool(x == y); }));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SHARED_VECTOR_H
