#include "features/descriptor/ball_surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/SVD>
#include <catch2/catch.hpp>

#include "features/descriptor/solid_frame.h"
#include "tests/support/ball_clouds.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

// The hat function of node i of an evenly spaced grid whose ends reach to infinity.
double hat(double x, double first, double last, std::size_t i) {
  const double end = surroundings_nodes - 1;
  const double position = std::clamp((x - first) / (last - first) * end, 0.0, end);
  return std::max(0.0, 1 - std::abs(position - static_cast<double>(i)));
}

double largest_radius(const std::vector<Ball>& balls) {
  double largest = 0.0;
  for (const Ball& ball : balls) largest = std::max(largest, ball.radius);
  return largest;
}

struct Found {
  double flatness, thickness, offset, fill;
};

// The surroundings as their definition has it: extents are singular values of the weighted
// positions, to which each ball adds the three semi-axes of a body of its own moments.
Found examine(const std::vector<Ball>& balls, const Ball& middle, double reach) {
  double mass = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  const auto weight = [&](const Ball& ball) {
    const double distance = (ball.center - middle.center).norm();
    return distance < reach
               ? std::pow(1 - std::pow(distance / reach, 2), 2) * std::pow(ball.radius, 3)
               : 0.0;
  };
  for (const Ball& ball : balls) {
    mass += weight(ball);
    centroid += weight(ball) * ball.center;
  }
  centroid /= mass;
  Eigen::MatrixX3d rows(4 * balls.size(), 3);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double root = std::sqrt(weight(balls[i]) / mass);
    const auto first = static_cast<Eigen::Index>(4 * i);
    rows.row(first) = root * (balls[i].center - centroid).transpose();
    rows.middleRows<3>(first + 1) =
        root * balls[i].radius / std::sqrt(5.0) * Eigen::Matrix3d::Identity();
  }
  const Eigen::VectorXd extents = rows.jacobiSvd().singularValues();
  // The integral of the weights over the ball of the reach, by the midpoint rule.
  double space = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps;
    space += 4 * std::numbers::pi * x * x * std::pow(1 - x * x, 2) / steps;
  }
  const double fill = 4.0 / 3 * std::numbers::pi * mass / (space * std::pow(reach, 3));
  return {extents[1] / extents[0], extents[2] / extents[1],
          (centroid - middle.center).norm() / reach, std::log2(fill)};
}

double trait_share(const Surroundings& kind, const Found& found, std::size_t node) {
  return kind.trait == SurroundingsTrait::offset ? hat(found.offset, 0.0, 0.4, node)
                                                 : hat(found.fill, -4.0, 1.0, node);
}

std::vector<double> expected_shares(const std::vector<Ball>& balls, const Surroundings& kind) {
  const double largest = largest_radius(balls);
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius * ball.radius;
  std::vector<double> shares(surroundings_size, 0.0);
  for (const Ball& ball : balls) {
    double unit = 1.0;
    if (kind.unit == ReachUnit::own_radius) unit = ball.radius;
    if (kind.unit == ReachUnit::largest_radius) unit = largest;
    const Found found = examine(balls, ball, kind.reach * unit);
    std::size_t node = 0;
    for (std::size_t i = 0; i < surroundings_nodes; ++i) {
      for (std::size_t j = 0; j < surroundings_nodes; ++j) {
        for (std::size_t k = 0; k < surroundings_nodes; ++k) {
          shares[node++] += ball.radius * ball.radius / total * hat(found.flatness, 0, 1, i) *
                            hat(found.thickness, 0, 1, j) * trait_share(kind, found, k);
        }
      }
    }
  }
  return shares;
}

/// Equal balls on a grid, each touching the next.
std::vector<Ball> grid(int columns, int rows, int layers) {
  std::vector<Ball> balls;
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) {
      for (int z = 0; z < layers; ++z) balls.push_back({Eigen::Vector3d(x, y, z), 0.5});
    }
  }
  return to_solid_frame(balls);
}

/// The share of the balls by the node of a proportion: axis 0 of e2 / e1, axis 1 of e3 / e2.
std::array<double, surroundings_nodes> marginal(const SurroundingsShares& shares, int axis) {
  std::array<double, surroundings_nodes> result{};
  for (std::size_t node = 0; node < shares.size(); ++node) {
    const std::size_t proportions = node / surroundings_nodes;
    result[axis == 0 ? proportions / surroundings_nodes : proportions % surroundings_nodes] +=
        shares[node];
  }
  return result;
}

}  // namespace

TEST_CASE("surroundings are what their definition says") {
  const std::vector<Ball> balls = to_solid_frame(random_balls(60, 7));
  const auto found = ball_surroundings(balls);
  for (std::size_t kind = 0; kind < surroundings_kinds.size(); ++kind) {
    const std::vector<double> expected = expected_shares(balls, surroundings_kinds[kind]);
    for (std::size_t i = 0; i < surroundings_size; ++i) {
      CHECK(std::abs(found[kind][i] - expected[i]) < 1e-6);
    }
  }
}

TEST_CASE("the shares of each kind sum to 1") {
  for (const SurroundingsShares& shares : ball_surroundings(to_solid_frame(random_balls(100, 2)))) {
    CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1.0));
  }
}

TEST_CASE("a rod, a plate and a lump are told apart by their proportions") {
  const auto rod = ball_surroundings(grid(60, 1, 1));
  const auto plate = ball_surroundings(grid(16, 16, 1));
  const auto lump = ball_surroundings(grid(7, 7, 7));
  constexpr std::size_t near = 0;
  CHECK(marginal(rod[near], 0)[0] + marginal(rod[near], 0)[1] > 0.95);
  CHECK(marginal(plate[near], 0)[3] + marginal(plate[near], 0)[2] > 0.9);
  CHECK(marginal(plate[near], 1)[0] + marginal(plate[near], 1)[1] > 0.9);
  CHECK(marginal(lump[near], 1)[3] + marginal(lump[near], 1)[2] > 0.9);
}

TEST_CASE("a longer rod has nearly the same surroundings out to the reach of its radii") {
  const auto shorter = ball_surroundings(grid(60, 1, 1));
  const auto longer = ball_surroundings(grid(120, 1, 1));
  for (std::size_t kind = 0; kind < 3; ++kind) {
    for (std::size_t i = 0; i < surroundings_size; ++i) {
      CHECK(std::abs(shorter[kind][i] - longer[kind][i]) < 0.1);
    }
  }
}

TEST_CASE("a ball alone is its own surroundings: a lump around its centre") {
  const auto found = ball_surroundings(to_solid_frame(std::vector<Ball>{{{4, 5, 6}, 2.0}}));
  const std::size_t lump = surroundings_size - surroundings_nodes;
  CHECK(found[0][lump] == Approx(1.0));  // 105 / 24 / 6^3 of it solid, less than the first node
  CHECK(found[2][lump] == Approx(1.0));  // no offset
  CHECK(found[3][lump] == Approx(1.0));  // no offset
  const double position = (std::log2(105.0 / 24 / 8) + 4) / 5 * 3;
  CHECK(found[1][lump + 1] == Approx(2 - position));
  CHECK(found[1][lump + 2] == Approx(position - 1));
}
