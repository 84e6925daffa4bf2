// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// When moving solids meet: closed forms, near misses on both sides, grazing contacts, every pair of parts, tumbling
// boxes against exact separating planes, and what is asked for wrongly.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace first_contacts_3_test {

using Curve = SC::Bspline_curve_3<K>;
using Motion = SC::Rational_motion_3;
using Function = Motion::Function;
using Solid = std::vector<Surface>;
using State = SC::Contact_state;
using Part = SC::Solid_part;
using Parts = std::pair<Part, Part>; // of the moving solid, and of the fixed one
using States = std::vector<State>;

namespace {

Solid box(const Point& low, const Point& high)
{
  Solid result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const int u = (axis + (end == 1 ? 1 : 2)) % 3;
      std::vector<Point> points;
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          const auto coordinate = [&](int k) { return (k == axis ? end : k == u ? i : j) == 1 ? high[k] : low[k]; };
          points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        }
      result.push_back(Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, points));
    }
  return result;
}

// Around the origin.
Solid box(const Rational& x, const Rational& y, const Rational& z) { return box(Point(-x, -y, -z), Point(x, y, z)); }

Solid table() { return box(Point(-4, -4, -1), Point(4, 4, 0)); }
Solid sphere(const Rational& radius) { return {SC::sphere_surface<K>(Point(0, 0, 0), radius)}; }

// Around the vertical axis.
Solid revolved(const std::vector<Point>& profile)
{
  Solid result;
  for (std::size_t i = 1; i < profile.size(); ++i)
    result.push_back(SC::surface_of_revolution(Curve(1, {0, 0, 1, 1}, {profile[i - 1], profile[i]}), Point(0, 0, 0),
                                               Vector(0, 0, 1)));
  return result;
}

Solid cylinder() { return revolved({Point(0, 0, -1), Point(1, 0, -1), Point(1, 0, 1), Point(0, 0, 1)}); }
Solid cone() { return revolved({Point(0, 0, -1), Point(1, 0, 1), Point(0, 0, 1)}); }

Motion line(const Point& from, const Point& to) { return Motion::along(Curve(1, {0, 0, 1, 1}, {from, to})); }

// About a line through the origin by 2 arctan(q |d| / p).
Motion turned(const Vector& direction, const Rational& p, const Rational& q)
{
  return Motion::rotation(Point(0, 0, 0), direction, Function({0}, {{0, 1}}, {p}), Function({0}, {{0, 1}}, {q}));
}

// The same by 2 arctan(t |d|).
Motion turning(const Vector& direction)
{
  return Motion::rotation(Point(0, 0, 0), direction, Function({0}, {{0, 1}}, {1}),
                          Function({1}, {{0, 0, 1, 1}}, {0, 1}));
}

Motion falling() { return line(Point(0, 0, 4), Point(0, 0, -1)); }

using Range = SC::Contact_3::Range;
bool encloses(const Range& range, const Rational& value) { return range.first <= value && value <= range.second; }

std::vector<Parts> parts_of(const SC::First_contact_3& contact)
{
  std::vector<Parts> result;
  for (const SC::Contact_3& c : contact.contacts())
    result.emplace_back(c.places[0].part, c.places[1].part);
  std::ranges::sort(result);
  return result;
}

// A first contact in a narrow range of times, with these parts.
void expect_contact(const SC::First_contact_3& contact, const std::vector<Parts>& parts, const std::string& what)
{
  EXPECT_TRUE(contact.is_complete()) << what;
  EXPECT_EQ(State::APART, contact.state_at_begin()) << what;
  EXPECT_TRUE(CGAL::certainly(contact.do_meet())) << what;
  ASSERT_TRUE(contact.time_range()) << what;
  EXPECT_LT(Rational(contact.time_range()->second - contact.time_range()->first), Rational(1e-12)) << what;
  EXPECT_EQ(parts, parts_of(contact)) << what;
}

void expect_contact(const SC::First_contact_3& contact, const std::vector<Parts>& parts, const Rational& time,
                    const std::string& what)
{
  expect_contact(contact, parts, what);
  EXPECT_TRUE(contact.time_range() && encloses(*contact.time_range(), time)) << what;
}

