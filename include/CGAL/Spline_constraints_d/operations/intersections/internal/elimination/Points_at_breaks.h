// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_POINTS_AT_BREAKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_POINTS_AT_BREAKS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Curve_parts.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

using Places = std::array<Place_on_curve, 2>;

/*
The common points of two curves that are a break of one of them, or of both, their ends included: what is known of each
from the pieces on both sides.
*/
template <int d>
class Points_at_breaks
{
  // A direction in which one of the curves leaves the point.
  struct Ray
  {
    std::size_t curve;
    Exact_pair direction;
    Arc_germ germ;
  };

  Curve_pieces<d>& m_pieces;

public:
  explicit Points_at_breaks(Curve_pieces<d>& pieces) : m_pieces(pieces) {}

  // All of them at breaks in a box of parameters, once: of a closed curve, with the lower end. The parameter of the
  // other curve may be outside of it, but not far.
  std::vector<Places> places(const Parameter_box& box)
  {
    std::vector<Places> result;
    for (const std::size_t k : {0, 1}) {
      const std::size_t last = m_pieces.size(k);
      for (std::size_t index = 0; index <= last; ++index) {
        const Exact_rational& value = m_pieces.breaks(k)[index];
        if (value < box[k].first || box[k].second < value || (index == last && m_pieces.pair().is_repeated_at_end(k)))
          continue;
        const Place_on_curve at_break = m_pieces.place_at_break(k, index);
        for (Place_on_curve& other : m_pieces.places_of_break(1 - k, box[1 - k], index, k == 0))
          result.push_back(k == 0 ? Places{at_break, std::move(other)} : Places{std::move(other), at_break});
      }
    }
    return result;
  }

  // Whether one of the curves ends there.
  bool is_end(const Places& places) const
  {
    return std::any_of(places.begin(), places.end(),
                       [&, k = std::size_t(0)](const Place_on_curve& place) mutable { return is_end(k++, place); });
  }

  // How often the common point counts for each piece of one curve with each one of the other: the same number for all
  // of them, 0 if these are different or one is not known. Nothing if one may be one, and may be more.
  std::optional<int> multiplicity(Places& places)
  {
    std::optional<int> result;
    const std::vector<Half_branch> first = branches(0, places[0]), second = branches(1, places[1]);
    for (const Half_branch& a : first)
      for (const Half_branch& b : second) {
        const std::optional<int> own = multiplicity(places, a, b);
        if (!own)
          return std::nullopt;
        result = !result || *result == *own ? *own : 0;
      }
    return result;
  }

  // How the curves pass through the point, if both go on.
  std::optional<Passage> passage(const Places& places) requires(d == 2)
  {
    if (is_end(places))
      return std::nullopt;
    const std::optional<bool> crosses = places[0].is_break() && places[1].is_break() ? alternate(places)
        : places[0].is_break()                                                       ? change_sides(0, places)
                                                                                     : change_sides(1, places);
    return !crosses ? Passage::TOUCHES_OR_CROSSES : *crosses ? Passage::CROSSES : Passage::TOUCHES;
  }

private:
  bool is_end(std::size_t curve, const Place_on_curve& place) const
  {
    return place.is_break() && m_pieces.half_branches(curve, place).size() < 2;
  }

  // A smooth piece is one.
  std::vector<Half_branch> branches(std::size_t curve, const Place_on_curve& place) const
  {
    return place.is_break() ? m_pieces.half_branches(curve, place) : std::vector<Half_branch>{{place.piece, false}};
  }

  static Exact_root root_at(const Place_on_curve& place, const Half_branch& branch)
  {
    return place.is_break() ? Exact_root(Exact_rational(branch.is_end ? 1 : 0)) : place.root;
  }

  // By the parameter of one of the pieces that is the only one of the point.
  std::optional<int> multiplicity(const Places& places, const Half_branch& a, const Half_branch& b)
  {
    const std::array<Half_branch, 2> branches{a, b};
    for (const std::size_t k : {0, 1}) {
      Piece_elimination<d>& elimination = m_pieces.elimination(k, branches[k].piece, branches[1 - k].piece);
      Exact_root root = root_at(places[k], branches[k]);
      if (!elimination.is_zero() && elimination.partner(root))
        return elimination.multiplicity(root);
    }
    return std::nullopt;
  }

