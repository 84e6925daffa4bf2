// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether meshes cross themselves: pairs of boxes beside all pairs, and meshes with vertices that were moved beside
// self_intersections() of CGAL.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Box_hierarchy.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_crossings.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace mesh_crossings_test {

namespace SC = CGAL::Spline_constraints;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

bool does_self_intersect(const SC::Solution_surface_mesh& surface)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> copy;
  CGAL::copy_face_graph(surface.mesh, copy);
  return PMP::does_self_intersect(copy);
}

} // namespace

TEST(Mesh_crossings, pairs_of_boxes_are_those_that_meet)
{
  std::mt19937 random(1);
  for (const int count : {0, 1, 2, 7, 100, 400}) {
    std::vector<CGAL::Bbox_3> boxes;
    std::uniform_int_distribution<int> place(0, 40), size(0, 6); // many boxes touch only
    for (int i = 0; i < count; ++i) {
      const int x = place(random), y = place(random), z = place(random);
      boxes.emplace_back(x, y, z, x + size(random), y + size(random), z + size(random));
    }
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (CGAL::do_overlap(boxes[i], boxes[k]))
          expected.emplace(k, i);
    const bool was_stopped = SC::internal::Box_hierarchy(boxes).any_pair([&](std::size_t i, std::size_t k) {
      EXPECT_TRUE(found.insert(std::minmax(i, k)).second);
      return false;
    });
    EXPECT_FALSE(was_stopped);
    EXPECT_EQ(found, expected);
    if (count == 400) {
      EXPECT_GT(found.size(), 100u);
      EXPECT_TRUE(SC::internal::Box_hierarchy(boxes).any_pair([](std::size_t, std::size_t) { return true; }));
    }
  }
}

// A half of a torus, with a boundary: vertices are moved a little or far, so that some of the meshes cross themselves.
TEST(Mesh_crossings, same_as_all_pairs_of_triangles)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  const auto ring = square(x) + square(y);
  const SC::Surface_solution_set_d set =
      SC::solve_surfaces(square(ring + square(z) + SC::Exact_rational(91) / 100) - 4 * ring == 0);
  const SC::Solution_surface_mesh torus = SC::to_surface_mesh(set, {.chord_error = 0.03});
  EXPECT_FALSE(SC::internal::Mesh_crossings(torus, set).exist());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<std::size_t> index(0, torus.mesh.number_of_vertices() - 1);
  int crossing = 0, others = 0;
  for (const double length : {0.1, 0.5, 1.0, 2.0})
    for (int k = 0; k < 25; ++k) {
      SC::Solution_surface_mesh moved = torus;
      const SC::Solution_surface_mesh::Mesh::Vertex_index v(static_cast<unsigned>(index(random)));
      moved.mesh.point(v) +=
          length * SC::Surface_differentials_3::Vector(coordinate(random), coordinate(random), coordinate(random));
      const bool expected = does_self_intersect(moved);
      EXPECT_EQ(SC::internal::Mesh_crossings(moved, set).exist(), expected);
      ++(expected ? crossing : others);
    }
  EXPECT_GT(crossing, 10);
  EXPECT_GT(others, 20);
}

} // namespace mesh_crossings_test