// At the first zero of a function that is positive before.
template <class Function_of_time>
void expect_zero(const SC::First_contact_3& contact, const std::vector<Parts>& parts, const Function_of_time& f,
                 const std::string& what)
{
  expect_contact(contact, parts, what);
  ASSERT_TRUE(contact.time_range()) << what;
  EXPECT_GE(f(contact.time_range()->first), 0) << what;
  EXPECT_LE(f(contact.time_range()->second), 0) << what;
}

void expect_none(const SC::First_contact_3& contact, const std::string& what)
{
  EXPECT_TRUE(contact.is_complete()) << what;
  EXPECT_EQ(State::APART, contact.state_at_begin()) << what;
  EXPECT_TRUE(CGAL::certainly(!contact.do_meet())) << what;
  EXPECT_FALSE(contact.time_range()) << what;
}

States states_of(const SC::Contact_events_3& events)
{
  EXPECT_TRUE(events.is_complete());
  States result{events.state_at_begin()};
  for (const SC::Contact_event_3& event : events.events()) {
    EXPECT_EQ(result.back(), event.before);
    EXPECT_FALSE(event.contacts.empty());
    result.push_back(event.after);
  }
  EXPECT_EQ(result.back(), events.state_at_end());
  return result;
}

template <class Call>
std::string message_of(const Call& call)
{
  try {
    call();
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "";
}

constexpr Parts faces{Part::FACE, Part::FACE}, edges{Part::EDGE, Part::EDGE}, corners{Part::CORNER, Part::CORNER},
    edge_on_face{Part::EDGE, Part::FACE}, face_on_edge{Part::FACE, Part::EDGE},
    corner_on_face{Part::CORNER, Part::FACE}, face_on_corner{Part::FACE, Part::CORNER},
    corner_on_edge{Part::CORNER, Part::EDGE};

} // namespace

// The centers are at the distance of the sum of the radii.
TEST(First_contacts_3, Spheres)
{
  const Point from(-5, Rational(1) / 3, Rational(1) / 5), to(6, Rational(2) / 3, 0);
  const auto gap = [&](const Rational& t) {
    return Rational((from + (to - from) * t - CGAL::ORIGIN).squared_length() - 4);
  };
  expect_zero(SC::first_contact(sphere(1), line(from, to), sphere(1)), {faces}, gap, "apart from seams");
}

// A sphere that passes the edge of a box at a distance that differs little from its radius, or not at all.
TEST(First_contacts_3, Near_misses)
{
  const Solid obstacle = box(Point(0, -4, -8), Point(8, 4, 0));
  const Vector way(Rational(3) / 5, 0, Rational(4) / 5), side(Rational(-4) / 5, 0, Rational(3) / 5);
  const auto passing = [&](const Rational& distance) {
    const Point nearest = Point(0, Rational(1) / 3, 0) + side * distance;
    return line(nearest - way * Rational(5), nearest + way * Rational(6));
  };
  const Rational gap(1e-12), near = 1 + gap, inside = 1 - gap;
  expect_none(SC::first_contact(sphere(1), passing(near), obstacle), "miss");
  expect_zero(
      SC::first_contact(sphere(1), passing(inside), obstacle), {face_on_edge},
      [&](const Rational& t) { return Rational((11 * t - 5) * (11 * t - 5) + inside * inside - 1); }, "hit");
  const SC::Contact_events_3 events = SC::contact_events(sphere(1), passing(1), obstacle);
  EXPECT_EQ((States{State::APART, State::APART}), states_of(events));
  ASSERT_EQ(1u, events.events().size());
  EXPECT_TRUE(encloses(events.events()[0].time, Rational(5) / 11));
  // with the pole, on a parabola
  const Motion parabola =
      Motion::along(Curve(2, {0, 0, 0, 1, 1, 1}, {Point(-1, 0, 2), Point(0, 0, 0), Point(1, 0, 2)}));
  const SC::Contact_events_3 pole = SC::contact_events(sphere(1), parabola, table());
  EXPECT_EQ((States{State::APART, State::APART}), states_of(pole));
  ASSERT_EQ(1u, pole.events().size());
  EXPECT_TRUE(encloses(pole.events()[0].time, Rational(1) / 2));
}