  // Of a curve with a break in a point of a smooth piece of the other one. Where the tangents are different, they tell;
  // else the sign of the equation of this piece on both sides of the break, if it passes through the point once.
  std::optional<bool> change_sides(std::size_t k, const Places& places)
  {
    std::array<CGAL::Sign, 2> sides{}, slopes{};
    bool are_sides_known = true;
    for (const Half_branch& branch : m_pieces.half_branches(k, places[k])) {
      Piece_elimination<d>& elimination = m_pieces.elimination(k, branch.piece, places[1 - k].piece);
      Exact_root end = root_at(places[k], branch), root = places[1 - k].root;
      slopes[branch.is_end] = root.sign_of_value(slope_along(
          m_pieces.piece(1 - k, places[1 - k].piece), m_pieces.piece(k, branch.piece).end_tangent(branch.is_end)));
      are_sides_known = are_sides_known && !elimination.is_zero() && elimination.partner(end);
      if (are_sides_known)
        sides[branch.is_end] = sign_next_to(elimination.polynomial(), branch);
    }
    if (slopes[0] != CGAL::ZERO && slopes[1] != CGAL::ZERO)
      return slopes[0] == slopes[1];
    return are_sides_known ? std::optional(sides[0] != sides[1]) : std::nullopt;
  }

  // The sign of the turn from the derivative of a piece to a direction, as a polynomial of its parameter.
  static Integer_polynomial slope_along(const Integer_piece<2>& piece, const std::array<Big_integer, 2>& direction)
  {
    const std::array<Integer_coefficients, 2> tangent = piece.tangent();
    Integer_coefficients result;
    add_multiple(result, tangent[0], direction[1]);
    add_multiple(result, tangent[1], Big_integer(-direction[0]));
    return Integer_polynomial(std::move(result));
  }

  // Of a polynomial on a piece, next to an end. \pre It is not zero everywhere.
  static CGAL::Sign sign_next_to(Integer_polynomial f, const Half_branch& branch)
  {
    const Exact_rational end(branch.is_end ? 1 : 0);
    CGAL::Sign sign = f.sign_at(end);
    for (int order = 1; sign == CGAL::ZERO; ++order) {
      f = f.derivative();
      sign = branch.is_end && order % 2 != 0 ? -f.sign_at(end) : f.sign_at(end);
    }
    return sign;
  }

  // Whether the rays of the curves alternate around a corner of both.
  std::optional<bool> alternate(const Places& places)
  {
    std::vector<Ray> rays;
    std::size_t order = 1; // more than pieces of different algebraic curves can agree
    for (const std::size_t k : {0, 1}) {
      std::size_t degree = 1;
      for (const Half_branch& branch : m_pieces.half_branches(k, places[k]))
        degree = (std::max)(degree, m_pieces.piece(k, branch.piece).degree());
      order *= degree;
    }
    for (const std::size_t k : {0, 1})
      for (const Half_branch& branch : m_pieces.half_branches(k, places[k])) {
        if (m_pieces.piece(k, branch.piece).is_point())
          return std::nullopt;
        const Exact_arc_2 arc = arc_of(k, branch.piece);
        rays.push_back({k, outgoing_direction(arc, branch.is_end), Arc_germ(arc, branch.is_end, order + 1)});
      }
    bool is_known = std::none_of(rays.begin(), rays.end(),
                                 [](const Ray& ray) { return ray.direction[0] == 0 && ray.direction[1] == 0; });
    // counterclockwise; a ray to the right of another one in the same direction comes before it
    std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) {
      const int half = half_of_directions(a.direction), other_half = half_of_directions(b.direction);
      if (half != other_half)
        return half < other_half;
      const int turn = sign_of(exact_cross(a.direction, b.direction));
      return turn != 0 ? turn > 0 : a.germ < b.germ;
    });
    for (std::size_t i = 0; i + 1 < rays.size(); ++i)
      is_known = is_known &&
          (!are_same_directions(rays[i].direction, rays[i + 1].direction) || rays[i].germ < rays[i + 1].germ ||
           rays[i].curve == rays[i + 1].curve);
    if (!is_known)
      return std::nullopt;
    return rays[0].curve != rays[1].curve && rays[1].curve != rays[2].curve && rays[2].curve != rays[3].curve;
  }

  Exact_arc_2 arc_of(std::size_t curve, std::size_t piece)
  {
    const auto coordinate = [&](std::size_t i) {
      std::vector<Exact_rational> powers;
      for (const Big_integer& c : m_pieces.piece(curve, piece)[i])
        powers.push_back(scaled_rational(c, 0));
      const int degree = static_cast<int>(powers.size()) - 1;
      return Bernstein_tensor<Exact_rational>::from_power({degree}, std::move(powers));
    };
    return Exact_arc_2(
        Homogeneous_piece{{Exact_rational(0), Exact_rational(1)}, {coordinate(0), coordinate(1), coordinate(2)}});
  }
};

