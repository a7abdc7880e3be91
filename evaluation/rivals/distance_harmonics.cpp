#include "evaluation/rivals/distance_harmonics.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/descriptor/spherical_harmonics.h"
#include "features/distance/mesh_distance_field.h"

namespace mdbd {
namespace {

// The width of the Gaussian relative to the outermost sphere: two cells of the paper's grid, whose
// half has 32.
constexpr double gaussian_width = 2.0 / 32;

/// Centroid and root mean square distance of the surface from it.
struct SurfaceFrame {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double size = 0.0;
};

SurfaceFrame frame_of(const TriangleMesh& mesh) {
  const auto for_each_triangle = [&](const auto& visit) {
    for (const auto& [i, j, k] : mesh.triangles) {
      const Eigen::Vector3d& a = mesh.vertices[i];
      const Eigen::Vector3d& b = mesh.vertices[j];
      const Eigen::Vector3d& c = mesh.vertices[k];
      visit(a, b, c, (b - a).cross(c - a).norm());
    }
  };
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for_each_triangle([&](const auto& a, const auto& b, const auto& c, double weight) {
    area += weight;
    moment += weight * (a + b + c) / 3;
  });
  SurfaceFrame frame{.centroid = moment / area, .size = 0.0};
  double squares = 0.0;
  for_each_triangle([&](const auto& a, const auto& b, const auto& c, double weight) {
    const Eigen::Vector3d sum = a + b + c - 3 * frame.centroid;
    squares += weight / 12 *
               ((a - frame.centroid).squaredNorm() + (b - frame.centroid).squaredNorm() +
                (c - frame.centroid).squaredNorm() + sum.squaredNorm());
  });
  frame.size = std::sqrt(squares / area);
  if (!(frame.size > 0) || !std::isfinite(frame.size)) {
    throw InvalidInput("has no surface whose distance could be measured");
  }
  return frame;
}

/// Points spread evenly over the sphere by the golden angle, all of the same weight.
std::vector<Eigen::Vector3d> spread_directions(int count) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double radius = std::sqrt(1 - z * z);
    directions.emplace_back(radius * std::cos(golden_angle * i),
                            radius * std::sin(golden_angle * i), z);
  }
  return directions;
}

}  // namespace

std::vector<float> compute_distance_harmonics(const TriangleMesh& mesh) {
  constexpr int direction_count = 1500;
  constexpr std::size_t count = harmonic_count(distance_degree);
  const SurfaceFrame frame = frame_of(mesh);
  const MeshDistanceField field(mesh, true);
  const std::vector<Eigen::Vector3d> directions = spread_directions(direction_count);
  const SphericalHarmonics harmonics(distance_degree);
  std::vector<std::array<double, count>> basis(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) harmonics.evaluate(directions[i], basis[i]);

  std::vector<DistanceQuery> queries(directions.size());
  std::vector<DistanceSample> samples(directions.size());
  std::vector<double> amplitudes;
  for (int shell = 1; shell <= distance_shells; ++shell) {
    const double radius = static_cast<double>(shell) / distance_shells;  // of the outermost sphere
    for (std::size_t i = 0; i < directions.size(); ++i) {
      // The side is of no interest: given, the field need not find it out.
      queries[i] = {.point = frame.centroid + 2 * frame.size * radius * directions[i],
                    .side = Side::outside};
    }
    field.measure(queries, samples);
    std::array<double, count> sums{};
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double distance = samples[i].distance / (2 * frame.size * gaussian_width);
      const double value = std::exp(-distance * distance) * radius / direction_count;
      for (std::size_t j = 0; j < count; ++j) sums[j] += value * basis[i][j];
    }
    append_amplitudes(sums, distance_degree, 1.0, amplitudes);
  }
  return {amplitudes.begin(), amplitudes.end()};
}

}  // namespace mdbd
