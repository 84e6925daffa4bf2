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
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The function of a node on a face of its box, for nodes of one function: the first or the last layer of its coefficients
along an axis. All blocks become one tensor on the unknowns that are left, of the largest degrees, with a bound on the
error of its coefficients.
*/
class Face_restriction
{
  // A summand of a coefficient.
  struct Summand
  {
    std::size_t to, from, distance; // to the last layer
    double weight;
  };

  int m_axis;
  System_layout m_layout;
  std::vector<Summand> m_summands;
  double m_rounding; // relative to the sum of bounds on the coefficients of the blocks

public:
  // \pre there is one function, on at least two unknowns, and degrees are at most 56: binomials are exact.
  Face_restriction(const System_layout& whole, int axis) : m_axis(axis)
  {
    m_layout.dimension = whole.dimension - 1;
    m_layout.equalities = m_layout.functions = 1;
    Block& face = m_layout.blocks.emplace_back();
    face.functions = {0};
    for (int j = 0; j < m_layout.dimension; ++j) {
      face.axes.push_back(j);
      face.degrees.push_back(0);
    }
    for (const Block& block : whole.blocks)
      for (std::size_t j = 0; j < block.axes.size(); ++j)
        if (block.axes[j] != axis) {
          int& degree = face.degrees[unknown_on_face(block.axes[j])];
          degree = (std::max)(degree, block.degrees[j]);
        }
    for (const int degree : face.degrees)
      face.points *= static_cast<std::size_t>(degree) + 1;
    m_layout.place_blocks();
    for (const Block& block : whole.blocks)
      add_summands(block);
    // a weight is off by 3 u for each axis, a product and each sum by u more, u = 2^-52 in any rounding mode
    m_rounding = 2 * (most_summands() + 3 * m_layout.dimension + 1) * 0x1p-52;
  }

  const System_layout& layout() const { return m_layout; }

  // The unknown on the face that another one than that of the axis becomes.
  int unknown_on_face(int unknown) const { return unknown - (unknown > m_axis ? 1 : 0); }

  // Writes the function on one of both faces. \pre the bounds on the sizes of the coefficients are those of the node
  void operator()(const Box_node<double>& node, bool is_upper, Box_node<double>& face) const
  {
    double *to = face.coefficients().data(), error = 0, size = 0;
    const double* from = node.coefficients().data();
    std::fill_n(to, m_layout.size, 0.0);
    for (const Summand& summand : m_summands)
      to[summand.to] += summand.weight * from[summand.from + (is_upper ? summand.distance : 0)];
    for (std::size_t b = 0; b < node.errors().size(); ++b) {
      error += node.errors()[b];
      size += node.sizes()[b];
    }
    face.errors()[0] = (error + (size + error) * m_rounding) * (1 + 0x1p-48);
    face.scale[0] = node.scale[0];
    for (int j = 0; j <= m_layout.dimension; ++j)
      if (j != m_axis) {
        face.lower[unknown_on_face(j)] = node.lower[j];
        face.upper[unknown_on_face(j)] = node.upper[j];
      }
  }

private:
  // The coefficients of a block are raised to the degrees of the face along each axis: of degree d to D, the i-th is
  // the sum of binom(d, j) binom(D - d, i - j) / binom(D, i) times the j-th.
  void add_summands(const Block& block)
  {
    std::vector<Summand> summands{{0, block.offset, 0, 1}};
    for (std::size_t j = 0; j < block.axes.size(); ++j)
      if (block.axes[j] == m_axis)
        for (Summand& summand : summands)
          summand.distance = static_cast<std::size_t>(block.degrees[j]) * block.lengths[j + 1];
    const Block& face = m_layout.blocks.front();
    for (std::size_t k = 0; k < face.axes.size(); ++k) {
      int degree = 0;
      std::size_t step = 0;
      for (std::size_t j = 0; j < block.axes.size(); ++j)
        if (block.axes[j] != m_axis && unknown_on_face(block.axes[j]) == face.axes[k]) {
          degree = block.degrees[j];
          step = block.lengths[j + 1];
        }
      const std::vector<double> own = binomials<double>(degree), rest = binomials<double>(face.degrees[k] - degree),
                                all = binomials<double>(face.degrees[k]);
      std::vector<Summand> raised;
      for (const Summand& summand : summands)
        for (int i = 0; i <= face.degrees[k]; ++i)
          for (int j = (std::max)(0, i - face.degrees[k] + degree); j <= (std::min)(i, degree); ++j)
            raised.push_back({summand.to + static_cast<std::size_t>(i) * face.lengths[k + 1],
                              summand.from + static_cast<std::size_t>(j) * step, summand.distance,
                              summand.weight * (own[j] * rest[i - j] / all[i])});
      summands = std::move(raised);
    }
    m_summands.insert(m_summands.end(), summands.begin(), summands.end());
  }

  double most_summands() const
  {
    std::vector<double> counts(m_layout.size, 0);
    for (const Summand& summand : m_summands)
      ++counts[summand.to];
    return *std::max_element(counts.begin(), counts.end());
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FACE_RESTRICTION_H
