// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polygons known up to bands: numbers of signatures, models against exact point location, a model for each signature,
// what is refused, and limits.
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/approximate_polygons_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace approximate_polygons_2_test {

namespace SC = CGAL::Spline_constraints;
using R = SC::Exact_rational;
using Approximate = SC::Approximate_polygon_2;
using K = Approximate::Kernel;
using P = K::Point_2;
using Polygon = CGAL::Polygon_2<K>;
using Location = SC::Signature_location;
using Ratios = std::vector<std::pair<R, R>>;

namespace {

Polygon polygon(const std::vector<P>& corners) { return Polygon(corners.begin(), corners.end()); }

// Clockwise: left, top, right, bottom.
Polygon square() { return polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}}); }

Polygon letter_L() { return polygon({{0, 0}, {0, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 0}}); }

std::vector<std::string> all_signatures(std::size_t size)
{
  std::vector<std::string> result{""};
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<std::string> longer;
    for (const std::string& s : result)
      for (const char side : {'L', 'R'})
        longer.push_back(s + side);
    result = std::move(longer);
  }
  return result;
}

std::set<std::string> signatures_of(const SC::Signature_cells_2& cells, std::optional<Location> location = {})
{
  std::set<std::string> result;
  for (const SC::Signature_cell_2& cell : cells.cells())
    if (!location || cell.location == *location)
      result.insert(cell.signature);
  return result;
}

Location location_in(const Polygon& model, const P& p)
{
  return model.bounded_side(p) == CGAL::ON_BOUNDED_SIDE ? Location::INSIDE : Location::OUTSIDE;
}

