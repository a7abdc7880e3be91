#include "features/planar/planar_domain.h"

#include <algorithm>
#include <cmath>

#include <polyclipping/clipper.hpp>

#include "features/core/errors.h"

namespace mdbd {
namespace {

// Clipper computes with integers below 2^62.
constexpr int grid_exponent = 60;

double largest_coordinate(const PlanarDomain& domain) {
  double largest = 0.0;
  for (const Outline& outline : domain) {
    for (const Eigen::Vector2d& point : outline) {
      if (!point.allFinite()) throw InvalidInput("a coordinate is not a finite number");
      largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
    }
  }
  return largest;
}

ClipperLib::Path to_grid(const Outline& outline, int exponent) {
  ClipperLib::Path path;
  for (const Eigen::Vector2d& point : outline) {
    path.emplace_back(std::llround(std::ldexp(point.x(), exponent)),
                      std::llround(std::ldexp(point.y(), exponent)));
  }
  return path;
}

Outline from_grid(const ClipperLib::Path& path, int exponent) {
  Outline outline;
  for (const ClipperLib::IntPoint& point : path) {
    outline.emplace_back(std::ldexp(static_cast<double>(point.X), -exponent),
                         std::ldexp(static_cast<double>(point.Y), -exponent));
  }
  return outline;
}

double signed_area(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - outline[0];
    const Eigen::Vector2d b = outline[(i + 1) % outline.size()] - outline[0];
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * doubled;
}

}  // namespace

PlanarDomain simplify(const PlanarDomain& domain) {
  const double largest = largest_coordinate(domain);
  if (!(largest > 0)) throw InvalidInput("there is no outline with an area");
  const int exponent = grid_exponent - std::ilogb(largest) - 1;
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  for (const Outline& outline : domain) {
    clipper.AddPath(to_grid(outline, exponent), ClipperLib::ptSubject, true);
  }
  ClipperLib::Paths paths;
  clipper.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftEvenOdd);
  PlanarDomain simple;
  for (const ClipperLib::Path& path : paths) simple.push_back(from_grid(path, exponent));
  if (!(area(simple) > 0)) throw InvalidInput("there is no outline with an area");
  return simple;
}

double area(const PlanarDomain& domain) {
  double sum = 0.0;
  for (const Outline& outline : domain) sum += signed_area(outline);
  return sum;
}

}  // namespace mdbd
