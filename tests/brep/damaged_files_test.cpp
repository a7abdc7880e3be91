// CAD files as accidents and attackers leave them.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "collection/isolated.h"
#include "features/brep/read_brep.h"
#include "features/brep_shape.h"
#include "features/core/errors.h"
#include "tests/brep/occt_solids.h"
#include "tests/support/mutated_files.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

struct CadFile {
  std::string ending;
  std::string content;
};

std::vector<CadFile> sound_cad_files() {
  const TemporaryDirectory folder;
  const auto solid = OcctSolid::box({0, 0, 0}, {2, 2, 2}).without(OcctSolid::sphere(1.0));
  solid.write_step(folder / "a.step");
  solid.as_splines().write_step(folder / "b.step");
  solid.write_iges(folder / "a.iges");
  std::vector<CadFile> files;
  for (const char* name : {"a.step", "b.step", "a.iges"}) {
    files.push_back({std::filesystem::path(name).extension(), content_of(folder / name)});
  }
  return files;
}

int mutation_count() {
  const char* text = std::getenv("MDBD_MUTATIONS");
  return text == nullptr ? 6 : std::atoi(text);
}

/// What became of a file; a crash or a hang is told apart from a refusal.
std::string read_isolated(const std::filesystem::path& path) {
  ProcessLimits limits;
  limits.time = std::chrono::seconds(5);
  Recipe recipe;
  try {
    return compute_isolated(path, limits, [&] {
      const Shape shape = load_brep_shape(path, recipe);
      return shape.field->enclosing_ball().center.allFinite() ? "read" : "not finite";
    });
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("files that hold no shape are refused with a reason") {
  const TemporaryDirectory folder;
  const auto reason = [&](const char* name, const std::string& content) -> std::string {
    try {
      read_brep(folder.write(name, content));
      return "read";
    } catch (const InvalidInput& error) {
      return error.what();
    }
  };
  for (const char* name : {"a.step", "a.iges"}) {
    CHECK_THAT(reason(name, "nothing of the kind"), Catch::Contains("no "));
    CHECK(reason(name, "") != "read");
    CHECK(reason(name, std::string(5000, '\0')) != "read");
  }
  CHECK_THROWS_AS(read_brep(folder / "missing.step"), IoError);
}

TEST_CASE("a file that is cut off is refused, or what is left of it is read") {
  const TemporaryDirectory folder;
  for (const auto& [ending, content] : sound_cad_files()) {
    for (int part = 1; part < 10; ++part) {
      const auto path = folder.write("cut" + ending, content.substr(0, content.size() * part / 10));
      const std::string outcome = read_isolated(path);
      INFO(ending << " " << part << "/10: " << outcome);
      CHECK_FALSE(outcome.empty());
      CHECK_THAT(outcome, !Catch::Contains("crashed") && !Catch::Contains("signal"));
    }
  }
}

TEST_CASE("mutated CAD files cost themselves and nothing else") {
  const TemporaryDirectory folder;
  int crashes = 0;
  Mutator mutator(7);
  for (const auto& [ending, content] : sound_cad_files()) {
    for (int i = 0; i < mutation_count(); ++i) {
      const std::string outcome =
          read_isolated(folder.write("bad" + ending, mutator.mutate(content)));
      CHECK_FALSE(outcome.empty());
      if (outcome.find("signal") != outcome.npos) ++crashes;
    }
  }
  // OpenCASCADE is not ours to mend: its crashes are contained.
  WARN(crashes << " contained crashes");
}