std::string refusal(const Polygon& polygon, const R& half_width)
{
  try {
    SC::approximate_polygon(polygon, half_width);
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "";
}

using Random = std::mt19937;

R random_number(Random& random, int least, int greatest)
{
  return R(std::uniform_int_distribution<int>(least, greatest)(random));
}

// A polygon around the origin, in one orientation or the other, often with bands as wide as they can be.
std::optional<Approximate> random_polygon(Random& random, std::size_t size)
{
  static constexpr std::array<std::array<int, 2>, 12> directions{
      {{4, 0}, {4, 2}, {2, 4}, {0, 4}, {-2, 4}, {-4, 2}, {-4, 0}, {-4, -2}, {-2, -4}, {0, -4}, {2, -4}, {4, -2}}};
  std::vector<std::size_t> chosen(directions.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = i;
  std::shuffle(chosen.begin(), chosen.end(), random);
  chosen.resize(size);
  std::sort(chosen.begin(), chosen.end());
  if (random() % 2 == 0)
    std::reverse(chosen.begin(), chosen.end());
  Polygon result;
  for (const std::size_t i : chosen) {
    const R radius = random_number(random, 3, 25);
    result.push_back(P(R(radius * directions[i][0]), R(radius * directions[i][1])));
  }
  const bool is_clockwise = CGAL::is_negative(result.area());
  for (int steps = 64; steps > 1; steps /= 2) {
    std::vector<SC::Edge_strip_2> strips;
    for (std::size_t i = 0; i < size; ++i) {
      const auto edge = result[(i + 1) % size] - result[i];
      const auto outwards = edge.perpendicular(is_clockwise ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
      strips.push_back({result[i] - R(random_number(random, 1, steps) / 256) * outwards,
                        result[i] + R(random_number(random, 0, steps) / 256) * outwards});
    }
    try {
      return Approximate(result, strips);
    } catch (const SC::Invalid_input&) {
    }
  }
  return std::nullopt;
}

Polygon random_model(Random& random, const Approximate& approximate)
{
  Ratios ratios;
  for (std::size_t i = 0; i < approximate.size(); ++i)
    ratios.emplace_back(R(random_number(random, 0, 8) / 8), R(random_number(random, 0, 8) / 8));
  return approximate.model(ratios);
}

// Near the polygon, far away, in a band, or on a side of it but in one point.
P random_point(Random& random, const Approximate& approximate)
{
  const auto around = [&](int size) {
    return P(random_number(random, -size, size), random_number(random, -size, size));
  };
  if (random() % 4 == 0)
    return around(random() % 2 == 0 ? 120 : 2000);
  const Polygon band = approximate.band(random() % approximate.size());
  K::Vector_2 sum = CGAL::NULL_VECTOR;
  R weights(0);
  for (const P& corner : band.vertices()) {
    const R weight = random_number(random, 0, 6);
    weights += weight;
    sum = sum + weight * (corner - CGAL::ORIGIN);
  }
  return weights == 0 ? band[0] : CGAL::ORIGIN + sum / weights;
}

P center(const Polygon& part)
{
  K::Vector_2 sum = CGAL::NULL_VECTOR;
  for (const P& corner : part.vertices())
    sum = sum + (corner - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / R(static_cast<unsigned long>(part.size()));
}

// The four lines of which one is on a side of a point if any line through both ends of a band is, as ratios.
std::optional<std::pair<R, R>> extreme_line(const Approximate& approximate, std::size_t edge, const P& p, char side)
{
  const Polygon band = approximate.band(edge);
  const CGAL::Sign outer = CGAL::orientation(band[0], band[1], band[2]);
  for (const int tail : {0, 1})
    for (const int head : {0, 1})
      if (CGAL::orientation(band[tail == 0 ? 0 : 3], band[head == 0 ? 1 : 2], p) == (side == 'L' ? outer : -outer))
        return std::pair(R(tail), R(head));
  return std::nullopt;
}

// Each part of each cell has a model in which its center has the signature, and the location.
void expect_models(const Approximate& approximate, const SC::Signature_cells_2& cells)
{
  for (const SC::Signature_cell_2& cell : cells.cells()) {
    ASSERT_FALSE(cell.parts.empty());
    for (const Polygon& part : cell.parts) {
      EXPECT_TRUE(part.is_convex() && part.is_counterclockwise_oriented());
      const P p = center(part);
      Ratios ratios;
      for (std::size_t i = 0; i < approximate.size(); ++i) {
        const auto line = extreme_line(approximate, i, p, cell.signature[i]);
        ASSERT_TRUE(line.has_value());
        ratios.push_back(*line);
      }
      const Polygon model = approximate.model(ratios);
      EXPECT_TRUE(model.is_simple() && approximate.is_model(model));
      EXPECT_EQ(approximate.signature(model, p), cell.signature);
      EXPECT_EQ(location_in(model, p), cell.location);
    }
  }
}

// A point is in the cells of the signatures that it has with extreme lines, and in no other ones.
void expect_cells_of_point(const Approximate& approximate, const SC::Signature_cells_2& cells, const P& p)
{
  std::vector<std::string> expected{""};
  for (std::size_t i = 0; i < approximate.size(); ++i) {
    std::vector<std::string> longer;
    for (const char side : {'L', 'R'})
      if (extreme_line(approximate, i, p, side))
        for (const std::string& s : expected)
          longer.push_back(s + side);
    expected = std::move(longer);
  }
  for (const std::string& s : expected) {
    const SC::Signature_cell_2* cell = cells.find(s);
    ASSERT_NE(cell, nullptr) << s;
    if (cells.window().has_on_bounded_side(p)) {
      EXPECT_TRUE(std::any_of(cell->parts.begin(), cell->parts.end(),
                              [&](const Polygon& part) { return !part.has_on_unbounded_side(p); }));
    }
  }
  for (const SC::Signature_cell_2& cell : cells.cells())
    if (std::find(expected.begin(), expected.end(), cell.signature) == expected.end()) {
      EXPECT_TRUE(std::none_of(cell.parts.begin(), cell.parts.end(),
                               [&](const Polygon& part) { return part.has_on_bounded_side(p); }));
    }
}

} // namespace

TEST(Approximate_polygons, Square_has_13_of_16_signatures)
{
  for (const R& width : {R(1), R(R(1) / 2), R(R(1) / 1000)}) {
    const Approximate approximate = SC::approximate_polygon(square(), R(width / 2));
    const SC::Signature_cells_2 cells = SC::signature_cells(approximate);
    EXPECT_TRUE(cells.is_complete() && cells.undecided().empty());
    std::set<std::string> missing;
    for (const std::string& s : all_signatures(4))
      if (cells.find(s) == nullptr)
        missing.insert(s);
    EXPECT_EQ(missing, (std::set<std::string>{"LLLL", "LRLR", "RLRL"}));
    EXPECT_EQ(signatures_of(cells, Location::INSIDE), std::set<std::string>{"RRRR"});
    P lowest(0, 1000000);
    for (const Polygon& part : cells.find("LLLR")->parts)
      lowest = (std::min)(lowest, *part.bottom_vertex(), [](const P& p, const P& q) { return p.y() < q.y(); });
    EXPECT_EQ(lowest, P(2, R(4 + 8 / width)));
    // four cells begin at that distance: for narrow bands, nine are left near the square, as for a square with edges
    const auto is_near = [](const Polygon& part) {
      return std::any_of(part.begin(), part.end(),
                         [](const P& p) { return CGAL::abs(p.x() - 2) < 6 && CGAL::abs(p.y() - 2) < 6; });
    };
    const auto near = std::count_if(cells.cells().begin(), cells.cells().end(), [&](const SC::Signature_cell_2& cell) {
      return std::any_of(cell.parts.begin(), cell.parts.end(), is_near);
    });
    EXPECT_EQ(near, 9) << width;
    expect_models(approximate, cells);
  }
}

TEST(Approximate_polygons, L_has_32_of_64_signatures)
{
  const Approximate approximate = SC::approximate_polygon(letter_L(), R(1) / 4);
  const SC::Signature_cells_2 cells = SC::signature_cells(approximate);
  EXPECT_TRUE(cells.is_complete());
  EXPECT_EQ(cells.cells().size(), 32u);
  EXPECT_EQ(signatures_of(cells, Location::INSIDE), (std::set<std::string>{"RRRRRR", "RRRLRR", "RRRRLR"}));
  EXPECT_TRUE(approximate.is_reflex(4));
  for (const std::size_t edge : {0, 1, 2, 3, 5})
    EXPECT_FALSE(approximate.is_reflex(edge));
  EXPECT_EQ(approximate.band(3),
            polygon({{R(25) / 4, R(13) / 4}, {R(11) / 4, R(13) / 4}, {R(11) / 4, R(11) / 4}, {R(25) / 4, R(11) / 4}}));

  expect_models(approximate, cells);
}

TEST(Approximate_polygons, Edges_keep_their_numbers_in_both_orientations)
{
  Polygon reversed = letter_L();
  reversed.reverse_orientation(); // begins with the same vertex
  const auto cells = SC::signature_cells(SC::approximate_polygon(letter_L(), R(1) / 4)),
             reversed_cells = SC::signature_cells(SC::approximate_polygon(reversed, R(1) / 4));
  for (std::string s : all_signatures(6)) {
    const auto* cell = cells.find(s);
    std::reverse(s.begin(), s.end());
    const auto* reversed_cell = reversed_cells.find(s);
    ASSERT_EQ(cell == nullptr, reversed_cell == nullptr);
    if (cell != nullptr) {
      EXPECT_EQ(cell->location, reversed_cell->location);
    }
  }
}

// A million points with `--gtest_repeat=10`: each time has a seed of its own.
TEST(Approximate_polygons, Models_against_exact_point_location)
{
  static unsigned seed = 1991;
  Random random(seed++);
  int cases = 0, inside = 0, uncertain = 0, reflex = 0;
  while (cases < 100000) {
    const auto approximate = random_polygon(random, 3 + random() % 6);
    if (!approximate)
      continue;
    for (std::size_t i = 0; i < approximate->size(); ++i)
      reflex += approximate->is_reflex(i);
    std::map<std::string, Location> known;
    for (int m = 0; m < 20; ++m) {
      const Polygon model = random_model(random, *approximate);
      ASSERT_TRUE(model.is_simple() && approximate->is_model(model));
      for (int i = 0; i < 50; ++i) {
        const P p = random_point(random, *approximate);
        const auto signature = approximate->signature(model, p);
        if (!signature)
          continue;
        const Location expected = location_in(model, p);
        auto found = known.find(*signature);
        if (found == known.end())
          found = known.emplace(*signature, approximate->locate(*signature)).first;
        ASSERT_EQ(found->second, expected) << *signature << " in " << model << " at " << p;
        const CGAL::Uncertain<bool> is_inside = approximate->is_inside(p);
        if (CGAL::is_certain(is_inside)) {
          ASSERT_EQ(is_inside.make_certain(), expected == Location::INSIDE);
        }
        uncertain += !CGAL::is_certain(is_inside);
        inside += expected == Location::INSIDE;
        ++cases;
      }
    }
  }
  EXPECT_GT(inside, 20000);
  EXPECT_GT(uncertain, 50000);
  EXPECT_GT(reflex, 50);
}

TEST(Approximate_polygons, Each_signature_has_a_model_and_no_other_one_has)
{
  Random random(1208);
  int polygons = 0;
  while (polygons < 25) {
    const auto approximate = random_polygon(random, 3 + random() % 4);
    if (!approximate)
      continue;
    ++polygons;
    const SC::Signature_cells_2 cells = SC::signature_cells(*approximate);
    ASSERT_TRUE(cells.is_complete());
    expect_models(*approximate, cells);
    for (const std::string& s : all_signatures(approximate->size())) {
      const auto* cell = cells.find(s);
      EXPECT_EQ(approximate->locate(s), cell == nullptr ? Location::NO_MODEL : cell->location);
    }
    for (int i = 0; i < 50; ++i)
      expect_cells_of_point(*approximate, cells, random_point(random, *approximate));
  }
}

TEST(Approximate_polygons, Bands_between_two_polygons)
{
  const Polygon inner = polygon({{1, 1}, {1, 3}, {3, 3}, {3, 1}}), outer = polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  const Approximate between = SC::approximate_polygon_between(inner, outer);
  EXPECT_TRUE(between.is_model(inner) && between.is_model(outer));
  EXPECT_EQ(between.band(0), polygon({{1, 0}, {1, 4}, {0, 4}, {0, 0}}));
  EXPECT_FALSE(between.is_model(polygon({{0, 0}, {0, 4}, {4, 5}, {4, 0}})));
  EXPECT_FALSE(between.is_model(polygon({{0, 0}, {0, 4}, {4, 4}})));
  EXPECT_TRUE(CGAL::certainly(between.is_inside(P(2, 2))) && CGAL::certainly(!between.is_inside(P(5, 2))));
  EXPECT_FALSE(CGAL::is_certain(between.is_inside(P(1, 2))));
  EXPECT_EQ(between.signature(outer, P(2, 0)), std::nullopt);
  EXPECT_EQ(between.signature(outer, P(2, -1)), "RRRL");
}

TEST(Approximate_polygons, Irrational_lengths)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Polygon_2<Kernel> triangle;
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(70, 10), std::pair(30, 50)})
    triangle.push_back(Kernel::Point_2(x, y));
  const Approximate approximate = SC::approximate_polygon(triangle, Kernel::FT(2));
  for (std::size_t i = 0; i < 3; ++i) {
    const Polygon band = approximate.band(i);
    const R square = CGAL::squared_distance(K::Line_2(band[0], band[1]), band[2]);
    EXPECT_TRUE(square >= 16 && square < R(16 * (1 + 1e-12)));
  }
}

