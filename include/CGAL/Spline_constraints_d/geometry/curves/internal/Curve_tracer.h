// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_CURVE_TRACER_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_CURVE_TRACER_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Proper_reparametrization.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Monotone_stretches.h>
#include <CGAL/Spline_constraints_d/geometry/internal/proper_maps.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Proper {

// A range of the parameter of a curve with one map.
struct Curve_part
{
  Exact_rational begin, end;
  Curve_map map;
};

// A polynomial in (t - begin) / (end - begin) as one in t.
inline std::vector<Exact_rational> in_global_parameter(const std::vector<Exact_rational>& f,
                                                       const Exact_rational& begin, const Exact_rational& end)
{
  const Exact_rational slope = Exact_rational(1) / (end - begin), constant = -begin * slope;
  std::vector<Exact_rational> result;
  for (std::size_t k = f.size(); k-- > 0;) {
    result.insert(result.begin(), Exact_rational(0)); // times t slope + constant
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] =
          result[i] * slope + (i + 1 < result.size() ? Exact_rational(result[i + 1] * constant) : Exact_rational(0));
    result[0] += f[k];
  }
  return result;
}

// The numerators of a curve, and the weight, if there is one.
struct Curve_functions
{
  std::vector<Bspline_function<Exact_rational>> functions;
  bool is_rational;
};

// The parts between breaks; successive ones with the same map are one. \throws Invalid_input if one is a point.
inline std::vector<Curve_part> parts_of(const Curve_functions& curve)
{
  const std::vector<Exact_rational> breaks = curve.functions.front().breaks(0);
  std::vector<std::vector<Bernstein_tensor<Exact_rational>>> pieces;
  for (const auto& function : curve.functions)
    pieces.push_back(function.bezier_pieces());
  std::vector<Curve_part> result;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    std::vector<std::vector<Exact_rational>> polynomials;
    for (const auto& of_function : pieces)
      polynomials.push_back(in_global_parameter(of_function[k].power_coefficients(), breaks[k], breaks[k + 1]));
    if (!curve.is_rational)
      polynomials.push_back({Exact_rational(1)});
    Curve_map map = in_lowest_terms(with_integers(polynomials));
    if (degree_of(map) == 0)
      throw Invalid_input("proper_reparametrization: the curve is one point for the parameters from " +
                          std::to_string(to_nearest_double(breaks[k])) + " to " +
                          std::to_string(to_nearest_double(breaks[k + 1])));
    if (!result.empty() && result.back().map == map)
      result.back().end = breaks[k + 1];
    else
      result.push_back({breaks[k], breaks[k + 1], std::move(map)});
  }
  return result;
}

/*
All parts of a curve on the algebraic curves that they are parts of: each of these has one proper map, and each part a
function h into its parameter line. A chart makes the range that is covered there one of finite numbers.
*/
class Curve_tracer
{
public:
  // A component, by the numerators and the weight of its curve.
  struct Component
  {
    std::vector<Bspline_function<Exact_rational>> functions;
    int degree;
    bool is_closed;
    std::vector<Covered_range> coverage;
  };

  struct Result
  {
    std::vector<Component> components;
    std::vector<Curve_stretch> stretches;
  };

private:
  struct Image
  {
    Curve_map map;
    std::optional<Exact_rational> seam = std::nullopt; // a number only if all of the line is covered
  };

  struct Traced_part
  {
    Exact_rational begin, end;
    std::size_t image;
    int index;
    Polynomial_quotient h;
  };

  // Of the extended real line.
  struct Interval
  {
    std::optional<Number_range> lower, upper; // nothing: infinite
  };

  std::vector<Image> m_images;
  std::vector<Traced_part> m_parts;
  Result m_result;
  std::vector<std::size_t> m_image_of_stretch;

public:
  Result operator()(const Curve_functions& curve, Interruption& interruption)
  {
    for (Curve_part& part : parts_of(curve))
      add(std::move(part), interruption);
    for (std::size_t i = 0; i < m_images.size(); ++i)
      choose_chart(i);
    for (const Traced_part& part : m_parts)
      add_stretches(part);
    for (std::size_t i = 0; i < m_images.size(); ++i)
      add_components(i);
    return std::move(m_result);
  }

private:
  void add(Curve_part&& part, Interruption& interruption)
  {
    Proper_map proper = proper_map(part.map, interruption);
    const int index = proper.tracing_index();
    for (std::size_t i = 0; i < m_images.size(); ++i)
      if (const auto between = map_between(m_images[i].map, proper.map, interruption)) {
        m_parts.push_back({part.begin, part.end, i, index, composed(*between, proper.h)});
        return;
      }
    m_parts.push_back({part.begin, part.end, m_images.size(), index, std::move(proper.h)});
    m_images.push_back({std::move(proper.map)});
  }

