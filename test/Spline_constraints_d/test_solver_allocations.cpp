// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The node loop of the solver takes no memory: what a walk allocates depends on the depth of the subdivision, not on
// the number of its nodes.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <gmp.h>

#include <cstdlib>
#include <new>

static std::size_t allocations = 0;

// Not inlined: the compiler would take malloc and delete for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

// GMP has an allocator of its own.
static void* counting_allocate(std::size_t size)
{
  ++allocations;
  return std::malloc(size);
}

static void* counting_reallocate(void* memory, std::size_t, std::size_t size)
{
  ++allocations;
  return std::realloc(memory, size);
}

static void release(void* memory, std::size_t) { std::free(memory); }

using namespace solver_test;

struct Run
{
  std::size_t nodes, restarts, allocations;
  int depth;
};

// One task of the solver without a limit: longer runs are cut into tasks of thousands of nodes, which take memory of
// their own.
template <class Traits>
static Run walk_and_count(const System& system)
{
  using Number_type = typename Traits::Number_type;
  using Walk = SC::internal::Subdivision<Traits>;
  using Coordinate = typename Walk::Coordinate;
  [[maybe_unused]] const typename SC::Number_traits<Number_type>::Rounding_guard guard;
  const SC::Solver_options options{.tolerance = 1e-14};
  SC::internal::Run_control control(options);
  SC::Summary summary;
  const SC::internal::System_layout layout(system);
  SC::internal::Exact_source source(system, layout);
  SC::internal::Root_collection<Number_type> roots(system, layout, source, options.precision);
  Walk walk(system, layout, source, options, control, roots, summary);
  const std::vector<Coordinate> lower(system.dimension(), Coordinate(-2)), upper(system.dimension(), Coordinate(2));
  const auto task = Walk::make_task(SC::internal::Cell(system.dimension(), 0), lower, upper, 1);
  const std::size_t before = allocations;
  walk.run(task, {.nodes = std::size_t(1) << 40, .looks = 0, .attempts = 0, .open_before = 0, .guesses = 0});
  const std::size_t after = allocations;
  EXPECT_TRUE(walk.open_boxes().empty());
  EXPECT_TRUE(walk.pending().empty());
  EXPECT_TRUE(roots.roots().empty());
  return {summary.nodes, summary.restarts, after - before, summary.depth};
}

// Two curves that run side by side at a distance: nothing to report, and the closer they are the more nodes it takes to
// see that.
static System parallel_circles(int dimension, const Rational& distance)
{
  Polynomial square_of_radius;
  for (const Polynomial& x : variables(dimension))
    square_of_radius += square(x);
  std::vector<Polynomial> functions{square_of_radius - 1, square(square_of_radius) - square(Polynomial(1 + distance))};
  for (int i = 2; i < dimension; ++i)
    functions.push_back(pow(Polynomial::variable(i), 3) - fraction(1, 8) * Polynomial::variable(0));
  return with_equalities(cube(dimension, -2, 2), functions);
}

template <class Traits>
static void expect_independent_of_nodes(int dimension, const Rational& wide, const Rational& narrow)
{
  walk_and_count<Traits>(parallel_circles(dimension, wide));   // what is allocated once for all
  const Run few = walk_and_count<Traits>(parallel_circles(dimension, wide));
  const Run many = walk_and_count<Traits>(parallel_circles(dimension, narrow));
  EXPECT_GT(few.allocations, 0u);
  EXPECT_GT(many.nodes, 20 * few.nodes);
  EXPECT_LE(many.restarts, few.restarts + 2);   // exact coefficients are big integers
  ASSERT_GE(many.depth, few.depth);
  const std::size_t new_levels = many.depth - few.depth + 1;
  EXPECT_LE(many.allocations, few.allocations + 24 * new_levels) << few.nodes << " and " << many.nodes << " nodes";
}

class Solver_allocations : public testing::Test
{
protected:
  static void SetUpTestSuite() { mp_set_memory_functions(counting_allocate, counting_reallocate, release); }
};

TEST_F(Solver_allocations, AreCounted)
{
  const std::size_t before = allocations;
  const Rational number = Rational(1) / Rational(3);
  const std::vector<int> numbers(number == Rational(0) ? 1 : 100);
  EXPECT_GE(allocations, before + 3);
}

TEST_F(Solver_allocations, Doubles)
{
  expect_independent_of_nodes<SC::Certified_solver_traits>(2, fraction(1, 1000), fraction(1, 10000000));
  expect_independent_of_nodes<SC::Certified_solver_traits>(3, fraction(1, 10), fraction(1, 100000));
}

TEST_F(Solver_allocations, Intervals)
{
  expect_independent_of_nodes<SC::Interval_solver_traits>(2, fraction(1, 1000), fraction(1, 10000000));
}

TEST_F(Solver_allocations, OtherPolicies)
{
  using Traits =
      SC::Solver_traits<double, SC::Normal_cone_test, SC::Projected_polyhedron_reduction, SC::Widest_splitter>;
  expect_independent_of_nodes<Traits>(2, fraction(1, 10), fraction(1, 100000));
}
