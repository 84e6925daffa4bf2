// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How a part turns that keeps touching two fixed fingers, and where a third finger has to go so that the three can hold
// it without friction. The position is a rational function of the rotation; all else is exact algebra of splines.
//
//   finger_tracking
//
// A square, one corner of which runs along the circle of Thales, twice in a turn, and the next one along a limaçon, and
// a triangle. For both: curves, tracing indices, and the range of angles at which all contacts are inside their edges.
// The last lines are positions in space, on three fingers, for rational rotations. Writes finger_tracking.svg. Exit
// status: 0 when all is as it is known to be, 1 when not.
//
// Source: D. Rus, J. E. Hopcroft, in: Representing, Manipulating, and Reasoning About Physical Objects, 1991.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Number>;
using Point = K::Point_2;
using Vector = K::Vector_2;
using Curve = SC::Bspline_curve_2<K>;
using Function = SC::Bspline_function<Number>;
using Functions = std::array<Function, 2>; // a vector that depends on the rotation

namespace {

Function dot(const Functions& a, const Vector& b) { return a[0] * b.x() + a[1] * b.y(); }
Functions operator+(const Functions& a, const Functions& b) { return {a[0] + b[0], a[1] + b[1]}; }
Functions operator-(const Functions& a, const Functions& b) { return {a[0] - b[0], a[1] - b[1]}; }
Functions times(const Function& f, const Vector& a) { return {f * a.x(), f * a.y()}; }
Vector turned(const Vector& a) { return a.perpendicular(CGAL::COUNTERCLOCKWISE); }
Number cross(const Vector& a, const Vector& b) { return turned(a) * b; }

// The vector with given scalar products with a and b, by the dual basis.
Functions with_products(const Vector& a, const Function& with_a, const Vector& b, const Function& with_b)
{
  const Number area = cross(a, b);
  return times(with_a, -turned(b) / area) + times(with_b, turned(a) / area);
}

// A convex part on two fixed fingers, for a full turn while the time goes from 0 to 2. Its edges are numbered as their
// first vertices, anticlockwise. In the plane of the part, vectors have the denominator w, in that of the fingers w^2.
class Finger_tracking
{
  std::vector<Point> m_outline;
  std::array<std::size_t, 3> m_edges; // of the fixed fingers, and of the third one
  Function m_cosine, m_sine, m_weight;
  Functions m_shift;                   // the position of the part is that of this vector, turned with it
  std::array<Functions, 3> m_contacts; // in the plane of the part

public:
  Finger_tracking(const std::vector<Point>& outline, const std::array<std::size_t, 3>& edges,
                  const std::array<Point, 2>& fingers)
    : m_outline(outline), m_edges(edges)
  {
    const Function p({1}, {{0, 0, 2, 2}}, {1, -1}), q({1}, {{0, 0, 1, 2, 2}}, {0, 1, 0});
    m_cosine = p * p - q * q;
    m_sine = p * q * Number(2);
    m_weight = p * p + q * q;

    // Where the fingers are, seen from the part before it is shifted; then the shift puts them on their edges.
    const std::array<Functions, 2> seen{turned_back(fingers[0] - CGAL::ORIGIN), turned_back(fingers[1] - CGAL::ORIGIN)};
    const auto height = [&](std::size_t i) {
      return dot(seen[i], normal(edges[i])) - m_weight * (normal(edges[i]) * (outline[edges[i]] - CGAL::ORIGIN));
    };
    m_shift = with_products(normal(edges[0]), height(0), normal(edges[1]), height(1));
    m_contacts[0] = seen[0] - m_shift;
    m_contacts[1] = seen[1] - m_shift;

    // The third contact is where the normal through the common point of the first two normals meets its edge.
    const Vector a = edge(edges[0]), b = edge(edges[1]), n = normal(edges[2]);
    const Functions center = with_products(a, dot(m_contacts[0], a), b, dot(m_contacts[1], b));
    const Function depth = m_weight * (n * (outline[edges[2]] - CGAL::ORIGIN)) - dot(center, n);
    m_contacts[2] = center + times(depth, n / n.squared_length());
  }

  // The path of a vertex.
  Curve path_of_vertex(std::size_t i) const { return path(times(m_weight, m_outline[i] - CGAL::ORIGIN)); }
  Curve path_of_third_finger() const { return path(m_contacts[2]); }

  SC::Rational_motion_2 motion() const
  {
    return SC::Rational_motion_2(
        {{{m_weight * m_cosine, m_weight * m_sine}, {-(m_weight * m_sine), m_weight * m_cosine}}},
        turned_forth(m_shift), m_weight * m_weight);
  }

