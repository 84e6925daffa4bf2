// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_BOUNDARY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_BOUNDARY_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/corner_fans.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// A side of a patch on the unit square, where one parameter is 0 or 1.
struct Patch_side
{
  std::size_t patch = 0;
  int side = 0; // u = 0, u = 1, v = 0, v = 1

  int axis() const { return side / 2; } // that is constant
  int end() const { return side % 2; }
  int free_axis() const { return 1 - axis(); }

  // Whether the boundary of the patch, anticlockwise, goes with the parameter.
  bool is_forward() const { return side == 1 || side == 2; }

  // Of a corner, 2 u + v, where the free parameter is 0 or 1.
  int corner(int free_end) const { return axis() == 0 ? 2 * end() + free_end : 2 * free_end + end(); }

  friend auto operator<=>(const Patch_side&, const Patch_side&) = default;
};

// The side that is the same curve, by the same parameter x or by 1 - x.
struct Glued_side
{
  Patch_side side;
  bool is_reversed = false;

  template <class NT>
  NT parameter(const NT& x) const
  {
    return is_reversed ? NT(1 - x) : x;
  }
};

// The boundary of a solid as patches on unit squares whose sides are poles or are glued in pairs. It is closed, and has
// one orientation on each connected part.
class Solid_boundary
{
public:
  using Patch = Common::Spline_patch<3>;
  using Lines = std::array<std::set<Exact_rational>, 2>; // of constant u or v inside of a patch

private:
  using Point = std::array<Exact_rational, 3>;
  using Range = Common::Parameter_range;

  // Where a patch comes from.
  struct Origin
  {
    std::size_t operand;
    std::array<Range, 2> ranges;
  };

  std::string m_name; // for messages
  std::vector<Patch> m_patches;
  std::vector<Origin> m_origins;
  std::size_t m_operands;
  std::vector<std::array<std::optional<Glued_side>, 4>> m_glued; // none: a pole
  std::vector<std::size_t> m_components;                         // of patches: any one of the same connected part

public:
  // Messages begin with the name.
  // \throws Invalid_input when a side is neither a pole nor the same as exactly one other one, or orientations differ.
  Solid_boundary(const std::vector<Patch>& patches, std::string name)
    : m_name(std::move(name)), m_operands(patches.size())
  {
    if (patches.empty())
      throw Invalid_input(m_name + ": the solid has no surface");
    for (std::size_t i = 0; i < patches.size(); ++i)
      add(patches[i], {i, {patches[i].domain(0), patches[i].domain(1)}});
    glue();
  }

  std::size_t size() const { return m_patches.size(); }
  const Patch& operator[](std::size_t patch) const { return m_patches[patch]; }
  const std::vector<Patch>& patches() const { return m_patches; }

  std::size_t number_of_operands() const { return m_operands; }

  // The index of the patch that was given, of which this one is a part.
  std::size_t operand(std::size_t patch) const { return m_origins[patch].operand; }

  // The other side of an edge; nothing at a pole.
  const std::optional<Glued_side>& glued(const Patch_side& side) const { return m_glued[side.patch][side.side]; }

  // A patch that stands for a connected part.
  std::size_t component(std::size_t patch) const { return m_components[patch]; }

  // The range of a parameter that was given, of a range in the unit square. Of a part of a fan, it is larger.
  std::pair<double, double> original_range(std::size_t patch, int axis, const std::pair<double, double>& range) const
  {
    const auto& [begin, end] = m_origins[patch].ranges[static_cast<std::size_t>(axis)];
    const double low = to_nearest_double(begin), width = to_nearest_double(Exact_rational(end - begin));
    return {low + width * range.first, low + width * range.second};
  }

