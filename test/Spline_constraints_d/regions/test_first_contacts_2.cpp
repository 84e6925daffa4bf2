// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// When moving regions meet: closed forms, near misses on both sides, grazing contacts, rigid motions of the whole
// scene, polygons against all times at which a vertex passes an edge, and what is asked for wrongly.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace first_contacts_2_test {

namespace SC = CGAL::Spline_constraints;
using R = SC::Exact_rational;
using K = CGAL::Simple_cartesian<R>;
using P = K::Point_2;
using Map = CGAL::Aff_transformation_2<K>;
using Curve = SC::Bspline_curve_2<K>;
using Region = SC::Planar_region_2<K>;
using Motion = SC::Rational_motion_2;
using Function = Motion::Function;
using State = SC::Contact_state;
using Kind = SC::Contact_kind;
using Range = SC::Contact_2::Range;

namespace {

Region region(const std::vector<Curve>& curves) { return SC::planar_region(curves); }

Region polygon(const std::vector<P>& corners)
{
  std::vector<Curve> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(SC::segment_curve<K>(corners[i], corners[(i + 1) % corners.size()]));
  return region(edges);
}

Region rectangle(const R& x0, const R& y0, const R& x1, const R& y1)
{
  return polygon({P(x0, y0), P(x1, y0), P(x1, y1), P(x0, y1)});
}

Region disc(const P& center, const R& radius) { return region({SC::circle_curve<K>(center, radius)}); }

Motion line(const P& from, const P& to) { return Motion::along(SC::segment_curve<K>(from, to)); }

// A spline of one piece with these control points, from time 0 to 1.
Function bezier(const std::vector<R>& values)
{
  const int degree = static_cast<int>(values.size()) - 1;
  std::vector<R> knots(values.size(), R(0));
  knots.insert(knots.end(), values.size(), R(1));
  return Function({degree}, {knots}, values);
}

// About a point by the angle 2 arctan(t), t from 0 to 1.
Motion quarter_turn(const P& center) { return Motion::rotation(center, bezier({R(1)}), bezier({R(0), R(1)})); }

Region transformed(const Region& region_before, const Map& map)
{
  std::vector<Curve> curves;
  for (const Curve& curve : region_before.curves())
    curves.push_back(curve.transformed(map));
  return region(curves);
}

// The motion that does not move, but maps.
Motion constant(const Map& map, const std::pair<R, R>& domain)
{
  const auto f = [&](const R& value) { return Function({0}, {{domain.first, domain.second}}, {value}); };
  return Motion({{{f(map.m(0, 0)), f(map.m(1, 0))}, {f(map.m(0, 1)), f(map.m(1, 1))}}},
                {f(map.m(0, 2)), f(map.m(1, 2))}, f(R(1)));
}

bool encloses(const Range& range, const R& value) { return range.first <= value && value <= range.second; }
R width(const Range& range) { return R(range.second - range.first); }
bool do_overlap(const Range& a, const Range& b) { return a.first <= b.second && b.first <= a.second; }

// A first contact in a narrow range, with a time in it.
void expect_contact(const SC::First_contact_2& contact, const R& time, const std::string& what)
{
  EXPECT_TRUE(contact.is_complete()) << what;
  EXPECT_EQ(State::APART, contact.state_at_begin()) << what;
  EXPECT_TRUE(CGAL::certainly(contact.do_meet())) << what;
  ASSERT_TRUE(contact.time_range()) << what;
  EXPECT_TRUE(encloses(*contact.time_range(), time)) << what << ' ' << CGAL::to_double(contact.time_range()->first);
  EXPECT_LT(width(*contact.time_range()), R(1e-12)) << what;
  EXPECT_FALSE(contact.contacts().empty()) << what;
  for (const SC::Contact_2& c : contact.contacts())
    EXPECT_TRUE(do_overlap(c.time, *contact.time_range())) << what;
}

void expect_none(const SC::First_contact_2& contact, const std::string& what)
{
  EXPECT_TRUE(contact.is_complete()) << what;
  EXPECT_EQ(State::APART, contact.state_at_begin()) << what;
  EXPECT_TRUE(CGAL::certainly(!contact.do_meet())) << what;
  EXPECT_FALSE(contact.time_range()) << what;
  EXPECT_TRUE(contact.contacts().empty()) << what;
}

using States = std::vector<State>;

// The states in the order of time.
void expect_states(const SC::Contact_events_2& events, const States& states, const std::string& what)
{
  EXPECT_TRUE(events.is_complete()) << what;
  States found{events.state_at_begin()};
  for (const SC::Contact_event_2& event : events.events()) {
    EXPECT_EQ(found.back(), event.before) << what;
    EXPECT_FALSE(event.contacts.empty()) << what;
    found.push_back(event.after);
  }
  EXPECT_EQ(states, found) << what;
  EXPECT_EQ(states.back(), events.state_at_end()) << what;
}

} // namespace

