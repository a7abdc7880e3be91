#include "cli/utf8.h"

#include <catch2/catch.hpp>

using namespace mdbd;

TEST_CASE("the width of a text is that of its characters") {
  CHECK(display_width("") == 0);
  CHECK(display_width("chair") == 5);
  CHECK(display_width("Stühle") == 6);
  CHECK(display_width("椅子") == 4);
}

TEST_CASE("texts are shortened between characters") {
  CHECK(shorten("chair", 5) == "chair");
  CHECK(shorten("chairs", 5) == "chai…");
  CHECK(shorten("Stühle", 4) == "Stü…");
  CHECK(shorten("椅子椅子", 4) == "椅…");
  CHECK(shorten("chair", 1) == "…");
}

TEST_CASE("bytes that are no UTF-8 do no harm") {
  const std::string text = "\xff\xfe\xc3 chair\xe6";
  CHECK(utf8_length(text, 0) == 0);
  CHECK(utf8_length("a", 1) == 0);
  CHECK(display_width(text) <= text.size());
  CHECK(shorten(text, 3).ends_with("…"));
}
