// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_SEARCH_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Boundary_element.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_equations.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
Finds the solutions of the equations of contact, one part of the time after the other. A part is halved as long as many
pairs of elements have boxes that meet in it: where regions are far from each other, nothing is solved. Knots of the
motion are ends of parts.
*/
class Contact_search
{
  using Pairs = std::vector<std::array<std::size_t, 2>>;
  using Box = std::array<Interval, 2>;

  const Rational_motion_2& m_motion;
  std::vector<Boundary_element> m_moving, m_fixed;
  Budgeted_solver& m_solve;
  std::optional<Exact_rational> m_stop;

public:
  // Is told the candidates of a part of the time, and says whether to go on.
  using Visitor = std::function<bool(const Parameter_range&, std::vector<Contact_candidate>)>;

  Contact_search(const Moving_regions& regions, Budgeted_solver& solve)
    : m_motion(regions.motion), m_moving(elements_of(regions.moving, solve)),
      m_fixed(elements_of(regions.fixed, solve)), m_solve(solve)
  {}

  const Boundary_element& element(std::size_t region, std::size_t i) const
  {
    return region == 0 ? m_moving[i] : m_fixed[i];
  }

  // Where the run was ended by a limit: before this time all is found.
  const std::optional<Exact_rational>& stop() const { return m_stop; }

  void operator()(const Visitor& visitor)
  {
    if (m_solve.has_ended()) {
      m_stop = m_motion.domain().first;
      return;
    }
    Pairs all;
    for (std::size_t i = 0; i < m_moving.size(); ++i)
      for (std::size_t k = 0; k < m_fixed.size(); ++k)
        all.push_back({i, k});
    const std::vector<Exact_rational> breaks = breaks_of_motion();
    const int depth = static_cast<int>(std::bit_width(breaks.size() - 1)) - 1;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      if (!search({breaks[i - 1], breaks[i]}, all, depth, visitor))
        return;
  }

private:
  // Where the motion is no polynomial one, so that what is true all the time within a part is an identity.
  std::vector<Exact_rational> breaks_of_motion() const
  {
    std::vector<Exact_rational> result = m_motion.weight().breaks(0);
    for (const auto& column : m_motion.columns())
      for (const auto& f : column)
        result = internal::united(result, f.breaks(0));
    return result;
  }

  bool search(const Parameter_range& time, const Pairs& pairs, int depth, const Visitor& visitor)
  {
    constexpr int least_depth = 3, greatest_depth = 8;
    constexpr std::size_t few = 8;
    if (m_solve.has_ended()) {
      m_stop = time.first;
      return false;
    }
    const Motion_part part(m_motion, time);
    const std::vector<Boxes> images = boxes_of_images(part);
    Pairs near;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(near),
                 [&](const auto& pair) { return do_any_meet(images[pair[0]], m_fixed[pair[1]]); });
    if (near.empty())
      return true;
    if (depth < least_depth || (depth < greatest_depth && near.size() > few)) {
      // Not in the middle, where contacts are more likely than elsewhere: it would be found in both parts.
      const Exact_rational middle(time.first + (time.second - time.first) * 31 / 64);
      return search({time.first, middle}, near, depth + 1, visitor) &&
          search({middle, time.second}, near, depth + 1, visitor);
    }
    std::vector<Contact_candidate> found;
    for (const auto& pair : near) {
      if (m_solve.has_ended())
        m_stop = time.first;
      else
        append_candidates(pair, part, images[pair[0]].whole, found);
    }
    return visitor(time, std::move(found)) && !m_stop;
  }

  // Around the images of a piece, and of its parts.
  struct Boxes
  {
    Box whole;
    std::vector<Box> parts;
  };

  std::vector<Boxes> boxes_of_images(const Motion_part& part) const
  {
    const Upward_rounding_guard guard;
    std::vector<Boxes> result;
    for (const Boundary_element& element : m_moving) {
      result.push_back({part.image(element.box), {}});
      for (const Box& box : element.boxes_of_parts)
        result.back().parts.push_back(part.image(box));
    }
    return result;
  }

  static bool do_any_meet(const Boxes& images, const Boundary_element& fixed)
  {
    return do_meet(images.whole, fixed.box) && std::ranges::any_of(images.parts, [&](const Box& image) {
             return do_meet(image, fixed.box) &&
                 std::ranges::any_of(fixed.boxes_of_parts, [&](const Box& box) { return do_meet(image, box); });
           });
  }

  static bool do_meet(const Box& a, const Box& b)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (a[axis].sup() < b[axis].inf() || b[axis].sup() < a[axis].inf())
        return false;
    return true;
  }

  static Box box_of(const Exact_pair& point) { return interval_pair_of<Interval>(point); }

  static Box image_of_vertex(const Boundary_element& element, const Motion_part& part)
  {
    const Upward_rounding_guard guard;
    return part.image(box_of(element.vertex));
  }

  void append_candidates(const std::array<std::size_t, 2>& pair, const Motion_part& part, const Box& image,
                         std::vector<Contact_candidate>& found)
  {
    const Boundary_element &moving = m_moving[pair[0]], &fixed = m_fixed[pair[1]];
    const Contact_equations equations(moving, fixed, part, m_motion.keeps_orientation());
    const Box vertex = image_of_vertex(moving, part);
    for (const bool is_moving_vertex : {true, false})
      for (const bool is_fixed_vertex : {true, false}) {
        const std::array<bool, 2> is_at_vertex{is_moving_vertex, is_fixed_vertex};
        if (!do_meet(is_moving_vertex ? vertex : image, is_fixed_vertex ? box_of(fixed.vertex) : fixed.box) ||
            equations.are_void(is_at_vertex))
          continue;
        for (const Solution_d<double>& solution : equations.solutions(is_at_vertex, m_solve))
          found.push_back(candidate(pair, is_at_vertex, part.time(), solution));
      }
  }

  // Enclosures may be larger than the domain by rounding; solutions are in it.
  static Contact_candidate candidate(const std::array<std::size_t, 2>& pair, const std::array<bool, 2>& is_at_vertex,
                                     const Parameter_range& time, const Solution_d<double>& solution)
  {
    const auto box = solution.exact_box();
    const auto within = [](const Parameter_range& range, const Parameter_range& domain) {
      return Parameter_range((std::max)(range.first, domain.first), (std::min)(range.second, domain.second));
    };
    Contact_candidate result{pair, is_at_vertex, {}, within(box.back(), time), solution};
    std::size_t next = 0;
    for (const std::size_t k : {0, 1}) {
      const Exact_rational zero(0);
      result.parameters[k] =
          is_at_vertex[k] ? Parameter_range(zero, zero) : within(box[next++], {zero, Exact_rational(1)});
    }
    return result;
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_SEARCH_H
