// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_JOURNAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_JOURNAL_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Bytes.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Results on the disk: a line that says what work they belong to, then one record for each, with a sum that shows whether
all of it is there. What a run that was ended has left half-written at the end is cut off.
*/
class Journal
{
  std::string m_path;
  std::ofstream m_file;
  Byte_writer m_record;

public:
  // Calls known(task, bytes) for each record that is there. `work` is the same for the same tasks.
  template <class Receiver>
  Journal(const std::string& path, const std::string& work, const Receiver& known) : m_path(path)
  {
    Byte_writer first;
    first.add(std::string_view("Spline_constraints_d journal"));
    first.add(std::string_view(work));
    const std::string beginning = first.take();
    std::string text;
    if (std::ifstream file(path, std::ios::binary); file)
      text.assign(std::istreambuf_iterator<char>(file), {});
    if (!text.empty() && !text.starts_with(beginning))
      throw Invalid_input("journal " + path + ": it is not one of this batch");
    const std::size_t length = text.empty() ? 0 : read_records(text, beginning.size(), known);
    if (length > 0)
      std::filesystem::resize_file(path, length);
    m_file.open(path, std::ios::binary | std::ios::app);
    if (length == 0)
      m_file << beginning;
    m_file.flush();
    if (!m_file)
      throw Invalid_input("journal " + path + ": it cannot be written");
  }

  // It may be lost until flush() is called.
  void add(std::size_t task, std::string_view bytes)
  {
    m_record.clear();
    m_record.add(task);
    m_record.add(bytes);
    m_record.add(sum_of(m_record.bytes()));
    m_file << m_record.bytes();
  }

  void flush()
  {
    m_file.flush();
    if (!m_file)
      throw std::runtime_error("journal " + m_path + ": it cannot be written");
  }

private:
  // Returns how much of the text is complete.
  template <class Receiver>
  static std::size_t read_records(const std::string& text, std::size_t begin, const Receiver& known)
  {
    while (true) {
      try {
        const std::string_view rest = std::string_view(text).substr(begin);
        Byte_reader reader(rest);
        const std::size_t task = reader.get<std::size_t>();
        const std::string bytes = reader.get<std::string>();
        const std::uint64_t sum = sum_of(rest.substr(0, rest.size() - reader.size()));
        if (reader.get<std::uint64_t>() != sum)
          return begin;
        known(task, bytes);
        begin = text.size() - reader.size();
      } catch (const std::runtime_error&) { // the end
        return begin;
      }
    }
  }

  // FNV-1a
  static std::uint64_t sum_of(std::string_view text)
  {
    std::uint64_t sum = 0xcbf29ce484222325;
    for (const char c : text)
      sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return sum;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_JOURNAL_H