// A disc that moves along a line meets another one where the square of the distance is that of the sum of the radii: a
// quadratic equation, whose first root lies between two times at which the sign changes.
TEST(First_contacts_2, Discs_on_lines)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> number(-40, 40), size(1, 20);
  int hits = 0, misses = 0;
  for (int i = 0; i < 60; ++i) {
    const R radius(R(size(random)) / 8), other(R(size(random)) / 8), reach(radius + other);
    const P from(R(number(random)) / 4, R(number(random)) / 4), to(R(number(random)) / 4, R(number(random)) / 4);
    const auto excess = [&](const R& t) {
      const R x(from.x() + t * (to.x() - from.x())), y(from.y() + t * (to.y() - from.y()));
      return R(x * x + y * y - reach * reach);
    };
    if (from == to || excess(0) <= 0)
      continue;
    const K::Vector_2 way = to - from;
    const R nearest(-(from - CGAL::ORIGIN) * way / way.squared_length());
    const auto contact = SC::first_contact(disc(P(0, 0), radius), line(from, to), disc(P(0, 0), other));
    const std::string what = "discs " + std::to_string(i);
    const bool do_meet = excess(1) <= 0 || (nearest > 0 && nearest < 1 && excess(nearest) <= 0);
    if (!do_meet) {
      ++misses;
      expect_none(contact, what);
      continue;
    }
    ++hits;
    ASSERT_TRUE(contact.time_range()) << what;
    const auto& [lower, upper] = *contact.time_range();
    EXPECT_GE(excess(lower), 0) << what;
    EXPECT_LE(excess(upper), 0) << what;
    expect_contact(contact, R((lower + upper) / 2), what);
    ASSERT_EQ(1u, contact.contacts().size()) << what;
    EXPECT_EQ(Kind::SMOOTH, contact.contacts()[0].kind) << what;
  }
  EXPECT_GT(hits, 10);
  EXPECT_GT(misses, 10);
}

// Misses, and contacts, by very little, along a line that is not parallel to an axis.
TEST(First_contacts_2, Near_misses)
{
  const K::Vector_2 way(R(3, 5), R(4, 5)), side(R(-4, 5), R(3, 5));
  for (const double gap : {1e-3, 1e-9, 1e-12, 1e-15}) {
    const auto path = [&](const R& distance) {
      return line(P(0, 0) + side * distance - way * R(5), P(0, 0) + side * distance + way * R(6));
    };
    const Region a = disc(P(0, 0), R(1)), b = disc(P(0, 0), R(1));
    const std::string what = "gap " + std::to_string(gap);
    expect_none(SC::first_contact(a, path(R(2 + R(gap))), b), what);
    expect_states(SC::contact_events(a, path(R(2 + R(gap))), b), {State::APART}, what);
    const auto events = SC::contact_events(a, path(R(2 - R(gap))), b);
    expect_states(events, {State::APART, State::OVERLAPPING, State::APART}, what);
    ASSERT_EQ(2u, events.events().size()) << what;
    const auto contact = SC::first_contact(a, path(R(2 - R(gap))), b);
    ASSERT_TRUE(contact.time_range()) << what;
    expect_contact(contact, contact.time_range()->first, what);
    // At the time t the distance of the centers is (11 t - 5)^2 + (2 - gap)^2 = 4.
    const double half = std::sqrt(4 * gap - gap * gap);
    EXPECT_NEAR((5 - half) / 11, CGAL::to_double(contact.time_range()->first), 1e-11) << what;
    EXPECT_NEAR(2 * half / 11, CGAL::to_double(R(events.events()[1].time.first - events.events()[0].time.first)),
                1e-6 * half + 1e-15)
        << what;
  }
  const auto grazing = SC::contact_events(disc(P(0, 0), R(1)),
                                          line(P(0, 0) + side * R(2) - way * R(5), P(0, 0) + side * R(2) + way * R(6)),
                                          disc(P(0, 0), R(1)));
  expect_states(grazing, {State::APART, State::APART}, "grazing discs");
  EXPECT_TRUE(encloses(grazing.events()[0].time, R(5, 11)));
}

