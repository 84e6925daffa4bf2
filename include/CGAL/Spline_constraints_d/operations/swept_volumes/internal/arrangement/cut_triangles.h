// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CUT_TRIANGLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CUT_TRIANGLES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Contact_points.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Meeting_triangles.h>

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Triangles of one plane, cut along the segments in which others meet them.
class Plane_triangulation
{
  static constexpr std::size_t is_made = std::numeric_limits<std::size_t>::max(); // by two segments that cross

  using Point_2 = Exact_kernel::Point_2;
  struct Label
  {
    std::size_t index = is_made;
  };
  using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Label, Exact_kernel>;
  using Structure =
      CGAL::Triangulation_data_structure_2<Vertices, CGAL::Constrained_triangulation_face_base_2<Exact_kernel>>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Exact_kernel, Structure, CGAL::Exact_intersections_tag>;
  using Vertex = Triangulation::Vertex_handle;

  const Triangle_soup& m_soup;
  Contact_points& m_points;
  std::vector<std::size_t> m_triangles;
  int m_axis;                      // the plane is seen along it, from its positive side
  std::vector<CGAL::Sign> m_sides; // of the triangles: whether they are counterclockwise
  Triangulation m_triangulation;
  std::unordered_map<std::size_t, Vertex> m_known;

public:
  Plane_triangulation(const Triangle_soup& soup, Contact_points& points, std::vector<std::size_t> triangles)
    : m_soup(soup), m_points(points), m_triangles(std::move(triangles)), m_axis(axis_of(m_triangles.front()))
  {
    for (std::size_t triangle : m_triangles) {
      const Corners& corners = m_soup.triangles[triangle];
      m_sides.push_back(CGAL::orientation(seen(corners[0]), seen(corners[1]), seen(corners[2])));
      for (int k = 0; k < 3; ++k)
        add_segment(corners[k], corners[(k + 1) % 3]);
    }
  }

  void add(const std::vector<std::size_t>& contact)
  {
    if (contact.size() == 1)
      vertex_of(contact.front());
    else if (contact.size() == 2)
      add_segment(contact[0], contact[1]);
  }

  void append_to(Triangle_complex& complex)
  {
    for (Vertex vertex : m_triangulation.finite_vertex_handles())
      if (vertex->info().index == is_made)
        vertex->info().index = m_points.index_of(lifted(vertex->point()));
    for (const auto face : m_triangulation.finite_face_handles())
      if (const int multiplicity = number_over(face); multiplicity > 0) {
        complex.triangles.push_back(
            {face->vertex(0)->info().index, face->vertex(1)->info().index, face->vertex(2)->info().index});
        complex.multiplicity.push_back(multiplicity);
        complex.planes.push_back(m_triangles.front());
      }
  }

private:
  int axis_of(std::size_t triangle) const
  {
    const Corners& corners = m_soup.triangles[triangle];
    const auto& p = m_soup.points[corners[0]];
    const auto normal = CGAL::cross_product(m_soup.points[corners[1]] - p, m_soup.points[corners[2]] - p);
    int result = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(normal[k]) > std::abs(normal[result]))
        result = k;
    for (int k = 0; k < 3; ++k, result = (result + 1) % 3) // a thin triangle may have no normal in doubles
      if (CGAL::orientation(seen(corners[0], result), seen(corners[1], result), seen(corners[2], result)) != CGAL::ZERO)
        break;
    return result;
  }

  Point_2 seen(std::size_t index, int axis) const
  {
    const auto& point = m_points[index];
    return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
  }
  Point_2 seen(std::size_t index) const { return seen(index, m_axis); }

  Vertex vertex_of(std::size_t index)
  {
    const auto [place, is_new] = m_known.try_emplace(index);
    if (is_new) {
      place->second = m_triangulation.insert(seen(index));
      place->second->info().index = index;
    }
    return place->second;
  }

  void add_segment(std::size_t from, std::size_t to)
  {
    m_triangulation.insert_constraint(vertex_of(from), vertex_of(to));
  }

  // The point of the plane that is seen there.
  Exact_kernel::Point_3 lifted(const Point_2& point) const
  {
    const Corners& corners = m_soup.triangles[m_triangles.front()];
    const auto& p = m_points[corners[0]];
    const auto normal = CGAL::cross_product(m_points[corners[1]] - p, m_points[corners[2]] - p);
    const int first = (m_axis + 1) % 3, second = (m_axis + 2) % 3;
    std::array<Exact_kernel::FT, 3> result;
    result[first] = point.x();
    result[second] = point.y();
    result[m_axis] = p[m_axis] -
        (normal[first] * (point.x() - p[first]) + normal[second] * (point.y() - p[second])) / normal[m_axis];
    return {result[0], result[1], result[2]};
  }

  // How many triangles lie over a face.
  int number_over(const Triangulation::Face_handle& face) const
  {
    if (m_triangles.size() == 1)
      return 1;
    const Point_2 middle = CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
    int result = 0;
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const Corners& corners = m_soup.triangles[m_triangles[i]];
      bool is_inside = true;
      for (int k = 0; k < 3 && is_inside; ++k)
        is_inside = CGAL::orientation(seen(corners[k]), seen(corners[(k + 1) % 3]), middle) == m_sides[i];
      result += is_inside;
    }
    return result;
  }
};