  static Polynomial_quotient linear_function(const Exact_rational& constant, const Exact_rational& slope)
  {
    std::vector<Integer_coefficients> both = with_integers({{constant, slope}, {Exact_rational(1)}});
    return Polynomial_quotient(std::move(both[0]), std::move(both[1]));
  }

  Monotone_stretches stretches_of(const Traced_part& part) const
  {
    return Monotone_stretches(composed(part.h, linear_function(part.begin, Exact_rational(part.end - part.begin))),
                              m_images[part.image].seam);
  }

  // What h(t) covers: if it is infinite somewhere, another number is sent to infinity that h(t) is not; if there is
  // none, the line is closed.
  void choose_chart(std::size_t image)
  {
    bool is_finite = true;
    std::vector<Interval> covered;
    for (const Traced_part& part : m_parts)
      if (part.image == image) {
        Monotone_stretches stretches = stretches_of(part);
        is_finite = is_finite && !stretches.meets_seam();
        for (std::size_t k = 0; k + 1 < stretches.cuts().size(); ++k) {
          Interval interval{stretches.value_at(k), stretches.value_at(k + 1)};
          if (!stretches.increases_after(k))
            std::swap(interval.lower, interval.upper);
          covered.push_back(std::move(interval));
        }
      }
    if (is_finite)
      return;
    const std::optional<Exact_rational> free_number = number_between(std::move(covered));
    if (!free_number) {
      m_images[image].seam = Exact_rational(-1);
      return;
    }
    // u = x - 1/v, v = 1/(x - u), both increasing
    const std::vector<Integer_coefficients> x = with_integers({{*free_number}, {Exact_rational(1)}});
    const Big_integer &p = x[0].empty() ? Big_integer(0) : x[0][0], &q = x[1][0];
    const Polynomial_quotient back(Integer_coefficients{Big_integer(-q), p}, Integer_coefficients{Big_integer(0), q}),
        chart(Integer_coefficients(1, q), Integer_coefficients{p, Big_integer(-q)});
    m_images[image].map = composed(m_images[image].map, back);
    for (Traced_part& part : m_parts)
      if (part.image == image)
        part.h = composed(chart, part.h);
  }