TEST(First_contacts_2, Discs_and_squares)
{
  const Region square = rectangle(0, 0, 3, 3), unit = disc(P(0, 0), R(1));
  const auto edge = SC::first_contact(unit, line(P(-4, R(3, 2)), P(4, R(3, 2))), square);
  expect_contact(edge, R(3, 8), "edge");
  ASSERT_EQ(1u, edge.contacts().size());
  EXPECT_EQ(Kind::SMOOTH, edge.contacts()[0].kind);
  EXPECT_EQ(3u, edge.contacts()[0].places[1].curve);
  EXPECT_TRUE(encloses(edge.contacts()[0].point[0], R(0)));
  EXPECT_TRUE(encloses(edge.contacts()[0].point[1], R(3, 2)));

  // The center is at (8t - 4) (3/5, 4/5) from the corner.
  const auto corner = SC::first_contact(unit, line(P(R(-12, 5), R(-16, 5)), P(R(12, 5), R(16, 5))), square);
  expect_contact(corner, R(3, 8), "corner");
  ASSERT_EQ(1u, corner.contacts().size());
  EXPECT_EQ(Kind::FIXED_VERTEX, corner.contacts()[0].kind);
  EXPECT_TRUE(corner.contacts()[0].places[1].is_vertex);
  EXPECT_FALSE(corner.contacts()[0].places[0].is_vertex);

  // With the normal of the edge exactly in the corner.
  const auto end = SC::first_contact(unit, line(P(-4, 0), P(4, 0)), square);
  expect_contact(end, R(3, 8), "end of an edge");
  ASSERT_EQ(1u, end.contacts().size());
  EXPECT_EQ(Kind::FIXED_VERTEX, end.contacts()[0].kind);

  const auto vertex = SC::first_contact(square, line(P(-12, R(-3, 2)), P(4, R(-3, 2))), unit);
  expect_contact(vertex, R(1, 2), "moving square");
  EXPECT_EQ(Kind::SMOOTH, vertex.contacts()[0].kind);
  const auto moving = SC::first_contact(square, line(P(-9, -9), P(-1, -1)), unit);
  ASSERT_EQ(1u, moving.contacts().size());
  EXPECT_EQ(Kind::MOVING_VERTEX, moving.contacts()[0].kind);
  const auto& [lower, upper] = *moving.time_range(); // of (8t - 6)^2 + (8t - 6)^2 = 1 the first root
  const auto excess = [](const R& t) { return R(2 * (8 * t - 6) * (8 * t - 6) - 1); };
  EXPECT_GE(excess(lower), 0);
  EXPECT_LE(excess(upper), 0);

  const auto corners = SC::first_contact(square, line(P(-8, -8), P(0, 0)), square);
  expect_contact(corners, R(5, 8), "two corners");
  ASSERT_EQ(1u, corners.contacts().size());
  EXPECT_EQ(Kind::VERTICES, corners.contacts()[0].kind);
  expect_states(SC::contact_events(square, line(P(-8, 8), P(8, -8)), square),
                {State::APART, State::OVERLAPPING, State::APART}, "two corners");
  expect_states(SC::contact_events(square, line(P(-8, 2), P(2, -8)), square), {State::APART, State::APART},
                "corners that pass each other");
}

// A unit square turns about its center, beside a wall: the corner reaches it where cos + sin = 2h. A rectangle of 4 x 3
// touches a wall at 5/2, half of its diagonal, where the tangent of half of the angle is 1/3.
TEST(First_contacts_2, Turning_rectangles)
{
  const R half(1, 2);
  const Region square = rectangle(R(-half), R(-half), half, half), wall = rectangle(R(7, 10), -3, 2, 3);
  const auto contact = SC::first_contact(square, quarter_turn(P(0, 0)), wall);
  expect_contact(contact, R(1, 3), "turning square");
  EXPECT_EQ(Kind::MOVING_VERTEX, contact.contacts().at(0).kind);
  const auto events = SC::contact_events(square, quarter_turn(P(0, 0)), wall);
  expect_states(events, {State::APART, State::OVERLAPPING, State::APART}, "turning square");
  EXPECT_TRUE(encloses(events.events().at(0).time, R(1, 3)));
  EXPECT_TRUE(encloses(events.events().at(1).time, R(1, 2)));

  const Region long_one = rectangle(-2, R(-3, 2), 2, R(3, 2));
  const auto beside = [&](const R& h) {
    return SC::contact_events(long_one, quarter_turn(P(0, 0)), rectangle(h, -5, 4, 5));
  };
  const auto grazing = beside(R(5, 2));
  expect_states(grazing, {State::APART, State::APART}, "grazing corner");
  EXPECT_TRUE(encloses(grazing.events().at(0).time, R(1, 3)));
  EXPECT_EQ(2, grazing.events()[0].contacts.at(0).certificate.multiplicity());
  expect_contact(SC::first_contact(long_one, quarter_turn(P(0, 0)), rectangle(R(5, 2), -5, 4, 5)), R(1, 3),
                 "grazing corner");
  for (const double gap : {1e-9, 1e-12}) {
    expect_states(beside(R(R(5, 2) + R(gap))), {State::APART}, "corner that misses");
    expect_states(beside(R(R(5, 2) - R(gap))), {State::APART, State::OVERLAPPING, State::APART}, "corner that hits");
  }

  // A full turn beside a disc: four times something begins or ends, by symmetry at times that add up to one and three.
  const Region bar = rectangle(-2, R(-half), 2, half);
  const auto turn = SC::contact_events(bar, Motion::full_turn(P(0, 0)), disc(P(0, 2), R(1)));
  expect_states(turn, {State::APART, State::OVERLAPPING, State::APART, State::OVERLAPPING, State::APART},
                "turning bar");
  EXPECT_TRUE(encloses({R(turn.events()[0].time.first + turn.events()[1].time.first),
                        R(turn.events()[0].time.second + turn.events()[1].time.second)},
                       R(1)));
}

// The height of a square over a table is (2 - s^2)^2, s from 0 to 2: it touches at an irrational time.
TEST(First_contacts_2, Irrational_grazing)
{
  std::vector<P> path; // s = 2t: 4 - 16 t^2 + 16 t^4
  const std::vector<R> heights{R(4), R(4), R(R(4) - R(16, 6)), R(R(4) - R(16, 2)), R(4)};
  for (std::size_t i = 0; i < heights.size(); ++i)
    path.emplace_back(R(static_cast<int>(i)), heights[i]);
  const Motion motion = Motion::along(SC::bezier_curve<K>(path));
  const Region diamond = polygon({P(0, 0), P(1, 1), P(0, 2), P(-1, 1)}), table = rectangle(-10, -1, 10, 0);
  const auto events = SC::contact_events(diamond, motion, table);
  expect_states(events, {State::APART, State::APART}, "diamond");
  EXPECT_LE(R(2 * events.events()[0].time.first * events.events()[0].time.first), 1);
  EXPECT_GE(R(2 * events.events()[0].time.second * events.events()[0].time.second), 1);
  const auto round = SC::contact_events(disc(P(0, 1), R(1)), motion, table);
  expect_states(round, {State::APART, State::APART}, "disc");
}