// A common point at breaks that counts so often, by Points_at_breaks.
template <int d>
Common_point point_at_breaks(Points_at_breaks<d>& at_breaks, const Curve_pieces<d>& pieces, const Places& places,
                             int multiplicity)
{
  Common_point result{Intersection_kind::TANGENT, {}, {}, std::nullopt, false, multiplicity};
  for (const std::size_t k : {0, 1}) {
    result.parameters.push_back(pieces.range(k, places[k]));
    result.is_at_end.push_back(places[k].is_break() &&
                               (*places[k].at_break == 0 || *places[k].at_break == pieces.size(k)));
  }
  const bool is_end = at_breaks.is_end(places);
  if constexpr (d == 2)
    result.passage = at_breaks.passage(places);
  if (result.passage && multiplicity != 0 &&
      *result.passage != (multiplicity % 2 != 0 ? Passage::CROSSES : Passage::TOUCHES))
    result.multiplicity = 0; // both sides count, but not together
  if (result.multiplicity == 1 || (is_end && multiplicity == 1))
    result.kind =
        result.is_at_end[0] || result.is_at_end[1] ? Intersection_kind::END_POINT : Intersection_kind::TRANSVERSAL;
  return result;
}

// Whether a range holds a break of a curve, but for its ends.
template <int d>
bool holds_inner_break(const Spline_patch<d>& patch, int axis, const Parameter_range& range)
{
  const std::vector<Exact_rational> breaks = patch.breaks(axis);
  return std::any_of(breaks.begin() + 1, breaks.end() - 1,
                     [&](const Exact_rational& t) { return range.first <= t && t <= range.second; });
}

/*
How two planar curves pass through common points that are not told to be crossings: inside of pieces by the number of
times that they count, at breaks and seams by the pieces on both sides. At an end of one of them they do not.
*/
class Passages
{
  const Patch_pair<2>& m_pair;
  Curve_pieces<2> m_pieces;
  Points_at_breaks<2> m_at_breaks{m_pieces};

public:
  // `check` is called often, and may throw.
  Passages(const Patch_pair<2>& pair, std::function<void()> check) : m_pair(pair), m_pieces(pair, std::move(check)) {}

  // Whether both curves go on at a point that is not told to be a crossing.
  static bool is_passed(const Patch_pair<2>& pair, const Common_point& point)
  {
    const auto ends = [&](std::size_t k) { return point.is_at_end[k] && !pair[k].is_closed(0); };
    return (point.kind == Intersection_kind::TANGENT || point.kind == Intersection_kind::END_POINT) && !ends(0) &&
        !ends(1);
  }

  // \pre Both curves go on there.
  Passage operator()(const Common_point& point)
  {
    const bool is_at_end = point.is_at_end[0] || point.is_at_end[1];
    const Parameter_box& box = point.parameters;
    if (!is_at_end && !holds_inner_break(m_pair[0], 0, box[0]) && !holds_inner_break(m_pair[1], 0, box[1])) {
      const int count = multiplicity_of(point);
      return count == 0 ? Passage::TOUCHES_OR_CROSSES : count % 2 != 0 ? Passage::CROSSES : Passage::TOUCHES;
    }
    std::vector<Places> places = m_at_breaks.places(box);
    std::erase_if(places, [&](const Places& x) {
      return !have_common_part(box, {m_pieces.range(0, x[0]), m_pieces.range(1, x[1])});
    });
    return places.size() == 1 ? m_at_breaks.passage(places[0]).value_or(Passage::TOUCHES_OR_CROSSES)
                              : Passage::TOUCHES_OR_CROSSES;
  }
};

