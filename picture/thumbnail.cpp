#include "picture/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "picture/depth_image.h"
#include "picture/encode_png.h"

namespace mdbd {
namespace {

constexpr int samples_per_pixel = 2;  ///< along a side, so that edges are smooth
constexpr int image_size = samples_per_pixel * thumbnail_size;
constexpr double margin = 8.0;        ///< samples
constexpr double outline_step = 9.0;  ///< samples

constexpr int coverages = samples_per_pixel * samples_per_pixel;
constexpr int shades = 32;

/// Rows are the picture's right, its up, and towards the viewer.
Eigen::Matrix3d view_axes() {
  const Eigen::Vector3d viewer = Eigen::Vector3d(0.55, -0.75, 0.5).normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(viewer).normalized();
  Eigen::Matrix3d axes;
  axes << right.transpose(), viewer.cross(right).transpose(), viewer.transpose();
  return axes;
}

/// Takes points of a shape to samples of an image which the shape fills.
class View {
 public:
  void include(const Eigen::Vector3d& point, double radius = 0.0) {
    const Eigen::Vector3d seen = axes_ * point;
    lowest_ = lowest_.cwiseMin((seen.array() - radius).matrix());
    highest_ = highest_.cwiseMax((seen.array() + radius).matrix());
  }

  /// Settles the view. @returns false if there is nothing to be seen
  bool fit() {
    const double extent = (highest_ - lowest_).head<2>().maxCoeff();
    scale_ = (image_size - 2 * margin) / extent;
    return extent > 0 && std::isfinite(extent) && std::isfinite(scale_);
  }

  double scale() const { return scale_; }
  Eigen::Vector3d direction(const Eigen::Vector3d& vector) const { return axes_ * vector; }
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d middle = 0.5 * lowest_ + 0.5 * highest_;
    return scale_ * (axes_ * point - middle) +
           Eigen::Vector3d(0.5 * image_size, 0.5 * image_size, 0.0);
  }

 private:
  Eigen::Matrix3d axes_ = view_axes();
  Eigen::Vector3d lowest_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d highest_ = -lowest_;
  double scale_ = 0.0;
};

/// Colour 0 is transparent; then each coverage has all shades.
std::vector<Rgba> make_palette() {
  constexpr std::array dark = {34.0, 50.0, 74.0};
  constexpr std::array bright = {226.0, 235.0, 245.0};
  std::vector<Rgba> palette = {{0, 0, 0, 0}};
  for (int coverage = 1; coverage <= coverages; ++coverage) {
    for (int shade = 0; shade < shades; ++shade) {
      const double share = shade / (shades - 1.0);
      Rgba colour{};
      for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = static_cast<std::uint8_t>(dark[i] + share * (bright[i] - dark[i]));
      }
      colour[3] = static_cast<std::uint8_t>(255 * coverage / coverages);
      palette.push_back(colour);
    }
  }
  return palette;
}

std::uint8_t pixel(const DepthImage& image, int column, int row) {
  int covered = 0;
  float sum = 0.0F;
  for (int sample = 0; sample < coverages; ++sample) {
    const float brightness = image.brightness(samples_per_pixel * column + sample % 2,
                                              samples_per_pixel * row + sample / 2);
    if (brightness == DepthImage::nothing) continue;
    ++covered;
    sum += brightness;
  }
  if (covered == 0) return 0;
  const float share = std::clamp(sum / static_cast<float>(covered), 0.0F, 1.0F);
  const auto shade = static_cast<int>(std::lround(share * (shades - 1)));
  return static_cast<std::uint8_t>(1 + (covered - 1) * shades + shade);
}

std::string to_png(DepthImage image) {
  image.draw_outlines(outline_step);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(thumbnail_size) * thumbnail_size);
  for (int row = 0; row < thumbnail_size; ++row) {
    for (int column = 0; column < thumbnail_size; ++column) {
      pixels.push_back(pixel(image, column, row));
    }
  }
  static const std::vector<Rgba> palette = make_palette();
  return encode_png(pixels, thumbnail_size, thumbnail_size, palette);
}

std::string draw_mesh(const TriangleMesh& mesh) {
  View view;
  for (const Eigen::Vector3d& vertex : mesh.vertices) view.include(vertex);
  if (!view.fit()) return {};
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) seen.push_back(view(vertex));
  DepthImage image(image_size);
  for (const Triangle& triangle : mesh.triangles) {
    image.draw_triangle({seen[triangle[0]], seen[triangle[1]], seen[triangle[2]]});
  }
  return to_png(std::move(image));
}

/// As large as is needed to close a surface that fills half of the image.
double splat_radius(std::size_t points) {
  return std::clamp(1.6 * image_size / std::sqrt(static_cast<double>(points)), 1.5, 14.0);
}

std::string draw_cloud(const PointCloud& cloud) {
  View view;
  for (const Eigen::Vector3d& point : cloud.points) view.include(point);
  if (!view.fit()) return {};
  DepthImage image(image_size);
  const double radius = splat_radius(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    image.draw_disc(view(cloud.points[i]), view.direction(cloud.normals[i]), radius);
  }
  return to_png(std::move(image));
}

}  // namespace

std::string draw_balls(std::span<const Ball> balls) {
  View view;
  for (const Ball& ball : balls) view.include(ball.center, ball.radius);
  if (!view.fit()) return {};
  DepthImage image(image_size);
  for (const Ball& ball : balls) image.draw_ball(view(ball.center), view.scale() * ball.radius);
  return to_png(std::move(image));
}

std::string draw_thumbnail(const VisibleSurface& surface, std::span<const Ball> balls) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&surface)) return draw_mesh(*mesh);
  if (const auto* cloud = std::get_if<PointCloud>(&surface)) return draw_cloud(*cloud);
  return draw_balls(balls);
}

}  // namespace mdbd
