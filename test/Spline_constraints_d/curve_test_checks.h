// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_CURVE_TEST_CHECKS_H
#define TEST_CURVE_TEST_CHECKS_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;

// What holds of every answer: pieces are chained, ends lie in their boxes, vertices inside the domain belong to two
// pieces.
inline void check_chains(const SC::Curve_solution_set_d& set)
{
  std::vector<int> uses(set.vertices().size(), 0);
  for (const SC::Solution_curve& curve : set.curves()) {
    ASSERT_FALSE(curve.pieces.empty());
    for (std::size_t p = 0; p < curve.pieces.size(); ++p) {
      const SC::Curve_piece& piece = curve.pieces[p];
      EXPECT_TRUE(p == 0 || piece.ends[0] == curve.pieces[p - 1].ends[1]);
      for (const std::size_t end : piece.ends) {
        ++uses[end];
        const SC::Curve_vertex& vertex = set.vertices()[end];
        for (std::size_t j = 0; j < vertex.box.size(); ++j) {
          EXPECT_LE(piece.box[j].first, vertex.box[j].second);
          EXPECT_LE(vertex.box[j].first, piece.box[j].second);
        }
      }
      const auto place = [&](std::size_t end) {
        return set.vertices()[piece.ends[end]].box[(std::max)(piece.parameter, 0)];
      };
      EXPECT_TRUE(piece.parameter < 0 || place(0).second < place(1).first || place(1).second < place(0).first);
    }
    EXPECT_TRUE(!curve.is_closed || curve.pieces.back().ends[1] == curve.pieces.front().ends[0]);
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const SC::Curve_vertex& vertex = set.vertices()[i];
    EXPECT_TRUE(!set.is_complete() || vertex.is_on_boundary || vertex.is_on_inequality || vertex.is_singular ||
                uses[i] == 2);
  }
}

// Pieces that end in a vertex.
inline std::size_t number_of_ends_at(const SC::Curve_solution_set_d& set, std::size_t vertex)
{
  std::size_t result = 0;
  for (const SC::Solution_curve& curve : set.curves())
    for (const SC::Curve_piece& piece : curve.pieces)
      result += static_cast<std::size_t>(std::count(piece.ends.begin(), piece.ends.end(), vertex));
  return result;
}

// Ends of open curves, in the order of the domain's boundary.
inline std::size_t ends_on_boundary(const SC::Curve_solution_set_d& set)
{
  std::size_t result = 0;
  for (const SC::Solution_curve& curve : set.curves())
    if (!curve.is_closed)
      for (const std::size_t i : {curve.pieces.front().ends[0], curve.pieces.back().ends[1]})
        result += set.vertices()[i].is_on_boundary;
  return result;
}

inline void expect_curves(const SC::Curve_solution_set_d& set, std::size_t closed, std::size_t open,
                          const std::string& what = "")
{
  check_chains(set);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << what;
  EXPECT_EQ(set.number_of_open_curves(), open) << what;
  EXPECT_EQ(ends_on_boundary(set), 2 * open) << what;
}

inline void expect_point(const SC::Curve_vertex::Exact_box& box, const std::vector<SC::Exact_rational>& point)
{
  for (std::size_t j = 0; j < point.size(); ++j) {
    EXPECT_LE(box[j].first, point[j]);
    EXPECT_GE(box[j].second, point[j]);
    EXPECT_LT(SC::Exact_rational(box[j].second - box[j].first), SC::Exact_rational(1, 1000000));
  }
}

#endif // TEST_CURVE_TEST_CHECKS_H
