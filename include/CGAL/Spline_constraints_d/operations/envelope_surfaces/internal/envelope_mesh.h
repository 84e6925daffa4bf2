// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Mesh_joints.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Local_functions.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_image.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Euler's formula for a part, with copies joined: a cell with k copies counts as 1/k, and at a pole curves are points.
class Joined_cells
{
  const Envelope_part_3& m_part;
  std::vector<bool> m_is_used;     // vertices
  std::vector<std::size_t> m_same; // by vertex, one that is connected with it at a pole

public:
  explicit Joined_cells(const Envelope_part_3& part)
    : m_part(part), m_is_used(part.solutions.vertices().size(), false), m_same(part.solutions.vertices().size())
  {
    std::iota(m_same.begin(), m_same.end(), 0);
  }

  int characteristic()
  {
    double result = static_cast<double>(m_part.solutions.patches().size());
    for (const Surface_arc& arc : m_part.solutions.arcs()) {
      if (arc.patches == 0)
        continue;
      result -= weight_of(arc.box);
      for (const std::size_t v : arc.ends)
        m_is_used[v] = true;
      if (is_at_point(arc.box))
        m_same[representative(arc.ends[0])] = representative(arc.ends[1]);
    }
    for (std::size_t v = 0; v < m_is_used.size(); ++v)
      if (m_is_used[v]) {
        const Curve_vertex::Exact_box& box = m_part.solutions.vertices()[v].box;
        result += is_at_point(box) ? (representative(v) == v ? 1.0 : 0.0) : weight_of(box);
      }
    return static_cast<int>(std::lround(result));
  }

private:
  std::size_t representative(std::size_t v) const
  {
    while (m_same[v] != v)
      v = m_same[v];
    return v;
  }

  static bool is_at(const Curve_vertex::Exact_box& box, int unknown, const Exact_rational& value)
  {
    const auto& own = box[static_cast<std::size_t>(unknown)];
    return own.first == value && own.second == value;
  }

  bool is_at_point(const Curve_vertex::Exact_box& box) const
  {
    return std::any_of(m_part.poles.begin(), m_part.poles.end(), [&](const Envelope_pole& pole) {
      return pole.is_one_point && is_at(box, pole.unknown, pole.value);
    });
  }

  double weight_of(const Curve_vertex::Exact_box& box) const
  {
    if (is_at_point(box))
      return 0;
    double result = 1;
    for (const int j : m_part.closed_unknowns) {
      const auto& range = m_part.solutions.system().domain(j);
      if (is_at(box, j, range.first) || is_at(box, j, range.second))
        result /= 2;
    }
    for (const Envelope_pole& pole : m_part.poles)
      if (is_at(box, pole.unknown, pole.value))
        result /= 2;
    return result;
  }
};

// Joins the triangles of a part across its seams and poles.
inline void join(Solution_surface_mesh& mesh, const Envelope_part_3& part)
{
  Mesh_joints joints(mesh);
  bool is_joined = true;
  for (const int j : part.closed_unknowns) {
    const auto& range = part.solutions.system().domain(j);
    is_joined = joints.join(joints.chains_on(j, CGAL::to_double(range.first)),
                            joints.chains_on(j, CGAL::to_double(range.second))) &&
        is_joined;
  }
  for (const Envelope_pole& pole : part.poles)
    if (pole.is_one_point)
      joints.contract(joints.chains_on(pole.unknown, CGAL::to_double(pole.value)));
  if (!is_joined)
    mesh.undecided_parts.push_back({{}, {}, "a seam along which triangles were not joined"});
}

// Joins the triangles of all parts where surfaces go on across a pole.
inline void join_at_poles(Solution_surface_mesh& mesh, const std::vector<Envelope_part_3>& parts)
{
  std::set<std::pair<int, Exact_rational>> known;
  for (const Envelope_part_3& part : parts)
    for (const Envelope_pole& pole : part.poles)
      if (!pole.is_one_point && known.emplace(pole.unknown, pole.value).second) {
        Mesh_joints joints(mesh);
        if (!joints.join_pairs(joints.chains_on(pole.unknown, CGAL::to_double(pole.value))))
          mesh.undecided_parts.push_back({{}, {}, "a pole at which triangles were not joined"});
      }
}

