#include "perturbation/similarity_transform.h"

#include <utility>

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"
#include "perturbation/random_vectors.h"

namespace mdbd {
namespace {

TriangleMesh transform_about(const Eigen::Vector3d& middle, const Eigen::Matrix3d& matrix,
                             TriangleMesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = middle + matrix * (vertex - middle);
  return mesh;
}

}  // namespace

TriangleMesh rotate(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  return transform_about(enclosing_ball(mesh.vertices).center,
                         random_rotation(random).toRotationMatrix(), mesh);
}

TriangleMesh translate(const TriangleMesh& mesh, double distance, std::uint64_t seed) {
  if (!(distance >= 0 && distance <= 1e6)) {
    throw InvalidInput("a translation must be from 0 to 1e6 diameters");
  }
  Random random(seed);
  const Eigen::Vector3d shift =
      distance * 2 * enclosing_ball(mesh.vertices).radius * random_direction(random);
  TriangleMesh moved = mesh;
  for (Eigen::Vector3d& vertex : moved.vertices) vertex += shift;
  return moved;
}

TriangleMesh scale(const TriangleMesh& mesh, double factor) {
  if (!(factor >= 1e-6 && factor <= 1e6)) {
    throw InvalidInput("a scale must be from 1e-6 to 1e6");
  }
  TriangleMesh scaled = mesh;
  for (Eigen::Vector3d& vertex : scaled.vertices) vertex *= factor;
  return scaled;
}

TriangleMesh mirror(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const Eigen::Vector3d normal = random_direction(random);
  const Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
  TriangleMesh mirrored = transform_about(enclosing_ball(mesh.vertices).center, reflection, mesh);
  for (Triangle& triangle : mirrored.triangles) std::swap(triangle[1], triangle[2]);
  return mirrored;
}

}  // namespace mdbd
