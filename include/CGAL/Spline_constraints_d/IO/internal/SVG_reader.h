// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_READER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_READER_H

#include <CGAL/Spline_constraints_d/IO/internal/SVG_exact_curve.h>
#include <CGAL/Spline_constraints_d/IO/internal/SVG_path_parser.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Walks through the elements of an SVG document. Attributes are read from the source itself, so that errors know their
// place.
class SVG_reader
{
  using Point = Exact_kernel::Point_2;
  using Vector = Exact_kernel::Vector_2;
  using Transformation = Exact_kernel::Aff_transformation_2;

  static constexpr int maximal_depth = 200;

  const Text_source& m_source;
  std::vector<SVG_exact_curve> m_curves;

public:
  explicit SVG_reader(const Text_source& source) : m_source(source) {}

  std::vector<SVG_exact_curve> curves()
  {
    if (const std::size_t zero = m_source.content().find('\0'); zero != std::string_view::npos)
      m_source.fail(zero, 1, "a zero byte");
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(m_source.content().data(), m_source.content().size(),
                                                               pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
      const auto position = (std::min)(static_cast<std::size_t>(result.offset), m_source.content().size());
      Text_cursor(m_source, position, m_source.content().size() - position)
          .fail(std::string("not XML: ") + result.description());
    }
    const pugi::xml_node root = document.document_element();
    if (name(root) != "svg")
      m_source.fail(root ? begin(root) : 0, root ? std::string_view(root.name()).size() : 0, "expected an element svg");
    for (const pugi::xml_node& child : root.children())
      read(child, transformation(root, upwards()), 1);
    return std::move(m_curves);
  }

private:
  // The y-axis of SVG points downwards.
  static Transformation upwards() { return Transformation(1, 0, 0, 0, -1, 0); }

  static std::string_view name(const pugi::xml_node& element)
  {
    const std::string_view full = element.name();
    return full.substr(0, 4) == "svg:" ? full.substr(4) : full;
  }

  static std::size_t begin(const pugi::xml_node& element) { return static_cast<std::size_t>(element.offset_debug()); }

  [[noreturn]] void fail(const pugi::xml_node& element, const std::string& message) const
  {
    m_source.fail(begin(element), std::string_view(element.name()).size(), message);
  }

  // The value of an attribute in the source.
  std::optional<Text_cursor> attribute(const pugi::xml_node& element, std::string_view wanted) const
  {
    const std::string_view content = m_source.content();
    std::size_t position = begin(element) + std::string_view(element.name()).size();
    for (;;) {
      position = content.find_first_not_of(" \t\r\n", position);
      if (position == std::string_view::npos || content[position] == '>' || content[position] == '/')
        return std::nullopt;
      const std::size_t end_of_name = content.find_first_of(" \t\r\n=", position);
      const std::size_t quote = content.find_first_of("\"'", position);
      if (end_of_name == std::string_view::npos || quote == std::string_view::npos)
        return std::nullopt;
      const std::size_t end = content.find(content[quote], quote + 1);
      if (end == std::string_view::npos)
        return std::nullopt;
      if (content.substr(position, end_of_name - position) == wanted)
        return Text_cursor(m_source, quote + 1, end - quote - 1);
      position = end + 1;
    }
  }

  // ---- elements ----

  void read(const pugi::xml_node& element, const Transformation& outer, int depth)
  {
    if (element.type() != pugi::node_element)
      return;
    if (depth > maximal_depth)
      fail(element, "more than " + std::to_string(maximal_depth) + " elements within each other");
    const std::string_view kind = name(element);
    if (kind == "use" || kind == "svg")
      fail(element, "elements '" + std::string(kind) + "' within a drawing are not supported");
    if (kind == "g" || kind == "a" || kind == "switch") {
      const Transformation inner = transformation(element, outer);
      for (const pugi::xml_node& child : element.children())
        read(child, inner, depth + 1);
      return;
    }
    try {
      const std::vector<Bezier_path::Curve> curves = shapes(element, kind);
      if (curves.empty())
        return;
      const Transformation map = transformation(element, outer);
      for (const Bezier_path::Curve& curve : curves)
        m_curves.push_back(
            {curve.transformed(map), element.attribute("id").value(), std::string(kind), begin(element) - 1});
    } catch (const Parse_error&) {
      throw;
    } catch (const Invalid_input& error) {
      fail(element, error.what());
    }
  }

