// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ANSWER_BYTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ANSWER_BYTES_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Bytes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Answers as bytes and back, with all that they hold, bit by bit.
struct Answer_bytes
{
  template <class Coordinate>
  static std::string of(const Solution_set_d<Coordinate>& set)
  {
    Byte_writer bytes;
    write(bytes, set.m_summary);
    bytes.add(set.m_solutions.size());
    for (const Solution_d<Coordinate>& solution : set.m_solutions)
      write(bytes, solution);
    return bytes.take();
  }

  template <class Coordinate>
  static Solution_set_d<Coordinate> answers(std::string_view bytes)
  {
    Byte_reader reader(bytes);
    Solution_set_d<Coordinate> set;
    set.m_summary = summary(reader);
    const std::size_t size = reader.get<std::size_t>();
    set.m_solutions.reserve((std::min)(size, bytes.size()));
    for (std::size_t i = 0; i < size; ++i)
      read(reader, set.m_solutions.emplace_back());
    return set;
  }

  static void write(Byte_writer& bytes, const Summary& summary)
  {
    bytes.add(summary.nodes);
    bytes.add(summary.restarts);
    bytes.add(summary.depth);
    bytes.add(summary.seconds);
    bytes.add(summary.setup_seconds);
    bytes.add(summary.rebuild_seconds);
    bytes.add(summary.is_complete);
    bytes.add(static_cast<int>(summary.why_not));
  }

  static Summary summary(Byte_reader& bytes)
  {
    Summary result;
    bytes.read(result.nodes);
    bytes.read(result.restarts);
    bytes.read(result.depth);
    bytes.read(result.seconds);
    bytes.read(result.setup_seconds);
    bytes.read(result.rebuild_seconds);
    bytes.read(result.is_complete);
    result.why_not = static_cast<Undecided_reason>(bytes.get<int>());
    return result;
  }

private:
  // Answers point at names that live as long as the program; what travels is their place.
  static constexpr std::array<const char*, 5> names_of_number_types{"", "double", "interval", "multiprecision",
                                                                    "exact"};

  static std::size_t place_of_number_type(std::string_view name)
  {
    const auto place = std::find(names_of_number_types.begin(), names_of_number_types.end(), name);
    return place == names_of_number_types.end() ? 0 : static_cast<std::size_t>(place - names_of_number_types.begin());
  }

  template <class Coordinate>
  static void write(Byte_writer& bytes, const Solution_d<Coordinate>& solution)
  {
    bytes.add(static_cast<int>(solution.m_kind));
    bytes.add(static_cast<int>(solution.m_reason));
    bytes.add(solution.m_multiplicity);
    bytes.add(place_of_number_type(solution.m_number_type));
    bytes.add(solution.m_box);
    bytes.add(solution.m_region);
    bytes.add(solution.m_details != nullptr);
    if (solution.m_details != nullptr) {
      const auto& details = *solution.m_details;
      bytes.add(details.box);
      bytes.add(details.region);
      bytes.add(details.precision);
      bytes.add(details.dimension);
      bytes.add(details.cover);
      bytes.add(details.ends);
    }
  }

  template <class Coordinate>
  static void read(Byte_reader& bytes, Solution_d<Coordinate>& result)
  {
    using Details = typename Solution_d<Coordinate>::Details;
    result.m_kind = static_cast<Solution_kind>(bytes.get<int>());
    result.m_reason = static_cast<Undecided_reason>(bytes.get<int>());
    bytes.read(result.m_multiplicity);
    result.m_number_type = names_of_number_types[bytes.get<std::size_t>() % names_of_number_types.size()];
    bytes.read(result.m_box);
    bytes.read(result.m_region);
    if (bytes.get<bool>()) {
      Details details;
      bytes.read(details.box);
      bytes.read(details.region);
      bytes.read(details.precision);
      bytes.read(details.dimension);
      bytes.read(details.cover);
      bytes.read(details.ends);
      result.m_details = std::make_shared<const Details>(std::move(details));
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ANSWER_BYTES_H
