#include "features/shape_io/triangulate_polygon.h"

#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr std::size_t most_corners = 10'000;  // the time to cut ears grows with the square
constexpr double straight = 1e-12;            // the sine of a turn that is none

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

void append_fan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

}  // namespace

void PolygonTriangulator::triangulate(std::span<const Eigen::Vector3d> vertices,
                                      std::span<const std::uint32_t> corners,
                                      std::vector<Triangle>& triangles) {
  if (corners.size() == 3 || !project(vertices, corners) || is_strictly_convex()) {
    append_fan(corners, triangles);
    return;
  }
  if (corners.size() > most_corners) {
    throw InvalidInput("a face that is not convex has " + std::to_string(corners.size()) +
                       " corners; triangulate the model first");
  }
  clip_ears(corners, triangles);
}

// Onto the coordinate plane that the polygon faces most, so that it turns to the left. False if the
// polygon has no area, hence no plane.
bool PolygonTriangulator::project(std::span<const Eigen::Vector3d> vertices,
                                  std::span<const std::uint32_t> corners) {
  const Eigen::Vector3d origin = vertices[corners[0]];
  double extent = 0.0;
  for (const std::uint32_t corner : corners) {
    extent = std::max(extent, (vertices[corner] - origin).cwiseAbs().maxCoeff());
  }
  if (extent == 0.0) return false;

  const auto local = [&](std::size_t i) -> Eigen::Vector3d {
    return (vertices[corners[i % corners.size()]] - origin) / extent;
  };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) normal += local(i).cross(local(i + 1));
  Eigen::Index axis = 0;
  if (normal.cwiseAbs().maxCoeff(&axis) <= straight) return false;

  Eigen::Index first = (axis + 1) % 3;
  Eigen::Index second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  points_.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d point = local(i);
    points_[i] = {point[first], point[second]};
  }
  return true;
}

// 1 to the left, -1 to the right, 0 straight on or back.
int PolygonTriangulator::turn(std::size_t a, std::size_t b, std::size_t c) const {
  const Eigen::Vector2d in = points_[b] - points_[a];
  const Eigen::Vector2d out = points_[c] - points_[b];
  const double area = cross(in, out);
  if (std::abs(area) <= straight * in.norm() * out.norm()) return 0;
  return area > 0 ? 1 : -1;
}

bool PolygonTriangulator::is_strictly_convex() const {
  const std::size_t count = points_.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (turn(i, (i + 1) % count, (i + 2) % count) <= 0) return false;
  }
  return true;
}

// Whether the triangle at a corner lies in the polygon: it turns left there, and none of the other
// corners lies in it or on its rim. Corners at the same place as one of the three do no harm; they
// occur where a slit leads to a hole.
bool PolygonTriangulator::is_ear(std::size_t corner) const {
  const std::size_t before = previous_[corner];
  const std::size_t after = next_[corner];
  if (turn(before, corner, after) <= 0) return false;
  Eigen::AlignedBox2d box(points_[before]);
  box.extend(points_[corner]).extend(points_[after]);
  for (std::size_t i = next_[after]; i != before; i = next_[i]) {
    if (!box.contains(points_[i])) continue;  // most of them
    const bool is_inside =
        turn(before, corner, i) >= 0 && turn(corner, after, i) >= 0 && turn(after, before, i) >= 0;
    if (is_inside && points_[i] != points_[before] && points_[i] != points_[corner] &&
        points_[i] != points_[after]) {
      return false;
    }
  }
  return true;
}

// Marks all ears of what remains and returns how many there are.
std::size_t PolygonTriangulator::mark_ears(std::size_t start) {
  std::size_t ears = 0;
  std::size_t i = start;
  do {
    is_ear_[i] = is_ear(i) ? 1 : 0;
    ears += is_ear_[i];
    i = next_[i];
  } while (i != start);
  return ears;
}

void PolygonTriangulator::clip_ears(std::span<const std::uint32_t> corners,
                                    std::vector<Triangle>& triangles) {
  const std::size_t count = corners.size();
  previous_.resize(count);
  next_.resize(count);
  is_ear_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    previous_[i] = (i + count - 1) % count;
    next_[i] = (i + 1) % count;
  }

  std::size_t current = 0;
  std::size_t remaining = count;
  std::size_t ears = mark_ears(current);
  while (remaining > 3 && (ears > 0 || (ears = mark_ears(current)) > 0)) {
    while (is_ear_[current] == 0) current = next_[current];
    const std::size_t before = previous_[current];
    const std::size_t after = next_[current];
    triangles.push_back({corners[before], corners[current], corners[after]});
    next_[before] = after;
    previous_[after] = before;
    --remaining;
    ears -= 1 + is_ear_[before] + is_ear_[after];
    for (const std::size_t neighbour : {before, after}) {
      is_ear_[neighbour] = is_ear(neighbour) ? 1 : 0;
      ears += is_ear_[neighbour];
    }
    current = next_[after];  // not the next neighbour, which would make a fan of slivers
  }

  std::vector<std::uint32_t> rest;
  for (std::size_t i = 0; i < remaining; ++i, current = next_[current]) {
    rest.push_back(corners[current]);
  }
  append_fan(rest, triangles);
}

}  // namespace mdbd