TEST(Approximate_polygons, What_is_refused_names_the_edges)
{
  const Polygon strip = polygon({{0, 0}, {0, 1}, {20, 1}, {20, 0}});
  EXPECT_EQ(refusal(strip, R(1) / 4), "");
  EXPECT_NE(refusal(strip, R(1) / 2).find("strip of edge 0 is too wide"), std::string::npos);
  const Polygon notch = polygon({{0, 0}, {0, 9}, {9, 9}, {9, 5}, {3, 5}, {3, 4}, {9, 4}, {9, 0}});
  EXPECT_NE(refusal(notch, R(1) / 2).find("edge 4"), std::string::npos);
  // Two spikes that nearly meet.
  const Polygon spikes = polygon({{0, 0}, {10, 9}, {20, 0}, {20, 20}, {10, 10}, {0, 20}});
  EXPECT_EQ(refusal(spikes, R(1) / 4), "");
  EXPECT_NE(refusal(spikes, R(1)).find("bands of edges 0 and 3, which are no neighbours, meet"), std::string::npos)
      << refusal(spikes, R(1));
  const Polygon bow = polygon({{0, 0}, {4, 4}, {4, 0}, {0, 5}});
  EXPECT_NE(refusal(bow, R(1) / 100).find("bands of edges 0 and 2"), std::string::npos) << refusal(bow, R(1) / 100);
  EXPECT_NE(refusal(polygon({{0, 0}, {0, 2}, {0, 4}, {4, 0}}), R(1) / 4).find("edges 0 and 1 are parallel"),
            std::string::npos);
  EXPECT_NE(refusal(polygon({{0, 0}, {0, 0}, {0, 4}, {4, 0}}), R(1) / 4).find("edge 0 has no length"),
            std::string::npos);
  EXPECT_NE(refusal(polygon({{0, 0}, {0, 4}}), R(1) / 4).find("less than three"), std::string::npos);
  EXPECT_NE(refusal(square(), R(0)).find("half width of edge 0 is not positive"), std::string::npos);
  EXPECT_THROW(SC::approximate_polygon(square(), std::vector<R>(3, R(1))), SC::Invalid_input);
  EXPECT_THROW(SC::approximate_polygon_between(letter_L(), square()), SC::Invalid_input);
  EXPECT_THROW(SC::approximate_polygon_between(square(), polygon({{0, 0}, {0, 4}, {4, 5}, {4, 0}})), SC::Invalid_input);
  EXPECT_THROW(SC::approximate_polygon_between(square(), square()), SC::Invalid_input); // no interior
  EXPECT_THROW(Approximate(square(), std::vector<SC::Edge_strip_2>(4, {P(9, 9), P(10, 8)})), SC::Invalid_input);
  EXPECT_THROW(Approximate(square(), {}), SC::Invalid_input);

  using Doubles = CGAL::Simple_cartesian<double>;
  CGAL::Polygon_2<Doubles> doubles;
  for (const auto& [x, y] : {std::pair(0., 0.), std::pair(4., 0.), std::pair(4., 4.)})
    doubles.push_back(Doubles::Point_2(x, y));
  EXPECT_EQ(SC::approximate_polygon(doubles, 0.25).size(), 3u);
  EXPECT_THROW(SC::approximate_polygon(doubles, std::numeric_limits<double>::quiet_NaN()), SC::Invalid_input);
  EXPECT_TRUE(CGAL::certainly(SC::approximate_polygon(doubles, 0.25).is_inside(Doubles::Point_2(3, 1))));
  doubles.push_back(Doubles::Point_2(0, std::numeric_limits<double>::infinity()));
  EXPECT_THROW(SC::approximate_polygon(doubles, 0.25), SC::Invalid_input);

  const Approximate approximate = SC::approximate_polygon(square(), R(1) / 2);
  for (const std::string signature : {"", "RRR", "RRRRR", "RRRX", "rrrr"})
    EXPECT_THROW(approximate.locate(signature), SC::Invalid_input) << signature;
  EXPECT_THROW(approximate.model(Ratios(3, {R(0), R(0)})), SC::Invalid_input);
  EXPECT_THROW(approximate.model(Ratios(4, {R(0), R(2)})), SC::Invalid_input);
  EXPECT_THROW(approximate.signature(letter_L(), P(1, 1)), SC::Invalid_input);
  EXPECT_THROW(SC::signature_cells(approximate, {.time_limit = -1}), SC::Invalid_input);
}

