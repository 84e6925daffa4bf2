// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_KRAWCZYK_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_KRAWCZYK_TEST_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Affine_enclosures.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Preconditioned_rows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A box with one solution of the equalities, which is regular, and an enclosure of it inside.
struct Proved_root
{
  Box_of_ranges enclosure, region;
};

inline bool is_inside(const Box_of_ranges& a, const Box_of_ranges& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), [](const Interval& inner, const Interval& outer) {
    return outer.inf() <= inner.inf() && inner.sup() <= outer.sup();
  });
}

// Whether two roots are the same, where that is certain: the only one of a region is the only one in parts of it.
inline bool are_equal(const Proved_root& a, const Proved_root& b)
{
  return is_inside(a.enclosure, b.region) || is_inside(b.enclosure, a.region);
}

inline void add_unless_known(const Proved_root& root, std::vector<Proved_root>& roots)
{
  if (std::none_of(roots.begin(), roots.end(), [&](const Proved_root& other) { return are_equal(root, other); }))
    roots.push_back(root);
}

/*
The test of Krawczyk, with combinations of equalities that are formed before they are bounded: where the image of a box
under x - C f(x), by the mean value theorem, lies in its interior, the box has exactly one zero of f.
*/
class Krawczyk_test
{
  Preconditioned_rows& m_rows;
  bool m_has_functions;
  Box_of_ranges m_image;

public:
  Krawczyk_test(Preconditioned_rows& rows, bool has_functions) : m_rows(rows), m_has_functions(has_functions) {}

  // The root of a box that is widened a little, when there is one: refined until nothing is gained. Where equalities
  // are hardly independent, rounding asks for more room.
  std::optional<Proved_root> operator()(const Box_of_ranges& box)
  {
    constexpr double widening = 0.5;
    Proved_root root;
    for (const double room : {1e-13, 1e-11, 1e-9}) {
      root.region.clear();
      for (const Interval& range : box)
        root.region.push_back(widened(range, widening * width(range) + room * (std::max)(1.0, magnitude(range))));
      if (!maps_into_itself(root.region))
        continue;
      root.enclosure = m_image;
      refine(root);
      return root;
    }
    return std::nullopt;
  }

private:
  static Interval widened(const Interval& range, double by)
  {
    return Interval((Interval(range.inf()) - Interval(by)).inf(), (Interval(range.sup()) + Interval(by)).sup());
  }

  // The image of a box, if it lies in the interior; or whatever it is, which has the root that the box has.
  bool maps_into_itself(const Box_of_ranges& box, bool is_anywhere = false)
  {
    if (!m_rows.invert(box))
      return false;
    Affine_enclosures& enclosures = m_rows.enclosures();
    m_image.resize(box.size());
    for (std::size_t i = 0; i < box.size(); ++i) {
      const int own = static_cast<int>(i);
      enclosures.set_sum_of_derivatives(m_rows.multiples(own), box);
      Interval image = Interval(enclosures.centre(own)) - enclosures.constant();
      bool has_own = false;
      for (const int j : enclosures.unknowns()) {
        const Interval slope = j == own ? Interval(1) - enclosures.slope(j) : -enclosures.slope(j);
        image += slope * enclosures.offset(j);
        has_own = has_own || j == own;
      }
      if (!has_own ||
          (is_anywhere ? !(image.inf() <= image.sup()) : !(image.inf() > box[i].inf() && image.sup() < box[i].sup())))
        return false;
      m_image[i] = image;
    }
    return true;
  }

  // With functions, whose bounds are some ulps wide, one unknown may be as well known as it can be long before others.
  void refine(Proved_root& root)
  {
    constexpr int most_steps = 30;
    constexpr double margin = 0.1, rounding = 0x1p-53, least_gain = 0.1;
    Box_of_ranges box(root.enclosure.size());
    for (int step = 0; step < most_steps; ++step) {
      for (std::size_t j = 0; j < box.size(); ++j)
        box[j] = widened(root.enclosure[j],
                         margin * width(root.enclosure[j]) + rounding * magnitude(root.enclosure[j]) + 1e-300);
      if (!maps_into_itself(box, m_has_functions))
        return;
      bool is_gain = false;
      for (std::size_t j = 0; j < box.size(); ++j) {
        is_gain = is_gain || width(m_image[j]) < (1 - least_gain) * width(root.enclosure[j]);
        root.enclosure[j] = common_part(root.enclosure[j], m_image[j]); // both have the root
      }
      if (!is_gain)
        return;
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_KRAWCZYK_TEST_H
