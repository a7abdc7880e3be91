#include "query/collection_filter.h"

#include <catch2/catch.hpp>

using mdbd::CollectionFilter;

namespace {

bool accepts(const CollectionFilter& filter, const std::string& path, double scale = 1.0) {
  return filter.accepts(path, scale);
}

}  // namespace

TEST_CASE("a pattern without a slash is for the name of the file, others for the path") {
  CHECK(accepts({.glob = "*.stl"}, "/a/b.stl"));
  CHECK_FALSE(accepts({.glob = "*.stl"}, "/a.stl/b.off"));
  CHECK(accepts({.glob = "*/chairs/*"}, "/models/chairs/old/1.off"));
  CHECK_FALSE(accepts({.glob = "chairs/*"}, "/models/chairs/1.off"));
  CHECK(accepts({.glob = "b[0-9]?.off"}, "/a/b12.off"));
  CHECK_FALSE(accepts({.glob = "b[0-9]?.off"}, "/a/b1.off"));
}

TEST_CASE("the class is the folder that holds the file") {
  CHECK(accepts({.label = "chair"}, "/models/chair/1.off"));
  CHECK_FALSE(accepts({.label = "models"}, "/models/chair/1.off"));
}

TEST_CASE("both ends of a range of scales belong to it") {
  const CollectionFilter filter{.min_scale = 1.0, .max_scale = 2.0};
  CHECK(accepts(filter, "/a.off", 1.0));
  CHECK(accepts(filter, "/a.off", 2.0));
  CHECK_FALSE(accepts(filter, "/a.off", 0.999));
  CHECK_FALSE(accepts(filter, "/a.off", 2.001));
  CHECK(CollectionFilter{}.is_empty());
  CHECK_FALSE(filter.is_empty());
}
