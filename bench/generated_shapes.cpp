#include "bench/generated_shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace mdbd::bench {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

// Joins `around` rings of `across` vertices each, the last to the first.
std::vector<Triangle> join_rings(std::uint32_t around, std::uint32_t across) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t ring = i * across;
    const std::uint32_t next = (i + 1) % around * across;
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t up = (j + 1) % across;
      triangles.push_back({ring + j, next + j, next + up});
      triangles.push_back({ring + j, next + up, ring + up});
    }
  }
  return triangles;
}

// Turns closed profiles of distances from the z axis and heights, counter-clockwise, around it.
// profile_at(angle) gives one; all have the same size.
template <typename Function>
TriangleMesh revolve(const Function& profile_at, std::uint32_t around) {
  TriangleMesh mesh;
  std::size_t across = 0;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = turn * i / around;
    const std::vector<Eigen::Vector2d>& profile = profile_at(angle);
    across = profile.size();
    for (const Eigen::Vector2d& point : profile) {
      mesh.vertices.emplace_back(point.x() * std::cos(angle), point.x() * std::sin(angle),
                                 point.y());
    }
  }
  mesh.triangles = join_rings(around, static_cast<std::uint32_t>(across));
  return mesh;
}

std::vector<Eigen::Vector2d> make_ellipse(const Eigen::Vector2d& center,
                                          const Eigen::Vector2d& half_axes, std::uint32_t corners) {
  std::vector<Eigen::Vector2d> ellipse;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = turn * i / corners;
    ellipse.emplace_back(center.x() + half_axes.x() * std::cos(angle),
                         center.y() + half_axes.y() * std::sin(angle));
  }
  return ellipse;
}

// For twice as many sections.
std::uint32_t corners_of_section(std::int64_t triangles) {
  return static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
}

}  // namespace

TriangleMesh make_torus(std::int64_t triangles) {
  const std::uint32_t corners = corners_of_section(triangles);
  const auto section = make_ellipse({0.75, 0.0}, {0.25, 0.25}, corners);
  return revolve(
      [&](double) -> const auto& { return section; }, 2 * corners);
}

TriangleMesh make_ring(std::int64_t triangles) {
  const std::uint32_t corners = corners_of_section(triangles);
  const auto section_at = [&](double angle) {
    const double size = 0.2 * (1.0 + 0.3 * std::sin(3.0 * angle));
    return make_ellipse({0.75, 0.15 * std::sin(2.0 * angle)}, {size, 0.6 * size}, corners);
  };
  return revolve(section_at, 2 * corners);
}

TriangleMesh make_pipe(std::int64_t triangles) {
  const std::vector<Eigen::Vector2d> wall = {
      Eigen::Vector2d(0.95, -1.0), {1.0, -1.0}, {1.0, 1.0}, {0.95, 1.0}};
  return revolve(
      [&](double) -> const auto& { return wall; }, static_cast<std::uint32_t>(triangles / 8));
}

TriangleMesh make_bracket() {
  constexpr double width = 1.2;
  constexpr double thickness = 1.0 / 15.0;
  // Seen from the side, counter-clockwise, and cut at the inner corner into two convex pieces.
  const std::array<Eigen::Vector2d, 6> outline = {Eigen::Vector2d(0.0, 0.0), {2.0, 0.0},
                                                  {2.0, thickness},          {thickness, thickness},
                                                  {thickness, 1.5},          {0.0, 1.5}};
  const std::array<Triangle, 4> caps = {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  TriangleMesh mesh;
  for (const double z : {0.0, width}) {
    for (const Eigen::Vector2d& corner : outline) {
      mesh.vertices.emplace_back(corner.x(), corner.y(), z);
    }
  }
  const auto corners = static_cast<std::uint32_t>(outline.size());
  for (const auto& [a, b, c] : caps) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + corners, b + corners, c + corners});
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    mesh.triangles.push_back({i, next, next + corners});
    mesh.triangles.push_back({i, next + corners, i + corners});
  }
  return mesh;
}

}  // namespace mdbd::bench
