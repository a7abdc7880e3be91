#include "features/decomposition/flat_pieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

// A hexagon's sides are so near to its centre, relative to its corners.
constexpr double apothem = 0.5 * std::numbers::sqrt3;
// A disc is made only if it reaches so much farther than the piece and is large for the distance;
// one that is known is used again if it reaches at least so far, relative to a new one.
constexpr double least_gain = 1.5;
constexpr double least_radius = 0.05;  // relative to the distance of the sample
constexpr double least_share = 0.5;

double clearance(ConvexPolygon polygon, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d side = edge(polygon, i);
    const double squared_length = side.squaredNorm();
    if (!(squared_length > 0)) continue;
    least = std::min(least, side.cross(point - polygon[i]).squaredNorm() / squared_length);
  }
  return std::sqrt(least);
}

std::array<Eigen::Vector3d, 6> hexagon(const Eigen::Vector3d& center, double radius,
                                       const Eigen::Vector3d& normal) {
  const Eigen::Vector3d first = normal.unitOrthogonal();
  const Eigen::Vector3d second = normal.cross(first);
  std::array<Eigen::Vector3d, 6> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi / 3.0 * i;
    corners[i] = center + radius * (std::cos(angle) * first + std::sin(angle) * second);
  }
  return corners;
}

bool is_disc_better(const DistanceSample& sample) {
  const double reach = apothem * sample.flat_region.radius;
  if (reach <= least_radius * std::abs(sample.distance)) return false;
  return sample.piece.empty() || reach > least_gain * clearance(sample.piece, sample.closest);
}

}  // namespace

const FlatPiece* FlatPieces::around(const DistanceSample& sample) {
  if (is_disc_better(sample)) return find_disc(sample);
  if (sample.piece.empty()) return nullptr;
  const auto [entry, is_new] = polygons_.try_emplace(sample.piece.data());
  if (is_new) entry->second = std::make_unique<FlatPiece>(sample.piece);
  return entry->second.get();
}

const FlatPiece* FlatPieces::find_disc(const DistanceSample& sample) {
  std::vector<Disc>& discs = discs_[sample.flat_region.number];
  const auto reach = [&](const Disc& disc) {
    return disc.clearance - (disc.center - sample.closest).norm();
  };
  const auto best = std::ranges::max_element(discs, {}, reach);
  const double wanted = apothem * sample.flat_region.radius;
  if (best != discs.end() && reach(*best) >= least_share * wanted) return best->piece.get();
  discs.push_back({sample.closest, wanted,
                   std::make_unique<FlatPiece>(hexagon(sample.closest, sample.flat_region.radius,
                                                       sample.flat_region.normal))});
  return discs.back().piece.get();
}

}  // namespace mdbd
