// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_COLLECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_COLLECTION_H

#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Found_roots.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The roots that one walk finds: from the region of a root to its tight enclosure and its position.
*/
template <class NT>
class Root_collection : public Found_roots<typename Number_traits<NT>::Coordinate>
{
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Base = Found_roots<Coordinate>;

  Approximate_refinement m_approximation;
  Root_refinement<Coordinate> m_refinement;
  Root_position<NT> m_position;
  Certified_region<Coordinate> m_region;
  std::vector<NT> m_coefficients;   // on the region, where it is the box of a node
  Coordinate_box<Coordinate> m_first_box;
  int m_precision;

public:
  using Base::is_known;

  Root_collection(const Constraint_system_d& system, const System_layout& layout, Exact_source& source, int precision,
                  const std::vector<Found_root<Coordinate>>* others = nullptr)
    : Base(others), m_position(system, layout, source), m_precision(precision)
  {
    constexpr std::size_t few = 16;
    this->roots().reserve(few);
  }

  // Notes that the box of a node holds exactly one root. The first region of a root is the largest, the last one serves
  // the refinement.
  void set_region(const Box_node<NT>& node, Exact_source& source, const Linear_enclosure& linear, double contraction,
                  const std::vector<double>& bounds, bool is_first)
  {
    const int n = linear.dimension(), m = linear.equations();
    m_region.lower = node.lower;
    m_region.upper = node.upper;
    m_region.scale = node.scale;
    m_region.source = &source;
    m_region.matrix = source.matrix();
    m_region.contraction = contraction;
    m_region.bounds = bounds;
    m_region.weights.clear();
    m_region.start.resize(n);
    for (int j = 0; j < n; ++j)
      m_region.start[j] = linear.centre(j) + 0.5;
    m_region.inverse.clear();
    for (int j = 0; j < n; ++j)
      m_region.inverse.insert(m_region.inverse.end(), linear.inverse_row(j), linear.inverse_row(j) + m);
    m_coefficients.assign(node.coefficients().begin(), node.coefficients().end());
    if (is_first)
      m_first_box = make_box(node.lower, node.upper);
  }

  void set_region(const Certified_region<Coordinate>& region, bool is_first)
  {
    m_region = region;
    m_coefficients.clear();
    if (is_first)
      m_first_box = make_box(region.lower, region.upper);
  }

  // Leaves the part of a box that lies in the region; they meet.
  void clip_to_region(std::vector<Coordinate>& lower, std::vector<Coordinate>& upper) const
  {
    for (std::size_t j = 0; j < lower.size(); ++j) {
      lower[j] = (std::max)(lower[j], m_region.lower[j]);
      upper[j] = (std::min)(upper[j], m_region.upper[j]);
    }
  }

  // A tight enclosure of the root of the region, which stays until the next call.
  const Root_enclosure<Coordinate>& refine()
  {
    if constexpr (std::is_same_v<NT, double>)
      if (!m_coefficients.empty())
        m_approximation.refine(m_region.source->layout(), m_coefficients.data(), m_region.inverse, m_region.start);
    return m_refinement.refine(m_region, m_precision);
  }

  // Whether the root of the region, in this enclosure, is a known one.
  bool is_known(const Coordinate_box<Coordinate>& enclosure) const { return is_known(enclosure, m_first_box); }

  // Keeps the root of the region, with the enclosure that was found last.
  void add(Coordinate_box<Coordinate> enclosure)
  {
    const Position position = m_position.decide(m_region, m_refinement.enclosure());
    this->roots().push_back({std::move(enclosure), std::move(m_first_box), position});
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_COLLECTION_H
