#include "features/point_cloud/outside_flood.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

constexpr int most_voxels = 192;  // along the longest side

}  // namespace

OutsideFlood::OutsideFlood(std::span<const Eigen::Vector3d> points, std::span<const double> reach) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    box.extend((points[i].array() - reach[i]).matrix());
    box.extend((points[i].array() + reach[i]).matrix());
  }
  std::vector<double> sorted(reach.begin(), reach.end());
  const auto typical = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, typical);
  voxel_size_ = std::max(*typical / 3.0, box.sizes().maxCoeff() / most_voxels);
  // A margin of two voxels on each side lets the flood go round.
  origin_ = (box.min().array() - 2 * voxel_size_).matrix();
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    size_[axis] = static_cast<int>(std::ceil(box.sizes()[axis] / voxel_size_)) + 4;
    count *= static_cast<std::size_t>(size_[axis]);
  }
  states_.assign(count, dry);
  for (std::size_t i = 0; i < points.size(); ++i) mark_ball(points[i], reach[i]);
  flood();
}

bool OutsideFlood::reaches(const Eigen::Vector3d& place) const {
  const Voxel voxel = voxel_of(place);
  return !contains(voxel) || states_[index_of(voxel)] == flooded;
}

OutsideFlood::Voxel OutsideFlood::voxel_of(const Eigen::Vector3d& place) const {
  Voxel voxel;
  for (int axis = 0; axis < 3; ++axis) {
    voxel[axis] = static_cast<int>(std::floor((place[axis] - origin_[axis]) / voxel_size_));
  }
  return voxel;
}

bool OutsideFlood::contains(const Voxel& voxel) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (voxel[axis] < 0 || voxel[axis] >= size_[axis]) return false;
  }
  return true;
}

std::size_t OutsideFlood::index_of(const Voxel& voxel) const {
  const auto width = static_cast<std::size_t>(size_[0]);
  const auto height = static_cast<std::size_t>(size_[1]);
  return static_cast<std::size_t>(voxel[0]) +
         width * (static_cast<std::size_t>(voxel[1]) + height * static_cast<std::size_t>(voxel[2]));
}

void OutsideFlood::mark_ball(const Eigen::Vector3d& center, double radius) {
  const Voxel low = voxel_of((center.array() - radius).matrix());
  const Voxel high = voxel_of((center.array() + radius).matrix());
  const Eigen::Vector3d local = (center - origin_) / voxel_size_;
  const double squared_radius = radius * radius / (voxel_size_ * voxel_size_);
  Voxel voxel;
  for (voxel[2] = low[2]; voxel[2] <= high[2]; ++voxel[2]) {
    for (voxel[1] = low[1]; voxel[1] <= high[1]; ++voxel[1]) {
      for (voxel[0] = low[0]; voxel[0] <= high[0]; ++voxel[0]) {
        const Eigen::Vector3d middle(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5);
        if ((middle - local).squaredNorm() <= squared_radius) states_[index_of(voxel)] = near_point;
      }
    }
  }
  states_[index_of(voxel_of(center))] = near_point;
}

// From a corner of the margin, through the faces of voxels.
void OutsideFlood::flood() {
  std::vector<Voxel> front{{0, 0, 0}};
  states_[0] = flooded;
  while (!front.empty()) {
    const Voxel voxel = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Voxel next = voxel;
        next[axis] += step;
        if (!contains(next)) continue;
        State& state = states_[index_of(next)];
        if (state != dry) continue;
        state = flooded;
        front.push_back(next);
      }
    }
  }
}

}  // namespace mdbd
