#include "perturbation/perturbation.h"

#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/shape_io/mesh_statistics.h"
#include "tests/perturbation/meshes.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/temporary_directory.h"

namespace mdbd::test {
namespace {

std::vector<Perturbation> all_perturbations() {
  return {noise_perturbation(0.5),      noise_perturbation(1),       rotation_perturbation(),
          translation_perturbation(10), scale_perturbation(25.4),    mirror_perturbation(),
          subdivision_perturbation(),   decimation_perturbation(50), decimation_perturbation(10),
          shuffling_perturbation(),     export_perturbation(".off"), export_perturbation(".obj"),
          export_perturbation(".ply"),  export_perturbation(".stl")};
}

}  // namespace

TEST_CASE("perturbations have names of their own and do what they say") {
  const TriangleMesh sphere = make_sphere(3);
  std::set<std::string> names;
  for (const Perturbation& perturbation : all_perturbations()) {
    INFO(perturbation.name);
    names.insert(perturbation.name);
    const TriangleMesh copy = perturbation.apply(sphere, 1);
    CHECK(are_equal(copy, perturbation.apply(sphere, 1)));
    CHECK(are_equal(copy, perturbation.apply(sphere, 2)) != perturbation.is_random);
    CHECK(measure_statistics(copy).watertight);
    CHECK(measure_statistics(copy).orientation == Orientation::outward);
  }
  CHECK(names.size() == all_perturbations().size());
  CHECK(noise_perturbation(0.5).name == "noise 0.5 %");
}

TEST_CASE("a copy depends on seed and content, not on the file's name") {
  const TemporaryDirectory directory;
  const auto a = directory.write("a/cube.off", to_off(make_cube()));
  const auto b = directory.write("b/other.off", to_off(make_cube()));
  const auto c = directory.write("c/cube.off", "# a comment\n" + to_off(make_cube()));
  const Perturbation noise = noise_perturbation(1);
  const TriangleMesh copy = perturb_file(a, noise, 1);
  CHECK(copy.vertices.size() == 8);
  CHECK(are_equal(copy, perturb_file(b, noise, 1)));
  CHECK_FALSE(are_equal(copy, perturb_file(c, noise, 1)));
  CHECK_FALSE(are_equal(copy, perturb_file(a, noise, 2)));
}

TEST_CASE("files that are no models are refused") {
  const TemporaryDirectory directory;
  const auto damaged = directory.write("a.off", "OFF\n3 1");
  CHECK_THROWS_AS(perturb_file(damaged, mirror_perturbation(), 1), InvalidInput);
  CHECK_THROWS_AS(perturb_file(directory / "none.off", mirror_perturbation(), 1), IoError);
}

}  // namespace mdbd::test
