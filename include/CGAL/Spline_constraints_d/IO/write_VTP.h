// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H

#include <CGAL/Spline_constraints_d/IO/internal/decimal_text.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <CGAL/Point_3.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes polylines in space as `PolyData` of VTK, in XML with numbers as text, which ParaView and others read. The cell
data `component` are the indices of the polylines. Coordinates are rounded to double.
\param out where they are written to.
\param polylines the points of each polyline; those of a closed one begin and end with the same point.
*/
template <SplineKernel Kernel>
void write_VTP(std::ostream& out, const std::vector<std::vector<CGAL::Point_3<Kernel>>>& polylines)
{
  std::size_t points = 0;
  for (const auto& polyline : polylines)
    points += polyline.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << polylines.size()
      << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
      << "<CellData Scalars=\"component\">\n<DataArray type=\"Int64\" Name=\"component\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < polylines.size(); ++i)
    out << i << '\n';
  out << "</DataArray>\n</CellData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">\n";
  for (const auto& polyline : polylines)
    for (const CGAL::Point_3<Kernel>& p : polyline)
      for (int i = 0; i < 3; ++i)
        out << internal::double_text(internal::converted_number<double>(p.cartesian(i))) << (i < 2 ? ' ' : '\n');
  out << "</DataArray>\n</Points>\n<Lines>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < points; ++i)
    out << i << '\n';
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for (const auto& polyline : polylines)
    out << (end += polyline.size()) << '\n';
  out << "</DataArray>\n</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_VTP_H