// cos + sin = 2 h, and a corner that grazes the wall at a double root.
TEST(First_contacts_3, Boxes_turn_beside_a_wall)
{
  const Motion quarter = turning(Vector(0, 0, 1));
  const auto wall = [](const Rational& h) { return box(Point(h, -9, -9), Point(h + 9, 9, 9)); };
  const Rational half = Rational(1) / 2;
  const Solid cube = box(half, half, half), wide = box(2, 3 * half, 1);
  const std::vector<Parts> two_corners(2, corner_on_face);
  expect_contact(SC::first_contact(cube, quarter, wall(Rational(7) / 10)), two_corners, Rational(1) / 3, "cube");
  const SC::Contact_events_3 events = SC::contact_events(cube, quarter, wall(Rational(7) / 10));
  EXPECT_EQ((States{State::APART, State::OVERLAPPING, State::APART}), states_of(events));
  ASSERT_EQ(2u, events.events().size());
  EXPECT_TRUE(encloses(events.events()[1].time, half));
  expect_contact(SC::first_contact(wide, quarter, wall(5 * half)), two_corners, Rational(1) / 3, "grazing");
  EXPECT_EQ((States{State::APART, State::APART}), states_of(SC::contact_events(wide, quarter, wall(5 * half))));
  expect_none(SC::first_contact(wide, quarter, wall(5 * half + Rational(1e-12))), "beyond");
}

// Parts of solids that fall on a table, and on each other.
TEST(First_contacts_3, Every_pair_of_parts)
{
  const Motion down = falling();
  const auto height = [](const Rational& z, const Rational& low) { return Rational((z - low) / 5); }; // of the center
  expect_contact(SC::first_contact(sphere(1), down, table()), {faces}, height(4, 1), "pole");
  expect_contact(SC::first_contact(cone(), down, table()), {corner_on_face}, height(4, 1), "tip");
  expect_contact(SC::first_contact(box(1, 1, 1), down, table()), std::vector<Parts>(4, corner_on_face), height(4, 1),
                 "face");
  // circles in the plane of the table, and the center of the disk
  expect_contact(SC::first_contact(cylinder(), down, table()),
                 {faces, edge_on_face, edge_on_face, edge_on_face, edge_on_face}, height(4, 1), "standing");
  expect_contact(SC::first_contact(cylinder(), down * turned(Vector(1, 0, 0), 1, 1), table()),
                 {edge_on_face, edge_on_face}, height(4, 1), "lying");
  const Motion about_x = turned(Vector(1, 0, 0), 2, 1), about_y = turned(Vector(0, 1, 0), 2, 1);
  expect_contact(SC::first_contact(box(1, 1, 1), down * about_x, table()), {corner_on_face, corner_on_face},
                 height(4, Rational(7) / 5), "edge in plane");
  // a cylinder tilted by 3/5, 4/5: its lowest point is on an edge
  expect_contact(SC::first_contact(cylinder(), down * about_x, table()), {edge_on_face}, height(4, Rational(7) / 5),
                 "tilted");
  Solid ridge;
  for (const Surface& face : box(1, 1, 1))
    ridge.push_back(face.transformed(about_y(0)));
  expect_contact(SC::first_contact(box(1, 1, 1), down * about_x, ridge), {edges}, height(4, Rational(14) / 5),
                 "ridges");
  expect_contact(SC::first_contact(sphere(1), down, ridge), {face_on_edge}, "sphere on ridge");
  expect_contact(SC::first_contact(box(1, 1, 1), line(Point(-4, 0, 0), Point(4, 0, 0)), box(1, 1, 1)),
                 std::vector<Parts>(4, corners), Rational(1) / 4, "aligned");
  Solid tip; // towards the sphere
  for (const Surface& face : cone())
    tip.push_back(face.transformed(turned(Vector(0, 1, 0), 1, 1)(0)));
  const Point from(-4, Rational(1) / 3, Rational(1) / 5), apex(-1, 0, 0);
  expect_zero(
      SC::first_contact(sphere(1), line(from, from + Vector(8, 0, 0)), tip), {face_on_corner},
      [&](const Rational& t) { return Rational((from + Vector(8 * t, 0, 0) - apex).squared_length() - 1); },
      "tip aside");
}

