#include "store/database_file.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace mdbd {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic{"SQLite format 3\0", 16};
constexpr int header_size = 100;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw StoreError(path.string() + ": " + why);
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

// Not by SQLite, for which one byte is nothing.
std::uint64_t size_of(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

// The size of the file by its header; 0 if the header does not know (file format, section 1.3).
std::uint64_t claimed_size(std::string_view header) {
  if (header.substr(24, 4) != header.substr(92, 4)) return 0;
  const std::uint64_t page_size = big_endian(header.substr(16, 2));
  return big_endian(header.substr(28, 4)) * (page_size == 1 ? 65536 : page_size);
}

}  // namespace

bool find_database_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) refuse(path, "a folder; name a file in it with --db");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(path, "no regular file; name another with --db");
  }
  return status.type() != fs::file_type::not_found;
}

void require_folder_of(const fs::path& path) {
  if (path.empty()) throw StoreError("the name of the database is empty; name a file with --db");
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const fs::file_type type = fs::status(folder, error).type();
  if (type != fs::file_type::directory && type != fs::file_type::none) {
    refuse(path, "cannot be created, there is no folder " + folder.string() +
                     "; make it, or use another --db");
  }
}

// Other processes may create the database or copy a log into it meanwhile. The file is never
// shorter than its header says, except while a log is copied; so the order is: header, log, size.
void require_whole_file(const Database& database) {
  if (size_of(database.path()) == 0) return;
  const std::string header = database.read_header(header_size);
  if (!header.starts_with(magic)) {
    refuse(database.path(), "no database; name another file with --db");
  }
  const std::uint64_t claimed = std::max<std::uint64_t>(claimed_size(header), header_size);
  if (find_log(database.path())) return;
  const std::uint64_t size = size_of(database.path());
  if (size >= claimed) return;
  refuse(database.path(), "truncated, " + std::to_string(size) + " of " + std::to_string(claimed) +
                              " bytes are left; restore it from a copy, or remove it and index "
                              "again");
}

std::optional<fs::path> find_log(const fs::path& path) {
  for (const char* ending : {"-wal", "-journal"}) {
    std::error_code error;
    // Logs lie beside what a symbolic link leads to.
    const fs::path log = fs::canonical(path, error) += ending;
    if (!error && size_of(log) > 0) return log;
  }
  return std::nullopt;
}

}  // namespace mdbd
