// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_MINIBEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_MINIBEX_H

#include <CGAL/Spline_constraints_d/IO/Minibex_system.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// Number of unknowns from `first` on that are the elements base(1), base(2), ... of one array; 0 when `first` is not an
// array's beginning.
std::size_t array_size(const Minibex_system& system, std::size_t first);

bool is_name(const std::string& text);

inline std::string interval_text(const std::pair<Exact_rational, Exact_rational>& interval)
{
  return '[' + Power_polynomial(interval.first).to_string() + ", " + Power_polynomial(interval.second).to_string() +
      ']';
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t array_size(const Minibex_system& system, std::size_t first)
{
  const std::string& name = system.names[first];
  if (name.size() < 4 || name.substr(name.size() - 3) != "(1)")
    return 0;
  const std::string base = name.substr(0, name.size() - 2);
  std::size_t size = 1;
  while (first + size < system.names.size() && system.names[first + size] == base + std::to_string(size + 1) + ')')
    ++size;
  return size;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_name(const std::string& text)
{
  const char* const letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  return !text.empty() && std::string(letters).find(text[0]) != std::string::npos &&
      text.find_first_not_of(std::string(letters) + "0123456789") == std::string::npos;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIO

writes a system as a Minibex file that `read_minibex()` reads back exactly: the same names, domains, functions and
relations.

\throws Invalid_input when a name is neither an identifier nor in place as an element `x(1)`, `x(2)`, ... of an array,
when there are
        no unknowns or no constraints, when names and domains differ in number, when a function has an unknown without a
        name, or when a relation is `NOT_EQUAL`, which the language does not have.
*/
void write_minibex(std::ostream& out, const Minibex_system& system);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void write_minibex(std::ostream& out, const Minibex_system& system)
{
  if (system.names.empty() || system.constraints.empty())
    throw Invalid_input("write_minibex: no unknowns or no constraints");
  if (system.names.size() != system.domains.size())
    throw Invalid_input("write_minibex: names and domains differ in number");
  std::string text = "Variables\n";
  for (std::size_t i = 0; i < system.names.size();) {
    const std::size_t size = internal::array_size(system, i);
    const std::string name = size == 0 ? system.names[i] : system.names[i].substr(0, system.names[i].size() - 3);
    if (!internal::is_name(name))
      throw Invalid_input("write_minibex: the name '" + system.names[i] + "' of unknown " + std::to_string(i) +
                          " is not an identifier");
    text += "  " + name + (size == 0 ? "" : '[' + std::to_string(size) + ']') + " in " + (size == 0 ? "" : "(");
    for (std::size_t j = 0; j < (size == 0 ? 1 : size); ++j, ++i)
      text += (j == 0 ? "" : "; ") + internal::interval_text(system.domains[i]);
    text += size == 0 ? ";\n" : ");\n";
  }
  text += "Constraints\n";
  for (const Minibex_constraint& constraint : system.constraints) {
    if (constraint.relation == Relation::NOT_EQUAL)
      throw Invalid_input("write_minibex: the relation != cannot be written");
    text += "  " + system.values.text(constraint.function, system.names) + ' ' + symbol(constraint.relation) + " 0;\n";
  }
  out << text << "end\n";
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_MINIBEX_H
