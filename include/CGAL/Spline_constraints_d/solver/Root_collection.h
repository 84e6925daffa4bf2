// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_COLLECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_COLLECTION_H

#include <CGAL/Spline_constraints_d/solver/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Root_position.h>
#include <CGAL/Spline_constraints_d/solver/Root_refinement.h>

#include <chrono>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A root that was found: its tight enclosure, and a region around it that holds no other root of the equalities.
template <class Coordinate>
struct Found_root
{
  Root_enclosure<Coordinate> enclosure;
  std::vector<Coordinate> lower, upper;   // the region
  Position position;
};

/*
The regular roots found so far, each once: a root on a face that several boxes share is found from each of them. Two finds are the same root when the
enclosure of one lies in the region of the other; no tolerance is involved.
*/
template <class NT>
class Root_collection
{
  using Coordinate = typename Number_traits<NT>::Coordinate;

  Approximate_refinement m_approximation;
  Root_refinement<Coordinate> m_refinement;
  Root_position<NT> m_position;
  Certified_region<Coordinate> m_region;
  std::vector<NT> m_coefficients;   // on the region, where it is the box of a node
  std::vector<Coordinate> m_first_lower, m_first_upper;
  std::vector<Found_root<Coordinate>> m_roots;
  const std::vector<Found_root<Coordinate>>* m_others;
  int m_precision;
  double m_seconds = 0;

public:
  // `others`: roots that are known from elsewhere, to be counted there.
  Root_collection(const Constraint_system_d& system, const System_layout& layout, Exact_source& source, int precision,
                  const std::vector<Found_root<Coordinate>>* others = nullptr)
    : m_position(system, layout, source), m_others(others), m_precision(precision)
  {}

  void set_others(const std::vector<Found_root<Coordinate>>* others) { m_others = others; }

  std::vector<Found_root<Coordinate>>& roots() { return m_roots; }
  const std::vector<Found_root<Coordinate>>& roots() const { return m_roots; }
  double seconds() const { return m_seconds; }

  // Notes that the box of a node holds exactly one root. The first region of a root is the largest, the last one serves the refinement.
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
    m_coefficients = node.coefficients;
    if (is_first) {
      m_first_lower = node.lower;
      m_first_upper = node.upper;
    }
  }

  void set_region(const Certified_region<Coordinate>& region, bool is_first)
  {
    m_region = region;
    m_coefficients.clear();
    if (is_first) {
      m_first_lower = region.lower;
      m_first_upper = region.upper;
    }
  }

  // Leaves the part of a box that lies in the region; they meet.
  void clip_to_region(std::vector<Coordinate>& lower, std::vector<Coordinate>& upper) const
  {
    for (std::size_t j = 0; j < lower.size(); ++j) {
      lower[j] = (std::max)(lower[j], m_region.lower[j]);
      upper[j] = (std::min)(upper[j], m_region.upper[j]);
    }
  }

  // A tight enclosure of the root of the region.
  Root_enclosure<Coordinate> refine()
  {
    const auto start = std::chrono::steady_clock::now();
    if constexpr (std::is_same_v<NT, double>)
      if (!m_coefficients.empty())
        m_approximation.refine(m_region.source->layout(), m_coefficients.data(), m_region.inverse, m_region.start);
    Root_enclosure<Coordinate> enclosure = m_refinement.refine(m_region, m_precision);
    m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return enclosure;
  }

  // A known root whose enclosure meets another one.
  const Found_root<Coordinate>* root_that_meets(const Root_enclosure<Coordinate>& enclosure) const
  {
    return find([&](const Found_root<Coordinate>& root) {
      for (std::size_t j = 0; j < enclosure.lower.size(); ++j)
        if (root.enclosure.upper[j] < enclosure.lower[j] || enclosure.upper[j] < root.enclosure.lower[j])
          return false;
      return true;
    });
  }

  // Whether the root of the region, in this enclosure, is a known one.
  bool is_known(const Root_enclosure<Coordinate>& enclosure) const { return is_known(enclosure, m_first_lower, m_first_upper); }

  // The same for a root that another collection has found.
  bool is_known(const Found_root<Coordinate>& root) const { return is_known(root.enclosure, root.lower, root.upper); }

  // Keeps the root of the region unless it is known.
  void add(Root_enclosure<Coordinate> enclosure)
  {
    if (is_known(enclosure))
      return;
    const auto start = std::chrono::steady_clock::now();
    const Position position = m_position.decide(m_region, enclosure);
    m_roots.push_back({std::move(enclosure), m_first_lower, m_first_upper, position});
    m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  // The box lies in the region of a known root.
  bool is_covered(const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper) const
  {
    return find([&](const Found_root<Coordinate>& root) { return contains(root.lower, root.upper, lower, upper); }) != nullptr;
  }

private:
  template <class Predicate>
  const Found_root<Coordinate>* find(const Predicate& is_wanted) const
  {
    for (const auto* roots : {m_others, &m_roots})
      if (roots != nullptr)
        for (const Found_root<Coordinate>& root : *roots)
          if (is_wanted(root))
            return &root;
    return nullptr;
  }

  // An enclosure lies in a known region, or its region holds the enclosure of a known root, which then is the same.
  bool is_known(const Root_enclosure<Coordinate>& enclosure, const std::vector<Coordinate>& region_lower, const std::vector<Coordinate>& region_upper) const
  {
    if (is_covered(enclosure.lower, enclosure.upper))
      return true;
    const auto* known = root_that_meets(enclosure);
    return known != nullptr && contains(region_lower, region_upper, known->enclosure.lower, known->enclosure.upper);
  }

  static bool contains(const std::vector<Coordinate>& outer_lower, const std::vector<Coordinate>& outer_upper,
                       const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper)
  {
    for (std::size_t j = 0; j < lower.size(); ++j)
      if (lower[j] < outer_lower[j] || outer_upper[j] < upper[j])
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_ROOT_COLLECTION_H
