// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_JOINT_PLACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_JOINT_PLACES_H

#include <CGAL/Spline_constraints_d/geometry/curves/internal/Joint_control_points.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/near_boxes.h>
#include <CGAL/Spline_constraints_d/operations/joints/internal/foot_on_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Joints {

/*
Places are points of joints of curves, and pieces what is between two joints. Places near others are joined with them,
and those near a piece are moved onto it: after both places in which that ends, so that nothing they are on is moved
later.
*/
template <RationalSplineKernel Kernel>
class Joint_places
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using FT = typename Kernel::FT;
  using Curve = Bspline_curve_2<Kernel>;
  using Box = Indexed_box<2>;

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  enum class State
  {
    WAITING,
    IN_PROGRESS,
    DONE
  };

  struct Place
  {
    Point point;
    std::vector<Joint_side> sides;
    std::vector<std::size_t> near_pieces{};
    std::size_t joined_with = none;
    State state = State::WAITING;
  };

  // Between two joints.
  struct Piece
  {
    std::size_t curve, first, last;
    std::array<std::size_t, 2> places;
  };

  Run_of_steps& m_run;
  double m_most_distance;
  FT m_most_squared_distance, m_most_squared_sine;
  std::vector<Place> m_places;
  std::vector<Piece> m_pieces;
  std::vector<std::map<std::size_t, std::size_t>> m_place_of; // of each curve and joint
  // of each control point: the place where a tangent depends on it, that it has in common with others
  std::vector<std::vector<std::size_t>> m_keepers;

public:
  Joint_control_points<Kernel> points;
  std::size_t joints = 0, left = 0;

  // \throws Run_stopped
  Joint_places(std::vector<Curve> curves, double most_distance, double most_angle, Run_of_steps& run)
    : m_run(run), m_most_distance(most_distance), m_most_squared_distance(squared(most_distance)),
      m_most_squared_sine(squared(std::sin(most_angle))), points(std::move(curves))
  {
    make_places();
    make_pieces();
    keep_common_tangents();
    join_near_places();
    find_near_pieces();
    for (std::size_t place = 0; place < m_places.size(); ++place) {
      settle(place);
      m_run.add_progress(1 / static_cast<double>(m_places.size()));
    }
  }

