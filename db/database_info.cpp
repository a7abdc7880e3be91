#include "db/database_info.h"

#include <iterator>
#include <map>

#include <fmt/format.h>

#include "cli/options.h"
#include "cli/terminal.h"

namespace mdbd {

std::string describe_database(const ShapeStore& store, const DatabaseSize& size) {
  std::size_t failed = 0;
  std::map<std::string, std::size_t> formats;
  for (const ShapeRecord& record : store.shapes()) {
    if (record.status == ShapeStatus::failed) {
      ++failed;
    } else {
      ++formats[record.format];
    }
  }
  std::size_t indexed = 0;
  std::string by_format;
  for (const auto& [format, count] : formats) {
    indexed += count;
    by_format += fmt::format("{}{} {}", by_format.empty() ? "" : ", ", count, format);
  }
  std::string text = fmt::format("models      {} indexed{}\n", indexed,
                                 by_format.empty() ? "" : " (" + by_format + ")");
  auto out = std::back_inserter(text);
  fmt::format_to(out, "failed      {}\n", failed);
  fmt::format_to(out, "mdbd-fused  {} without\n", store.shapes_without(stored_mdbd_fused).size());
  fmt::format_to(out, "size        {}, of which {} unused\n", format_size(size.bytes),
                 format_size(size.unused_bytes));
  text += "recipe\n";
  for (const auto& [name, value] : to_entries(store.recipe())) {
    fmt::format_to(out, "  {:<18} {}\n", name, value);
  }
  return text;
}

std::string describe_caches(const std::filesystem::path& database) {
  std::map<std::string, std::uint64_t> sizes;
  const std::filesystem::path folder = database.has_parent_path() ? database.parent_path() : ".";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(database.filename().string() + ".") || !name.ends_with(".vectors")) {
      continue;
    }
    sizes[name] = entry.file_size(error);
  }
  std::string text;
  for (const auto& [name, size] : sizes) {
    fmt::format_to(std::back_inserter(text), "cache       {}, {}\n", printable(name),
                   format_size(size));
  }
  return text;
}

}  // namespace mdbd
