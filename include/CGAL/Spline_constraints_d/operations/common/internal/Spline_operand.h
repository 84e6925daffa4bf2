// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H

// Operands as patches.
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H