// Boxes along the axes meet when the last of three intervals does, unless another one has ended then.
TEST(First_contacts_3, Translated_boxes)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(-40, 40);
  int meetings = 0, misses = 0;
  for (int i = 0; i < 20; ++i) {
    const auto number = [&] { return Rational(coordinate(random)) / 8; };
    const Point from(-7, number(), number()), to(7, number(), number());
    Rational begin(0), end(1);
    for (int axis = 0; axis < 3; ++axis) {
      const Rational step = to[axis] - from[axis];
      if (step == 0) {
        if (CGAL::abs(from[axis]) > 3)
          end = -1;
        continue;
      }
      const Rational a = (-3 - from[axis]) / step, b = (3 - from[axis]) / step;
      begin = (std::max)(begin, (std::min)(a, b));
      end = (std::min)(end, (std::max)(a, b));
    }
    const SC::First_contact_3 contact = SC::first_contact(box(1, 1, 1), line(from, to), box(2, 2, 2));
    EXPECT_TRUE(contact.is_complete()) << i;
    if (begin > end) {
      ++misses;
      expect_none(contact, std::to_string(i));
    } else {
      ++meetings;
      ASSERT_TRUE(contact.time_range()) << i;
      EXPECT_TRUE(CGAL::certainly(contact.do_meet()) && encloses(*contact.time_range(), begin)) << i;
    }
  }
  EXPECT_GT(meetings, 2);
  EXPECT_GT(misses, 2);
}

namespace {

// Whether a plane with one of the 15 possible normals is between two boxes around the origin, one of which is moved.
bool are_separate(const std::array<Rational, 3>& moving, const CGAL::Aff_transformation_3<Motion::Kernel>& map,
                  const std::array<Rational, 3>& fixed)
{
  std::vector<Vector> own, other{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
  for (const Vector& v : other)
    own.push_back(map.transform(v));
  std::vector<Vector> normals = other;
  normals.insert(normals.end(), own.begin(), own.end());
  for (const Vector& a : own)
    for (const Vector& b : other)
      normals.push_back(CGAL::cross_product(a, b));
  const Vector way = map.transform(Point(0, 0, 0)) - CGAL::ORIGIN;
  return std::ranges::any_of(normals, [&](const Vector& n) {
    Rational reach(0);
    for (std::size_t k = 0; k < 3; ++k)
      reach += CGAL::abs(Rational(own[k] * n)) * moving[k] + CGAL::abs(Rational(other[k] * n)) * fixed[k];
    return CGAL::abs(Rational(way * n)) > reach;
  });
}

} // namespace

// They are separated by a plane until the first contact, and by none just after it.
TEST(First_contacts_3, Tumbling_boxes)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> number(-9, 9);
  int meetings = 0;
  for (int i = 0; i < 6; ++i) {
    const std::array<Rational, 3> own{1, Rational(2) / 3, Rational(1) / 2}, other{Rational(3) / 4, 1, Rational(4) / 5};
    const Vector axis(number(random), number(random), 10);
    const Motion motion =
        line(Point(-6, Rational(number(random)) / 6, Rational(number(random)) / 6), Point(6, 0, 0)) * turning(axis);
    const auto is_apart = [&](const Rational& t) { return are_separate(own, motion(t), other); };
    const SC::First_contact_3 contact =
        SC::first_contact(box(own[0], own[1], own[2]), motion, box(other[0], other[1], other[2]));
    EXPECT_TRUE(contact.is_complete()) << i;
    EXPECT_EQ(State::APART, contact.state_at_begin()) << i;
    ASSERT_TRUE(contact.time_range() && CGAL::certainly(contact.do_meet())) << i;
    ++meetings;
    const Rational before = contact.time_range()->first - Rational(1e-9),
                   after = contact.time_range()->second + Rational(1e-9);
    for (int k = 0; k <= 20; ++k)
      EXPECT_TRUE(is_apart(Rational(before * k / 20))) << i << ' ' << k;
    EXPECT_FALSE(is_apart(after)) << i;
  }
  EXPECT_EQ(6, meetings);
}

TEST(First_contacts_3, Through_a_box)
{
  const Motion motion = line(Point(-5, Rational(1) / 3, Rational(1) / 5), Point(4, Rational(1) / 3, Rational(1) / 5));
  const SC::Contact_events_3 events = SC::contact_events(sphere(1), motion, box(Point(0, -2, -2), Point(1, 2, 2)));
  EXPECT_EQ((States{State::APART, State::OVERLAPPING, State::APART}), states_of(events));
  ASSERT_EQ(2u, events.events().size());
  EXPECT_TRUE(encloses(events.events()[0].time, Rational(4) / 9));
  EXPECT_TRUE(encloses(events.events()[1].time, Rational(7) / 9));
}

