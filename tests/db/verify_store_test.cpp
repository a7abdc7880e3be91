#include "db/verify_store.h"

#include <catch2/catch.hpp>

#include "features/descriptor/compute_descriptor.h"
#include "features/descriptor/fused_signature.h"
#include "store/maintenance.h"
#include "tests/store/models.h"
#include "tests/support/ball_clouds.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

ShapeData consistent_data(const ShapeRecord& record, const Recipe& recipe, unsigned seed) {
  BallDecomposition decomposition;
  decomposition.balls = random_balls(40, seed);
  decomposition.scale = record.scale;
  return {.balls = decomposition.balls,
          .signature = compute_descriptor(decomposition, recipe).values,
          .fused = compute_fused_signature(decomposition.balls)};
}

}  // namespace

TEST_CASE("signatures that are those of their balls pass, others are named") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  for (unsigned seed = 1; seed < 5; ++seed) {
    const ShapeRecord record = make_record("/" + std::to_string(seed) + ".off");
    store->put(record, consistent_data(record, store->recipe(), seed));
  }
  store->put(make_failed_record("/failed.off"), {});
  CHECK(verify_store(*store).models == 4);
  CHECK(verify_store(*store).problems.empty());

  ShapeData wrong = consistent_data(make_record(""), store->recipe(), 2);
  wrong.signature[7] += 0.001F;
  store->put(make_record("/2.off"), wrong);
  wrong = consistent_data(make_record(""), store->recipe(), 3);
  wrong.fused[7] += 0.001F;
  store->put(make_record("/3.off"), wrong);
  const Verification verification = verify_store(*store);
  CHECK(verification.problems ==
        std::vector<std::string>{"/2.off: its mdbd-100 is not that of its balls",
                                 "/3.off: its mdbd-fused is not that of its balls"});
}