TEST(First_contacts_2, State_at_the_first_time)
{
  const Region square = rectangle(0, 0, 3, 3), unit = disc(P(0, 0), R(1)), large = disc(P(0, 0), R(5));
  const auto at_begin = [](const Region& a, const Motion& motion, const Region& b, State state) {
    const auto contact = SC::first_contact(a, motion, b);
    EXPECT_EQ(state, contact.state_at_begin());
    EXPECT_TRUE(contact.is_complete());
    EXPECT_TRUE(CGAL::certainly(contact.do_meet()));
    EXPECT_TRUE(contact.time_range() && contact.time_range()->second == motion.domain().first);
    return contact;
  };
  at_begin(unit, line(P(0, 0), P(9, 9)), square, State::OVERLAPPING);
  at_begin(unit, line(P(-1, 0), P(1, 0)), large, State::OVERLAPPING); // inside, no boundaries meet
  at_begin(large, line(P(-1, 0), P(1, 0)), unit, State::OVERLAPPING);
  at_begin(unit, line(P(4, 0), P(9, 0)), large, State::OVERLAPPING); // touches from inside
  at_begin(unit, line(P(0, 0), P(9, 0)), unit, State::OVERLAPPING);  // the same
  at_begin(square, line(P(0, 0), P(9, 0)), square, State::OVERLAPPING);
  at_begin(rectangle(1, 0, 2, 1), line(P(0, 0), P(9, 0)), square, State::OVERLAPPING); // a common part, on one side

  const auto smooth = at_begin(unit, line(P(-1, 1), P(-3, 1)), square, State::TOUCHING);
  ASSERT_EQ(1u, smooth.contacts().size());
  EXPECT_EQ(Kind::SMOOTH, smooth.contacts()[0].kind);
  const auto corners = at_begin(square, line(P(-3, -3), P(0, 0)), square, State::TOUCHING);
  ASSERT_EQ(1u, corners.contacts().size());
  EXPECT_EQ(Kind::VERTICES, corners.contacts()[0].kind);
  expect_states(SC::contact_events(square, line(P(-3, -3), P(0, 0)), square), {State::TOUCHING, State::OVERLAPPING},
                "corners");
  expect_states(SC::contact_events(unit, line(P(-1, 1), P(-3, 1)), square), {State::TOUCHING, State::APART}, "disc");
  expect_states(SC::contact_events(unit, line(P(-3, 1), P(-1, 1)), square), {State::APART, State::TOUCHING}, "disc");
}

// A block slides on a table until its last corner passes the end of the table. (The edges have a part in common.)
TEST(First_contacts_2, Block_slides_off_a_table)
{
  const Region block = rectangle(0, 0, 1, 1), table = rectangle(-2, -1, 2, 0);
  const auto events = SC::contact_events(block, line(P(-1, 0), P(4, 0)), table);
  expect_states(events, {State::TOUCHING, State::APART}, "block");
  EXPECT_TRUE(encloses(events.events()[0].time, R(3, 5)));
  EXPECT_EQ(Kind::VERTICES, events.events()[0].contacts.at(0).kind);

  // It comes down first, and is lifted at the end.
  const Motion motion = Motion::along(SC::polyline_curve(std::vector<P>{{-1, 1}, {-1, 0}, {1, 0}, {1, 2}}));
  const auto landing = SC::contact_events(block, motion, table);
  expect_states(landing, {State::APART, State::TOUCHING, State::APART}, "landing block");
  EXPECT_TRUE(encloses(landing.events().at(0).time, R(1)));
  EXPECT_TRUE(encloses(landing.events().at(1).time, R(2)));
  const auto first = SC::first_contact(block, motion, table);
  expect_contact(first, R(1), "landing block");
  EXPECT_EQ(2u, first.contacts().size());
}

// In a hole: it is no overlap, and the boundary of the hole is met.
TEST(First_contacts_2, Regions_with_holes)
{
  const Region ring = region({SC::circle_curve<K>(P(0, 0), R(5)), SC::circle_curve<K>(P(0, 0), R(3))});
  const auto contact = SC::first_contact(disc(P(0, 0), R(1)), line(P(0, 0), P(10, 0)), ring);
  expect_contact(contact, R(1, 5), "hole");
  ASSERT_EQ(1u, contact.contacts().size());
  EXPECT_EQ(1u, contact.contacts()[0].places[1].curve);
  const auto events = SC::contact_events(disc(P(0, 0), R(1)), line(P(0, 0), P(10, 0)), ring);
  expect_states(events, {State::APART, State::OVERLAPPING, State::APART}, "hole");
  EXPECT_TRUE(encloses(events.events()[1].time, R(3, 5)));
  const auto around = SC::first_contact(ring, line(P(0, 0), P(0, 8)), disc(P(0, 0), R(1)));
  expect_contact(around, R(1, 4), "moving hole");
}

