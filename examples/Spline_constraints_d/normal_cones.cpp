// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Normal cones and tangent cones of two equations on two boxes: the test of Elber and Kim whether a box holds at most
// one solution.
//
// The normal cone of an equation f = 0 on a box holds all of its gradients: it is spanned by the control vectors of the
// gradient, which are the coefficients of the derivatives of f in Bernstein form. Chords between solutions of f = 0 in
// the box are in the tangent cone, which consists of all vectors that are orthogonal to one of the normal cone. Where
// the tangent cones of both equations have nothing but the origin in common, no chord joins two common solutions.
//
// Writes normal_cones.svg: above, a box with two solutions, and cones that meet; below, a smaller box, and cones that
// do not. Exit status: 0 when the cones are as said, else 1.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Number = SC::Exact_rational;
using Spline = SC::Bspline_function<Number>;
using Box = std::array<std::pair<Number, Number>, 2>;

const std::string colors[] = {"#d62728", "#1f77b4"}, pale[] = {"#d6272850", "#1f77b450"};

// An ellipse and a cubic curve; x and y are unknowns or splines.
template <class T>
std::array<T, 2> equations(const T& x, const T& y)
{
  return {x * x * Number(1, 2) + y * y - Number(1), y * Number(2) - x * x * x + x};
}

// All vectors (cos a, sin a) and their opposites with an angle to the axis of at most this one.
struct Cone
{
  std::vector<K::Vector_2> spanned_by;
  double direction, angle; // the angle is a right one where there is no cone
};

Cone normal_cone(const Spline& f, const Box& box)
{
  const Spline part = f.restricted(0, box[0].first, box[0].second).restricted(1, box[1].first, box[1].second),
               f_x = part.derivative(0).elevated(part.degrees()), f_y = part.derivative(1).elevated(part.degrees());
  Cone cone{{}, 0, 0};
  K::Vector_2 sum(0, 0);
  for (std::size_t i = 0; i < f_x.coefficients().size(); ++i) {
    const K::Vector_2 v(CGAL::to_double(f_x.coefficients()[i]), CGAL::to_double(f_y.coefficients()[i]));
    cone.spanned_by.push_back(v);
    if (v == K::Vector_2(0, 0))
      cone.angle = std::acos(0.0);   // a vector without a direction
    else
      sum += v / std::sqrt(v.squared_length());
  }
  cone.direction = std::atan2(sum.y(), sum.x());
  for (const K::Vector_2& v : cone.spanned_by)
    cone.angle = (std::max)(cone.angle,
                            std::abs(std::remainder(std::atan2(v.y(), v.x()) - cone.direction, 2 * std::acos(-1.0))));
  cone.angle = (std::min)(cone.angle, std::acos(0.0));
  return cone;
}

// The vectors that are orthogonal to one of the normal cone.
Cone tangent_cone(const Cone& normals) { return {{}, normals.direction + std::acos(0.0), normals.angle}; }

bool meet_in_origin_only(const Cone& a, const Cone& b)
{
  return std::abs(std::remainder(a.direction - b.direction, std::acos(-1.0))) > a.angle + b.angle;
}

K::Point_2 at(const K::Point_2& origin, double radius, double angle)
{
  return origin + radius * K::Vector_2(std::cos(angle), std::sin(angle));
}

void draw(SC::SVG_writer& picture, const Cone& cone, const K::Point_2& origin, double radius, const std::string& color)
{
  for (const double side : {0.0, std::acos(-1.0)}) {
    std::vector<K::Point_2> corners{origin};
    for (int i = -16; i <= 16; ++i)
      corners.push_back(at(origin, radius, side + cone.direction + i * cone.angle / 16));
    picture.polygon(corners, color);
  }
}

