// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A smooth closed surface of implicit cubic patches through the vertices of a mesh, as a finer mesh.
//
//   smooth_mesh FILE [--estimated] [--chord-error E] [--time-limit S] [--output OUT]
//
// FILE is an .off file of triangles, closed; with normals at its vertices (NOFF) the surface has these; without, or
// with --estimated, normals are estimated. OUT is one of .off, .ply or .stl, or a picture, .svg. Exit status: 0 when
// the surface is proved to be smooth and to have the topology of the mesh, 3 when it is not, 2 for bad input. Without
// arguments, some meshes of data/meshes are made smooth, and drawn into smooth_mesh.svg below these.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/smooth_surfaces_3.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Color = CGAL::IO::Color;

Mesh mesh_in(const std::string& path)
{
  std::ifstream in(path);
  if (!in)
    throw SC::Invalid_input(path + " cannot be read");
  Mesh mesh;
  if (!CGAL::IO::read_OFF(in, mesh))
    throw SC::Invalid_input(path + " is no .off file of a manifold mesh");
  return mesh;
}

// With normals of the file, or estimated ones; lengths are such that they contradict each other least.
SC::Smooth_surface_3 smooth(Mesh& mesh, bool are_estimated, const SC::Smooth_surface_shape& shape,
                            const SC::Solver_options& options)
{
  const auto given = mesh.property_map<Mesh::Vertex_index, K::Vector_3>("v:normal");
  const auto gradients = given.second && !are_estimated ? SC::balanced_gradients(mesh, given.first)
                                                        : SC::balanced_gradients(mesh, SC::estimated_normals(mesh));
  return SC::smooth_surface(mesh, gradients, shape, options);
}

int print(const SC::Smooth_surface_3& surface)
{
  for (const auto& part : surface.undecided())
    std::cout << part << '\n';
  std::cout << surface << '\n';
  return surface.is_complete() ? 0 : 3;
}

// A mesh in a picture: its faces, or those of the surface; faces that are not certified are red.
void draw(SC::Scene_3& scene, Mesh mesh, const Color& color, const K::Vector_3& place,
          const std::set<std::size_t>& failed, bool is_smooth)
{
  for (const auto vertex : mesh.vertices())
    mesh.point(vertex) = mesh.point(vertex) + place;
  scene.add(mesh, {.color = color, .has_edges = !is_smooth, .crease = 1},
            [&](const auto& face) { return !is_smooth && failed.count(face) > 0 ? Color(230, 90, 80) : color; });
}

void write(const std::string& path, const Mesh& mesh)
{
  if (!path.ends_with(".svg"))
    return SC::IO::write_surface_mesh(path, mesh);
  SC::Scene_3 scene;
  draw(scene, mesh, Color(150, 195, 235), {0, 0, 0}, {}, true);
  std::ofstream out(path);
  scene.write(out);
  if (!out.flush())
    throw SC::Invalid_input("--output: " + path + " cannot be written");
}

// Of the own data, each above its surface.
class Gallery
{
  SC::Scene_3 m_scene{{.to_viewer = {0.25, -0.9, 0.45}, .width = 1200}};
  double m_right = 0;

public:
  // The number of faces that are not certified.
  std::size_t add(const std::string& name, double size, double width, int halvings,
                  const SC::Smooth_surface_shape& shape = {}, const std::string& file = "")
  {
    Mesh mesh = mesh_in(DATA_DIRECTORY "meshes/" + (file.empty() ? name : file) + ".off");
    for (const auto vertex : mesh.vertices())
      mesh.point(vertex) = CGAL::ORIGIN + size * (mesh.point(vertex) - CGAL::ORIGIN);
    const SC::Smooth_surface_3 surface = smooth(mesh, false, shape, {});
    std::cout << name << ": " << surface << '\n';
    std::set<std::size_t> failed;
    for (const auto& part : surface.undecided())
      failed.insert(part.parameters[0].operand);
    const K::Vector_3 to_right = (m_right + width / 2) * K::Vector_3(0.9635, 0.2676, 0);
    draw(m_scene, mesh, Color(222, 200, 150), to_right + K::Vector_3(0, 0, 3.3), failed, false);
    draw(m_scene, SC::to_surface_mesh(surface, {.chord_error = 0.02, .most_halvings = halvings}).mesh,
         Color(150, 195, 235), to_right, failed, true);
    m_right += width;
    return failed.size();
  }

  void write(const std::string& path) const
  {
    std::ofstream picture(path);
    m_scene.write(picture);
  }
};

int own_examples()
{
  Gallery gallery;
  gallery.add("octahedron", 1.4, 3.1, 2);
  // the values at some apexes are less: the surface is pulled to them
  SC::Smooth_surface_shape pulled;
  pulled.apex_value = [](const auto& apex, const SC::Exact_rational& value) {
    return apex.is_outer && (apex.face == 0 || apex.face == 3) ? SC::Exact_rational(value / 16) : value;
  };
  gallery.add("pulled octahedron", 1.4, 3.3, 2, pulled, "octahedron");
  gallery.add("icosahedron", 0.75, 3.2, 2);
  gallery.add("torus", 0.75, 4.6, 1);
  gallery.add("teapot", 0.85, 4.5, 2);
  const std::size_t failed = gallery.add("coarse torus", 0.75, 4.6, 1, {}, "coarse_torus");
  std::cout << "coarse torus: " << failed << " of 48 faces are not certified\n";
  gallery.write("smooth_mesh.svg");
  return 0;
}

int main(int argc, char** argv)
try {
  SC::Solver_options options;
  const std::vector<std::string> words = arguments_and_time_limit(argc, argv, options);
  if (words.empty())
    return own_examples();
  std::vector<std::string> files;
  std::optional<std::string> output;
  bool are_estimated = false;
  double chord_error = 0.01;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--estimated")
      are_estimated = true;
    else if (words[i] == "--chord-error" && i + 1 < words.size())
      chord_error = number_of<double>(words[++i]);
    else if (words[i] == "--output" && i + 1 < words.size())
      output = words[++i];
    else
      files.push_back(words[i]);
  if (files.size() != 1)
    throw SC::Invalid_input("usage: smooth_mesh FILE [--estimated] [--chord-error E] [--time-limit S] [--output OUT]");
  Mesh mesh = mesh_in(files[0]);
  const SC::Smooth_surface_3 surface = smooth(mesh, are_estimated, {}, options);
  if (output) {
    const auto triangles =
        SC::to_surface_mesh(surface, {.chord_error = chord_error}, after(surface.summary().seconds, options));
    write(*output, triangles.mesh);
    std::cout << "mesh: " << triangles.mesh.number_of_vertices() << " vertices, " << triangles.mesh.number_of_faces()
              << " triangles, error " << triangles.error << '\n';
  }
  return print(surface);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
