// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that solutions of constraints give, and what moves: what solids sweep, and when regions meet. What other
// sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/bisectors_of_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/curve_surface_bisectors.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelopes_of_two_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/offset_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/sweep_envelopes.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/trimmed_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/trimmed_sheets.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contacts_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/contacts_of_solids.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_of.h>