  // The same, cut along lines, which go on in the patches beyond.
  Solid_boundary cut_along(std::vector<Lines> lines) const
  {
    extend(lines);
    Solid_boundary result(m_operands, m_name);
    for (std::size_t patch = 0; patch < size(); ++patch) {
      std::array<std::vector<Range>, 2> ranges;
      for (const std::size_t axis : {0u, 1u}) {
        Exact_rational begin(0);
        lines[patch][axis].insert(Exact_rational(1));
        for (const Exact_rational& end : lines[patch][axis]) {
          ranges[axis].emplace_back(begin, end);
          begin = end;
        }
      }
      for (const Range& u : ranges[0])
        for (const Range& v : ranges[1])
          result.add(m_patches[patch].part({u, v}), {operand(patch), {original(patch, 0, u), original(patch, 1, v)}});
    }
    result.glue();
    return result;
  }

  // The same with some patches cut at a corner, see fan_at().
  Solid_boundary with_fans(const std::vector<std::optional<int>>& corners) const
  {
    Solid_boundary result(m_operands, m_name);
    for (std::size_t patch = 0; patch < size(); ++patch)
      if (!corners[patch])
        result.add(m_patches[patch], m_origins[patch]);
      else
        for (const Patch& part : fan_at(m_patches[patch], *corners[patch]))
          result.add(part, m_origins[patch]);
    result.glue();
    return result;
  }

private:
  Solid_boundary(std::size_t operands, std::string name) : m_name(std::move(name)), m_operands(operands) {}

  Range original(std::size_t patch, std::size_t axis, const Range& range) const
  {
    const auto& [begin, end] = m_origins[patch].ranges[axis];
    const Exact_rational width(end - begin);
    return {Exact_rational(begin + width * range.first), Exact_rational(begin + width * range.second)};
  }

  static Common::Exact_function on_unit_ranges(const Common::Exact_function& f)
  {
    std::vector<std::vector<Exact_rational>> knots;
    for (int axis = 0; axis < f.dimension(); ++axis) {
      const auto [begin, end] = f.domain(axis);
      const Exact_rational width(end - begin);
      knots.push_back(f.knots(axis));
      for (Exact_rational& knot : knots.back())
        knot = Exact_rational((knot - begin) / width);
    }
    return {f.degrees(), std::move(knots), f.coefficients()};
  }

  static Common::Exact_function reversed(const Common::Exact_function& f)
  {
    std::vector<Exact_rational> knots = f.knots(0), coefficients = f.coefficients();
    for (Exact_rational& knot : knots)
      knot = Exact_rational(1 - knot);
    std::reverse(knots.begin(), knots.end());
    std::reverse(coefficients.begin(), coefficients.end());
    return {f.degrees(), {std::move(knots)}, std::move(coefficients)};
  }

  void add(const Patch& patch, const Origin& origin)
  {
    Common::Vector_of_functions<3> numerators;
    for (std::size_t i = 0; i < 3; ++i)
      numerators[i] = on_unit_ranges(patch.numerators()[i]);
    m_patches.emplace_back(std::move(numerators), on_unit_ranges(patch.weight()), patch.is_rational());
    m_origins.push_back(origin);
  }

  Patch curve(const Patch_side& side) const
  {
    const Exact_rational value(side.end());
    return m_patches[side.patch].part(side.axis(), {value, value});
  }

  static Patch reversed(const Patch& curve)
  {
    Common::Vector_of_functions<3> numerators;
    for (std::size_t i = 0; i < 3; ++i)
      numerators[i] = reversed(curve.numerators()[i]);
    return {std::move(numerators), reversed(curve.weight()), curve.is_rational()};
  }

  static bool are_same(const Patch& a, const Patch& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (a.is_rational() || b.is_rational() ? !(a.numerators()[i] * b.weight() == b.numerators()[i] * a.weight())
                                             : !(a.numerators()[i] == b.numerators()[i]))
        return false;
    return true;
  }

