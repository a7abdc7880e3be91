#include "features/distance/mesh_distance_field.h"

#include <cmath>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/distance/closest_point.h"
#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

const TriangleMesh& require_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidInput("the mesh has no faces");
  return mesh;
}

// Of the surface, measured from a point near it, for the sake of rounding.
Eigen::Vector3d surface_centroid(const TriangleMesh& mesh, const Eigen::Vector3d& origin) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = mesh.vertices[a] - origin;
    const Eigen::Vector3d q = mesh.vertices[b] - origin;
    const Eigen::Vector3d r = mesh.vertices[c] - origin;
    const double doubled = (q - p).cross(r - p).norm();
    moment += doubled / 3.0 * (p + q + r);
    area += doubled;
  }
  return area > 0 ? Eigen::Vector3d(origin + moment / area) : origin;
}

}  // namespace

MeshDistanceField::MeshDistanceField(const TriangleMesh& mesh, bool is_closed)
    : enclosing_ball_(mdbd::enclosing_ball(require_triangles(mesh).vertices)),
      centroid_(surface_centroid(mesh, enclosing_ball_.center)),
      is_closed_(is_closed),
      tree_(mesh),
      winding_number_(tree_),
      faces_(mesh),
      regions_(mesh) {
  if (!(enclosing_ball_.radius > 0)) throw InvalidInput("all vertices of the mesh coincide");
}

void MeshDistanceField::measure(std::span<const DistanceQuery> queries,
                                std::span<DistanceSample> samples) const {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const DistanceQuery& query = queries[i];
    const ClosestPoint closest = find_closest_point(tree_, query.point, query.bound);
    const double distance = std::sqrt(closest.squared_distance);
    const Side side = side_of(query, distance);
    const bool is_inside =
        side == Side::unknown ? winding_number_(query.point) > 0.5 : side == Side::inside;
    samples[i] = {is_inside ? distance : -distance, closest.point, piece_of(closest.triangle),
                  regions_.around(closest.point, tree_.sources()[closest.triangle])};
  }
}

ConvexPolygon MeshDistanceField::piece_of(std::uint32_t triangle) const {
  const ConvexPolygon face = faces_.face_of(tree_.sources()[triangle]);
  return face.empty() ? ConvexPolygon(tree_.triangles()[triangle]) : face;
}

}  // namespace mdbd
