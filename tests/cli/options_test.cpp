#include "cli/options.h"

#include <cstdlib>
#include <limits>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

std::uint64_t parse_size(const std::string& text) {
  CLI::App app;
  std::uint64_t bytes = 7;
  add_size_option(app, "--memory", bytes, "Memory");
  app.parse("--memory " + text);
  return bytes;
}

double parse_duration(const std::string& text) {
  CLI::App app;
  std::chrono::duration<double> duration(7.0);
  add_duration_option(app, "--time", duration, "Time");
  app.parse("--time " + text);
  return duration.count();
}

std::filesystem::path parse_database(const std::string& arguments) {
  CLI::App app;
  std::filesystem::path database;
  add_database_option(app, database);
  app.parse(arguments);
  return database;
}

}  // namespace

TEST_CASE("sizes are bytes with binary units") {
  CHECK(parse_size("1000000") == 1000000);
  CHECK(parse_size("512M") == 512ull << 20);
  CHECK(parse_size("512MiB") == 512ull << 20);
  CHECK(parse_size("2gib") == 2ull << 30);
  CHECK(parse_size("3kb") == 3072);
}

TEST_CASE("sizes that are none are refused") {
  const auto text =
      GENERATE(as<std::string>(), "0", "-1", "-1G", "much", "2GiX", "1e3", "99999999999G");
  INFO(text);
  CHECK_THROWS_AS(parse_size(text), CLI::ParseError);
}

TEST_CASE("durations are seconds with units") {
  CHECK(parse_duration("90") == 90.0);
  CHECK(parse_duration("0.5s") == 0.5);
  CHECK(parse_duration("250ms") == 0.25);
  CHECK(parse_duration("5m") == 300.0);
  CHECK(parse_duration("5min") == 300.0);
  CHECK(parse_duration("2h") == 7200.0);
}

TEST_CASE("durations that are none are refused") {
  const auto text = GENERATE(as<std::string>(), "0", "-1", "nan", "inf", "soon", "3 parsec");
  INFO(text);
  CHECK_THROWS_AS(parse_duration(text), CLI::ParseError);
}

TEST_CASE("the database is the option, else the environment, else mdbd.db") {
  unsetenv("MDBD_DB");
  CHECK(parse_database("") == "mdbd.db");
  setenv("MDBD_DB", "/data/parts.db", 1);
  CHECK(parse_database("") == "/data/parts.db");
  CHECK(parse_database("--db other.db") == "other.db");
  setenv("MDBD_DB", "", 1);
  CHECK(parse_database("") == "mdbd.db");
  unsetenv("MDBD_DB");
}

TEST_CASE("help names units and defaults but no internals") {
  CLI::App app;
  std::uint64_t bytes = 2ull << 30;
  std::chrono::duration<double> duration(60.0);
  add_size_option(app, "--memory", bytes, "Memory");
  add_duration_option(app, "--time", duration, "Time");
  const std::string help = app.help();
  INFO(help);
  CHECK(help.find("SIZE=2 GiB") != std::string::npos);
  CHECK(help.find("TIME=1 min") != std::string::npos);
  CHECK(help.find("[") == help.find("[OPTIONS]"));
}

TEST_CASE("sizes and times for people") {
  CHECK(format_size(17) == "17 B");
  CHECK(format_size(1536) == "1.5 KiB");
  CHECK(format_size(2ull << 30) == "2 GiB");
  CHECK(format_size(std::numeric_limits<std::uint64_t>::max()) == "16 EiB");
  const auto format = [](double seconds) {
    return format_duration(std::chrono::duration<double>(seconds));
  };
  CHECK(format(0.0) == "0 s");
  CHECK(format(0.25) == "0.25 s");
  CHECK(format(59.4) == "59 s");
  CHECK(format(59.6) == "1 min");
  CHECK(format(200.0) == "3 min 20 s");
  CHECK(format(7500.0) == "2 h 5 min");
}
