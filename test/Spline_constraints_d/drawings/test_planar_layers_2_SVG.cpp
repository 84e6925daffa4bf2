// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Results of all planar operations as layers: what they consist of, drawn and read back as XML, written as well-known
// text and read back by CGAL, and through the streams of CGAL.
#include <CGAL/Spline_constraints_d/IO/write_SVG_voronoi_diagram_2.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/Arr_iostream.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace planar_layers_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Layers = SC::Planar_layers_2<K>;
using Polygon = CGAL::Polygon_with_holes_2<K>;

// A closed curve, not convex, of two cubics, and a segment to the right of it.
const std::vector<Curve> outline{SC::bezier_curve(std::vector<P>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                                 SC::bezier_curve(std::vector<P>{{0, 4}, {1, 3}, {1, 1}, {0, 0}})};
const Curve segment = SC::segment_curve(P(6, 0), P(6, 3));

std::vector<std::string> names(const Layers& layers)
{
  std::vector<std::string> result;
  for (const auto& layer : layers)
    result.push_back(layer.name);
  return result;
}

// The layers of a drawing, with the numbers of their elements.
void expect_drawn(const Layers& layers)
{
  std::ostringstream out;
  {
    SC::SVG_writer picture(out, CGAL::Bbox_2(-10, -10, 20, 20));
    SC::draw(picture, layers);
  }
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  std::vector<pugi::xml_node> drawn;
  for (const pugi::xml_node& node : document.child("svg").child("g").children("g"))
    drawn.push_back(node);
  ASSERT_EQ(drawn.size(), layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ(drawn[i].attribute("inkscape:label").value(), layers[i].name);
    EXPECT_EQ(std::string(drawn[i].attribute("inkscape:groupmode").value()), "layer");
    std::size_t filled = 0, lines = 0, points = 0, holes = 0;
    for (const pugi::xml_node& path : drawn[i].children("path")) {
      const std::string data = path.attribute("d").value();
      ++(path.attribute("fill") ? filled : path.attribute("stroke-linecap") ? points : lines);
      EXPECT_TRUE(data.starts_with("M"));
      EXPECT_EQ(path.attribute(path.attribute("fill") ? "fill" : "stroke").value(), layers[i].color);
      for (std::size_t p = 1; path.attribute("fill") && p < data.size(); ++p)
        holes += data[p] == 'M';
    }
    std::size_t holes_of_layer = 0;
    for (const Polygon& area : layers[i].areas)
      holes_of_layer += area.number_of_holes();
    EXPECT_EQ(filled, layers[i].areas.size());
    EXPECT_EQ(holes, holes_of_layer);
    EXPECT_EQ(lines, layers[i].lines.size());
    EXPECT_EQ(points, layers[i].points.size());
  }
}

// The same coordinates, read back by CGAL.
void expect_written(const Layers& layers)
{
  std::stringstream text;
  SC::IO::write_WKT(text, layers);
  std::vector<P> points, expected_points;
  std::vector<std::vector<P>> lines, expected_lines;
  std::vector<Polygon> areas, expected_areas;
  std::string line;
  while (std::getline(text, line)) {
    std::istringstream one(line);
    CGAL::IO::read_WKT(one, points, lines, areas);
  }
  for (const auto& layer : layers) {
    expected_areas.insert(expected_areas.end(), layer.areas.begin(), layer.areas.end());
    expected_lines.insert(expected_lines.end(), layer.lines.begin(), layer.lines.end());
    expected_points.insert(expected_points.end(), layer.points.begin(), layer.points.end());
  }
  EXPECT_EQ(points, expected_points);
  EXPECT_EQ(lines, expected_lines);
  EXPECT_EQ(areas, expected_areas);
}

// Polygons, through the operators of CGAL.
void expect_streamed(const Layers& layers)
{
  for (const auto& layer : layers)
    for (const Polygon& area : layer.areas) {
      std::stringstream stream;
      stream.precision(17);
      stream << area;
      Polygon back;
      stream >> back;
      EXPECT_EQ(back, area);
    }
}

void expect_layers(const Layers& layers, const std::vector<std::string>& expected)
{
  EXPECT_EQ(names(layers), expected);
  for (const auto& layer : layers) {
    EXPECT_FALSE(layer.areas.empty() && layer.lines.empty() && layer.points.empty());
    for (const auto& line : layer.lines)
      EXPECT_GE(line.size(), 2U);
  }
  expect_drawn(layers);
  expect_written(layers);
  expect_streamed(layers);
}

double area(const Layers& layers)
{
  double result = 0;
  for (const Polygon& polygon : layers.at(0).areas) {
    result += polygon.outer_boundary().area();
    for (const auto& hole : polygon.holes())
      result += hole.area();
  }
  return result;
}

TEST(Planar_layers, Diagrams)
{
  std::vector<Curve> curves = outline;
  curves.push_back(segment);
  const auto diagram = SC::voronoi_diagram(curves);
  ASSERT_TRUE(diagram.is_complete());
  const Layers layers = SC::planar_layers(diagram, 0.01, 20);
  expect_layers(layers, {"edges", "vertices"});
  EXPECT_LE(layers[0].lines.size() + layers[0].points.size(), diagram.edges().size());
  const Layers axis = SC::planar_layers(SC::medial_axis(SC::planar_region(outline)), 0.01, 20);
  EXPECT_EQ(names(axis).front(), "edges");
  expect_written(axis);
}

TEST(Planar_layers, BisectorsAndSectors)
{
  expect_layers(SC::planar_layers(SC::trimmed_bisector(outline[0], segment), 0.01, 20), {"bisector"});
  expect_layers(SC::planar_layers(SC::trimmed_alpha_sector(segment, P(2, 1), 0.25), 0.01), {"sector"});
  EXPECT_THROW((void)SC::planar_layers(SC::trimmed_alpha_sector(segment, P(2, 1), 0.25), 0.), SC::Invalid_input);
}

// Of a segment of the length 3: two segments and two half circles.
TEST(Planar_layers, Offsets)
{
  const Layers layers = SC::planar_layers(SC::trimmed_offset(std::vector<Curve>{segment}, 1), 1e-4);
  expect_layers(layers, {"area", "curve", "circle"});
  EXPECT_NEAR(area(layers), 6 + 3.14159265358979, 0.01);
  EXPECT_EQ(layers[1].lines.size(), 2U);
  EXPECT_EQ(layers[2].lines.size(), 2U);
  // a ring
  expect_layers(SC::planar_layers(SC::trimmed_offset(std::vector<Curve>{SC::circle_curve(P(0, 0), 3.)}, 1), 1e-2),
                {"area", "curve"});
}

TEST(Planar_layers, RegionsAndSums)
{
  const auto region = SC::planar_region(outline);
  const double exact = SC::to_nearest_double(region.area().first);
  const Layers layers = SC::planar_layers(region, 1e-3);
  expect_layers(layers, {"area"});
  EXPECT_NEAR(area(layers), exact, 0.02);
  const Layers sum =
      SC::planar_layers(SC::minkowski_sum(region, SC::planar_region(SC::circle_curve(P(0, 0), 1.))), 1e-3);
  expect_layers(sum, {"area", "boundary"});
  EXPECT_GT(area(sum), exact + 3);
  expect_layers(SC::planar_layers(SC::swept_area(region, segment), 1e-3), {"area", "boundary"});
}

TEST(Planar_layers, HullsKernelsAndVisibleParts)
{
  const Layers hull = SC::planar_layers(SC::convex_hull(outline), 1e-3);
  expect_layers(hull, {"area", "arc", "segment"});
  EXPECT_GT(area(hull), SC::to_nearest_double(SC::planar_region(outline).area().first));
  expect_layers(SC::planar_layers(SC::region_kernel(SC::planar_region(outline)), 1e-3), {"area", "arc", "segment"});
  EXPECT_EQ(names(SC::planar_layers(SC::visible_part(P(2, 2), outline), 1e-3)),
            (std::vector<std::string>{"area", "arc"}));
  expect_layers(SC::planar_layers(SC::visible_part(P(2, 2), std::vector<Curve>{segment}), 1e-3),
                {"area", "arc", "open"});
  const std::vector<Curve> rings{SC::circle_curve(P(0, 0), 3.), SC::circle_curve(P(0, 0), 1.)};
  EXPECT_TRUE(SC::planar_layers(SC::region_kernel(SC::planar_region(rings)), 1e-3).empty());
}

TEST(Planar_layers, Distances)
{
  const auto distance = SC::region_distance(SC::planar_region(SC::circle_curve(P(0, 0), 1.)),
                                            SC::planar_region(SC::circle_curve(P(5, 0), 1.)));
  const Layers layers = SC::planar_layers(distance, 1.);
  expect_layers(layers, {"distance"});
  EXPECT_NEAR(CGAL::squared_distance(layers[0].lines.at(0)[0], layers[0].lines[0][1]), 9, 1e-6);
}

// The edges of a diagram, as an arrangement of CGAL that is written and read.
TEST(Planar_layers, ArrangementsThroughStreams)
{
  using Traits = CGAL::Arr_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Arrangement = CGAL::Arrangement_2<Traits>;
  const auto diagram = SC::voronoi_diagram(outline);
  Arrangement arrangement, back;
  std::vector<Traits::Curve_2> chords;
  const auto exact = [](const P& p) { return Traits::Point_2(p.x(), p.y()); };
  const Layers layers = SC::planar_layers(diagram, 0.1, 10);
  for (const auto& line : layers.at(0).lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      if (line[i - 1] != line[i])
        chords.emplace_back(exact(line[i - 1]), exact(line[i]));
  CGAL::insert(arrangement, chords.begin(), chords.end());
  std::stringstream stream;
  stream.precision(17);
  stream << arrangement;
  stream >> back;
  EXPECT_GT(back.number_of_edges(), diagram.edges().size());
  EXPECT_EQ(back.number_of_edges(), arrangement.number_of_edges());
  EXPECT_EQ(back.number_of_faces(), arrangement.number_of_faces());
}

// With the pixel of a drawing as the error; the overload for results.
TEST(Planar_layers, DrawnInOneCall)
{
  const auto diagram = SC::voronoi_diagram(outline);
  std::ostringstream out;
  {
    SC::SVG_writer picture(out, CGAL::Bbox_2(-1, -1, 7, 5));
    SC::draw(picture, SC::convex_hull(outline));
    SC::draw(picture, diagram);
  }
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  std::vector<std::string> labels;
  for (const pugi::xml_node& node : document.child("svg").child("g").children("g"))
    labels.emplace_back(node.attribute("inkscape:label").value());
  ASSERT_GE(labels.size(), 4U);
  EXPECT_EQ(labels[0], "area");
  EXPECT_EQ(labels[3], "edges");
  std::ostringstream text;
  SC::IO::write_WKT(text, SC::convex_hull(outline), 0.01);
  EXPECT_TRUE(text.str().starts_with("POLYGON (("));
  std::ostringstream text_of_axis;
  SC::IO::write_WKT(text_of_axis, diagram, 0.01, 10);
  EXPECT_TRUE(text_of_axis.str().starts_with("MULTILINESTRING (("));
}

} // namespace planar_layers_test
