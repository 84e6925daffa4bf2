// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_FOUND_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_FOUND_ROOTS_H

#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_position.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A root that was found: its tight enclosure, and a region around it that holds no other root of the equalities.
template <class Coordinate>
struct Found_root
{
  Coordinate_box<Coordinate> enclosure, region;
  Position position;
};

/*
The regular roots found so far, each once: a root on a face that several boxes share is found from each of them. Two
finds are the same root when the enclosure of one lies in the region of the other; no tolerance is involved.
*/
template <class Coordinate>
class Found_roots
{
  std::vector<Found_root<Coordinate>> m_roots;
  const std::vector<Found_root<Coordinate>>* m_others;   // null: none

public:
  // `others`: roots that are known from elsewhere, to be counted there.
  explicit Found_roots(const std::vector<Found_root<Coordinate>>* others = nullptr) : m_others(others) {}

  std::vector<Found_root<Coordinate>>& roots() { return m_roots; }
  const std::vector<Found_root<Coordinate>>& roots() const { return m_roots; }

  // A known root whose enclosure meets another one.
  const Found_root<Coordinate>* root_that_meets(const Coordinate_box<Coordinate>& enclosure) const
  {
    return find([&](const Found_root<Coordinate>& root) {
      for (std::size_t j = 0; j < enclosure.size(); ++j)
        if (root.enclosure[j].second < enclosure[j].first || enclosure[j].second < root.enclosure[j].first)
          return false;
      return true;
    });
  }

  // The box lies in the region of a known root.
  bool is_covered(const Coordinate_box<Coordinate>& box) const
  {
    return find([&](const Found_root<Coordinate>& root) { return contains(root.region, box); }) != nullptr;
  }

  // An enclosure lies in a known region, or its region holds the enclosure of a known root, which then is the same.
  bool is_known(const Coordinate_box<Coordinate>& enclosure, const Coordinate_box<Coordinate>& region) const
  {
    if (is_covered(enclosure))
      return true;
    const auto* known = root_that_meets(enclosure);
    return known != nullptr && contains(region, known->enclosure);
  }
  bool is_known(const Found_root<Coordinate>& root) const { return is_known(root.enclosure, root.region); }

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
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_FOUND_ROOTS_H
