// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Are zeros of polynomials in tetrahedra convex, with the solid where the polynomial is negative? Told by proof: of the
// polynomial as a function, and of the patch, which may be convex where the function is not. Draws the patches into
// implicit_patches.svg: green where they are convex, red where they are not, with a witness in each red part. Of the
// cubic, also the curves between these parts, and a convex function near it.

#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/nearby_convex_function.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/parabolic_curves.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/patch_convexity.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Polynomial = SC::Power_polynomial;
using Form = SC::Simplex_function_3::Form;
using Color = CGAL::IO::Color;

const Color convex(110, 180, 110), not_convex(225, 105, 90);
const K::Tetrahedron_3 tetrahedron({-1, -0.75, 0}, {1, -0.75, 0}, {0, 1, 0}, {0, 0, 1.5});

// The patch as triangles, cut where the curvature changes its sign.
SC::Solution_surface_mesh mesh_of(const SC::Simplex_function_3& patch)
{
  SC::Constraint_system_d system({{-1, 1}, {-1, 1}, {0, 1.5}});
  const Polynomial f = patch.polynomial();
  system.add(f, SC::Relation::EQUAL);
  for (int i = 0; i < 4; ++i) {
    std::array<SC::Exact_rational, 4> height{};
    height[i] = SC::Exact_rational(1);
    system.add(SC::Simplex_function_3(tetrahedron, Form::affine(height)).polynomial(), SC::Relation::GREATER_EQUAL);
  }
  const auto [gaussian, mean] = SC::curvature_polynomials(f);
  std::vector<SC::Spline_function> features;
  if (!gaussian.is_constant())
    features.push_back(gaussian);
  return SC::to_surface_mesh(SC::solve_surfaces(system, features), {.chord_error = 0.004});
}

// The point of the patch on the segment of a witness, nearly.
K::Point_3 point_on_patch(const SC::Simplex_function_3& patch, const SC::Curvature_witness& witness)
{
  auto first = witness.first, second = witness.second;
  for (int step = 0; step < 20; ++step) {
    const auto middle = CGAL::midpoint(first, second);
    (patch.sign_at(middle) == CGAL::POSITIVE ? second : first) = middle;
  }
  return {CGAL::to_double(first.x()), CGAL::to_double(first.y()), CGAL::to_double(first.z())};
}

void draw(SC::Scene_3& scene, const SC::Simplex_function_3& patch, const SC::Patch_shape& shape,
          const K::Vector_3& place)
{
  const auto [gaussian, mean] = SC::curvature_polynomials(patch.polynomial());
  auto surface = mesh_of(patch);
  auto& mesh = surface.mesh;
  const auto color_of = [&](const auto& face) {
    std::vector<SC::Exact_rational> center(3);
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      for (int i = 0; i < 3; ++i)
        center[i] += SC::Exact_rational((mesh.point(vertex)[i] - place[i]) / 3);
    return gaussian(center) >= 0 && mean(center) >= 0 ? convex : not_convex;
  };
  for (const auto vertex : mesh.vertices())
    mesh.point(vertex) = mesh.point(vertex) + place;
  scene.add(mesh, {}, color_of);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      scene.add_polyline(std::vector<K::Point_3>{tetrahedron[i] + place, tetrahedron[j] + place},
                         {.color = "#506080", .hidden = SC::Hidden_line::THIN});
  if (const auto& witness = shape.witness_against_convexity())
    scene.add_point(point_on_patch(patch, *witness) + place,
                    {.width = 8, .hidden = SC::Hidden_line::THIN, .nearer = 0.1});
  std::ostringstream kind;
  kind << shape.kind();
  scene.add_point(K::Point_3(-0.9, -0.75, -0.6) + place, {.width = 0.1}, kind.str());
}

int main()
{
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), z = Polynomial::variable(2);
  struct Example
  {
    std::string name;
    Polynomial function;
  };
  const std::vector<Example> examples{
      {"hyperboloid of two sheets", x * x + y * y - (z - Polynomial(1.25)) * (z - Polynomial(1.25)) + Polynomial(0.25)},
      {"parabolic cylinder", z + Polynomial(0.75) * x * x - Polynomial(0.625)},
      {"cubic", z + x * x * x + Polynomial(0.5) * y * y - Polynomial(0.25) * x - Polynomial(0.5)},
      {"saddle", z - x * x + y * y - Polynomial(0.5)}};
  SC::Scene_3 scene({.to_viewer = {0.2, -0.85, 0.45}, .width = 900});
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const SC::Simplex_function_3 patch(tetrahedron, examples[i].function);
    const SC::Patch_shape shape = SC::patch_convexity(patch);
    std::cout << examples[i].name << ": function " << SC::function_convexity(patch).kind() << ", patch " << shape.kind()
              << '\n';
    if (const auto& witness = shape.witness_against_convexity())
      std::cout << "  not convex between (" << witness->first << ") and (" << witness->second << "), along grad f x ("
                << witness->axis << ")\n";
    if (i == 2) {
      std::cout << "  parabolic curves: " << SC::parabolic_curves(patch) << '\n';
      if (const auto nearby = SC::nearby_convex_function(patch))
        std::cout << "  nearest of some convex functions: function " << SC::function_convexity(*nearby).kind()
                  << ", patch " << SC::patch_convexity(*nearby).kind() << '\n';
    }
    draw(scene, patch, shape, 2.3 * static_cast<double>(i) * K::Vector_3(0.973, 0.229, 0));
  }
  std::ofstream picture("implicit_patches.svg");
  scene.write(picture);
  return picture ? 0 : 1;
}
