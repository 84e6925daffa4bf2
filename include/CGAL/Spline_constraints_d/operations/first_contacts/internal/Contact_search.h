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
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Time_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
Finds the solutions of the equations of contact of regions. Boxes of parts of the pieces tell which ones are near.
*/
class Contact_search : public Time_search<Contact_search, Contact_candidate>
{
  using Box = std::array<Interval, 2>;

  // Around the images of a piece, and of its parts.
  struct Boxes
  {
    Box whole;
    std::vector<Box> parts;
  };

  const Rational_motion_2& m_motion;
  std::vector<Boundary_element> m_moving, m_fixed;
  std::size_t m_number_of_moving_curves;

public:
  struct Part
  {
    Motion_part motion;
    std::vector<Boxes> images; // of all elements
  };

  Contact_search(const Moving_regions& regions, Budgeted_solver& solve)
    : Time_search(solve), m_motion(regions.motion), m_moving(elements_of(regions.moving, solve)),
      m_fixed(elements_of(regions.fixed, solve)), m_number_of_moving_curves(regions.number_of_moving_curves)
  {}

  const Rational_motion_2& motion() const { return m_motion; }
  std::size_t number_of_moving_curves() const { return m_number_of_moving_curves; }
  std::array<std::size_t, 2> numbers_of_elements() const { return {m_moving.size(), m_fixed.size()}; }

  const Boundary_element& element(std::size_t region, std::size_t i) const
  {
    return region == 0 ? m_moving[i] : m_fixed[i];
  }

  Part part(const Parameter_range& time) const
  {
    Part result{Motion_part(m_motion, time), {}};
    const Upward_rounding_guard guard;
    for (const Boundary_element& element : m_moving) {
      result.images.push_back({result.motion.image(element.box), {}});
      for (const Box& box : element.boxes_of_parts)
        result.images.back().parts.push_back(result.motion.image(box));
    }
    return result;
  }

  bool do_meet(const Part& part, const Pair& pair) const
  {
    const Boxes& images = part.images[pair[0]];
    const Boundary_element& fixed = m_fixed[pair[1]];
    return do_meet(images.whole, fixed.box) && std::ranges::any_of(images.parts, [&](const Box& image) {
             return do_meet(image, fixed.box) &&
                 std::ranges::any_of(fixed.boxes_of_parts, [&](const Box& box) { return do_meet(image, box); });
           });
  }

  void append_candidates(const Pair& pair, const Part& part, std::vector<Contact_candidate>& found)
  {
    const Boundary_element &moving = m_moving[pair[0]], &fixed = m_fixed[pair[1]];
    const Contact_equations equations(moving, fixed, part.motion, m_motion.keeps_orientation());
    const Box vertex = image_of_vertex(moving, part.motion), &image = part.images[pair[0]].whole;
    for (const bool is_moving_vertex : {true, false})
      for (const bool is_fixed_vertex : {true, false}) {
        const std::array<bool, 2> is_at_vertex{is_moving_vertex, is_fixed_vertex};
        if (!do_meet(is_moving_vertex ? vertex : image, is_fixed_vertex ? box_of(fixed.vertex) : fixed.box) ||
            equations.are_void(is_at_vertex))
          continue;
        for (const Solution_d<double>& solution : equations.solutions(is_at_vertex, solver()))
          found.push_back(candidate(pair, is_at_vertex, part.motion.time(), solution));
      }
  }

private:
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

  static Contact_candidate candidate(const std::array<std::size_t, 2>& pair, const std::array<bool, 2>& is_at_vertex,
                                     const Parameter_range& time, const Solution_d<double>& solution)
  {
    const auto box = solution.exact_box();
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
