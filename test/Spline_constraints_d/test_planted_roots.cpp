// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
2,000 random systems of which all solutions are known and rational: in the unknowns z_i they are products of linear factors g_i(z_i), and of quadratic
ones without real zeros; z is an affine, a triangular or a kinked map of x, and the equations are mixed by a regular matrix. Some zeros are 1e-9
apart; the domain has some solutions on its faces, in its corners and right outside.
*/

#include "solver_test_checks.h"

#include <algorithm>
#include <functional>
#include <random>

using namespace solver_test;

using Rational_point = std::vector<Rational>;

class Planted_systems
{
  std::mt19937_64 m_random;
  int m_dimension = 1;
  std::vector<std::vector<Rational>> m_zeros;   // of g_i
  std::vector<Polynomial> m_factors;            // g_i, in z_i
  std::vector<Rational_point> m_roots;          // in x
  std::vector<System::Domain> m_domain;

public:
  std::size_t on_faces = 0, in_corners = 0, close_pairs = 0, splines = 0, highest_degree = 0;

  explicit Planted_systems(unsigned seed) : m_random(seed) {}

  Problem make(int n)
  {
    m_dimension = n;
    choose_zeros();
    switch (integer(0, 3)) {
    case 0: return affine();
    case 1: return triangular();
    case 2: return separable();
    default: return kinked();
    }
  }

private:
  int integer(int low, int high) { return low + static_cast<int>(m_random() % static_cast<unsigned>(high - low + 1)); }
  bool chance(int percent) { return integer(1, 100) <= percent; }
  Rational number() { return fraction(integer(-36, 36), integer(1, 12)); }
  static Polynomial variable(int i) { return Polynomial::variable(i); }

  // Degrees up to 6, but not many solutions.
  void choose_zeros()
  {
    const Rational tiny = fraction(1, 1000000000);
    m_zeros.assign(m_dimension, {});
    int room = 20;
    std::vector<int> order(m_dimension);
    for (int i = 0; i < m_dimension; ++i)
      order[i] = i;
    std::shuffle(order.begin(), order.end(), m_random);
    for (int i : order) {
      const int count = integer(1, (std::min)(room, m_dimension > 3 ? 3 : 6));
      room /= count;
      std::vector<Rational>& zeros = m_zeros[i];
      while (static_cast<int>(zeros.size()) < count) {
        const Rational z = number();
        if (std::find(zeros.begin(), zeros.end(), z) == zeros.end())
          zeros.push_back(z);
      }
      if (count > 1 && chance(25)) {
        zeros[0] = zeros[1] + tiny;
        ++close_pairs;
      }
    }
    m_factors.clear();
    for (int i = 0; i < m_dimension; ++i) {
      Polynomial g(1);
      for (const Rational& z : m_zeros[i])
        g *= variable(i) - z;
      if (m_zeros[i].size() < 5 && m_dimension < 4 && chance(20))
        g *= square(variable(i) - number()) + fraction(integer(1, 5), integer(1, 5));
      highest_degree = (std::max)(highest_degree, static_cast<std::size_t>(g.degree(i)));
      m_factors.push_back(std::move(g));
    }
  }

  // Calls visit(z) for all combinations of zeros.
  template <class Visitor>
  void visit_combinations(const Visitor& visit) const
  {
    std::vector<std::size_t> index(m_dimension, 0);
    for (bool is_done = false; !is_done;) {
      Rational_point z;
      for (int i = 0; i < m_dimension; ++i)
        z.push_back(m_zeros[i][index[i]]);
      visit(z);
      is_done = true;
      for (int i = 0; i < m_dimension && is_done; ++i) {
        is_done = index[i] + 1 == m_zeros[i].size();
        index[i] = is_done ? 0 : index[i] + 1;
      }
    }
  }