// The whole scene is turned and moved, or both regions move by one more motion, or all is reflected: the same times.
TEST(First_contacts_2, Rigid_motions_of_the_scene)
{
  const std::vector<P> controls{{2, 0}, {2, 2}, {0, 1}, {-2, 2}, {-1, 0}, {-2, -2}, {0, -1}, {2, -1}};
  std::vector<R> knots;
  for (int i = 0; i <= 8; ++i)
    knots.push_back(R(i));
  const Region blob = region({Curve::from_periodic(3, knots, controls)});
  const Region other =
      region({SC::bezier_curve<K>({P(0, 0), P(3, -1), P(4, 2), P(1, 3)}), SC::segment_curve<K>(P(1, 3), P(0, 0))});
  const Motion path =
      Motion::along(Curve(2, {R(0), R(0), R(0), R(1, 3), R(1), R(1), R(1)}, {P(-8, 1), P(-4, 4), P(1, -1), P(9, 3)}));
  const Motion motion = path * quarter_turn(P(0, 0));
  const auto events = SC::contact_events(blob, motion, other);
  expect_states(events, {State::APART, State::OVERLAPPING, State::APART}, "blob");
  const auto first = SC::first_contact(blob, motion, other);
  ASSERT_TRUE(first.time_range());
  expect_contact(first, first.time_range()->first, "blob");

  // Before it the exact distance is positive, behind it they meet.
  const auto distance_at = [&](const R& time) {
    return SC::region_distance(transformed(blob, motion(time)), other).do_meet();
  };
  for (int i = 0; i < 8; ++i)
    EXPECT_TRUE(CGAL::certainly(!distance_at(R(first.time_range()->first * i / 8))));
  EXPECT_TRUE(CGAL::certainly(!distance_at(R(first.time_range()->first - R(1e-6)))));
  EXPECT_TRUE(CGAL::certainly(distance_at(R(first.time_range()->second + R(1e-6)))));

  std::mt19937 random(3);
  std::uniform_int_distribution<int> number(-20, 20);
  for (int i = 0; i < 20; ++i) {
    const R q(R(number(random)) / 7), w(1 + q * q), cosine((1 - q * q) / w), sine(2 * q / w), x(R(number(random)) / 3),
        y(R(number(random)) / 3);
    const int sign = i % 5 == 4 ? -1 : 1; // reflected
    const Map map(cosine, R(-sine * sign), x, sine, R(cosine * sign), y);
    const auto same = SC::first_contact(blob, constant(map, motion.domain()) * motion, transformed(other, map));
    const std::string what = "motion " + std::to_string(i);
    ASSERT_TRUE(same.is_complete() && same.time_range()) << what;
    EXPECT_TRUE(do_overlap(*first.time_range(), *same.time_range())) << what;
    ASSERT_EQ(first.contacts().size(), same.contacts().size()) << what;
    EXPECT_EQ(first.contacts()[0].kind, same.contacts()[0].kind) << what;
    EXPECT_EQ(first.contacts()[0].places[0].curve, same.contacts()[0].places[0].curve) << what;
    expect_states(SC::contact_events(blob, constant(map, motion.domain()) * motion, transformed(other, map)),
                  {State::APART, State::OVERLAPPING, State::APART}, what);
    if (i % 5 == 0) {
      const Motion carrier = Motion::rotation(P(x, y), bezier({R(1), R(2)}), bezier({q, R(1)}));
      const auto relative = SC::first_contact(blob, carrier.inverse() * (carrier * motion), other);
      ASSERT_TRUE(relative.is_complete() && relative.time_range()) << what;
      EXPECT_TRUE(do_overlap(*first.time_range(), *relative.time_range())) << what;
    }
  }

  // What is smaller comes later; a body that grows meets what it does not reach.
  const Motion growing({{{bezier({R(1), R(4)}), bezier({R(0)}) * bezier({R(0), R(0)})},
                         {bezier({R(0)}) * bezier({R(0), R(0)}), bezier({R(1), R(4)})}}},
                       {bezier({R(0)}), bezier({R(0)})}, bezier({R(1)}));
  expect_contact(SC::first_contact(disc(P(0, 0), R(1)), growing, rectangle(3, -9, 4, 9)), R(2, 3), "growing disc");
}

