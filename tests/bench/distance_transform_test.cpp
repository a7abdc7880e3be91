#include "bench/rival/distance_transform.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

struct Image {
  Eigen::Array3i counts;
  std::vector<std::uint8_t> is_inside;

  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * counts.y() + y) * counts.x() + x;
  }
};

// Voxels that are inside with some probability, but for the outermost.
Image random_image(const Eigen::Array3i& counts, double share) {
  Image image{counts, std::vector<std::uint8_t>(static_cast<std::size_t>(counts.prod()), 0)};
  std::mt19937 random(1);
  std::bernoulli_distribution is_inside(share);
  for (int z = 1; z + 1 < counts.z(); ++z) {
    for (int y = 1; y + 1 < counts.y(); ++y) {
      for (int x = 1; x + 1 < counts.x(); ++x) {
        image.is_inside[image.index(x, y, z)] = is_inside(random) ? 1 : 0;
      }
    }
  }
  return image;
}

template <typename Function>
void for_each_voxel(const Image& image, const Function& function) {
  for (int z = 0; z < image.counts.z(); ++z) {
    for (int y = 0; y < image.counts.y(); ++y) {
      for (int x = 0; x < image.counts.x(); ++x) function(Eigen::Array3i(x, y, z));
    }
  }
}

std::vector<float> transform_by_brute_force(const Image& image) {
  std::vector<float> values;
  for_each_voxel(image, [&](const Eigen::Array3i& from) {
    int nearest = image.counts.square().sum();
    for_each_voxel(image, [&](const Eigen::Array3i& to) {
      if (image.is_inside[image.index(to.x(), to.y(), to.z())] != 0) return;
      nearest = std::min(nearest, (from - to).square().sum());
    });
    values.push_back(static_cast<float>(nearest));
  });
  return values;
}

}  // namespace

TEST_CASE("the distance transform equals brute force") {
  const double share = GENERATE(0.0, 0.3, 0.9, 0.99, 1.0);
  const Image image = random_image({21, 12, 9}, share);
  CAPTURE(share);
  CHECK(bench::squared_distance_transform(image.is_inside, image.counts) ==
        transform_by_brute_force(image));
}