private:
  static FT squared(double x)
  {
    const FT number = converted_number<FT>(x);
    return number * number;
  }

  void make_places()
  {
    std::map<std::pair<FT, FT>, std::size_t> place_at;
    m_place_of.resize(points.number_of_curves());
    for (const Joint_side& side : points.sides()) {
      m_run.check();
      const Point& p = points.joint(side);
      const auto [place, is_new] = place_at.emplace(std::pair(p.x(), p.y()), m_places.size());
      if (is_new)
        m_places.push_back({p, {}});
      m_places[place->second].sides.push_back(side);
      m_place_of[side.curve][side.joint] = place->second;
    }
  }

  void make_pieces()
  {
    for (std::size_t i = 0; i < points.number_of_curves(); ++i) {
      m_run.check();
      m_keepers.emplace_back(points.points(i).size(), none);
      const std::vector<std::size_t>& along = points.joints(i);
      for (std::size_t k = 0; k + 1 < along.size(); ++k)
        m_pieces.push_back({i, along[k], along[k + 1], {m_place_of[i][along[k]], m_place_of[i][along[k + 1]]}});
    }
  }

  // Where pieces have the same tangent in a place, it stays that.
  void keep_common_tangents()
  {
    for (std::size_t i = 0; i < m_places.size(); ++i) {
      m_run.check();
      for (const Joint_side& a : m_places[i].sides)
        for (const Joint_side& b : m_places[i].sides)
          if ((a.curve != b.curve || a.joint != b.joint || a.is_forward != b.is_forward) &&
              CGAL::determinant(points.direction(a), points.direction(b)) == 0)
            m_keepers[a.curve][points.next(a)] = i;
    }
  }

  std::size_t place_after_joining(std::size_t place) const
  {
    return place == none || m_places[place].joined_with == none ? place : m_places[place].joined_with;
  }

  Box box_of(const CGAL::Bbox_2& b, double margin, std::size_t index) const
  {
    return widened_box<2>({std::pair(b.xmin(), b.xmax()), std::pair(b.ymin(), b.ymax())}, margin, index);
  }

  // Joins places with the nearest one of a lower index, but for both ends of a piece.
  void join_near_places()
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < m_places.size(); ++i)
      boxes.push_back(box_of(m_places[i].point.bbox(), m_most_distance / 2, i));
    const std::vector<std::pair<std::size_t, std::size_t>> pairs = meeting_pairs<2>(std::move(boxes));
    for (auto pair = pairs.begin(); pair != pairs.end();) {
      m_run.check();
      const std::size_t place = pair->first;
      std::optional<std::pair<FT, std::size_t>> nearest;
      for (; pair != pairs.end() && pair->first == place; ++pair)
        if (const std::size_t other = pair->second;
            m_places[other].joined_with == none && !are_ends_of_piece(place, other))
          if (const FT distance = CGAL::squared_distance(m_places[place].point, m_places[other].point);
              !(distance > m_most_squared_distance) && (!nearest || distance < nearest->first))
            nearest = {distance, other};
      if (nearest)
        join(place, nearest->second);
    }
  }

  bool are_ends_of_piece(std::size_t place, std::size_t other) const
  {
    const auto is_other_end = [&](const Joint_side& side) {
      return place_after_joining(place_at(points.opposite(side))) == other;
    };
    return std::any_of(m_places[place].sides.begin(), m_places[place].sides.end(), is_other_end);
  }

  // none where a curve has no joint in its end.
  std::size_t place_at(const Joint_side& side) const
  {
    const auto found = m_place_of[side.curve].find(side.joint);
    return found == m_place_of[side.curve].end() ? none : found->second;
  }

  void join(std::size_t place, std::size_t other)
  {
    ++joints;
    move(place, m_places[other].point);
    m_places[place].joined_with = other;
    m_places[place].state = State::DONE;
    m_places[other].sides.insert(m_places[other].sides.end(), m_places[place].sides.begin(),
                                 m_places[place].sides.end());
  }

  // Moves joints, and the control points next to them that nothing else depends on, so that curves keep their
  // directions there, and stay flat where they are. Straight pieces stay straight.
  void move(std::size_t place, const Point& to)
  {
    const Vector way = to - m_places[place].point;
    std::map<std::pair<std::size_t, std::size_t>, Vector> ways;
    for (const Joint_side& side : m_places[place].sides) {
      const std::size_t last = points.opposite(side).joint;
      ways[{side.curve, side.joint}] = way;
      if (points.is_straight(side))
        for (std::size_t i = side.joint; i != last; i = following(side, i))
          ways[{side.curve, i}] = way * FT(1 - share_of_way(side, i));
      else
        for (const std::size_t i : flat_points(side))
          if (i != last && is_kept_by_none_but(place, side.curve, i))
            ways[{side.curve, i}] = way;
    }
    for (const auto& [index, by] : ways)
      points.point(index.first, index.second) = points.point(index.first, index.second) + by;
    m_places[place].point = to;
  }

  static std::size_t following(const Joint_side& side, std::size_t index)
  {
    return side.is_forward ? index + 1 : index - 1;
  }

  // The control point that the direction of a side depends on, and those behind it that are in this direction but for
  // rounding.
  std::vector<std::size_t> flat_points(const Joint_side& side) const
  {
    const std::size_t last = points.opposite(side).joint;
    const std::vector<Point>& along = points.points(side.curve);
    const Point& joint = points.joint(side);
    const Vector direction = points.direction(side);
    std::vector<std::size_t> result{points.next(side)};
    while (result.back() != last) {
      const std::size_t i = following(side, result.back());
      const FT height = CGAL::determinant(direction, Vector(along[i] - joint)),
               most = converted_number<FT>(rounding_of_coordinates *
                                           (std::max)(magnitude_of(joint), magnitude_of(along[i])));
      if (height * height > most * most * direction.squared_length())
        break;
      result.push_back(i);
    }
    return result;
  }

  // Where a control point of a straight piece is on the way to its other end.
  FT share_of_way(const Joint_side& side, std::size_t index) const
  {
    const Vector chord = points.joint(points.opposite(side)) - points.joint(side),
                 part = points.points(side.curve)[index] - points.joint(side);
    const FT length = chord.squared_length();
    return length == 0 ? FT(0) : FT(part * chord / length);
  }

  bool is_kept_by_none_but(std::size_t place, std::size_t curve, std::size_t index) const
  {
    return m_keepers[curve][index] == none ||
        place_after_joining(m_keepers[curve][index]) == place_after_joining(place);
  }

  // Of each place, the pieces whose distance from it is not greater than the given one. Copies of a piece count once.
  void find_near_pieces()
  {
    std::vector<Box> places, pieces;
    for (std::size_t i = 0; i < m_places.size(); ++i)
      if (m_places[i].joined_with == none)
        places.push_back(box_of(m_places[i].point.bbox(), m_most_distance, i));
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
      m_run.check();
      const Curve curve = curve_of(i);
      const std::vector<Point> along = curve.control_points();
      CGAL::Bbox_2 box;
      for (const Point& p : along)
        box += p.bbox();
      pieces.push_back(box_of(box, 0, i));
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    CGAL::box_intersection_d(places.begin(), places.end(), pieces.begin(), pieces.end(),
                             [&](const Box& a, const Box& b) { pairs.emplace_back(a.info(), b.info()); });
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [place, piece] : pairs) {
      m_run.check();
      if (is_near(place, piece) &&
          std::none_of(m_places[place].near_pieces.begin(), m_places[place].near_pieces.end(),
                       [&, &piece = piece](std::size_t other) { return are_copies(piece, other); }))
        m_places[place].near_pieces.push_back(piece);
    }
  }

  Curve curve_of(std::size_t piece) const
  {
    return points.between(m_pieces[piece].curve, m_pieces[piece].first, m_pieces[piece].last);
  }

  bool is_near(std::size_t place, std::size_t piece) const
  {
    const Point& p = m_places[place].point;
    for (const std::size_t end : m_pieces[piece].places)
      // joined, if it could be
      if (!(CGAL::squared_distance(p, m_places[place_after_joining(end)].point) > m_most_squared_distance))
        return false;
    const Curve curve = curve_of(piece);
    return !(CGAL::squared_distance(p, curve(nearest_parameter(curve, p))) > m_most_squared_distance);
  }

  bool are_copies(std::size_t a, std::size_t b) const
  {
    const Curve one = curve_of(a), other = curve_of(b);
    const auto are_same = [](const Curve& p, const Curve& q) {
      return p.control_points() == q.control_points() && p.control_weights() == q.control_weights() &&
          p.size() == static_cast<std::size_t>(p.degree() + 1);
    };
    return one.degree() == other.degree() && one.size() == other.size() &&
        (are_same(one, other) || are_same(one.reversed(), other));
  }

  // Moves a place onto the piece near it, after the ends of that, and aligns directions. Returns whether it has its
  // final point: not yet, where it is the begin of a circle of places of which each one depends on the next one.
  bool settle(std::size_t place)
  {
    if (m_places[place].state != State::WAITING)
      return m_places[place].state == State::DONE;
    m_run.check();
    m_places[place].state = State::IN_PROGRESS;
    if (const std::vector<std::size_t>& pieces = m_places[place].near_pieces; pieces.empty())
      align_after_straight_pieces(place);
    else if (pieces.size() == 1 && are_ends_settled(pieces[0]))
      put_on(place, curve_of(pieces[0]));
    else
      ++left;
    m_places[place].state = State::DONE;
    return true;
  }

  bool are_ends_settled(std::size_t piece)
  {
    const auto& [begin, end] = m_pieces[piece].places;
    return settle(place_after_joining(begin)) && settle(place_after_joining(end));
  }

  // Where straight pieces end on others, these are put there before their directions count.
  void align_after_straight_pieces(std::size_t place)
  {
    const std::vector<Joint_side> sides = m_places[place].sides;
    for (const Joint_side& side : sides)
      if (const std::size_t end = place_after_joining(place_at(points.opposite(side)));
          end != none && !m_places[end].near_pieces.empty() && points.is_straight(side))
        settle(end);
    joints += align(place);
  }

  // Which sides are to have its tangent is decided before anything is moved.
  void put_on(std::size_t place, const Curve& curve)
  {
    const FT nearest = nearest_parameter(curve, m_places[place].point);
    const auto t = simplest_parameter(curve, m_places[place].point, nearest, m_most_distance);
    if (!t) {
      ++left;
      return;
    }
    std::vector<Joint_side> tangential;
    for (const Joint_side& side : m_places[place].sides)
      if (are_nearly_parallel(points.direction(side), curve.tangent(nearest)))
        tangential.push_back(side);
    const Point on_curve = curve(*t);
    const bool is_moved = on_curve != m_places[place].point;
    if (is_moved)
      move(place, on_curve);
    bool is_any = is_moved;
    for (const Joint_side& side : tangential)
      is_any |= straighten_or_leave(side, place, curve.tangent(*t)) > 0;
    is_any |= align(place, tangential);
    joints += is_any;
  }

  // How many control points were moved.
  int straighten_or_leave(const Joint_side& side, std::size_t place, const Vector& tangent)
  {
    const std::optional<int> moved = straighten(side, place, tangent);
    left += !moved;
    return moved.value_or(0);
  }

  // Gives the same tangent to sides of a place that nearly have it, but for some: that of a curve that keeps its
  // tangent, or of a straight piece. Returns whether anything was moved.
  bool align(std::size_t place, const std::vector<Joint_side>& others = {})
  {
    std::vector<Joint_side> sides = m_places[place].sides;
    std::erase_if(
        sides, [&](const Joint_side& side) { return std::find(others.begin(), others.end(), side) != others.end(); });
    const auto rank = [&](const Joint_side& side) {
      return points.is_straight(side) ? 1 : m_keepers[side.curve][points.next(side)] != none ? 0 : 2;
    };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Joint_side& a, const Joint_side& b) { return rank(a) < rank(b); });
    std::vector<Joint_side> first_ones; // with different tangents
    bool is_any = false;
    for (const Joint_side& side : sides) {
      const auto common = std::find_if(first_ones.begin(), first_ones.end(), [&](const Joint_side& first) {
        return are_nearly_parallel(points.direction(side), points.direction(first));
      });
      if (common == first_ones.end())
        first_ones.push_back(side);
      else {
        is_any |= straighten_or_leave(side, place, points.direction(*common)) > 0;
        if (std::size_t& keeper = m_keepers[common->curve][points.next(*common)]; keeper == none)
          keeper = place;
      }
    }
    return is_any;
  }

  bool are_nearly_parallel(const Vector& a, const Vector& b) const
  {
    const FT determinant = CGAL::determinant(a, b);
    const FT most = m_most_squared_sine * a.squared_length() * b.squared_length();
    return a != CGAL::NULL_VECTOR && b != CGAL::NULL_VECTOR && !(determinant * determinant > most);
  }

  // Moves the next control point onto a tangent, and where the curve is flat those behind it; all of a straight piece,
  // or nothing. Returns how many were moved; no number if the next one is not on the tangent and has to stay.
  std::optional<int> straighten(const Joint_side& side, std::size_t place, const Vector& tangent)
  {
    const std::size_t last = points.opposite(side).joint;
    const bool is_straight = points.is_straight(side);
    const std::vector<std::size_t> flat = flat_points(side);
    int moved = 0;
    for (const std::size_t i : flat) {
      if (CGAL::determinant(Vector(points.points(side.curve)[i] - m_places[place].point), tangent) != 0) {
        if (!is_movable(place, side, is_straight ? last : i))
          return i == flat.front() ? std::nullopt : std::optional(moved);
        points.move_onto_line(side.curve, i, m_places[place].point, tangent);
        ++moved;
        if (i == last)
          m_places[place_at(points.opposite(side))].point = points.points(side.curve)[i];
      }
      if (i != last)
        m_keepers[side.curve][i] = place;
    }
    return moved;
  }

  // Whether no other place depends on a control point of a side.
  bool is_movable(std::size_t place, const Joint_side& side, std::size_t index) const
  {
    const Joint_side opposite = points.opposite(side);
    if (index != opposite.joint)
      return is_kept_by_none_but(place, side.curve, index);
    const std::size_t end = place_at(opposite);
    return end != none && m_places[end].joined_with == none && m_places[end].sides.size() == 1 &&
        m_places[end].near_pieces.empty();
  }
};

} // namespace Joints
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_JOINT_PLACES_H
