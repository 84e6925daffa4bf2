// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SYSTEM_LAYOUT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SYSTEM_LAYOUT_H

#include <CGAL/Spline_constraints_d/function/bernstein_kernels.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
How the Bernstein coefficients of all functions of a system lie in one array.

A block is a tensor over some unknowns whose entries are interleaved: the functions that have a term on exactly these
unknowns stand side by side as the fastest index, so that one pass over the block splits, bounds and differentiates all
of them. Functions are numbered equalities first, then inequalities.
*/
struct Block
{
  std::vector<int> axes;        // unknowns, increasing
  std::vector<int> degrees;
  std::vector<int> functions;   // interleaved, increasing
  std::size_t points = 1;       // control points: the product of the (degree + 1)
  std::size_t offset = 0;       // of the first number in the array
  std::size_t first_error = 0;  // of the first function's error bound: one per function of the block

  // numbers that axis j and the faster ones span; one more entry for the functions alone
  std::vector<std::size_t> lengths;

  std::size_t size() const { return points * functions.size(); }

  bool holds_equalities(int equalities) const { return !functions.empty() && functions.front() < equalities; }

  Axis_view view(std::size_t axis) const
  {
    Axis_view result{1, degrees[axis], functions.size()};
    for (std::size_t j = 0; j < axis; ++j)
      result.outer *= static_cast<std::size_t>(degrees[j]) + 1;
    for (std::size_t j = axis + 1; j < degrees.size(); ++j)
      result.inner *= static_cast<std::size_t>(degrees[j]) + 1;
    return result;
  }
};

// A block seen along one of its axes, with what a cut needs to know of it.
struct Block_axis
{
  std::size_t block;
  std::size_t position;   // of the unknown among the axes of the block
  Axis_view view;
  std::size_t offset, first_error, functions;
};

// Places of the array, from `begin` on and before `end`.
struct Place_range
{
  std::size_t begin, end;
};

void append_range(std::vector<Place_range>& ranges, const Place_range& range);

struct System_layout
{
  int dimension = 0;
  int equalities = 0;
  int functions = 0;
  std::size_t size = 0;     // numbers in the array
  std::size_t errors = 0;   // error bounds
  std::vector<Block> blocks;
  std::vector<std::vector<Block_axis>> blocks_of_axis;
  // the blocks that an axis does not concern, and two bounds per block and function behind all blocks; those side by
  // side joined
  std::vector<std::vector<Place_range>> ranges_without_axis;

  System_layout() = default;
  explicit System_layout(const Constraint_system_d& system);

  // Of the equalities alone, each of their blocks with all of them.
  static System_layout of_combined_equalities(const System_layout& layout);

  // The same with one block on given unknowns.
  static System_layout of_mixed_equalities(const System_layout& layout);

  // Lays the blocks one after the other, once their axes, degrees and functions are set.
  void place_blocks();
};

