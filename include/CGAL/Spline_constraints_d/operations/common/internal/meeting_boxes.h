// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_MEETING_BOXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_MEETING_BOXES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Index_pair = std::pair<std::size_t, std::size_t>;

template <int d>
using Indexed_box = CGAL::Box_intersection_d::Box_with_info_d<double, d, std::size_t>;

// Closed boxes that hold the patches, so that patches that only touch are a pair.
template <int d>
std::vector<Indexed_box<d>> boxes_of(const std::vector<Spline_patch<d>>& patches)
{
  std::vector<Indexed_box<d>> result;
  for (const Spline_patch<d>& patch : patches) {
    const Vector_bounds<d> bounds = patch.values();
    double lower[d], upper[d];
    for (int i = 0; i < d; ++i) {
      lower[i] = to_double_interval(bounds[i].lower).first;
      upper[i] = to_double_interval(bounds[i].upper).second;
    }
    result.emplace_back(lower, upper, result.size());
  }
  return result;
}

// About how many pieces of two curves have control points with meeting boxes, to judge how much work they are.
template <int d>
std::size_t number_of_meeting_pieces(const Spline_patch<d>& first, const Spline_patch<d>& second)
{
  using Box = std::array<std::pair<double, double>, d>;
  const auto boxes = [](const Spline_patch<d>& curve) {
    std::vector<Box> result;
    for (std::size_t i = 0; i < d; ++i) {
      const Exact_function& f = curve.numerators()[i];
      std::vector<double> points;
      for (std::size_t k = 0; k < f.coefficients().size(); ++k) {
        const double w = curve.is_rational() && k < curve.weight().coefficients().size()
            ? CGAL::to_double(curve.weight().coefficients()[k])
            : 1;
        points.push_back(CGAL::to_double(f.coefficients()[k]) / w);
      }
      const std::size_t degree = static_cast<std::size_t>(f.degree(0));
      result.resize((std::max)(result.size(), points.size() - degree));
      for (std::size_t k = 0; k + degree < points.size(); ++k) {
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(k);
        const auto [least, greatest] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(degree) + 1);
        result[k][i] = {*least, *greatest};
      }
    }
    return result;
  };
  const std::vector<Box> a = boxes(first), b = boxes(second);
  std::size_t result = 0;
  for (const Box& p : a)
    for (const Box& q : b) {
      bool do_meet = true;
      for (std::size_t i = 0; i < d; ++i)
        do_meet = do_meet && p[i].first <= q[i].second && q[i].first <= p[i].second;
      result += do_meet;
    }
  return result;
}

// The positions of all patches whose boxes meet, the lower one first, in lexicographic order.
template <int d>
std::vector<Index_pair> pairs_with_meeting_boxes(const std::vector<Spline_patch<d>>& patches)
{
  std::vector<Indexed_box<d>> boxes = boxes_of(patches);
  std::vector<Index_pair> result;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Indexed_box<d>& a, const Indexed_box<d>& b) {
    result.push_back(std::minmax(a.info(), b.info()));
  });
  std::sort(result.begin(), result.end());
  return result;
}

// The same of patches of two collections.
template <int d>
std::vector<Index_pair> pairs_with_meeting_boxes(const std::vector<Spline_patch<d>>& patches,
                                                 const std::vector<Spline_patch<d>>& others)
{
  std::vector<Indexed_box<d>> boxes = boxes_of(patches), other_boxes = boxes_of(others);
  std::vector<Index_pair> result;
  CGAL::box_intersection_d(
      boxes.begin(), boxes.end(), other_boxes.begin(), other_boxes.end(),
      [&](const Indexed_box<d>& a, const Indexed_box<d>& b) { result.emplace_back(a.info(), b.info()); });
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_MEETING_BOXES_H
