// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pairs of planes, spheres, cylinders, cones, tori, ruled and bicubic patches in positions that mechanical parts have,
// with what they have in common.

#ifndef TEST_PAIRS_OF_PRIMITIVES_H
#define TEST_PAIRS_OF_PRIMITIVES_H

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace pairs_of_primitives {

using Polynomial = SC::Power_polynomial;

// A patch, and the equation of all of its surface.
struct Primitive
{
  Surface patch;
  Polynomial equation;
};

// What two primitives have in common: as patches, as a patch and a surface, as a surface and a patch, as surfaces. The
// numbers of closed and open curves and of singular points; u where parts of them coincide.
struct Pair
{
  std::string name;
  Primitive a, b;
  std::array<std::string, 4> counts;
  bool has_common_pole = false;   // then the answer may be undecided
};

using Coordinates = std::array<Polynomial, 3>;

inline Coordinates from(const Point& p)
{
  return {Polynomial::variable(0) - Polynomial(p.x()), Polynomial::variable(1) - Polynomial(p.y()),
          Polynomial::variable(2) - Polynomial(p.z())};
}
inline Polynomial dot(const Coordinates& q, const Vector& d)
{
  return Polynomial(d.x()) * q[0] + Polynomial(d.y()) * q[1] + Polynomial(d.z()) * q[2];
}
inline Polynomial square(const Coordinates& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2]; }

inline Primitive plane(const Point& p, const Vector& a, const Vector& b)
{
  return {SC::plane_patch<K>(p, a, b), dot(from(p), CGAL::cross_product(a, b))};
}

inline Primitive sphere(const Point& c, const Rational& radius)
{
  return {SC::sphere_surface<K>(c, radius), square(from(c)) - Polynomial(Rational(radius * radius))};
}

inline Primitive cylinder(const Point& c, const Vector& d, const Point& source)
{
  const Rational dd = d * d, along = (source - c) * d, radius = (source - c).squared_length() * dd - along * along;
  return {SC::cylinder_surface<K>(c, d, source),
          Polynomial(dd) * square(from(c)) - dot(from(c), d) * dot(from(c), d) - Polynomial(radius)};
}

// The part between two shares of the segment from the apex to the source.
inline Primitive cone(const Point& apex, const Vector& d, const Point& source, const Rational& begin = 0)
{
  const Rational along = (source - apex) * d, length = (source - apex).squared_length();
  const Surface all = SC::cone_surface<K>(apex, d, source);
  return {begin == 0 ? all : all.restricted(1, begin, Rational(1)),
          Polynomial(Rational(along * along)) * square(from(apex)) -
              Polynomial(length) * dot(from(apex), d) * dot(from(apex), d)};
}

inline Primitive torus(const Point& c, const Vector& d, const Point& spine, const Rational& ratio)
{
  const Rational dd = d * d, major = (spine - c).squared_length(), minor = major * ratio * ratio;
  const Polynomial q = square(from(c)), along = dot(from(c), d), sum = q + Polynomial(Rational(major - minor));
  return {SC::torus_surface<K>(c, d, spine, ratio),
          Polynomial(dd) * sum * sum - Polynomial(Rational(4 * major)) * (Polynomial(dd) * q - along * along)};
}

// z = x y / 2 over the square of this half side, moved upwards.
inline Primitive saddle(const Rational& side, const Rational& height)
{
  const auto corner = [&](int i, int j) { return Point(i * side, j * side, i * j * side * side / 2 + height); };
  return {SC::bilinear_surface<K>(corner(-1, -1), corner(-1, 1), corner(1, -1), corner(1, 1)),
          Polynomial::variable(2) - Polynomial(height) -
              Polynomial(Rational(1, 2)) * Polynomial::variable(0) * Polynomial::variable(1)};
}

inline Rational q(int p, int q) { return Rational(p, q); }

