#include "db/export_arrays.h"

#include <cstring>

#include <catch2/catch.hpp>

#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::StartsWith;

namespace {

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  REQUIRE(bytes.size() >= offset + sizeof number);
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

/// Where the data of a NumPy file begins.
std::size_t data_offset(const std::string& npy) {
  REQUIRE_THAT(npy, StartsWith(std::string("\x93NUMPY\x01\x00", 8)));
  const std::size_t offset = 10U + number_at<std::uint16_t>(npy, 8);
  CHECK(offset % 64 == 0);
  CHECK(npy[offset - 1] == '\n');
  return offset;
}

}  // namespace

TEST_CASE("arrays hold the numbers of the indexed models in the order of their paths") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/b.off"), make_data(2, 3));
  store->put(make_failed_record("/c.off"), {});
  store->put(make_record("/a,1.off"), make_data(1, 2));

  const std::string npy = vectors_to_npy(store->vectors(signature_mdbd_100));
  const std::size_t data = data_offset(npy);
  CHECK(npy.find("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 100), }") == 10);
  CHECK(npy.size() == data + 2 * 100 * sizeof(float));
  CHECK(number_at<float>(npy, data) == make_data(1).signature[0]);
  CHECK(number_at<float>(npy, data + 199 * sizeof(float)) == make_data(2).signature[99]);
  CHECK(models_to_csv(store->vectors(signature_mdbd_100)) ==
        "id,path,scale\n3,\"/a,1.off\",1.5\n1,/b.off,1.5\n");

  const std::string balls = balls_to_npy(*store);
  const std::size_t first = data_offset(balls);
  CHECK(balls.find("'shape': (5,), }") != std::string::npos);
  REQUIRE(balls.size() == first + std::size_t{5} * 40);
  CHECK(number_at<std::int64_t>(balls, first) == 3);
  CHECK(number_at<std::int64_t>(balls, first + 4 * 40) == 1);
  CHECK(number_at<double>(balls, first + 4 * 40 + 32) == make_data(2, 3).balls[2].radius);
}

TEST_CASE("CSV has a line for each model, or for each ball") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  CHECK(vectors_to_csv(store->vectors(signature_mdbd_100)).empty());
  store->put(make_record("/a.off"), make_data(1, 2));
  CHECK_THAT(
      vectors_to_csv(store->vectors(signature_mdbd_100)),
      StartsWith("id,path,scale,v1,v2,") && Catch::Contains("v100\n1,/a.off,1.5,1,1.142857"));
  CHECK_THAT(vectors_to_csv(store->vectors(stored_mdbd_fused)), Catch::Contains(",v30\n"));
  CHECK_THAT(
      balls_to_csv(*store),
      StartsWith("id,path,ball,x,y,z,r\n1,/a.off,1,1.3333333333333333,0,-0,0.5\n1,/a.off,2,"));
}
