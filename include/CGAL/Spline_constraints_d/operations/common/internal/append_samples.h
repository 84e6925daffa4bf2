// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_APPEND_SAMPLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_APPEND_SAMPLES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// How often a part of a curve is halved.
struct Halvings
{
  int least = 2;
  int most = 16;
};

// Appends samples of a curve, behind those that there are, up to a last one: halves the way until `is_chord(from,
// between, to)`, where `between(from, to)` is the sample in the middle.
template <class Sample, class Between, class Is_chord>
void append_samples(std::vector<Sample>& samples, const Sample& to, const Between& between, const Is_chord& is_chord,
                    const Halvings& halvings = {}, int depth = 0)
{
  const Sample middle = between(samples.back(), to);
  if (depth >= halvings.most || (depth >= halvings.least && is_chord(samples.back(), middle, to))) {
    samples.push_back(to);
    return;
  }
  append_samples(samples, middle, between, is_chord, halvings, depth + 1);
  append_samples(samples, to, between, is_chord, halvings, depth + 1);
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_APPEND_SAMPLES_H
