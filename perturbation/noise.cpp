#include "perturbation/noise.h"

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"
#include "perturbation/random_vectors.h"

namespace mdbd {

TriangleMesh displace_vertices(const TriangleMesh& mesh, double bound, std::uint64_t seed) {
  if (!(bound >= 0 && bound <= 1)) throw InvalidInput("noise must be from 0 to 100 %");
  const double length = bound * 2 * enclosing_ball(mesh.vertices).radius;
  Random random(seed);
  TriangleMesh noisy = mesh;
  for (Eigen::Vector3d& vertex : noisy.vertices) vertex += length * random_in_unit_ball(random);
  return noisy;
}

}  // namespace mdbd