  // A number in none of the intervals, if there is one.
  static std::optional<Exact_rational> number_between(std::vector<Interval> intervals)
  {
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
      return a.lower && b.lower ? a.lower->first < b.lower->first : !a.lower && b.lower;
    });
    std::optional<Number_range> reached = intervals.front().upper;
    if (intervals.front().lower) { // infinity is reached from below only
      const Exact_rational begin = intervals.front().lower->first;
      return simplest_rational_between(Exact_rational(begin - 2), Exact_rational(begin - 1));
    }
    for (const Interval& interval : intervals) {
      if (!reached)
        return std::nullopt;
      if (interval.lower && interval.lower->first > reached->second) {
        const Exact_rational third = (interval.lower->first - reached->second) / 3;
        return simplest_rational_between(Exact_rational(reached->second + third),
                                         Exact_rational(interval.lower->first - third));
      }
      if (!interval.upper || interval.upper->second > reached->second)
        reached = interval.upper;
    }
    if (!reached)
      return std::nullopt;
    return simplest_rational_between(Exact_rational(reached->second + 1), Exact_rational(reached->second + 2));
  }

  // The parameter of a closed component: u from -1 to 1, and 2 - 1/u, which begins with 1 there and ends with 3 at -1.
  static Number_range closed_parameter(const std::optional<Number_range>& u)
  {
    const auto at = [](const Exact_rational& x) {
      return x >= -1 && x <= 1 ? x : Exact_rational(2 - Exact_rational(1) / x);
    };
    return u ? Number_range(at(u->first), at(u->second)) : Number_range(Exact_rational(2), Exact_rational(2));
  }

  void add_stretches(const Traced_part& part)
  {
    Monotone_stretches stretches = stretches_of(part);
    const bool is_closed = m_images[part.image].seam.has_value();
    std::vector<std::optional<Number_range>> values;
    std::vector<Number_range> parameters;
    for (std::size_t k = 0; k < stretches.cuts().size(); ++k) {
      values.push_back(stretches.value_at(k));
      const Exact_root& root = stretches.cuts()[k].root;
      const auto in_curve = [&](const Exact_rational& x) {
        return Exact_rational(part.begin + x * (part.end - part.begin));
      };
      parameters.emplace_back(in_curve(root.lower()), in_curve(root.upper()));
    }
    for (std::size_t k = 0; k + 1 < values.size(); ++k) {
      const bool is_reversed = !stretches.increases_after(k);
      const auto image = [&](std::size_t cut) {
        if (!is_closed)
          return values[cut].value();
        const bool is_upper_end = (cut == k) == is_reversed;
        const Exact_rational at_seam(is_upper_end ? 3 : -1);
        return stretches.cuts()[cut].is_seam ? Number_range(at_seam, at_seam) : closed_parameter(values[cut]);
      };
      m_result.stretches.push_back(
          {parameters[k], parameters[k + 1], 0, part.index, part.h, image(k), image(k + 1), is_reversed});
      m_image_of_stretch.push_back(part.image);
    }
  }

  static const Number_range& lower_of(const Curve_stretch& s) { return s.is_reversed ? s.image_end : s.image_begin; }
  static const Number_range& upper_of(const Curve_stretch& s) { return s.is_reversed ? s.image_begin : s.image_end; }

  // One for each range of the line that is covered without gaps.
  void add_components(std::size_t image)
  {
    std::vector<Curve_stretch*> stretches;
    for (std::size_t i = 0; i < m_result.stretches.size(); ++i)
      if (m_image_of_stretch[i] == image)
        stretches.push_back(&m_result.stretches[i]);
    std::sort(stretches.begin(), stretches.end(),
              [](const Curve_stretch* a, const Curve_stretch* b) { return lower_of(*a).first < lower_of(*b).first; });
    for (auto first = stretches.begin(); first != stretches.end();) {
      Exact_rational end = upper_of(**first).second;
      auto last = first + 1;
      for (; last != stretches.end() && lower_of(**last).first <= end; ++last)
        end = (std::max)(end, upper_of(**last).second);
      for (auto s = first; s != last; ++s)
        (*s)->component = m_result.components.size();
      m_result.components.push_back({functions_on(m_images[image], {lower_of(**first).first, end}),
                                     static_cast<int>(degree_of(m_images[image].map)), m_images[image].seam.has_value(),
                                     coverage_of({first, last})});
      first = last;
    }
  }

  static std::vector<Covered_range> coverage_of(const std::vector<Curve_stretch*>& stretches)
  {
    std::vector<Number_range> ends;
    for (const Curve_stretch* s : stretches)
      ends.insert(ends.end(), {s->image_begin, s->image_end});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Covered_range> result;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Exact_rational middle = (ends[i].second + ends[i + 1].first) / 2;
      const int times = static_cast<int>(std::count_if(stretches.begin(), stretches.end(), [&](const auto* s) {
        return lower_of(*s).first <= middle && middle <= upper_of(*s).second;
      }));
      if (!result.empty() && result.back().times == times)
        result.back().end = ends[i + 1];
      else
        result.push_back({ends[i], ends[i + 1], times});
    }
    return result;
  }

  // The Bernstein coefficients of a polynomial of a degree, from one number to another.
  static std::vector<Exact_rational> bernstein(Integer_coefficients f, std::size_t degree, const Exact_rational& begin,
                                               const Exact_rational& end)
  {
    f.resize(degree + 1, Big_integer(0));
    std::vector<Exact_rational> powers;
    for (const Big_integer& x : f)
      powers.push_back(scaled_rational(x, 0));
    const std::array<Number_range, 1> range{Number_range(begin, end)};
    return Bernstein_tensor<Exact_rational>::from_power_on_box({static_cast<int>(degree)}, std::move(powers), range)
        .coefficients();
  }

  static std::vector<Bspline_function<Exact_rational>> functions_on(const Image& image, const Number_range& range)
  {
    const std::size_t n = degree_of(image.map);
    std::vector<Exact_rational> knots(n + 1, range.first);
    if (image.seam)
      knots.insert(knots.end(), n, Exact_rational(1));
    knots.insert(knots.end(), n + 1, range.second);
    std::vector<Bspline_function<Exact_rational>> result;
    for (const Integer_coefficients& f : image.map) {
      std::vector<Exact_rational> coefficients;
      if (!image.seam)
        coefficients = bernstein(f, n, range.first, range.second);
      else { // u^n f(1/u) for u = 2 - t, from 1 to -1
        Integer_coefficients reversed = f;
        reversed.resize(n + 1, Big_integer(0));
        std::reverse(reversed.begin(), reversed.end());
        coefficients = bernstein(f, n, Exact_rational(-1), Exact_rational(1));
        const std::vector<Exact_rational> rest = bernstein(reversed, n, Exact_rational(1), Exact_rational(-1));
        coefficients.insert(coefficients.end(), rest.begin() + 1, rest.end());
      }
      result.emplace_back(std::vector<int>{static_cast<int>(n)}, std::vector<std::vector<Exact_rational>>{knots},
                          std::move(coefficients));
    }
    return result;
  }
};

} // namespace Proper
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_CURVE_TRACER_H
