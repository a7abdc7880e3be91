#include "features/modules/module.h"

#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/shape.h"
#include "features/shape_io/vti_reader.h"

namespace mdbd::test {
namespace {

bool is_loaded(const std::string& module) {
  std::ifstream maps("/proc/self/maps");
  const std::string text{std::istreambuf_iterator<char>(maps), {}};
  return text.find("/" + module + ".so") != text.npos;
}

TEST_CASE("a module that is missing is named, with the reason") {
  CHECK_THROWS_AS(find_module("mdbd_none"), IoError);
  CHECK_THROWS_WITH(find_module("mdbd_none"),
                    Catch::Contains("needs the module mdbd_none, which cannot be loaded: ") &&
                        Catch::Contains("mdbd_none.so: cannot open shared object file"));
}

TEST_CASE("what a module throws is caught by its type") {
  CHECK_THROWS_AS(read_vti("no grid"), InvalidInput);
}

TEST_CASE("what the ending of a path needs is loaded ahead, whether or not there is a file") {
  CHECK(!is_loaded("mdbd_scenes"));
  preload_reader("none.off");
  preload_reader("none.step");
  CHECK(!is_loaded("mdbd_scenes"));
  CHECK(is_loaded("mdbd_cad"));
  preload_reader("none.3MF");
  CHECK(is_loaded("mdbd_scenes"));
}

}  // namespace
}  // namespace mdbd::test
