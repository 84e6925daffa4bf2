// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/write_SVG_voronoi_diagram_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace write_SVG_voronoi_diagram_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

std::size_t number_of(const std::string& what, const std::string& text)
{
  const std::regex pattern(what);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()));
}

std::string layer(const std::string& drawing, const std::string& name)
{
  const auto begin = drawing.find("inkscape:label='" + name + "'");
  return begin == std::string::npos ? "" : drawing.substr(begin, drawing.find("</g>", begin) - begin);
}

// Two parallel segments and a point between them: the cell of the point is bounded by parts of parabolas. Each edge has
// a quadrangle for each of its sites.
TEST(Write_SVG_voronoi_diagram, layers)
{
  const std::vector<SC::Bspline_curve_2<K>> curves{SC::segment_curve(K::Point_2(0, 0), K::Point_2(8, 0)),
                                                   SC::segment_curve(K::Point_2(0, 4), K::Point_2(8, 4))};
  const auto diagram = SC::voronoi_diagram(curves, std::vector<K::Point_2>{{4, 2}});
  ASSERT_TRUE(diagram.is_complete());
  std::ostringstream out;
  SC::IO::write_SVG(out, curves, diagram);

  EXPECT_NE(out.str().find("viewBox='-0.266"), std::string::npos);   // a margin of a thirtieth of eight
  std::size_t branching = 0;
  for (const auto& vertex : diagram.vertices())
    branching += !vertex.is_at_infinity && vertex.edges.size() > 2 ? 1 : 0;
  EXPECT_GE(branching, 2u);
  EXPECT_EQ(number_of("<path", layer(out.str(), "vertices")), branching);
  EXPECT_EQ(number_of("<path", layer(out.str(), "sites")), 3u);
  EXPECT_EQ(number_of("M4 2h0", layer(out.str(), "sites")), 1u);
  EXPECT_EQ(number_of("<path", layer(out.str(), "edges")), diagram.edges().size());
  EXPECT_EQ(number_of("<path d='M[^']+Z'", layer(out.str(), "cells")), 2 * diagram.edges().size());
  // by symmetry
  EXPECT_EQ(number_of("fill='#eeeeee'", layer(out.str(), "cells")),
            number_of("fill='#aec7e8'", layer(out.str(), "cells")));
  EXPECT_EQ(number_of("fill='#f7d7a0'", layer(out.str(), "cells")), 2u);   // above and below the point
}

} // namespace write_SVG_voronoi_diagram_test
