// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The common curves of two surfaces.
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Joined_parts.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/common_curves.h>
