// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What moves: when regions meet, and what solids sweep. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contacts_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_of.h>
