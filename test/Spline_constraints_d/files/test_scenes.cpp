// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Scenes: the facet that is painted last over a point is the nearest one there; parts of lines are visible or hidden as
// a test of each of their points with all triangles says; bad input.
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Hidden_parts.h>
#include <CGAL/Spline_constraints_d/IO/internal/scene/Painters_order.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace scenes_test {

namespace SC = CGAL::Spline_constraints;
namespace Scene = SC::internal::Scene;

namespace {

using K = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using SC::Exact_rational;

constexpr std::array<double, 4> picture{0, 0, 1000, 1000};

Scene::Grid_point random_point(std::mt19937& random, int from = 0, int to = 1000)
{
  std::uniform_int_distribution<int> coordinate(from, to);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

Scene::Grid_triangle counterclockwise(Scene::Grid_triangle triangle)
{
  if (Scene::turn(triangle[0], triangle[1], triangle[2]) < 0)
    std::swap(triangle[1], triangle[2]);
  return triangle;
}

std::vector<Scene::Grid_triangle> random_triangles(std::mt19937& random, int number, int size)
{
  std::vector<Scene::Grid_triangle> result;
  std::uniform_int_distribution<int> offset(-size, size);
  for (int i = 0; i < number; ++i) {
    Scene::Grid_triangle triangle;
    triangle.fill(random_point(random, size, 1000 - size));
    for (Scene::Grid_point& corner : triangle)
      for (auto& x : corner)
        x += offset(random);
    result.push_back(counterclockwise(triangle));
  }
  return result;
}

// The depth of a triangle over a point of the picture, if it covers that one.
std::optional<Exact_rational> depth(const Scene::Grid_triangle& triangle, const Exact_rational& x,
                                    const Exact_rational& y)
{
  std::array<Scene::Exact_point, 3> exact;
  for (int i = 0; i < 3; ++i)
    exact[i] = Scene::Facet::exact(triangle[i]);
  const Exact_rational area = Scene::turn(exact[0], exact[1], exact[2]);
  const Scene::Exact_point p{x, y, Exact_rational(0)};
  if (area == 0 || !Scene::Facet_pair<Exact_rational>::covers(exact, p))
    return std::nullopt;
  return Exact_rational(-Scene::height_over(exact, p) / area);
}

// Samples of the picture, on no edge of a triangle.
void expect_nearest_on_top(const std::vector<Scene::Grid_triangle>& triangles, const std::vector<Scene::Facet>& facets,
                           std::mt19937& random)
{
  int covered = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Scene::Grid_point at = random_point(random);
    const Exact_rational x = Exact_rational(static_cast<double>(at[0])) + Exact_rational(1) / 1009,
                         y = Exact_rational(static_cast<double>(at[1])) + Exact_rational(1) / 1013;
    std::optional<Exact_rational> nearest;
    for (const auto& triangle : triangles)
      if (const auto here = depth(triangle, x, y); here && (!nearest || *here > *nearest))
        nearest = here;
    std::optional<std::size_t> top;
    for (const Scene::Facet& facet : facets)
      if (Scene::Facet_pair<Exact_rational>::covers(facet.outline(), Scene::Exact_point{x, y, Exact_rational(0)}))
        top = facet.source;
    ASSERT_EQ(top.has_value(), nearest.has_value());
    covered += top.has_value();
    if (top) {
      ASSERT_GE(*depth(triangles[*top], x, y), *nearest - 2) << "at " << at[0] << ' ' << at[1];
    }
  }
  EXPECT_GT(covered, 20);
}

Mesh sheet(double height, int faces_per_side)
{
  Mesh result;
  std::vector<Mesh::Vertex_index> vertices;
  for (int i = 0; i <= faces_per_side; ++i)
    for (int j = 0; j <= faces_per_side; ++j)
      vertices.push_back(result.add_vertex(K::Point_3(i, j, height)));
  const auto at = [&](int i, int j) { return vertices[i * (faces_per_side + 1) + j]; };
  for (int i = 0; i < faces_per_side; ++i)
    for (int j = 0; j < faces_per_side; ++j) {
      result.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      result.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return result;
}

std::string drawn(const SC::Scene_3& scene)
{
  std::ostringstream out;
  scene.write(out);
  return out.str();
}

std::size_t count(const std::string& text, const std::string& word)
{
  std::size_t result = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++result;
  return result;
}

const SC::View_3 from_above{.to_viewer = {0, 0, 1}, .up = {0, 1, 0}, .width = 400};

} // namespace

// They pass through each other, and there are circles.
TEST(Scenes, The_nearest_facet_is_on_top)
{
  std::mt19937 random(7);
  for (const auto& [number, size] : {std::pair(8, 400), std::pair(30, 200), std::pair(200, 60)}) {
    const auto triangles = random_triangles(random, number, size);
    const auto facets = Scene::Painters_order(picture, triangles, 100000).facets();
    EXPECT_GE(facets.size(), triangles.size() - 1);
    expect_nearest_on_top(triangles, facets, random);
  }
}

TEST(Scenes, Facets_that_cover_each_other_in_a_circle_are_split)
{
  // Three bars, each over the next one, none through another.
  std::vector<Scene::Grid_triangle> triangles;
  const std::array<std::array<std::int64_t, 2>, 3> corners{{{100, 100}, {900, 100}, {500, 800}}};
  for (int i = 0; i < 3; ++i) {
    const auto &from = corners[i], &to = corners[(i + 1) % 3];
    const std::array<std::int64_t, 2> along{(to[0] - from[0]) / 4, (to[1] - from[1]) / 4};
    triangles.push_back(counterclockwise({Scene::Grid_point{from[0] - along[0], from[1] - along[1], 100},
                                          Scene::Grid_point{to[0] + along[0], to[1] + along[1], 500},
                                          Scene::Grid_point{to[0] + along[0], to[1] + along[1] + 90, 500}}));
  }
  const auto facets = Scene::Painters_order(picture, triangles, 100000).facets();
  EXPECT_GT(facets.size(), 3u);
  std::mt19937 random(1);
  expect_nearest_on_top(triangles, facets, random);
}

TEST(Scenes, Facets_at_the_same_depth_are_painted_in_their_order)
{
  const Scene::Grid_triangle triangle{Scene::Grid_point{0, 0, 5}, {900, 0, 5}, {0, 900, 5}};
  const Scene::Grid_triangle small{Scene::Grid_point{100, 100, 5}, {300, 100, 5}, {100, 300, 5}};
  for (const auto& triangles : {std::vector{triangle, small}, std::vector{small, triangle}}) {
    const auto facets = Scene::Painters_order(picture, triangles, 100000).facets();
    ASSERT_EQ(facets.size(), 2u);
    EXPECT_EQ(facets[0].source, 0u);
    EXPECT_EQ(facets[1].source, 1u);
  }
}

TEST(Scenes, Parts_of_segments_are_hidden_where_a_triangle_is_before_them)
{
  std::mt19937 random(11);
  int hidden_parts = 0, visible_parts = 0;
  for (int repetition = 0; repetition < 20; ++repetition) {
    const auto triangles = random_triangles(random, 60, 150);
    const Scene::Hidden_parts hidden(picture, triangles);
    for (int segment = 0; segment < 20; ++segment) {
      const Scene::Grid_point p = random_point(random), q = random_point(random);
      const auto parts = hidden.parts(p, q);
      ASSERT_FALSE(parts.empty());
      EXPECT_EQ(parts.front().begin, 0);
      EXPECT_EQ(parts.back().end, 1);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_LT(parts[i].begin, parts[i].end);
        if (i > 0) {
          EXPECT_EQ(parts[i].begin, parts[i - 1].end);
        }
        (parts[i].is_hidden ? hidden_parts : visible_parts) += 1;
        for (int k = 1; k < 8; ++k) {
          const Exact_rational t = parts[i].begin + (parts[i].end - parts[i].begin) * k / 8;
          Scene::Exact_point at;
          for (int c = 0; c < 3; ++c)
            at[c] = Exact_rational(static_cast<double>(p[c])) + t * static_cast<double>(q[c] - p[c]);
          const bool is_behind = std::any_of(triangles.begin(), triangles.end(), [&](const auto& triangle) {
            const auto here = depth(triangle, at[0], at[1]);
            return here && *here > at[2];
          });
          ASSERT_EQ(is_behind, parts[i].is_hidden);
        }
      }
    }
  }
  EXPECT_GT(hidden_parts, 100);
  EXPECT_GT(visible_parts, 100);
}

