// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACES_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_subdivision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A face of the domain, or a plane of breaks in it, on which an equality is zero everywhere.
struct Vanishing_face
{
  std::size_t equality;
  int axis;
  Exact_rational value;
};

// What is known of the curves of a system.
struct Found_curves
{
  Curve_vertices vertices;
  std::vector<Curve_piece> pieces = {};
  std::vector<Undecided_box> undecided = {};
  Vertex_indices points = {};   // that no piece ends in
  Summary summary = {};

  // Whether each vertex is one of a curve, or a solution by itself.
  std::vector<bool> solutions() const
  {
    std::vector<bool> result(vertices.size(), false);
    for (const Curve_piece& piece : pieces)
      for (const std::size_t i : piece.ends)
        result[i] = true;
    for (const std::size_t i : points)
      result[i] = true;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result[i] = result[i] || vertices[i].is_singular_point();
    return result;
  }

  // Calls change(index) for all references to vertices.
  template <class Change>
  void for_each_index(const Change& change)
  {
    for (Curve_piece& piece : pieces)
      std::for_each(piece.ends.begin(), piece.ends.end(), change);
    for (Undecided_box& box : undecided)
      std::for_each(box.vertices.begin(), box.vertices.end(), change);
    std::for_each(points.begin(), points.end(), change);
  }

  // Adds others. Returns the indices of their vertices here.
  Vertex_indices merge(Found_curves&& others)
  {
    const Vertex_indices place = vertices.merge(std::move(others.vertices), {});
    others.for_each_index([&](std::size_t& i) { i = place[i]; });
    pieces.insert(pieces.end(), others.pieces.begin(), others.pieces.end());
    undecided.insert(undecided.end(), others.undecided.begin(), others.undecided.end());
    points.insert(points.end(), others.points.begin(), others.points.end());
    summary += others.summary;
    return place;
  }
};

/*
A spline and the factor x - c, zero at an end c of the range of an unknown, or at a break in it. Where it is zero there,
all of its terms are, as a rule: those with other unknowns.
*/
class Face_factor
{
  const Spline_function& m_function;
  const int m_unknown;
  const Exact_rational m_value;
  const bool m_has_below, m_has_above;           // whether the domain goes on
  // of the cells at the face, on one side or both, the places among those of the unknown
  std::pair<std::size_t, std::size_t> m_layers;

public:
  Face_factor(const Spline_function& function, int unknown, const std::pair<Exact_rational, Exact_rational>& range,
              const Exact_rational& value)
    : m_function(function), m_unknown(unknown), m_value(value), m_has_below(range.first < value),
      m_has_above(value < range.second), m_layers(0, 0)
  {
    if (!function.terms().empty() && axis_of(function.terms().front()))
      m_layers = layers();
  }

  // Whether all terms are zero on the face, and have the same breaks of the unknown.
  bool divides() const
  {
    for (const Spline_term& term : m_function.terms()) {
      const std::optional<std::size_t> axis = axis_of(term);
      if (!axis || term.breaks[*axis] != breaks() || !vanishes(term, *axis))
        return false;
    }
    return !m_function.terms().empty();
  }

  // Divided by x - c in the cells at the face and, so that it stays continuous, by constants in the others. \pre
  // `divides()`
  Spline_function quotient() const
  {
    Spline_function result;
    for (Spline_term term : m_function.terms()) {
      const std::size_t axis = *axis_of(term);
      for (std::size_t c = 0; c < term.pieces.size(); ++c)
        if (is_at_face(term, axis, c))
          divide(term, axis, c);
        else
          for (Exact_rational& coefficient : term.pieces[c])
            coefficient /= distance(layer_of(term, axis, c));
      result += Spline_function(std::move(term));
    }
    return result;
  }

  // Divides a function by the factor as often as it can be. Returns how often this is.
  static int divide_out(Spline_function& function, int unknown, const std::pair<Exact_rational, Exact_rational>& range,
                        const Exact_rational& value)
  {
    int exponent = 0;
    for (; Face_factor(function, unknown, range, value).divides(); ++exponent)
      function = Face_factor(function, unknown, range, value).quotient();
    return exponent;
  }

private:
  std::optional<std::size_t> axis_of(const Spline_term& term) const
  {
    const auto place = std::find(term.variables.begin(), term.variables.end(), m_unknown);
    return place == term.variables.end() ? std::nullopt
                                         : std::optional(static_cast<std::size_t>(place - term.variables.begin()));
  }

  const std::vector<Exact_rational>& breaks() const
  {
    return m_function.terms().front().breaks[*axis_of(m_function.terms().front())];
  }

