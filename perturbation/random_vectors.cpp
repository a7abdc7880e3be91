#include "perturbation/random_vectors.h"

#include <cmath>
#include <numbers>

namespace mdbd {

Eigen::Vector3d random_in_unit_ball(Random& random) {
  while (true) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    const Eigen::Vector3d vector(x, y, z);
    if (vector.squaredNorm() <= 1) return vector;
  }
}

Eigen::Vector3d random_direction(Random& random) {
  while (true) {
    const Eigen::Vector3d vector = random_in_unit_ball(random);
    if (vector.squaredNorm() > 1e-6) return vector.normalized();
  }
}

Eigen::Quaterniond random_rotation(Random& random) {
  const double share = random.uniform();
  const double first = 2 * std::numbers::pi * random.uniform();
  const double second = 2 * std::numbers::pi * random.uniform();
  const double a = std::sqrt(1 - share);
  const double b = std::sqrt(share);
  return {b * std::cos(second), a * std::sin(first), a * std::cos(first), b * std::sin(second)};
}

}  // namespace mdbd
