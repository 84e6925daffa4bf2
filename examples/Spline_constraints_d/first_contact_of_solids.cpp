// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// When a moving solid first meets another one, proved to be the first time, and where.
//
//   first_contact_of_solids MOVING FIXED PATH [--time-limit S] [--output FILE.svg]
//
// Files of .g2 or .itd: the surfaces that bound two solids, whose edges are seams, poles, or common to two of them, and
// a curve in space, along which the first one is translated. Without arguments, a cylinder tumbles and hits a ball over
// a table, and first_contact_of_solids.svg shows it. The picture has the moving solid at regular times before in blue,
// and in the first contact, which is red, in orange.
// Exit status: 0 when all is proved, 3 when something is not, 2 for bad input.
#include "arguments.h"
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_3.h>

#include <exception>
#include <fstream>
#include <optional>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using Point = Kernel_of_operands::Point_3;
using Vector = Kernel_of_operands::Vector_3;
using Motion = SC::Rational_motion_3;
using Function = Motion::Function;
using Solid = std::vector<Surface_operand>;

namespace {

struct Example
{
  Solid moving;
  Motion motion;
  Solid fixed;
};

// The six faces, with normals that point outwards.
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
      result.push_back(Surface_operand({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, points));
    }
  return result;
}

// Around the vertical axis: a disk, the side, and another disk.
Solid cylinder(double radius, double height)
{
  const std::vector<Point> profile{
      {0, 0, -height / 2}, {radius, 0, -height / 2}, {radius, 0, height / 2}, {0, 0, height / 2}};
  Solid result;
  for (std::size_t i = 1; i < profile.size(); ++i)
    result.push_back(SC::surface_of_revolution(Curve_operand(1, {0, 0, 1, 1}, {profile[i - 1], profile[i]}),
                                               Point(0, 0, 0), Vector(0, 0, 1)));
  return result;
}

// The cylinder turns about a line through its middle, which runs along a parabola.
Example own_example()
{
  const Curve_operand path(2, {0, 0, 0, 1, 1, 1}, {{-4, -1, 3}, {-1, -0.5, 5}, {2.5, 0.25, 0}});
  const Motion turn = Motion::rotation(Point(0, 0, 0), Vector(1, 2, 0.5), Function({0}, {{0, 1}}, {1}),
                                       Function({1}, {{0, 0, 1, 1}}, {0, 1}));
  Solid fixed = box(Point(-5, -2, -0.25), Point(4, 2, 0));
  fixed.push_back(SC::sphere_surface<Kernel_of_operands>(Point(1.75, 0.25, 1), 0.75));
  return {cylinder(0.5, 2), Motion::along(path) * turn, fixed};
}

Surface_operand moved(const Surface_operand& surface, const Motion& motion, const Number& time)
{
  const auto map = motion(time);
  const auto entry = [&](int i, int k) { return CGAL::to_double(map.m(i, k)); };
  return surface.transformed({entry(0, 0), entry(0, 1), entry(0, 2), entry(0, 3), entry(1, 0), entry(1, 1), entry(1, 2),
                              entry(1, 3), entry(2, 0), entry(2, 1), entry(2, 2), entry(2, 3)});
}

void draw(const std::string& path, const Example& example, const SC::First_contact_3& contact)
{
  SC::Scene_3 scene({.to_viewer = {-0.3, -0.9, 0.4}, .width = 800});
  const auto add = [&](const Surface_operand& surface, const CGAL::IO::Color& color) {
    const bool is_flat = surface.degree(0) == 1 && surface.degree(1) == 1;
    scene.add(grid_on(surface, is_flat ? 1 : 16), {.color = color});
  };
  for (const Surface_operand& surface : example.fixed)
    add(surface, CGAL::IO::Color(215, 215, 215));
  const auto [begin, end] = example.motion.domain();
  const Number last = contact.time_range() ? contact.time_range()->first : end;
  constexpr int poses = 4;
  for (int i = 0; i <= poses; ++i)
    for (const Surface_operand& surface : example.moving)
      add(moved(surface, example.motion, begin + (last - begin) * i / poses),
          i < poses ? CGAL::IO::Color(190, 215, 240) : CGAL::IO::Color(240, 190, 120));
  for (const SC::Contact_3& c : contact.contacts())
    scene.add_point(
        Point(CGAL::to_double(c.point[0].first), CGAL::to_double(c.point[1].first), CGAL::to_double(c.point[2].first)),
        {.color = "#d62728", .width = 9, .nearer = 1});
  std::ofstream out(path);
  scene.write(out);
  if (!out.flush())
    throw SC::Invalid_input("--output: " + path + " cannot be written");
}

int print(const SC::First_contact_3& contact)
{
  for (const SC::Contact_3& c : contact.contacts())
    std::cout << c.places[0].part << " on " << c.places[1].part << " at " << CGAL::to_double(c.point[0].first) << ", "
              << CGAL::to_double(c.point[1].first) << ", " << CGAL::to_double(c.point[2].first) << '\n';
  for (const auto& part : contact.undecided())
    std::cout << part << '\n';
  std::cout << "at first: " << contact.state_at_begin() << "; first contact: ";
  if (!contact.time_range())
    std::cout << "none";
  else
    std::cout << CGAL::to_double(contact.time_range()->first) << " to " << CGAL::to_double(contact.time_range()->second)
              << ", proved: " << (CGAL::certainly(contact.do_meet()) ? "yes" : "no");
  std::cout << "; complete: " << (contact.is_complete() ? "yes" : "no") << '\n';
  return contact.is_complete() ? 0 : 3;
}

} // namespace

int main(int argc, char** argv)
try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<std::string> files;
  std::optional<std::string> output;
  SC::Solver_options options;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--time-limit" && i + 1 < words.size())
      options.time_limit = number_of<double>(words[++i]);
    else if (words[i] == "--output" && i + 1 < words.size())
      output = words[++i];
    else
      files.push_back(words[i]);
  if (!files.empty() && files.size() != 3)
    throw SC::Invalid_input("usage: first_contact_of_solids MOVING FIXED PATH [--time-limit S] [--output FILE.svg]");
  const Example example = files.empty()
      ? own_example()
      : Example{surfaces_in(files[0]), Motion::along(curve_in(files[2])), surfaces_in(files[1])};
  const SC::First_contact_3 contact = SC::first_contact(example.moving, example.motion, example.fixed, options);
  if (files.empty() && !output)
    output = "first_contact_of_solids.svg";
  if (output)
    draw(*output, example, contact);
  return print(contact);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
