// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Motions from states that add and remove constraints. They are kinematic: nothing has a mass, no force acts.
//
// A figure walks: it swings a leg, lands it, lifts the other one, and again with the legs exchanged. A heel on the
// ground stays where it is up to a centimetre, the one that swings follows a quintic curve, knees bend backward only,
// the leg that stands is straight up to 15 degrees, and the torso is between the heels. How a state ends is a condition
// on the position; when, nobody needs to know. Every position is rational and satisfies all constraints exactly.
//
// A block slides off a table: its face lies on that of the table, then on its edge, then it is free.
//
//   walk_cycle
//
// Writes walk_cycle.svg. Exit status: 0 when all positions are found, 3 when not.
//
// Source: A. J. Stewart, J. F. Cremer, Beyond keyframing: an algorithmic approach to animation, 1991.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/constraint_idioms.h>
#include <CGAL/Spline_constraints_d/geometry/curves/hermite_curves.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_tracker.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Number>;
using Point = K::Point_2;
using Vector = K::Vector_2;
using Curve = SC::Bspline_curve_2<K>;
using Formulas = SC::Vector_expression<2>;

namespace {

const Number last_time = 4, step = Number(6) / 10, tolerance = Number(1) / 100;

SC::Spline_map<1, 2> map_of(const Curve& curve) { return SC::Spline_map<1, 2>(curve.homogeneous_coordinates()); }

// From one place on the ground to another, over a height, at rest before and after.
Curve heel_curve(const Point& from, const Point& to, const Number& begin, const Number& end)
{
  const Vector rest = CGAL::NULL_VECTOR, middle((to.x() - from.x()) / (end - begin) * Number(15) / 8, 0);
  const Point top((from.x() + to.x()) / 2, Number(1) / 8);
  return SC::hermite_curve<K>({from, from, top, to, to}, {rest, rest, middle, rest, rest},
                              {rest, rest, rest, rest, rest}, {0, begin, (begin + end) / 2, end, last_time});
}

enum class State
{
  SWING,
  LAND,
  LIFT
};

// A hip and two legs, each of two links of length 1/2. Joints are tangents of half angles: of the thigh to the
// vertical, and of the knee.
class Walking_figure
{
  std::vector<SC::Unknown> m_joints =
      SC::unknowns({{{-1, 4}}, {{0.7, 1.1}}, {{-0.5, 0.5}}, {{0, 0.7}}, {{-0.5, 0.5}}, {{0, 0.7}}, {{0, last_time}}});
  Formulas m_hip{m_joints[0], m_joints[1]};
  std::array<Formulas, 2> m_knees{m_hip, m_hip}, m_heels{m_hip, m_hip};
  std::array<Point, 2> m_places{Point(0, 0), Point(step, 0)}; // where the heels are on the ground
  std::array<std::vector<std::size_t>, 2> m_leg_constraints;
  SC::Constraint_tracker m_tracker;
  State m_state = State::LIFT;
  std::size_t m_leg = 0; // that swings, or is lifted next
  Number m_end;

public:
  std::vector<std::array<Point, 5>> figures; // heel, knee, hip, knee, heel
  int held = 0, repaired = 0, others = 0, states = 0;

  Walking_figure()
    : m_tracker(m_joints[6],
                {Number(3) / 10, Number(19) / 20, Number(-1) / 7, Number(1) / 10, Number(1) / 6, Number(1) / 20, 0},
                {.offset = 0x1p-11, .most_steps = 2000, .is_search_allowed = false})
  {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const SC::Expression &a = m_joints[2 + 2 * leg], &b = m_joints[3 + 2 * leg];
      const Formulas thigh{2 * a / (1 + a * a), -(1 - a * a) / (1 + a * a)};
      const SC::Expression cosine = (1 - b * b) / (1 + b * b), sine = 2 * b / (1 + b * b);
      const Formulas shin{thigh[0] * cosine + thigh[1] * sine, thigh[1] * cosine - thigh[0] * sine};
      m_knees[leg] = {m_hip[0] + thigh[0] / 2, m_hip[1] + thigh[1] / 2};
      m_heels[leg] = {m_knees[leg][0] + shin[0] / 2, m_knees[leg][1] + shin[1] / 2};
    }
    const SC::Expression middle = (m_heels[0][0] + m_heels[1][0]) / 2;
    m_tracker.add(SC::interval(m_hip[0], middle - Number(1) / 20, middle + Number(1) / 20));
    stand(1);
    lift(0);
  }