inline std::vector<Pair> all_pairs()
{
  const Vector x(1, 0, 0), z(0, 0, 1);
  const auto board = [](const Rational& height) {
    return plane(Point(-5, -4, height), Vector(11, 0, 0), Vector(0, 9, 0));
  };
  const auto wall_x = [](const Rational& c) { return plane(Point(c, -5, -4), Vector(0, 11, 0), Vector(0, 0, 9)); };
  const auto wall_y = [](const Rational& c) { return plane(Point(-5, c, -4), Vector(11, 0, 0), Vector(0, 0, 9)); };
  const auto along_x = [](const Rational& y, const Rational& z, const Rational& r) {
    return cylinder(Point(-4, y, z), Vector(8, 0, 0), Point(-4, y, z + r));
  };
  const auto ball = [](const Rational& x, const Rational& y, const Rational& z, const Rational& r) {
    return sphere(Point(x, y, z), r);
  };
  const Primitive tube = cylinder(Point(0, 0, -3), Vector(0, 0, 6), Point(1, 0, -3));
  const Primitive tip = cone(Point(0, 0, 0), z, Point(3, 0, 4));
  const Primitive ring = torus(Point(0, 0, 0), z, Point(3, 0, 0), q(1, 3));
  const Primitive rectangle = plane(Point(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0));
  const auto same = [](const char* counts) { return std::array<std::string, 4>{counts, counts, counts, counts}; };
  std::vector<Pair> result{
      {"planes cross", board(0), wall_y(q(1, 3)), same("0/1/0")},
      {"planes share an edge", rectangle, plane(Point(0, 0, 0), Vector(2, 0, 0), Vector(0, 0, 1)), same("0/1/0")},
      {"planes share a part of an edge", rectangle, plane(Point(1, 0, 0), Vector(2, 0, 0), Vector(0, 0, 1)),
       same("0/1/0")},
      {"edge of a plane in another one", rectangle, plane(Point(q(1, 2), 1, 0), Vector(1, 0, 0), Vector(0, 0, 1)),
       same("0/1/0")},
      {"planes share an edge, oblique", rectangle, plane(Point(0, 0, 0), Vector(2, 0, 0), Vector(q(1, 3), q(-1, 2), 1)),
       same("0/1/0")},
      {"coplanar, a common edge", rectangle, plane(Point(0, 0, 0), Vector(2, 0, 0), Vector(0, -1, 0)), same("u")},
      {"planes coincide", rectangle, plane(Point(1, 1, 0), Vector(2, 0, 0), Vector(0, 3, 0)), same("u")},
      {"plane, sphere", board(1), ball(0, 0, q(1, 3), 2), same("1/0/0")},
      {"plane, sphere: equator", board(q(1, 3)), ball(0, 0, q(1, 3), 2), same("1/0/0")},
      {"plane, sphere: meridian", wall_y(0), ball(0, 0, q(1, 3), 2), same("1/0/0")},
      {"plane, sphere: oblique great circle", plane(Point(-3, -3, q(-13, 6)), Vector(6, 0, 3), Vector(0, 6, 2)),
       ball(0, 0, q(1, 3), 2), same("1/0/0")},
      {"plane touches sphere", plane(Point(q(6, 5) + 4, q(8, 5) - 3, -1), Vector(-8, 6, 0), Vector(0, 0, 3)),
       ball(0, 0, q(1, 3), 2), same("0/0/1")},
      {"plane touches sphere at pole", board(q(7, 3)), ball(0, 0, q(1, 3), 2), same("0/0/1")},
      {"plane across cylinder", board(q(1, 2)), tube, same("1/0/0")},
      {"plane oblique to cylinder", plane(Point(-3, -3, q(-5, 2)), Vector(6, 0, 3), Vector(0, 6, 2)), tube,
       same("1/0/0")},
      {"plane along cylinder", wall_y(q(3, 5)), tube, same("0/2/0")},
      {"plane through axis of cylinder", wall_y(0), tube, same("0/2/0")},
      {"plane touches cylinder", wall_y(1), tube, same("0/1/0")},
      {"plane touches cylinder at seam", wall_x(1), tube, same("0/1/0")},
      {"plane touches cylinder elsewhere",
       plane(Point(q(3, 5) + 4, q(4, 5) - 3, -4), Vector(-8, 6, 0), Vector(0, 0, 8)), tube, same("0/1/0")},
      {"cap of cylinder", board(-3), tube, same("1/0/0")},
      {"plane across cone", board(2), tip, same("1/0/0")},
      {"plane oblique to cone", plane(Point(-5, -5, q(3, 4)), Vector(10, 0, q(5, 2)), Vector(0, 10, 0)), tip,
       same("1/0/0")},
      {"plane, cone: hyperbola", wall_y(1), tip, {"0/1/0", "0/2/0", "0/1/0", "0/2/0"}},
      {"plane, cone: parabola", plane(Point(-3, -4, -3), Vector(6, 0, 8), Vector(0, 8, 0)), tip, same("0/1/0")},
      {"plane, cone: lines", wall_y(0), tip, {"0/2/1", "0/4/1", "0/2/1", "0/4/1"}, true},
      // the apex is a pole of the patch, where the line ends
      {"plane touches cone",
       plane(Point(q(-9, 5) + 4, q(-12, 5) - 3, -4), Vector(q(18, 5), q(24, 5), 8), Vector(-8, 6, 0)),
       tip,
       {"0/1/1", "0/1/0", "0/1/1", "0/1/0"},
       true},
      {"plane touches cone at seam",
       plane(Point(-3, -3, -4), Vector(6, 0, 8), Vector(0, 7, 0)),
       tip,
       {"0/1/1", "0/1/0", "0/1/1", "0/1/0"},
       true},
      {"cap of cone", board(4), tip, same("1/0/0")},
      {"plane, apex of cone", board(0), tip, same("0/0/1"), true},
      {"cap of frustum", board(2), cone(Point(0, 0, 0), z, Point(3, 0, 4), q(1, 2)), same("1/0/0")},
      {"torus on plane", board(1), ring, same("1/0/0")},
      {"torus, equators", board(0), ring, same("2/0/0")},
      {"torus, meridians", wall_y(0), ring, same("2/0/0")},
      {"torus, two loops", wall_y(1), ring, same("2/0/0")},
      {"torus, one loop", wall_y(3), ring, same("1/0/0")},
      {"plane touches torus inside", wall_y(2), ring, same("0/2/1")},
      {"plane touches torus outside", wall_y(4), ring, same("0/0/1")},
      {"torus, Villarceau", plane(Point(-4, -5, -3), Vector(8, 0, 6), Vector(0, 10, 0)),
       torus(Point(0, 0, 0), z, Point(q(5, 2), 0, 0), q(3, 5)), same("0/4/2")},
      {"plane, saddle", board(q(1, 2)), saddle(2, 0), same("0/2/0")},
      {"plane touches saddle", board(0), saddle(2, 0), same("0/4/1")},
      {"plane at edge of saddle", wall_x(2), saddle(2, 0), same("0/1/0")},
      {"spheres", ball(0, 0, 0, 2), ball(1, q(1, 2), q(1, 3), 2), same("1/0/0")},
      {"spheres, one axis", ball(0, 0, 0, 2), ball(0, 0, 1, 2), same("1/0/0")},
      {"spheres touch outside", ball(0, 0, 0, 2), ball(1, 2, 2, 1), same("0/0/1")},
      {"spheres touch outside at equators", ball(0, 0, 0, 2), ball(q(9, 5), q(12, 5), 0, 1), same("0/0/1")},
      {"spheres touch outside at poles", ball(0, 0, 0, 2), ball(0, 0, 3, 1), same("0/0/1"), true},
      {"spheres touch inside", ball(0, 0, 0, 2), ball(q(1, 3), q(2, 3), q(2, 3), 1), same("0/0/1")},
      {"concentric spheres", ball(0, 0, 0, 2), ball(0, 0, 0, 1), same("0/0/0")},
      {"spheres coincide", ball(0, 0, 0, 2), ball(0, 0, 0, 2), same("u")},
      {"ball in tube", tube, ball(0, 0, q(1, 3), 1), same("1/0/0")},
      {"cylinder, sphere: one axis", tube, ball(0, 0, q(1, 3), 2), same("2/0/0")},
      {"cylinder, sphere: one loop", tube, ball(q(3, 2), q(1, 2), q(1, 3), 1), same("1/0/0")},
      {"cylinder, sphere: two loops", tube, ball(q(1, 2), q(1, 3), q(1, 5), 2), same("2/0/0")},
      {"cylinder, sphere: Viviani", tube, ball(1, 0, 0, 2), same("0/2/1")},
      {"cylinder touches sphere", tube, ball(q(9, 5), q(12, 5), q(1, 3), 2), same("0/0/1")},
      {"tube with round end", tube, ball(0, 0, 3, 1), same("1/0/0")},
      {"ball in cone", tip, ball(0, 0, q(5, 2), q(3, 2)), same("1/0/0")},
      {"cone, sphere: one axis", tip, ball(0, 0, 2, q(3, 2)), same("2/0/0")},
      {"sphere around apex", tip, ball(0, 0, 0, 2), {"1/0/0", "1/0/0", "2/0/0", "2/0/0"}},
      {"cone, sphere: one loop", tip, ball(1, q(1, 2), 2, 1), same("1/0/0")},
      {"apex on sphere", tip, ball(0, 0, 2, 2), same("1/0/1"), true},
      {"ball in torus", ring, ball(q(9, 5), q(12, 5), 0, 1), same("1/0/0")},
      {"ball in torus at seam", ring, ball(3, 0, 0, 1), same("1/0/0")},
      {"torus in sphere", ring, ball(0, 0, 0, 4), same("1/0/0")},
      {"torus around sphere", ring, ball(0, 0, 0, 2), same("1/0/0")},
      {"torus, sphere: one center", ring, ball(0, 0, 0, 3), same("2/0/0")},
      {"torus, sphere", ring, ball(3, q(1, 2), q(1, 3), q(3, 2)), same("2/0/0")},
      {"parallel cylinders", tube, cylinder(Point(1, q(1, 2), -4), Vector(0, 0, 8), Point(2, q(1, 2), -4)),
       same("0/2/0")},
      {"parallel cylinders touch", tube,
       cylinder(Point(q(6, 5), q(8, 5), -4), Vector(0, 0, 8), Point(q(6, 5) + 1, q(8, 5), -4)), same("0/1/0")},
      {"parallel cylinders touch at seam", tube, cylinder(Point(2, 0, -4), Vector(0, 0, 8), Point(3, 0, -4)),
       same("0/1/0")},
      {"parallel cylinders touch inside", tube, cylinder(Point(q(1, 2), 0, -4), Vector(0, 0, 8), Point(1, 0, -4)),
       same("0/1/0")},
      {"coaxial cylinders", tube, cylinder(Point(0, 0, -4), Vector(0, 0, 8), Point(2, 0, -4)), same("0/0/0")},
      {"cylinders coincide", tube, cylinder(Point(0, 0, -4), Vector(0, 0, 8), Point(1, 0, -4)), same("u")},
      {"cylinders: T", tube, along_x(0, 0, q(1, 2)), same("2/0/0")},
      {"cylinders: branch",
       tube,
       cylinder(Point(0, 0, 0), Vector(4, 0, 0), Point(0, 0, q(1, 2))),
       {"1/0/0", "2/0/0", "1/0/0", "2/0/0"}},
      {"cylinders, skew", tube, along_x(q(1, 3), q(1, 5), q(1, 2)), same("2/0/0")},
      {"equal pipes", tube, along_x(0, 0, 1), same("0/4/2")},
      {"equal pipes: branch",
       tube,
       cylinder(Point(0, 0, 0), Vector(4, 0, 0), Point(0, 0, 1)),
       {"0/2/2", "0/4/2", "0/2/2", "0/4/2"}},
      {"equal pipes, oblique", tube, cylinder(Point(-4, 0, -3), Vector(8, 0, 6), Point(-4, 1, -3)), same("0/4/2")},
      {"cylinders touch and cross", tube, along_x(q(1, 2), 0, q(1, 2)), same("0/2/1")},
      {"cylinders touch", tube, along_x(q(3, 2), 0, q(1, 2)), same("0/0/1")},
      {"cylinder, cone: one axis",
       tube,
       cone(Point(0, 0, -2), z, Point(3, 0, 2)),
       {"1/0/0", "1/0/0", "1/0/0", "2/0/0"}},
      {"chamfer of cylinder",
       tube,
       cone(Point(0, 0, 5), Vector(0, 0, -1), Point(1, 0, 3), q(1, 2)),
       {"1/0/0", "1/0/0", "1/0/0", "2/0/0"}},
      {"cylinder through cone", along_x(0, 2, q(1, 2)), tip, same("2/0/0")},
      {"cylinder, cone: one sphere inside", cylinder(Point(-5, 0, q(5, 2)), Vector(10, 0, 0), Point(-5, 0, 4)),
       cone(Point(0, 0, 0), z, Point(q(9, 2), 0, 6)), same("0/4/2")},
      {"cylinder, torus: one axis", cylinder(Point(0, 0, -2), Vector(0, 0, 4), Point(3, 0, -2)), ring, same("2/0/0")},
      {"cylinder around torus", cylinder(Point(0, 0, -2), Vector(0, 0, 4), Point(4, 0, -2)), ring, same("1/0/0")},
      {"cylinder in torus", cylinder(Point(0, 0, -2), Vector(0, 0, 4), Point(2, 0, -2)), ring, same("1/0/0")},
      {"pipe in torus", cylinder(Point(3, -5, 0), Vector(0, 10, 0), Point(4, -5, 0)), ring, same("0/4/2")},
      {"elbow",
       cylinder(Point(3, 0, 0), Vector(0, 4, 0), Point(4, 0, 0)),
       {ring.patch.restricted(0, Rational(3), Rational(4)), ring.equation},
       {"1/0/0", "0/3/2", "0/3/2", "0/4/2"}},
      {"pipe through torus", along_x(0, 0, q(1, 2)), ring, same("4/0/0")},
      {"cones, one axis", tip, cone(Point(0, 0, 4), Vector(0, 0, -1), Point(3, 0, 0)), same("1/0/0")},
      {"equal cones, parallel", tip, cone(Point(1, 0, 0), z, Point(4, 0, 4)), {"0/1/0", "0/1/0", "0/1/0", "0/2/0"}},
      {"cones, one apex", tip, cone(Point(0, 0, 0), x, Point(4, 4, 0)), same("0/0/1"), true},
      {"cones cross", tip, cone(Point(-4, 0, 2), x, Point(4, 0, 3)), same("2/0/0")},
      {"cone, torus: one axis", tip, torus(Point(0, 0, 2), z, Point(q(3, 2), 0, 2), q(1, 3)), same("2/0/0")},
      {"fillet of cone", tip, torus(Point(0, 0, q(17, 10)), z, Point(q(19, 10), 0, q(17, 10)), q(5, 19)),
       same("1/0/0")},
      {"cone, torus", tip, ring, same("0/0/0")},
      {"tori in a chain", ring, torus(Point(3, 0, 0), Vector(0, 1, 0), Point(6, 0, 0), q(1, 3)), same("0/0/0")},
      {"tori touch at equators", ring, torus(Point(0, 0, 0), z, Point(5, 0, 0), q(1, 5)), same("1/0/0")},
      {"tori, one axis", ring, torus(Point(0, 0, 1), z, Point(3, 0, 1), q(1, 3)), same("2/0/0")},
      {"tori touch along meridian", ring, torus(Point(6, 0, 0), z, Point(3, 0, 0), q(1, 3)), same("0/4/2")},
      {"tori touch along meridian, other axis", ring, torus(Point(3, 0, 3), x, Point(3, 0, 0), q(1, 3)), same("0/4/2")},
      {"bend",
       {ring.patch.restricted(0, Rational(3), Rational(4)), ring.equation},
       {torus(Point(6, 0, 0), z, Point(3, 0, 0), q(1, 3)).patch.restricted(0, Rational(3), Rational(4)),
        torus(Point(6, 0, 0), z, Point(3, 0, 0), q(1, 3)).equation},
       {"1/0/0", "0/3/2", "0/3/2", "0/4/2"}},
      {"tori", ring, torus(Point(1, q(1, 2), q(1, 3)), z, Point(4, q(1, 2), q(1, 3)), q(1, 3)), same("2/0/0")},
      {"saddle, sphere", saddle(2, 0), ball(0, 0, 0, 1), same("1/0/0")},
      {"saddle, cylinder", saddle(2, 0), tube, same("1/0/0")},
      {"saddle, cone", saddle(2, 1), tip, {"1/0/0", "1/0/0", "1/0/0", "1/2/0"}},
      {"saddle, torus", saddle(2, 0), torus(Point(0, 0, 0), z, Point(1, 0, 0), q(1, 3)), same("2/0/0")},
  };
  return result;
}

} // namespace pairs_of_primitives

#endif // TEST_PAIRS_OF_PRIMITIVES_H
