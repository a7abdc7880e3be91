#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// What to tell people when a database cannot be used. Every message begins with the path of the
/// database and ends with what to do.
namespace mdbd {

/// Explains a failure of SQLite. Looks at the file and its folder to find the reason.
/// @param code a result code of SQLite, primary or extended
std::string explain_failure(int code, const std::filesystem::path& database,
                            std::string_view sqlite_message);

/// Explains damage that was found in the content.
std::string explain_damage(const std::filesystem::path& database, std::string_view what);

/// Explains why a database cannot be changed although it can be read.
std::string explain_read_only(const std::filesystem::path& database);

}  // namespace mdbd
