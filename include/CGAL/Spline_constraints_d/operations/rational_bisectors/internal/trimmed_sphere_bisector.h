// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/functions_on_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/parts_of_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// The pieces of a surface, and how many of them there are along both axes.
struct Foot_pieces
{
  std::vector<Foot_piece> pieces;
  std::array<std::size_t, 2> shape;

  //! \pre no piece is a curve.
  static Foot_pieces of(const std::vector<Polynomial_piece>& all, const Operation_budget& budget)
  {
    Foot_pieces result;
    for (const Polynomial_piece& piece : all) {
      budget.check();
      result.pieces.push_back(Foot_piece::of(piece.coordinates).value());
    }
    const auto is_in_first_row = [&](const Polynomial_piece& piece) { return piece.domain[0] == all[0].domain[0]; };
    result.shape[1] = static_cast<std::size_t>(std::ranges::count_if(all, is_in_first_row));
    result.shape[0] = all.size() / result.shape[1];
    return result;
  }
};

// A positive multiple of <S - r n - Q, n> for a sphere around Q of radius r and a piece with the normal n: its sign is
// not that of x + r, for a point S + x n of the bisector, and it is zero at poles.
inline Tensor side_of_bisector(const Oriented_sphere& sphere, const Polynomial_piece& surface)
{
  const Power_polynomial& w = surface.weight();
  const Polynomial_vector q{Power_polynomial(sphere.center.x()), Power_polynomial(sphere.center.y()),
                            Power_polynomial(sphere.center.z())};
  const Polynomial_vector e = surface.numerators() - w * q;
  Power_polynomial result;
  if (sphere.radius == 0) {
    const std::vector<Power_polynomial> n = oriented_normal(normal_of(surface.coordinates));
    result = dot(e, {n[0], n[1], n[2]});
  } else {
    const Unit_normal unit = unit_normal(surface.coordinates).value();
    const std::vector<Power_polynomial>& n = unit.direction;
    result = dot(e, {n[0], n[1], n[2]}) - Power_polynomial(sphere.radius) * w * unit.length;
  }
  return tensors_of({value_at(w, 0, 0) < 0 ? -result : result}).front();
}

/*
Whether faces of the bisector of a sphere, or a point, and a surface have nearest feet: decided on the cells of a grid
that cover a face, which are those within reach that are connected with the sample of the face and on the same side of
poles. A face has a label if all of them give the same answer.
*/
class Face_trimming
{
  using Interval = Interval_net::Interval;
  using Answer = Nearest_feet::Answer;

  // Of a piece, or a part of it.
  struct Nets
  {
    std::vector<Interval_net> feet;        // those of the grid
    std::vector<Interval_net> coordinates; // the point from the center of the sphere, times the weight, and the weight
    Interval_net power;                    // positive out of reach
    Interval_net side;                     // zero at poles
  };

  // A square of cells of the grid, or a part of a cell.
  struct Block
  {
    std::array<int, 2> at;
    int size;
  };

  // Those of all cells of the grid, row by row; none out of reach.
  using Answers = std::vector<std::optional<Answer>>;

