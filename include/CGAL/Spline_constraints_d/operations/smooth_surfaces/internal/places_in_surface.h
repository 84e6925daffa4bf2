// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PLACES_IN_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PLACES_IN_SURFACE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

// Multiples of the barycentric coordinates, by volumes; signs are as of these.
inline std::array<Interval, 4> enclosed_barycentric(const std::array<Interval_point, 4>& x, const Interval_point& p)
{
  const auto difference = [](const Interval_point& a, const Interval_point& b) {
    return Interval_point{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto volume = [&](const Interval_point& a, const Interval_point& b, const Interval_point& c,
                          const Interval_point& d) {
    const Interval_point u = difference(b, a), v = difference(c, a), w = difference(d, a);
    return product_of(orthogonal_to<Interval>(std::array<const Interval_point*, 2>{&u, &v}), w);
  };
  std::array<Interval, 4> result{volume(p, x[1], x[2], x[3]), volume(x[0], p, x[2], x[3]), volume(x[0], x[1], p, x[3]),
                                 volume(x[0], x[1], x[2], p)};
  const Interval whole = volume(x[0], x[1], x[2], x[3]);
  for (Interval& y : result)
    y *= whole;
  return result;
}

inline std::array<Interval_point, 4> enclosed_vertices(const Surface_data& data, std::size_t patch)
{
  const auto& nodes = data.neighborhood.patches[patch].nodes;
  return {data.places[nodes[0]], data.places[nodes[1]], data.places[nodes[2]], data.places[nodes[3]]};
}

// A box of points; infinite where a ray goes on.
using Range_box = std::array<std::pair<double, double>, 3>;

inline Range_box box_of_line(const Interval_point& first, const Interval_point& second, bool is_ray)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range_box result;
  for (int k = 0; k < 3; ++k) {
    const auto &a = first[k], &b = second[k];
    result[k] = {(std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup())};
    if (is_ray && !(b.inf() >= a.sup()))
      result[k].first = -infinity;
    if (is_ray && !(b.sup() <= a.inf()))
      result[k].second = infinity;
  }
  return result;
}

inline bool is_beside_box(const std::array<Interval_point, 4>& vertices, const Range_box& box)
{
  for (int k = 0; k < 3; ++k) {
    const auto is_below = [&](const Interval_point& p) { return p[k].sup() < box[k].first; };
    const auto is_above = [&](const Interval_point& p) { return p[k].inf() > box[k].second; };
    if (std::all_of(vertices.begin(), vertices.end(), is_below) ||
        std::all_of(vertices.begin(), vertices.end(), is_above))
      return true;
  }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::size_t> patch_at(const Surface_data& data,
                                                                   const Exact_kernel::Point_3& point)
{
  const Upward_rounding_guard guard;
  const Interval_point place = enclosure_of(point);
  const Range_box box = box_of_line(place, place, false);
  for (std::size_t i = 0; i < data.forms.size(); ++i) {
    const auto vertices = enclosed_vertices(data, i);
    if (is_beside_box(vertices, box))
      continue;
    const auto enclosed = enclosed_barycentric(vertices, place);
    if (std::any_of(enclosed.begin(), enclosed.end(), [](const Interval& x) { return x.sup() < 0; }))
      continue;
    const Form::Barycentric tau = barycentric_of(data.vertices(i), point);
    if (std::all_of(tau.begin(), tau.end(), [](const Exact_rational& x) { return x >= 0; }))
      return i;
  }
  return std::nullopt;
}

// A line with a parameter, and its pieces in the patches of a surface and between them.
class Line_through_surface
{
  using Point = Exact_kernel::Point_3;
  using FT = Exact_rational;
  using Cubic = Bernstein_tensor<FT>;

  // In a patch; it may have the length 0.
  struct Piece
  {
    FT lower, upper;
    std::size_t patch;
    std::array<Form::Barycentric, 2> ends;
    Cubic function = {}; // for hits only

    bool begins_at_vertex() const { return ends[0][1] == 1 || ends[0][2] == 1; } // of the mesh
  };

  const Surface_data& m_data;
  Point m_source, m_target;
  bool m_is_ray;
  std::vector<Piece> m_pieces; // in order, one where faces of patches have the same

public:
  Line_through_surface(const Surface_data& data, const Point& source, const Point& target, bool is_ray)
    : m_data(data), m_source(source), m_target(target), m_is_ray(is_ray)
  {
    const Upward_rounding_guard guard;
    const Interval_point first = enclosure_of(source), second = enclosure_of(target);
    const Range_box box = box_of_line(first, second, is_ray);
    for (std::size_t i = 0; i < data.forms.size(); ++i)
      if (const auto vertices = enclosed_vertices(data, i);
          !is_beside_box(vertices, box) && !is_beside(vertices, first, second))
        add_piece(i);
    std::sort(m_pieces.begin(), m_pieces.end(), [](const Piece& a, const Piece& b) {
      return a.lower < b.lower || (a.lower == b.lower && a.upper < b.upper);
    });
    m_pieces.erase(std::unique(m_pieces.begin(), m_pieces.end(),
                               [](const Piece& a, const Piece& b) { return a.lower == b.lower && a.upper == b.upper; }),
                   m_pieces.end());
  }

  // Of which side the patch is that the line enters first; nothing where there is none, or a vertex of the mesh comes
  // first, which is on both sides.
  std::optional<int> first_side() const
  {
    if (m_pieces.empty() || m_pieces.front().begins_at_vertex())
      return std::nullopt;
    return m_data.neighborhood.patches[m_pieces.front().patch].side;
  }

  std::vector<Smooth_surface_hit> hits()
  {
    for (Piece& piece : m_pieces)
      piece.function = Cubic({3}, m_data.forms[piece.patch].restricted(piece.ends).coefficients());
    std::vector<Smooth_surface_hit> result;
    std::map<FT, std::size_t> zeros; // at ends of pieces, with a patch
    for (const Piece& piece : m_pieces) {
      const auto& values = piece.function.coefficients();
      if (CGAL::is_zero(values.front()))
        zeros.try_emplace(piece.lower, piece.patch);
      if (CGAL::is_zero(values.back()))
        zeros.try_emplace(piece.upper, piece.patch);
      if (piece.lower < piece.upper)
        add_inner_hits(piece, result);
    }
    for (const auto& [t, patch] : zeros)
      result.push_back({t, t, sign_before(t), sign_after(t), patch});
    std::sort(result.begin(), result.end(), [](const Smooth_surface_hit& a, const Smooth_surface_hit& b) {
      return a.lower < b.lower || (a.lower == b.lower && a.upper < b.upper);
    });
    return result;
  }

private:
  Point at(const FT& t) const { return m_source + t * (m_target - m_source); }

  // Whether all of the line is on the other side of a face of a patch, seen from this.
  bool is_beside(const std::array<Interval_point, 4>& x, const Interval_point& first,
                 const Interval_point& second) const
  {
    const auto a = enclosed_barycentric(x, first), b = enclosed_barycentric(x, second);
    for (int i = 0; i < 4; ++i)
      if (a[i].sup() < 0 && (m_is_ray ? (b[i] - a[i]).sup() < 0 : b[i].sup() < 0))
        return true;
    return false;
  }

  void add_piece(std::size_t patch)
  {
    const Simplex_vertices<3> vertices = m_data.vertices(patch);
    const Form::Barycentric a = barycentric_of(vertices, m_source), b = barycentric_of(vertices, m_target);
    FT lower(0);
    std::optional<FT> upper;
    if (!m_is_ray)
      upper = FT(1);
    for (int i = 0; i < 4; ++i) {
      const FT slope = b[i] - a[i];
      if (CGAL::is_zero(slope)) {
        if (a[i] < 0)
          return;
        continue;
      }
      const FT zero = -a[i] / slope;
      if (slope > 0)
        lower = (std::max)(lower, zero);
      else if (!upper || zero < *upper)
        upper = zero;
    }
    if (*upper < lower) // it is bounded, as the patch is
      return;
    Piece& piece = m_pieces.emplace_back(Piece{lower, *upper, patch, {}});
    for (int i = 0; i < 4; ++i) {
      piece.ends[0][i] = a[i] + lower * (b[i] - a[i]);
      piece.ends[1][i] = a[i] + *upper * (b[i] - a[i]);
    }
  }

  static CGAL::Sign first_sign(const std::vector<FT>& coefficients, bool is_from_behind)
  {
    CGAL::Sign result = CGAL::ZERO;
    for (std::size_t i = 0; i < coefficients.size() && result == CGAL::ZERO; ++i)
      result = CGAL::sign(coefficients[is_from_behind ? coefficients.size() - 1 - i : i]);
    return result;
  }

  void add_inner_hits(const Piece& piece, std::vector<Smooth_surface_hit>& result) const
  {
    const FT length = piece.upper - piece.lower;
    const auto& coefficients = piece.function.coefficients();
    CGAL::Sign before = first_sign(coefficients, false);
    if (before == CGAL::ZERO) {
      result.push_back({piece.lower, piece.upper, CGAL::ZERO, CGAL::ZERO, piece.patch, true});
      return;
    }
    const auto roots = Common::inner_roots(piece.function, FT(power_of_two(-60)));
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const CGAL::Sign after = i + 1 < roots.size()
          ? CGAL::sign(piece.function(std::vector<FT>{FT((roots[i].upper() + roots[i + 1].lower()) / 2)}))
          : first_sign(coefficients, true);
      result.push_back({FT(piece.lower + length * roots[i].lower()), FT(piece.lower + length * roots[i].upper()),
                        before, after, piece.patch});
      before = after;
    }
  }

  // The sign on a part of the line that is in no patch.
  CGAL::Sign sign_outside(const FT& t) const { return is_inside(m_data, at(t)) ? CGAL::NEGATIVE : CGAL::POSITIVE; }

  CGAL::Sign sign_before(const FT& t) const
  {
    FT last(0);
    for (const Piece& piece : m_pieces) {
      if (piece.upper == t && piece.lower < t)
        return first_sign(piece.function.coefficients(), true);
      if (piece.upper < t)
        last = (std::max)(last, piece.upper);
    }
    return t > 0 ? sign_outside((last + t) / 2) : CGAL::ZERO;
  }

  CGAL::Sign sign_after(const FT& t) const
  {
    std::optional<FT> next;
    if (!m_is_ray)
      next = FT(1);
    for (const Piece& piece : m_pieces) {
      if (piece.lower == t && t < piece.upper)
        return first_sign(piece.function.coefficients(), false);
      if (t < piece.lower && (!next || piece.lower < *next))
        next = piece.lower;
    }
    if (!next)
      next = t + 1;
    return t < *next ? sign_outside((t + *next) / 2) : CGAL::ZERO;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_inside(const Surface_data& data, const Exact_kernel::Point_3& point)
{
  // Towards the middles of patches: of all these directions few go through vertices of the mesh.
  for (const Patch_place& patch : data.neighborhood.patches) {
    const auto& points = data.neighborhood.points;
    const Exact_kernel::Point_3 middle =
        CGAL::centroid(points[patch.nodes[0]], points[patch.nodes[1]], points[patch.nodes[2]], points[patch.nodes[3]]);
    if (const auto side = Line_through_surface(data, point, middle, false).first_side())
      return *side == INNER;
  }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Smooth_surface_hit> hits_on_line(const Surface_data& data,
                                                                            const Exact_kernel::Point_3& source,
                                                                            const Exact_kernel::Point_3& target,
                                                                            bool is_ray)
{
  if (source == target)
    throw Invalid_input("intersections: the two points of the segment or ray are equal");
  return Line_through_surface(data, source, target, is_ray).hits();
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_PLACES_IN_SURFACE_H
