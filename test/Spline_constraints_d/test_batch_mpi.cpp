// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
What the ranks of MPI find together is what one finds alone, bit by bit. It runs as any number of ranks, also without
`mpirun`. With an argument --dying-... the last rank kills itself in the middle.
*/

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/batch.h>
#include <CGAL/Spline_constraints_d/solver/batch_mpi.h>

#include <boost/mpi/environment.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

using namespace solver_test;
namespace mpi = boost::mpi;
using SC::run_tasks_mpi;
using SC::solve_batch_mpi;
using SC::internal::Answer_bytes;
using Answers = SC::Solution_set_d<double>;

// All that an answer holds, but the seconds.
static std::string bits_of(Answers answers)
{
  SC::Summary summary = answers.summary();
  summary.seconds = summary.setup_seconds = summary.rebuild_seconds = 0;
  return Answer_bytes::of(Answers(std::move(answers).solutions(), summary));
}

static void expect_equal(const std::vector<Answers>& found, const std::vector<Answers>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(bits_of(found[i]), bits_of(expected[i])) << "system " << i;
}

// Circles of many sizes and a cubic curve: they cross in up to six points.
static System circle_and_cubic(const std::vector<Rational>& parameters)
{
  const std::vector<Polynomial> x = variables(2);
  System system = cube(2, -4, 4);
  system.add(square(x[0]) + square(x[1]) - parameters[0] * parameters[0], Relation::EQUAL);
  system.add(x[1] - x[0] * x[0] * x[0] - parameters[1], Relation::EQUAL);
  return system;
}

static SC::Parameter_grid many_parameters() { return SC::Parameter_grid({{0, 3, 13}, {fraction(-3, 2), 3, 19}}); }

static std::vector<System> systems_of(const SC::Parameter_grid& grid)
{
  std::vector<System> systems;
  for (std::size_t i = 0; i < grid.size(); ++i)
    systems.push_back(circle_and_cubic(grid[i]));
  return systems;
}

// Of all kinds of answers: certified in doubles and with more precision, clusters, continua, undecided ones.
static std::vector<System> systems_of_all_kinds()
{
  const std::vector<Polynomial> x = variables(2);
  const Rational tiny = Rational(1) / Rational(1e15);
  std::vector<System> systems{cyclic_chebyshev(2, 3).system, zigzag().system, circle_and_ellipse().system,
                              lines_tangent_to_spheres().system};
  systems.push_back(with_equalities(cube(2, -2, 3), {x[1] - square(x[0]), x[1] - 2 * x[0] + 1}));
  systems.push_back(with_equalities(cube(2, -2, 3), {(x[0] - x[1]) * (x[0] - 1), (x[0] - x[1]) * (x[1] + 1)}));
  systems.push_back(with_equalities(cube(2, -2, 3), {x[1] - square(x[0]), x[1] - tiny * tiny}));
  systems.push_back(with_equalities(cube(2, -2, 3), {pow(x[0], 3) - 2, pow(x[1], 3) - 3 * x[0]}));
  return systems;
}

TEST(Batch_mpi, BytesHoldAllOfAnAnswer)
{
  std::map<Solution_kind, int> kinds;
  int finer = 0;
  for (const System& system : systems_of_all_kinds()) {
    const Answers answers = solve(system);
    const Answers read = Answer_bytes::answers<double>(Answer_bytes::of(answers));
    EXPECT_EQ(Answer_bytes::of(read), Answer_bytes::of(answers));
    EXPECT_EQ(read.summary().nodes, answers.summary().nodes);
    EXPECT_EQ(read.summary().seconds, answers.summary().seconds);
    EXPECT_EQ(read.is_complete(), answers.is_complete());
    ASSERT_EQ(read.size(), answers.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      ++kinds[answers[i].kind()];
      finer += answers[i].precision() > 0;
      EXPECT_EQ(read[i].kind(), answers[i].kind());
      EXPECT_EQ(read[i].reason(), answers[i].reason());
      EXPECT_EQ(read[i].multiplicity(), answers[i].multiplicity());
      EXPECT_EQ(read[i].number_type(), std::string_view(answers[i].number_type()));
      EXPECT_EQ(read[i].precision(), answers[i].precision());
      EXPECT_EQ(read[i].dimension(), answers[i].dimension());
      EXPECT_EQ(read[i].box(), answers[i].box());
      EXPECT_EQ(read[i].exact_box(), answers[i].exact_box());
      EXPECT_EQ(read[i].exact_uniqueness_region(), answers[i].exact_uniqueness_region());
      EXPECT_EQ(read[i].cover(), answers[i].cover());
      EXPECT_EQ(read[i].ends(), answers[i].ends());
    }
    for (const std::size_t end : {std::size_t(0), std::size_t(9), Answer_bytes::of(answers).size() - 1})
      EXPECT_THROW(Answer_bytes::answers<double>(Answer_bytes::of(answers).substr(0, end)), std::runtime_error);
  }
  EXPECT_GE(kinds[Solution_kind::CERTIFIED], 20);
  EXPECT_GE(kinds[Solution_kind::CLUSTER], 1);
  EXPECT_GE(kinds[Solution_kind::CONTINUUM], 1);
  EXPECT_GE(finer, 2);
}

