// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_ALLOCATE_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_ALLOCATE_PARTS_H

#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Arrays of given sizes in one piece of memory, filled with zeros: small systems would spend more time on many small
// pieces than on what is computed in them.
template <class T>
void allocate_parts(std::vector<T>& storage, std::initializer_list<std::pair<std::span<T>*, std::size_t>> parts)
{
  std::size_t size = 0;
  for (const auto& part : parts)
    size += part.second;
  storage.assign(size, T());
  std::size_t begin = 0;
  for (const auto& [span, length] : parts) {
    *span = {storage.data() + begin, length};
    begin += length;
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_ALLOCATE_PARTS_H
