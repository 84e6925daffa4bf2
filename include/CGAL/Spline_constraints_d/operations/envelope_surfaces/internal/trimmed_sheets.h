// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_SHEETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_SHEETS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Nearest_on_curve.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Sheet_labels.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Touching_curve.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Touching_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/union_of_boxes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// A surface with what tells whether feet on it are nearest.
class Surface_with_feet
{
  std::vector<Polynomial_piece> m_pieces;
  std::vector<Ball_nets> m_nets;
  Foot_pieces m_feet;
  Foot_grid m_grid;
  Nearest_feet m_nearest;

public:
  static constexpr std::size_t parameters = 2;

  //! \pre rounding is upwards, here and below.
  Surface_with_feet(const Exact_map<3>& surface, const Operation_budget& budget)
    : m_pieces(pieces_in_powers(surface)), m_feet(Foot_pieces::of(m_pieces, budget)),
      m_grid(m_feet.pieces, m_feet.shape, m_pieces.size() < 8 ? 32 : 16), m_nearest(m_grid, m_pieces, budget)
  {
    for (const Polynomial_piece& piece : m_pieces)
      m_nets.emplace_back(piece.coordinates);
  }
  Surface_with_feet(const Surface_with_feet&) = delete;
  Surface_with_feet& operator=(const Surface_with_feet&) = delete;

  const std::vector<Polynomial_piece>& pieces() const { return m_pieces; }
  const Ball_nets& nets(std::size_t piece) const { return m_nets[piece]; }
  Nearest_feet& nearest() { return m_nearest; }
};

// The piece that ranges of parameters are in, from `first` on; or none.
inline std::optional<std::size_t> piece_with(const std::vector<Polynomial_piece>& pieces,
                                             const Curve_vertex::Exact_box& box, std::size_t first)
{
  const auto contains = [&](const Polynomial_piece& piece) {
    for (std::size_t i = 0; i < piece.domain.size(); ++i)
      if (box[first + i].first < piece.domain[i].first || piece.domain[i].second < box[first + i].second)
        return false;
    return true;
  };
  const auto found = std::ranges::find_if(pieces, contains);
  return found == pieces.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - pieces.begin()));
}

/*
The parts of a bisector or sector with labels, patch by patch. `Scene` makes the pair of pieces for a part, and has both
operands.
*/
template <class Scene>
class Labelled_sheets
{
  using Pair = typename Scene::Pair;
  using Labels = Sheet_labels<Pair, typename Scene::First, typename Scene::Second>;
  using Interval = CGAL::Interval_nt<false>;
  static constexpr std::size_t parameters = Pair::unknowns - 1;

  struct Block
  {
    std::size_t part;
    std::array<Bisector_range, parameters> domain; // of the pieces
    Labels labels;
  };

  std::shared_ptr<Scene> m_scene;
  std::vector<Block> m_blocks;
  std::vector<Trimmed_cell_3> m_cells;
  std::vector<Undecided_part> m_undecided;

public:
  //! \pre rounding is upwards.
  Labelled_sheets(std::shared_ptr<Scene> scene, const Envelope_surface_3& sheets, Operation_budget& budget)
    : m_scene(std::move(scene))
  {
    for (std::size_t i = 0; i < sheets.parts().size(); ++i) {
      std::set<Curve_vertex::Exact_box> boxes; // several patches may be in one
      for (const Surface_patch& patch : sheets.parts()[i].solutions.patches())
        if (boxes.insert(patch.box).second)
          add(i, sheets.parts()[i], patch, budget);
    }
    join_undecided(budget);
  }

  const std::vector<Trimmed_cell_3>& cells() const { return m_cells; }
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  Nearest_feet_label label(std::size_t part, std::span<const double> unknowns) const
  {
    const Upward_rounding_guard guard;
    for (const Block& block : m_blocks) {
      if (block.part != part)
        continue;
      std::array<double, parameters> at;
      for (std::size_t j = 0; j < parameters; ++j) {
        const double begin = CGAL::to_double(block.domain[j].first), end = CGAL::to_double(block.domain[j].second);
        at[j] = (unknowns[j] - begin) / (end - begin);
      }
      const std::optional<Nearest_feet_label> own = block.labels.label(at);
      if (own && *own != Nearest_feet_label::UNDECIDED)
        return *own;
    }
    return Nearest_feet_label::UNDECIDED;
  }

private:
  void add(std::size_t index, const Envelope_part_3& part, const Surface_patch& patch, Operation_budget& budget)
  {
    const auto pieces = m_scene->pieces(patch.box);
    if (!pieces) {
      add_cell(index, double_ranges(std::span(patch.box).first(parameters)), Nearest_feet_label::UNDECIDED);
      return;
    }
    const auto domain = m_scene->domain(*pieces);
    typename Pair::Box box;
    for (std::size_t j = 0; j < parameters; ++j) {
      const auto local = [&](const Exact_rational& x) {
        return Exact_rational((x - domain[j].first) / (domain[j].second - domain[j].first));
      };
      box[j] = Interval(to_double_interval(local(patch.box[j].first)).first,
                        to_double_interval(local(patch.box[j].second)).second);
    }
    const Pair pair = m_scene->pair(part, *pieces);
    const auto feet = pair.feet(box);
    const std::optional<Interval> steps = feet ? pair.steps(*feet) : std::nullopt;
    box.back() = steps ? *steps : m_scene->steps();
    m_blocks.push_back({index, domain, Labels(pair, m_scene->first(), m_scene->second(), box)});
    Labels& labels = m_blocks.back().labels;
    labels.run(budget);
    for (const auto& leaf : labels.leaves()) {
      std::vector<Undecided_part::Range> ranges;
      for (std::size_t j = 0; j < parameters; ++j) {
        const auto global = [&](double x) {
          return Exact_rational(domain[j].first + Exact_rational(x) * (domain[j].second - domain[j].first));
        };
        ranges.push_back(double_range(std::pair(global(leaf.cell.box()[j].inf()), global(leaf.cell.box()[j].sup()))));
      }
      add_cell(index, std::move(ranges), leaf.label);
    }
    if (labels.leaves().empty()) // though the patch has points
      add_cell(index, double_ranges(std::span(patch.box).first(parameters)), Nearest_feet_label::UNDECIDED);
  }