  // Forces along the normals that add up to zero: whether their moments do, at all times.
  bool is_in_equilibrium() const
  {
    const auto n = [&](std::size_t i) { return normal(m_edges[i % 3]); };
    Function moment = m_weight * Number(0);
    for (std::size_t i = 0; i < 3; ++i)
      moment = moment + dot(m_contacts[i], -turned(n(i))) * cross(n(i + 1), n(i + 2));
    return moment == m_weight * Number(0);
  }

  // All ranges of the time in which the three contacts are inside their edges, their ends to double precision.
  std::vector<std::pair<Number, Number>> ranges() const
  {
    std::vector<Function> conditions;
    std::vector<Number> ends{0, 2};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector a = edge(m_edges[i]);
      const Function behind = dot(m_contacts[i], a) - m_weight * (a * (m_outline[m_edges[i]] - CGAL::ORIGIN)),
                     ahead = m_weight * a.squared_length() - behind;
      conditions.insert(conditions.end(), {behind, ahead});
      const SC::Spline_map<1, 2> distances({behind, ahead}, m_weight);
      const auto [t] = SC::parameters(distances);
      for (const SC::Expression& distance : {distances(t)[0], distances(t)[1]}) {
        const auto zeros = SC::solve(distance == 0);
        if (!zeros.is_complete())
          throw std::runtime_error("contacts with the ends of an edge are undecided");
        for (const auto& zero : zeros)
          ends.emplace_back(zero.point()[0]);
      }
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<Number, Number>> result;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const std::array<Number, 1> middle{(ends[i] + ends[i + 1]) / 2};
      if (std::all_of(conditions.begin(), conditions.end(), [&](const Function& f) { return f(middle) > 0; }))
        result.emplace_back(ends[i], ends[i + 1]);
    }
    return result;
  }

  const std::vector<Point>& outline() const { return m_outline; }

private:
  Vector edge(std::size_t i) const { return m_outline[(i + 1) % m_outline.size()] - m_outline[i]; }
  Vector normal(std::size_t i) const { return -turned(edge(i)); }
  Functions turned_back(const Vector& a) const
  {
    return {m_cosine * a.x() + m_sine * a.y(), m_cosine * a.y() - m_sine * a.x()};
  }
  Functions turned_forth(const Functions& a) const
  {
    return {m_cosine * a[0] - m_sine * a[1], m_sine * a[0] + m_cosine * a[1]};
  }
  Curve path(const Functions& in_part) const
  {
    return Curve::from_homogeneous_coordinates(turned_forth(m_shift + in_part), m_weight * m_weight);
  }
};

double degrees(const SC::Rational_motion_2& motion, const Number& time)
{
  const auto map = motion(time);
  const double angle = std::atan2(CGAL::to_double(map.m(1, 0)), CGAL::to_double(map.m(0, 0))) * 180 / std::acos(-1.);
  return angle < 0 ? angle + 360 : angle;
}

// Prints what is known of a part, and draws it, moved to the right.
void show(SC::SVG_writer& picture, const std::string& name, const Finger_tracking& part,
          const std::vector<std::pair<std::size_t, std::string>>& vertices, const std::vector<Point>& fingers,
          const Number& right)
{
  const CGAL::Aff_transformation_2<K> beside(CGAL::TRANSLATION, Vector(right, 0));
  const SC::Rational_motion_2 motion = part.motion();
  std::cout << name << ": " << (part.is_in_equilibrium() ? "" : "not ") << "in equilibrium";
  for (const auto& [i, color] : vertices)
    std::cout << "; path of vertex " << i << ": degree " << part.path_of_vertex(i).degree() << ", tracing index "
              << SC::tracing_index(part.path_of_vertex(i));
  std::cout << '\n';
  const auto corners = [&](const Number& time) {
    std::vector<Point> result;
    for (std::size_t i = 0; i <= part.outline().size(); ++i)
      result.push_back(beside(motion(time)(part.outline()[i % part.outline().size()])));
    return result;
  };
  const auto ranges = part.ranges();
  for (const auto& range : ranges)
    picture.polygon(corners(range.first), "#e3e3e3");
  for (const auto& [i, color] : vertices)
    picture.curve(part.path_of_vertex(i).transformed(beside), color, 1.2);
  for (const auto& [begin, end] : ranges) {
    std::cout << "  from " << degrees(motion, begin) << " to " << degrees(motion, end) << " degrees\n";
    constexpr int poses = 4;
    for (int k = 0; k <= poses; ++k)
      picture.polyline(corners(begin + (end - begin) * k / poses),
                       "rgb(" + std::to_string(200 - 35 * k) + ',' + std::to_string(190 - 30 * k) + ",200)",
                       k == poses ? 3 : 1.5);
    for (const auto& [i, color] : vertices)
      picture.curve(part.path_of_vertex(i).restricted(begin, end).transformed(beside), color, 3.5);
    const Curve third = part.path_of_third_finger().restricted(begin, end).transformed(beside);
    picture.curve(third, "#d62728", 3.5);
    for (int k = 0; k <= poses; ++k)
      picture.point(third(begin + (end - begin) * k / poses), "#d62728", 9);
  }
  for (const Point& finger : fingers)
    picture.point(beside(finger), "black", 11);
}