  void glue()
  {
    m_glued.resize(size());
    std::map<std::array<Point, 2>, std::vector<std::pair<Patch_side, Patch>>> edges; // by their ends
    for (std::size_t patch = 0; patch < size(); ++patch)
      for (int k = 0; k < 4; ++k) {
        const Patch_side side{patch, k};
        Patch edge = curve(side);
        if (edge.is_one_point())
          continue;
        std::array<Point, 2> ends{edge(edge.first_corner()), edge(edge.last_corner())};
        if (ends[1] < ends[0])
          std::swap(ends[0], ends[1]);
        edges[ends].emplace_back(side, std::move(edge));
      }
    std::vector<std::size_t> rank(size()), parent(size());
    boost::disjoint_sets<std::size_t*, std::size_t*> parts(rank.data(), parent.data());
    for (std::size_t patch = 0; patch < size(); ++patch)
      parts.make_set(patch);
    for (const auto& [ends, sides] : edges)
      for (const auto& [side, edge] : sides) {
        const Glued_side other = partner(side, edge, sides);
        m_glued[side.patch][side.side] = other;
        parts.union_set(side.patch, other.side.patch);
      }
    for (std::size_t patch = 0; patch < size(); ++patch)
      m_components.push_back(parts.find_set(patch));
  }

  Glued_side partner(const Patch_side& side, const Patch& edge,
                     const std::vector<std::pair<Patch_side, Patch>>& candidates) const
  {
    const Patch backwards = reversed(edge);
    std::optional<Glued_side> result;
    for (const auto& [other, curve] : candidates) {
      const bool is_same = other != side && are_same(edge, curve);
      if (!is_same && (other == side || !are_same(backwards, curve)))
        continue;
      if (result)
        throw Invalid_input(m_name + ": more than two surfaces meet in one edge: " + name(side) + ", " +
                            name(result->side) + ", " + name(other));
      result = Glued_side{other, !is_same};
    }
    if (!result)
      throw Invalid_input(m_operands == 1
                              ? m_name + ": the surface is not closed: " + name(side) + " is neither a seam nor a pole"
                              : m_name + ": the solid is not closed: " + name(side) +
                                  " is neither a pole, nor has another edge the same curve with the same parameter or "
                                  "the reversed one");
    const bool goes_forward = side.is_forward() != result->is_reversed;
    if (goes_forward == result->side.is_forward())
      throw Invalid_input(m_name +
                          ": normals point to different sides of the solid at the common edge of two "
                          "surfaces: " +
                          name(side) + ", " + name(result->side));
    return *result;
  }

  // For messages.
  std::string name(const Patch_side& side) const
  {
    const Range& range = m_origins[side.patch].ranges[static_cast<std::size_t>(side.axis())];
    return (m_operands == 1 ? "its edge" : "the edge of surface " + std::to_string(operand(side.patch))) + " at " +
        (side.axis() == 0 ? "u" : "v") + " = " +
        shortest_text(to_nearest_double(side.end() == 0 ? range.first : range.second));
  }

  void extend(std::vector<Lines>& lines) const
  {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (std::size_t patch = 0; patch < size(); ++patch)
        for (int k = 0; k < 4; ++k) {
          const Patch_side side{patch, k};
          if (const auto& other = glued(side)) {
            auto& beyond = lines[other->side.patch][static_cast<std::size_t>(other->side.free_axis())];
            const std::size_t count = beyond.size();
            for (const Exact_rational& x : std::set(lines[patch][static_cast<std::size_t>(side.free_axis())]))
              beyond.insert(other->parameter(x));
            has_changed = has_changed || beyond.size() > count;
          }
        }
    }
  }
};

inline Solid_boundary solid_boundary_of(const std::vector<Common::Exact_map<3>>& surfaces, const std::string& name)
{
  std::vector<Solid_boundary::Patch> patches;
  for (const Common::Exact_map<3>& surface : surfaces)
    patches.emplace_back(surface);
  return Solid_boundary(patches, name);
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_BOUNDARY_H
