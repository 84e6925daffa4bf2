// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs do with `--heal TOLERANCE`: they compute with exact primitives in the coordinates in which these are
// simple, and move answers to where the data are.
#ifndef HEALING_H
#define HEALING_H

#include <CGAL/Spline_constraints_d/geometry/healing/exact_primitives.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>

// The number of those recognised, and the largest movement, which is proved.
template <class... Healed>
void print_healing(const Healed&... healed)
{
  namespace SC = CGAL::Spline_constraints;
  std::array<std::size_t, static_cast<std::size_t>(SC::Primitive_kind::UNDECIDED) + 1> count{};
  double displacement = 0;
  bool is_complete = true;
  const auto add = [&](const auto& result) {
    for (const auto& primitive : result.primitives)
      ++count[static_cast<std::size_t>(primitive.kind)];
    displacement = (std::max)(displacement, result.displacement());
    is_complete = is_complete && result.is_complete();
  };
  (add(healed), ...);
  std::cout << "healed:";
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] > 0)
      std::cout << ' ' << count[i] << ' ' << static_cast<SC::Primitive_kind>(i) << ',';
  std::cout << " moved by at most " << displacement << (is_complete ? "" : "; complete: no") << '\n';
}

// A rigid motion for points of any kernel, in doubles.
class Rounded_motion
{
  using K = CGAL::Simple_cartesian<double>;

  K::Aff_transformation_3 m_map{CGAL::IDENTITY};

public:
  Rounded_motion() = default;

  template <class Map>
  explicit Rounded_motion(const Map& map)
    : m_map(number(map, 0, 0), number(map, 0, 1), number(map, 0, 2), number(map, 0, 3), number(map, 1, 0),
            number(map, 1, 1), number(map, 1, 2), number(map, 1, 3), number(map, 2, 0), number(map, 2, 1),
            number(map, 2, 2), number(map, 2, 3))
  {}

  template <class Point>
  K::Point_3 operator()(const Point& p) const
  {
    return m_map.transform(K::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }

private:
  template <class Map>
  static double number(const Map& map, int i, int j)
  {
    return CGAL::to_double(map.cartesian(i, j));
  }
};

#endif // HEALING_H
