// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_OF_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_OF_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/certified_patches.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

/*
Makes the neighbourhood of a mesh, the function on it, and its certificate. Heights of apexes are a choice: those that
are certified first, of a few. At the beginning apexes are farther than they must be, by a part of the size of the facet
at least; where the boundary has no sign they go away, where tetrahedra meet or the function may turn back they come
nearer.
*/
class Smooth_surface_finder
{
  static constexpr int m_most_without_gain = 5;    // attempts
  static constexpr std::size_t m_most_parts = 256; // of a tetrahedron, for its certificate

  Oriented_mesh m_mesh;
  const Smooth_surface_shape& m_shape;
  Common::Run_of_steps m_run;
  std::array<std::vector<double>, 2> m_least, m_first, m_heights; // by side and facet
  std::vector<bool> m_is_to_blame;                                // patches of the last attempt, for being in the way

public:
  Smooth_surface_finder(Oriented_mesh mesh, const Smooth_surface_shape& shape, const Solver_options& options)
    : m_mesh(std::move(mesh)), m_shape(shape), m_run(options)
  {
    prepare_mesh(m_mesh);
    check_gradients(m_mesh);
    if (!(m_shape.gap_position > 0 && m_shape.gap_position < 1))
      refuse_mesh("the gap position is not between 0 and 1");
  }

  std::shared_ptr<const Surface_data> operator()()
  {
    Surface_data best;
    best.mesh = m_mesh;
    try {
      search(best);
    } catch (const Run_stopped&) {
    }
    tell(best);
    return std::make_shared<const Surface_data>(std::move(best));
  }

private:
  void search(Surface_data& best)
  {
    set_first_heights();
    best = attempt();
    Surface_data last = best;
    int without_gain = 0;
    for (int i = 1; !m_shape.height && !m_run.is_stopped() && !is_certified(best) && without_gain < m_most_without_gain;
         ++i) {
      change_heights(last, 1 + 1.0 / i);
      last = attempt();
      ++without_gain;
      if (certified_count(best) < certified_count(last)) {
        best = last;
        without_gain = 0;
      }
    }
  }

  void set_first_heights()
  {
    const Neighborhood::Heights least = least_heights(m_mesh);
    for (const int side : {OUTER, INNER})
      for (std::size_t f = 0; f < m_mesh.facets.size(); ++f) {
        // a third of the side of a square with the area of the facet, in units of the normal
        const double length = std::sqrt(CGAL::to_double(m_mesh.normals[f].squared_length()));
        m_least[side].push_back(CGAL::to_double(least[side][f]));
        m_heights[side].push_back((std::max)(std::sqrt(length / 2) / 3 / length, 1.75 * m_least[side][f]));
      }
    m_first = m_heights;
  }

  // Heights as short binary fractions, above the least ones.
  Neighborhood::Heights exact_heights() const
  {
    Neighborhood::Heights result;
    for (const int side : {OUTER, INNER})
      for (std::size_t f = 0; f < m_mesh.facets.size(); ++f) {
        int exponent;
        const double fraction = std::frexp(m_heights[side][f], &exponent);
        Exact_rational height = rational_of_finite(std::ldexp(std::ceil(std::ldexp(fraction, 12)), exponent - 12));
        if (m_shape.height)
          height = m_shape.height(m_mesh.facet_names[f], side == OUTER, height);
        if (!(height > 0))
          refuse_mesh("the height at " + m_mesh.name_of_facet(f) + " is not positive");
        result[side].push_back(height);
      }
    return result;
  }

  Surface_data attempt()
  {
    Surface_data result;
    result.mesh = m_mesh;
    result.neighborhood = neighborhood_of(m_mesh, exact_heights(), m_shape.gap_position);
    for (const auto& p : result.neighborhood.points)
      result.places.push_back(enclosure_of(p));
    const Patch_coefficients coefficients(result.mesh, result.neighborhood, m_shape, m_run);
    result.coefficient_count = coefficients.values().size();
    for (const Patch_place& patch : result.neighborhood.patches) {
      m_run.check();
      result.forms.push_back(coefficients.form_of(patch));
    }
    result.certificates.assign(result.forms.size(), {});
    m_is_to_blame = certify_places(result, m_run);
    certify_signs(result, m_run, m_most_parts);
    return result;
  }

