// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SUBJECTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SUBJECTS_H

/*!
\page Spline_constraints_d_subjects Subjects of Operations

Each folder of `operations/` is a subject. It holds the public headers of its operations, and in `internal/` what these
have in common, in the namespace of the subject. The using-directives of `operations/subjects.h` say which other
subjects it may use; the check of the house rules reads them there, and refuses every other include, and a circle. What
is in `internal/` may use the types and the `internal/` of these subjects, but calls none of their operations.

- `common`: operands as trees of Bézier pieces with boxes; arcs in exact numbers and in intervals; answers of several
  subjects. It uses the floors below alone.
- `intersections`: points and curves that curves and surfaces have in common, with others and with themselves.
- `surface_curves`: silhouettes, sections, parabolic lines, umbilics and accessible directions of surfaces.
- `regions`: regions of the plane with curved boundaries, and their conversions to polygons and arrangements.
- `distances`: closest points, distances of curves, surfaces and regions.
- `implicit_patches`: zeros of polynomials in tetrahedra, and their shape.
- `smooth_surfaces`: smooth closed surfaces of cubic patches through the vertices of meshes.
- `approximate_polygons`: polygons whose edges are known up to bands, and where points are in all of them.
- `surface_regions`: parts of surfaces that curves on them bound: accessible regions, visible parts.
- `loci`: curves of points that two curves define: bisectors, alpha-sectors, envelopes.
- `rational_bisectors`: bisectors in space that are rational surfaces, and what lies on them.
- `envelope_surfaces`: surfaces that solutions of constraints give: envelopes of moving surfaces, offsets, bisectors.
- `swept_volumes`: the boundary of what a moving solid sweeps, as a closed mesh.
- `first_contacts`: when moving regions and solids meet, and where.
- `curve_features`: inflections, vertices, bitangents, cusps of offsets, tangent circles, ray-traps.
- `joints`: ends of curves that nearly meet, joined exactly.
- `convex_hull`: convex hulls of curves.
- `visibility`: what is seen from a point, and from where all is seen.
- `minkowski_sum`: Minkowski sums of regions and curves, swept areas.
- `voronoi`: Voronoi diagrams, medial axes, offsets, trimmed bisectors and sectors.

`intersections/internal/elimination` finds common points of curves without subdivision, by polynomials in one parameter;
`intersections/internal/implicitization` finds equations of curves and surfaces;
`intersections/internal/primitives` recognises surfaces that are primitives but for rounding.
In `voronoi/internal/` a folder uses itself and those before it: `sites` (curves cut into arcs, and their graph),
`disks` (one disk that touches one or two arcs), `candidates` (arcs that can bound a disk), `envelope` (the largest
empty disks along an oriented boundary element), `offset`, `diagram`. In the same way `solver/internal/` goes from
`control`, `exact`, `node`, `certification` and `subdivision` to `curves`, `surfaces`, `meshing`, `verification`,
`decomposition`, `feasibility` and `tracking`.
*/

namespace CGAL {
namespace Spline_constraints {
namespace internal {

namespace Common {
}
namespace Intersections {
using namespace Common;
}
namespace Surface_curves {
using namespace Common;
using namespace Intersections;
}
namespace Regions {
using namespace Common;
using namespace Intersections;
}
namespace Distances {
using namespace Common;
using namespace Intersections;
using namespace Regions;
}
namespace Implicit_patches {
using namespace Common;
}
namespace Smooth_surfaces {
using namespace Common;
}
namespace Approximate_polygons {
using namespace Common;
}
namespace Surface_regions {
using namespace Common;
using namespace Intersections;
using namespace Surface_curves;
using namespace Regions;
using namespace Distances;
}
namespace Loci {
using namespace Common;
using namespace Intersections;
}
namespace Rational_bisectors {
using namespace Common;
using namespace Intersections;
using namespace Surface_curves;
using namespace Surface_regions;
using namespace Distances;
}
namespace Envelope_surfaces {
using namespace Common;
using namespace Intersections;
using namespace Surface_curves;
using namespace Rational_bisectors;
}
namespace Swept_volumes {
using namespace Common;
using namespace Surface_curves;
using namespace Envelope_surfaces;
}
namespace First_contacts {
using namespace Common;
using namespace Intersections;
using namespace Regions;
using namespace Envelope_surfaces;
using namespace Swept_volumes;
} // namespace First_contacts
namespace Curve_features {
using namespace Common;
using namespace Intersections;
using namespace Distances;
using namespace Loci;
}
namespace Joints {
using namespace Common;
using namespace Distances;
}
namespace Convex_hull {
using namespace Common;
using namespace Intersections;
using namespace Regions;
}
namespace Visibility {
using namespace Common;
using namespace Intersections;
using namespace Regions;
using namespace Convex_hull;
}
namespace Minkowski_sum {
using namespace Common;
using namespace Intersections;
using namespace Regions;
using namespace Loci;
}
namespace Voronoi {
using namespace Common;
using namespace Intersections;
using namespace Regions;
using namespace Loci;
using namespace Minkowski_sum;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SUBJECTS_H
