// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PRINTED_NUMBERS_H
#define PRINTED_NUMBERS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>

using CGAL::Spline_constraints::Exact_rational;

// A power of ten.
inline Exact_rational ten_to(int exponent)
{
  Exact_rational result(1);
  for (int i = 0; i < std::abs(exponent); ++i)
    result *= 10;
  return exponent < 0 ? Exact_rational(1 / result) : result;
}

// The exponent of the first digit of a positive number.
inline int first_digit_of(const Exact_rational& x)
{
  int result = static_cast<int>(std::floor(std::log10(CGAL::Spline_constraints::to_nearest_double(x))));
  while (x < ten_to(result))
    --result;
  while (x >= ten_to(result + 1))
    ++result;
  return result;
}

// A number, rounded to so many significant digits, without zeros at the end.
inline std::string with_digits(const Exact_rational& x, int digits)
{
  if (x == 0)
    return "0";
  Exact_rational rest = CGAL::abs(x);
  int first = first_digit_of(rest);
  const int last = first - digits + 1;
  rest += ten_to(last) / 2;
  first = first_digit_of(rest);
  std::string text;
  for (int place = first; place >= last; --place) {
    const Exact_rational unit = ten_to(place);
    char digit = '0';
    for (; rest >= unit; rest -= unit)
      ++digit;
    text += digit;
  }
  text.erase(text.find_last_not_of('0') + 1);
  const int count = static_cast<int>(text.size());
  constexpr int most_zeros = 4, most_places = 17;
  if (first < -most_zeros || first >= most_places)
    text = text.substr(0, 1) + (count > 1 ? '.' + text.substr(1) : "") + 'e' + std::to_string(first);
  else if (first < 0)
    text = "0." + std::string(static_cast<std::size_t>(-first - 1), '0') + text;
  else if (count <= first + 1)
    text += std::string(static_cast<std::size_t>(first + 1 - count), '0');
  else
    text.insert(static_cast<std::size_t>(first + 1), ".");
  return (x < 0 ? "-" : "") + text;
}

// A number between two bounds, with the digits that are certain, at most 17: it is not farther from what is printed
// than one unit of the last digit. All digits of a number that is known exactly, if they are not more.
inline std::string number_within(const std::pair<Exact_rational, Exact_rational>& bounds)
{
  constexpr int most_digits = 17;
  const Exact_rational middle((bounds.first + bounds.second) / 2), width(bounds.second - bounds.first);
  if (width == 0)
    return with_digits(middle, most_digits);
  // the rounding, and half of the width, are one half of the last digit at most each
  const int digits = middle == 0 ? 0 : first_digit_of(CGAL::abs(middle)) - first_digit_of(width);
  return digits < 1 ? "between " + with_digits(bounds.first, 2) + " and " + with_digits(bounds.second, 2)
                    : with_digits(middle, std::min(digits, most_digits));
}

// A double as it is: with the least digits that tell it from others.
inline std::string number_of_double(double x) { return CGAL::Spline_constraints::internal::shortest_text(x); }

// A number that is known up to an error.
inline std::string number_up_to(double x, double error)
{
  const Exact_rational middle = CGAL::Spline_constraints::to_rational(x),
                       reach = CGAL::Spline_constraints::to_rational(error);
  return number_within({Exact_rational(middle - reach), Exact_rational(middle + reach)});
}

// How a number between bounds is known.
inline std::string difference_of(const std::pair<Exact_rational, Exact_rational>& bounds)
{
  const Exact_rational width(bounds.second - bounds.first);
  return width == 0 ? "exact" : "bounds differ by " + with_digits(width, 2);
}

#endif // PRINTED_NUMBERS_H
