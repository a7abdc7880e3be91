#include "cli/terminal.h"

#include <catch2/catch.hpp>

using namespace mdbd;

TEST_CASE("printable leaves ordinary names alone") {
  CHECK(printable("chair 01.off") == "chair 01.off");
  CHECK(printable("Stühle/椅子/🪑.ply") == "Stühle/椅子/🪑.ply");
  CHECK(printable("").empty());
}

TEST_CASE("printable shows control characters and bytes that are no UTF-8") {
  CHECK(printable("a\nb\tc") == "a\\nb\\tc");
  CHECK(printable("\x1b[2J") == "\\x1b[2J");
  CHECK(printable("\xc2\x9b") == "\\xc2\\x9b");
  CHECK(printable("a\\nb") == "a\\\\nb");
  CHECK(printable("\xff.off") == "\\xff.off");
  CHECK(printable("\xc3") == "\\xc3");
  CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(printable(std::string_view("a\0b", 3)) == "a\\x00b");
}

TEST_CASE("printable_message may be applied to what is printable already") {
  CHECK(printable_message("a.off\x1b[2J: line 1\nline 2") == "a.off\\x1b[2J: line 1\\nline 2");
  CHECK(printable_message(printable("a\\b\x1b\n.off")) == printable("a\\b\x1b\n.off"));
}

TEST_CASE("a file is no terminal") {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  CHECK_FALSE(is_terminal(file));
  CHECK_FALSE(colour_allowed(file));
  CHECK(terminal_width(file) == 80);
  std::fclose(file);
}
