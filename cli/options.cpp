#include "cli/options.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "features/core/length_unit.h"

namespace mdbd {

CLI::Option* add_database_option(CLI::App& app, std::filesystem::path& database) {
  database = "mdbd.db";
  return app.add_option("--db", database, "The database")
      ->type_name("PATH")
      ->envname("MDBD_DB")
      ->capture_default_str();
}

CLI::Option* add_signature_option(CLI::App& app, SignatureKind& signature) {
  const std::string fused(signature_mdbd_fused);
  const auto choose = [&signature, fused](const std::string& name) {
    signature = name == fused ? SignatureKind::mdbd_fused : SignatureKind::mdbd_100;
  };
  return app.add_option_function<std::string>("--signature", choose, "What is compared")
      ->check(CLI::IsMember({std::string(signature_mdbd_100), fused}).description(""))
      ->type_name("mdbd-100|mdbd-fused")
      ->default_str(std::string(to_string(signature)));
}

CLI::Option* add_size_option(CLI::App& app, const std::string& name, std::uint64_t& bytes,
                             const std::string& description) {
  return app.add_option(name, bytes, description)
      ->transform(CLI::AsSizeValue(false).description(""))
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62).description(""))
      ->type_name("SIZE")
      ->default_str(format_size(bytes));
}

CLI::Option* add_duration_option(CLI::App& app, const std::string& name,
                                 std::chrono::duration<double>& duration,
                                 const std::string& description) {
  const std::map<std::string, double> units = {
      {"ms", 1e-3}, {"s", 1.0}, {"m", 60.0}, {"min", 60.0}, {"h", 3600.0}};
  const auto store = [&duration](double seconds) {
    duration = std::chrono::duration<double>(seconds);
  };
  return app.add_option_function<double>(name, store, description)
      ->transform(CLI::AsNumberWithUnit(units).description(""))
      ->check(CLI::Range(1e-3, 1e9).description(""))
      ->type_name("TIME")
      ->default_str(format_duration(duration));
}

CLI::Option* add_denoise_option(CLI::App& app, std::optional<std::string>& denoise) {
  return app
      .add_option("--denoise", denoise,
                  "auto takes noise from meshes where it stands out and leaves clean ones as they "
                  "are; off takes all as they are")
      ->check(CLI::IsMember({"auto", "off"}))
      ->type_name("MODE")
      ->default_str("auto");
}

CLI::Option* add_solidify_option(CLI::App& app, std::optional<std::string>& solidify) {
  return app
      .add_option("--solidify", solidify,
                  "auto gives surfaces that enclose nothing a thickness and says so; off refuses "
                  "them")
      ->check(CLI::IsMember({"auto", "off"}))
      ->type_name("MODE")
      ->default_str("auto");
}

CLI::Option* add_unit_option(CLI::App& app, std::string& unit, const std::string& description) {
  std::vector<std::string> names;
  for (const LengthUnit& known : length_units) names.emplace_back(known.name);
  return app.add_option("--unit", unit, description)
      ->check(CLI::IsMember(names).description(""))
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

std::string format_size(std::uint64_t bytes) {
  constexpr std::array units = {"B", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  std::size_t unit = 0;
  double size = static_cast<double>(bytes);
  for (; size >= 1024.0 && unit + 1 < units.size(); ++unit) size /= 1024.0;
  return fmt::format("{:.4g} {}", std::round(size * 10.0) / 10.0, units[unit]);
}

std::string format_duration(std::chrono::duration<double> duration) {
  const double seconds = duration.count();
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  const auto join = [](auto large, const char* unit, auto small, const char* small_unit) {
    return small == 0 ? fmt::format("{} {}", large, unit)
                      : fmt::format("{} {} {} {}", large, unit, small, small_unit);
  };
  if (whole < 3600) return join(whole / 60, "min", whole % 60, "s");
  return join(whole / 3600, "h", whole % 3600 / 60, "min");
}

}  // namespace mdbd
