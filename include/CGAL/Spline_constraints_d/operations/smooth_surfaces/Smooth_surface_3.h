// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Patch_certificate.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_hit.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Surface_data.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Point_3.h>
#include <CGAL/Ray_3.h>
#include <CGAL/Segment_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

A closed smooth surface through the vertices of a mesh, see `smooth_surface()`: the zeros of a function that is a cubic
polynomial on each of twelve tetrahedra per face of the mesh, with one derivative everywhere. It is negative inside.
All of it is exact. Copies share their data.
*/
class Smooth_surface_3
{
public:
  //! the kernel.
  using Kernel = internal::Exact_kernel;
  //! the numbers.
  using FT = Exact_rational;

private:
  std::shared_ptr<const internal::Smooth_surfaces::Surface_data> m_data;

public:
#ifndef DOXYGEN_RUNNING
  explicit Smooth_surface_3(std::shared_ptr<const internal::Smooth_surfaces::Surface_data> data)
    : m_data(std::move(data))
  {}

  const internal::Smooth_surfaces::Surface_data& data() const { return *m_data; }
#endif

  /// \name Pieces
  /// @{

  //! how many tetrahedra there are: twelve for each face, of which six are between the center of the face and an apex,
  //! and two times three halves of those between apexes of neighbouring faces.
  std::size_t number_of_patches() const { return m_data->forms.size(); }

  //! a tetrahedron with its polynomial.
  Simplex_function_3 patch(std::size_t i) const { return {m_data->vertices(i), m_data->forms[i]}; }

  //! what is proved of it.
  const Patch_certificate& certificate(std::size_t i) const { return m_data->certificates[i]; }

  //! of how many all is proved that is needed.
  std::size_t number_of_certified_patches() const
  {
    return std::count_if(m_data->certificates.begin(), m_data->certificates.end(),
                         [](const Patch_certificate& certificate) { return certificate.is_certified(); });
  }

  //! number of Bernstein coefficients; neighbours share those of common faces.
  std::size_t number_of_coefficients() const { return m_data->coefficient_count; }

  /// @}

  /// \name Places
  /// Where tetrahedra overlap, which the certificate tells, the first one counts.
  /// @{

  //! the first tetrahedron with a point, if there is one. Complexity: a filtered test for each.
  template <SplineKernel K>
  std::optional<std::size_t> patch_at(const CGAL::Point_3<K>& point) const
  {
    return internal::Smooth_surfaces::patch_at(*m_data, internal::exact_object(point));
  }

  //! the value of the function, within the tetrahedra.
  template <SplineKernel K>
  std::optional<FT> value(const CGAL::Point_3<K>& point) const
  {
    const auto i = patch_at(point);
    return i ? std::optional(patch(*i)(point)) : std::nullopt;
  }

  //! its gradient there.
  template <SplineKernel K>
  std::optional<Kernel::Vector_3> gradient(const CGAL::Point_3<K>& point) const
  {
    const auto i = patch_at(point);
    return i ? std::optional(patch(*i).gradient(point)) : std::nullopt;
  }

  //! on which side a point is, exactly: within the tetrahedra by the sign of the function, elsewhere by the side of
  //! the tetrahedra that is seen from it.
  template <SplineKernel K>
  CGAL::Bounded_side bounded_side(const CGAL::Point_3<K>& point) const
  {
    if (const auto found = value(point))
      return static_cast<CGAL::Bounded_side>(-static_cast<int>(CGAL::sign(*found)));
    return internal::Smooth_surfaces::is_inside(*m_data, internal::exact_object(point)) ? CGAL::ON_BOUNDED_SIDE
                                                                                        : CGAL::ON_UNBOUNDED_SIDE;
  }

  //! where a segment meets the surface, in order: all hits, by roots of cubic polynomials, which are exact. \throws
  //! Invalid_input when its ends are equal.
  template <SplineKernel K>
  std::vector<Smooth_surface_hit> intersections(const CGAL::Segment_3<K>& segment) const
  {
    return internal::Smooth_surfaces::hits_on_line(*m_data, internal::exact_object(segment.source()),
                                                   internal::exact_object(segment.target()), false);
  }

  //! the same of a ray; parameters belong to its source and its second point.
  template <SplineKernel K>
  std::vector<Smooth_surface_hit> intersections(const CGAL::Ray_3<K>& ray) const
  {
    return internal::Smooth_surfaces::hits_on_line(*m_data, internal::exact_object(ray.source()),
                                                   internal::exact_object(ray.second_point()), true);
  }

  /// @}

  /// \name Topology
  /// @{

  //! number of connected parts of the mesh, and of the surface if it is complete.
  std::size_t number_of_components() const { return m_data->mesh.number_of_components(); }

  //! that of the mesh, and of the surface if it is complete.
  int euler_characteristic() const
  {
    return static_cast<int>(m_data->mesh.points.size()) - static_cast<int>(m_data->mesh.edges.size()) +
        static_cast<int>(m_data->mesh.facets.size());
  }

  //! whether all tetrahedra are certified: the surface is smooth, without singular points, and has the topology of the
  //! mesh.
  bool is_complete() const { return m_data->undecided.empty(); }

  //! the tetrahedra that are not certified, with boxes around them, the face as operand, and why.
  const std::vector<Undecided_part>& undecided() const { return m_data->undecided; }

  //! the work; a node is a part of a tetrahedron whose signs were looked at, and 64 pairs of tetrahedra.
  const Summary& summary() const { return m_data->summary; }

  /// @}
};

//! writes one line with the counts, and whether they are proved.
//! \relates Smooth_surface_3
inline std::ostream& operator<<(std::ostream& out, const Smooth_surface_3& surface)
{
  return out << "patches: " << surface.number_of_patches() << " tetrahedra, certified "
             << surface.number_of_certified_patches() << "; surface: " << (surface.is_complete() ? "" : "not proved, ")
             << surface.number_of_components() << " components, Euler characteristic " << surface.euler_characteristic()
             << "; complete: " << (surface.is_complete() ? "yes" : "no") << "; nodes " << surface.summary().nodes
             << "; seconds " << surface.summary().seconds;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_3_H
