// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Smooth surfaces of tori with more and more faces: to make and certify them, their meshes, sides of points and hits of
// segments; and how many octahedra with perturbed gradients are certified.

#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/smooth_surfaces_3.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Vertex = Mesh::Vertex_index;

// With 2 * around * across faces.
Mesh torus(int around, int across)
{
  Mesh mesh;
  std::vector<Vertex> vertices;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      vertices.push_back(mesh.add_vertex(
          {(2 + 0.75 * std::cos(b)) * std::cos(a), (2 + 0.75 * std::cos(b)) * std::sin(a), 0.75 * std::sin(b)}));
    }
  const auto at = [&](int i, int j) { return vertices[(i % around) * across + j % across]; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

SC::Smooth_surface_3 surface_of(Mesh mesh)
{
  return SC::smooth_surface(mesh, SC::balanced_gradients(mesh, SC::estimated_normals(mesh)));
}

SC::Smooth_surface_3 smooth_torus(const benchmark::State& state)
{
  return surface_of(torus(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
}

void make(benchmark::State& state)
{
  const Mesh mesh = torus(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    const auto surface = surface_of(mesh);
    state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
    state.counters["certified"] = static_cast<double>(surface.number_of_certified_patches());
  }
}

void mesh(benchmark::State& state)
{
  const auto surface = smooth_torus(state);
  for (auto _ : state) {
    const auto triangles = SC::to_surface_mesh(surface, {.chord_error = 1e-9, .most_halvings = 2});
    state.counters["vertices"] = static_cast<double>(triangles.mesh.number_of_vertices());
  }
}

void side(benchmark::State& state)
{
  const auto surface = smooth_torus(state);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-3, 3);
  for (auto _ : state)
    benchmark::DoNotOptimize(surface.bounded_side(K::Point_3(number(random), number(random), number(random) / 3)));
}

void hits(benchmark::State& state)
{
  const auto surface = smooth_torus(state);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-3, 3);
  const auto point = [&] { return K::Point_3(number(random), number(random), number(random)); };
  for (auto _ : state)
    benchmark::DoNotOptimize(surface.intersections(K::Segment_3(point(), point())));
}

// Gradients of the sphere, whose coordinates are changed by so many percent of their length at most.
void perturbed_octahedra(benchmark::State& state)
{
  const double amplitude = static_cast<double>(state.range(0)) / 100;
  Mesh mesh;
  std::vector<Vertex> v;
  for (const double sign : {1.0, -1.0})
    for (int axis = 0; axis < 3; ++axis)
      v.push_back(mesh.add_vertex({axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0}));
  for (int octant = 0; octant < 8; ++octant) {
    const Vertex x = v[octant & 1 ? 3 : 0], y = v[octant & 2 ? 4 : 1], z = v[octant & 4 ? 5 : 2];
    const bool is_odd = ((octant & 1) + (octant >> 1 & 1) + (octant >> 2)) % 2 == 1;
    mesh.add_face(x, is_odd ? z : y, is_odd ? y : z);
  }
  const auto gradients = mesh.add_property_map<Vertex, K::Vector_3>("v:gradient").first;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-amplitude, amplitude);
  double certified = 0, refused = 0, all = 0;
  for (auto _ : state) {
    for (const Vertex vertex : mesh.vertices())
      gradients[vertex] =
          2 * (mesh.point(vertex) - CGAL::ORIGIN + K::Vector_3(number(random), number(random), number(random)));
    ++all;
    try {
      certified += SC::smooth_surface(mesh, gradients).is_complete() ? 1 : 0;
    } catch (const SC::Invalid_input&) {
      ++refused;
    }
  }
  state.counters["certified"] = certified / all;
  state.counters["refused"] = refused / all;
}

BENCHMARK(make)->Args({8, 5})->Args({16, 10})->Args({32, 20})->Unit(benchmark::kMillisecond);
BENCHMARK(mesh)->Args({8, 5})->Args({16, 10})->Args({32, 20})->Unit(benchmark::kMillisecond);
BENCHMARK(side)->Args({8, 5})->Args({16, 10})->Args({32, 20})->Unit(benchmark::kMillisecond);
BENCHMARK(hits)->Args({8, 5})->Args({16, 10})->Args({32, 20})->Unit(benchmark::kMillisecond);
BENCHMARK(perturbed_octahedra)->Arg(10)->Arg(25)->Arg(40)->Arg(50)->Iterations(200)->Unit(benchmark::kMillisecond);

} // namespace