// However tasks are dealt out, given back and done twice, each counts once.
TEST(Batch_mpi, EveryTaskCountsOnce)
{
  std::mt19937 random(7);
  for (int run = 0; run < 50; ++run) {
    const std::size_t count = random() % 400;
    SC::internal::Task_dealer dealer(count, 1 + random() % 5);
    std::vector<std::size_t> dealt, sizes;
    std::multiset<std::size_t> counted;
    while (!dealer.is_finished()) {
      const std::vector<std::size_t> packet = dealer.next_packet();
      if (!packet.empty())
        sizes.push_back(packet.size());
      dealt.insert(dealt.end(), packet.begin(), packet.end());
      for (int k = 0; k < 5 && !dealt.empty(); ++k) {
        const std::size_t task = dealt[random() % dealt.size()];
        if (random() % 3 == 0)
          dealer.give_back(task);
        else if (dealer.mark_as_done(task))
          counted.insert(task);
      }
    }
    EXPECT_EQ(counted.size(), count);
    EXPECT_EQ(std::set<std::size_t>(counted.begin(), counted.end()).size(), count);
  }
}

// The sizes of the packets, if each task takes so long and all are done at once.
static std::vector<std::size_t> sizes_of_packets(std::size_t count, double seconds)
{
  SC::internal::Task_dealer dealer(count, 2);
  std::vector<std::size_t> sizes;
  while (!dealer.is_finished()) {
    const std::vector<std::size_t> packet = dealer.next_packet();
    EXPECT_FALSE(packet.empty());
    for (const std::size_t task : packet)
      EXPECT_TRUE(dealer.mark_as_done(task));
    dealer.add_time(packet.size(), seconds * static_cast<double>(packet.size()));
    sizes.push_back(packet.size());
  }
  return sizes;
}

// Before the time of tasks is known packets are short; then they are a share of the rest, in the limits of time.
TEST(Batch_mpi, PacketsHaveTheSizeOfTheirTime)
{
  const std::vector<std::size_t> short_tasks = sizes_of_packets(10000, 0x1p-17);
  EXPECT_EQ(short_tasks[0], 16u);
  EXPECT_EQ(short_tasks[1], 9984u / 16);
  EXPECT_TRUE(std::is_sorted(short_tasks.rbegin(), short_tasks.rend() - 1));
  EXPECT_TRUE(std::all_of(short_tasks.begin() + 1, short_tasks.end() - 1, [](std::size_t n) { return n >= 26; }));
  EXPECT_EQ(sizes_of_packets(10000, 0x1p-27), (std::vector<std::size_t>{16, 9984}));
  const std::vector<std::size_t> long_tasks = sizes_of_packets(10000, 0.25), single_tasks = sizes_of_packets(50, 3);
  EXPECT_EQ(long_tasks[1], 4u);
  EXPECT_EQ(long_tasks.back(), 1u);
  EXPECT_EQ(std::accumulate(long_tasks.begin(), long_tasks.end(), std::size_t(0)), 10000u);
  EXPECT_EQ(std::count(single_tasks.begin() + 1, single_tasks.end(), std::size_t(1)), 47);

  SC::internal::Task_dealer dealer(1000, 2); // what a rank has not done is dealt out in packets as well
  for (std::size_t all = 0; all < 1000;)
    all += dealer.next_packet().size();
  EXPECT_TRUE(dealer.next_packet().empty());
  for (std::size_t task = 0; task < 1000; ++task)
    dealer.give_back(task);
  dealer.add_time(100, 0.1);
  EXPECT_EQ(dealer.next_packet().size(), 62u);
  dealer.drop_from(0);
  EXPECT_TRUE(dealer.next_packet().empty());
  EXPECT_TRUE(dealer.is_finished());
}

