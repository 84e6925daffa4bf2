// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_SCRATCH_MEMORY_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_SCRATCH_MEMORY_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <memory_resource>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Memory of one thread that is kept for its next call: what small queries need while they run. It is taken from the
// front of a block, and is free again as a whole when nothing of it is in use; so it is no place for answers. What a
// thread takes it has to give back itself.
class Scratch_memory : public std::pmr::memory_resource
{
  static constexpr std::size_t first_size = std::size_t(1) << 16;

  std::vector<std::unique_ptr<std::byte[]>> m_blocks; // the last one, the largest, is taken from
  std::byte *m_front = nullptr, *m_end = nullptr;
  std::size_t m_size = first_size / 2; // of the last block
  std::size_t m_parts_in_use = 0;

public:
  void* take(std::size_t size, std::size_t alignment)
  {
    void* begin = m_front;
    std::size_t space = static_cast<std::size_t>(m_end - m_front);
    if (std::align(alignment, size, begin, space) == nullptr) {
      add_block(size + alignment);
      return take(size, alignment);
    }
    m_front = static_cast<std::byte*>(begin) + size;
    ++m_parts_in_use;
    return begin;
  }

  void give_back(void* begin, std::size_t size) noexcept
  {
    if (static_cast<std::byte*>(begin) + size == m_front)
      m_front = static_cast<std::byte*>(begin);
    if (--m_parts_in_use == 0)
      free_all();
  }

private:
  void add_block(std::size_t least)
  {
    m_size = (std::max)(2 * m_size, least);
    m_blocks.push_back(std::make_unique<std::byte[]>(m_size));
    m_front = m_blocks.back().get();
    m_end = m_front + m_size;
  }

  void free_all() noexcept
  {
    if (m_blocks.size() > 1)
      m_blocks.erase(m_blocks.begin(), m_blocks.end() - 1);
    m_front = m_blocks.back().get();
  }

  void* do_allocate(std::size_t size, std::size_t alignment) override { return take(size, alignment); }
  void do_deallocate(void* begin, std::size_t size, std::size_t) override { give_back(begin, size); }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

// That of the calling thread. There is one, also where a program that hides its symbols links a shared library, which
// makes lists that the program frees.
Scratch_memory& scratch_memory();

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Scratch_memory& scratch_memory()
{
  thread_local Scratch_memory memory;
  return memory;
}
#endif

// Takes that memory.
template <class T>
struct Scratch_allocator
{
  using value_type = T;

  Scratch_allocator() = default;
  template <class U>
  Scratch_allocator(const Scratch_allocator<U>&) noexcept
  {}

  T* allocate(std::size_t size) { return static_cast<T*>(scratch_memory().take(size * sizeof(T), alignof(T))); }
  void deallocate(T* begin, std::size_t size) noexcept { scratch_memory().give_back(begin, size * sizeof(T)); }

  friend bool operator==(const Scratch_allocator&, const Scratch_allocator&) { return true; }
};

template <class T>
using Scratch_vector = std::vector<T, Scratch_allocator<T>>;
template <class T>
using Scratch_list = std::list<T, Scratch_allocator<T>>;

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_SCRATCH_MEMORY_H