// Whether the image has points without a tangent plane, or a curve of solutions is one point: triangles are not made
// well-shaped there.
inline bool is_image_singular(const Envelope_part_3& part)
{
  const auto is_at_point = [&](const Surface_arc& arc) {
    return std::any_of(part.poles.begin(), part.poles.end(), [&](const Envelope_pole& pole) {
      return pole.is_one_point && arc.plane == pole.unknown &&
          arc.box[static_cast<std::size_t>(arc.plane)].first == pole.value;
    });
  };
  const std::vector<Surface_arc>& arcs = part.solutions.arcs();
  return (part.cusps && !part.cusps->vertices().empty()) || std::any_of(arcs.begin(), arcs.end(), is_at_point);
}

// The triangles of a part; where the first ones are not within the error, edges may turn more, and then all is finer.
inline Solution_surface_mesh mesh_of(const Envelope_part_3& part, const Surface_mesh_options& options,
                                     Operation_budget& budget)
{
  constexpr double tolerance = 1.05, any_angle = 10; // errors are measured up to a small part
  Surface_mesh_options own = options;
  const bool is_singular = is_image_singular(part);
  own.is_remeshed = options.is_remeshed && !is_singular;
  const int most_rounds = part.cusps && !part.cusps->vertices().empty() ? 3 : 6;
  for (int round = 1;; ++round) {
    Solution_surface_mesh result = to_surface_mesh(part.solutions, part.image, own, budget.remaining());
    budget.add(result.summary());
    const bool is_within = result.error <= tolerance * options.chord_error;
    if (is_within || round == most_rounds || budget.must_stop()) {
      std::erase_if(result.undecided_parts,
                    [](const Undecided_part& place) { return place.reason == "triangles with a greater error"; });
      if (!is_within)
        result.undecided_parts.push_back({{}, {}, "triangles with a greater error"});
      return result;
    }
    const double share = round < 4 ? 0.9 : 0.6; // of the error that would be right, if errors were as one asks
    if (round > 1)
      own.chord_error *= (std::max)(0.25, share * options.chord_error / result.error);
    own.angle = any_angle;
  }
}

using Vertex_distances =
    Solution_surface_mesh::Mesh::Property_map<Solution_surface_mesh::Mesh::Vertex_index, std::vector<double>>;

inline Vertex_distances distances_of(Solution_surface_mesh& mesh)
{
  return mesh.mesh.add_property_map<Solution_surface_mesh::Mesh::Vertex_index, std::vector<double>>("v:distances")
      .first;
}

// Adds the distances of the vertices of a bisector or sector from both operands, along normals.
inline void add_distances(Solution_surface_mesh& mesh, const Envelope_part_3& part)
{
  const Vertex_distances distances = distances_of(mesh);
  const auto dimension = static_cast<std::size_t>(part.solutions.dimension());
  Exact_ranges domain = domain_of(part.solutions.system());
  domain.resize(dimension); // without those of inequalities
  for (const Vector_expression<3>& foot : part.feet) {
    const Image_functions own = image_functions(foot, domain);
    std::vector<Spline_function> functions(own.numerators.begin(), own.numerators.end());
    functions.insert(functions.end(), own.denominators.begin(), own.denominators.end());
    Local_function_source source(std::move(functions), dimension);
    Function_jets jets;
    for (const auto v : mesh.mesh.vertices()) {
      const std::span<const double> unknowns = std::span<const double>(mesh.unknowns[v]).first(dimension);
      Exact_ranges place;
      for (const double unknown : unknowns)
        place.emplace_back(Exact_rational(unknown), Exact_rational(unknown));
      source.near(place).evaluate(unknowns, 1, jets);
      const auto& p = mesh.mesh.point(v);
      const auto step = [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        return p[i] - jets.values[k] / jets.values[k + 3];
      };
      distances[v].push_back(std::hypot(step(0), step(1), step(2)));
    }
  }
}

