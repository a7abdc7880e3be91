#include "features/brep/flat_faces.h"

#include <algorithm>

namespace mdbd {

void FlatFaces::Selection::add(std::uint32_t triangle, const Triangle& corners) {
  number_of[triangle] = static_cast<std::uint32_t>(mesh.triangles.size());
  mesh.triangles.push_back(corners);
}

FlatFaces::FlatFaces(const Brep& brep, double edge_deflection) : edge_deflection_(edge_deflection) {
  const auto count = static_cast<std::uint32_t>(brep.mesh.triangles.size());
  for (Selection* selection : {&planar_, &straight_}) {
    selection->mesh.vertices = brep.mesh.vertices;
    selection->number_of.assign(count, none);
  }
  for (std::uint32_t t = 0; t < count; ++t) {
    if (brep.faces[brep.face_of[t]].kind != SurfaceKind::plane) continue;
    planar_.add(t, brep.mesh.triangles[t]);
    const auto& chords = brep.is_chord[t];
    if (std::ranges::any_of(chords, [](bool is_chord) { return is_chord; })) continue;
    straight_.add(t, brep.mesh.triangles[t]);
    const auto& [a, b, c] = brep.mesh.triangles[t];
    corners_.push_back({brep.mesh.vertices[a], brep.mesh.vertices[b], brep.mesh.vertices[c]});
  }
  convex_faces_ = std::make_unique<ConvexFaces>(straight_.mesh);
  regions_ = std::make_unique<FlatRegions>(planar_.mesh);
}

ConvexPolygon FlatFaces::piece_of(std::uint32_t triangle) const {
  const std::uint32_t number = straight_.number_of[triangle];
  if (number == none) return {};
  const ConvexPolygon face = convex_faces_->face_of(number);
  return face.empty() ? ConvexPolygon(corners_[number]) : face;
}

FlatRegion FlatFaces::around(const Eigen::Vector3d& point, std::uint32_t triangle) const {
  const std::uint32_t number = planar_.number_of[triangle];
  if (number == none) return {};
  FlatRegion region = regions_->around(point, number);
  region.radius = std::max(0.0, region.radius - edge_deflection_);
  return region;
}

}  // namespace mdbd
