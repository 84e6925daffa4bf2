// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What Voronoi diagrams, medial axes, trimmed bisectors and offsets have in common, for curves of all kernels.
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Sector_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Offset_cycles.h>

namespace CGAL::Spline_constraints::internal::Voronoi {

template Disk_diagram disk_diagram<CGAL::Sequential_tag>(const Site_graph_2<>&, std::vector<std::size_t>,
                                                         const std::string&);
template Offset_cycles offset_cycles<CGAL::Sequential_tag>(std::shared_ptr<const Site_graph_2<>>, const Exact_rational&,
                                                           const std::vector<std::size_t>&, bool);
template Sector_disks sector_disks<CGAL::Sequential_tag>(std::shared_ptr<const Site_graph_2<>>,
                                                         std::shared_ptr<const Scaled_sites<>>,
                                                         const std::vector<std::size_t>&);

} // namespace CGAL::Spline_constraints::internal::Voronoi
