// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_MULTIPLE_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_MULTIPLE_ROOTS_H

#include "random_systems.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace solver_test {

struct Planted_root
{
  Point point;
  int multiplicity;
  bool is_on_break = false;   // of a spline

  bool is_rational() const
  {
    return std::all_of(point.begin(), point.end(), [](const Coordinate& c) { return c.is_rational(); });
  }
};

struct Planted_problem
{
  std::string name;
  System system;
  std::vector<Planted_root> roots;   // all in the domain
};

/*
Random systems of which all real solutions and their multiplicities are known by construction. Some of the unknowns z
are those of a core:

- powers: products of powers of linear factors and of irreducible quadratic ones, in one unknown each. Multiplicities
  multiply.
- arrangements: as many products of linear forms as unknowns, any choice of one factor of each of which is regular. A
  solution has the number of the choices that vanish there, since
  multiplicities of intersections are additive in each product.
- graphs: f = y - p(x), and a f + b h with a polynomial h in x and b > 0. On the curve f = 0 the second function is b h:
  the multiplicities are those of the zeros of h.
- cubics with a cusp or a node, x = t^2 - e, y = t^3 - e t, and a f + b h with a product h of lines through two points
  of the curve each: the zeros of h in t, those that are one point together.
- circles, likewise.

The other unknowns have powers, z is a polynomial map of x that is regular everywhere, and the equations are multiplied
by a regular matrix: none of these changes a multiplicity.
*/
class Planted_multiple_roots
{
  struct Core
  {
    std::string name;
    std::vector<Polynomial> functions;
    std::vector<Planted_root> roots;
    int most = 24;   // of the multiplicities
  };

  Random_numbers m_random;
  int m_highest_contact;
  bool m_may_be_irrational = false;

public:
  // `highest_contact`: of curves that touch in a point, at least 2. The multiplicities of other kinds are limited
  // accordingly.
  explicit Planted_multiple_roots(std::uint64_t seed, int highest_contact)
    : m_random(seed), m_highest_contact(highest_contact)
  {}

  // A square root is a coordinate of some solutions, if the system may have any.
  Planted_problem make(int n, bool may_be_irrational)
  {
    m_may_be_irrational = may_be_irrational;
    for (;;) {
      Core core = make_core(n);
      while (core.functions.size() < static_cast<std::size_t>(n))
        add_powers(core, n > 2 ? 2 : 4);
      if (std::all_of(core.roots.begin(), core.roots.end(),
                      [&](const Planted_root& root) { return root.multiplicity <= core.most; }))
        return finished(std::move(core));
    }
  }

private:
  Core make_core(int n)
  {
    const int kind = n == 1 || m_may_be_irrational ? 0 : m_random.integer(0, n == 2 ? 4 : 5);
    if (kind == 1 || kind == 5)
      return arrangement(kind == 1 ? 2 : 3);
    if (kind == 0) {
      Core core{"powers", {}, {{{}, 1}}};
      add_powers(core, n == 1 ? 9 : n == 2 ? 6 : 3);
      return core;
    }
    for (;;) {
      Core core = kind == 2 ? graph() : kind == 3 ? cubic() : circle();
      core.most = 2 * m_highest_contact;
      if (is_short(core.roots) && std::all_of(core.roots.begin(), core.roots.end(), [&](const Planted_root& root) {
            return root.multiplicity <= m_highest_contact;
          }))
        return core;
    }
  }

  // No box of doubles that holds one of the roots holds a simpler rational point.
  static bool is_short(const std::vector<Planted_root>& roots)
  {
    const auto is_short_number = [](const Coordinate& c) {
      return !c.is_rational() || (SC::internal::denominator_of(c.lower) <= 2000 && -100 <= c.lower && c.lower <= 100);
    };
    return std::all_of(roots.begin(), roots.end(), [&](const Planted_root& root) {
      return std::all_of(root.point.begin(), root.point.end(), is_short_number);
    });
  }

  // Often on planes of the subdivision.
  Rational number()
  {
    return m_random.chance(40) ? fraction(m_random.integer(-4, 4), 1 << m_random.integer(0, 2))
                               : m_random.ratio(-24, 24, 12);
  }