// Numbers of all sizes and signs.
TEST(Batch_mpi, BytesHoldNumbers)
{
  std::mt19937_64 random(5);
  for (int run = 0; run < 300; ++run) {
    const int shift = static_cast<int>(random() % 64), bits = static_cast<int>(random() % 400);
    const std::uint64_t size = random() >> shift;
    const std::int64_t number = -static_cast<std::int64_t>(size >> 1);
    const double real =
        std::ldexp(static_cast<double>(random() % 1000) - 500, static_cast<int>(random() % 2000) - 1000);
    Rational power(1), fine(random() >> 12);
    for (int k = 0; k < bits; ++k)
      power *= 2;
    fine = (fine - Rational(1 << 30)) * (run % 2 == 0 ? power : Rational(1 / power)) / (run % 3 == 0 ? 7 : 1);
    SC::internal::Byte_writer bytes;
    bytes.add(size);
    bytes.add(number);
    bytes.add(real);
    bytes.add(std::vector<Rational>{fine, Rational(0), Rational(real)});
    bytes.add(std::vector<int>{-1, run});
    const std::string text = bytes.take();
    SC::internal::Byte_reader reader(text);
    EXPECT_EQ(reader.get<std::uint64_t>(), size);
    EXPECT_EQ(reader.get<std::int64_t>(), number);
    EXPECT_EQ(reader.get<double>(), real);
    EXPECT_EQ(reader.get<std::vector<Rational>>(), (std::vector<Rational>{fine, Rational(0), Rational(real)}));
    EXPECT_EQ(reader.get<std::vector<int>>(), (std::vector<int>{-1, run}));
    EXPECT_TRUE(reader.is_at_end());
  }
}

TEST(Batch_mpi, GridOfParameters)
{
  const SC::Parameter_grid grid({{0, 1, 3}, {5, 7, 1}, {-1, 2, 4}});
  ASSERT_EQ(grid.size(), 12u);
  EXPECT_EQ(grid[0], (std::vector<Rational>{0, 5, -1}));
  EXPECT_EQ(grid[3], (std::vector<Rational>{0, 5, 2}));
  EXPECT_EQ(grid[4], (std::vector<Rational>{fraction(1, 2), 5, -1}));
  EXPECT_EQ(grid[11], (std::vector<Rational>{1, 5, 2}));
  EXPECT_EQ(SC::Parameter_grid({{0, 1, 4}})[1][0], fraction(1, 3));
  EXPECT_THROW(SC::Parameter_grid({{0, 1, 0}}), SC::Invalid_input);
}

TEST(Batch_mpi, AnswersOfOneRank)
{
  const mpi::communicator world;
  const SC::Parameter_grid grid = many_parameters();
  SC::Mpi_report report;
  const auto found = solve_batch_mpi(world, grid, circle_and_cubic, {}, &report);
  const auto of_range = solve_batch_mpi(world, systems_of_all_kinds());
  EXPECT_TRUE(solve_batch_mpi(world, std::vector<System>()).empty());
  if (world.rank() != 0) {
    EXPECT_TRUE(found.empty());
    return;
  }
  expect_equal(found, solve(systems_of(grid)));
  expect_equal(of_range, solve(systems_of_all_kinds()));
  EXPECT_EQ(std::accumulate(report.tasks.begin(), report.tasks.end(), std::size_t(0)), grid.size());
  EXPECT_TRUE(report.lost.empty());
  EXPECT_GT(report.seconds, 0);
  EXPECT_EQ(report.tasks.size(), static_cast<std::size_t>(world.size()));
}

