// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_ARRANGEMENT_TEST_TOOLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_ARRANGEMENT_TEST_TOOLS_H

#include <CGAL/version.h>

// The variants that traits classes of arrangements write: those of Boost before CGAL 6.
#if CGAL_VERSION_NR < 1060000000
#include <boost/variant.hpp>

template <class... Types>
using Variant = boost::variant<Types...>;

template <class Type, class... Types>
const Type* get_if(const boost::variant<Types...>* variant)
{
  return boost::get<Type>(variant);
}
#else
#include <variant>

template <class... Types>
using Variant = std::variant<Types...>;
using std::get_if;
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_ARRANGEMENT_TEST_TOOLS_H
