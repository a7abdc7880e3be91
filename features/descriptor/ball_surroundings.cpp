#include "features/descriptor/ball_surroundings.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

namespace mdbd {
namespace {

constexpr std::size_t kinds = surroundings_kinds.size();

/// 1, x, y, z, r^2, xx, yy, zz, xy, xz, yz of a ball, times r^3, or weighted sums of them; the
/// twelfth is there for the vector unit.
using Moments = Eigen::Array<double, 12, 1>;

double reach_of(const Surroundings& kind, double own_radius, double largest_radius) {
  switch (kind.unit) {
    case ReachUnit::own_radius:
      return kind.reach * own_radius;
    case ReachUnit::largest_radius:
      return kind.reach * largest_radius;
    case ReachUnit::shape_size:
      return kind.reach;  // in the frame of the solid
  }
  return kind.reach;
}

std::vector<Moments> moments_of(std::span<const Ball> balls) {
  std::vector<Moments> result;
  result.reserve(balls.size());
  for (const Ball& ball : balls) {
    const double x = ball.center.x();
    const double y = ball.center.y();
    const double z = ball.center.z();
    const double square = ball.radius * ball.radius;
    Moments moments;
    moments << 1.0, x, y, z, square, x * x, y * y, z * z, x * y, x * z, y * z, 0.0;
    result.push_back(square * ball.radius * moments);
  }
  return result;
}

void square_distances(std::span<const Ball> balls, const Eigen::Vector3d& from,
                      std::span<double> squares) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    squares[i] = (balls[i].center - from).squaredNorm();
  }
}

/// The weighted sum of the moments of the balls within a reach. Which these are is found out first,
/// without a branch that cannot be foreseen.
/// @param squares of the balls' distances from the middle
/// @param within room for as many numbers
Moments gather(std::span<const double> squares, std::span<const Moments> moments, double reach,
               std::span<std::size_t> within) {
  const double squared_reach = reach * reach;
  std::size_t count = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    within[count] = i;
    count += squares[i] < squared_reach ? 1 : 0;
  }
  const double inverse = 1 / squared_reach;
  Moments sum = Moments::Zero();
  for (const std::size_t i : within.first(count)) {
    const double nearness = 1 - squares[i] * inverse;
    sum += nearness * nearness * moments[i];
  }
  return sum;
}

/// The principal extents, squared, in increasing order.
Eigen::Vector3d squared_extents(const Moments& sums, const Eigen::Vector3d& centroid) {
  const Moments means = sums / sums[0];
  Eigen::Matrix3d moments;
  moments << means[5], means[8], means[9],  //
      means[8], means[6], means[10],        //
      means[9], means[10], means[7];
  moments -= centroid * centroid.transpose();
  // A ball's own second moment along each axis: none is smaller, but for rounding.
  const double own = means[4] / 5;
  moments.diagonal().array() += own;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseMax(own);
}

double trait_of(SurroundingsTrait trait, double mass, double offset, double reach) {
  switch (trait) {
    case SurroundingsTrait::offset:
      return offset / reach;
    case SurroundingsTrait::fill:
      // The weights of a space that is solid throughout have the integral 32 pi / 105 h^3, and the
      // sum has r^3 where a ball's volume is 4 pi / 3 r^3.
      return std::log2(mass / (reach * reach * reach) * (105.0 / 24));
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

std::array<SoftBin, 3> find_nodes(SurroundingsTrait trait, const Moments& sums,
                                  const Eigen::Vector3d& middle, double reach) {
  const Eigen::Vector3d centroid = sums.segment<3>(1) / sums[0];
  const Eigen::Vector3d squares = squared_extents(sums, centroid);
  const double value = trait_of(trait, sums[0], (centroid - middle).norm(), reach);
  return {proportion_nodes.find(std::sqrt(squares[1] / squares[2])),
          proportion_nodes.find(std::sqrt(squares[0] / squares[1])),
          trait_nodes(trait).find(value)};
}

}  // namespace

std::array<SurroundingsShares, kinds> ball_surroundings(std::span<const Ball> balls) {
  const double largest = std::ranges::max(balls, {}, &Ball::radius).radius;
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius * ball.radius;
  const std::vector<Moments> moments = moments_of(balls);
  std::vector<double> squares(balls.size());
  std::vector<std::size_t> within(balls.size());
  std::array<SurroundingsShares, kinds> shares{};
  for (const Ball& middle : balls) {
    square_distances(balls, middle.center, squares);
    const double weight = middle.radius * middle.radius / total;
    for (std::size_t i = 0; i < kinds; ++i) {
      const Surroundings& kind = surroundings_kinds[i];
      const double reach = reach_of(kind, middle.radius, largest);
      const Moments sums = gather(squares, moments, reach, within);
      add(shares[i], weight, find_nodes(kind.trait, sums, middle.center, reach));
    }
  }
  return shares;
}

}  // namespace mdbd