  std::pair<std::size_t, std::size_t> layers() const
  {
    if (breaks().empty())
      return {0, 0};
    const auto place = [&](const auto& next) { return static_cast<std::size_t>(next - breaks().begin()) - 1; };
    const std::size_t above = place(std::upper_bound(breaks().begin() + 1, breaks().end() - 1, m_value)),
                      below = place(std::lower_bound(breaks().begin() + 1, breaks().end() - 1, m_value));
    return {m_has_below ? below : above, m_has_above ? above : below};
  }

  // From the face to the next break, with the sign of that side of it.
  Exact_rational distance(std::size_t layer) const
  {
    const auto [first, last] = m_layers;
    const bool is_above = m_has_below && m_has_above ? last < layer : m_has_above;
    return Exact_rational(breaks()[is_above ? last + 1 : first] - m_value);
  }

  static std::size_t layer_of(const Spline_term& term, std::size_t axis, std::size_t cell)
  {
    std::size_t inner = 1;
    for (std::size_t j = axis + 1; j < term.variables.size(); ++j)
      inner *= term.cells(j);
    return cell / inner % term.cells(axis);
  }

  bool is_at_face(const Spline_term& term, std::size_t axis, std::size_t cell) const
  {
    const auto [first, last] = m_layers;
    const std::size_t layer = layer_of(term, axis, cell);
    return first <= layer && layer <= last;
  }

  bool vanishes(const Spline_term& term, std::size_t axis) const
  {
    for (std::size_t c = 0; c < term.pieces.size(); ++c) {
      if (!is_at_face(term, axis, c))
        continue;
      bool is_zero = true;
      std::vector<Exact_rational> piece = term.pieces[c];
      visit_rows(piece, term.degrees, axis, [&](const Exact_rational* a, std::size_t step) {
        Exact_rational sum(0);
        for (int k = term.degrees[axis]; is_zero && k >= 0; --k)
          sum = Exact_rational(sum * m_value + a[static_cast<std::size_t>(k) * step]);
        is_zero = is_zero && CGAL::is_zero(sum);
      });
      if (!is_zero)
        return false;
    }
    return true;
  }

  void divide(Spline_term& term, std::size_t axis, std::size_t cell) const
  {
    visit_rows(term.pieces[cell], term.degrees, axis, [&](Exact_rational* a, std::size_t step) {
      Exact_rational quotient(0);
      for (int k = term.degrees[axis]; k >= 0; --k) {
        const Exact_rational coefficient = std::exchange(a[static_cast<std::size_t>(k) * step], quotient);
        quotient = Exact_rational(coefficient + m_value * quotient);
      }
    });
  }
};

