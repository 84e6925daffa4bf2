// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// When a part that moves along a curve and turns first hits an obstacle, proved to be the first time; and all times at
// which it begins or ceases to collide.
//
//   first_contact
//
// Writes first_contact.svg: the obstacle (gray), the part at regular times, blue where it is free and orange where it
// collides, and red in the first contact; below, the same as a bar along the time. Exit status: 0 when all is proved, 3
// when something is not.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Number>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Motion = SC::Rational_motion_2;

namespace {

// A closed curve of edges and one cubic.
std::vector<Curve> part_outline()
{
  return {SC::segment_curve<K>(Point(-1, -0.5), Point(1, -0.5)),
          SC::bezier_curve(std::vector<Point>{{1, -0.5}, {2, 1}, {0, 1}, {-1, 0.5}}),
          SC::segment_curve<K>(Point(-1, 0.5), Point(-1, -0.5))};
}

std::vector<Curve> obstacle_outline()
{
  return {SC::bezier_curve(std::vector<Point>{{0, 0}, {16, 0}}),
          SC::bezier_curve(std::vector<Point>{{16, 0}, {15, 4}, {13, 4}, {12, 1}}),
          SC::bezier_curve(std::vector<Point>{{12, 1}, {10, 2}, {9, 6}, {7, 3}}),
          SC::bezier_curve(std::vector<Point>{{7, 3}, {5, 0}, {3, 2}, {0, 0}})};
}

// Along a curve in the time from 0 to 1, while it turns by two times the angle whose tangent is the time.
Motion part_motion()
{
  const Curve path(3, {0, 0, 0, 0, Number(1) / 2, 1, 1, 1, 1},
                   {Point(1, 3), Point(5, 3), Point(8, 6), Point(12, 3), Point(15.5, 5)});
  const Motion::Function one({1}, {{0, 0, 1, 1}}, {1, 1}), time({1}, {{0, 0, 1, 1}}, {0, -1});
  return Motion::along(path) * Motion::rotation(Point(0, 0), one, time);
}

std::string color_of(SC::Contact_state state) { return state == SC::Contact_state::APART ? "#1f77b4" : "#ff7f0e"; }

SC::Contact_state state_at(const SC::Contact_events_2& events, const Number& time)
{
  SC::Contact_state result = events.state_at_begin();
  for (const SC::Contact_event_2& event : events.events())
    if (event.time.second < time)
      result = event.after;
  return result;
}

} // namespace

int main()
{
  const auto part = SC::planar_region(part_outline()), obstacle = SC::planar_region(obstacle_outline());
  const Motion motion = part_motion();
  const SC::First_contact_2 first = SC::first_contact(part, motion, obstacle);
  const SC::Contact_events_2 events = SC::contact_events(part, motion, obstacle);

  std::ofstream file("first_contact.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-0.5, -1.6, 16.5, 6.5), 900);
  const auto draw_part = [&](const Number& time, const std::string& color, double width) {
    for (const Curve& curve : part.curves())
      picture.curve(curve.transformed(motion(time)), color, width);
  };
  picture.layer("obstacle");
  for (const auto& polygon : obstacle.polygons_with_holes(0.001))
    picture.polygon(std::vector<Point>(polygon.outer_boundary().begin(), polygon.outer_boundary().end()), "#dddddd");
  for (const Curve& curve : obstacle.curves())
    picture.curve(curve, "black", 2);
  picture.layer("part at regular times");
  constexpr int poses = 12;
  for (int i = 0; i <= poses; ++i)
    draw_part(Number(i) / poses, color_of(state_at(events, Number(i) / poses)), 1.5);

  picture.layer("times");
  const auto on_axis = [](const Number& time) { return Point(16 * time, Number(-1)); };
  Number begin = motion.domain().first;
  SC::Contact_state state = events.state_at_begin();
  for (const SC::Contact_event_2& event : events.events()) {
    picture.curve(SC::segment_curve<K>(on_axis(begin), on_axis(event.time.first)), color_of(state), 9);
    begin = event.time.first;
    state = event.after;
    std::cout << "at " << CGAL::to_double(event.time.first) << ": " << event.before << ", then " << event.after << '\n';
  }
  picture.curve(SC::segment_curve<K>(on_axis(begin), on_axis(motion.domain().second)), color_of(state), 9);
  picture.label(Point(0, -1.5), "time: free (blue), collides (orange)");

  if (CGAL::possibly(first.do_meet())) {
    const Number time = first.time_range()->first;
    std::cout << "first contact at " << CGAL::to_double(time) << ", error at most "
              << CGAL::to_double(Number(first.time_range()->second - time))
              << ", proved: " << (CGAL::certainly(first.do_meet()) ? "yes" : "no") << '\n';
    picture.layer("first contact");
    draw_part(time, "#d62728", 4);
    picture.point(on_axis(time), "#d62728", 12);
    for (const SC::Contact_2& contact : first.contacts()) {
      const Point point(contact.point[0].first, contact.point[1].first);
      picture.point(point, "#d62728", 12);
      std::cout << contact.kind << " at " << CGAL::to_double(point.x()) << ", " << CGAL::to_double(point.y()) << '\n';
    }
  }
  const bool is_complete = first.is_complete() && events.is_complete();
  std::cout << "complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete ? 0 : 3;
}