// Cuts the triangles of a soup where they meet others.
class Cut_triangles
{
  using Pairs = std::vector<Meeting_triangles::Pair>;

  const Triangle_soup& m_soup;
  const std::function<bool()>& m_is_stopped;
  Contact_points m_points;
  std::vector<bool> m_is_met;
  std::vector<std::size_t> m_plane_of; // one of the triangles that are cut together
  std::vector<std::vector<std::size_t>> m_triangles;
  std::vector<std::vector<std::vector<std::size_t>>> m_contacts; // of planes

public:
  Cut_triangles(const Triangle_soup& soup, const std::function<bool()>& is_stopped)
    : m_soup(soup), m_is_stopped(is_stopped), m_points(soup), m_is_met(count(), false), m_plane_of(count()),
      m_triangles(count()), m_contacts(count())
  {}

  // Nothing, if it was stopped.
  std::optional<Triangle_complex> operator()()
  {
    const Pairs pairs = Meeting_triangles(m_soup)(m_is_stopped);
    if (m_is_stopped())
      return std::nullopt;
    find_planes(pairs);
    if (!find_contacts(pairs))
      return std::nullopt;
    return cut();
  }

private:
  std::size_t count() const { return m_soup.triangles.size(); }
  bool is_stopped_at(std::size_t step) const { return (step & 0xff) == 0 && m_is_stopped(); }

  // Triangles of one plane that have areas in common are cut together.
  void find_planes(const Pairs& pairs)
  {
    std::vector<std::size_t> rank(count()), parent(count());
    boost::disjoint_sets<std::size_t*, std::size_t*> planes(rank.data(), parent.data());
    for (std::size_t i = 0; i < count(); ++i)
      planes.make_set(i);
    for (const auto& pair : pairs) {
      m_is_met[pair.first] = m_is_met[pair.second] = true;
      if (pair.is_coplanar)
        planes.union_set(pair.first, pair.second);
    }
    for (std::size_t i = 0; i < count(); ++i) {
      m_plane_of[i] = planes.find_set(i);
      if (m_is_met[i])
        m_triangles[m_plane_of[i]].push_back(i);
    }
  }

  // What triangles of different planes have in common. Whether it was not stopped.
  bool find_contacts(const Pairs& pairs)
  {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (is_stopped_at(i))
        return false;
      const std::size_t one = m_plane_of[pairs[i].first], other = m_plane_of[pairs[i].second];
      if (one == other)
        continue;
      const std::vector<std::size_t> contact = m_points.contact_of(pairs[i].first, pairs[i].second);
      m_contacts[one].push_back(contact);
      m_contacts[other].push_back(contact);
    }
    return true;
  }

  std::optional<Triangle_complex> cut()
  {
    Triangle_complex result;
    for (std::size_t i = 0; i < count(); ++i) {
      if (is_stopped_at(i))
        return std::nullopt;
      if (!m_is_met[i]) {
        result.triangles.push_back(m_soup.triangles[i]);
        result.multiplicity.push_back(1);
        result.planes.push_back(i);
      } else if (!m_triangles[i].empty()) {
        Plane_triangulation plane(m_soup, m_points, m_triangles[i]);
        for (const auto& contact : m_contacts[i])
          plane.add(contact);
        plane.append_to(result);
      }
    }
    result.points = m_points.points();
    return result;
  }
};

// The triangles of a soup, cut where they meet others; nothing, if it was stopped.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Triangle_complex>
triangle_complex_of(const Triangle_soup& soup, const std::function<bool()>& is_stopped)
{
  return Cut_triangles(soup, is_stopped)();
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CUT_TRIANGLES_H