  const Operation_budget& m_budget;
  Foot_grid::Box m_center;
  Interval m_radius, m_reach; // of the sphere, with its sign; the greatest distance from its center
  CGAL::Sign m_sign_of_radius;
  std::vector<Tensor> m_sides;
  std::vector<Nets> m_nets;
  Foot_grid m_grid;
  Nearest_feet m_feet;
  std::map<std::pair<std::size_t, bool>, Answers> m_answers; // of a piece and the sign of its side

public:
  // \pre rounding is upwards, here and below
  Face_trimming(const Rational_bisector_3& bisector, const std::vector<Polynomial_piece>& surface,
                const Foot_pieces& feet, const Oriented_sphere& sphere, const Reach& reach,
                const Operation_budget& budget)
    : m_budget(budget), m_center{to_double_interval(sphere.center.x()), to_double_interval(sphere.center.y()),
                                 to_double_interval(sphere.center.z())},
      m_radius(to_double_interval(sphere.radius)),
      m_reach(CGAL::sqrt(Interval(to_double_interval(reach.squared_radius))) +
              CGAL::sqrt(Interval(to_double_interval(CGAL::squared_distance(sphere.center, reach.center))))),
      m_sign_of_radius(CGAL::sign(sphere.radius)), m_grid(feet.pieces, feet.shape, feet.pieces.size() < 8 ? 32 : 16),
      m_feet(m_grid, budget)
  {
    const Rational_bisector_piece_3::Coordinates center = constant_coordinates(sphere.center),
                                                 center_of_reach = constant_coordinates(reach.center);
    for (std::size_t k = 0; k < surface.size(); ++k) {
      const auto& x = bisector.pieces()[k].coordinates();
      m_sides.push_back(side_of_bisector(sphere, surface[k]));
      Nets nets{m_grid.nets(k),
                {},
                Interval_net(power_of_distance(x, center_of_reach, reach.squared_radius)),
                Interval_net(m_sides.back())};
      for (std::size_t c = 0; c < 3; ++c)
        nets.coordinates.emplace_back(x[c] - x[3] * center[c]);
      nets.coordinates.emplace_back(x[3]);
      m_nets.push_back(std::move(nets));
    }
  }

  // For the face around parameters in the unit box of a piece; or, if pieces are cut into blocks that need not be cut
  // any further, for what is in one of these.
  std::optional<int> label(std::size_t piece, const Parameters& local, bool is_cut)
  {
    const CGAL::Sign side = CGAL::sign(m_sides[piece](local));
    if (side == CGAL::ZERO)
      return std::nullopt;
    const bool is_positive = side > 0;
    // x + r and r have different signs: the distance is that from the farthest point of the sphere.
    if (is_positive ? m_sign_of_radius > 0 : m_sign_of_radius < 0)
      return NOT_NEAREST;
    auto [known, is_new] = m_answers.try_emplace({piece, is_positive});
    if (is_new) {
      known->second.resize(static_cast<std::size_t>(m_grid.size() * m_grid.size()));
      add_answers(known->second, piece, m_nets[piece], {{0, 0}, m_grid.size()}, is_positive);
    }
    const auto index = [&](std::size_t axis) {
      const Exact_rational place(local[axis] * m_grid.size());
      int i = static_cast<int>(std::floor(to_nearest_double(place)));
      if (place < i) // it was rounded upwards
        --i;
      return (std::min)((std::max)(i, 0), m_grid.size() - 1);
    };
    const std::array<int, 2> at{index(0), index(1)};
    switch (is_cut ? known->second[index_of(at)].value_or(Answer::UNKNOWN) : connected_answer(known->second, at)) {
    case Answer::YES:
      return NEAREST;
    case Answer::NO:
      return NOT_NEAREST;
    default:
      return std::nullopt;
    }
  }

  // Whether cells in a block of a piece, given by its place among those of its size, have different answers. All faces
  // have been asked for.
  bool must_be_cut(std::size_t piece, const std::array<int, 2>& at, int blocks) const
  {
    const int size = m_grid.size() / blocks;
    for (const bool is_positive : {false, true})
      if (const auto known = m_answers.find({piece, is_positive}); known != m_answers.end())
        if (!agree(known->second, {{at[0] * size, at[1] * size}, size}))
          return true;
    return false;
  }

private:
  std::size_t index_of(const std::array<int, 2>& at) const
  {
    return static_cast<std::size_t>(at[0] * m_grid.size() + at[1]);
  }

  // Whether all cells of a block that are not out of reach have the same answer.
  bool agree(const Answers& answers, const Block& block) const
  {
    std::optional<Answer> first;
    for (int i = block.at[0]; i < block.at[0] + block.size; ++i)
      for (int j = block.at[1]; j < block.at[1] + block.size; ++j)
        if (const std::optional<Answer> answer = answers[index_of({i, j})]) {
          if (first && *first != *answer)
            return false;
          first = answer;
        }
    return true;
  }