  Rational new_number(const std::vector<Rational>& others)
  {
    Rational result = number();
    while (std::find(others.begin(), others.end(), result) != others.end())
      result = number();
    return result;
  }

  Polynomial positive(const std::vector<Polynomial>& x)
  {
    Polynomial result(m_random.ratio(1, 9, 9));
    if (m_random.chance(40))
      for (const Polynomial& v : x)
        result += m_random.ratio(1, 3, 3) * square(v - number());
    return result;
  }

  // A polynomial in one unknown up to some degree, and its zeros, one of them multiple.
  struct Powers
  {
    Polynomial function;
    std::vector<std::pair<Coordinate, int>> zeros;
  };

  Powers powers(int variable, int room)
  {
    const Polynomial x = Polynomial::variable(variable);
    Powers result{Polynomial(m_random.ratio(1, 9, 9)), {}};
    if (m_may_be_irrational && room > 1 && m_random.chance(70)) {
      const int multiplicity = room > 3 && m_random.chance(80) ? 2 : 1;
      const Rational c = fraction(std::array{2, 3, 5, 7}[m_random.integer(0, 3)], m_random.chance(50) ? 1 : 4);
      result.function *= pow(square(x) - c, multiplicity);
      const Coordinate root = Coordinate::square_root(c);
      result.zeros = {{root, multiplicity}, {Coordinate(0) - root, multiplicity}};
      room -= 2 * multiplicity;
    }
    std::vector<Rational> places;
    for (bool is_first = true; room > 0 && (is_first || m_random.chance(50)); is_first = false) {
      const int most = (std::min)(room, variable == 0 ? 6 : 4);
      const int multiplicity = is_first && most > 1
          ? m_random.integer(m_random.chance(80) ? 2 : 1, m_random.chance(25) ? most : (std::min)(most, 3))
          : m_random.integer(1, (std::min)(most, 2));
      places.push_back(new_number(places));
      result.function *= pow(x - places.back(), multiplicity);
      result.zeros.emplace_back(places.back(), multiplicity);
      room -= multiplicity;
    }
    if (room > 1 && m_random.chance(15))
      result.function *= positive({x});
    return result;
  }

  // One more unknown that does not depend on the others.
  void add_powers(Core& core, int room)
  {
    const Powers added = powers(static_cast<int>(core.functions.size()), room);
    std::vector<Planted_root> roots;
    for (const Planted_root& root : core.roots)
      for (const auto& [zero, multiplicity] : added.zeros) {
        roots.push_back({root.point, root.multiplicity * multiplicity});
        roots.back().point.push_back(zero);
      }
    core.roots = std::move(roots);
    core.functions.push_back(added.function);
  }

  static std::vector<Planted_root> roots_of(const std::map<std::vector<Rational>, int>& multiplicities)
  {
    std::vector<Planted_root> result;
    for (const auto& [point, multiplicity] : multiplicities)
      result.push_back({Point(point.begin(), point.end()), multiplicity});
    return result;
  }

  // The solution of A x = b by elimination; empty when A is singular.
  static std::vector<Rational> solution(std::vector<std::vector<Rational>> rows)
  {
    const std::size_t n = rows.size();
    for (std::size_t c = 0; c < n; ++c) {
      std::size_t pivot = c;
      while (pivot < n && rows[pivot][c] == Rational(0))
        ++pivot;
      if (pivot == n)
        return {};
      std::swap(rows[c], rows[pivot]);
      for (std::size_t i = 0; i < n; ++i)
        if (i != c) {
          const Rational factor = rows[i][c] / rows[c][c];
          for (std::size_t k = c; k <= n; ++k)
            rows[i][k] -= factor * rows[c][k];
        }
    }
    std::vector<Rational> result;
    for (std::size_t i = 0; i < n; ++i)
      result.emplace_back(rows[i][n] / rows[i][i]);
    return result;
  }

