#include "query/answer_query.h"

#include <catch2/catch.hpp>

#include "features/descriptor/fused_signature.h"
#include "tests/support/ball_clouds.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::int64_t put_model(ShapeStore& store, const std::string& path, unsigned seed, bool has_fused) {
  ShapeRecord record;
  record.path = path;
  record.scale = 5.0;
  ShapeData data{.balls = random_balls(30, seed),
                 .signature = std::vector<float>(100, static_cast<float>(seed)),
                 .fused = {}};
  if (has_fused) data.fused = compute_fused_signature(data.balls);
  return store.put(record, data);
}

}  // namespace

TEST_CASE("a model without mdbd-fused in the database is found all the same, by its balls") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t old = put_model(*store, "/old.off", 1, false);
  put_model(*store, "/new.off", 2, true);
  put_model(*store, "/twin.off", 1, true);
  const QueryAnswer answer = query_by_id(*store, old, 3, SignatureKind::mdbd_fused);
  CHECK(answer.completed == 1);
  CHECK(answer.result.exact);
  REQUIRE(answer.result.matches.size() == 3);
  CHECK(answer.result.matches[0].path == "/old.off");
  CHECK(answer.result.matches[1].path == "/twin.off");
  CHECK(answer.result.matches[1].distance == 0.0);
  CHECK(answer.result.matches[2].distance > 0.1);
  store->put_vector(old, stored_mdbd_fused, compute_fused_signature(random_balls(30, 1)));
  CHECK(query_by_id(*store, old, 3, SignatureKind::mdbd_fused).completed == 0);
}

TEST_CASE("mdbd-100 is what is compared unless something else is asked for") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = put_model(*store, "/a.off", 1, false);
  put_model(*store, "/b.off", 3, false);
  const QueryAnswer answer = query_by_id(*store, id, 2);
  CHECK(answer.completed == 0);
  CHECK(answer.result.matches.at(1).distance == Approx(4 * std::sqrt(50.0)));
}
