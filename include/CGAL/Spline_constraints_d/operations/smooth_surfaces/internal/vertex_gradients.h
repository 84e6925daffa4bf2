// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_VERTEX_GRADIENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_VERTEX_GRADIENTS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

using Double_vector = std::array<double, 3>;

inline Double_vector double_vector(const Exact_kernel::Vector_3& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

inline Double_vector unit_vector(const Exact_kernel::Vector_3& v)
{
  Double_vector result = double_vector(v);
  const double length = std::hypot(result[0], result[1], result[2]);
  for (double& x : result)
    x /= length;
  return result;
}

inline Exact_kernel::Vector_3 exact_vector(const Double_vector& v)
{
  return {rational_of_finite(v[0]), rational_of_finite(v[1]), rational_of_finite(v[2])};
}

/*
The normal at one vertex. Apexes of the facets there have to be beyond its tangent plane, which asks for heights that
are large where centers of facets are far from this plane, or facets turn away from it. The mean normal is turned, in
smaller and smaller steps, until heights are no larger than a half of the size of the facets, if that is possible.
*/
class Vertex_normal
{
  struct Facet
  {
    Double_vector normal, center; // of unit length; from the vertex, divided by the size
  };

  std::vector<Facet> m_facets;
  Double_vector m_sum{};

public:
  // The weight is the angle of the facet.
  void add_facet(const Double_vector& normal, const Double_vector& center, double weight)
  {
    m_facets.push_back({normal, center});
    for (int k = 0; k < 3; ++k)
      m_sum[k] += weight * normal[k];
  }

  Double_vector operator()() const
  {
    constexpr double good_height = 0.5, least_step = 1e-4;
    Double_vector best = scaled_to_one(m_sum);
    double lowest = height(best);
    for (double step = 0.5; step > least_step && lowest > good_height;) {
      Double_vector next = best;
      for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
          Double_vector turned = best;
          turned[axis] += sign * step;
          turned = scaled_to_one(turned);
          if (const double own = height(turned); own < lowest) {
            lowest = own;
            next = turned;
          }
        }
      if (next == best)
        step /= 2;
      best = next;
    }
    return best;
  }

private:
  static Double_vector scaled_to_one(Double_vector v)
  {
    const double length = std::sqrt(product_of(v, v));
    for (double& x : v)
      x /= length;
    return v;
  }

  // The greatest height, relative to sizes; far more where a facet is seen from behind.
  double height(const Double_vector& normal) const
  {
    double result = 0;
    for (const Facet& facet : m_facets) {
      constexpr double least_cosine = 0.05, penalty = 100;
      const double cosine = product_of(normal, facet.normal);
      result = (std::max)(result,
                          cosine < least_cosine ? penalty * (1 + least_cosine - cosine)
                                                : std::abs(product_of(normal, facet.center)) / cosine);
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_kernel::Vector_3> estimated_normals(Oriented_mesh mesh)
{
  prepare_mesh(mesh);
  std::vector<Vertex_normal> normals(mesh.points.size());
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    const Double_vector normal = unit_vector(mesh.normals[f]);
    const double size = std::sqrt(std::sqrt(CGAL::to_double(mesh.normals[f].squared_length())) / 2);
    const auto& corners = mesh.facets[f];
    for (int i = 0; i < 3; ++i) {
      const auto& p = mesh.points[corners[i]];
      const Double_vector a = unit_vector(mesh.points[corners[(i + 1) % 3]] - p),
                          b = unit_vector(mesh.points[corners[(i + 2) % 3]] - p);
      Double_vector center = double_vector(center_of_facet(mesh, f) - p);
      for (double& x : center)
        x /= size;
      normals[corners[i]].add_facet(normal, center, std::acos(std::clamp(product_of(a, b), -1.0, 1.0)));
    }
  }
  std::vector<Exact_kernel::Vector_3> result;
  for (const Vertex_normal& normal : normals)
    result.push_back(exact_vector(normal()));
  return result;
}

/*
Lengths l of the normals n for which the sum of (l_p n_p (q - p) + l_q n_q (q - p))^2 over all edges is nearly least
among those of the same mean: of a quadric, its gradients. By relaxation, vertex for vertex; lengths stay within a
factor of 8 of the mean.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_kernel::Vector_3> balanced_gradients(Oriented_mesh mesh)
{
  prepare_mesh(mesh);
  check_gradients(mesh);
  struct Term
  {
    std::size_t other;
    double own, of_other; // slopes along the edge
  };
  std::vector<Double_vector> normals;
  for (const auto& gradient : mesh.gradients)
    normals.push_back(unit_vector(gradient));
  std::vector<std::vector<Term>> terms(mesh.points.size());
  for (const auto& edge : mesh.edges) {
    const auto& [p, q] = edge.ends;
    const Double_vector along = double_vector(mesh.points[q] - mesh.points[p]);
    const double at_p = product_of(normals[p], along), at_q = product_of(normals[q], along);
    terms[p].push_back({q, at_p, at_q});
    terms[q].push_back({p, at_q, at_p});
  }
  std::vector<double> lengths(mesh.points.size(), 1);
  for (int sweep = 0; sweep < 500; ++sweep) {
    double mean = 0;
    for (std::size_t v = 0; v < lengths.size(); ++v) {
      double numerator = 0, denominator = 0;
      for (const Term& term : terms[v]) {
        numerator -= term.own * term.of_other * lengths[term.other];
        denominator += term.own * term.own;
      }
      if (denominator > 0)
        lengths[v] = std::clamp(numerator / denominator, 0.125, 8.0);
      mean += lengths[v] / static_cast<double>(lengths.size());
    }
    for (double& length : lengths)
      length /= mean;
  }
  std::vector<Exact_kernel::Vector_3> result;
  for (std::size_t v = 0; v < lengths.size(); ++v)
    result.push_back(
        exact_vector({lengths[v] * normals[v][0], lengths[v] * normals[v][1], lengths[v] * normals[v][2]}));
  return result;
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_VERTEX_GRADIENTS_H
