// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_CROSSINGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_CROSSINGS_H

#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_findings.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A face of the domain.
struct Domain_face
{
  int unknown;
  Exact_rational value; // that it has there

  bool operator==(const Domain_face& other) const { return unknown == other.unknown && value == other.value; }

  bool has(const Plane_point& point) const
  {
    const std::size_t j = static_cast<std::size_t>(unknown);
    return point.is_fixed[j] && point.box[j].first == value;
  }

  bool has(const Stored_arc& arc) const
  {
    return arc.plane == unknown && arc.box()[static_cast<std::size_t>(unknown)].first == value;
  }
};

// The faces of the domain that cross a cone in a box, and the vertex in which arcs on them end.
struct Cone_crossings
{
  std::vector<Domain_face> faces = {};
  std::optional<std::size_t> apex = std::nullopt;

  // Of the cone with the apex `point`. None if there are arcs on faces of the domain beside it, or if they meet edges
  // of the domain or end in another singular point.
  static std::optional<Cone_crossings> of(const Arc_store& store, const Arc_indices& arcs, const Exact_ranges& domain,
                                          const Exact_ranges& point)
  {
    Cone_crossings result;
    for (const std::size_t a : arcs) {
      const std::size_t unknown = static_cast<std::size_t>(store.arcs()[a].plane);
      const Domain_face face{store.arcs()[a].plane, store.arcs()[a].box()[unknown].first};
      if (face.value != domain[unknown].first && face.value != domain[unknown].second)
        continue;
      if (point[unknown].first != face.value || point[unknown].second != face.value)
        return std::nullopt;
      if (std::find(result.faces.begin(), result.faces.end(), face) == result.faces.end())
        result.faces.push_back(face);
    }
    for (const std::size_t a : arcs)
      for (const std::size_t end : store.arcs()[a].ends)
        if (!result.takes(store.vertex(end), end, point))
          return std::nullopt;
    if (!result.faces.empty() && !result.apex)
      return std::nullopt;
    return result;
  }

private:
  bool takes(const Plane_point& vertex, std::size_t index, const Exact_ranges& point)
  {
    const auto count =
        std::count_if(faces.begin(), faces.end(), [&](const Domain_face& face) { return face.has(vertex); });
    if (count == 0 || !is_at(vertex, point))
      return count < 2 && !vertex.is_singular;
    if (!apex)
      apex = index;
    return *apex == index;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_CROSSINGS_H