  // Until the state has changed so often.
  void walk(int changes)
  {
    constexpr int steps_of_unit = 40;
    for (int k = 0; k <= steps_of_unit * last_time && states < changes; ++k) {
      const SC::Tracking_step found = m_tracker.advance(Number(k) / steps_of_unit);
      ++(found.status == SC::Tracking_status::HELD           ? held
             : found.status == SC::Tracking_status::REPAIRED ? repaired
                                                             : others);
      if (!found.has_point()) {
        std::cout << found << '\n';
        continue;
      }
      record(found.point);
      change_state(found.point);
    }
  }

private:
  static constexpr double straight = 0.13, flexed = 0.18; // knees of less than 15, and more than 20 degrees

  void set(std::size_t leg, const std::vector<SC::Constraint>& constraints)
  {
    for (const std::size_t number : m_leg_constraints[leg])
      m_tracker.remove(number);
    m_leg_constraints[leg] = m_tracker.add(constraints);
  }

  Formulas place(std::size_t leg) const { return {m_places[leg].x(), m_places[leg].y()}; }

  void stand(std::size_t leg)
  {
    set(leg, {SC::toleranced_move(m_heels[leg], place(leg), tolerance), m_joints[3 + 2 * leg] <= straight});
  }

  // The knee may bend again.
  void trail(std::size_t leg) { set(leg, {SC::toleranced_move(m_heels[leg], place(leg), tolerance)}); }

  void lift(std::size_t leg)
  {
    const SC::Expression &x = m_heels[leg][0], &y = m_heels[leg][1];
    const auto near = SC::interval(x, m_places[leg].x() - tolerance, m_places[leg].x() + Number(1) / 10),
               low = SC::interval(y, 0, Number(1) / 10);
    const Number speed = 1, from = m_tracker.point().back() * speed;
    set(leg, {near[0], near[1], low[0], low[1], SC::pusher(-m_joints[3 + 2 * leg], from, speed, m_joints[6])});
  }

  void swing(std::size_t leg, const Point& from)
  {
    const Number time = m_tracker.point().back();
    m_end = time + Number(1) / 2;
    m_places[leg] = Point(m_places[1 - leg].x() + step, 0);
    const auto target = map_of(heel_curve(from, m_places[leg], time, m_end));
    set(leg, {SC::toleranced_move(m_heels[leg], target(m_joints[6]), tolerance)});
  }

  void change_state(const std::vector<Number>& point)
  {
    const std::size_t other = 1 - m_leg;
    const auto heel = m_heels[m_leg](point);
    if (m_state == State::LIFT && point[3 + 2 * m_leg] >= Number(flexed)) {
      swing(m_leg,
            Point(Number(std::lround(1000 * CGAL::to_double(heel[0]))) / 1000,
                  Number(std::lround(1000 * CGAL::to_double(heel[1]))) / 1000));
      m_state = State::SWING;
    } else if (m_state == State::SWING && point.back() >= m_end && heel[1] <= tolerance) {
      stand(m_leg);
      trail(other);
      m_state = State::LAND;
    } else if (m_state == State::LAND) {
      lift(other);
      m_leg = other;
      m_state = State::LIFT;
    } else
      return;
    ++states;
  }

  void record(const std::vector<Number>& point)
  {
    const auto at = [&](const Formulas& f) {
      const auto p = f(point);
      return Point(p[0], p[1]);
    };
    figures.push_back({at(m_heels[0]), at(m_knees[0]), at(m_hip), at(m_knees[1]), at(m_heels[1])});
  }
};

