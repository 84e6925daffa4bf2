// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace write_surface_mesh_test {

namespace SC = CGAL::Spline_constraints;
using Mesh = SC::Solution_surface_mesh::Mesh;
using Point = CGAL::Simple_cartesian<double>::Point_3;

namespace {

// Its coordinates need all digits.
Mesh pyramid()
{
  Mesh mesh;
  std::array<Mesh::Vertex_index, 5> v;
  for (int k = 0; k < 4; ++k)
    v[k] = mesh.add_vertex(Point(k % 3 == 0 ? -1. / 3 : 1. / 7, k < 2 ? 0.1 : 0.7, 0));
  v[4] = mesh.add_vertex(Point(0, 0, 1e-9 + 1));
  mesh.add_face(v[3], v[2], v[1], v[0]);
  for (int k = 0; k < 4; ++k)
    mesh.add_face(v[k], v[(k + 1) % 4], v[4]);
  return mesh;
}

Mesh triangle()
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1. / 3, 0, 0)), mesh.add_vertex(Point(0, 1, 0)));
  return mesh;
}

// In the folder for files that are of no use later.
std::string path_of(const std::string& name)
{
  return (std::filesystem::temp_directory_path() / ("spline_constraints_" + name)).string();
}

std::string message_for(const std::string& path, const Mesh& mesh)
{
  try {
    SC::IO::write_surface_mesh(path, mesh);
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST(Write_surface_mesh, points_and_faces_are_read_again)
{
  const Mesh mesh = pyramid();
  for (const std::string ending : {".off", ".ply"}) {
    const std::string path = path_of("pyramid" + ending);
    SC::IO::write_surface_mesh(path, mesh);
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    ASSERT_TRUE(CGAL::IO::read_polygon_soup(path, points, faces)) << ending;
    ASSERT_EQ(points.size(), 5u) << ending;
    for (const Mesh::Vertex_index v : mesh.vertices())
      EXPECT_EQ(points[v], mesh.point(v)) << ending;
    ASSERT_EQ(faces.size(), 5u) << ending;
    EXPECT_EQ(faces[0], (std::vector<std::size_t>{3, 2, 1, 0})) << ending;
    std::filesystem::remove(path);
  }
  const std::string path = path_of("triangle.stl");
  SC::IO::write_surface_mesh(path, triangle());
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  ASSERT_TRUE(CGAL::IO::read_polygon_soup(path, points, faces));
  EXPECT_EQ(points, (std::vector<Point>{Point(0, 0, 0), Point(1. / 3, 0, 0), Point(0, 1, 0)}));
  EXPECT_EQ(faces, (std::vector<std::vector<std::size_t>>{{0, 1, 2}}));
  std::filesystem::remove(path);
}

TEST(Write_surface_mesh, VTP_is_what_the_stream_gets)
{
  const Mesh mesh = pyramid();
  const std::string path = path_of("pyramid.vtp");
  SC::IO::write_surface_mesh(path, mesh);
  std::stringstream file, expected;
  file << std::ifstream(path).rdbuf();
  SC::IO::write_VTP(expected, mesh);
  EXPECT_NE(file.str().find("NumberOfPoints=\"5\""), std::string::npos);
  EXPECT_EQ(file.str(), expected.str());
  std::filesystem::remove(path);
}

TEST(Write_surface_mesh, bad_input)
{
  EXPECT_EQ(message_for("mesh.png", triangle()), "mesh.png ends neither with .off, .ply or .stl nor with .vtp");
  EXPECT_EQ(message_for("mesh.stl", pyramid()), "mesh.stl: a face of the mesh is no triangle");
  EXPECT_EQ(message_for("no_such_folder/mesh.off", triangle()), "no_such_folder/mesh.off cannot be written");
  EXPECT_FALSE(std::filesystem::exists("mesh.png"));
  EXPECT_FALSE(std::filesystem::exists("mesh.stl"));
}

} // namespace write_surface_mesh_test