  std::vector<Bezier_path::Curve> shapes(const pugi::xml_node& element, std::string_view kind) const
  {
    std::vector<Bezier_path::Curve> result;
    const auto add = [&](const Bezier_path& path) {
      if (!path.empty())
        result.push_back(path.curve());
    };
    if (kind == "path") {
      if (const auto data = attribute(element, "d"))
        for (const Bezier_path& path : SVG_path_parser(*data).paths())
          add(path);
    } else if (kind == "line") {
      Bezier_path path(Point(length(element, "x1"), length(element, "y1")));
      path.add({Point(length(element, "x2"), length(element, "y2"))});
      add(path);
    } else if (kind == "polyline" || kind == "polygon")
      add(polygon(element, kind == "polygon"));
    else if (kind == "rect")
      add(rectangle(element));
    else if (kind == "circle" || kind == "ellipse") {
      const Exact_rational rx = radius(element, kind == "circle" ? "r" : "rx"),
                           ry = radius(element, kind == "circle" ? "r" : "ry");
      if (rx != 0 && ry != 0)
        result.push_back(ellipse<2>(Point(length(element, "cx"), length(element, "cy")), Vector(rx, 0), Vector(0, ry)));
    }
    return result;
  }

  Bezier_path polygon(const pugi::xml_node& element, bool is_closed) const
  {
    std::vector<Point> points;
    if (auto cursor = attribute(element, "points"))
      for (cursor->skip_blanks(); !cursor->is_at_end();) {
        const Exact_rational x = cursor->number("a coordinate");
        skip_separator(*cursor);
        const Exact_rational y = cursor->number("a coordinate");
        points.emplace_back(x, y);
        if (skip_separator(*cursor) && cursor->is_at_end())
          cursor->fail("expected a coordinate");
      }
    Bezier_path path(points.empty() ? Point(0, 0) : points.front());
    for (const Point& p : points)
      path.add({p});
    if (is_closed)
      path.close();
    return path;
  }

  // From the end of the upper left corner around, with x to the right and y downwards.
  Bezier_path rectangle(const pugi::xml_node& element) const
  {
    const Exact_rational x = length(element, "x"), y = length(element, "y"), w = radius(element, "width"),
                         h = radius(element, "height");
    if (w == 0 || h == 0)
      return Bezier_path(Point(x, y));
    const bool has_rx = has_number(element, "rx"), has_ry = has_number(element, "ry");
    Exact_rational rx = radius(element, has_rx ? "rx" : "ry"), ry = radius(element, has_ry ? "ry" : "rx");
    rx = (std::min)(rx, Exact_rational(w / 2));
    ry = (std::min)(ry, Exact_rational(h / 2));
    if (rx == 0 || ry == 0)
      rx = ry = 0;
    const Exact_rational right = Exact_rational(x + w), bottom = Exact_rational(y + h);
    Bezier_path path(Point(Exact_rational(x + rx), y));
    const auto corner = [&](const Point& target) {
      if (rx != 0)
        add_elliptical_arc(path, {Vector(1, 0), rx, ry}, false, true, target);
    };
    path.add({Point(Exact_rational(right - rx), y)});
    corner(Point(right, Exact_rational(y + ry)));
    path.add({Point(right, Exact_rational(bottom - ry))});
    corner(Point(Exact_rational(right - rx), bottom));
    path.add({Point(Exact_rational(x + rx), bottom)});
    corner(Point(x, Exact_rational(bottom - ry)));
    path.add({Point(x, Exact_rational(y + ry))});
    corner(path.source());
    return path;
  }

  // ---- lengths ----

  bool has_number(const pugi::xml_node& element, std::string_view wanted) const
  {
    const auto cursor = attribute(element, wanted);
    return cursor && cursor->rest() != "auto";
  }

