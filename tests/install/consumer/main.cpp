// A program outside the project: it indexes one model and finds it again, and reads one by a
// module.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "features/describe.h"
#include "query/answer_query.h"
#include "store/shape_store.h"

namespace {

constexpr const char* cube = R"(OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
)";

constexpr const char* octahedron = R"(NRRD0004
type: float
dimension: 3
sizes: 3 3 3
encoding: ascii

-1 -1 -1 -1 -1 -1 -1 -1 -1
-1 -1 -1 -1 14 -1 -1 -1 -1
-1 -1 -1 -1 -1 -1 -1 -1 -1
)";

}  // namespace

int main() {
  std::ofstream("cube.off") << cube;
  std::filesystem::remove("consumer.db");
  const mdbd::Recipe recipe{.balls = 9};
  const mdbd::ShapeDescription description = mdbd::describe_file("cube.off", recipe);
  const auto store = mdbd::open_store("consumer.db", recipe);
  store->put({.path = "/cube.off", .scale = description.decomposition.scale},
             {.balls = description.decomposition.balls,
              .signature = description.descriptor.values,
              .fused = description.fused});

  const mdbd::QueryAnswer answer = mdbd::query_by_file(*store, "cube.off", {.count = 1});
  const bool is_found =
      answer.result.matches.size() == 1 && answer.result.matches[0].distance == 0.0;
  std::puts(is_found ? "found" : "not found");

  // |x| + |y| + |z| <= 14/15
  std::ofstream("octahedron.nrrd") << octahedron;
  const mdbd::ShapeDescription solid = mdbd::describe_file("octahedron.nrrd", recipe);
  const double radius = solid.decomposition.balls.front().radius;
  const bool is_right = std::abs(radius - 14 / (15 * std::sqrt(3))) < 1e-6;
  std::printf("radius %g\n", radius);
  return is_found && is_right ? 0 : 1;
}
