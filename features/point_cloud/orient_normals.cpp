#include "features/point_cloud/orient_normals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <tuple>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/point_cloud/outside_flood.h"

namespace mdbd {
namespace {

// Samples drawn at random leave holes of up to about two spacings.
constexpr double least_scale = 2.0;
constexpr double farthest_reach = 0.25;  // relative to the size of the cloud
constexpr double most_seen_from_both_sides = 0.5;

/// How far the flood is from a point, along its normal and against it.
struct Evidence {
  double ahead;
  double behind;
};

double distance_to_flood(const OutsideFlood& flood, const Eigen::Vector3d& point,
                         const Eigen::Vector3d& direction, double reach) {
  constexpr double farthest = 4.0;  // times the reach
  for (double t = reach; t <= farthest * reach; t += 0.5 * flood.voxel_size()) {
    if (flood.reaches(point + t * direction)) return t;
  }
  return std::numeric_limits<double>::infinity();
}

std::vector<Evidence> find_evidence(const PointCloud& cloud, const CloudSurface& surface,
                                    const OutsideFlood& flood, std::span<const double> reach) {
  std::vector<Evidence> evidence;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d& normal = surface.normals[i];
    evidence.push_back({distance_to_flood(flood, cloud.points[i], normal, reach[i]),
                        distance_to_flood(flood, cloud.points[i], -normal, reach[i])});
  }
  return evidence;
}

bool is_seen_from_both_sides(const Evidence& evidence, double voxel_size) {
  return std::isfinite(evidence.ahead) && std::isfinite(evidence.behind) &&
         std::abs(evidence.ahead - evidence.behind) <= voxel_size;
}

double share_seen_from_both_sides(std::span<const Evidence> evidence, double voxel_size) {
  const auto count = std::ranges::count_if(
      evidence, [&](const Evidence& e) { return is_seen_from_both_sides(e, voxel_size); });
  return static_cast<double>(count) / static_cast<double>(evidence.size());
}

/// The spacing around each point: the largest of its own and of its neighbours, since a hole
/// belongs to all that surround it.
std::vector<double> local_spacing(const CloudSurface& surface,
                                  const Neighbourhoods& neighbourhoods) {
  std::vector<double> spacing;
  for (std::size_t i = 0; i < surface.areas.size(); ++i) {
    double largest = surface.areas[i];
    for (const std::uint32_t neighbour : neighbourhoods.of(i)) {
      largest = std::max(largest, surface.areas[neighbour]);
    }
    spacing.push_back(std::sqrt(largest));
  }
  return spacing;
}

/// Spreads signs from points whose sign is known over the graph of neighbours, best agreement first
/// (Prim's algorithm).
class SignSpreading {
 public:
  SignSpreading(std::vector<Eigen::Vector3d>& normals, const Neighbourhoods& neighbourhoods)
      : normals_(normals), links_(normals.size()), is_known_(normals.size()) {
    for (std::size_t i = 0; i < normals.size(); ++i) {
      for (const std::uint32_t neighbour : neighbourhoods.of(i)) {
        links_[i].push_back(neighbour);
        links_[neighbour].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }

  bool is_known(std::size_t point) const { return is_known_[point]; }

  /// The sign of a point's normal is right.
  void set_known(std::size_t point) {
    is_known_[point] = true;
    for (const std::uint32_t neighbour : links_[point]) {
      if (is_known_[neighbour]) continue;
      const double disagreement = 1.0 - std::abs(normals_[point].dot(normals_[neighbour]));
      queue_.emplace(disagreement, static_cast<std::uint32_t>(point), neighbour);
    }
  }

  /// Gives all points their sign that are connected to known ones; returns those it gave.
  std::vector<std::size_t> spread() {
    std::vector<std::size_t> given;
    while (!queue_.empty()) {
      const auto [disagreement, from, to] = queue_.top();
      queue_.pop();
      if (is_known_[to]) continue;
      if (normals_[from].dot(normals_[to]) < 0) normals_[to] = -normals_[to];
      set_known(to);
      given.push_back(to);
    }
    return given;
  }

 private:
  using Link = std::tuple<double, std::uint32_t, std::uint32_t>;

  std::vector<Eigen::Vector3d>& normals_;
  std::vector<std::vector<std::uint32_t>> links_;
  std::vector<bool> is_known_;
  std::priority_queue<Link, std::vector<Link>, std::greater<>> queue_;
};

/// Turns the wall of a cavity so that its normals point into it: inward seen from the wall's top.
void orient_cavity(const PointCloud& cloud, std::size_t first, SignSpreading& spreading,
                   std::vector<Eigen::Vector3d>& normals) {
  spreading.set_known(first);
  std::vector<std::size_t> wall = spreading.spread();
  wall.push_back(first);
  const std::size_t top =
      *std::ranges::max_element(wall, {}, [&](std::size_t i) { return cloud.points[i].z(); });
  if (normals[top].z() <= 0) return;
  for (const std::size_t i : wall) normals[i] = -normals[i];
}

std::vector<Eigen::Vector3d> orient(const PointCloud& cloud, const CloudSurface& surface,
                                    const Neighbourhoods& neighbourhoods,
                                    std::span<const Evidence> evidence, double voxel_size) {
  std::vector<Eigen::Vector3d> normals = surface.normals;
  SignSpreading spreading(normals, neighbourhoods);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto [ahead, behind] = evidence[i];
    if (std::min(ahead, behind) + voxel_size >= std::max(ahead, behind)) continue;
    if (!std::isfinite(std::min(ahead, behind))) continue;
    if (behind < ahead) normals[i] = -normals[i];
    spreading.set_known(i);
  }
  spreading.spread();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!spreading.is_known(i)) orient_cavity(cloud, i, spreading, normals);
  }
  return normals;
}

}  // namespace

std::vector<Eigen::Vector3d> orient_normals(const PointCloud& cloud, const CloudSurface& surface,
                                            const Neighbourhoods& neighbourhoods) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : cloud.points) box.extend(point);
  const double size = box.sizes().maxCoeff();
  const std::vector<double> spacing = local_spacing(surface, neighbourhoods);
  for (double scale = least_scale;
       scale == least_scale || scale * surface.spacing <= farthest_reach * size; scale *= 2) {
    std::vector<double> reach;
    for (const double s : spacing) reach.push_back(std::min(scale * s, farthest_reach * size));
    const OutsideFlood flood(cloud.points, reach);
    const std::vector<Evidence> evidence = find_evidence(cloud, surface, flood, reach);
    if (share_seen_from_both_sides(evidence, flood.voxel_size()) > most_seen_from_both_sides) {
      continue;
    }
    return orient(cloud, surface, neighbourhoods, evidence, flood.voxel_size());
  }
  throw InvalidInput(
      "an open cloud: the points enclose no interior, since from outside most of them can be seen "
      "from both sides");
}

}  // namespace mdbd