  // A box around most solutions; ends of some ranges are coordinates of solutions.
  void choose_domain()
  {
    m_domain.clear();
    const Rational_point& corner = m_roots[integer(0, static_cast<int>(m_roots.size()) - 1)];
    const bool has_corner = chance(15);
    for (int j = 0; j < m_dimension; ++j) {
      Rational lower = m_roots[0][j], upper = lower;
      for (const Rational_point& root : m_roots) {
        lower = (std::min)(lower, root[j]);
        upper = (std::max)(upper, root[j]);
      }
      lower -= fraction(integer(1, 9), integer(1, 9));
      upper += fraction(integer(1, 9), integer(1, 9));
      if (has_corner || chance(20)) {
        const Rational at = has_corner ? corner[j] : m_roots[integer(0, static_cast<int>(m_roots.size()) - 1)][j];
        (chance(50) ? lower : upper) = at;
      }
      m_domain.emplace_back(lower, upper);
    }
  }

  System mixed(const std::vector<SC::Spline_function>& functions)
  {
    // Unit triangular matrices are regular.
    System system(m_domain);
    std::vector<SC::Spline_function> rows = functions;
    const bool is_mixed = chance(60);
    for (int i = 0; i < m_dimension && is_mixed; ++i)
      for (int j = 0; j < i; ++j)
        if (chance(50))
          rows[i] += SC::Spline_function(rows[j]) *= fraction(integer(-3, 3), integer(1, 3));
    std::shuffle(rows.begin(), rows.end(), m_random);
    for (SC::Spline_function& row : rows)
      system.add(row *= fraction(integer(1, 20), integer(1, 20)), Relation::EQUAL);
    return system;
  }

  Problem problem(const std::string& name, System system)
  {
    std::vector<Point> known;
    for (const Rational_point& root : m_roots) {
      int faces = 0;
      bool is_inside = true;
      for (int j = 0; j < m_dimension; ++j) {
        is_inside = is_inside && m_domain[j].first <= root[j] && root[j] <= m_domain[j].second;
        faces += root[j] == m_domain[j].first || root[j] == m_domain[j].second;
      }
      if (!is_inside)
        continue;
      on_faces += faces > 0;
      in_corners += m_dimension > 1 && faces == m_dimension;
      known.emplace_back(root.begin(), root.end());
    }
    return all_known(name, std::move(system), std::move(known));
  }

  std::vector<SC::Spline_function> composed_with(const std::vector<Polynomial>& z) const
  {
    std::vector<SC::Spline_function> result;
    for (const Polynomial& g : m_factors)
      result.emplace_back(composed(g, z));
    return result;
  }

  // z = A x with a triangular matrix of ones and small fractions and few entries in the rows of high degree.
  Problem affine()
  {
    std::vector<std::vector<Rational>> matrix(m_dimension, std::vector<Rational>(m_dimension, Rational(0)));
    std::vector<Polynomial> z;
    std::vector<int> order(m_dimension);   // row order[i] uses the unknowns order[0..i]
    for (int i = 0; i < m_dimension; ++i)
      order[i] = i;
    std::shuffle(order.begin(), order.end(), m_random);
    z.resize(m_dimension);
    for (int i = 0; i < m_dimension; ++i) {
      const int row = order[i];
      int room = m_factors[row].degree(row) > 3 || m_dimension > 3 ? 1 : 2;
      z[row] = variable(row);
      for (int j = 0; j < i; ++j)
        if (room > 0 && chance(60)) {
          --room;
          matrix[row][order[j]] = fraction(integer(-4, 4), integer(1, 4));
          z[row] += matrix[row][order[j]] * variable(order[j]);
        }
    }
    m_roots.clear();
    visit_combinations([&](const Rational_point& value) {
      Rational_point x(m_dimension);
      for (int row : order) {
        x[row] = value[row];
        for (int j = 0; j < m_dimension; ++j)
          if (matrix[row][j] != Rational(0))
            x[row] -= matrix[row][j] * x[j];
      }
      m_roots.push_back(std::move(x));
    });
    choose_domain();
    return problem("affine", mixed(composed_with(z)));
  }

