// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Values as bytes that are the same on every machine and give the same values again, bit by bit: integers and doubles as
the eight bytes of their bits, the lowest first, rationals as fractions in words, ranges of these with their lengths.
*/
class Byte_writer
{
  std::string m_bytes;

public:
  void add(std::integral auto value) { add_bits(static_cast<std::uint64_t>(value)); }
  void add(double value) { add_bits(std::bit_cast<std::uint64_t>(value)); }

  void add(std::string_view text)
  {
    add(text.size());
    m_bytes.append(text);
  }

  void add(const Exact_rational& value)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << value;
    add(std::string_view(text.str()));
  }

  template <class First, class Second>
  void add(const std::pair<First, Second>& value)
  {
    add(value.first);
    add(value.second);
  }

  template <class T>
  void add(const std::vector<T>& values)
  {
    add(values.size());
    for (const T& value : values)
      add(value);
  }

  std::string take() { return std::exchange(m_bytes, {}); }
  std::size_t size() const { return m_bytes.size(); }

private:
  void add_bits(std::uint64_t bits)
  {
    std::array<char, 8> bytes;
    for (int i = 0; i < 8; ++i)
      bytes[i] = static_cast<char>(bits >> (8 * i) & 0xff);
    m_bytes.append(bytes.data(), bytes.size());
  }
};

// Reads what was written, in the same order.
class Byte_reader
{
  std::string_view m_rest;

public:
  explicit Byte_reader(std::string_view bytes) : m_rest(bytes) {}

  template <class T>
  T get()
  {
    T value{};
    read(value);
    return value;
  }

  void read(std::integral auto& value) { value = static_cast<std::remove_reference_t<decltype(value)>>(bits()); }
  void read(double& value) { value = std::bit_cast<double>(bits()); }

  void read(std::string& text) { text = next(get<std::size_t>()); }

  void read(Exact_rational& value)
  {
    std::istringstream text(get<std::string>());
    text.imbue(std::locale::classic());
    text >> value;
  }

  template <class First, class Second>
  void read(std::pair<First, Second>& value)
  {
    read(value.first);
    read(value.second);
  }

  template <class T>
  void read(std::vector<T>& values)
  {
    const std::size_t size = get<std::size_t>();
    values.clear();
    values.reserve((std::min)(size, m_rest.size()));
    for (std::size_t i = 0; i < size; ++i) {
      T value{};
      read(value);
      values.push_back(std::move(value));
    }
  }

  bool is_at_end() const { return m_rest.empty(); }

private:
  std::string_view next(std::size_t size)
  {
    if (m_rest.size() < size)
      throw std::runtime_error("Spline_constraints_d: bytes of an answer are missing");
    const std::string_view result = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return result;
  }

  std::uint64_t bits()
  {
    std::uint64_t result = 0;
    const std::string_view bytes = next(8);
    for (int i = 0; i < 8; ++i)
      result |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H
