// A database of made-up models for measuring searches: vectors in clusters (descriptor_vectors.h),
// and balls that have nothing to do with them.
//
//     generate_database FILE.db MODELS [BALLS]
//
// Every model is waited for until it is on the disk; a file in memory, such as /dev/shm/a.db, is
// there sooner.
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "bench/descriptor_vectors.h"
#include "store/shape_store.h"
#include "tests/support/ball_clouds.h"

namespace {

std::vector<float> row_of(const mdbd::VectorTable& table, std::size_t row) {
  const std::span<const float> values = table.values(row);
  return {values.begin(), values.end()};
}

mdbd::ShapeRecord make_record(std::string path) {
  mdbd::ShapeRecord record;
  record.content_hash = fmt::format("{:032x}", std::hash<std::string>()(path));
  record.path = std::move(path);
  record.file_size = 1;
  record.format = "off";
  record.representation = "mesh";
  record.scale = 1.0;
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: generate_database FILE.db MODELS [BALLS]\n");
    return 2;
  }
  const auto models = static_cast<std::size_t>(std::atoll(argv[2]));
  const auto balls = static_cast<std::size_t>(argc > 3 ? std::atoll(argv[3]) : 10);
  try {
    const mdbd::VectorTable descriptors = mdbd::mdbd_100_vectors(models);
    const mdbd::VectorTable fused = mdbd::mdbd_fused_vectors(models);
    const auto store = mdbd::open_store(argv[1]);
    mdbd::ShapeData data;
    data.balls = mdbd::test::random_balls(balls, 1);
    for (std::size_t row = 0; row < models; ++row) {
      data.signature = row_of(descriptors, row);
      data.fused = row_of(fused, row);
      store->put(make_record(std::string(descriptors.path(row))), data);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "generate_database: {}\n", error.what());
    return 1;
  }
  return 0;
}
