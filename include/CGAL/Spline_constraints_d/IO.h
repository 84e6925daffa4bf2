// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_H

// All readers and writers of files. read_SVG.h needs pugixml, and is there where that is found.
#include <CGAL/Spline_constraints_d/IO/Minibex_system.h>
#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/planar_layers_2.h>
#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG_voronoi_diagram_2.h>
#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/IO/write_WKT.h>
#include <CGAL/Spline_constraints_d/IO/write_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/IO/write_surface_mesh.h>

#if __has_include(<pugixml.hpp>)
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_H
