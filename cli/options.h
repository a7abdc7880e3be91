#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "features/core/signature.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Options that several programs share, declared in one way.
namespace mdbd {

/// Adds `--db PATH`: the option, else $MDBD_DB, else ./mdbd.db.
CLI::Option* add_database_option(CLI::App& app, std::filesystem::path& database);

/// Adds `--signature NAME`: what is compared.
CLI::Option* add_signature_option(CLI::App& app, SignatureKind& signature);

/// Adds an option for a number of bytes: "1000000", "512M" or "512MiB" (1024²), "2GiB". At least 1.
CLI::Option* add_size_option(CLI::App& app, const std::string& name, std::uint64_t& bytes,
                             const std::string& description);

/// Adds an option for a time: "90" (seconds), "0.5s", "5m", "1h". Above 0.
CLI::Option* add_duration_option(CLI::App& app, const std::string& name,
                                 std::chrono::duration<double>& duration,
                                 const std::string& description);

/// Adds `--denoise auto|off`, Recipe::denoise; stays empty if it is not given.
CLI::Option* add_denoise_option(CLI::App& app, std::optional<std::string>& denoise);

/// Adds `--solidify auto|off`, Recipe::solidify; stays empty if it is not given.
CLI::Option* add_solidify_option(CLI::App& app, std::optional<std::string>& solidify);

/// Adds `--unit UNIT`, one of length_units; stays empty if it is not given.
CLI::Option* add_unit_option(CLI::App& app, std::string& unit, const std::string& description);

/// A number of bytes for people: "2 GiB", "512 MiB", "1.5 KiB", "17 B".
std::string format_size(std::uint64_t bytes);

/// A time for people: "0.25 s", "42 s", "3 min 20 s", "2 h 5 min".
std::string format_duration(std::chrono::duration<double> duration);

}  // namespace mdbd