  // z_i = x_i + c x_{i-1}^2. Coordinates may grow so large that doubles do not see a difference of 1e-9.
  Problem triangular()
  {
    std::vector<Polynomial> z{variable(0)};
    std::vector<Rational> factor{0};
    for (int i = 1; i < m_dimension; ++i) {
      factor.push_back(m_factors[i].degree(i) > 3 ? Rational(0) : fraction(integer(-2, 2), integer(2, 6)));
      z.push_back(variable(i) + factor[i] * square(variable(i - 1)));
    }
    m_roots.clear();
    visit_combinations([&](const Rational_point& value) {
      Rational_point x = value;
      for (int i = 1; i < m_dimension; ++i)
        x[i] -= factor[i] * x[i - 1] * x[i - 1];
      m_roots.push_back(std::move(x));
    });
    choose_domain();
    return problem("triangular", mixed(composed_with(z)));
  }

  Problem separable()
  {
    m_roots.clear();
    visit_combinations([&](const Rational_point& value) { m_roots.push_back(value); });
    choose_domain();
    std::vector<Polynomial> z;
    for (int i = 0; i < m_dimension; ++i)
      z.push_back(variable(i));
    return problem("separable", mixed(composed_with(z)));
  }

  // z_i = x_i up to a break and increases with another slope from there on. The break may be a zero.
  Problem kinked()
  {
    ++splines;
    Rational_point kink, slope;
    for (int i = 0; i < m_dimension; ++i) {
      kink.push_back(chance(40) ? m_zeros[i][0] : number());
      slope.push_back(chance(30) ? Rational(1) : fraction(integer(1, 6), integer(1, 6)));
    }
    m_roots.clear();
    visit_combinations([&](const Rational_point& value) {
      Rational_point x = value;
      for (int i = 0; i < m_dimension; ++i)
        if (x[i] > kink[i])
          x[i] = kink[i] + (x[i] - kink[i]) / slope[i];
      m_roots.push_back(std::move(x));
    });
    choose_domain();
    std::vector<SC::Spline_function> functions;
    for (int i = 0; i < m_dimension; ++i) {
      const auto& [lower, upper] = m_domain[i];
      std::vector<Polynomial> replacement(m_dimension);
      replacement[i] = kink[i] + slope[i] * (variable(i) - kink[i]);
      const Polynomial above = composed(m_factors[i], replacement);
      if (kink[i] <= lower)
        functions.push_back(in_pieces(above, i, {lower, upper}));
      else if (upper <= kink[i])
        functions.push_back(in_pieces(m_factors[i], i, {lower, upper}));
      else
        functions.push_back(piecewise(i, {lower, kink[i], upper}, {m_factors[i], above}));
    }
    return problem("kinked", mixed(functions));
  }
};

static void run(int dimension, int count)
{
  Planted_systems systems(static_cast<unsigned>(1000 + dimension));
  std::size_t planted = 0;
  for (int test = 0; test < count; ++test) {
    const Problem problem = systems.make(dimension);
    SCOPED_TRACE(std::to_string(dimension) + " unknowns, system " + std::to_string(test));
    planted += problem.count;
    check<SC::Certified_solver_traits>(problem, {.tolerance = 1e-12});
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(planted, static_cast<std::size_t>(2 * count));
  EXPECT_GT(systems.on_faces, static_cast<std::size_t>(count / 10));
  EXPECT_TRUE(dimension == 1 || systems.in_corners > static_cast<std::size_t>(count / 20));
  EXPECT_GT(systems.close_pairs, static_cast<std::size_t>(count / 10));
  EXPECT_GT(systems.splines, static_cast<std::size_t>(count / 6));
  EXPECT_GE(systems.highest_degree, dimension > 3 ? 3u : 6u);
}

TEST(Planted_roots, OneUnknown) { run(1, 400); }
TEST(Planted_roots, TwoUnknowns) { run(2, 400); }
TEST(Planted_roots, ThreeUnknowns) { run(3, 400); }
TEST(Planted_roots, FourUnknowns) { run(4, 400); }
TEST(Planted_roots, FiveUnknowns) { run(5, 400); }
