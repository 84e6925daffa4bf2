// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

// The number that all of an argument of a program is.
template <class Number>
Number number_of(const std::string& argument)
{
  Number result{};
  const char* const last = argument.data() + argument.size();
  const auto [end, error] = std::from_chars(argument.data(), last, result);
  if (error != std::errc() || end != last)
    throw CGAL::Spline_constraints::Invalid_input("the argument '" + argument + "' is no number that is allowed there");
  return result;
}

// The arguments of a program, without `--time-limit S`, which sets an option.
inline std::vector<std::string> arguments_and_time_limit(int argc, char* argv[],
                                                         CGAL::Spline_constraints::Solver_options& options)
{
  std::vector<std::string> words(argv + 1, argv + argc), result;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--time-limit" && i + 1 < words.size())
      options.time_limit = number_of<double>(words[++i]);
    else
      result.push_back(words[i]);
  return result;
}

// What is left of a time limit after a part of the work; a little at least, as zero would be no limit.
inline CGAL::Spline_constraints::Solver_options after(double seconds, CGAL::Spline_constraints::Solver_options options)
{
  if (options.time_limit > 0)
    options.time_limit = std::max(options.time_limit - seconds, 1e-9);
  return options;
}

// The options of the operations of a program, one after the other: the time limit is for all of them together.
class Options_of_program
{
  CGAL::Spline_constraints::Solver_options m_options;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();

public:
  explicit Options_of_program(const CGAL::Spline_constraints::Solver_options& options) : m_options(options) {}

  // With what is left of the time.
  CGAL::Spline_constraints::Solver_options operator()() const
  {
    return after(std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(), m_options);
  }
};

#endif // ARGUMENTS_H
