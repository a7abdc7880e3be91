#include "picture/thumbnail.h"

#include <vector>

#include <catch2/catch.hpp>
#include <png.h>

#include "picture/encode_png.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::vector<Rgba> decode(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = PNG_FORMAT_RGBA;
  REQUIRE(image.width == static_cast<unsigned>(thumbnail_size));
  REQUIRE(image.height == static_cast<unsigned>(thumbnail_size));
  std::vector<Rgba> pixels(static_cast<std::size_t>(image.width) * image.height);
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

/// The share of the picture that is covered.
double coverage(const std::string& file) {
  double sum = 0.0;
  const std::vector<Rgba> pixels = decode(file);
  for (const Rgba& pixel : pixels) sum += pixel[3] / 255.0;
  return sum / static_cast<double>(pixels.size());
}

// Of a round picture that fills its square but for the margins.
constexpr double disc = 3.14159265 / 4 * 0.95 * 0.95;

}  // namespace

TEST_CASE("a ball's picture is a disc, drawn from balls, a mesh or points") {
  const std::vector<Ball> balls = {{{5, 6, 7}, 1000.0}};
  CHECK(coverage(draw_balls(balls)) == Approx(disc).epsilon(0.01));
  CHECK(draw_thumbnail({}, balls) == draw_balls(balls));
  CHECK(coverage(draw_thumbnail(make_sphere(1e-6, 30), {})) == Approx(disc).epsilon(0.02));
  PointCloud cloud;
  for (const Eigen::Vector3d& point : make_sphere(1.0, 30).vertices) {
    cloud.points.push_back(point);
    cloud.normals.push_back(point);
  }
  CHECK(coverage(draw_thumbnail(cloud, {})) == Approx(disc).epsilon(0.05));
}

TEST_CASE("a picture depends on neither place nor scale") {
  TriangleMesh mesh = make_cube();
  const std::string picture = draw_thumbnail(mesh, {});
  CHECK_FALSE(picture.empty());
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = 1024.0 * vertex + Eigen::Vector3d(2048, -4096, 0);
  }
  CHECK(draw_thumbnail(mesh, {}) == picture);
}

TEST_CASE("what has no extent, or too much, has no picture") {
  CHECK(draw_balls({}).empty());
  CHECK(draw_thumbnail(TriangleMesh{}, {}).empty());
  CHECK(draw_thumbnail(TriangleMesh{.vertices = {{1, 2, 3}}, .triangles = {}}, {}).empty());
  TriangleMesh huge = make_cube();
  for (Eigen::Vector3d& vertex : huge.vertices) vertex = 1.7e308 * (vertex.array() - 0.5).matrix();
  CHECK_NOTHROW(draw_thumbnail(huge, {}));
}