TEST(Scenes, A_sheet_hides_what_is_below)
{
  SC::Scene_3 scene(from_above);
  scene.add(sheet(1, 4), {.color = CGAL::IO::Color(200, 0, 0), .has_edges = false});
  EXPECT_EQ(count(drawn(scene), "Z'"), 32u);
  scene.add_polyline(std::vector{K::Point_3(-2, 2, 0), K::Point_3(6, 2, 0)}, {.color = "blue"});
  EXPECT_EQ(count(drawn(scene), "'blue'"), 2u);   // left and right
  scene.add_polyline(std::vector{K::Point_3(1, 1, 1), K::Point_3(3, 2, 1)}, {.color = "green"});
  EXPECT_EQ(count(drawn(scene), "'green'"), 1u);   // on it
  scene.add_polyline(std::vector{K::Point_3(1, 1, 0.5), K::Point_3(3, 2, 0.5)}, {.color = "gray", .nearer = 0.6});
  EXPECT_EQ(count(drawn(scene), "'gray'"), 1u);
  scene.add_polyline(std::vector{K::Point_3(1, 1, 0), K::Point_3(3, 2, 0)},
                     {.color = "black", .hidden = SC::Hidden_line::THIN});
  EXPECT_EQ(count(drawn(scene), "'black'"), 1u);
  scene.add_polyline(std::vector{K::Point_3(1, 1, 0), K::Point_3(3, 2, 0)},
                     {.color = "brown", .hidden = SC::Hidden_line::DASHED});
  EXPECT_GT(count(drawn(scene), "'brown'"), 5u);
  scene.add_point(K::Point_3(2, 2, 0), {.color = "yellow"}, "below");
  scene.add_point(K::Point_3(2, 2, 2), {.color = "yellow"}, "above");
  EXPECT_EQ(count(drawn(scene), "yellow"), 1u);
  EXPECT_EQ(count(drawn(scene), "below"), 0u);
  EXPECT_EQ(count(drawn(scene), "above"), 1u);
}