TEST(Batch_mpi, InvalidInputNamesTheSystemOnAllRanks)
{
  const mpi::communicator world;
  std::vector<System> systems = systems_of(SC::Parameter_grid({{1, 2, 20}, {0, 1, 10}}));
  systems[77] = systems[150] = cube(2, 0, 1);
  try {
    solve_batch_mpi(world, systems);
    ADD_FAILURE() << "no exception";
  } catch (const SC::Invalid_input& error) {
    EXPECT_EQ(std::string(error.what()).find("system 77 of a batch: "), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find("0 equalities for 2 unknowns"), std::string::npos) << error.what();
  }
  const auto without_system = [](std::size_t) -> System { throw std::out_of_range("no such system"); };
  EXPECT_THROW(solve_batch_mpi(world, 3, without_system), std::runtime_error);
  EXPECT_THROW(solve_batch_mpi(world, systems, {.silence = 0}), SC::Invalid_input);
  EXPECT_THROW(solve_batch_mpi(world, systems, {.solver = {.tolerance = -1}}), SC::Invalid_input);
  EXPECT_THROW(solve_mpi(world, cube(2, 0, 1)), SC::Invalid_input);
}

// Many tasks that take next to nothing in one packet, and between them some that take longer than all others: each
// result comes once.
TEST(Batch_mpi, TasksOfVeryDifferentCost)
{
  const mpi::communicator world;
  constexpr std::size_t count = 20000;
  std::vector<int> received(count, 0);
  SC::Mpi_report report;
  run_tasks_mpi(
      world, count,
      [&](std::size_t i, const SC::Visitor_reference& visitor) {
        if (i % 2500 == 100)
          for (int k = 0; k < 20 && !visitor.stop(); ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
        return std::to_string(3 * i);
      },
      [&](std::size_t i, const std::string& text) { received[i] += text == std::to_string(3 * i) ? 1 : 100; }, {},
      "tasks of very different cost", &report);
  if (world.rank() != 0)
    return;
  EXPECT_EQ(std::count(received.begin(), received.end(), 1), static_cast<std::ptrdiff_t>(count));
  EXPECT_EQ(std::accumulate(report.tasks.begin(), report.tasks.end(), std::size_t(0)), count);
  EXPECT_EQ(report.repeated, 0u);
}

// Is told of the progress, and stops at a share of it.
struct Stops_at
{
  double share;
  double last = 0;
  int calls = 0;
  bool stop() const { return last >= share; }
  void on_progress(double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
    ++calls;
  }
};

// A second start goes on where the first one was stopped, also when a record is torn.
TEST(Batch_mpi, JournalAfterAStop)
{
  const mpi::communicator world;
  const std::vector<System> systems(150, cyclic_chebyshev(2, 4).system);
  const std::string path =
      (std::filesystem::temp_directory_path() / ("journal_of_" + std::to_string(getpid()))).string();
  if (world.rank() == 0)
    std::filesystem::remove(path);
  Stops_at visitor{0.3};
  SC::Mpi_report report;
  const auto slow_system = [&](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    return systems[i];
  };
  const auto stopped = solve_batch_mpi(world, systems.size(), slow_system,
                                       {.solver = {.visitor = visitor}, .journal = path}, &report);
  const Answers expected = solve(systems[0]);
  if (world.rank() == 0) {
    ASSERT_EQ(stopped.size(), systems.size());
    EXPECT_TRUE(stopped.front().is_complete());
    EXPECT_EQ(stopped.back().summary().why_not, SC::Undecided_reason::STOPPED);
    EXPECT_GE(visitor.calls, 1);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
  }
  const auto found = solve_batch_mpi(world, systems, {.journal = path}, &report);
  const auto again = solve_batch_mpi(world, systems, {.journal = path});
  if (world.rank() == 0) {
    EXPECT_GE(report.from_journal, 40u);
    EXPECT_LT(report.from_journal, 150u);
    for (const auto& answers : {found, again}) {
      ASSERT_EQ(answers.size(), systems.size());
      for (const Answers& one : answers)
        EXPECT_EQ(bits_of(one), bits_of(expected));
    }
  }
  EXPECT_THROW(solve_batch_mpi(world, std::vector<System>(3, systems[0]), {.journal = path}), SC::Invalid_input);
  if (world.rank() == 0)
    std::filesystem::remove(path);
}

TEST(Batch_mpi, BoxesOfOneSystem)
{
  const mpi::communicator world;
  for (const Problem& problem : {cyclic_chebyshev(3, 4), mixed_chebyshev(3, 3), lines_tangent_to_spheres(),
                                 cyclic_chebyshev_in_pieces(4), zigzag(), brown(5, 10)}) {
    SCOPED_TRACE(problem.name);
    SC::Mpi_report report;
    const Answers found = solve_mpi(world, problem.system, {}, &report);
    if (world.rank() == 0) {
      expect_solved(problem, found);
      EXPECT_EQ(bits_of(found), bits_of(solve(problem.system)));
    } else
      EXPECT_TRUE(found.empty());
  }
  SC::Mpi_report report;
  const System system = cyclic_chebyshev(8, 2).system;
  const Answers limited = solve_mpi(world, system, {.solver = {.node_limit = 1000}});
  Stops_at at_once{0};
  const Answers stopped = solve_mpi(world, system, {.solver = {.visitor = at_once}});
  const Answers in_time = solve_mpi(world, system, {.solver = {.time_limit = 1e-9}}, &report);
  if (world.rank() == 0) {
    EXPECT_EQ(bits_of(limited), bits_of(solve(system, {.node_limit = 1000})));
    EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
    EXPECT_EQ(in_time.summary().why_not, SC::Undecided_reason::TIME);
  }
}

TEST(Batch_mpi, TasksOfAnyKind)
{
  const mpi::communicator world;
  std::vector<std::string> received(300);
  SC::Mpi_report report;
  std::size_t count = 0;
  const auto text_of = [](std::size_t i) { return std::string(i * 77 % 5000, 'x') + std::to_string(i); };
  run_tasks_mpi(
      world, received.size(),
      [&](std::size_t i, const SC::Visitor_reference&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return text_of(i);
      },
      [&](std::size_t i, const std::string& text) {
        received[i] = text;
        ++count;
      },
      {}, "texts", &report);
  if (world.rank() != 0)
    return;
  EXPECT_EQ(count, received.size());
  for (std::size_t i = 0; i < received.size(); ++i)
    EXPECT_EQ(received[i], text_of(i));
  for (const std::size_t tasks : report.tasks)
    EXPECT_GT(tasks, 0u);
}

static void report_losses(bool is_equal, const SC::Mpi_report& report)
{
  if (mpi::communicator().rank() == 0)
    std::cout << (is_equal ? "all answers are there" : "answers are missing") << ", " << report.lost.size()
              << " rank lost, " << (report.repeated > 0 ? "some" : "no") << " tasks dealt out again" << std::endl;
  exit_after_mpi(report);
}

// The last rank is killed in the midst of a packet, of which it has sent the first answers since the fifth system took
// long; all answers are there.
static int die_in_a_batch()
{
  const mpi::communicator world;
  const SC::Parameter_grid grid = many_parameters();
  int mine = 0;
  SC::Mpi_report report;
  const auto found = solve_batch_mpi(
      world, grid,
      [&](const std::vector<Rational>& parameters) {
        if (world.rank() == world.size() - 1 && ++mine == 5)
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
        if (mine == 8)
          std::raise(SIGKILL);
        return circle_and_cubic(parameters);
      },
      {.silence = 1.5}, &report);
  const auto expected = solve(systems_of(grid));
  bool is_equal = found.size() == expected.size();
  for (std::size_t i = 0; is_equal && i < found.size(); ++i)
    is_equal = bits_of(found[i]) == bits_of(expected[i]);
  report_losses(is_equal, report);
  return 0;
}

// The last rank is killed while it works on the boxes of a system.
static int die_in_a_box()
{
  const mpi::communicator world;
  const System system = mixed_chebyshev(4, 5).system;
  if (world.rank() == world.size() - 1)
    std::thread([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      std::raise(SIGKILL);
    }).detach();
  SC::Mpi_report report;
  const Answers found = solve_mpi(world, system, {.silence = 1.5}, &report);
  report_losses(world.rank() == 0 && bits_of(found) == bits_of(solve(system)), report);
  return 0;
}

int main(int count, char** arguments)
{
  mpi::environment environment(count, arguments);
  if (count > 1 && std::string_view(arguments[1]) == "--dying-in-a-batch")
    return die_in_a_batch();
  if (count > 1 && std::string_view(arguments[1]) == "--dying-in-a-box")
    return die_in_a_box();
  testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}
