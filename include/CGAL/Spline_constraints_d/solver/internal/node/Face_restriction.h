// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FACE_RESTRICTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FACE_RESTRICTION_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The equalities of a node on a face of its box: the first or the last layer of its coefficients along an axis. Blocks
that are on the same unknowns there become one, of the larger degrees, and so do constants with another one.
*/
class Face_restriction
{
  // The part of the coefficients of one block in those of a block on the face. Each is a sum of some of its own.
  struct Part
  {
    struct Summand
    {
      std::size_t to, from; // of the first function
      double weight;
    };

    std::size_t functions, first_error, first_error_on_face; // equalities come first
    std::size_t distance = 0;                                // from the first to the last layer
    std::vector<Summand> summands = {};
  };

  int m_axis;
  System_layout m_layout;
  std::vector<Part> m_parts;
  double m_rounding; // of a part, relative to a bound on its coefficients

public:
  static bool has_moderate_degrees(const System_layout& layout)
  {
    constexpr int largest_degree = 32;
    return std::all_of(layout.blocks.begin(), layout.blocks.end(), [](const Block& block) {
      return std::all_of(block.degrees.begin(), block.degrees.end(),
                         [](int degree) { return degree <= largest_degree; });
    });
  }

  // \pre degrees are moderate: binomials are exact.
  Face_restriction(const System_layout& whole, int axis) : m_axis(axis)
  {
    m_layout.dimension = whole.dimension - 1;
    m_layout.equalities = whole.equalities;
    m_layout.functions = whole.equalities;
    std::vector<std::pair<const Block*, std::size_t>> places;
    for (const Block& block : whole.blocks)
      if (block.holds_equalities(whole.equalities))
        places.emplace_back(&block, place_of(block));
    m_layout.place_blocks();
    double most_summands = 0;
    for (const auto& [block, place] : places)
      most_summands += add_part(*block, m_layout.blocks[place]);
    // with u = 2^-52 in any rounding mode: a weight is off by 3 u for each axis, a product by u more, and a sum, which
    // is no larger than all parts together, by u as often as there is something added
    m_rounding = 2 * (most_summands + 3 * m_layout.dimension + 1) * 0x1p-52;
  }

  const System_layout& layout() const { return m_layout; }

  // The unknown on the face that another one than that of the axis becomes.
  int unknown_on_face(int unknown) const { return unknown - (unknown > m_axis ? 1 : 0); }

  // Writes the functions on one of both faces. \pre the node knows bounds on its coefficients
  void operator()(const Box_node<double>& node, bool is_upper, Box_node<double>& face) const
  {
    double* const to = face.coefficients().data();
    std::fill_n(to, m_layout.size, 0.0);
    std::fill_n(face.errors().begin(), m_layout.errors, 0.0);
    for (const Part& part : m_parts) {
      const double* const from = node.coefficients().data() + (is_upper ? part.distance : 0);
      for (const auto& summand : part.summands)
        for (std::size_t f = 0; f < part.functions; ++f)
          to[summand.to + f] += summand.weight * from[summand.from + f];
      for (std::size_t f = 0; f < part.functions; ++f) {
        const double error = node.errors()[part.first_error + f], size = node.sizes()[part.first_error + f];
        double& sum = face.errors()[part.first_error_on_face + f];
        sum = (sum + error + (size + error) * m_rounding) * (1 + 0x1p-50);
      }
    }
    std::copy_n(node.scale.begin(), face.scale.size(), face.scale.begin());
    for (int j = 0; j <= m_layout.dimension; ++j)
      if (j != m_axis) {
        face.lower[unknown_on_face(j)] = node.lower[j];
        face.upper[unknown_on_face(j)] = node.upper[j];
      }
  }

private:
  // Of the block on the face that a block becomes a part of; it is made, or its degrees are raised.
  std::size_t place_of(const Block& block)
  {
    Block own;
    for (const int function : block.functions)
      if (function < m_layout.equalities)
        own.functions.push_back(function);
    for (std::size_t j = 0; j < block.axes.size(); ++j)
      if (block.axes[j] != m_axis) {
        own.axes.push_back(unknown_on_face(block.axes[j]));
        own.degrees.push_back(block.degrees[j]);
      }
    std::vector<Block>& blocks = m_layout.blocks;
    auto known = std::find_if(blocks.begin(), blocks.end(), [&](const Block& other) {
      return other.functions == own.functions && (other.axes == own.axes || other.axes.empty() || own.axes.empty());
    });
    if (known == blocks.end())
      known = blocks.insert(blocks.end(), own);
    Block& result = *known;
    if (result.axes.empty()) {
      result.axes = own.axes;
      result.degrees = own.degrees;
    }
    result.points = 1;
    for (std::size_t j = 0; j < result.axes.size(); ++j) {
      if (!own.axes.empty())
        result.degrees[j] = (std::max)(result.degrees[j], own.degrees[j]);
      result.points *= static_cast<std::size_t>(result.degrees[j]) + 1;
    }
    return static_cast<std::size_t>(&result - blocks.data());
  }

  // Coefficients are raised to the degrees on the face along each axis: of degree d to D, the i-th is the sum of
  // binom(d, j) binom(D - d, i - j) / binom(D, i) times the j-th. Returns how many make up one at most.
  double add_part(const Block& block, const Block& face)
  {
    Part part{face.functions.size(), block.first_error, face.first_error};
    for (std::size_t j = 0; j < block.axes.size(); ++j)
      if (block.axes[j] == m_axis)
        part.distance = static_cast<std::size_t>(block.degrees[j]) * block.lengths[j + 1];
    part.summands.push_back({face.offset, block.offset, 1});
    double most_summands = 1;
    for (std::size_t k = 0; k < face.axes.size(); ++k) {
      int degree = 0;
      std::size_t step = 0;
      for (std::size_t j = 0; j < block.axes.size(); ++j)
        if (block.axes[j] != m_axis && unknown_on_face(block.axes[j]) == face.axes[k]) {
          degree = block.degrees[j];
          step = block.lengths[j + 1];
        }
      const int raised_by = face.degrees[k] - degree;
      most_summands *= (std::min)(degree, raised_by) + 1;
      const std::vector<double> own = binomials<double>(degree), rest = binomials<double>(raised_by),
                                all = binomials<double>(face.degrees[k]);
      std::vector<Part::Summand> raised;
      for (const Part::Summand& summand : part.summands)
        for (int i = 0; i <= face.degrees[k]; ++i)
          for (int j = (std::max)(0, i - raised_by); j <= (std::min)(i, degree); ++j)
            raised.push_back({summand.to + static_cast<std::size_t>(i) * face.lengths[k + 1],
                              summand.from + static_cast<std::size_t>(j) * step,
                              summand.weight * (own[j] * rest[i - j] / all[i])});
      part.summands = std::move(raised);
    }
    m_parts.push_back(std::move(part));
    return most_summands;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FACE_RESTRICTION_H
