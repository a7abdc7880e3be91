#include "bench/shared_models.h"

#include <algorithm>
#include <cstdlib>

#include "features/shape_io/read_mesh.h"

namespace mdbd::bench {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? fs::path() : fs::path(value);
}

}  // namespace

fs::path shared_data_folder() {
  if (fs::path data = folder_of("MDBD_DATA"); !data.empty()) return data;
  if (const fs::path cache = folder_of("XDG_CACHE_HOME"); !cache.empty())
    return cache / "mdbd-data";
  return folder_of("HOME") / ".cache" / "mdbd-data";
}

std::vector<fs::path> find_shared_models(const std::string& set, std::size_t stride) {
  const fs::path folder = shared_data_folder() / set;
  if (!fs::is_directory(folder)) return {};
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && has_mesh_extension(entry.path())) all.push_back(entry.path());
  }
  std::ranges::sort(all);
  std::vector<fs::path> chosen;
  for (std::size_t i = 0; i < all.size(); i += stride) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace mdbd::bench