// Seen from above, the boundary of a sheet; of a roof, its ridge, too; no back.
TEST(Scenes, Boundaries_and_creases_are_drawn)
{
  const SC::Face_style_3 style{.color = CGAL::IO::Color(100, 100, 100), .back = CGAL::IO::Color(0, 0, 250)};
  SC::Scene_3 flat(from_above), folded(from_above), turned({.to_viewer = {0, 0, -1}, .up = {0, 1, 0}});
  flat.add(sheet(1, 1), style);
  turned.add(sheet(1, 1), style);
  Mesh roof = sheet(0, 1);
  for (const auto vertex : roof.vertices())
    roof.point(vertex) = K::Point_3(roof.point(vertex).x(), roof.point(vertex).y(),
                                    std::abs(roof.point(vertex).x() - roof.point(vertex).y()));
  folded.add(roof, style);
  EXPECT_EQ(count(drawn(flat), "#282828"), 4u);
  EXPECT_EQ(count(drawn(folded), "#282828"), 5u);
  EXPECT_EQ(count(drawn(flat), "fill='#0000"), 0u);
  EXPECT_EQ(count(drawn(turned), "fill='#0000"), 2u);
}

TEST(Scenes, Faces_have_colors_of_their_own)
{
  SC::Scene_3 scene(from_above);
  scene.add(sheet(0, 2), {.has_edges = false},
            [](const auto face) { return face % 2 == 0 ? CGAL::IO::Color(255, 0, 0) : CGAL::IO::Color(0, 255, 0); });
  const std::string text = drawn(scene);
  EXPECT_EQ(count(text, "0000' stroke-width"), 4u);
  EXPECT_EQ(count(text, "fill='#00"), 4u);
}

TEST(Scenes, Bad_input)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SC::Scene_3({.to_viewer = {0, 0, 0}}), SC::Invalid_input);
  EXPECT_THROW(SC::Scene_3({.to_viewer = {0, 0, -2}}), SC::Invalid_input);   // up
  EXPECT_THROW(SC::Scene_3({.to_viewer = {nan, 0, 1}}), SC::Invalid_input);
  EXPECT_THROW(SC::Scene_3({.up = {0, infinity, 1}}), SC::Invalid_input);
  EXPECT_THROW(SC::Scene_3({.width = 0}), SC::Invalid_input);
  EXPECT_THROW(SC::Scene_3({.width = nan}), SC::Invalid_input);
  SC::Scene_3 scene;
  EXPECT_THROW(drawn(scene), SC::Invalid_input);
  scene.add_point(K::Point_3(1, 2, 3), {});
  EXPECT_THROW(drawn(scene), SC::Invalid_input);
  EXPECT_THROW(scene.add_point(K::Point_3(1, nan, 3), {}), SC::Invalid_input);
  EXPECT_THROW(scene.add_point(K::Point_3(1, 2, 3), {.width = -1}), SC::Invalid_input);
  EXPECT_THROW(scene.add_polyline(std::vector{K::Point_3(1, 2, infinity)}), SC::Invalid_input);
  Mesh mesh = sheet(0, 1);
  mesh.point(*mesh.vertices().begin()) = K::Point_3(0, 0, infinity);
  EXPECT_THROW(scene.add(mesh), SC::Invalid_input);
  Mesh square;
  square.add_face(square.add_vertex(K::Point_3(0, 0, 0)), square.add_vertex(K::Point_3(1, 0, 0)),
                  square.add_vertex(K::Point_3(1, 1, 0)), square.add_vertex(K::Point_3(0, 1, 0)));
  EXPECT_THROW(scene.add(square), SC::Invalid_input);
}

} // namespace scenes_test