  // Of all cells that are connected with one.
  Answer connected_answer(const Answers& answers, const std::array<int, 2>& start) const
  {
    const int n = m_grid.size();
    const auto index = [this](const std::array<int, 2>& at) { return index_of(at); };
    if (!answers[index(start)])
      return Answer::UNKNOWN;
    std::vector<bool> is_known(answers.size(), false);
    std::vector<std::array<int, 2>> open{start};
    is_known[index(start)] = true;
    while (!open.empty()) {
      const std::array<int, 2> at = open.back();
      open.pop_back();
      if (*answers[index(at)] != *answers[index(start)])
        return Answer::UNKNOWN;
      for (const std::size_t axis : {0, 1})
        for (const int step : {-1, 1}) {
          std::array<int, 2> next = at;
          next[axis] += step;
          if (next[axis] < 0 || next[axis] >= n || is_known[index(next)] || !answers[index(next)])
            continue;
          is_known[index(next)] = true;
          open.push_back(next);
        }
    }
    return *answers[index(start)];
  }

  // Of the cells in a block; it is halved along both axes where nothing is known.
  void add_answers(Answers& answers, std::size_t piece, const Nets& nets, const Block& block, bool is_positive)
  {
    m_budget.check();
    const std::optional<Nearest_feet::Feet> feet = feet_in(piece, nets, is_positive);
    if (!feet)
      return;
    const bool is_large = 4 * block.size > m_grid.size();
    const Answer answer = is_large ? Answer::UNKNOWN : m_feet(*feet);
    if (answer == Answer::UNKNOWN && block.size > 1) {
      const int half = block.size / 2;
      for (const int a : {0, 1})
        for (const int b : {0, 1})
          add_answers(answers, piece, quarter(nets, a, b), {{block.at[0] + a * half, block.at[1] + b * half}, half},
                      is_positive);
      return;
    }
    const std::optional<Answer> of_all =
        answer == Answer::UNKNOWN ? answer_of_quarters(piece, nets, is_positive, 0) : std::optional(answer);
    for (int i = block.at[0]; i < block.at[0] + block.size; ++i)
      for (int j = block.at[1]; j < block.at[1] + block.size; ++j)
        answers[index_of({i, j})] = of_all;
  }

  // Of a part of a cell, by its quarters; none out of reach.
  std::optional<Answer> answer_of_quarters(std::size_t piece, const Nets& nets, bool is_positive, int depth)
  {
    constexpr int most_halvings = 4;
    if (depth == most_halvings)
      return Answer::UNKNOWN;
    std::optional<Answer> result;
    for (const int a : {0, 1})
      for (const int b : {0, 1}) {
        m_budget.check();
        const Nets part = quarter(nets, a, b);
        const std::optional<Nearest_feet::Feet> feet = feet_in(piece, part, is_positive);
        if (!feet)
          continue;
        std::optional<Answer> answer = m_feet(*feet);
        if (answer == Answer::UNKNOWN)
          answer = answer_of_quarters(piece, part, is_positive, depth + 1);
        if (answer == Answer::UNKNOWN || (answer && result && *answer != *result))
          return Answer::UNKNOWN;
        if (answer)
          result = answer;
      }
    return result;
  }

  static Nets quarter(const Nets& nets, int a, int b)
  {
    const auto part = [&](const Interval_net& net) {
      return net.restricted(0, 0.5 * a, 0.5 * (a + 1)).restricted(1, 0.5 * b, 0.5 * (b + 1));
    };
    // within reach, its degree is not needed any more
    const bool is_within = nets.power.bounds().sup() < 0;
    Nets result{{}, {}, is_within ? Interval_net::constant(-1) : part(nets.power), part(nets.side)};
    for (const auto list : {&Nets::feet, &Nets::coordinates})
      for (const Interval_net& net : nets.*list)
        (result.*list).push_back(part(net));
    return result;
  }

