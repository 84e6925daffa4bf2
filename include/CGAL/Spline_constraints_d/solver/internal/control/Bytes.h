// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H

#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Values as bytes that are the same on every machine and give the same values again, bit by bit: doubles as the eight
bytes of their bits, the lowest first, integers in as few groups of seven bits as they need, numerators and denominators
of rationals with their lengths in bytes, ranges of these with their lengths.
*/
class Byte_writer
{
  std::string m_bytes; // with room at its end
  std::size_t m_size = 0;

public:
  void add(std::integral auto value)
  {
    std::uint64_t rest = static_cast<std::uint64_t>(value);
    char* place = room_for(10);
    const char* const begin = place;
    for (; rest >= 0x80; rest >>= 7)
      *place++ = static_cast<char>(rest | 0x80);
    *place++ = static_cast<char>(rest);
    m_size += static_cast<std::size_t>(place - begin);
  }

  void add(double value)
  {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    char* const place = room_for(8);
    for (int i = 0; i < 8; ++i)
      place[i] = static_cast<char>(bits >> (8 * i) & 0xff);
    m_size += 8;
  }

  void add(std::string_view text)
  {
    add(text.size());
    append(text);
  }

  // Bytes of another writer.
  void append(std::string_view bytes)
  {
    std::copy(bytes.begin(), bytes.end(), room_for(bytes.size()));
    m_size += bytes.size();
  }

  void add(const Exact_rational& value)
  {
    add_integer(numerator_of(value));
    add_integer(denominator_of(value));
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

  std::string_view bytes() const { return std::string_view(m_bytes).substr(0, m_size); }
  std::size_t size() const { return m_size; }

  // Keeps its memory.
  void clear() { m_size = 0; }

  std::string take()
  {
    m_bytes.resize(std::exchange(m_size, 0));
    return std::exchange(m_bytes, {});
  }

private:
  char* room_for(std::size_t size)
  {
    if (m_bytes.size() - m_size < size)
      m_bytes.resize((std::max)({2 * m_bytes.size(), m_size + size, std::size_t(200)}));
    return m_bytes.data() + m_size;
  }

  void add_integer(const Big_integer& value)
  {
    const std::size_t length = (static_cast<std::size_t>(bit_length(value)) + 7) / 8;
    add(2 * length + static_cast<std::size_t>(value < 0));
    mpz_export(room_for(length), nullptr, -1, 1, 0, 0, value.backend().data());
    m_size += length;
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

  void read(std::integral auto& value)
  {
    std::uint64_t result = 0;
    int shift = 0;
    for (bool goes_on = true; goes_on; shift += 7) {
      const unsigned char group = static_cast<unsigned char>(next(1).front());
      result |= shift < 64 ? static_cast<std::uint64_t>(group & 0x7f) << shift : 0;
      goes_on = group >= 0x80;
    }
    value = static_cast<std::remove_reference_t<decltype(value)>>(result);
  }

  void read(double& value)
  {
    std::uint64_t bits = 0;
    const char* const bytes = next(8).data();
    for (int i = 0; i < 8; ++i)
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    value = std::bit_cast<double>(bits);
  }

  void read(std::string& text) { text = next(get<std::size_t>()); }

  void read(Exact_rational& value)
  {
    const Big_integer numerator = integer(), denominator = integer();
    if (denominator <= 0)
      throw std::runtime_error("Spline_constraints_d: bytes of an answer are wrong");
    value = quotient(numerator, denominator);
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
    for (std::size_t i = 0; i < size; ++i)
      read(values.emplace_back());
  }

  bool is_at_end() const { return m_rest.empty(); }

  // What was not read.
  std::size_t size() const { return m_rest.size(); }

private:
  std::string_view next(std::size_t size)
  {
    if (m_rest.size() < size)
      throw std::runtime_error("Spline_constraints_d: bytes of an answer are missing");
    const std::string_view result = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return result;
  }

  Big_integer integer()
  {
    const std::size_t length_and_sign = get<std::size_t>();
    const std::string_view bytes = next(length_and_sign / 2);
    Big_integer result;
    mpz_import(result.backend().data(), bytes.size(), -1, 1, 0, 0, bytes.data());
    return length_and_sign % 2 == 0 ? result : Big_integer(-result);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_BYTES_H
