// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Newton's method, and the proof of answers.
#include <CGAL/Spline_constraints_d/solver/internal/Newton_iteration.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>
