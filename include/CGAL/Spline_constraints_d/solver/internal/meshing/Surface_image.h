// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_IMAGE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_IMAGE_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/Jet.h>
#include <CGAL/Spline_constraints_d/function/internal/expanded.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Local_functions.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_points.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A map of the unknowns to space, each coordinate a quotient of splines.
struct Image_functions
{
  std::array<Spline_function, 3> numerators, denominators;
};

// The quotient of functions that a formula is, exactly. Functions of formulas with splines are so up to factors, which
// values at a point tell.
inline std::pair<Spline_function, Spline_function> quotient_of(const Expression& formula, const Exact_ranges& domain)
{
  const auto function = [&](const Power_polynomial& polynomial) {
    return expanded(formula.symbols().get(), polynomial, {});
  };
  std::pair<Spline_function, Spline_function> result{function(formula.numerator()),
                                                     function(polynomial_of(formula.denominator()))};
  if (formula.symbols() == nullptr || formula.is_polynomial() || is_zero_everywhere(result.first))
    return result;
  constexpr int most_points = 64;
  for (int k = 1; k < most_points; ++k) {
    std::vector<Exact_rational> point;
    for (std::size_t j = 0; j < domain.size(); ++j) // of many different coordinates
      point.push_back(domain[j].first +
                      (domain[j].second - domain[j].first) * (1 + (k * (2 * static_cast<int>(j) + 3)) % most_points) /
                          (most_points + 1));
    const std::span<const Exact_rational> place(point);
    const Exact_rational above = spline_value<Exact_rational>(result.first, place, place),
                         below = spline_value<Exact_rational>(result.second, place, place);
    if (above == Exact_rational(0) || below == Exact_rational(0))
      continue;
    result.first *= Exact_rational(formula(place) * below / above);
    return result;
  }
  throw Invalid_input("to_surface_mesh: a coordinate of the map to space is zero, or not defined, at too many points");
}

inline Image_functions image_functions(const Vector_expression<3>& image, const Exact_ranges& domain)
{
  Image_functions result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (const auto own = image[i].domains(); own != nullptr && own->size() > domain.size())
      throw Invalid_input("to_surface_mesh: coordinate " + std::to_string(i) +
                          " of the map to space has unknowns that the system does not have");
    std::tie(result.numerators[i], result.denominators[i]) = quotient_of(image[i], domain);
  }
  return result;
}

// Where surfaces of solutions lie in space, with tangents and curvatures there.
class Surface_image
{
public:
  using Point = Solution_surface_mesh::Mesh::Point;
  using Vector = Surface_differentials_3::Vector;
  using Unknowns = Surface_points::Point;

private:
  Surface_points& m_points;
  const Surface_solution_set_d& m_set;
  std::optional<Local_function_source> m_source; // none: the first three unknowns
  std::vector<std::unique_ptr<Local_functions>> m_near_patch;
  Function_jets m_jets, m_quotients;

public:
  Surface_image(const Surface_solution_set_d& set, Surface_points& points, const Image_functions* image)
    : m_points(points), m_set(set), m_near_patch(set.patches().size())
  {
    if (image == nullptr)
      return;
    std::vector<Spline_function> functions(image->numerators.begin(), image->numerators.end());
    functions.insert(functions.end(), image->denominators.begin(), image->denominators.end());
    m_source.emplace(std::move(functions), points.dimension());
  }

  Point operator()(std::size_t patch, const Unknowns& unknowns)
  {
    if (!m_source)
      return Point(unknowns[0], unknowns[1], unknowns[2]);
    set_quotients(patch, unknowns, 1);
    return Point(m_quotients.values[0], m_quotients.values[1], m_quotients.values[2]);
  }

  // The directions in which unknowns can move on the surface, as columns, and those in which their images move. With
  // the gradients of the equalities before them, those of inequalities negated, they are positively oriented.
  using Directions = Eigen::Matrix<double, Eigen::Dynamic, 2>;
  struct Tangents
  {
    Directions unknowns;
    std::array<Vector, 2> images;
  };

  Tangents tangents(std::size_t patch, const Unknowns& unknowns, int order = 1)
  {
    m_points.functions(patch).evaluate(unknowns, order, m_jets);
    if (m_source)
      set_quotients(patch, unknowns, order);
    Tangents result{kernel_of(jacobian(), (m_set.system().dimension() - m_set.dimension()) % 2 == 0), {}};
    for (const int k : {0, 1})
      result.images[static_cast<std::size_t>(k)] = image_of(result.unknowns.col(k));
    return result;
  }