// Legs in two colors, darker with time; the paths of heels and hip.
bool show_walk(SC::SVG_writer& picture)
{
  Walking_figure figure;
  figure.walk(12);
  const auto& figures = figure.figures;
  picture.polyline(std::vector<Point>{{-1, 0}, {4, 0}}, "#8a6f4d", 3);
  bool are_links = !figures.empty();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto& joints = figures[i];
    for (std::size_t k = 0; k < 4; ++k)
      are_links = are_links && CGAL::squared_distance(joints[k], joints[k + 1]) == Number(1) / 4;
    if (i % 5 != 0)
      continue;
    picture.polyline(std::vector<Point>{joints[0], joints[1], joints[2]}, "#1f77b4", 1.7);
    picture.polyline(std::vector<Point>{joints[4], joints[3], joints[2]}, "#ff7f0e", 1.7);
    picture.polyline(std::vector<Point>{joints[2], joints[2] + Vector(0, Number(1) / 2)}, "#99a2ad", 1.7);
    picture.circle(joints[2] + Vector(0, Number(58) / 100), Number(8) / 100, "#99a2ad", 1.2);
  }
  for (const auto& [joint, color] : {std::pair(0, "#1f77b4"), {4, "#ff7f0e"}, {2, "black"}}) {
    std::vector<Point> path;
    for (const auto& joints : figures)
      path.push_back(joints[joint]);
    picture.polyline(path, color, 3);
  }
  std::cout << "walk: " << figure.states << " changes of state; " << figure.held << " held, " << figure.repaired
            << " repaired, " << figure.others << " others; links keep their lengths: " << (are_links ? "yes" : "no")
            << '\n';
  return are_links && figure.others == 0 && figure.states == 12;
}

// A block of length 1 and its left lower corner at x(t), which is shown tilting from when its middle has passed the end
// of the table at 0: its lower side goes on passing through that point.
bool show_block(SC::SVG_writer& picture, const Vector& place)
{
  const std::vector<Vector> rest(2, CGAL::NULL_VECTOR);
  const Curve path = SC::hermite_curve<K>({Point(Number(-3) / 2, 0), Point(Number(1) / 2, 0)}, rest, rest);
  const auto x = map_of(path);
  const auto [t] = SC::parameters(x);
  std::vector<Number> times;
  for (const Number& corner : {Number(1), Number(Number(1) / 2), Number(0)})
    for (const auto& solution : SC::solve(x(t)[0] + corner == 0))
      times.push_back(solution.exact_box()[0].second);
  const bool is_right = times.size() == 3 && times[0] < times[1] && times[1] == Number(1) / 2 && times[1] < times[2];
  if (!is_right)
    return false;
  std::cout << "block: face on face; at " << CGAL::to_double(times[0]) << " it passes the end, at "
            << CGAL::to_double(times[1]) << " its middle: face on edge; at " << CGAL::to_double(times[2]) << " free\n";

  using Motion = SC::Rational_motion_2;
  const Motion::Function one({1}, {{0, 0, 1, 1}}, {1, 1}), tilt({2}, {{0, 0, 0, times[1], 1, 1, 1}}, {0, 0, 0, -4});
  const Motion motion = Motion::rotation(Point(0, 0), one, tilt) * Motion::along(path);
  const CGAL::Aff_transformation_2<K> beside(CGAL::TRANSLATION, place);
  picture.polygon(std::vector<Point>{Point(-2, Number(-1) / 4) + place, Point(0, Number(-1) / 4) + place,
                                     Point(0, 0) + place, Point(-2, 0) + place},
                  "#d8c9b0");
  bool passes_end = true;
  const auto draw = [&](const Number& time, const std::string& color, double width) {
    std::vector<Point> corners;
    for (const Point& p : {Point(0, 0), Point(1, 0), Point(1, Number(2) / 5), Point(0, Number(2) / 5), Point(0, 0)})
      corners.push_back(beside(motion(time)(p)));
    picture.polyline(corners, color, width);
    passes_end = passes_end && motion(time)(Point(-path(time).x(), 0)) == Point(0, 0);
  };
  for (int k = 3; k <= 12; ++k)
    draw(Number(k) / 20, k < 10 ? "#1f77b4" : "#ff7f0e", 1.2);
  draw(times[1], "black", 2.5);
  draw(times[2], "#d62728", 2.5);
  picture.label(Point(Number(-19) / 10, Number(-1) / 2) + place,
                "face on face (blue), face on edge (orange), free (red)");
  return passes_end;
}

} // namespace

int main()
{
  std::ofstream file("walk_cycle.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-0.4, -1.4, 3.4, 1.8), 900);
  const bool is_walking = show_walk(picture), is_sliding = show_block(picture, Vector(Number(8) / 5, Number(-7) / 10));
  return is_walking && is_sliding ? 0 : 3;
}
