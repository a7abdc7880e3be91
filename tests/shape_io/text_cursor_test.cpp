#include "features/shape_io/text_cursor.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace mdbd::test {

TEST_CASE("Words, lines and comments") {
  TextCursor cursor("one  two # not this\n\r\n# nor this\r  three");
  CHECK(cursor.next() == "one");
  CHECK(cursor.next_in_line() == "two");
  CHECK(cursor.next_in_line().empty());
  CHECK(cursor.line() == 1);
  CHECK(cursor.next() == "three");
  CHECK(cursor.line() == 4);
  CHECK(cursor.next().empty());
  CHECK(cursor.at_end());
}

TEST_CASE("Lines of every kind are skipped whole") {
  TextCursor cursor("a b\nc d\r\ne f\rg");
  for (const char* first : {"a", "c", "e", "g"}) {
    CHECK(cursor.next_in_line() == first);
    cursor.skip_line();
  }
  CHECK(cursor.at_end());
}

TEST_CASE("A backslash joins lines") {
  TextCursor cursor("f 1\\\n2 \\\r\n3\nf \\ 4");
  for (const char* word : {"f", "1", "2", "3", "", ""}) CHECK(cursor.next_in_line() == word);
  cursor.skip_line();
  for (const char* word : {"f", "\\", "4"}) CHECK(cursor.next_in_line() == word);
}

TEST_CASE("Numbers") {
  CHECK(parse_number("1.5") == 1.5);
  CHECK(parse_number("+1.5e+2") == 150.0);
  CHECK(parse_number("-.5") == -0.5);
  CHECK(parse_number("5.") == 5.0);
  CHECK(parse_number("1e-999") == 0.0);
  CHECK(std::isinf(parse_number("1e999").value()));
  CHECK(std::isnan(parse_number("NaN").value()));
  for (const char* bad : {"", "+", "-", "+-1", "1,5", "0x10", "1e", "1.5.2", "one"}) {
    CHECK_FALSE(parse_number(bad).has_value());
  }
}

TEST_CASE("Integers") {
  CHECK(parse_integer("+12") == 12);
  CHECK(parse_integer("-12") == -12);
  for (const char* bad : {"", "1.0", "1e3", "99999999999999999999", "x", "+-1"}) {
    CHECK_FALSE(parse_integer(bad).has_value());
  }
}

TEST_CASE("Upper and lower case") {
  CHECK(equals_ignoring_case("EndSolid", "endsolid"));
  CHECK_FALSE(equals_ignoring_case("solid", "solids"));
}

}  // namespace mdbd::test
