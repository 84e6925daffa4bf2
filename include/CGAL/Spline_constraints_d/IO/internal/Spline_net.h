// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_H

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A curve or surface as files list it: control points with the first axis fastest, the weight last if there is one. On
// a periodic axis the first points come again at the end.
class Spline_net
{
  struct Axis
  {
    int size = 0, order = 0;
    std::vector<Exact_rational> knots;
    bool is_periodic = false;

    int unwrapped_size() const { return is_periodic ? size + order - 1 : size; }
  };

public:
  std::vector<Axis> axes;
  std::vector<std::vector<Exact_rational>> points;
  int dimension = 0;
  bool is_rational = false;

  std::size_t number_of_points() const
  {
    std::size_t result = 1;
    for (const Axis& axis : axes)
      result *= static_cast<std::size_t>(axis.size);
    return result;
  }

  template <SplineKernel Kernel>
  void add_to(Spline_file<Kernel>& file, std::string name, const std::pair<int, int>& place) const
  {
    const auto add = [&]<class Object>(std::vector<Spline_file_entry<Object>>& entries) {
      entries.push_back({object<Object>(), std::move(name), place.first, place.second});
    };
    if (axes.size() == 1 && dimension == 2)
      add(file.curves_2);
    else if (axes.size() == 1 && dimension == 3)
      add(file.curves_3);
    else if (dimension == 3)
      add(file.surfaces_3);
    else
      throw Invalid_input("surfaces in the plane are not supported");
  }

private:
  template <class Object>
  Object object() const
  {
    constexpr int d = Object::ambient_dimension;
    using Map = Homogeneous_spline<Exact_rational, d>;
    std::vector<Bspline_function<Exact_rational>> functions;
    std::vector<int> degrees;
    std::vector<std::vector<Exact_rational>> knots;
    for (const Axis& axis : axes) {
      degrees.push_back(axis.order - 1);
      knots.push_back(axis.knots);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(d + (is_rational ? 1 : 0)); ++i)
      functions.emplace_back(degrees, knots, coefficients(i));
    const Map map(std::move(functions), "a curve or surface");
    if constexpr (std::same_as<typename Object::Number_type, Exact_rational>)
      return Object(map);
    else
      return Object(map.template converted<double>("a curve or surface"));
  }

  // Of one homogeneous coordinate, the last axis fastest.
  std::vector<Exact_rational> coefficients(std::size_t coordinate) const
  {
    const int columns = axes.size() == 1 ? 1 : axes[1].unwrapped_size();
    std::vector<Exact_rational> result;
    for (int i = 0; i < axes[0].unwrapped_size(); ++i)
      for (int j = 0; j < columns; ++j)
        result.push_back(
            points[static_cast<std::size_t>(i % axes[0].size) +
                   static_cast<std::size_t>(axes.size() == 1 ? 0 : j % axes[1].size) * axes[0].size][coordinate]);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_H
