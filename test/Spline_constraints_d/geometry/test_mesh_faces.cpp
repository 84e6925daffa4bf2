// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/mesh_faces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace mesh_faces_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Epick;
using Mesh = CGAL::Surface_mesh<K::Point_3>;

TEST(Mesh_faces, of_a_wedge_are_patches_with_normals_outwards)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const K::Point_3& p : {K::Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}})
    v.push_back(mesh.add_vertex(p));
  std::vector<Mesh::Face_index> triangles{mesh.add_face(v[0], v[2], v[1]), mesh.add_face(v[3], v[4], v[5])};
  for (int i = 0; i < 3; ++i)
    mesh.add_face(v[i], v[(i + 1) % 3], v[3 + (i + 1) % 3], v[3 + i]);
  const auto patches = SC::to_bspline_surfaces(mesh);
  ASSERT_EQ(patches.size(), 5u);
  const K::Point_3 middle(0.25, 0.25, 1);
  for (const auto& [face, patch] : patches) {
    EXPECT_GT(patch.normal(0.5, 0.5) * (patch(0.5, 0.5) - middle), 0) << face;
    std::size_t on_patch = 0;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      for (const double a : {0., 1.})
        on_patch += patch(a, 0) == mesh.point(vertex) || patch(a, 1) == mesh.point(vertex);
    EXPECT_EQ(on_patch, mesh.degree(face));
  }
  EXPECT_EQ(patches[0].first, triangles[0]);
}

// The surfaces of the faces of a mesh.
template <class Patches>
std::vector<SC::Bspline_surface_3<K>> surfaces_of(const Patches& patches)
{
  std::vector<SC::Bspline_surface_3<K>> result;
  for (const auto& [face, patch] : patches)
    result.push_back(patch);
  return result;
}

TEST(Mesh_faces, are_put_together_again)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const K::Point_3& p : {K::Point_3(0, 0, 0.1), {1, 0, 0}, {0, 1, 0}, {0, 0.3, 2}, {1, 0, 2}, {0, 1, 2}})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[2], v[1]);
  mesh.add_face(v[3], v[4], v[5]);
  for (int i = 0; i < 3; ++i)
    mesh.add_face(v[i], v[(i + 1) % 3], v[3 + (i + 1) % 3], v[3 + i]);
  auto surfaces = surfaces_of(SC::to_bspline_surfaces(mesh));
  surfaces[3] = surfaces[3].with_domain(0, -2, 6);
  const Mesh back = SC::to_surface_mesh(surfaces);
  EXPECT_TRUE(CGAL::is_closed(back) && back.is_valid());
  ASSERT_EQ(back.number_of_vertices(), 6u);
  ASSERT_EQ(back.number_of_faces(), 5u);
  const auto corners = [](const Mesh& of, Mesh::Face_index face) {   // from its least vertex on
    std::vector<K::Point_3> result;
    for (const auto vertex : CGAL::vertices_around_face(of.halfedge(face), of))
      result.push_back(of.point(vertex));
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  };
  for (const auto face : mesh.faces())
    EXPECT_EQ(corners(back, face), corners(mesh, face));
  EXPECT_EQ(SC::to_triangle(surfaces[1]), K::Triangle_3({0, 0.3, 2}, {1, 0, 2}, {0, 1, 2}));
  EXPECT_FALSE(SC::to_triangle(surfaces[3]));

  surfaces.push_back(surfaces[2]);
  expect_invalid([&] { SC::to_surface_mesh(surfaces); }, "surface 5 has an edge that is taken");
  surfaces.front() = SC::Bspline_surface_3<K>(
      {1, 2}, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1},
      std::vector<K::Point_3>{{0, 0, 0}, {0, 1, 1}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}});
  expect_invalid([&] { SC::to_surface_mesh(surfaces); }, "surface 0 is no triangle and no bilinear patch");
  surfaces.front() = SC::bilinear_surface<K>({0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0});
  expect_invalid([&] { SC::to_surface_mesh(surfaces); }, "surface 0 has a corner twice");
  EXPECT_TRUE(SC::to_surface_mesh(std::vector<SC::Bspline_surface_3<K>>()).is_empty());
}

TEST(Iso_cuboid, is_given_back_by_its_faces)
{
  const K::Iso_cuboid_3 cuboid({0.1, 0, -1}, {0.3, 2, 5});
  auto faces = SC::to_bspline_surfaces(cuboid);
  std::swap(faces[1], faces[4]);
  EXPECT_EQ(SC::to_iso_cuboid(faces), cuboid);
  faces[0] = faces[2];
  EXPECT_FALSE(SC::to_iso_cuboid(faces));
  EXPECT_FALSE(SC::to_iso_cuboid(std::vector<SC::Bspline_surface_3<K>>()));
}

TEST(Mesh_faces, with_five_vertices_are_refused)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const K::Point_3& p : {K::Point_3(0, 0, 0), {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v);
  expect_invalid([&] { SC::to_bspline_surfaces(mesh); }, "face 0 of the mesh has 5 vertices");
  EXPECT_TRUE(SC::to_bspline_surfaces(Mesh()).empty());
}

TEST(Tetrahedron, has_faces_with_normals_outwards)
{
  const Exact_cartesian::Point_3 p(0, 0, 0), q(1, 0, 0), r(0, 1, 0), s(0, 0, 1);
  for (const auto& tetrahedron :
       {Exact_cartesian::Tetrahedron_3(p, q, r, s), Exact_cartesian::Tetrahedron_3(p, r, q, s)}) {
    const auto faces = SC::to_bspline_surfaces(tetrahedron);
    for (int i = 0; i < 4; ++i) {
      const auto normal = faces[i].normal(1, 0);
      EXPECT_LT(normal * (tetrahedron.vertex(i) - faces[i](0, 0)), 0);
      for (int j = 0; j < 4; ++j)
        EXPECT_EQ(normal * (tetrahedron.vertex(j) - faces[i](0, 0)) == 0, j != i);
    }
  }
  expect_invalid([&] { SC::to_bspline_surfaces(Exact_cartesian::Tetrahedron_3(p, q, r, q)); }, "flat");
}

} // namespace

} // namespace mesh_faces_test