TEST(Approximate_polygons, What_a_limit_leaves_is_named)
{
  const Approximate approximate = SC::approximate_polygon(letter_L(), R(1) / 4);
  const SC::Signature_cells_2 all = SC::signature_cells(approximate);
  for (const std::size_t limit : {1, 40, 120}) {
    const SC::Signature_cells_2 some = SC::signature_cells(approximate, {.node_limit = limit});
    EXPECT_FALSE(some.is_complete());
    EXPECT_FALSE(some.undecided().empty());
    EXPECT_LE(some.summary().nodes, limit + 1);
    for (const SC::Signature_cell_2& cell : some.cells()) {
      ASSERT_NE(all.find(cell.signature), nullptr);
      EXPECT_EQ(all.find(cell.signature)->location, cell.location);
    }
    // What is missing is in the places that are named.
    for (const SC::Signature_cell_2& cell : all.cells())
      for (const Polygon& part : cell.parts) {
        const SC::Signature_cell_2* found = some.find(cell.signature);
        const P p = center(part);
        const bool is_there = found != nullptr &&
            std::any_of(found->parts.begin(), found->parts.end(),
                        [&](const Polygon& other) { return other.has_on_bounded_side(p); });
        EXPECT_TRUE(is_there ||
                    std::any_of(some.undecided().begin(), some.undecided().end(), [&](const SC::Undecided_part& open) {
                      return R(open.place[0].first) <= p.x() && p.x() <= R(open.place[0].second) &&
                          R(open.place[1].first) <= p.y() && p.y() <= R(open.place[1].second);
                    }));
      }
  }
}

} // namespace approximate_polygons_2_test
