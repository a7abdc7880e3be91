#include "perturbation/decimation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using Quadric = OpenMesh::Geometry::Quadricd;

// Further patches of a mesh that is no manifold at thousands of places cost more than they save.
constexpr int most_patch_layers = 16;

/// OpenMesh says on standard error which faces it refuses.
class Silence {
 public:
  Silence() : lock_(one_at_a_time()), was_enabled_(omerr().is_enabled()) { omerr().disable(); }
  ~Silence() {
    if (was_enabled_) omerr().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }

  std::lock_guard<std::mutex> lock_;
  bool was_enabled_;
};

/// The quadric error with planes through boundary edges. OpenMesh's own module has no such planes,
/// and takes errors that rounding made negative, as on every flat face, for illegal collapses.
class BoundaryAwareQuadrics final : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh> {
 public:
  explicit BoundaryAwareQuadrics(HalfEdgeMesh& mesh)
      : OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>(mesh, false) {}

  void initialize() override {
    quadrics_.assign(mesh().n_vertices(), Quadric());
    for (const FaceHandle face : mesh().faces()) add_face_plane(face);
    for (const HalfedgeHandle halfedge : mesh().halfedges()) {
      if (mesh().is_boundary(halfedge)) add_boundary_plane(halfedge);
    }
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    Quadric sum = of(collapse.v0);
    sum += of(collapse.v1);
    return static_cast<float>(std::max(0.0, sum(collapse.p1)));
  }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    of(collapse.v1) += of(collapse.v0);
  }

 private:
  Quadric& of(VertexHandle vertex) { return quadrics_[static_cast<std::size_t>(vertex.idx())]; }

  void add_face_plane(FaceHandle face) {
    for (const VertexHandle corner : mesh().fv_range(face)) {
      Quadric quadric(mesh().normal(face), mesh().point(corner));
      of(corner) += quadric *= mesh().calc_face_area(face);
    }
  }

  /// The plane through a boundary edge that stands on its face. It weighs as much as a face of the
  /// square of the edge.
  void add_boundary_plane(HalfedgeHandle boundary) {
    const FaceHandle face = mesh().face_handle(mesh().opposite_halfedge_handle(boundary));
    if (!face.is_valid()) return;
    const auto edge = mesh().calc_edge_vector(boundary);
    const double weight = edge.sqrnorm();
    const auto normal = (mesh().normal(face) % edge).normalize_cond();
    for (const VertexHandle end :
         {mesh().from_vertex_handle(boundary), mesh().to_vertex_handle(boundary)}) {
      Quadric quadric(normal, mesh().point(end));
      of(end) += quadric *= weight;
    }
  }

  std::vector<Quadric> quadrics_;
};

/// A mesh taken apart into patches that are manifolds, within the unit ball.
class Patches {
 public:
  explicit Patches(const TriangleMesh& mesh) : source_(mesh), ball_(enclosing_ball(mesh.vertices)) {
    half_edges_.request_vertex_status();
    half_edges_.request_edge_status();
    half_edges_.request_face_status();
    half_edges_.request_face_normals();
    add_all();
    lock_seams();
    half_edges_.update_face_normals();
  }

  HalfEdgeMesh& half_edges() { return half_edges_; }

  /// What is left of the mesh, put together again.
  TriangleMesh join() const {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> places(source_.vertices.size(), 0);
    for (const FaceHandle face : half_edges_.faces()) {
      if (half_edges_.status(face).deleted()) continue;
      Triangle triangle{};
      std::ranges::transform(half_edges_.fv_range(face), triangle.begin(),
                             [&](VertexHandle corner) { return origin(corner); });
      for (const std::uint32_t corner : triangle) places[corner] = 1;
      triangles.push_back(triangle);
    }
    TriangleMesh joined;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] == 0) continue;
      places[i] = static_cast<std::uint32_t>(joined.vertices.size());
      joined.vertices.push_back(source_.vertices[i]);
    }
    for (Triangle& triangle : triangles) {
      for (std::uint32_t& corner : triangle) corner = places[corner];
    }
    joined.triangles = std::move(triangles);
    return joined;
  }

 private:
  std::uint32_t origin(VertexHandle vertex) const {
    return origins_[static_cast<std::size_t>(vertex.idx())];
  }

  VertexHandle add_vertex(std::uint32_t index) {
    const Eigen::Vector3d place = (source_.vertices[index] - ball_.center) / ball_.radius;
    origins_.push_back(index);
    return half_edges_.add_vertex({place.x(), place.y(), place.z()});
  }

  void add_all() {
    const Silence silence;
    std::vector<Triangle> left = source_.triangles;
    for (int i = 0; i < most_patch_layers && !left.empty(); ++i) left = add_layer(left);
    for (const auto& [a, b, c] : left) {
      half_edges_.add_face(add_vertex(a), add_vertex(b), add_vertex(c));
    }
  }

  /// Adds faces with new vertices, which they share.
  /// @returns the faces that would make it no manifold
  std::vector<Triangle> add_layer(const std::vector<Triangle>& triangles) {
    std::vector<VertexHandle> handles(source_.vertices.size());
    std::vector<Triangle> refused;
    for (const Triangle& triangle : triangles) {
      for (const std::uint32_t corner : triangle) {
        if (!handles[corner].is_valid()) handles[corner] = add_vertex(corner);
      }
      const FaceHandle face =
          half_edges_.add_face(handles[triangle[0]], handles[triangle[1]], handles[triangle[2]]);
      if (!face.is_valid()) refused.push_back(triangle);
    }
    return refused;
  }

  /// Keeps the vertices that patches share and those where the parts of one patch only touch.
  void lock_seams() {
    std::vector<int> copies(source_.vertices.size(), 0);
    for (const VertexHandle vertex : half_edges_.vertices()) {
      if (!half_edges_.is_isolated(vertex)) ++copies[origin(vertex)];
    }
    for (const VertexHandle vertex : half_edges_.vertices()) {
      const auto outgoing = half_edges_.voh_range(vertex);
      const auto gaps = std::ranges::count_if(
          outgoing, [&](HalfedgeHandle halfedge) { return half_edges_.is_boundary(halfedge); });
      half_edges_.status(vertex).set_locked(copies[origin(vertex)] > 1 || gaps > 1);
    }
  }

  const TriangleMesh& source_;
  Ball ball_;
  HalfEdgeMesh half_edges_;
  std::vector<std::uint32_t> origins_;  // of the vertices of half_edges_: indices into source_
};

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, double fraction) {
  if (!(fraction > 0 && fraction <= 1)) {
    throw InvalidInput("the share of the faces to keep must be above 0 and at most 100 %");
  }
  const double wanted = std::round(fraction * static_cast<double>(mesh.triangles.size()));
  Patches patches(mesh);
  OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(patches.half_edges());
  OpenMesh::Decimater::ModHandleT<BoundaryAwareQuadrics> quadrics;
  OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle no_flips;
  decimater.add(quadrics);
  decimater.add(no_flips);
  decimater.initialize();
  decimater.decimate_to_faces(0, std::max<std::size_t>(4, static_cast<std::size_t>(wanted)));
  return patches.join();
}

}  // namespace mdbd
