#include "features/brep/deviation.h"

#include "features/brep/closest_on_surface.h"
#include "features/core/triangle.h"

namespace mdbd {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d lift_to_surface(const Brep& brep, const BrepFace& face, const Triangle& corners,
                         const Vector3d& weight) {
  Vector2d uv = Vector2d::Zero();
  Vector3d point = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    uv += weight[i] * brep.parameters[corners[i]];
    point += weight[i] * brep.mesh.vertices[corners[i]];
  }
  if (face.kind == SurfaceKind::other) return face.surface->at(uv).point;
  // At poles and apices parameters say nothing of what is between them and other points.
  const auto foot = find_foot(face, point, uv, uv, uv);
  return foot ? foot->point : point;
}

double measure_deviation(const Brep& brep, std::size_t triangle, const Vector3d& weight) {
  const Triangle& t = brep.mesh.triangles[triangle];
  const TriangleCorners corners{brep.mesh.vertices[t[0]], brep.mesh.vertices[t[1]],
                                brep.mesh.vertices[t[2]]};
  const Vector3d lifted = lift_to_surface(brep, brep.faces[brep.face_of[triangle]], t, weight);
  return (closest_point(corners, lifted) - lifted).norm();
}

}  // namespace mdbd
