#include "features/descriptor/ball_surroundings.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "features/descriptor/soft_bins.h"

namespace mdbd {
namespace {

constexpr std::size_t kinds = surroundings_kinds.size();
constexpr SoftBins proportion_bins{0.0, 1.0, surroundings_nodes};

/// Weighted sums over balls of 1, x, y, z, r^2, xx, yy, zz, xy, xz, yz with the ball in the middle
/// as the origin; the twelfth is there for the vector unit.
using Moments = Eigen::Array<double, 12, 1>;

SoftBins trait_bins(SurroundingsTrait trait) {
  switch (trait) {
    case SurroundingsTrait::offset:
      return {0.0, 0.4, surroundings_nodes};
    case SurroundingsTrait::fill:
      return {-4.0, 1.0, surroundings_nodes};
    case SurroundingsTrait::size:
      return {-5.0, 0.0, surroundings_nodes};
  }
  return {};
}

double reach_of(const Surroundings& kind, double radius, double largest) {
  return kind.reach * (kind.unit == ReachUnit::own_radius ? radius : largest);
}

Moments moments_of(const Ball& ball, const Eigen::Vector3d& offset) {
  const double x = offset.x();
  const double y = offset.y();
  const double z = offset.z();
  Moments moments;
  moments << 1.0, x, y, z, ball.radius * ball.radius, x * x, y * y, z * z, x * y, x * z, y * z, 0.0;
  return ball.radius * ball.radius * ball.radius * moments;
}

std::array<Moments, kinds> gather(std::span<const Ball> balls, const Ball& middle, double largest) {
  std::array<Moments, kinds> sums;
  std::array<double, kinds> inverse_squares{};
  double farthest = 0.0;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    sums[kind].setZero();
    const double reach = reach_of(surroundings_kinds[kind], middle.radius, largest);
    inverse_squares[kind] = 1 / (reach * reach);
    farthest = std::max(farthest, reach * reach);
  }
  for (const Ball& ball : balls) {
    const Eigen::Vector3d offset = ball.center - middle.center;
    const double squared_distance = offset.squaredNorm();
    if (squared_distance >= farthest) continue;
    const Moments moments = moments_of(ball, offset);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const double nearness = 1 - squared_distance * inverse_squares[kind];
      if (nearness > 0) sums[kind] += nearness * nearness * moments;
    }
  }
  return sums;
}

/// The principal extents, squared, in increasing order.
Eigen::Vector3d squared_extents(const Moments& sums, const Eigen::Vector3d& centroid) {
  const Moments means = sums / sums[0];
  Eigen::Matrix3d moments;
  moments << means[5], means[8], means[9],  //
      means[8], means[6], means[10],        //
      means[9], means[10], means[7];
  moments -= centroid * centroid.transpose();
  // A ball's own second moment along each axis.
  moments.diagonal().array() += means[4] / 5;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

double trait_of(SurroundingsTrait trait, const Moments& sums, const Eigen::Vector3d& centroid,
                double reach, double size) {
  switch (trait) {
    case SurroundingsTrait::offset:
      return centroid.norm() / reach;
    case SurroundingsTrait::fill:
      // The weights of a space that is solid throughout have the integral 32 pi / 105 h^3, and the
      // sum has r^3 where a ball's volume is 4 pi / 3 r^3.
      return std::log2(sums[0] / (reach * reach * reach) * (105.0 / 24));
    case SurroundingsTrait::size:
      return size;
  }
  return 0.0;
}

/// Shares a weight between the eight nodes around a point.
void add(SurroundingsShares& shares, double weight, const std::array<SoftBin, 3>& bins) {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    std::size_t node = 0;
    double share = weight;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t upper = corner >> axis & 1U;
      node = node * surroundings_nodes + bins[axis].lower + upper;
      share *= upper == 1 ? bins[axis].share : 1 - bins[axis].share;
    }
    shares[node] += share;
  }
}

std::array<SoftBin, 3> find_nodes(const Surroundings& kind, const Moments& sums, const Ball& middle,
                                  double largest) {
  const Eigen::Vector3d centroid = sums.segment<3>(1) / sums[0];
  const Eigen::Vector3d squares = squared_extents(sums, centroid);
  const double trait = trait_of(kind.trait, sums, centroid, reach_of(kind, middle.radius, largest),
                                std::log2(middle.radius / largest));
  return {proportion_bins.find(std::sqrt(squares[1] / squares[2])),
          proportion_bins.find(std::sqrt(squares[0] / squares[1])),
          trait_bins(kind.trait).find(trait)};
}

}  // namespace

std::array<SurroundingsShares, kinds> ball_surroundings(std::span<const Ball> balls) {
  const double largest = std::ranges::max(balls, {}, &Ball::radius).radius;
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius * ball.radius;
  std::array<SurroundingsShares, kinds> shares{};
  for (const Ball& middle : balls) {
    const std::array<Moments, kinds> sums = gather(balls, middle, largest);
    const double weight = middle.radius * middle.radius / total;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      add(shares[kind], weight, find_nodes(surroundings_kinds[kind], sums[kind], middle, largest));
    }
  }
  return shares;
}

}  // namespace mdbd
