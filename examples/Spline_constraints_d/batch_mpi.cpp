// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
batch_mpi [columns = 20] [rows = 20] [journal]
mpirun -n 4 batch_mpi 320 320

The workspace of a robot arm with three joints, each axis perpendicular to the one before. With its offsets and lengths
d2, d3, d4, r2, and the second and third angle, the tool is at the distance rho from the first axis, at the height z:

  rho^2 = (d2 + (d3 + d4 cos3) cos2)^2 + (r2 + d4 sin3)^2,   z = -(d3 + d4 cos3) sin2.

For each position of a grid of rho and z, all postures of the arm that reach it are solved for, by all ranks of MPI: 0,
2 or 4. Draws them to batch_mpi.svg, the darker the more; dots are undecided, or lie where postures coincide. With a
journal, a run that was ended goes on where it was.
*/

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/solver/batch_mpi.h>

#include <boost/mpi/environment.hpp>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;

static SC::Constraint_system_d postures(const std::vector<Number>& position)
{
  const Number d2 = 1, d3 = 2, d4 = Number(3) / Number(2), r2 = 1;
  const auto [cos2, sin2, cos3, sin3] = SC::unknowns({-1, 1}, {-1, 1}, {-1, 1}, {-1, 1});
  const auto reach = d3 + d4 * cos3;
  const std::array constraints{square(d2 + reach * cos2) + square(r2 + d4 * sin3) == position[0] * position[0],
                               reach * sin2 == Number(-position[1]), square(cos2) + square(sin2) == 1,
                               square(cos3) + square(sin3) == 1};
  return SC::make_system(constraints);
}

// 0 to 4 postures, or 5: not decided, or some coincide.
static std::size_t class_of(const SC::Solution_set_d<double>& answers)
{
  const std::size_t certified = answers.count(SC::Solution_kind::CERTIFIED);
  return certified == answers.size() && certified <= 4 ? certified : 5;
}

// A row of cells of one class is one rectangle.
static void draw(const std::vector<std::size_t>& classes, std::size_t columns, std::size_t rows)
{
  constexpr std::array colours{"#ffffff", "#e0e0e0", "#a8c8e8", "#7090c0", "#305890", "#c02020"};
  std::ofstream file("batch_mpi.svg");
  file << "<svg xmlns='http://www.w3.org/2000/svg' width='500' height='640' viewBox='0 0 " << columns << ' ' << rows
       << "' preserveAspectRatio='none' shape-rendering='crispEdges'>\n";
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t begin = 0, end = 0; begin < columns; begin = end) {
      const auto class_at = [&](std::size_t column) { return classes[column * rows + row]; };
      while (end < columns && class_at(end) == class_at(begin))
        ++end;
      file << "<rect x='" << begin << "' y='" << rows - 1 - row << "' width='" << end - begin << "' height='1' fill='"
           << colours[class_at(begin)] << "'/>\n";
    }
  file << "</svg>\n";
}

// Tells rank 0 how much is done; it could stop all ranks as well.
struct Progress
{
  void on_progress(double share) { std::cerr << static_cast<int>(100 * share) << " %\r" << std::flush; }
  bool stop() const { return false; }
};

int main(int count, char** arguments)
{
  boost::mpi::environment environment(count, arguments);
  const boost::mpi::communicator world;
  const std::size_t columns = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 20,
                    rows = count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 20;

  SC::Mpi_report report;
  Progress progress;
  try {
    const SC::Parameter_grid positions({{Number(1) / 100, 5, columns}, {-Number(399) / 100, 4, rows}});
    const SC::Mpi_options options{.solver = {.visitor = progress}, .journal = count > 3 ? arguments[3] : ""};
    const auto answers = SC::solve_batch_mpi(world, positions, postures, options, &report);
    if (world.rank() == 0) {
      std::array<std::size_t, 6> counts{};
      std::vector<std::size_t> classes;
      for (const auto& of_position : answers) {
        classes.push_back(class_of(of_position));
        ++counts[classes.back()];
      }
      draw(classes, columns, rows);
      std::cout << answers.size() << " positions: " << counts[0] << " with no posture, " << counts[2] << " with 2, "
                << counts[4] << " with 4, " << counts[1] + counts[3] + counts[5] << " others\n";
      for (int rank = 0; rank < world.size(); ++rank)
        std::cout << "rank " << rank << ": " << report.tasks[rank] << " systems, " << report.busy_seconds[rank]
                  << " s of the processor\n";
      std::cout << report.seconds << " s" << std::endl;
    }
  } catch (const SC::Invalid_input& error) {
    if (world.rank() == 0)
      std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  exit_after_mpi(report);
  return EXIT_SUCCESS;
}