// The box with the curves in it, beside it the normal cones with their control vectors, and the tangent cones.
bool draw_row(SC::SVG_writer& picture, const Box& box, double height)
{
  const Box whole{std::pair(Number(-2), Number(2)), std::pair(Number(-2), Number(2))};
  const std::vector<Number> knots{-2, -2, 2, 2};
  const std::array<Spline, 2> splines =
      equations(Spline({1, 1}, {knots, knots}, {-2, -2, 2, 2}), Spline({1, 1}, {knots, knots}, {-2, 2, -2, 2}));
  const K::Vector_2 up(0, height);
  const K::Point_2 normals_at(4, height), tangents_at(8, height);
  const double left = CGAL::to_double(box[0].first), right = CGAL::to_double(box[0].second),
               low = CGAL::to_double(box[1].first), high = CGAL::to_double(box[1].second);
  picture.polygon(std::vector<K::Point_2>{K::Point_2(left, low) + up, K::Point_2(right, low) + up,
                                          K::Point_2(right, high) + up, K::Point_2(left, high) + up},
                  "#ffe9b0");
  auto [x, y] = SC::unknowns({whole[0].first, whole[0].second}, {whole[1].first, whole[1].second});
  std::array<Cone, 2> tangents;
  for (const std::size_t i : {0, 1}) {
    const SC::Constraint_system_d system =
        make_system(std::vector<SC::Constraint>{equations(SC::Expression(x), SC::Expression(y))[i] == 0});
    const SC::Curve_solution_set_d set = SC::solve_curves(system);
    for (const SC::Solution_curve& curve : set.curves()) {
      std::vector<K::Point_2> points;
      for (const std::vector<double>& p : SC::to_polyline(system, set, curve, 1e-3))
        points.push_back(K::Point_2(p[0], p[1]) + up);
      picture.polyline(points, colors[i], 2);
    }
    const Cone normals = normal_cone(splines[i], box);
    tangents[i] = tangent_cone(normals);
    draw(picture, normals, normals_at, 1.5, pale[i]);
    draw(picture, tangents[i], tangents_at, 1.5, pale[i]);
    double longest = 0;
    for (const K::Vector_2& v : normals.spanned_by)
      longest = (std::max)(longest, std::sqrt(v.squared_length()));
    for (const K::Vector_2& v : normals.spanned_by)
      picture.polyline(std::vector<K::Point_2>{normals_at, normals_at + 1.4 / longest * v}, colors[i], 1.5);
  }
  auto [u, v] = SC::unknowns({box[0].first, box[0].second}, {box[1].first, box[1].second});
  const auto [f, g] = equations(SC::Expression(u), SC::Expression(v));
  const auto solutions = SC::solve(f == 0, g == 0);
  for (const auto& solution : solutions)
    picture.point(K::Point_2(solution.point()[0], solution.point()[1]) + up, "black", 9);
  const bool has_at_most_one = meet_in_origin_only(tangents[0], tangents[1]);
  const std::string count = std::to_string(solutions.size());
  picture.label(K::Point_2(-1.9, height - 2.2), solutions.size() == 1 ? "one solution" : count + " solutions");
  picture.label(K::Point_2(3.1, height - 2.2), "normal cones");
  picture.label(K::Point_2(6, height - 2.2),
                has_at_most_one ? "tangent cones: at most one solution" : "tangent cones: not decided");
  std::cout << count << " solutions in the box, the tangent cones "
            << (has_at_most_one ? "meet in the origin only\n" : "have more than the origin in common\n");
  return has_at_most_one;
}

int main()
{
  std::ofstream file("normal_cones.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-2.2, -2.5, 10.5, 6.6), 760);
  const bool is_first_decided = draw_row(
                 picture, {std::pair(Number(-7, 4), Number(7, 4)), std::pair(Number(-5, 4), Number(5, 4))}, 4.5),
             is_second_decided =
                 draw_row(picture, {std::pair(Number(1), Number(7, 4)), std::pair(Number(1, 10), Number(1))}, 0);
  return !is_first_decided && is_second_decided ? 0 : 1;
}