// The faces of the domain and the planes of breaks for an unknown.
inline std::vector<Exact_rational> places_of_faces(const Constraint_system_d& system, int unknown)
{
  const auto& [lower, upper] = system.domain(unknown);
  std::vector<Exact_rational> result{lower, upper};
  for (const Spline_function& function : system.equalities())
    for (const Spline_term& term : function.terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        if (term.variables[j] == unknown)
          result.insert(result.end(), term.breaks[j].begin(), term.breaks[j].end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return {std::lower_bound(result.begin(), result.end(), lower), std::upper_bound(result.begin(), result.end(), upper)};
}

inline std::optional<Vanishing_face> vanishing_face(const Constraint_system_d& system)
{
  for (int axis = 0; axis < system.dimension(); ++axis)
    for (const Exact_rational& place : places_of_faces(system, axis))
      for (std::size_t i = 0; i < system.equalities().size(); ++i)
        if (Face_factor(system.equalities()[i], axis, system.domain(axis), place).divides())
          return Vanishing_face{i, axis, place};
  return std::nullopt;
}

// The system with an equality that is divided by the factor of the face, as often as it can be, and how often this is.
inline std::pair<Constraint_system_d, int> without_face(const Constraint_system_d& system, const Vanishing_face& face)
{
  Constraint_system_d result(domain_of(system));
  int exponent = 0;
  for (std::size_t i = 0; i < system.equalities().size(); ++i) {
    Spline_function function = system.equalities()[i];
    if (i == face.equality)
      exponent = Face_factor::divide_out(function, face.axis, system.domain(face.axis), face.value);
    result.add(std::move(function), Relation::EQUAL);
  }
  for (const auto& [function, relation] : system.inequalities())
    result.add(function, relation);
  return {std::move(result), exponent};
}

/*
The system on a face, whose curves lie within the domain: with the unknown that is constant there as an unknown whose
range is wider, and with its equation in the place of the equality that is zero. Nothing if an inequality excludes the
face.
*/
inline std::optional<Constraint_system_d> system_on_face(const Constraint_system_d& system, const Vanishing_face& face)
{
  Exact_ranges slab = domain_of(system);
  const Exact_rational width = slab[face.axis].second - slab[face.axis].first;
  slab[face.axis] = {Exact_rational(face.value - width), Exact_rational(face.value + width)};
  const auto on_face = [&](const Spline_function& function) {
    const Spline_function restricted = with_fixed(function, face.axis, face.value);
    Spline_function result;
    for (Spline_term term : restricted.terms()) {
      for (int& v : term.variables)
        v += v >= face.axis;
      result += Spline_function(std::move(term));
    }
    return result;
  };
  Constraint_system_d result(slab);
  result.add(Power_polynomial::variable(face.axis) - Power_polynomial(face.value), Relation::EQUAL);
  for (std::size_t i = 0; i < system.equalities().size(); ++i)
    if (i != face.equality)
      result.add(on_face(system.equalities()[i]), Relation::EQUAL);
  for (const auto& [function, relation] : system.inequalities()) {
    Spline_function restricted = on_face(function);
    const bool is_zero = is_zero_everywhere(restricted);
    if (is_zero && is_strict(relation))
      return std::nullopt;
    if (is_zero)
      result.add(Power_polynomial(Exact_rational(1)), Relation::GREATER);   // inequalities keep their numbers
    else
      result.add(std::move(restricted), relation);
  }
  return result;
}

// Makes points that are known to be solutions ends of the curves that pass through them.
class Curve_divisions
{
protected:
  Found_curves& m_all;
  std::size_t m_first;         // of the pieces
  Vertex_indices m_vertices;   // that a point may be

public:
  Curve_divisions(Found_curves& all, std::size_t first, Vertex_indices vertices)
    : m_all(all), m_first(first), m_vertices(std::move(vertices))
  {}

  // Whether the vertex, a solution, is a point of the curves; it is singular then.
  bool add(std::size_t i) { return joins_vertex(i) || splits_piece(i); }

private:
  void make_singular(std::size_t i)
  {
    m_all.vertices.make_singular(i);
    std::erase(m_all.points, i);
  }

  // The point is a vertex.
  bool joins_vertex(std::size_t i)
  {
    const auto same = std::find_if(m_vertices.begin(), m_vertices.end(),
                                   [&](std::size_t k) { return is_same(m_all.vertices[i], m_all.vertices[k]); });
    if (same == m_vertices.end())
      return false;
    m_all.vertices.identify(i, *same);
    m_all.for_each_index([&](std::size_t& k) { k = k == *same ? i : k; });
    make_singular(i);
    return true;
  }

  // Both are solutions. A regular vertex is the only one in its region on its plane, or where its inequality is zero.
  static bool is_same(const Plane_point& point, const Plane_point& vertex)
  {
    const auto is_number = [](const auto& range) { return range.first == range.second; };
    if (point.box == vertex.box && std::all_of(point.box.begin(), point.box.end(), is_number))
      return true;
    if (vertex.kind != Plane_point::REGULAR || !is_within(point.box, vertex.region))
      return false;
    if (const std::optional<std::size_t> plane = vertex.first_plane())
      return point.is_fixed[*plane] && point.box[*plane] == vertex.box[*plane];
    return vertex.inequality && point.inequality == vertex.inequality;
  }

  // The point lies in a piece, which becomes two.
  bool splits_piece(std::size_t i)
  {
    const Exact_ranges& point = m_all.vertices[i].box;
    for (std::size_t p = m_first; p < m_all.pieces.size(); ++p) {
      Curve_piece& piece = m_all.pieces[p];
      if (piece.parameter < 0 || !is_within(point, piece.box))
        continue;
      const auto range = [&](std::size_t k) { return m_all.vertices[k].box[piece.parameter]; };
      auto [first, last] = std::pair(range(piece.ends[0]), range(piece.ends[1]));
      if (last.first < first.first)
        std::swap(first, last);
      if (!(first.second < point[piece.parameter].first && point[piece.parameter].second < last.first))
        continue;
      Curve_piece rest = piece;
      piece.ends[1] = rest.ends[0] = i;
      m_all.pieces.push_back(std::move(rest));
      make_singular(i);
      return true;
    }
    return false;
  }
};

/*
Joins the curves on a face, or a plane of breaks, with all other ones, which meet it in points. There the equality has
two factors that are zero, so that they are singular points; and they are solutions on the face: each of them is a
vertex there, or lies in a piece, between its ends, since this has no other solutions in its box.
*/
class Curves_on_face : Curve_divisions
{
  const Vanishing_face& m_face;
  const int m_exponent;
  std::size_t m_first_undecided;   // of the boxes on the face

public:
  // Adds `on_face` to `all`, the solutions without the face. The exponent is that of the factor of the face.
  Curves_on_face(const Vanishing_face& face, int exponent, Found_curves& all)
    : Curve_divisions(all, all.pieces.size(), {}), m_face(face), m_exponent(exponent),
      m_first_undecided(all.undecided.size())
  {}

  void add(Found_curves&& on_face)
  {
    const std::vector<bool> is_solution = m_all.solutions();
    on_face.vertices.move_to_plane(m_face.axis, m_face.value);
    for (Curve_piece& piece : on_face.pieces) {
      piece.box[m_face.axis] = {m_face.value, m_face.value};
      piece.multiplicity *= m_exponent;
    }
    for (Undecided_box& box : on_face.undecided)
      box.box[m_face.axis] = {m_face.value, m_face.value};
    m_vertices = m_all.merge(std::move(on_face));
    for (std::size_t i = 0; i < is_solution.size(); ++i)
      if (is_solution[i] && is_on_face(i) && !is_undecided(i) && !Curve_divisions::add(i))
        m_all.undecided.push_back({m_all.vertices[i].box, {i}, Undecided_reason::TOLERANCE});
  }

  // Says nothing of the face of a domain.
  void leave_undecided(Exact_ranges domain)
  {
    domain[m_face.axis] = {m_face.value, m_face.value};
    Undecided_box face{std::move(domain), {}, Undecided_reason::CONTINUUM};
    for (std::size_t i = 0; i < m_all.vertices.size(); ++i)
      if (is_on_face(i))
        face.vertices.push_back(i);
    std::erase_if(m_all.points, [&](std::size_t i) { return is_on_face(i); });
    m_all.undecided.push_back(std::move(face));
  }

private:
  bool is_on_face(std::size_t i) const
  {
    return m_all.vertices[i].is_fixed[m_face.axis] && m_all.vertices[i].box[m_face.axis].first == m_face.value;
  }

  // Nothing is known of the face there.
  bool is_undecided(std::size_t i) const
  {
    return std::any_of(m_all.undecided.begin() + static_cast<std::ptrdiff_t>(m_first_undecided), m_all.undecided.end(),
                       [&](const Undecided_box& box) { return touch(box.box, m_all.vertices[i].box); });
  }
};

/*
The curves of two systems, which meet in the solutions of both: these are singular points of the union. What is not
decided of them is undecided there.
*/
class United_curves
{
  std::array<Found_curves, 2> m_found;
  const Constraint_system_d& m_both;   // all equalities, which are polynomials
  std::vector<Undecided_box> m_undecided;

public:
  United_curves(Found_curves&& first, Found_curves&& second, const Constraint_system_d& both)
    : m_found{std::move(first), std::move(second)}, m_both(both)
  {}

  Found_curves operator()(const Solution_set_d<double>& common_points)
  {
    std::vector<std::array<std::size_t, 2>> same;
    for (const Solution_d<double>& point : common_points)
      if (point.kind() == Solution_kind::CERTIFIED)
        same.push_back(divided_at(place(point)));
      else
        m_undecided.push_back({point.exact_box(), {}, Undecided_reason::TOLERANCE});
    auto& [result, second] = m_found;
    const Vertex_indices places = result.merge(std::move(second));
    for (const auto& [i, other] : same) {
      result.vertices.identify(i, places[other]);
      result.for_each_index(
          [&, i = i, other = places[other]](std::size_t& index) { index = index == other ? i : index; });
    }
    result.undecided.insert(result.undecided.end(), m_undecided.begin(), m_undecided.end());
    return std::move(result);
  }

private:
  // The vertices of both that a point becomes.
  std::array<std::size_t, 2> divided_at(const Exact_ranges& point)
  {
    std::array<std::size_t, 2> result;
    for (const std::size_t k : {0, 1}) {
      Vertex_indices others(m_found[k].vertices.size());
      std::iota(others.begin(), others.end(), std::size_t(0));
      result[k] = m_found[k].vertices.add(Plane_point::singular(point));
      if (!Curve_divisions(m_found[k], 0, std::move(others)).add(result[k]))
        m_undecided.push_back({point, {}, Undecided_reason::TOLERANCE});
    }
    return result;
  }

  // The box of a solution; a rational point that is a singular vertex, if it is this one.
  Exact_ranges place(const Solution_d<double>& point) const
  {
    for (const Found_curves& found : m_found)
      for (std::size_t i = 0; i < found.vertices.size(); ++i)
        if (const Plane_point& vertex = found.vertices[i]; vertex.is_singular_point() &&
            is_within(vertex.box, point.exact_uniqueness_region()) && is_solution(vertex.box))
          return vertex.box;
    return point.exact_box();
  }

  bool is_solution(const Exact_ranges& box) const
  {
    std::vector<Exact_rational> point;
    for (const auto& [lower, upper] : box) {
      if (lower != upper)
        return false;
      point.push_back(lower);
    }
    return std::all_of(m_both.equalities().begin(), m_both.equalities().end(),
                       [&](const Spline_function& f) { return CGAL::is_zero(polynomial_at(f, point)(point)); });
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVES_ON_FACES_H