  // Whether the surface is that of one equality in space, so that the gradient is its normal.
  bool is_level_set() const { return !m_source && n() == 3; }

  // Of unit length; zero where there is none.
  Vector normal(std::size_t patch, const Unknowns& unknowns)
  {
    if (is_level_set()) {
      m_points.functions(patch).evaluate(unknowns, 1, m_jets);
      return unit(m_jets.gradients);
    }
    const Tangents tangent = tangents(patch, unknowns);
    const Vector cross = CGAL::cross_product(tangent.images[0], tangent.images[1]);
    const double size = length(cross);
    return size > 0 ? cross / size : Vector(CGAL::NULL_VECTOR);
  }

  // The vector of this direction.
  static Vector unit(const std::vector<double>& coordinates)
  {
    const Vector vector(coordinates[0], coordinates[1], coordinates[2]);
    const double size = length(vector);
    return size > 0 ? vector / size : Vector(CGAL::NULL_VECTOR);
  }

  // Where the surface has no tangent plane: zero.
  static Surface_differentials_3 no_differentials()
  {
    const Vector zero(0, 0, 0);
    return {{zero, zero}, zero, {0, 0, 0}, {0, 0}, {zero, zero}};
  }

  Surface_differentials_3 differentials(std::size_t patch, const Unknowns& unknowns)
  {
    if (is_level_set())
      return differentials_of_level_set(patch, unknowns);
    const Tangents tangent = tangents(patch, unknowns, 2);
    const auto& [first, second] = tangent.images;
    Surface_differentials_3 result = no_differentials();
    const Vector cross = CGAL::cross_product(first, second);
    const double area = length(cross);
    if (!(area > 0))
      return result;
    result.normal = cross / area;
    const Eigen::MatrixXd rows = jacobian();
    const Eigen::MatrixXd square = rows * rows.transpose();
    const auto bend = [&](int i, int k) {
      return result.normal * second_derivative(rows, square, tangent.unknowns.col(i), tangent.unknowns.col(k));
    };
    // the first tangent, and what is left of the second one perpendicular to it
    const double scale = 1 / length(first), other = first * second * scale;
    const Vector rest = second - other * scale * first;
    const double inverse = 1 / length(rest);
    result.tangents = {first * scale, rest * inverse};
    const double l = bend(0, 0), m = bend(0, 1), n = bend(1, 1), a = -other * scale * inverse;
    result.second_form = {scale * scale * l, scale * (a * l + inverse * m),
                          a * a * l + 2 * a * inverse * m + inverse * inverse * n};
    set_principal(result);
    return result;
  }

  static double length(const Vector& vector) { return std::sqrt(vector.squared_length()); }

private:
  std::size_t n() const { return m_points.dimension(); }

  // On f = 0 points bend away from the tangents by the second derivatives of f over the length of its gradient.
  Surface_differentials_3 differentials_of_level_set(std::size_t patch, const Unknowns& unknowns)
  {
    m_points.functions(patch).evaluate(unknowns, 2, m_jets);
    Surface_differentials_3 result = no_differentials();
    const Vector gradient(m_jets.gradients[0], m_jets.gradients[1], m_jets.gradients[2]);
    const double size = length(gradient);
    if (!(size > 0))
      return result;
    result.normal = gradient / size;
    const Vector axis = std::abs(gradient.x()) < std::abs(gradient.y()) ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector first = CGAL::cross_product(result.normal, axis);
    result.tangents[0] = first / length(first);
    result.tangents[1] = CGAL::cross_product(result.normal, result.tangents[0]);
    const double* h = m_jets.hessians.data();
    const auto bend = [&](const Vector& a, const Vector& b) {
      const Vector image(h[0] * a.x() + h[1] * a.y() + h[2] * a.z(), h[3] * a.x() + h[4] * a.y() + h[5] * a.z(),
                         h[6] * a.x() + h[7] * a.y() + h[8] * a.z());
      return -(image * b) / size;
    };
    const auto& [s, t] = result.tangents;
    result.second_form = {bend(s, s), bend(s, t), bend(t, t)};
    set_principal(result);
    return result;
  }

  const Local_functions& functions(std::size_t patch)
  {
    std::unique_ptr<Local_functions>& own = m_near_patch[patch];
    if (own == nullptr)
      own = std::make_unique<Local_functions>(m_source->near(m_set.patches()[patch].box));
    return *own;
  }