// What slides onto a table meets its edge where it touches the plane of the table.
TEST(First_contacts_3, Sliding)
{
  const Motion slide = line(Point(-9, Rational(1) / 3, 1), Point(0, Rational(1) / 3, 1));
  expect_contact(SC::first_contact(sphere(1), slide, table()), {face_on_edge}, Rational(5) / 9, "with the pole");
  expect_contact(SC::first_contact(box(1, 1, 1), slide, table()), {corner_on_edge, corner_on_edge}, Rational(4) / 9,
                 "box");
}

TEST(First_contacts_3, State_at_the_first_time)
{
  const Motion away = line(Point(0, 0, 0), Point(4, 1, 0));
  for (const Solid& moving : {box(1, 1, 1), box(Rational(1) / 4, Rational(1) / 4, Rational(1) / 4), box(3, 3, 3)}) {
    const SC::First_contact_3 contact = SC::first_contact(moving, away, box(Point(-1, -1, -2), Point(2, 1, 1)));
    EXPECT_EQ(State::OVERLAPPING, contact.state_at_begin());
    EXPECT_TRUE(contact.is_complete() && CGAL::certainly(contact.do_meet()));
    EXPECT_EQ(Range(0, 0), *contact.time_range());
  }
  // what touches at first is not decided, and said so
  const SC::First_contact_3 contact = SC::first_contact(box(1, 1, 1), away, box(Point(-1, -1, -2), Point(1, 1, -1)));
  EXPECT_EQ(State::UNDECIDED, contact.state_at_begin());
  EXPECT_TRUE(CGAL::is_indeterminate(contact.do_meet()));
  ASSERT_EQ(1u, contact.undecided().size());
  EXPECT_EQ("how the solids lie to each other at this time", contact.undecided()[0].reason);
}

TEST(First_contacts_3, Bad_input)
{
  const Motion down = falling();
  Solid open = box(1, 1, 1);
  open.pop_back();
  const auto contact = [](const Solid& moving, const Motion& motion, const Solid& fixed) {
    return message_of([&] { SC::first_contact(moving, motion, fixed); });
  };
  EXPECT_NE(contact(open, down, table()).find("first contact, moving solid: the solid is not closed"),
            std::string::npos);
  EXPECT_NE(contact(table(), down, open).find("first contact, fixed solid: the solid is not closed"),
            std::string::npos);
  EXPECT_NE(contact({}, down, table()).find("the solid has no surface"), std::string::npos);
  Solid twisted = box(1, 1, 1);
  twisted[0] = twisted[0].transposed();
  EXPECT_NE(contact(twisted, down, table()).find("normals point to different sides"), std::string::npos);
  const Function one({0}, {{0, 1}}, {1}), zero({0}, {{0, 1}}, {0}), time({1}, {{0, 0, 1, 1}}, {-1, 1});
  const Motion flat({{{one, zero, zero}, {zero, one, zero}, {zero, zero, time}}}, {zero, zero, zero}, one);
  EXPECT_NE(contact(box(1, 1, 1), flat, table()).find("not proved that the maps of the motion are invertible"),
            std::string::npos);
  EXPECT_THROW(SC::first_contact(table(), down, table(), {.tolerance = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::contact_events(open, down, table()), SC::Invalid_input);
  // a motion with a pole cannot be made
  EXPECT_THROW(Motion({{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}, time),
               SC::Invalid_input);
}

TEST(First_contacts_3, Limits)
{
  struct Stop : SC::Default_solver_visitor
  {
    bool stop() { return true; }
  } stop;
  const Motion motion = falling() * turning(Vector(1, 2, 3));
  const SC::First_contact_3 none = SC::first_contact(sphere(1), motion, table(), {.visitor = stop});
  EXPECT_FALSE(none.is_complete());
  EXPECT_FALSE(none.undecided().empty());
  const SC::First_contact_3 few = SC::first_contact(sphere(1), motion, table(), {.node_limit = 2});
  EXPECT_FALSE(few.is_complete());
  EXPECT_TRUE(CGAL::is_indeterminate(few.do_meet()));
}

} // namespace first_contacts_3_test