// Adds triangles with all that is known of their vertices and edges. Surfaces are numbered on.
inline void append(Solution_surface_mesh& result, Solution_surface_mesh& other)
{
  const Vertex_distances distances = distances_of(result), own = distances_of(other);
  std::size_t first = 0;
  for (const auto f : result.mesh.faces())
    first = (std::max)(first, result.surface[f] + 1);
  std::vector<Solution_surface_mesh::Mesh::Vertex_index> copy(other.mesh.num_vertices());
  for (const auto v : other.mesh.vertices()) {
    copy[v] = result.mesh.add_vertex(other.mesh.point(v));
    result.unknowns[copy[v]] = other.unknowns[v];
    result.differentials[copy[v]] = other.differentials[v];
    distances[copy[v]] = own[v];
  }
  for (const auto f : other.mesh.faces()) {
    std::vector<Solution_surface_mesh::Mesh::Vertex_index> corners;
    for (const auto v : other.mesh.vertices_around_face(other.mesh.halfedge(f)))
      corners.push_back(copy[v]);
    result.surface[result.mesh.add_face(corners)] = first + other.surface[f];
  }
  for (const auto e : other.mesh.edges())
    if (other.is_feature[e]) {
      const auto h = other.mesh.halfedge(e);
      result
          .is_feature[result.mesh.edge(result.mesh.halfedge(copy[other.mesh.source(h)], copy[other.mesh.target(h)]))] =
          true;
    }
  result.error = (std::max)(result.error, other.error);
  result.undecided_parts.insert(result.undecided_parts.end(), other.undecided_parts.begin(),
                                other.undecided_parts.end());
  result.work += other.work;
}

} // namespace Envelope_surfaces
} // namespace internal

CGAL_SPLINE_CONSTRAINTS_INLINE int Envelope_surface_3::euler_characteristic() const
{
  int result = 0;
  for (const Envelope_part_3& part : m_parts)
    result += internal::Envelope_surfaces::Joined_cells(part).characteristic();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_surface_mesh Envelope_surface_3::mesh(const Surface_mesh_options& options,
                                                                              const Solver_options& run) const
{
  internal::Common::Operation_budget budget(run);
  Solution_surface_mesh result;
  for (const Envelope_part_3& part : m_parts) {
    Solution_surface_mesh own = internal::Envelope_surfaces::mesh_of(part, options, budget);
    internal::Envelope_surfaces::join(own, part);
    internal::Envelope_surfaces::add_distances(own, part);
    internal::Envelope_surfaces::append(result, own);
  }
  internal::Envelope_surfaces::join_at_poles(result, m_parts);
  std::size_t of_parts = 0; // which their meshes have, too
  for (const Envelope_part_3& part : m_parts)
    of_parts += part.solutions.undecided().size();
  if (m_undecided.size() > of_parts)
    result.undecided_parts.insert(result.undecided_parts.end(), m_undecided.begin(), m_undecided.end());
  result.work.is_complete = result.undecided_parts.empty();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Envelope_surface_3& surface)
{
  std::size_t surfaces = 0;
  for (const Envelope_part_3& part : surface.parts())
    surfaces += part.solutions.surfaces().size();
  return out << "surfaces: " << (surface.is_complete() ? "" : "at least ") << surfaces << " in "
             << surface.parts().size() << " parts, Euler characteristic " << surface.euler_characteristic() << ", "
             << surface.undecided().size() << " undecided; complete: " << (surface.is_complete() ? "yes" : "no")
             << "; nodes " << surface.summary().nodes << "; seconds " << surface.summary().seconds;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H
