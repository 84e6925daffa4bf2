// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minkowski sums and swept areas, for all kernels.
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_model_2.h>
