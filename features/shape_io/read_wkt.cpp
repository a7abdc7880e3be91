#include <algorithm>
#include <string>
#include <string_view>

#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>

#include "features/core/errors.h"
#include "features/shape_io/read_planar_domain.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point>;

template <typename Ring>
Outline to_outline(const Ring& ring) {
  Outline outline;
  for (const Point& point : ring) outline.emplace_back(point.x(), point.y());
  return outline;
}

// Boost knows no separators but blanks.
std::string with_blanks(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

bool is_multiple(std::string_view text) {
  constexpr std::string_view name = "MULTIPOLYGON";
  return equals_ignoring_case(text.substr(0, name.size()), name);
}

bg::model::multi_polygon<Polygon> parse(const std::string& text) {
  bg::model::multi_polygon<Polygon> polygons;
  if (is_multiple(text)) {
    bg::read_wkt(text, polygons);
  } else {
    bg::read_wkt(text, polygons.emplace_back());
  }
  return polygons;
}

}  // namespace

PlanarDomain read_wkt(const std::string& text) {
  try {
    PlanarDomain domain;
    for (const Polygon& polygon : parse(with_blanks(text))) {
      domain.push_back(to_outline(polygon.outer()));
      for (const auto& hole : polygon.inners()) domain.push_back(to_outline(hole));
    }
    return domain;
  } catch (const bg::read_wkt_exception&) {
    throw InvalidInput("it is no well-known text of a POLYGON or MULTIPOLYGON");
  }
}

}  // namespace mdbd
