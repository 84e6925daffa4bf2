// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_SPLINE_H

#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Bezier_rows.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Rounded_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

template <class NT>
double nearest_double(const NT& x)
{
  return converted_number<double>(x);
}

template <class NT>
Scratch_vector<double> nearest_doubles(const std::vector<NT>& numbers)
{
  Scratch_vector<double> result(numbers.size());
  std::transform(numbers.begin(), numbers.end(), result.begin(), nearest_double<NT>);
  return result;
}

template <class NT>
bool is_double(const NT& x, double rounded)
{
  if constexpr (std::is_same_v<NT, double>)
    return true;
  else
    return std::isfinite(rounded) && x == to_rational(rounded);
}

enum class Closedness
{
  OPEN,
  CLOSED,
  UNKNOWN
};

template <int d>
struct Double_box
{
  std::array<double, d> lower, upper;
};

/*
A curve or surface in doubles: its Bezier pieces with bounds of their errors, prepared for distances, and a pyramid of
boxes around them: a binary tree, in which each box holds those below it.
*/
template <int d>
class Rounded_spline
{
public:
  // A box around the pieces of a range of cells along each axis.
  struct Node
  {
    Double_box<d> box;
    int child; // the first of two nodes, or -1: a single cell
    std::array<int, 2> cell, end;
  };

private:
  int m_axes;
  std::array<std::pmr::vector<double>, 2> m_breaks;
  std::array<Closedness, 2> m_closedness{Closedness::OPEN, Closedness::OPEN};
  bool m_is_usable = true;
  bool m_is_rational = false;
  std::pmr::vector<double> m_nets;
  mutable std::pmr::vector<Rounded_piece<d>> m_pieces;        // along the second axis first
  mutable std::pmr::vector<std::pmr::vector<double>> m_forms; // of pieces; none: nobody has asked for it
  std::pmr::vector<Node> m_nodes;

public:
  // In memory that outlives it. Rounding has to be upward.
  template <class NT>
  explicit Rounded_spline(const Homogeneous_spline<NT, d>& spline,
                          std::pmr::memory_resource* memory = std::pmr::get_default_resource())
    : m_axes(spline.dimension()), m_breaks{std::pmr::vector<double>({0, 1}, memory),
                                           std::pmr::vector<double>({0, 1}, memory)},
      m_nets(memory), m_pieces(memory), m_forms(memory), m_nodes(memory)
  {
    make_pieces(spline);
    if (m_is_usable)
      make_pyramid();
  }
  Rounded_spline(const Rounded_spline&) = delete;
  Rounded_spline& operator=(const Rounded_spline&) = delete;

  // Whether doubles are good enough: degrees are not too high, knots are doubles, and weights of pieces are positive.
  bool is_usable() const { return m_is_usable; }

  int number_of_axes() const { return m_axes; }
  int number_of_cells(int axis) const { return static_cast<int>(m_breaks[axis].size()) - 1; }
  const std::pmr::vector<double>& breaks(int axis) const { return m_breaks[axis]; }

  // Whether both ends of an axis are the same points.
  Closedness closedness(int axis) const { return m_closedness[axis]; }

  // Its forms are made when it is asked for; after `prepare()`, several threads may ask.
  const Rounded_piece<d>& piece(const std::array<int, 2>& cell) const
  {
    const std::size_t index = index_of(cell);
    if (m_forms[index].empty())
      make_forms(index);
    return m_pieces[index];
  }

  void prepare()
  {
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
      make_forms(k);
  }

  // The first one is around everything.
  const Node& node(int index) const { return m_nodes[static_cast<std::size_t>(index)]; }

private:
  std::size_t index_of(const std::array<int, 2>& cell) const
  {
    return static_cast<std::size_t>(cell[0] * number_of_cells(1) + cell[1]);
  }

  template <class NT>
  void make_pieces(const Homogeneous_spline<NT, d>& spline)
  {
    const auto& functions = spline.functions();
    Degrees degrees{functions[0].degree(0), m_axes == 2 ? functions[0].degree(1) : 0};
    if (2 * (std::max)(degrees[0], degrees[1]) > greatest_product_degree) {
      m_is_usable = false;
      return;
    }
    Scratch_vector<Bezier_rows> rows;
    rows.reserve(2);
    for (int axis = 0; axis < m_axes; ++axis) {
      const std::vector<NT>& knots = functions[0].knots(axis);
      rows.emplace_back(degrees[axis], nearest_doubles(knots));
      m_is_usable = m_is_usable && std::equal(knots.begin(), knots.end(), rows[axis].knots().begin(), is_double<NT>);
      m_breaks[axis].assign(1, rows[axis].knots()[rows[axis].spans().front()]);
      for (const std::size_t span : rows[axis].spans())
        m_breaks[axis].push_back(rows[axis].knots()[span + 1]);
    }
    if (!m_is_usable)
      return;
    const std::size_t cells = static_cast<std::size_t>(number_of_cells(0) * number_of_cells(1)),
                      size = size_of(degrees);
    m_nets.resize(functions.size() * cells * size);
    m_pieces.resize(cells);
    m_is_rational = spline.is_rational();
    m_forms.resize(cells);
    for (std::size_t f = 0; f < functions.size(); ++f)
      add_function(functions[f], rows, degrees, f);
    for (std::size_t k = 0; k < cells; ++k) {
      m_pieces[k].degrees = degrees;
      m_pieces[k].axes = m_axes;
    }
    for (int axis = 0; axis < m_axes; ++axis)
      m_closedness[axis] = closedness(functions, axis);
  }

  void make_forms(std::size_t index) const
  {
    Piece_forms<d> forms(m_pieces[index].degrees, m_is_rational);
    m_forms[index].assign(forms.size(), 0.0);
    forms.make(m_pieces[index], m_forms[index].data());
  }

