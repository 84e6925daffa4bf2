// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_OUTCOME_OF_TASK_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_OUTCOME_OF_TASK_H

#include <CGAL/Spline_constraints_d/solver/internal/certification/Found_roots.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Answer_bytes.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Bytes.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Subdivision.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What came of a task of a walk.
template <class Coordinate>
struct Outcome_of_task
{
  std::vector<Found_root<Coordinate>> roots;
  std::vector<Open_box<Coordinate>> open, curve_boxes;
  std::vector<Subdivision_task<Coordinate>> pending;
  std::vector<Multiple_root> multiple_roots;
  std::size_t looks = 0, gains = 0;
};

// Outcomes and the work as bytes and back, bit by bit, for other processes.
template <class Coordinate>
class Outcome_bytes
{
  using Outcome = Outcome_of_task<Coordinate>;
  using Task = Subdivision_task<Coordinate>;

public:
  static std::string of(const Outcome& outcome, const Summary& work)
  {
    Byte_writer bytes;
    const auto add_all = [&](const auto& values) {
      bytes.add(values.size());
      for (const auto& value : values)
        write(bytes, value);
    };
    add_all(outcome.roots);
    add_all(outcome.open);
    add_all(outcome.curve_boxes);
    add_all(outcome.pending);
    add_all(outcome.multiple_roots);
    bytes.add(outcome.looks);
    bytes.add(outcome.gains);
    Answer_bytes::write(bytes, work);
    return bytes.take();
  }

  static std::pair<Outcome, Summary> outcome(std::string_view text)
  {
    Byte_reader bytes(text);
    std::pair<Outcome, Summary> result;
    const auto read_all = [&](auto& values) {
      values.resize(bytes.get<std::size_t>());
      for (auto& value : values)
        read(bytes, value);
    };
    Outcome& outcome = result.first;
    read_all(outcome.roots);
    read_all(outcome.open);
    read_all(outcome.curve_boxes);
    read_all(outcome.pending);
    read_all(outcome.multiple_roots);
    bytes.read(outcome.looks);
    bytes.read(outcome.gains);
    result.second = Answer_bytes::summary(bytes);
    return result;
  }

private:
  static void write(Byte_writer& bytes, const Found_root<Coordinate>& root)
  {
    bytes.add(root.enclosure);
    bytes.add(root.region);
    bytes.add(static_cast<int>(root.position));
  }

  static void read(Byte_reader& bytes, Found_root<Coordinate>& root)
  {
    bytes.read(root.enclosure);
    bytes.read(root.region);
    root.position = static_cast<Position>(bytes.get<int>());
  }

  static void write(Byte_writer& bytes, const Open_box<Coordinate>& box)
  {
    bytes.add(box.lower);
    bytes.add(box.upper);
    bytes.add(static_cast<int>(box.reason));
    bytes.add(box.cell);
  }

  static void read(Byte_reader& bytes, Open_box<Coordinate>& box)
  {
    bytes.read(box.lower);
    bytes.read(box.upper);
    box.reason = static_cast<Undecided_reason>(bytes.get<int>());
    bytes.read(box.cell);
  }

  static void write(Byte_writer& bytes, const Task& task)
  {
    bytes.add(task.cell);
    bytes.add(task.lower);
    bytes.add(task.upper);
    bytes.add(task.domain_widths);
    bytes.add(task.depth);
    bytes.add(task.share);
  }

  static void read(Byte_reader& bytes, Task& task)
  {
    bytes.read(task.cell);
    bytes.read(task.lower);
    bytes.read(task.upper);
    bytes.read(task.domain_widths);
    bytes.read(task.depth);
    bytes.read(task.share);
  }

  static void write(Byte_writer& bytes, const Multiple_root& root)
  {
    bytes.add(root.point);
    bytes.add(root.multiplicity);
    bytes.add(root.lower);
    bytes.add(root.upper);
  }

  static void read(Byte_reader& bytes, Multiple_root& root)
  {
    bytes.read(root.point);
    bytes.read(root.multiplicity);
    bytes.read(root.lower);
    bytes.read(root.upper);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_OUTCOME_OF_TASK_H