  void add_cell(std::size_t part, std::vector<Undecided_part::Range> box, Nearest_feet_label label)
  {
    m_cells.push_back({part, std::move(box), label});
  }

  // Those cells that touch each other are one part.
  void join_undecided(const Operation_budget& budget)
  {
    const std::string reason =
        budget.reason() == Undecided_reason::NONE ? "whether feet are nearest" : in_words(budget.reason());
    std::map<std::size_t, std::vector<Exact_ranges>> boxes;
    for (const Trimmed_cell_3& cell : m_cells)
      if (cell.label == Nearest_feet_label::UNDECIDED) {
        Exact_ranges& box = boxes[cell.part].emplace_back();
        for (const auto& [begin, end] : cell.box)
          box.emplace_back(Exact_rational(begin), Exact_rational(end));
      }
    for (const auto& [part, own] : boxes) {
      const std::vector<std::size_t> roots = roots_of_touching(own);
      std::map<std::size_t, Exact_ranges> hulls;
      for (std::size_t k = 0; k < own.size(); ++k) {
        Exact_ranges& hull = hulls.try_emplace(roots[k], own[k]).first->second;
        for (std::size_t j = 0; j < hull.size(); ++j)
          hull[j] = {(std::min)(hull[j].first, own[k][j].first), (std::max)(hull[j].second, own[k][j].second)};
      }
      for (const auto& [root, hull] : hulls)
        m_undecided.push_back({double_ranges(hull), {}, reason});
    }
  }
};

// Two surfaces, and the points at distances from them with a ratio.
class Scene_of_surfaces
{
  Surface_with_feet m_first, m_second;
  CGAL::Interval_nt<false> m_ratio, m_radius;

public:
  using Pair = Touching_surfaces;
  using First = Nearest_feet;
  using Second = Nearest_feet;
  using Pieces = std::array<std::size_t, 2>;

  Scene_of_surfaces(const Exact_map<3>& first, const Exact_map<3>& second, const Exact_rational& ratio,
                    const std::optional<Exact_rational>& radius, const Operation_budget& budget)
    : m_first(first, budget), m_second(second, budget), m_ratio(to_double_interval(ratio)),
      m_radius(to_double_interval(radius ? *radius : Exact_rational(0)))
  {}

  Nearest_feet& first() { return m_first.nearest(); }
  Nearest_feet& second() { return m_second.nearest(); }

  std::optional<Pieces> pieces(const Curve_vertex::Exact_box& box) const
  {
    const auto first = piece_with(m_first.pieces(), box, 0), second = piece_with(m_second.pieces(), box, 2);
    return first && second ? std::optional(Pieces{*first, *second}) : std::nullopt;
  }

  std::array<Bisector_range, 4> domain(const Pieces& pieces) const
  {
    const auto &a = m_first.pieces()[pieces[0]].domain, &b = m_second.pieces()[pieces[1]].domain;
    return {a[0], a[1], b[0], b[1]};
  }

  Pair pair(const Envelope_part_3& part, const Pieces& pieces) const
  {
    return {m_first.nets(pieces[0]), m_second.nets(pieces[1]), pieces,
            CGAL::Interval_nt<false>(part.product_of_sides) * m_ratio, m_radius};
  }

  // Of the distances, if nothing else is known.
  CGAL::Interval_nt<false> steps() const
  {
    const double greatest = m_radius.sup() > 0 ? m_radius.sup() : 0x1p500;
    return {-greatest, greatest};
  }
};

// A surface and a curve, and the points at the same distance from both.
class Scene_of_curve
{
  Surface_with_feet m_surface;
  std::vector<Polynomial_piece> m_curve;
  Nearest_on_curve m_nearest;
  CGAL::Interval_nt<false> m_radius;

public:
  using Pair = Touching_curve;
  using First = Nearest_feet;
  using Second = Nearest_on_curve;
  using Pieces = std::array<std::size_t, 2>;

