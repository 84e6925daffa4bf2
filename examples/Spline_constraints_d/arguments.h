// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <charconv>
#include <string>
#include <system_error>

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

#endif // ARGUMENTS_H
