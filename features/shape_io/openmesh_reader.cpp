#include "features/shape_io/openmesh_reader.h"

#include <locale>
#include <mutex>
#include <sstream>
#include <utility>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include "features/core/errors.h"

namespace mdbd {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using OpenMesh::Attributes::StatusInfo;

/// Gathers vertices and faces as they come. Everything else that a reader can hand over (normals,
/// colours, half-edges …) is not asked for and, should it come, ignored.
class SoupImporter final : public OpenMesh::IO::BaseImporter {
 public:
  explicit SoupImporter(PolygonMesh& mesh) : mesh_(mesh) {}

  VertexHandle add_vertex() override { return add(Eigen::Vector3d::Zero()); }
  VertexHandle add_vertex(const OpenMesh::Vec3f& point) override { return add(to_eigen(point)); }
  VertexHandle add_vertex(const OpenMesh::Vec3d& point) override { return add(to_eigen(point)); }

  void set_point(VertexHandle vertex, const OpenMesh::Vec3f& point) override {
    mesh_.vertices.at(static_cast<std::size_t>(vertex.idx())) = to_eigen(point);
  }

  FaceHandle add_face(const VHandles& corners) override {
    for (const VertexHandle corner : corners) {
      mesh_.corners.push_back(static_cast<std::uint32_t>(corner.idx()));
    }
    mesh_.face_ends.push_back(mesh_.corners.size());
    return FaceHandle(static_cast<int>(mesh_.face_count()) - 1);
  }

  std::size_t n_vertices() const override { return mesh_.vertices.size(); }
  std::size_t n_faces() const override { return mesh_.face_count(); }
  std::size_t n_edges() const override { return 0; }

  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_normal(VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(VertexHandle, const OpenMesh::Vec3d&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_color(VertexHandle, const OpenMesh::Vec4f&) override {}
  void set_texcoord(VertexHandle, const OpenMesh::Vec2f&) override {}
  void set_status(VertexHandle, const StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const OpenMesh::Vec2f&) override {}
  void set_texcoord(VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const OpenMesh::Vec3f&) override {}
  void set_status(HalfedgeHandle, const StatusInfo&) override {}
  void set_color(EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(EdgeHandle, const OpenMesh::Vec3f&) override {}
  void set_color(EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_status(EdgeHandle, const StatusInfo&) override {}
  void set_normal(FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(FaceHandle, const OpenMesh::Vec3d&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_color(FaceHandle, const OpenMesh::Vec4f&) override {}
  void set_status(FaceHandle, const StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  template <typename Point>
  static Eigen::Vector3d to_eigen(const Point& point) {
    return {point[0], point[1], point[2]};
  }

  VertexHandle add(const Eigen::Vector3d& vertex) {
    mesh_.vertices.push_back(vertex);
    return VertexHandle(static_cast<int>(mesh_.vertices.size()) - 1);
  }

  PolygonMesh& mesh_;
};

// OpenMesh's readers keep the state of the file at hand in global objects.
bool read_alone(PlainFile& file, SoupImporter& importer) {
  static std::mutex one_at_a_time;
  std::istringstream stream(std::move(file.bytes), std::ios::in | std::ios::binary);
  stream.imbue(std::locale::classic());
  OpenMesh::IO::Options options;
  if (file.is_binary) options += OpenMesh::IO::Options::Binary;
  const std::lock_guard lock(one_at_a_time);
  return OpenMesh::IO::IOManager().read(stream, file.extension, importer, options) &&
         !stream.fail();
}

}  // namespace

PolygonMesh read_with_openmesh(PlainFile file) {
  PolygonMesh mesh;
  mesh.file_vertices = file.vertices;
  mesh.file_faces = file.faces;
  SoupImporter importer(mesh);
  // The STL reader merges equal vertices and drops faces that join one twice; the others do not.
  const bool keeps_counts = file.extension != "stl";
  const bool is_read = read_alone(file, importer);
  if (!is_read || (keeps_counts &&
                   (importer.n_vertices() != file.vertices || importer.n_faces() != file.faces))) {
    throw InvalidInput("OpenMesh cannot read the file");
  }
  if (!file.coordinates.empty()) mesh.vertices = std::move(file.coordinates);
  return mesh;
}

}  // namespace mdbd