  // Copies a numerator or the weight into the pieces.
  template <class NT>
  void add_function(const Bspline_function<NT>& f, const Scratch_vector<Bezier_rows>& rows, const Degrees& degrees,
                    std::size_t index)
  {
    Scratch_vector<double> coefficients = nearest_doubles(f.coefficients());
    const double greatest = greatest_magnitude(coefficients.data(), coefficients.size());
    const bool is_rounded =
        !std::equal(f.coefficients().begin(), f.coefficients().end(), coefficients.begin(), is_double<NT>);
    double error = is_rounded ? unit * greatest + (std::numeric_limits<double>::min)() : 0;
    const std::size_t other = m_axes == 2 ? f.size(1) : 1;
    coefficients = rows[0](std::move(coefficients), error, other, 1, other);
    const std::size_t height = static_cast<std::size_t>((degrees[0] + 1) * number_of_cells(0));
    if (m_axes == 2)
      coefficients = rows[1](std::move(coefficients), error, height, other, 1);
    const std::size_t size = size_of(degrees), order = static_cast<std::size_t>(degrees[1] + 1),
                      width = order * static_cast<std::size_t>(number_of_cells(1));
    for (std::size_t k = 0; k < m_pieces.size(); ++k) {
      const std::size_t row = k / static_cast<std::size_t>(number_of_cells(1)),
                        column = k % static_cast<std::size_t>(number_of_cells(1));
      double* begin = m_nets.data() + (k * (m_nets.size() / m_pieces.size() / size) + index) * size;
      for (std::size_t i = 0; i <= static_cast<std::size_t>(degrees[0]); ++i)
        std::copy_n(coefficients.data() + (row * static_cast<std::size_t>(degrees[0] + 1) + i) * width + column * order,
                    order, begin + i * order);
      const Rounded_tensor tensor{begin, error, greatest_magnitude(begin, size)};
      (index < d ? m_pieces[k].points[index] : m_pieces[k].weights) = tensor;
      m_is_usable = m_is_usable && std::isfinite(tensor.greatest);
      if (index == d)
        m_is_usable = m_is_usable && *std::min_element(begin, begin + size) > 2 * error;
    }
  }

  // Where the knots at both ends are clamped, the control points there tell whether these are the same points.
  template <class NT>
  static Closedness closedness(const std::vector<Bspline_function<NT>>& functions, int axis)
  {
    const std::vector<NT>& knots = functions[0].knots(axis);
    const auto n = static_cast<std::size_t>(functions[0].degree(axis));
    if (knots[0] != knots[n] || knots.back() != knots[knots.size() - 1 - n])
      return Closedness::UNKNOWN;
    const bool is_surface = functions[0].dimension() == 2;
    const std::size_t size = functions[0].size(axis), others = is_surface ? functions[0].size(1 - axis) : 1,
                      step = is_surface && axis == 0 ? others : 1, skip = axis == 0 ? 1 : size;
    for (const Bspline_function<NT>& f : functions)
      for (std::size_t k = 0; k < others; ++k)
        if (f.coefficients()[k * skip] != f.coefficients()[k * skip + (size - 1) * step])
          return Closedness::OPEN;
    return Closedness::CLOSED;
  }

  void make_pyramid()
  {
    m_nodes.reserve(2 * m_pieces.size());
    m_nodes.push_back({{}, -1, {0, 0}, {number_of_cells(0), number_of_cells(1)}});
    for (std::size_t k = 0; k < m_nodes.size(); ++k) { // the vector grows
      const Node node = m_nodes[k];
      const std::array<int, 2> extent{node.end[0] - node.cell[0], node.end[1] - node.cell[1]};
      if (extent[0] == 1 && extent[1] == 1)
        continue;
      const int axis = extent[0] >= extent[1] ? 0 : 1, middle = (node.cell[axis] + node.end[axis]) / 2;
      m_nodes[k].child = static_cast<int>(m_nodes.size());
      m_nodes.push_back(node);
      m_nodes.back().end[axis] = middle;
      m_nodes.push_back(node);
      m_nodes.back().cell[axis] = middle;
    }
    for (std::size_t k = m_nodes.size(); k-- > 0;)
      m_nodes[k].box = m_nodes[k].child < 0 ? box_of(m_pieces[index_of(m_nodes[k].cell)])
                                            : hull_of(m_nodes[static_cast<std::size_t>(m_nodes[k].child)].box,
                                                      m_nodes[static_cast<std::size_t>(m_nodes[k].child) + 1].box);
  }

  static Double_box<d> box_of(const Rounded_piece<d>& piece)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Double_box<d> result;
    result.lower.fill(infinity);
    result.upper.fill(-infinity);
    for (int i = 0; i < d; ++i)
      for (std::size_t k = 0; k < size_of(piece.degrees); ++k) {
        double x = piece.points[i].begin[k], error = piece.points[i].error;
        if (piece.is_rational()) {
          const double w = piece.weights.begin[k];
          x /= w;
          error = 2 * (error + std::abs(x) * piece.weights.error) / w + 2 * unit * std::abs(x);
        }
        error += 2 * unit * (std::abs(x) + error); // of the sums
        result.lower[i] = (std::min)(result.lower[i], x - error);
        result.upper[i] = (std::max)(result.upper[i], x + error);
      }
    return result;
  }

  static Double_box<d> hull_of(const Double_box<d>& a, const Double_box<d>& b)
  {
    Double_box<d> result;
    for (int i = 0; i < d; ++i) {
      result.lower[i] = (std::min)(a.lower[i], b.lower[i]);
      result.upper[i] = (std::max)(a.upper[i], b.upper[i]);
    }
    return result;
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_SPLINE_H
