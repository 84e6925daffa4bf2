// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The systems that are shipped with the examples have as many solutions as their first line says. Runs in its own
// folder.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/IO/read_minibex.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace shipped_systems_test {

using namespace solver_test;

static std::vector<std::filesystem::path> files()
{
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator("../../examples/Spline_constraints_d/data"))
    if (entry.path().extension() == ".bch")
      result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

static Problem read(const std::filesystem::path& path)
{
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  const std::string announcement = "// real roots: ";
  if (!line.starts_with(announcement))
    throw std::runtime_error(path.string() + " does not say how many real roots there are");
  const SC::Minibex_system input = SC::read_minibex(path.string());
  System system(input.domains);
  for (const auto& constraint : input.constraints)
    system.add(constraint.function, constraint.relation);
  return {path.filename().string(), std::move(system), std::stoul(line.substr(announcement.size())), {}};
}

TEST(Shipped_systems, AreThere) { EXPECT_GE(files().size(), 14u); }

TEST(Shipped_systems, HaveAllTheirSolutions)
{
  for (const auto& path : files())
    check<SC::Certified_solver_traits>(read(path));
}

TEST(Shipped_systems, OneInExactArithmetic)
{
  check<SC::Exact_solver_traits>(read("../../examples/Spline_constraints_d/data/trilateration.bch"));
}

} // namespace shipped_systems_test
