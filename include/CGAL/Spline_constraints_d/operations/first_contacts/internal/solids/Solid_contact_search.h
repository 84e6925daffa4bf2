// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_SEARCH_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Time_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Moving_space.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_contact_equations.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/Solid_element.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/crossings.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// A solid that moves and one that does not, without inner breaks.
struct Moving_solids
{
  const Swept_volumes::Solid_boundary& moving;
  const Rational_motion_3& motion;
  const Swept_volumes::Solid_boundary& fixed;
  double tolerance; // of the solver

  const Swept_volumes::Solid_boundary& solid(std::size_t k) const { return k == 0 ? moving : fixed; }
};

// Finds the solutions of the equations of contact of solids.
class Solid_contact_search : public Time_search<Solid_contact_search, Solid_candidate>
{
  const Moving_solids& m_solids;
  std::array<std::vector<Solid_element>, 2> m_elements;
  std::vector<Exact_rational> m_breaks;                           // of the motion
  mutable std::map<std::pair<std::ptrdiff_t, Pair>, bool> m_void; // by the number of the part between breaks

public:
  struct Part
  {
    Moving_space motion;
    Linear_bounds_3 bounds;
    std::vector<Box_3> images;                       // of all elements
    std::vector<std::vector<Box_3>> images_of_parts; // of each
  };

  Solid_contact_search(const Moving_solids& solids, Budgeted_solver& solve)
    : Time_search(solve),
      m_solids(solids), m_elements{elements_of(solids.moving, solve), elements_of(solids.fixed, solve)},
      m_breaks(breaks_of_motion())
  {}

  const Moving_solids& solids() const { return m_solids; }
  const Rational_motion_3& motion() const { return m_solids.motion; }
  std::array<std::size_t, 2> numbers_of_elements() const { return {m_elements[0].size(), m_elements[1].size()}; }
  const Solid_element& element(std::size_t solid, std::size_t i) const { return m_elements[solid][i]; }

  Part part(const Parameter_range& time) const
  {
    Part result{Moving_space(motion(), time), Linear_bounds_3(motion(), time), {}, {}};
    const Upward_rounding_guard guard;
    for (const Solid_element& element : m_elements[0]) {
      result.images.push_back(result.motion.image(element.box));
      auto& parts = result.images_of_parts.emplace_back();
      for (const Box_3& box : element.boxes_of_parts)
        parts.push_back(result.motion.image(box));
    }
    return result;
  }

  bool do_meet(const Part& part, const Pair& pair) const
  {
    const Solid_element& fixed = m_elements[1][pair[1]];
    const auto& boxes = fixed.boxes_of_parts;
    return First_contacts::do_meet(part.images[pair[0]], fixed.box) &&
        std::ranges::any_of(part.images_of_parts[pair[0]],
                            [&](const Box_3& image) {
                              return First_contacts::do_meet(image, fixed.box) &&
                                  std::ranges::any_of(
                                         boxes, [&](const Box_3& box) { return First_contacts::do_meet(image, box); });
                            }) &&
        can_touch(part, pair);
  }

  void append_candidates(const Pair& pair, const Part& part, std::vector<Solid_candidate>& found)
  {
    const std::array<const Solid_element*, 2> elements{&m_elements[0][pair[0]], &m_elements[1][pair[1]]};
    const Solid_contact_equations equations(*elements[0], *elements[1], part.motion);
    for (const Solution_d<double>& solution : equations.solutions(solver())) {
      const auto box = solution.exact_box();
      Solid_candidate candidate{pair, {}, within(box.back(), part.motion.time()), solution};
      std::size_t next = 0;
      for (const std::size_t k : {0, 1})
        for (int axis = 0; axis < elements[k]->dimension(); ++axis)
          candidate.parameters[k].push_back(within(box[next++], {Exact_rational(0), Exact_rational(1)}));
      if (!cross_for_certain({*elements[0], candidate.parameters[0]}, {*elements[1], candidate.parameters[1]},
                             Linear_bounds_3(motion(), candidate.time)))
        found.push_back(std::move(candidate));
    }
  }

private:
  bool can_touch(const Part& part, const Pair& pair) const
  {
    const Solid_element &moving = m_elements[0][pair[0]], &fixed = m_elements[1][pair[1]];
    const auto all_of = [](const Solid_element& element) {
      return std::vector<Parameter_range>(static_cast<std::size_t>(element.dimension()),
                                          {Exact_rational(0), Exact_rational(1)});
    };
    return !are_void(part, pair) && !cross_for_certain({moving, all_of(moving)}, {fixed, all_of(fixed)}, part.bounds);
  }

  // Identities hold between two breaks of the motion, or nowhere there.
  bool are_void(const Part& part, const Pair& pair) const
  {
    const auto next_break = std::upper_bound(m_breaks.begin(), m_breaks.end(), part.motion.time().first);
    const auto [known, is_new] = m_void.try_emplace({next_break - m_breaks.begin(), pair}, false);
    if (is_new)
      known->second = Solid_contact_equations(m_elements[0][pair[0]], m_elements[1][pair[1]], part.motion).are_void();
    return known->second;
  }
};

