// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_CERTIFIED_PATCHES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_CERTIFIED_PATCHES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Surface_data.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/patch_signs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

using Interval_form = Bernstein_simplex<Interval, 3>;

// Whether the tetrahedron of a patch lies on the side of the mesh that it was made for: it is neither flat nor turned
// inside out.
inline bool is_upright(const Surface_data& data, const Patch_place& patch)
{
  const auto& points = data.neighborhood.points;
  const auto& [a, b, c, d] = patch.nodes;
  // for gaps, the facet whose apex it is has the ends of the edge in this order or in the other
  const bool is_first = !patch.is_gap || data.mesh.edges[patch.edge].facets[0] == patch.facet;
  const CGAL::Orientation expected =
      (patch.side == OUTER) == (is_first != patch.is_gap) ? CGAL::POSITIVE : CGAL::NEGATIVE;
  return CGAL::orientation(points[a], points[b], points[c], points[d]) == expected;
}

// The outward derivative along the segments that the proof follows.
inline Interval_form outward_derivative(const Interval_form& form, const Patch_place& patch)
{
  if (!patch.is_gap)
    return patch.side == OUTER ? form.derivative(0, 3) : form.derivative(3, 0);
  const Interval half(patch.side == OUTER ? 0.5 : -0.5);
  return form.derivative(Interval_form::Barycentric{half + half, -half, -half, Interval(0)});
}

/*
Fills in what is proved of each patch by signs of coefficients, in parts if need be. Counts parts, and stops with the
run.
*/
inline void certify_signs(Surface_data& data, Common::Run_of_steps& run, std::size_t most_parts)
{
  for (std::size_t i = 0; i < data.forms.size(); ++i) {
    if (run.must_stop())
      return;
    const Upward_rounding_guard guard;
    const Patch_place& patch = data.neighborhood.patches[i];
    const Interval_form form = data.forms[i].converted<Interval>(
        [](const Exact_rational& x) { return Number_traits<Interval>::from_rational(x); });
    std::size_t parts = 0;
    data.certificates[i].is_monotone = is_upright(data, patch) &&
        is_proved_to_increase(form, outward_derivative(form, patch), {false, true, true, false}, most_parts, parts);
    data.certificates[i].has_signs = true;
    const CGAL::Sign sign = patch.side == OUTER ? CGAL::POSITIVE : CGAL::NEGATIVE;
    for (int end = 1; patch.is_gap && end <= 2 && data.certificates[i].has_signs; ++end)
      data.certificates[i].has_signs =
          is_proved_to_have_sign<2>(form.face<3>({0, end, 3}), {false, true, false}, sign, most_parts, parts);
    run.add_nodes(parts);
  }
}

// The bounding box of a patch, rounded outwards.
inline CGAL::Bbox_3 box_of(const Surface_data& data, std::size_t patch)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};
  for (const std::size_t node : data.neighborhood.patches[patch].nodes)
    for (int k = 0; k < 3; ++k) {
      lower[k] = (std::min)(lower[k], data.places[node][k].inf());
      upper[k] = (std::max)(upper[k], data.places[node][k].sup());
    }
  return {lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]};
}

inline bool meet_in_common_face(const Surface_data& data, const std::vector<std::array<Exact_rational, 3>>& exact,
                                std::size_t i, std::size_t j)
{
  const Upward_rounding_guard guard;
  const auto& first = data.neighborhood.patches[i].nodes;
  const auto& second = data.neighborhood.patches[j].nodes;
  const auto by_intervals = Pair_of_tetrahedra<Interval>(data.places, first, second).meet_in_common_face();
  return by_intervals ? *by_intervals
                      : Pair_of_tetrahedra<Exact_rational>(exact, first, second).meet_in_common_face().value_or(false);
}

/*
Fills in which patches meet others in common faces only. Nothing is proved of those that are not upright, and of what is
near them. The result tells which patches are to blame: they are not upright, or meet one that is. \throws Run_stopped
*/
inline std::vector<bool> certify_places(Surface_data& data, Common::Run_of_steps& run)
{
  std::vector<std::array<Exact_rational, 3>> exact;
  for (const auto& p : data.neighborhood.points)
    exact.push_back({p.x(), p.y(), p.z()});
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Patch_place*>;
  const std::vector<Patch_place>& patches = data.neighborhood.patches;
  std::vector<Box> boxes;
  std::vector<bool> is_sound, is_to_blame;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    run.check();
    is_sound.push_back(is_upright(data, patches[i]));
    is_to_blame.push_back(!is_sound[i]);
    data.certificates[i].is_apart = is_sound[i];
    boxes.emplace_back(box_of(data, i), &patches[i]);
  }
  std::size_t pairs = 0;
  bool is_stopped = false;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    is_stopped = is_stopped || (++pairs % 64 == 0 && run.must_stop());
    const std::size_t i = a.handle() - patches.data(), j = b.handle() - patches.data();
    const bool are_sound = is_sound[i] && is_sound[j];
    if (is_stopped || (are_sound && ((is_to_blame[i] && is_to_blame[j]) || meet_in_common_face(data, exact, i, j))))
      return;
    data.certificates[i].is_apart = data.certificates[j].is_apart = false;
    if (are_sound)
      is_to_blame[i] = is_to_blame[j] = true;
  });
  if (is_stopped)
    for (Patch_certificate& certificate : data.certificates)
      certificate.is_apart = false;
  return is_to_blame;
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_CERTIFIED_PATCHES_H
