// Whatever is done to a file, reading it ends with a reason or with a sound mesh.
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

std::vector<std::pair<std::string, std::string>> samples() {
  const TriangleMesh mesh = make_torus(2.0, 0.5, 5, 3);
  return {{".off", to_off(mesh)},
          {".obj", to_obj(mesh)},
          {".ply", to_ply_text(mesh)},
          {".ply", to_ply_binary<float>(mesh, std::endian::little)},
          {".ply", to_ply_binary<double>(mesh, std::endian::big)},
          {".stl", to_stl_text(mesh)},
          {".stl", to_stl_binary(mesh)}};
}

bool is_sound(const MeshFile& file) {
  for (const Eigen::Vector3d& vertex : file.mesh.vertices) {
    if (!vertex.allFinite()) return false;
  }
  for (const Triangle& triangle : file.mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= file.mesh.vertices.size()) return false;
    }
  }
  return !file.mesh.triangles.empty() && file.statistics.faces == file.mesh.triangles.size();
}

enum class Outcome { refused_with_reason, refused_without_reason, sound_mesh, unsound_mesh };

Outcome outcome_of(const TemporaryDirectory& directory, const std::string& extension,
                   const std::string& content) {
  const std::filesystem::path path = directory.write("model" + extension, content);
  try {
    return is_sound(read_mesh(path)) ? Outcome::sound_mesh : Outcome::unsound_mesh;
  } catch (const InvalidInput& error) {
    return std::string_view(error.what()).empty() ? Outcome::refused_without_reason
                                                  : Outcome::refused_with_reason;
  }
}

bool is_fine(Outcome outcome) {
  return outcome == Outcome::refused_with_reason || outcome == Outcome::sound_mesh;
}

}  // namespace

TEST_CASE("A file cut at any length is refused or sound") {
  const TemporaryDirectory directory;
  for (const auto& [extension, content] : samples()) {
    std::size_t accepted = 0;
    for (std::size_t size = 0; size < content.size(); ++size) {
      INFO(extension << " of " << size << " bytes");
      const Outcome outcome = outcome_of(directory, extension, content.substr(0, size));
      CHECK(is_fine(outcome));
      if (outcome == Outcome::sound_mesh) ++accepted;
    }
    INFO(extension);
    // Formats without counts cannot tell a cut; the others miss no more than a last line end or
    // digit, or the name behind endsolid.
    if (extension != ".obj") CHECK(accepted <= 8);
  }
}

TEST_CASE("A file with random bytes changed is refused or sound") {
  const TemporaryDirectory directory;
  std::mt19937 random(20240229);
  for (const auto& [extension, content] : samples()) {
    for (int round = 0; round < 400; ++round) {
      std::string damaged = content;
      const int changes = 1 + static_cast<int>(random() % 4);
      for (int i = 0; i < changes; ++i) {
        // Half of the changes hit the first bytes, where headers are.
        const std::size_t range =
            random() % 2 == 0 ? damaged.size() : std::min<std::size_t>(damaged.size(), 250);
        damaged[random() % range] = static_cast<char>(random());
      }
      INFO(extension << " in round " << round);
      CHECK(is_fine(outcome_of(directory, extension, damaged)));
    }
  }
}

TEST_CASE("A text file with digits exchanged is refused or sound") {
  const TemporaryDirectory directory;
  std::mt19937 random(7);
  const std::string replacements = "0123456789-+.e #\n/";
  for (const auto& [extension, content] : samples()) {
    for (int round = 0; round < 400; ++round) {
      std::string damaged = content;
      const std::size_t at = damaged.find_first_of("0123456789", random() % damaged.size());
      if (at == damaged.npos) continue;
      damaged[at] = replacements[random() % replacements.size()];
      INFO(extension << " in round " << round);
      CHECK(is_fine(outcome_of(directory, extension, damaged)));
    }
  }
}

TEST_CASE("Content of one format under the ending of another is refused") {
  const TemporaryDirectory directory;
  for (const auto& [extension, content] : samples()) {
    for (const std::string_view other : mesh_file_extensions()) {
      if (other == extension) continue;
      INFO(extension << " as " << other);
      CHECK(outcome_of(directory, std::string(other), content) == Outcome::refused_with_reason);
    }
  }
}

}  // namespace mdbd::test
