// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Short names for tests of curves on exact surfaces.

#ifndef TEST_SURFACE_TEST_NAMES_H
#define TEST_SURFACE_TEST_NAMES_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Surface = SC::Bspline_surface_3<K>;

inline double length(const Vector& v) { return std::sqrt(CGAL::to_double(v.squared_length())); }

#endif // TEST_SURFACE_TEST_NAMES_H
