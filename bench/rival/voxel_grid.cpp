#include "bench/rival/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "features/core/box.h"

namespace mdbd::bench {
namespace {

// The margin is not a whole number of halves, so that rows do not run along the faces of parts
// whose sizes are round numbers.
constexpr double margin = 1.0123;

// Where a row meets a triangle.
struct Crossing {
  std::uint32_t row;
  std::int16_t first;  // the first voxel whose centre is beyond
  std::int16_t step;   // 1 where the row enters the solid, -1 where it leaves
};

// Corners of a triangle in units of voxels.
using Corners = std::array<Eigen::Vector3d, 3>;

// Twice the area of a, b and the point, seen along x. The order of a and b decides the sign alone,
// not the rounding, and it is never zero: triangles on both sides of an edge agree on where it
// runs, and exactly one of them has a row that runs through it.
double turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double y, double z) {
  const auto area = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const double twice =
        (to.y() - from.y()) * (z - from.z()) - (to.z() - from.z()) * (y - from.y());
    return twice == 0 ? std::numeric_limits<double>::min() : twice;
  };
  const bool is_in_order = a.y() < b.y() || (a.y() == b.y() && a.z() < b.z());
  return is_in_order ? area(a, b) : -area(b, a);
}

class CrossingFinder {
 public:
  explicit CrossingFinder(const VoxelGrid& grid) : grid_(grid) {}

  void add(const Corners& corners) {
    const auto& [a, b, c] = corners;
    const Eigen::Vector3d lowest = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3d highest = a.cwiseMax(b).cwiseMax(c);
    for (int z = first_at(lowest.z()); z <= highest.z(); ++z) {
      for (int y = first_at(lowest.y()); y <= highest.y(); ++y) cross(corners, y, z);
    }
  }

  const std::vector<Crossing>& crossings() const { return crossings_; }

 private:
  static int first_at(double coordinate) { return static_cast<int>(std::ceil(coordinate)); }

  void cross(const Corners& corners, int y, int z) {
    const auto& [a, b, c] = corners;
    const double at_a = turn(b, c, y, z);
    const double at_b = turn(c, a, y, z);
    const double at_c = turn(a, b, y, z);
    const bool is_front = at_a > 0;
    if (is_front != (at_b > 0) || is_front != (at_c > 0)) return;
    const double x = (at_a * a.x() + at_b * b.x() + at_c * c.x()) / (at_a + at_b + at_c);
    const auto row = static_cast<std::uint32_t>(z * grid_.counts.y() + y);
    crossings_.push_back({row, static_cast<std::int16_t>(first_at(x)),
                          static_cast<std::int16_t>(is_front ? -1 : 1)});
  }

  const VoxelGrid& grid_;
  std::vector<Crossing> crossings_;
};

std::vector<Crossing> find_crossings(const TriangleMesh& mesh, const VoxelGrid& grid) {
  CrossingFinder finder(grid);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    vertices.emplace_back((vertex - grid.origin) / grid.voxel_size);
  }
  for (const auto& [a, b, c] : mesh.triangles) finder.add({vertices[a], vertices[b], vertices[c]});
  return finder.crossings();
}

// Sorted by row and position. By counting: there are about as many crossings as rows.
std::vector<Crossing> sort_crossings(const std::vector<Crossing>& crossings, std::size_t rows) {
  std::vector<std::uint32_t> ends(rows + 1, 0);
  for (const Crossing& crossing : crossings) ++ends[crossing.row + 1];
  for (std::size_t row = 0; row < rows; ++row) ends[row + 1] += ends[row];
  std::vector<Crossing> sorted(crossings.size());
  for (const Crossing& crossing : crossings) sorted[ends[crossing.row]++] = crossing;
  std::uint32_t begin = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    std::ranges::sort(std::span(sorted).subspan(begin, ends[row] - begin), {}, &Crossing::first);
    begin = ends[row];
  }
  return sorted;
}

}  // namespace

VoxelGrid make_voxel_grid(const TriangleMesh& mesh, int resolution) {
  Box box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const double voxel_size = box.sizes().maxCoeff() / resolution;
  const Eigen::Array3d extent = box.sizes().array() / voxel_size + 2.0 * margin;
  return {.origin = (box.min().array() - margin * voxel_size).matrix(),
          .voxel_size = voxel_size,
          .counts = extent.ceil().cast<int>() + 1};
}

std::vector<std::uint8_t> voxelise(const TriangleMesh& mesh, const VoxelGrid& grid) {
  const std::vector<Crossing> crossings =
      sort_crossings(find_crossings(mesh, grid), grid.row_count());
  std::vector<std::uint8_t> is_inside(grid.size(), 0);
  for (std::size_t i = 0; i < crossings.size();) {
    const std::uint32_t row = crossings[i].row;
    const auto begin = is_inside.begin() + static_cast<std::ptrdiff_t>(row) * grid.counts.x();
    int winding = 0;
    for (; i + 1 < crossings.size() && crossings[i + 1].row == row; ++i) {
      winding += crossings[i].step;
      if (winding > 0) std::fill(begin + crossings[i].first, begin + crossings[i + 1].first, 1);
    }
    ++i;  // beyond the last crossing of a row all is outside
  }
  return is_inside;
}

}  // namespace mdbd::bench