namespace {

// Of a polynomial in Bernstein form on [0,1], all roots in order, each in a range that is at most 2^-60 wide: by
// Descartes' rule, which is exact for polynomials without multiple roots.
void append_roots(const std::vector<R>& b, const R& begin, const R& end, std::vector<Range>& roots)
{
  int changes = 0;
  R last(0);
  for (const R& c : b)
    if (c != 0) {
      changes += (last > 0 && c < 0) || (last < 0 && c > 0);
      last = c;
    }
  if (changes == 0 && b.front() != 0)
    return;
  if (R(end - begin) < R(0x1p-60)) {
    roots.emplace_back(begin, end);
    return;
  }
  std::vector<R> left, right, row = b; // de Casteljau
  while (!row.empty()) {
    left.push_back(row.front());
    right.insert(right.begin(), row.back());
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      row[i] = (row[i] + row[i + 1]) / 2;
    row.pop_back();
  }
  const R middle((begin + end) / 2);
  append_roots(left, begin, middle, roots);
  append_roots(right, middle, end, roots);
}

// Times at which a vertex of a polygon is on an edge of another one, by exact roots of one polynomial each.
std::vector<Range> passages(const std::vector<P>& moving, const Motion& motion, const std::vector<P>& fixed)
{
  std::vector<Range> result;
  const auto add = [&](const Motion& path, const P& vertex, const P& a, const P& b) {
    const K::Vector_2 n(R(a.y() - b.y()), R(b.x() - a.x()));
    std::array<Function, 2> x;
    for (std::size_t i = 0; i < 2; ++i)
      x[i] = path.columns()[0][i] * vertex.x() + path.columns()[1][i] * vertex.y() + path.columns()[2][i];
    const Function f = x[0] * n.x() + x[1] * n.y() - path.weight() * R(n.x() * a.x() + n.y() * a.y());
    std::vector<Range> roots;
    append_roots(f.bezier_pieces().front().coefficients(), R(0), R(1), roots);
    for (const Range& root : roots) {
      const P p = path(R((root.first + root.second) / 2)).transform(vertex);
      const R along((p - a) * (b - a) / (b - a).squared_length());
      if (along >= 0 && along <= 1)
        result.push_back(root);
    }
  };
  const Motion back = motion.inverse();
  for (std::size_t i = 0; i < moving.size(); ++i)
    for (std::size_t k = 0; k < fixed.size(); ++k) {
      add(motion, moving[i], fixed[k], fixed[(k + 1) % fixed.size()]);
      add(back, fixed[k], moving[i], moving[(i + 1) % moving.size()]);
    }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<P> random_star(std::mt19937& random, int corners)
{
  std::uniform_int_distribution<int> radius(30, 100);
  std::vector<P> result;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners, r = radius(random) / 50.0;
    result.emplace_back(R(std::round(1024 * r * std::cos(angle)) / 1024),
                        R(std::round(1024 * r * std::sin(angle)) / 1024));
  }
  return result;
}

} // namespace

// Polygons that turn and move: they first meet at the first time at which a vertex is on an edge.
TEST(First_contacts_2, Polygons)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> number(-60, 60), corners(3, 9);
  int hits = 0, misses = 0, grazing = 0;
  for (int i = 0; i < 40; ++i) {
    const std::vector<P> moving = random_star(random, corners(random)), fixed = random_star(random, corners(random));
    const P from(R(number(random)) / 10, R(number(random)) / 10), to(R(number(random)) / 10, R(number(random)) / 10);
    const Motion motion = line(from, to) *
        Motion::rotation(P(R(1, 7), R(0)), bezier({R(1), R(number(random)) / 20}), bezier({R(0), R(1)}));
    const Region a = polygon(moving), b = polygon(fixed);
    const auto contact = SC::first_contact(a, motion, b);
    const std::string what = "polygons " + std::to_string(i);
    EXPECT_TRUE(contact.is_complete()) << what;
    const auto apart = SC::region_distance(transformed(a, motion(R(0))), b).do_meet();
    ASSERT_TRUE(CGAL::is_certain(apart)) << what;
    EXPECT_EQ(CGAL::certainly(!apart), contact.state_at_begin() == State::APART) << what;
    if (contact.state_at_begin() != State::APART)
      continue;
    const std::vector<Range> times = passages(moving, motion, fixed);
    const auto events = SC::contact_events(a, motion, b);
    EXPECT_TRUE(events.is_complete()) << what;
    EXPECT_EQ(times.empty(), events.events().empty()) << what;
    if (times.empty()) {
      ++misses;
      expect_none(contact, what);
      continue;
    }
    ++hits;
    ASSERT_TRUE(contact.time_range()) << what;
    EXPECT_TRUE(do_overlap(times.front(), *contact.time_range())) << what;
    EXPECT_TRUE(do_overlap(events.events().front().time, *contact.time_range())) << what;
    expect_contact(contact, contact.time_range()->first, what);
    // Events are passages, and between two of them nothing changes.
    for (const SC::Contact_event_2& event : events.events()) {
      EXPECT_TRUE(std::any_of(times.begin(), times.end(), [&](const Range& t) { return do_overlap(t, event.time); }))
          << what;
      grazing += event.before == event.after;
    }
    for (std::size_t k = 0; k <= times.size(); ++k) {
      const R time(((k == 0 ? R(0) : times[k - 1].second) + (k == times.size() ? R(1) : times[k].first)) / 2);
      State state = events.state_at_begin();
      for (const SC::Contact_event_2& event : events.events())
        if (event.time.second < time)
          state = event.after;
      const auto meets = SC::region_distance(transformed(a, motion(time)), b).do_meet();
      EXPECT_TRUE(state == State::APART ? CGAL::certainly(!meets) : CGAL::certainly(meets)) << what << ' ' << k;
    }
  }
  EXPECT_GT(hits, 8);
  EXPECT_GT(misses, 4);
  EXPECT_EQ(0, grazing);
}

