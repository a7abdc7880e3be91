#include "cli/progress_bar.h"

#include <catch2/catch.hpp>

using namespace mdbd;
using Catch::Contains;
using std::chrono::duration;

TEST_CASE("a progress line tells models, rate, time left and failures") {
  const std::string line = progress_line({100, 25, 2, duration<double>(50.0)}, 100);
  CHECK_THAT(line, Contains("25/100 models, 0.5/s, 2 min 30 s left, 2 failed"));
  CHECK_THAT(line, Contains("[#######.......................]"));
}

TEST_CASE("a progress line claims nothing before the first model") {
  CHECK_THAT(progress_line({8, 0, 0, duration<double>(3.0)}, 80),
             !Contains("left") && Contains("0/8"));
}

TEST_CASE("a progress line fits its width") {
  for (int width = 0; width < 120; ++width) {
    CHECK(progress_line({1000, 999, 3, duration<double>(1e4)}, width).size() <= std::size_t(width));
  }
}

TEST_CASE("off a terminal only messages are written") {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  {
    ProgressBar bar(file);
    bar.start(2);
    bar.advance(false);
    bar.print_above("a line");
    bar.advance(true);
  }
  std::rewind(file);
  char text[100] = {};
  const std::size_t size = std::fread(text, 1, sizeof text, file);
  std::fclose(file);
  CHECK(std::string(text, size) == "a line\n");
}
