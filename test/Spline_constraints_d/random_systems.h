// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_SYSTEMS_H

#include "solver_test_systems.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

// What random systems with known solutions are made of.
namespace solver_test {

class Random_numbers
{
  std::mt19937_64 m_engine;

public:
  explicit Random_numbers(std::uint64_t seed) : m_engine(seed) {}

  int integer(int low, int high) { return low + static_cast<int>(m_engine() % static_cast<unsigned>(high - low + 1)); }
  bool chance(int percent) { return integer(1, 100) <= percent; }

  // A numerator and a denominator between given bounds.
  Rational ratio(int low, int high, int highest_denominator)
  {
    const int numerator = integer(low, high);
    return fraction(numerator, integer(1, highest_denominator));
  }

  template <class T>
  void shuffle(std::vector<T>& values)
  {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[m_engine() % i]);
  }

  // 0, ..., count - 1 in some order.
  std::vector<int> permutation(int count)
  {
    std::vector<int> result(count);
    for (int i = 0; i < count; ++i)
      result[i] = i;
    shuffle(result);
    return result;
  }
};

// New unknowns z = z(x) as polynomials in x, and x for a given z. The map is one-to-one and regular everywhere, so that
// it keeps multiplicities.
struct Change_of_unknowns
{
  std::vector<Polynomial> z;
  std::function<Point(const Point&)> inverse;
};

inline Change_of_unknowns identity(int dimension)
{
  return {variables(dimension), [](const Point& value) { return value; }};
}

// z = A x with a matrix that is triangular up to the order of the unknowns, of ones and small fractions, and with few
// entries in the rows of high degree.
inline Change_of_unknowns affine_change(Random_numbers& random, const std::vector<int>& degrees)
{
  const int n = static_cast<int>(degrees.size());
  std::vector<std::vector<Rational>> matrix(n, std::vector<Rational>(n, Rational(0)));
  std::vector<Polynomial> z(n);
  const std::vector<int> order = random.permutation(n);   // row order[i] uses the unknowns order[0..i]
  for (int i = 0; i < n; ++i) {
    const int row = order[i];
    int room = degrees[row] > 3 || n > 3 ? 1 : 2;
    z[row] = Polynomial::variable(row);
    for (int j = 0; j < i; ++j)
      if (room > 0 && random.chance(60)) {
        --room;
        matrix[row][order[j]] = random.ratio(-4, 4, 4);
        z[row] += matrix[row][order[j]] * Polynomial::variable(order[j]);
      }
  }
  return {std::move(z), [order, matrix, n](const Point& value) {
            Point x = value;
            for (int row : order)
              for (int j = 0; j < n; ++j)
                if (matrix[row][j] != Rational(0))
                  x[row] = x[row] - matrix[row][j] * x[j];
            return x;
          }};
}

// z_i = x_i + c x_{i-1}^2 for the unknowns from `first` on, with c = 0 where the degree is high. Coordinates may grow
// so large that doubles do not see a difference of 1e-9.
inline Change_of_unknowns triangular_change(Random_numbers& random, const std::vector<int>& degrees, int first = 1)
{
  const int n = static_cast<int>(degrees.size());
  std::vector<Polynomial> z = variables(n);
  std::vector<Rational> factor(n, Rational(0));
  for (int i = first; i < n; ++i) {
    if (degrees[i] <= 3)
      factor[i] = fraction(random.integer(-2, 2), random.integer(2, 6));
    z[i] += factor[i] * square(Polynomial::variable(i - 1));
  }
  return {std::move(z), [factor, n](const Point& value) {
            Point x = value;
            for (int i = 1; i < n; ++i)
              x[i] = x[i] - factor[i] * (x[i - 1] * x[i - 1]);
            return x;
          }};
}

// A box around most of the points; ends of some ranges are coordinates of points.
inline std::vector<System::Domain> domain_around(Random_numbers& random, const std::vector<Point>& points)
{
  std::vector<System::Domain> domain;
  const auto any = [&]() -> const Point& { return points[random.integer(0, static_cast<int>(points.size()) - 1)]; };
  const Point& corner = any();
  const bool has_corner = random.chance(15);
  for (std::size_t j = 0; j < corner.size(); ++j) {
    Rational lower = points[0][j].about(), upper = lower;
    for (const Point& point : points) {
      lower = (std::min)(lower, point[j].about());
      upper = (std::max)(upper, point[j].about());
    }
    lower -= random.ratio(1, 9, 9);
    upper += random.ratio(1, 9, 9);
    if (has_corner || random.chance(20)) {
      const Coordinate& at = has_corner ? corner[j] : any()[j];
      if (at.is_rational())
        (random.chance(50) ? lower : upper) = at.lower;
    }
    domain.emplace_back(lower, upper);
  }
  return domain;
}

inline bool is_in(const std::vector<System::Domain>& domain, const Point& point)
{
  for (std::size_t j = 0; j < point.size(); ++j)
    if (point[j].lower < domain[j].first || domain[j].second < point[j].upper)
      return false;
  return true;
}

// Number of faces of the box that the point lies on.
inline int count_faces(const std::vector<System::Domain>& domain, const Point& point)
{
  int result = 0;
  for (std::size_t j = 0; j < point.size(); ++j)
    result += point[j].is_rational() && (point[j].lower == domain[j].first || point[j].lower == domain[j].second);
  return result;
}

// The system of the functions, in most cases multiplied by a regular matrix, in any order and with any factors.
inline System mixed_system(Random_numbers& random, const std::vector<System::Domain>& domain,
                           std::vector<SC::Spline_function> rows)
{
  const bool is_mixed = random.chance(60);
  for (std::size_t i = rows.size(); i-- > 0 && is_mixed;)   // a unit triangular matrix is regular
    for (std::size_t j = 0; j < i; ++j)
      if (random.chance(50))
        rows[i] += SC::Spline_function(rows[j]) *= random.ratio(-3, 3, 3);
  random.shuffle(rows);
  System system(domain);
  for (SC::Spline_function& row : rows)
    system.add(row *= random.ratio(1, 20, 20), Relation::EQUAL);
  return system;
}

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_RANDOM_SYSTEMS_H