// The same in space, for one rotation: how far a part with the faces n.y = d is moved, so that each touches its finger.
bool three_fingers_touch()
{
  using Point_3 = K::Point_3;
  using Vector_3 = K::Vector_3;
  const std::array<Vector_3, 3> normals{Vector_3(-1, 0, 0), Vector_3(0, -1, 2), Vector_3(1, 1, -3)};
  const std::array<Number, 3> distances{0, 1, Number(5) / 2};
  const std::array<Point_3, 3> fingers{Point_3(0, 1, 1), Point_3(2, 0, -1), Point_3(1, 3, 0)};
  int touching = 0;
  for (int k = 0; k < 20; ++k) {
    const Number a = 3 + k, b = 1 - k, c = 2 * k - 5, d = 4, s = a * a + b * b + c * c + d * d;
    const CGAL::Aff_transformation_3<K> rotation(
        a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
        a * a - b * b + c * c - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
        a * a - b * b - c * c + d * d, s);
    const auto dual = [&](int i) {
      const Vector_3 other = CGAL::cross_product(normals[(i + 1) % 3], normals[(i + 2) % 3]);
      return other / (other * normals[i]);
    };
    Vector_3 shift = CGAL::NULL_VECTOR;
    for (int i = 0; i < 3; ++i)
      shift = shift + dual(i) * (rotation(normals[i]) * (fingers[i] - CGAL::ORIGIN) - distances[i]);
    const Vector_3 position = rotation(shift);
    for (int i = 0; i < 3; ++i)
      touching += rotation(normals[i]) * (fingers[i] - CGAL::ORIGIN - position) == distances[i];
  }
  std::cout << "in space, 20 rotations: " << touching << " faces touch their fingers\n";
  return touching == 60;
}

} // namespace

int main()
{
  const Number side = Number(5) / 4;
  const std::vector<Point> square_fingers{{0, 0}, {1, 0}}, triangle_fingers{{0, 0}, {1, Number(1) / 4}};
  const Finger_tracking square({{0, 0}, {side, 0}, {side, side}, {0, side}}, {0, 3, 1},
                               {square_fingers[0], square_fingers[1]});
  const Finger_tracking triangle({{0, 0}, {2, 0}, {Number(1) / 2, Number(3) / 2}}, {0, 2, 1},
                                 {triangle_fingers[0], triangle_fingers[1]});

  std::ofstream file("finger_tracking.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-0.6, -2.05, 5.2, 1.65), 900);
  show(picture, "square", square, {{0, "#1f77b4"}, {1, "#2ca02c"}}, square_fingers, 0);
  show(picture, "triangle", triangle, {{0, "#1f77b4"}}, triangle_fingers, Number(16) / 5);
  picture.label(Point(0.25, 0.55), "circle of Thales", "#1f77b4");
  picture.label(Point(1.5, 1.4), "limaçon", "#2ca02c");
  picture.label(Point(-0.5, -1.78), "fixed fingers (black), third finger (red)");
  picture.label(Point(-0.5, -1.95), "first position (filled) to last one (dark)");

  // In homogeneous coordinates: x^2 + y^2 = x, twice in a turn; and r = side + cos(angle).
  const Curve corner = square.path_of_vertex(0), next = square.path_of_vertex(1);
  const auto squared_norm = [](const Functions& a) { return a[0] * a[0] + a[1] * a[1]; };
  const auto [x, w] = std::pair(corner.homogeneous_coordinates(), corner.weight());
  const bool is_circle = squared_norm(x) == x[0] * w;
  const int turns = SC::proper_reparametrization(corner).times();
  const auto [y, v] = std::pair(next.homogeneous_coordinates(), next.weight());
  const Function part = squared_norm(y) - y[0] * v;
  const bool is_limacon = part * part == squared_norm(y) * v * v * (side * side);
  std::cout << "first corner on the circle of Thales: " << (is_circle ? "yes" : "no") << ", " << turns
            << " times in a turn; next corner on the limaçon: " << (is_limacon ? "yes" : "no") << '\n';

  const bool is_right = is_circle && turns == 2 && is_limacon && SC::tracing_index(corner) == 2 &&
      SC::tracing_index(next) == 1 && square.is_in_equilibrium() && triangle.is_in_equilibrium();
  return three_fingers_touch() && is_right ? 0 : 1;
}