  // In user units, 96 to the inch; 0 if there is no such attribute.
  Exact_rational length(const pugi::xml_node& element, std::string_view wanted) const
  {
    if (!has_number(element, wanted))
      return Exact_rational(0);
    Text_cursor cursor = *attribute(element, wanted);
    cursor.skip_blanks();
    const Exact_rational value = cursor.number("a length");
    struct Unit { std::string_view name; int numerator, denominator; };
    static constexpr std::array<Unit, 7> units{
        {{"", 1, 1}, {"px", 1, 1}, {"in", 96, 1}, {"cm", 4800, 127}, {"mm", 480, 127}, {"pt", 4, 3}, {"pc", 16, 1}}};
    const std::string_view rest = cursor.rest(), name = rest.substr(0, rest.find_last_not_of(" \t\r\n") + 1);
    for (const Unit& unit : units)
      if (name == unit.name)
        return Exact_rational(value * unit.numerator / unit.denominator);
    cursor.fail("expected px, in, cm, mm, pt, pc or nothing after a number");
  }

  Exact_rational radius(const pugi::xml_node& element, std::string_view wanted) const
  {
    const Exact_rational value = length(element, wanted);
    if (value < 0)
      attribute(element, wanted)->fail("a length that is negative");
    return value;
  }

  // ---- transformations ----

  Transformation transformation(const pugi::xml_node& element, const Transformation& outer) const
  {
    Transformation result = outer;
    if (auto cursor = attribute(element, "transform"))
      for (cursor->skip_blanks(); !cursor->is_at_end(); skip_separator(*cursor))
        result = result * one_transformation(*cursor);
    return result;
  }

  static Transformation one_transformation(Text_cursor& cursor)
  {
    const std::size_t begin = cursor.position();
    std::string kind;
    for (; Text_cursor::is_letter(cursor.peek()); cursor.advance())
      kind += cursor.peek();
    cursor.skip_blanks();
    if (!cursor.skip('('))
      cursor.fail_at(begin, "expected a transformation with its numbers in parentheses", "(");
    std::vector<Exact_rational> a;
    for (cursor.skip_blanks(); !cursor.skip(')'); skip_separator(cursor))
      a.push_back(cursor.number("a number or ')'"));
    const std::size_t n = a.size();
    const Exact_rational zero(0), one(1);
    const auto is = [&](const char* wanted, std::size_t fewest, std::size_t most) {
      return kind == wanted && n >= fewest && n <= most;
    };
    const auto tangent = [&] { return unit_vector_of_degrees(a[0]); };
    if (is("matrix", 6, 6)) {
      if (a[0] * a[3] == a[1] * a[2])
        cursor.fail_at(begin, "a transformation that is not invertible", "(");
      return Transformation(a[0], a[2], a[4], a[1], a[3], a[5]);
    }
    if (is("translate", 1, 2))
      return Transformation(one, zero, a[0], zero, one, n == 2 ? a[1] : zero);
    if (is("scale", 1, 2)) {
      if (a.front() == 0 || a.back() == 0)
        cursor.fail_at(begin, "a transformation that is not invertible", "(");
      return Transformation(a.front(), zero, zero, zero, a.back(), zero);
    }
    if (is("rotate", 1, 1) || is("rotate", 3, 3)) {
      const Vector u = unit_vector_of_degrees(a[0]);
      const Exact_rational x = n == 3 ? a[1] : zero, y = n == 3 ? a[2] : zero;
      return Transformation(u.x(), Exact_rational(-u.y()), Exact_rational(x - u.x() * x + u.y() * y),
                            u.y(), u.x(), Exact_rational(y - u.y() * x - u.x() * y));
    }
    if ((is("skewX", 1, 1) || is("skewY", 1, 1)) && tangent().x() != 0) {
      const Exact_rational t = tangent().y() / tangent().x();
      return kind == "skewX" ? Transformation(one, t, zero, zero, one, zero)
                             : Transformation(one, zero, zero, t, one, zero);
    }
    cursor.fail_at(begin, "not a transformation of SVG, or not with so many numbers", "(");
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<SVG_exact_curve> exact_curves_of_SVG(const Text_source& source)
{
  return SVG_reader(source).curves();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_READER_H