  Core arrangement(int n)
  {
    using Rows = std::vector<std::vector<Rational>>;   // of a form: normal and offset
    std::vector<std::vector<Rational>> centres(2);
    for (auto& centre : centres)
      for (int j = 0; j < n; ++j)
        centre.push_back(number());
    for (;;) {
      std::vector<Rows> factors(n);
      for (Rows& rows : factors)
        for (int count = m_random.integer(1, n == 2 ? 3 : 2); count > 0; --count) {
          const std::vector<Rational>& centre = centres[m_random.chance(70) ? 0 : 1];
          std::vector<Rational> row;
          Rational offset(0);
          for (int j = 0; j < n; ++j) {
            row.emplace_back(m_random.integer(-3, 3));
            offset += row[j] * centre[j];
          }
          row.push_back(offset);
          rows.push_back(row);
          if (m_random.chance(15))
            rows.push_back(row);
        }
      std::map<std::vector<Rational>, int> multiplicities;
      if (!count_choices(factors, {}, multiplicities))
        continue;
      Core core{"arrangement", {}, roots_of(multiplicities), 6 * m_highest_contact};
      for (const Rows& rows : factors) {
        Polynomial product(1);
        for (const auto& row : rows) {
          Polynomial form(Rational(-row[n]));
          for (int j = 0; j < n; ++j)
            form += row[j] * Polynomial::variable(j);
          product *= form;
        }
        core.functions.push_back(std::move(product));
      }
      return core;
    }
  }

  // False when some choice is singular.
  static bool count_choices(const std::vector<std::vector<std::vector<Rational>>>& factors,
                            const std::vector<std::vector<Rational>>& chosen,
                            std::map<std::vector<Rational>, int>& multiplicities)
  {
    if (chosen.size() == factors.size()) {
      const std::vector<Rational> point = solution(chosen);
      if (!point.empty())
        ++multiplicities[point];
      return !point.empty();
    }
    for (const auto& row : factors[chosen.size()]) {
      auto longer = chosen;
      longer.push_back(row);
      if (!count_choices(factors, longer, multiplicities))
        return false;
    }
    return true;
  }

  // f and a f + b h
  std::vector<Polynomial> tangential(const Polynomial& f, const Polynomial& h)
  {
    const std::vector<Polynomial> x = variables(2);
    Polynomial a(m_random.ratio(-3, 3, 3));
    if (m_random.chance(30))
      a += m_random.ratio(-2, 2, 2) * x[0] + m_random.ratio(-2, 2, 2) * x[1];
    return {f, a * f + (m_random.chance(30) ? positive(x) : Polynomial(m_random.ratio(1, 5, 5))) * h};
  }

  Core graph()
  {
    const std::vector<Polynomial> x = variables(2);
    const Powers zeros = powers(0, 5);
    Polynomial height;
    for (int k = m_random.integer(1, 3); k >= 0; --k)
      height = height * x[0] + m_random.ratio(-4, 4, 3);
    Core core{"graph", tangential(x[1] - height, zeros.function), {}, 0};
    for (const auto& [zero, multiplicity] : zeros.zeros)
      core.roots.push_back({{zero, value_at(height, {zero})}, multiplicity});
    return core;
  }

  // x = t^2 - e, y = t^3 - e t. The line through two points meets the curve in a third one: t_1 t_2 + (t_1 + t_2) t_3 =
  // -e.
  Core cubic()
  {
    const std::vector<Polynomial> x = variables(2);
    const Rational e(m_random.integer(0, 1));
    std::map<std::vector<Rational>, int> multiplicities;
    const auto count = [&](const Rational& t, int multiplicity) {
      multiplicities[{t * t - e, t * t * t - e * t}] += multiplicity;
    };
    Polynomial h(1);
    for (int lines = m_random.integer(1, 2); lines > 0; --lines) {
      const Rational t1 = m_random.ratio(-4, 4, 2), t2 = m_random.chance(60) ? t1 : m_random.ratio(-4, 4, 2);
      const int multiplicity = m_random.chance(20) ? 2 : 1;
      count(t1, multiplicity);
      count(t2, multiplicity);
      if (t1 + t2 == Rational(0))
        h *= pow(x[0] - (t1 * t1 - e), multiplicity);
      else {
        const Rational t3 = -(e + t1 * t2) / (t1 + t2), slope = t1 + t2 + t3;
        count(t3, multiplicity);
        h *= pow(x[1] - slope * (x[0] + e) - t1 * t2 * t3, multiplicity);
      }
    }
    return {"cubic", tangential(square(x[1]) - (x[0] + e) * square(x[0]), h), roots_of(multiplicities)};
  }