  // Value and derivatives of p / q, from those of p and q.
  void set_quotients(std::size_t patch, const Unknowns& unknowns, int order)
  {
    functions(patch).evaluate(unknowns, order, m_quotients);
    for (std::size_t i = 0; i < 3; ++i) {
      const double below = m_quotients.values[3 + i], value = m_quotients.values[i] / below;
      m_quotients.values[i] = value;
      double *own = &m_quotients.gradients[i * n()], *of_below = &m_quotients.gradients[(3 + i) * n()];
      for (std::size_t j = 0; j < n(); ++j)
        own[j] = (own[j] - value * of_below[j]) / below;
      for (std::size_t j = 0; order > 1 && j < n(); ++j)
        for (std::size_t k = 0; k < n(); ++k) {
          double& entry = m_quotients.hessians[(i * n() + j) * n() + k];
          const double entry_below = m_quotients.hessians[((3 + i) * n() + j) * n() + k];
          entry = (entry - own[j] * of_below[k] - own[k] * of_below[j] - value * entry_below) / below;
        }
    }
  }

  Eigen::MatrixXd jacobian() const
  {
    Eigen::MatrixXd rows(m_jets.values.size(), n());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      for (Eigen::Index j = 0; j < rows.cols(); ++j)
        rows(i, j) = m_jets.gradients[static_cast<std::size_t>(i) * n() + static_cast<std::size_t>(j)];
    return rows;
  }

  static Directions kernel_of(const Eigen::MatrixXd& rows, bool is_positive)
  {
    const Eigen::Index n = rows.cols();
    if (n == 3)
      return kernel_of_plane(Vector(rows(0, 0), rows(0, 1), rows(0, 2)));
    const Eigen::MatrixXd basis = Eigen::HouseholderQR<Eigen::MatrixXd>(rows.transpose()).householderQ();
    Directions result = basis.rightCols(2);
    Eigen::MatrixXd frame(n, n);
    frame << rows.transpose(), result;
    if ((frame.determinant() > 0) != is_positive)
      result.col(1) *= -1;
    return result;
  }

  static Directions kernel_of_plane(const Vector& gradient)
  {
    const Vector axis = std::abs(gradient.x()) < std::abs(gradient.y()) ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector first = CGAL::cross_product(gradient, axis), second = CGAL::cross_product(gradient, first);
    const double a = 1 / length(first), b = 1 / length(second);
    Directions result(3, 2);
    result << a * first.x(), b * second.x(), a * first.y(), b * second.y(), a * first.z(), b * second.z();
    return result;
  }

  // The derivative of the image in a direction.
  Vector image_of(const Eigen::VectorXd& direction) const
  {
    if (!m_source)
      return Vector(direction[0], direction[1], direction[2]);
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < n(); ++j)
        result[i] += m_quotients.gradients[i * n() + j] * direction[static_cast<Eigen::Index>(j)];
    return Vector(result[0], result[1], result[2]);
  }

  double second_order(const std::vector<double>& hessians, std::size_t function, const Eigen::VectorXd& a,
                      const Eigen::VectorXd& b) const
  {
    double result = 0;
    for (std::size_t j = 0; j < n(); ++j)
      for (std::size_t k = 0; k < n(); ++k)
        result += hessians[(function * n() + j) * n() + k] * a[static_cast<Eigen::Index>(j)] *
            b[static_cast<Eigen::Index>(k)];
    return result;
  }

  // Of the image along the surface: unknowns bend away from the tangent plane so that the equalities stay zero.
  Vector second_derivative(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& square, const Eigen::VectorXd& a,
                           const Eigen::VectorXd& b) const
  {
    Eigen::VectorXd bend(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      bend[i] = -second_order(m_jets.hessians, static_cast<std::size_t>(i), a, b);
    const Eigen::VectorXd lift = rows.transpose() * square.ldlt().solve(bend);
    Vector result = image_of(lift);
    if (m_source)
      result = result +
          Vector(second_order(m_quotients.hessians, 0, a, b), second_order(m_quotients.hessians, 1, a, b),
                 second_order(m_quotients.hessians, 2, a, b));
    return result;
  }

  static void set_principal(Surface_differentials_3& result)
  {
    const auto& [l, m, n] = result.second_form;
    const double mean = 0.5 * (l + n), half = 0.5 * (l - n), spread = std::hypot(half, m);
    result.curvatures = {mean - spread, mean + spread};
    const double angle = 0.5 * std::atan2(m, half); // of the greater one, from the first tangent
    const double c = std::cos(angle), s = std::sin(angle);
    result.directions = {c * result.tangents[1] - s * result.tangents[0],
                         c * result.tangents[0] + s * result.tangents[1]};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_SURFACE_IMAGE_H
