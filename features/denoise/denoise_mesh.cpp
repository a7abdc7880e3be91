#include "features/denoise/denoise_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "features/denoise/noise_estimate.h"
#include "features/denoise/umbrella_smoother.h"
#include "features/denoise/vertex_neighbours.h"
#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

constexpr double weakest = 0.5;  // strength
constexpr double rung = 2.0;     // each strength relative to the one before
constexpr int most_rungs = 14;
constexpr double worse = 3.0;    // the ladder ends where the mean error is so many times the least
constexpr int error_rings = 10;  // over which errors are averaged
constexpr int blend_rings = 3;

// Of neighbours whose normals differ: the difference, of unit vectors, that counts little, and the
// weight that is left of those beyond it.
constexpr double normal_spread = 0.35;
constexpr double least_weight = 1e-3;

using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Positions positions_of(const TriangleMesh& mesh) {
  Positions positions(mesh.vertices.size(), 3);
  for (Eigen::Index i = 0; i < positions.rows(); ++i) {
    positions.row(i) = mesh.vertices[static_cast<std::size_t>(i)].transpose();
  }
  return positions;
}

Positions unit_normals(const std::vector<Triangle>& triangles, const Positions& positions) {
  Positions normals = Positions::Zero(positions.rows(), 3);
  for (const auto& [a, b, c] : triangles) {
    const Eigen::RowVector3d ab = positions.row(b) - positions.row(a);
    const Eigen::RowVector3d ac = positions.row(c) - positions.row(a);
    const Eigen::RowVector3d normal = ab.cross(ac);
    for (const std::uint32_t corner : {a, b, c}) normals.row(corner) += normal;
  }
  normals.rowwise().normalize();
  return normals;
}

/// Each row becomes the mean of its own and those of the neighbours, several times.
void average(const VertexNeighbours& neighbours, int times, Columns& rows) {
  Columns next(rows.rows(), rows.cols());
  for (int i = 0; i < times; ++i) {
    for (std::uint32_t v = 0; v < neighbours.size(); ++v) {
      next.row(v) = rows.row(v);
      for (const std::uint32_t other : neighbours.of(v)) next.row(v) += rows.row(other);
      next.row(v) /= static_cast<double>(1 + neighbours.of(v).size());
    }
    std::swap(rows, next);
  }
}

/// A mesh smoothed with several strengths.
struct Ladder {
  std::vector<double> strengths;
  std::vector<Positions> smooth;
  std::vector<Eigen::VectorXd> errors;  // expected squares along the normal, for each vertex
};

Eigen::VectorXd expected_errors(const Positions& noisy, const Positions& smooth,
                                const Positions& normals, double level, double strength) {
  const double variance = level * level;
  const double constant = variance * (2 * UmbrellaSmoother::response(strength) - 1);
  const Eigen::VectorXd moves = (noisy - smooth).cwiseProduct(normals).rowwise().sum();
  return moves.array().square() + constant;
}

Ladder climb(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
             std::span<const double> weights, double level) {
  const UmbrellaSmoother smoother(neighbours, weights);
  const Positions noisy = positions_of(mesh);
  Ladder ladder;
  Positions smooth = noisy;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_rungs; ++i) {
    const double strength = weakest * std::pow(rung, i);
    smooth = smoother.smooth(noisy, strength, smooth);
    const Positions normals = unit_normals(mesh.triangles, smooth);
    ladder.strengths.push_back(strength);
    ladder.smooth.push_back(smooth);
    ladder.errors.push_back(expected_errors(noisy, smooth, normals, level, strength));
    const double mean = ladder.errors.back().mean();
    least = std::min(least, mean);
    if (mean > worse * std::max(least, 0.0)) break;
  }
  return ladder;
}

/// How much of each strength a vertex gets: that of the least error near it, blended.
Columns blending_shares(const Ladder& ladder, const VertexNeighbours& neighbours) {
  const auto rungs = static_cast<Eigen::Index>(ladder.strengths.size());
  Columns errors(neighbours.size(), rungs);
  for (Eigen::Index k = 0; k < rungs; ++k) errors.col(k) = ladder.errors[k];
  average(neighbours, error_rings, errors);
  Columns shares = Columns::Zero(errors.rows(), rungs);
  for (Eigen::Index v = 0; v < errors.rows(); ++v) {
    Eigen::Index best = 0;
    errors.row(v).minCoeff(&best);
    shares(v, best) = 1.0;
  }
  average(neighbours, blend_rings, shares);
  return shares;
}

struct Smoothed {
  Positions positions;
  double strength;  // geometric mean
};

Smoothed smooth_adaptively(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
                           std::span<const double> weights, double level) {
  const Ladder ladder = climb(mesh, neighbours, weights, level);
  const Columns shares = blending_shares(ladder, neighbours);
  Positions blended = Positions::Zero(shares.rows(), 3);
  double logarithms = 0.0;
  for (std::size_t k = 0; k < ladder.strengths.size(); ++k) {
    const auto share = shares.col(static_cast<Eigen::Index>(k));
    blended += share.asDiagonal() * ladder.smooth[k];
    logarithms += share.sum() * std::log(ladder.strengths[k]);
  }
  return {.positions = std::move(blended),
          .strength = std::exp(logarithms / static_cast<double>(shares.rows()))};
}

/// Low between neighbours on different sides of an edge of the surface.
std::vector<double> edge_weights(const VertexNeighbours& neighbours, const Positions& normals) {
  std::vector<double> weights;
  weights.reserve(neighbours.vertices.size());
  for (std::uint32_t v = 0; v < neighbours.size(); ++v) {
    for (const std::uint32_t other : neighbours.of(v)) {
      const double difference = (normals.row(v) - normals.row(other)).norm() / normal_spread;
      weights.push_back(std::exp(-0.5 * difference * difference) + least_weight);
    }
  }
  return weights;
}

}  // namespace

DenoisedMesh denoise_mesh(TriangleMesh mesh) {
  const double scale = enclosing_ball(mesh.vertices).radius;
  const VertexNeighbours neighbours = find_neighbours(mesh);
  const NoiseEstimate estimate = estimate_noise(mesh, neighbours, scale);
  if (!estimate.is_significant) return {.mesh = std::move(mesh)};

  const std::vector<double> equal(neighbours.vertices.size(), 1.0);
  const Positions guide = smooth_adaptively(mesh, neighbours, equal, estimate.level).positions;
  const auto weights = edge_weights(neighbours, unit_normals(mesh.triangles, guide));
  const Smoothed result = smooth_adaptively(mesh, neighbours, weights, estimate.level);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] = result.positions.row(static_cast<Eigen::Index>(i)).transpose();
  }
  return {.mesh = std::move(mesh), .noise = estimate.level / scale, .strength = result.strength};
}

}  // namespace mdbd