/*
Corners of both curves that the solver found to be common points, but not how often they count, and some of them several
times: where a box holds no other common point, its corner takes its place, once; on a seam, with the lower parameter.
*/
class Corners
{
  const Patch_pair<2>& m_pair;
  Curve_pieces<2> m_pieces;
  Points_at_breaks<2> m_at_breaks{m_pieces};
  Curve_parts<2> m_parts;

public:
  // `check` is called often, and may throw.
  Corners(const Patch_pair<2>& pair, const std::vector<Common_point>& points, std::function<void()> check)
    : m_pair(pair), m_pieces(pair, std::move(check)), m_parts(pair, points)
  {}

  static bool may_be_one(const Common_point& point)
  {
    return point.kind == Intersection_kind::TANGENT && !point.multiplicity && multiplicity_of(point) < 2;
  }

  std::optional<Common_point> operator()(const Common_point& point)
  {
    const std::vector<Exact_parameters> corners = m_parts.common_breaks(point.parameters);
    if (corners.size() != 1 || is_of_next_part(0, corners[0][0]) || is_of_next_part(1, corners[0][1]) ||
        !m_parts.holds_only(point.parameters, corners))
      return std::nullopt;
    Places places{place(0, corners[0][0]), place(1, corners[0][1])};
    Common_point result = point_at_breaks(m_at_breaks, m_pieces, places, m_at_breaks.multiplicity(places).value_or(0));
    result.solution = point.solution;
    return result;
  }

private:
  // Whether a parameter is the end of an arc that belongs to another one.
  bool is_of_next_part(std::size_t curve, const Exact_rational& value) const
  {
    return value == m_pieces.breaks(curve).back() && m_pair.is_repeated_at_end(curve) && !m_pair[curve].is_closed(0);
  }

  Place_on_curve place(std::size_t curve, const Exact_rational& value) const
  {
    const std::vector<Exact_rational>& breaks = m_pieces.breaks(curve);
    const std::size_t index =
        static_cast<std::size_t>(std::lower_bound(breaks.begin(), breaks.end(), value) - breaks.begin());
    return m_pieces.place_at_break(curve,
                                   index == m_pieces.size(curve) && m_pair.is_repeated_at_end(curve) ? 0 : index);
  }
};

// When the run is stopped, those that are left stay as they are.
inline void settle_corners(const Patch_pair<2>& pair, std::vector<Common_point>& points, Budgeted_solver& solve)
{
  if (std::none_of(points.begin(), points.end(), Corners::may_be_one))
    return;
  try {
    Corners corner_at(pair, points, [&] { solve.budget().check(); });
    std::vector<Common_point> others, corners;
    for (Common_point& point : points) {
      std::optional<Common_point> corner = Corners::may_be_one(point) ? corner_at(point) : std::nullopt;
      const auto is_same = [&](const Common_point& known) { return known.parameters == corner->parameters; };
      if (!corner)
        others.push_back(point);
      else if (std::none_of(corners.begin(), corners.end(), is_same))
        corners.push_back(std::move(*corner));
    }
    std::erase_if(corners, [&](const Common_point& corner) {
      return std::any_of(others.begin(), others.end(), [&](const Common_point& other) {
        return other.kind == Intersection_kind::END_POINT && other.parameters == corner.parameters;
      });
    });
    points = std::move(others);
    std::move(corners.begin(), corners.end(), std::back_inserter(points));
  } catch (const Run_stopped&) {
  }
}

// When the run is stopped, those that are left are not decided.
inline void decide_passages(const Patch_pair<2>& pair, std::vector<Common_point>& points, Budgeted_solver& solve)
{
  std::optional<Passages> passage_at;
  for (Common_point& point : points)
    if (!point.passage && Passages::is_passed(pair, point)) {
      if (!passage_at)
        passage_at.emplace(pair, [&] { solve.budget().check(); });
      try {
        point.passage = (*passage_at)(point);
      } catch (const Run_stopped&) {
        point.passage = Passage::TOUCHES_OR_CROSSES;
      }
    }
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_POINTS_AT_BREAKS_H
