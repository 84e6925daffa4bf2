// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are primitives but for rounding: which ones are, that what they leave open ends after a counted amount
// of work and says why, and that limits and visitors are heeded all the same.

#include "pairs_of_primitives.h"
#include "surfaces_of_cad_programs.h"

#include <CGAL/Spline_constraints_d/geometry/healing/exact_primitives.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/primitives/Rounded_primitives.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace rounded_primitives_test {

using pairs_of_primitives::Pair;
using surfaces_of_cad_programs::Motion;
using surfaces_of_cad_programs::Rounded_surface;
using surfaces_of_cad_programs::written;

Pair pair_of_name(const std::string& name)
{
  const std::vector<Pair> all = pairs_of_primitives::all_pairs();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Pair& pair) { return pair.name == name; });
  EXPECT_NE(found, all.end());
  return *found;
}

const Motion motion = Motion::turned({1, 2, -0.7}, 1.1, {std::sqrt(2.0), -std::exp(1.0), 0.123456789});

std::vector<Rounded_surface> written_pair(const Pair& pair)
{
  return {written(pair.a.patch, motion), written(pair.b.patch, motion)};
}

template <class A, class B>
std::string counts(const A& a, const B& b)
{
  const auto set = SC::intersection_curves(a, b);
  std::ostringstream out;
  out << set.number_of_closed_curves() << '/' << set.number_of_open_curves() << '/' << set.singular_points().size();
  return set.is_complete() ? out.str() : "u";
}

template <class A>
std::optional<SC::Primitive_kind> rounded(const A& surface)
{
  const auto primitive =
      SC::internal::Intersections::recognised_primitive(SC::internal::Common::Spline_patch<3>(surface));
  return primitive && primitive->is_rounded ? std::optional(primitive->kind) : std::nullopt;
}

TEST(Rounded_primitives, AreToldFromExactOnes)
{
  // by long fractions
  const K::Aff_transformation_3 shift(CGAL::TRANSLATION, Vector(Rational(1, 977), Rational(-5, 1009), Rational(7, 3)));
  std::size_t exact = 0;
  for (const char* name : {"plane, sphere", "cylinder, torus: one axis", "cones cross"}) {
    const Pair pair = pair_of_name(name);
    for (const Surface& surface : {pair.a.patch, pair.b.patch}) {
      SCOPED_TRACE(name);
      EXPECT_EQ(rounded(surface), std::nullopt);
      EXPECT_EQ(rounded(surface.transformed(shift)), std::nullopt);
      ++exact;
    }
    EXPECT_NE(rounded(written(pair.b.patch, motion)), std::nullopt);
  }
  EXPECT_EQ(exact, 6u);
  EXPECT_EQ(rounded(written(pair_of_name("plane, sphere").b.patch, motion)), SC::Primitive_kind::SPHERE);
  EXPECT_EQ(rounded(written(pair_of_name("plane, sphere").a.patch, motion)), SC::Primitive_kind::PLANE);
  EXPECT_EQ(rounded(written(pair_of_name("cones cross").b.patch, motion)), SC::Primitive_kind::CONE);
  EXPECT_EQ(rounded(written(pair_of_name("plane, saddle").b.patch, motion)), std::nullopt);
}

// All of these took more than a second, or did not end.
TEST(Rounded_primitives, WhatTheyLeaveOpenIsNamed)
{
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"plane touches cone", "rounded plane and cone; heal with a tolerance"},
      {"ball in tube", "rounded cylinder and sphere; heal with a tolerance"},
      {"cylinders coincide", "rounded cylinder and cylinder; heal with a tolerance"},
      {"pipe in torus", "rounded cylinder and torus; heal with a tolerance"}};
  for (const auto& [name, reason] : pairs) {
    SCOPED_TRACE(name);
    const Pair pair = pair_of_name(name);
    const std::vector<Rounded_surface> surfaces = written_pair(pair);
    const auto set = SC::intersection_curves(surfaces[0], surfaces[1]);
    EXPECT_FALSE(set.is_complete());
    const auto undecided = set.undecided();
    EXPECT_TRUE(std::any_of(undecided.begin(), undecided.end(),
                            [&, &why = reason](const SC::Undecided_part& part) { return part.reason == why; }));
    EXPECT_NE(set.summary().why_not, SC::Undecided_reason::STOPPED);
    EXPECT_NE(set.summary().why_not, SC::Undecided_reason::TIME);
    const auto again = SC::intersection_curves(surfaces[0], surfaces[1]); // work is counted, not time
    EXPECT_EQ(again.summary().nodes, set.summary().nodes);
    EXPECT_EQ(again.undecided().size(), undecided.size());
  }
}

TEST(Rounded_primitives, CrossingsAreDecided)
{
  for (const char* name : {"spheres", "cylinders, skew", "cylinder, sphere: two loops", "torus, sphere"}) {
    SCOPED_TRACE(name);
    const Pair pair = pair_of_name(name);
    const std::vector<Rounded_surface> surfaces = written_pair(pair);
    EXPECT_EQ(counts(surfaces[0], surfaces[1]), pair.counts[0]);
  }
}

TEST(Rounded_primitives, HealedOnesAreNotLimited)
{
  const Pair pair = pair_of_name("ball in tube");
  const std::vector<Surface> healed = SC::with_exact_primitives(written_pair(pair), 1e-9).simple_splines();
  EXPECT_EQ(counts(healed[0], healed[1]), pair.counts[0]);
}

struct Counting_visitor
{
  std::size_t questions = 0, most = 1000000000;
  void on_progress(double) {}
  bool stop() { return ++questions >= most; }
};

TEST(Rounded_primitives, LimitsOfTheCallerAreTheOnlyOnes)
{
  constexpr std::size_t most = SC::internal::Intersections::Rounded_primitives::most_questions;
  const std::vector<Rounded_surface> surfaces = written_pair(pair_of_name("cylinders coincide"));
  const auto reason_of = [](const auto& set) {
    const auto undecided = set.undecided();
    return undecided.empty() ? std::string() : undecided.front().reason;
  };
  Counting_visitor watching;
  const auto watched = SC::intersection_curves(surfaces[0], surfaces[1], {.tolerance = 1e-8, .visitor = watching});
  EXPECT_EQ(reason_of(watched), "rounded cylinder and cylinder; heal with a tolerance");
  EXPECT_LT(watching.questions, most); // the last question is not passed on

  Counting_visitor of_time;
  const auto longer =
      SC::intersection_curves(surfaces[0], surfaces[1], {.tolerance = 1e-8, .time_limit = 2, .visitor = of_time});
  EXPECT_EQ(reason_of(longer), "time limit");
  EXPECT_GT(of_time.questions, most);

  Counting_visitor stopping{0, 100};
  const auto stopped = SC::intersection_curves(surfaces[0], surfaces[1], {.tolerance = 1e-8, .visitor = stopping});
  EXPECT_EQ(reason_of(stopped), "stopped");
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
}

} // namespace rounded_primitives_test
