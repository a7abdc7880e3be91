#include "evaluation/certificate/mesh_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/StdVector>
#include <unsupported/Eigen/BVH>

namespace mdbd {
namespace {

using Box = Eigen::AlignedBox3d;

double squared_distance_from_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& x) {
  const Eigen::Vector3d ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0 ? std::clamp(ab.dot(x - a) / length, 0.0, 1.0) : 0.0;
  return (x - a - t * ab).squaredNorm();
}

// A triangle with its plane. The edges count everywhere, the plane where the foot is inside.
struct Facet {
  Eigen::Vector3d a, b, c;
  Eigen::Vector3d normal;  // of unit length; zero without area

  Facet(const Eigen::Vector3d& first, const Eigen::Vector3d& second, const Eigen::Vector3d& third)
      : a(first), b(second), c(third), normal((b - a).cross(c - a)) {
    const double length = normal.norm();
    normal = length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero();
  }

  Box box() const { return Box(a).extend(b).extend(c); }

  bool is_above(const Eigen::Vector3d& x) const {
    return normal.dot((b - a).cross(x - a)) > 0 && normal.dot((c - b).cross(x - b)) > 0 &&
           normal.dot((a - c).cross(x - c)) > 0;
  }

  double squared_distance(const Eigen::Vector3d& x) const {
    if (is_above(x)) return std::pow(normal.dot(x - a), 2);
    return std::min({squared_distance_from_edge(a, b, x), squared_distance_from_edge(b, c, x),
                     squared_distance_from_edge(c, a, x)});
  }
};

// What Eigen's BVMinimize and BVIntersect ask, in Eigen's names.
// NOLINTBEGIN(readability-identifier-naming)
struct NearestQuery {
  using Scalar = double;
  const std::vector<Facet>& facets;
  const Eigen::Vector3d& point;

  double minimumOnVolume(const Box& box) const { return box.squaredExteriorDistance(point); }
  double minimumOnObject(int facet) const { return facets[facet].squared_distance(point); }
};

struct ClearanceQuery {
  const std::vector<Facet>& facets;
  const Eigen::Vector3d& point;
  double squared_radius;
  bool is_hit = false;

  bool intersectVolume(const Box& box) const {
    return box.squaredExteriorDistance(point) < squared_radius;
  }
  bool intersectObject(int facet) {  // true ends the search
    is_hit = facets[facet].squared_distance(point) < squared_radius;
    return is_hit;
  }
};
// NOLINTEND(readability-identifier-naming)

// Adds up angles given as (cosine, sine), to any scale, by multiplying complex numbers and counting
// how often the sum passes half a turn: one arc tangent for a sum instead of one for each angle.
class AngleSum {
 public:
  void add(double cosine, double sine) {
    const double x = cosine_ * cosine - sine_ * sine;
    const double y = cosine_ * sine + sine_ * cosine;
    if (x == 0 && y == 0) return;
    if (sine > 0 && sine_ >= 0 && y < 0) ++turns_;
    if (sine < 0 && sine_ < 0 && y >= 0) --turns_;
    cosine_ = x;
    sine_ = y;
    const double size = std::abs(x) + std::abs(y);
    if (size < 1e-100 || size > 1e100) {
      cosine_ /= size;
      sine_ /= size;
    }
  }

  /// In turns.
  double total() const { return turns_ + std::atan2(sine_, cosine_) / (2 * std::numbers::pi); }

 private:
  double cosine_ = 1.0;
  double sine_ = 0.0;
  int turns_ = 0;
};

}  // namespace

struct MeshMeasure::Hierarchy {
  std::vector<Facet> facets;
  Eigen::KdBVH<double, 3, int> tree;
};

MeshMeasure::MeshMeasure(const TriangleMesh& mesh) : mesh_(mesh) {
  auto hierarchy = std::make_unique<Hierarchy>();
  std::vector<Box, Eigen::aligned_allocator<Box>> boxes;
  for (const auto& [a, b, c] : mesh.triangles) {
    hierarchy->facets.emplace_back(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    boxes.push_back(hierarchy->facets.back().box());
  }
  std::vector<int> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  hierarchy->tree.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
  hierarchy_ = std::move(hierarchy);
}

MeshMeasure::~MeshMeasure() = default;

double MeshMeasure::distance(const Eigen::Vector3d& point) const {
  NearestQuery query{hierarchy_->facets, point};
  return std::sqrt(Eigen::BVMinimize(hierarchy_->tree, query));
}

bool MeshMeasure::is_clear(const Eigen::Vector3d& point, double radius) const {
  ClearanceQuery query{hierarchy_->facets, point, radius * radius};
  Eigen::BVIntersect(hierarchy_->tree, query);
  return !query.is_hit;
}

double MeshMeasure::winding_number(const Eigen::Vector3d& point) const {
  std::vector<Eigen::Vector3d> offsets;
  std::vector<double> lengths;
  offsets.reserve(mesh_.vertices.size());
  lengths.reserve(mesh_.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh_.vertices) {
    offsets.push_back(vertex - point);
    lengths.push_back(offsets.back().norm());
  }
  AngleSum half_angles;
  for (const auto& [i, j, k] : mesh_.triangles) {
    const Eigen::Vector3d& a = offsets[i];
    const Eigen::Vector3d& b = offsets[j];
    const Eigen::Vector3d& c = offsets[k];
    half_angles.add(lengths[i] * lengths[j] * lengths[k] + a.dot(b) * lengths[k] +
                        b.dot(c) * lengths[i] + c.dot(a) * lengths[j],
                    a.dot(b.cross(c)));
  }
  return half_angles.total();
}

}  // namespace mdbd