// Polygons with small integers as corners, most of which move in such directions: vertices meet, edges have parts in
// common and slide on each other. The states are those of exact intersections of edges.
TEST(First_contacts_2, Polygons_on_a_grid)
{
  std::mt19937 random(2);
  std::uniform_int_distribution<int> coordinate(-3, 3), place(-5, 5), choice(0, 3);
  const std::vector<P> angle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
      fork{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const auto shape = [&]() -> std::vector<P> {
    if (const int kind = choice(random); kind < 2)
      return kind == 0 ? angle : fork;
    std::vector<P> corners;
    do {
      corners.clear();
      for (int i = 0; i < 3; ++i)
        corners.emplace_back(coordinate(random), coordinate(random));
    } while (CGAL::collinear(corners[0], corners[1], corners[2]));
    return corners;
  };
  const auto do_meet = [](const std::vector<P>& a, const std::vector<P>& b) {
    const CGAL::Polygon_2<K> p(a.begin(), a.end()), q(b.begin(), b.end());
    for (auto e = p.edges_begin(); e != p.edges_end(); ++e)
      if (std::any_of(q.edges_begin(), q.edges_end(), [&](const auto& f) { return CGAL::do_intersect(*e, f); }))
        return true;
    return p.bounded_side(b[0]) == CGAL::ON_BOUNDED_SIDE || q.bounded_side(a[0]) == CGAL::ON_BOUNDED_SIDE;
  };
  int touching = 0, grazing = 0, changes = 0;
  for (int i = 0; i < 120; ++i) {
    const std::vector<P> a = shape(), b = shape();
    const P from(place(random), place(random));
    const P to(place(random), choice(random) == 0 ? from.y() : R(place(random)));
    const Motion motion = choice(random) == 0 ? line(from, to) * quarter_turn(P(0, 0)) : line(from, to);
    const std::string what = "scene " + std::to_string(i);
    const auto events = SC::contact_events(polygon(a), motion, polygon(b));
    const auto contact = SC::first_contact(polygon(a), motion, polygon(b));
    EXPECT_TRUE(contact.is_complete()) << what;
    EXPECT_NE(State::UNDECIDED, events.state_at_begin()) << what;
    EXPECT_NE(State::UNDECIDED, events.state_at_end()) << what;
    std::vector<R> times;
    for (int k = 0; k <= 30; ++k)
      times.push_back(R(k) / 30);
    touching += events.state_at_begin() == State::TOUCHING;
    for (const SC::Contact_event_2& event : events.events()) {
      touching += event.after == State::TOUCHING;
      grazing += event.before == event.after;
      changes += event.before != event.after;
      times.push_back((std::max)(R(0), R(event.time.first - R(1e-9))));
      times.push_back((std::min)(R(1), R(event.time.second + R(1e-9))));
    }
    for (const R& time : times) {
      std::vector<P> moved;
      for (const P& corner : a)
        moved.push_back(motion(time).transform(corner));
      const bool meet = do_meet(moved, b);
      if (meet) {
        EXPECT_TRUE(contact.time_range() && contact.time_range()->first <= time) << what;
      }
      State state = events.state_at_begin();
      bool is_in_event = false;
      for (const SC::Contact_event_2& event : events.events()) {
        is_in_event = is_in_event || encloses(event.time, time);
        if (event.time.second < time)
          state = event.after;
      }
      if (!is_in_event) {
        EXPECT_EQ(meet, state != State::APART) << what << ' ' << CGAL::to_double(time);
      }
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_GT(grazing, 0);
  EXPECT_GT(changes, 60);
}

TEST(First_contacts_2, Bad_input)
{
  const auto expect_refused = [](const auto& make, const std::string& words) {
    try {
      make();
      ADD_FAILURE() << words;
    } catch (const SC::Invalid_input& error) {
      EXPECT_NE(std::string::npos, std::string(error.what()).find(words)) << error.what();
    }
  };
  const Function zero = bezier({R(0)}), one = bezier({R(1)}), t = bezier({R(-1), R(1)});
  expect_refused([&] { Motion({{{t, zero}, {zero, t}}}, {zero, zero}, one); }, "invertible"); // scale zero at 1/2
  expect_refused([&] { Motion({{{one, one}, {one, one}}}, {zero, zero}, one); }, "invertible");
  expect_refused([&] { Motion({{{one, zero}, {zero, one}}}, {zero, zero}, t); }, "weight");
  expect_refused([&] { Motion::rotation(P(0, 0), t, t); }, "weight");
  expect_refused(
      [&] {
        Motion({{{one, zero}, {zero, one}}}, {zero, zero}, Function({0}, {{R(0), R(2)}}, {R(1)}));
      },
      "same domain");
  const Motion motion = line(P(-4, 0), P(4, 0));
  expect_refused([&] { motion.restricted(R(1, 2), R(1, 4)); }, "axis 0");
  expect_refused([&] { motion.restricted(R(0), R(2)); }, "axis 0");
  expect_refused([&] { motion* motion.restricted(R(0), R(1, 2)); }, "different domains");
  expect_refused([&] { region({}); }, "no curves");
  const Region unit = disc(P(0, 0), R(1));
  expect_refused([&] { SC::first_contact(unit, motion, unit, {.tolerance = -1}); }, "tolerance");
  expect_refused([&] { SC::contact_events(unit, motion, unit, {.time_limit = -1}); }, "time limit");

  // A part of the time: only what happens in it.
  expect_contact(SC::first_contact(unit, motion.restricted(R(1, 8), R(1)), unit), R(1, 4), "part of the time");
  expect_none(SC::first_contact(unit, motion.restricted(R(7, 8), R(1)), unit), "part of the time");
}

// A curved boundary slides along a straight one until the foot comes to an end of it.
TEST(First_contacts_2, Sliding)
{
  const Region table = rectangle(0, -1, 4, 0), unit = disc(P(0, 0), R(1));
  const auto off = SC::contact_events(unit, line(P(1, 1), P(6, 1)), table);
  expect_states(off, {State::TOUCHING, State::APART}, "off");
  ASSERT_EQ(1u, off.events().size());
  EXPECT_TRUE(encloses(off.events()[0].time, R(3, 5)));
  const auto onto = SC::contact_events(unit, line(P(-3, 1), P(2, 1)), table);
  expect_states(onto, {State::APART, State::TOUCHING}, "onto");
  ASSERT_EQ(1u, onto.events().size());
  EXPECT_TRUE(encloses(onto.events()[0].time, R(3, 5)));
  expect_contact(SC::first_contact(unit, line(P(-3, 1), P(2, 1)), table), R(3, 5), "onto");
  // the table under the disc
  const auto away = SC::contact_events(table, line(P(-1, -1), P(-6, -1)), unit);
  expect_states(away, {State::TOUCHING, State::APART}, "away");
  ASSERT_EQ(1u, away.events().size());
  EXPECT_TRUE(encloses(away.events()[0].time, R(3, 5)));
  // over all of it, with a rigid motion of the scene, and at a height that misses
  const Map map(R(3, 5), R(-4, 5), R(2, 7), R(4, 5), R(3, 5), R(1, 3));
  const Motion moved_line = constant(map, {R(0), R(1)}) * line(P(-2, 1), P(6, 1));
  const auto over = SC::contact_events(unit, moved_line, transformed(table, map));
  expect_states(over, {State::APART, State::TOUCHING, State::APART}, "over");
  ASSERT_EQ(2u, over.events().size());
  EXPECT_TRUE(encloses(over.events()[0].time, R(1, 4)) && encloses(over.events()[1].time, R(3, 4)));
  expect_none(SC::first_contact(unit, line(P(-3, R(1) + R(1e-12)), P(7, R(1) + R(1e-12))), table), "above");
}

// Where a run ends early, what was not looked at is undecided, and nothing is claimed of it.
TEST(First_contacts_2, Limits)
{
  struct Stopper
  {
    int questions_before_stop, questions = 0;
    std::clock_t begin_of_stop = 0;
    void on_progress(double) {}
    bool stop()
    {
      if (++questions <= questions_before_stop)
        return false;
      if (begin_of_stop == 0)
        begin_of_stop = std::clock();
      return true;
    }
  };
  std::mt19937 random(5);
  std::vector<Curve> outlines;
  for (int i = 0; i < 2; ++i) {
    std::uniform_real_distribution<double> radius(0.9, 1.1);
    std::vector<P> controls;
    std::vector<R> knots;
    for (int k = 0; k < 150; ++k) {
      const double angle = 2 * 3.14159265358979 * k / 150, r = radius(random);
      controls.emplace_back(R(r * std::cos(angle)), R(r * std::sin(angle)));
      knots.push_back(R(k));
    }
    knots.push_back(R(150));
    outlines.push_back(Curve::from_periodic(3, knots, controls));
  }
  const Region a = region({outlines[0]}), b = region({outlines[1]});
  const Motion motion = line(P(-4, R(1, 3)), P(4, R(1, 3))) * quarter_turn(P(0, 0));
  const auto whole = SC::first_contact(a, motion, b);
  ASSERT_TRUE(whole.is_complete() && whole.time_range());
  for (int i = 0; i < 200; i = 2 * i + 1) {
    Stopper stopper{i};
    const auto part = SC::first_contact(a, motion, b, {.visitor = stopper});
    const std::clock_t end = std::clock();
    const auto events = SC::contact_events(a, motion, b, {.node_limit = static_cast<std::size_t>(i) + 1});
    EXPECT_FALSE(events.is_complete());
    EXPECT_FALSE(events.undecided().empty());
    if (part.is_complete()) {
      EXPECT_LE(stopper.questions, i);
      continue;
    }
    ASSERT_TRUE(part.time_range());
    EXPECT_LE(part.time_range()->first, whole.time_range()->second);
    EXPECT_GE(part.time_range()->second, whole.time_range()->first);
    EXPECT_FALSE(part.undecided().empty());
    EXPECT_EQ(SC::Undecided_reason::STOPPED, part.summary().why_not);
    EXPECT_LT(static_cast<double>(end - stopper.begin_of_stop) / CLOCKS_PER_SEC, 0.3);
  }
  for (const double limit : {1e-3, 0.05}) {
    const std::clock_t begin = std::clock();
    const auto part = SC::contact_events(a, motion, b, {.time_limit = limit});
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, limit + 0.3);
    EXPECT_FALSE(part.is_complete());
  }
  Stopper stopper{0};
  const Region unknown(std::vector<Curve>{outlines[0]}, {.visitor = stopper});
  ASSERT_FALSE(unknown.is_complete());
  EXPECT_FALSE(SC::first_contact(unknown, motion, b).is_complete());
  EXPECT_FALSE(SC::contact_events(a, motion, unknown).is_complete());
  EXPECT_FALSE(CGAL::is_certain(SC::first_contact(a, motion, unknown).do_meet()));
}

} // namespace first_contacts_2_test