  Core circle()
  {
    const std::vector<Polynomial> x = variables(2);
    const Rational u = number(), v = number(), r = m_random.ratio(1, 6, 3);
    const auto point = [&](const Rational& t) {
      const Rational length = 1 + t * t;
      return std::vector<Rational>{u + r * (1 - t * t) / length, v + r * 2 * t / length};
    };
    std::map<std::vector<Rational>, int> multiplicities;
    Polynomial h(1);
    for (int lines = m_random.integer(1, 2); lines > 0; --lines) {
      const std::vector<Rational> p = point(m_random.ratio(-3, 3, 2)),
                                  q = m_random.chance(60) ? p : point(m_random.ratio(-3, 3, 2));
      const int multiplicity = m_random.chance(20) ? 2 : 1;
      multiplicities[p] += multiplicity;
      multiplicities[q] += multiplicity;
      const Polynomial line = p == q ? (p[0] - u) * (x[0] - p[0]) + (p[1] - v) * (x[1] - p[1])
                                     : (q[1] - p[1]) * (x[0] - p[0]) - (q[0] - p[0]) * (x[1] - p[1]);
      h *= pow(line, multiplicity);
    }
    return {"circle", tangential(square(x[0] - u) + square(x[1] - v) - r * r, h), roots_of(multiplicities)};
  }

  Change_of_unknowns random_change(const std::vector<Polynomial>& functions)
  {
    const int n = static_cast<int>(functions.size());
    std::vector<int> degrees(n, 0);
    for (const Polynomial& function : functions)
      for (int i = 0; i < n; ++i)
        degrees[i] = (std::max)(degrees[i], function.degree(i));
    switch (m_random.integer(0, 3)) {
    case 0: return affine_change(m_random, degrees);
    case 1: return triangular_change(m_random, degrees);
    default: return identity(n);
    }
  }

  Planted_problem finished(Core core)
  {
    Change_of_unknowns change = random_change(core.functions);
    std::vector<Planted_root> changed = core.roots;
    for (Planted_root& root : changed)
      root.point = change.inverse(root.point);
    if (is_short(changed))
      core.roots = std::move(changed);
    else
      change = identity(static_cast<int>(core.functions.size()));
    std::vector<Point> points;
    for (const Planted_root& root : core.roots)
      points.push_back(root.point);
    const std::vector<System::Domain> domain = domain_around(m_random, points);
    std::erase_if(core.roots, [&](const Planted_root& root) { return !is_in(domain, root.point); });
    std::vector<SC::Spline_function> functions;
    for (const Polynomial& function : composed(core.functions, change.z))
      functions.push_back(!m_may_be_irrational && m_random.chance(20) ? broken(function, domain, core.roots)
                                                                      : SC::Spline_function(function));
    return {core.name, mixed_system(m_random, domain, std::move(functions)), std::move(core.roots)};
  }

  // A polynomial in one unknown in two pieces that meet somewhere, maybe at a root; any other one as it is.
  SC::Spline_function broken(const Polynomial& function, const std::vector<System::Domain>& domain,
                             std::vector<Planted_root>& roots)
  {
    if (function.variables().size() != 1 || roots.empty())
      return function;
    const int axis = function.variables()[0];
    const auto& [lower, upper] = domain[axis];
    const Rational at = m_random.chance(50) ? roots[0].point[axis].about() : Rational((lower + upper) / 2);
    if (at <= lower || upper <= at)
      return function;
    for (Planted_root& root : roots)
      root.is_on_break = root.is_on_break || (root.point[axis].is_rational() && root.point[axis].lower == at);
    return in_pieces(function, axis, {lower, at, upper});
  }
};

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_PLANTED_MULTIPLE_ROOTS_H