  static std::size_t certified_count(const Surface_data& data)
  {
    return std::count_if(data.certificates.begin(), data.certificates.end(),
                         [](const Patch_certificate& certificate) { return certificate.is_certified(); });
  }

  static bool is_certified(const Surface_data& data) { return certified_count(data) == data.certificates.size(); }

  void change_heights(const Surface_data& data, double factor)
  {
    constexpr double most_growth = 3;
    std::array<std::vector<int>, 2> wish; // 1: farther, -1: nearer
    for (auto& of_side : wish)
      of_side.assign(m_mesh.facets.size(), 0);
    for (std::size_t i = 0; i < data.certificates.size(); ++i) {
      const Patch_place& patch = data.neighborhood.patches[i];
      const Patch_certificate& certificate = data.certificates[i];
      int& own = wish[patch.side][patch.facet];
      if (m_is_to_blame[i])
        own = is_upright(data, patch) || !is_ridge(patch) ? -1 : 1;
      else if (!certificate.has_signs && own == 0)
        own = 1;
      else if (!certificate.is_monotone && own == 0)
        own = -1;
    }
    for (const int side : {OUTER, INNER})
      for (std::size_t f = 0; f < m_mesh.facets.size(); ++f) {
        const double least = m_least[side][f], first = m_first[side][f];
        double& height = m_heights[side][f];
        if (wish[side][f] > 0) // after the farthest again near ones
          height = height > most_growth * first ? least + (first - least) / most_growth : factor * height;
        else if (wish[side][f] < 0)
          height = least + (height - least) / factor;
      }
  }

  // Whether the edge of a gap is convex as seen from its side. Such a gap is not upright if it is too wide for a
  // segment between the apexes to pass over the edge, others if the tetrahedra beside them meet.
  bool is_ridge(const Patch_place& patch) const
  {
    const auto& edge = m_mesh.edges[patch.edge];
    const auto& corners = m_mesh.facets[edge.facets[1]];
    const std::size_t opposite = *std::find_if(corners.begin(), corners.end(),
                                               [&](std::size_t v) { return v != edge.ends[0] && v != edge.ends[1]; });
    const Exact_rational height =
        (m_mesh.points[opposite] - m_mesh.points[edge.ends[0]]) * m_mesh.normals[edge.facets[0]];
    return patch.side == OUTER ? height < 0 : height > 0;
  }

  void tell(Surface_data& data)
  {
    for (std::size_t i = 0; i < data.certificates.size(); ++i) {
      const Patch_certificate& certificate = data.certificates[i];
      if (certificate.is_certified())
        continue;
      Undecided_part part;
      const CGAL::Bbox_3 box = box_of(data, i);
      for (int axis = 0; axis < 3; ++axis)
        part.place.emplace_back((box.min)(axis), (box.max)(axis));
      const Patch_place& patch = data.neighborhood.patches[i];
      part.parameters.push_back({m_mesh.facet_names[patch.facet], {}});
      part.reason = std::string(patch.is_gap ? "gap " : "tetrahedron ") + std::to_string(i) +
          (patch.side == OUTER ? " above " : " below ") + m_mesh.name_of_facet(patch.facet) + ": " +
          reason_of(certificate);
      data.undecided.push_back(std::move(part));
    }
    if (data.forms.empty())
      data.undecided.push_back({{}, {}, in_words(m_run.reason())});
    data.summary = m_run.summary(data.undecided.empty());
  }

  std::string reason_of(const Patch_certificate& certificate) const
  {
    if (m_run.is_stopped())
      return in_words(m_run.reason());
    if (!certificate.is_apart)
      return "it meets another one not in a common face";
    return !certificate.has_signs ? "the function has not one sign on its outer faces"
                                  : "the function is not proved to increase outwards";
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::shared_ptr<const Surface_data>
smooth_surface_of(Oriented_mesh mesh, const Smooth_surface_shape& shape, const Solver_options& options)
{
  return Smooth_surface_finder(std::move(mesh), shape, options)();
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_OF_H
