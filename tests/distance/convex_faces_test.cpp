#include "features/distance/convex_faces.h"

#include <catch2/catch.hpp>

#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double area(ConvexPolygon polygon) { return 0.5 * area_normal(polygon).norm(); }

}  // namespace

TEST_CASE("the sides of a cube are squares") {
  const TriangleMesh cube = make_cube();
  const ConvexFaces faces(cube);
  for (std::uint32_t t = 0; t < cube.triangles.size(); ++t) {
    const ConvexPolygon face = faces.face_of(t);
    REQUIRE(face.size() == 4);
    CHECK(area(face) == Approx(1.0));
  }
}

TEST_CASE("triangles that are not flat together stay alone") {
  const TriangleMesh torus = make_torus(1.0, 0.3, 12, 8);
  const ConvexFaces faces(torus);
  for (std::uint32_t t = 0; t < torus.triangles.size(); ++t) {
    const ConvexPolygon face = faces.face_of(t);
    CHECK((face.empty() || face.size() == 4));
  }
}

TEST_CASE("a face with a notch is cut into convex pieces that cover it once") {
  // An L of three unit squares, cut into six triangles.
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                   {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 7}, {1, 2, 3}, {1, 3, 4}, {7, 4, 5}, {7, 5, 6}};
  const ConvexFaces faces(mesh);
  double total = 0.0;
  std::vector<const Eigen::Vector3d*> seen;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const ConvexPolygon face = faces.face_of(t);
    REQUIRE(face.size() >= 4);
    if (std::ranges::find(seen, face.data()) != seen.end()) continue;
    seen.push_back(face.data());
    total += area(face);
    const Eigen::Vector3d normal = area_normal(face);
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (const Eigen::Vector3d& corner : face) {
        CHECK(normal.cross(edge(face, i)).dot(corner - face[i]) >= -1e-12);
      }
    }
  }
  CHECK(total == Approx(3.0));
}

TEST_CASE("faces that are folded onto each other are not joined") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.4, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {1, 0, 2}};
  const ConvexFaces faces(mesh);
  for (std::uint32_t t = 0; t < 3; ++t) CHECK(faces.face_of(t).empty());
}