inline const Spline_function& function_of(const Constraint_system_d& system, int index)
{
  const int equalities = static_cast<int>(system.equalities().size());
  return index < equalities ? system.equalities()[index] : system.inequalities()[index - equalities].function;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void append_range(std::vector<Place_range>& ranges, const Place_range& range)
{
  if (ranges.empty() || ranges.back().end < range.begin)
    ranges.push_back(range);
  else
    ranges.back().end = range.end;
}

CGAL_SPLINE_CONSTRAINTS_INLINE System_layout::System_layout(const Constraint_system_d& system)
  : dimension(system.dimension()), equalities(static_cast<int>(system.equalities().size())),
    functions(static_cast<int>(system.equalities().size() + system.inequalities().size()))
{
  // Equal unknowns share a block when raising the degrees to the common ones costs at most half as much again.
  std::map<std::vector<int>, std::vector<std::size_t>> blocks_on;
  for (int f = 0; f < functions; ++f)
    for (const Spline_term& term : function_of(system, f).terms()) {
      // A function has one block on given unknowns: further terms on them join the first.
      Block* chosen = nullptr;
      for (std::size_t b : blocks_on[term.variables])
        if (!blocks[b].functions.empty() && blocks[b].functions.back() == f)
          chosen = &blocks[b];
      for (std::size_t b : blocks_on[term.variables]) {
        if (chosen != nullptr)
          break;
        Block& block = blocks[b];
        std::size_t common = 1;
        for (std::size_t j = 0; j < term.degrees.size(); ++j)
          common *= static_cast<std::size_t>((std::max)(block.degrees[j], term.degrees[j])) + 1;
        if (2 * common * (block.functions.size() + 1) <= 3 * (block.size() + term.piece_size()))
          chosen = &block;
      }
      if (chosen == nullptr) {
        blocks_on[term.variables].push_back(blocks.size());
        chosen = &blocks.emplace_back();
        chosen->axes = term.variables;
        chosen->degrees = term.degrees;
      }
      if (chosen->functions.empty() || chosen->functions.back() != f)
        chosen->functions.push_back(f);
      chosen->points = 1;
      for (std::size_t j = 0; j < term.degrees.size(); ++j) {
        chosen->degrees[j] = (std::max)(chosen->degrees[j], term.degrees[j]);
        chosen->points *= static_cast<std::size_t>(chosen->degrees[j]) + 1;
      }
    }
  place_blocks();
}

CGAL_SPLINE_CONSTRAINTS_INLINE System_layout System_layout::of_combined_equalities(const System_layout& layout)
{
  System_layout result;
  result.dimension = layout.dimension;
  result.equalities = result.functions = layout.equalities;
  std::vector<int> all(layout.equalities);
  std::iota(all.begin(), all.end(), 0);
  for (const Block& block : layout.blocks)
    if (block.holds_equalities(layout.equalities))
      result.blocks.push_back({block.axes, block.degrees, all, block.points, 0, 0, {}});
  result.place_blocks();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE System_layout System_layout::of_mixed_equalities(const System_layout& layout)
{
  System_layout result;
  result.dimension = layout.dimension;
  result.equalities = result.functions = layout.equalities;
  std::vector<int> all(layout.equalities);
  std::iota(all.begin(), all.end(), 0);
  std::map<std::vector<int>, std::vector<int>> degrees_on;
  for (const Block& block : layout.blocks)
    if (block.holds_equalities(layout.equalities)) {
      std::vector<int>& degrees = degrees_on[block.axes];
      degrees.resize(block.axes.size(), 0);
      for (std::size_t j = 0; j < degrees.size(); ++j)
        degrees[j] = (std::max)(degrees[j], block.degrees[j]);
    }
  for (const auto& [axes, degrees] : degrees_on) {
    Block& block = result.blocks.emplace_back();
    block.axes = axes;
    block.degrees = degrees;
    block.functions = all;
    for (int degree : degrees)
      block.points *= static_cast<std::size_t>(degree) + 1;
  }
  result.place_blocks();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void System_layout::place_blocks()
{
  blocks_of_axis.resize(dimension);
  ranges_without_axis.resize(dimension);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    std::vector<std::size_t>& lengths = blocks[b].lengths;
    lengths.assign(blocks[b].axes.size() + 1, blocks[b].functions.size());
    for (std::size_t j = blocks[b].axes.size(); j-- > 0;)
      lengths[j] = lengths[j + 1] * (blocks[b].degrees[j] + 1);
    blocks[b].offset = size;
    blocks[b].first_error = errors;
    size += blocks[b].size();
    errors += blocks[b].functions.size();
    for (std::size_t j = 0; j < blocks[b].axes.size(); ++j)
      blocks_of_axis[blocks[b].axes[j]].push_back(
          {b, j, blocks[b].view(j), blocks[b].offset, blocks[b].first_error, blocks[b].functions.size()});
    for (int axis = 0; axis < dimension; ++axis)
      if (!std::binary_search(blocks[b].axes.begin(), blocks[b].axes.end(), axis))
        append_range(ranges_without_axis[axis], {blocks[b].offset, size});
  }
  for (std::vector<Place_range>& ranges : ranges_without_axis)
    append_range(ranges, {size, size + 2 * errors});
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SYSTEM_LAYOUT_H