inline int rank(const Solid_candidate& c) { return -static_cast<int>(c.parameters[0].size() + c.parameters[1].size()); }

// A box around the place of a candidate on a solid, in the space of this solid.
inline Vector_bounds<3> bounds_of_place(const Solid_contact_search& search, const Solid_candidate& c, std::size_t solid)
{
  const Spline_patch<3> part = search.element(solid, c.elements[solid]).map.part(c.parameters[solid]);
  const Exact_vector middle = part(part.middle());
  Vector_of_functions<3> offsets = part.numerators(); // from the middle, so that the weight does not matter much
  for (std::size_t i = 0; i < 3; ++i)
    offsets[i] = part.is_rational() ? offsets[i] - part.weight() * middle[i] : offsets[i] - middle[i];
  Vector_bounds<3> result = part.with_numerators(offsets).values();
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = result[i] + Rational_interval(middle[i]);
  return result;
}

// Whether the enclosure is of the size of the tolerance in space and time, as around a pole, where a parameter is free.
inline bool is_tiny(const Solid_contact_search& search, const Solid_candidate& c)
{
  if (c.is_proved() || is_next_to_end(c.solution))
    return false;
  if (c.solution.reason() == Undecided_reason::TOLERANCE)
    return true;
  const Exact_rational most(search.solids().tolerance);
  const auto is_narrow = [&](const auto& bounds) {
    return std::ranges::all_of(bounds, [&](const Rational_interval& x) { return x.upper - x.lower <= most; });
  };
  return c.time.second - c.time.first <= most && is_narrow(bounds_of_place(search, c, 0)) &&
      is_narrow(bounds_of_place(search, c, 1));
}

/*
Candidates that may be the same contact: of one pair of elements if their parameters meet; of two elements of a solid if
their boxes in space meet, and the place is not for certain inside of the element with more dimensions, or of one of two
with as many.
*/
inline bool may_be_the_same(const Solid_contact_search& search, const Solid_candidate& a, const Solid_candidate& b)
{
  const auto is_inside = [](const std::vector<Parameter_range>& parameters) {
    return std::ranges::all_of(parameters, [](const auto& range) { return range.first > 0 && range.second < 1; });
  };
  if (!do_meet(a.time, b.time))
    return false;
  for (const std::size_t k : {0, 1}) {
    const auto &own = a.parameters[k], &other = b.parameters[k];
    if (a.elements[k] == b.elements[k]) {
      for (std::size_t i = 0; i < own.size(); ++i)
        if (!do_meet(own[i], other[i]))
          return false;
    } else if ((own.size() >= other.size() && is_inside(own)) || (other.size() >= own.size() && is_inside(other)) ||
               are_apart(bounds_of_place(search, a, k), bounds_of_place(search, b, k)))
      return false;
  }
  return true;
}

// The ranges of both parameters of the patch of an element.
inline std::array<Parameter_range, 2> place_on_patch(const Solid_element& element,
                                                     const std::vector<Parameter_range>& parameters)
{
  std::array<Parameter_range, 2> result = element.place;
  std::size_t next = 0;
  for (Parameter_range& range : result)
    if (range.first < range.second)
      range = parameters[next++];
  return result;
}

inline std::array<Undecided_part::Range, 2> original_place(const Solid_contact_search& search, const Solid_candidate& c,
                                                           std::size_t solid)
{
  const Solid_element& element = search.element(solid, c.elements[solid]);
  const auto place = place_on_patch(element, c.parameters[solid]);
  const auto original = [&](int axis) {
    return search.solids().solid(solid).original_range(element.patch, axis,
                                                       to_double_range(place[static_cast<std::size_t>(axis)]));
  };
  return {original(0), original(1)};
}

inline Contact_3 contact_of(const Solid_contact_search& search, const Solid_candidate& candidate)
{
  const auto place = [&](std::size_t k) {
    const Solid_element& element = search.element(k, candidate.elements[k]);
    return Contact_3::Place{search.solids().solid(k).operand(element.patch), original_place(search, candidate, k),
                            element.part};
  };
  const Vector_bounds<3> bounds = bounds_of_place(search, candidate, 1);
  const auto range = [&](std::size_t i) { return Contact_3::Range(bounds[i].lower, bounds[i].upper); };
  return {candidate.time, {range(0), range(1), range(2)}, {place(0), place(1)}, candidate.solution};
}

inline Undecided_part undecided_contact(const Solid_contact_search& search, const Solid_candidate& candidate)
{
  Undecided_part result = undecided_time(candidate.time, in_words(candidate.solution.reason()));
  for (const std::size_t k : {0, 1}) {
    const std::size_t patch = search.element(k, candidate.elements[k]).patch;
    const auto place = original_place(search, candidate, k);
    result.parameters.push_back(
        {search.solids().solid(k).operand(patch) + (k == 0 ? 0 : search.solids().moving.number_of_operands()),
         {place[0], place[1]}});
  }
  return result;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_SEARCH_H
