#include "features/shape_io/read_point_cloud.h"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::array<std::string_view, 4> extensions = {".pcd", ".xyz", ".txt", ".csv"};

constexpr double largest_coordinate = 1e30;  // as of meshes
constexpr double smallest_extent = 1e-90;
constexpr std::size_t longest_header = 1 << 16;  // bytes, of a PLY file

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

PointCloud read_points(const std::string& ending, std::string_view bytes) {
  if (ending == ".pcd") return read_pcd(bytes);
  if (ending == ".ply") return read_ply_points(bytes);
  return read_point_table(bytes);
}

bool is_finite(const PointCloud& cloud, std::size_t point) {
  return cloud.points[point].allFinite();
}

/// For each point whether it is kept, and counts of those that are not.
std::vector<bool> choose_points(const PointCloud& cloud, PointCloudFile& file) {
  std::vector<bool> is_kept(cloud.points.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    is_kept[i] = is_finite(cloud, i);
    if (is_kept[i]) order.push_back(i);
  }
  file.points_not_finite = cloud.points.size() - order.size();
  const auto key = [&](std::size_t i) {
    const Eigen::Vector3d& point = cloud.points[i];
    return std::array{point.x(), point.y(), point.z()};
  };
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (key(order[i]) != key(order[i - 1])) continue;
    is_kept[order[i]] = false;
    ++file.points_duplicate;
  }
  return is_kept;
}

/// Makes unit vectors, or drops them all if one has no direction.
void normalise(std::vector<Eigen::Vector3d>& normals) {
  const bool are_usable = std::ranges::all_of(normals, [](const Eigen::Vector3d& normal) {
    return normal.allFinite() && normal.stableNorm() > 0;
  });
  if (!are_usable) normals.clear();
  for (Eigen::Vector3d& normal : normals) normal.stableNormalize();
}

void require_usable(const PointCloud& cloud) {
  if (cloud.points.empty()) throw InvalidInput("no point has finite coordinates");
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : cloud.points) box.extend(point);
  if (std::max(box.max().maxCoeff(), -box.min().minCoeff()) > largest_coordinate) {
    throw InvalidInput("a point has a coordinate beyond 1e30");
  }
  const double extent = box.sizes().maxCoeff();
  if (!(extent > 0)) throw InvalidInput("all points coincide");
  if (extent < smallest_extent) {
    throw InvalidInput("the cloud is smaller than 1e-90 units; scale it up");
  }
}

}  // namespace

std::span<const std::string_view> point_cloud_file_extensions() { return extensions; }

bool has_point_cloud_extension(const std::filesystem::path& path) {
  return std::ranges::count(extensions, ending_of(path)) > 0;
}

bool is_point_cloud_file(const std::filesystem::path& path) {
  if (ending_of(path) != ".ply") return has_point_cloud_extension(path);
  return has_ply_points_alone(read_beginning(path, longest_header));
}

PointCloudFile read_point_cloud(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending != ".ply" && !has_point_cloud_extension(path)) {
    throw InvalidInput("the name does not end in .pcd, .ply, .xyz, .txt or .csv");
  }
  PointCloudFile file = clean_point_cloud(read_points(ending, read_input_file(path)));
  file.format = ending.substr(1);
  return file;
}

PointCloudFile clean_point_cloud(const PointCloud& cloud) {
  PointCloudFile file;
  const std::vector<bool> is_kept = choose_points(cloud, file);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!is_kept[i]) continue;
    file.cloud.points.push_back(cloud.points[i]);
    if (cloud.has_normals()) file.cloud.normals.push_back(cloud.normals[i]);
  }
  normalise(file.cloud.normals);
  require_usable(file.cloud);
  return file;
}

}  // namespace mdbd