  Scene_of_curve(const Exact_map<3>& curve, const Exact_map<3>& surface, const Exact_rational& radius,
                 const Operation_budget& budget)
    : m_surface(surface, budget), m_curve(pieces_in_powers(curve)), m_nearest(m_curve),
      m_radius(to_double_interval(radius))
  {}

  Nearest_feet& first() { return m_surface.nearest(); }
  Nearest_on_curve& second() { return m_nearest; }

  std::optional<Pieces> pieces(const Curve_vertex::Exact_box& box) const
  {
    const auto first = piece_with(m_surface.pieces(), box, 0), second = piece_with(m_curve, box, 2);
    return first && second ? std::optional(Pieces{*first, *second}) : std::nullopt;
  }

  std::array<Bisector_range, 3> domain(const Pieces& pieces) const
  {
    const auto& surface = m_surface.pieces()[pieces[0]].domain;
    return {surface[0], surface[1], m_curve[pieces[1]].domain[0]};
  }

  Pair pair(const Envelope_part_3&, const Pieces& pieces) const
  {
    return {m_surface.nets(pieces[0]), m_nearest.nets(pieces[1]), pieces, m_radius};
  }

  // Of the distances, if nothing else is known.
  CGAL::Interval_nt<false> steps() const { return {-m_radius.sup(), m_radius.sup()}; }
};

template <class Scene, class... Arguments>
Trimmed_envelope_surface_3 trimmed_sheets(Envelope_surface_3 sheets, const Solver_options& options,
                                          const Arguments&... arguments)
{
  Operation_budget budget(rest_of(options, sheets.summary()));
  Summary work = sheets.summary();
  std::shared_ptr<Labelled_sheets<Scene>> labels;
  std::string reason;
  try {
    const Upward_rounding_guard guard;
    auto scene = std::make_shared<Scene>(arguments..., budget);
    labels = std::make_shared<Labelled_sheets<Scene>>(std::move(scene), sheets, budget);
  } catch (const Invalid_input&) {
    reason = "polynomials of curvatures are too large";
  } catch (const Run_stopped& stop) {
    reason = in_words(stop.reason);
  }
  work += budget.total();
  work.seconds = sheets.summary().seconds + budget.seconds();
  std::vector<Trimmed_cell_3> cells;
  std::vector<Undecided_part> undecided;
  if (labels) {
    cells = labels->cells();
    undecided = labels->undecided();
  } else
    for (std::size_t i = 0; i < sheets.parts().size(); ++i)
      if (const auto& solutions = sheets.parts()[i].solutions; !solutions.patches().empty())
        undecided.push_back({double_ranges(domain_of(solutions.system())), {}, reason});
  work.is_complete = work.is_complete && undecided.empty();
  const auto label = [labels](std::size_t part, std::span<const double> unknowns) {
    return labels ? labels->label(part, unknowns) : Nearest_feet_label::UNDECIDED;
  };
  return {std::move(sheets), std::move(cells), undecided, work, label};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_envelope_surface_3 trimmed_surface_bisector_of(const Exact_map<3>& first,
                                                                                      const Exact_map<3>& second,
                                                                                      const Exact_rational& radius,
                                                                                      const Touched_sides& sides,
                                                                                      const Solver_options& options)
{
  return trimmed_sheets<Scene_of_surfaces>(surface_bisector_of(first, second, radius, sides, options), options, first,
                                           second, Exact_rational(1), std::optional(radius));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_envelope_surface_3 trimmed_curve_surface_bisector_of(
    const Exact_map<3>& curve, const Exact_map<3>& surface, const Exact_rational& radius, const Solver_options& options)
{
  return trimmed_sheets<Scene_of_curve>(curve_surface_bisector_of(curve, surface, radius, options), options, curve,
                                        surface, radius);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_envelope_surface_3 trimmed_alpha_sector_surface_of(const Exact_map<3>& first,
                                                                                          const Exact_map<3>& second,
                                                                                          const Exact_rational& alpha,
                                                                                          const Touched_sides& sides,
                                                                                          const Solver_options& options)
{
  return trimmed_sheets<Scene_of_surfaces>(alpha_sector_surface_of(first, second, alpha, sides, options), options,
                                           first, second, Exact_rational((1 - alpha) / alpha),
                                           std::optional<Exact_rational>());
}

} // namespace Envelope_surfaces
} // namespace internal

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Trimmed_envelope_surface_3& surface)
{
  return out << "cells: " << surface.number_of_cells(Nearest_feet_label::NEAREST) << " kept, "
             << surface.number_of_cells(Nearest_feet_label::NOT_NEAREST) << " removed, "
             << surface.number_of_cells(Nearest_feet_label::BOTH) << " divided, "
             << surface.number_of_cells(Nearest_feet_label::UNDECIDED) << " undecided, in "
             << surface.undecided().size() << " places; complete: " << (surface.is_complete() ? "yes" : "no")
             << "; nodes " << surface.summary().nodes << "; seconds " << surface.summary().seconds;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_SHEETS_H