  // Bounds of the feet of points of the bisector that are within reach on a side of the poles; none if there are none.
  // The distance of these points from the center of the sphere is |x + r|.
  std::optional<Nearest_feet::Feet> feet_in(std::size_t piece, const Nets& part, bool is_positive) const
  {
    const Interval side = part.side.bounds();
    if ((is_positive ? !(side.sup() > 0) : !(side.inf() < 0)) || part.power.bounds().inf() > 0)
      return std::nullopt;
    const std::vector<Interval_net>& nets = part.coordinates;
    const Interval weight = CGAL::abs(nets[3].bounds());
    const bool is_bounded = weight.inf() > 0;
    Nearest_feet::Feet result;
    result.centers = is_bounded ? Foot_grid::hull_of_quotients(nets)
                                : Foot_grid::Box{nets[0].bounds(), nets[1].bounds(), nets[2].bounds()};
    Interval square(0);
    for (const Interval& c : result.centers)
      square += CGAL::square(c);
    const Interval length = square_root(square);
    const double least = is_bounded ? length.inf() : (Interval(length.inf()) / Interval(weight.sup())).inf(),
                 greatest = is_bounded ? (std::min)(length.sup(), m_reach.sup()) : m_reach.sup();
    if (least > greatest)
      return std::nullopt;
    const Interval distance(least, greatest);
    result.x = (is_positive ? -distance : distance) - m_radius;
    for (std::size_t c = 0; c < 3; ++c)
      result.centers[c] = m_center[c] + (is_bounded ? result.centers[c] : Interval(-greatest, greatest));
    result.bounds = m_grid.bounds(piece, part.feet);
    return result;
  }
};

// If a face is undecided, the pieces are cut into blocks of the grid, and these are labelled.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Trimmed_surface_3>
trimmed_sphere_bisector(const Oriented_sphere& sphere, const Exact_map<3>& surface, const Rational_bisector_3& bisector,
                        const Reach& reach, const Solver_options& options)
{
  Operation_budget budget(options);
  const std::vector<Polynomial_piece> pieces = pieces_in_powers(surface);
  std::optional<Face_trimming> faces;
  bool is_cut = false, is_too_hard = false;
  const auto label = [&](const Parameters& parameters) -> std::optional<int> {
    if (!faces && is_too_hard)
      return std::nullopt;
    const Upward_rounding_guard guard;
    if (!faces)
      try {
        faces.emplace(bisector, pieces, Foot_pieces::of(pieces, budget), sphere, reach, budget);
      } catch (const Invalid_input&) { // polynomials of the curvatures would be too large
        is_too_hard = true;
        return std::nullopt;
      }
    const auto contains = [&](const Rational_bisector_piece_3& piece) {
      return piece.contains(0, parameters[0]) && piece.contains(1, parameters[1]);
    };
    const auto piece = std::ranges::find_if(bisector.pieces(), contains);
    return faces->label(static_cast<std::size_t>(piece - bisector.pieces().begin()),
                        {piece->local_parameter(0, parameters[0]), piece->local_parameter(1, parameters[1])}, is_cut);
  };
  const auto label_of_face = [&](const Surface_cell_3& cell, const Parameters& local, bool) {
    return label({cell.parameter(0, local[0]), cell.parameter(1, local[1])});
  };
  std::vector<Trimmed_surface_3> result = parts_of_bisector(bisector, reach, label_of_face, budget, is_never_cut);
  is_cut = faces && std::ranges::any_of(result, [](const Trimmed_surface_3& part) { return !part.is_complete(); });
  if (!is_cut || budget.must_stop())
    return result;
  try {
    const auto must_be_cut = [&](std::size_t piece, const std::array<int, 2>& at, int blocks) {
      return faces->must_be_cut(piece, at, blocks);
    };
    std::vector<Trimmed_surface_3> finer = parts_of_bisector(bisector, reach, label_of_face, budget, must_be_cut);
    return budget.must_stop() ? result : finer;
  } catch (const Run_stopped&) { // before there were cells
    return result;
  }
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TRIMMED_SPHERE_BISECTOR_H
