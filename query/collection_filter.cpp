#include "query/collection_filter.h"

#include <filesystem>

#include <fnmatch.h>

namespace mdbd {
namespace {

bool matches_glob(const std::string& glob, const std::filesystem::path& path) {
  const bool is_for_path = glob.find('/') != std::string::npos;
  const std::string text = is_for_path ? path.string() : path.filename().string();
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

}  // namespace

bool CollectionFilter::accepts(const std::string& path, double scale) const {
  const std::filesystem::path file(path);
  return scale >= min_scale && scale <= max_scale && (glob.empty() || matches_glob(glob, file)) &&
         (label.empty() || file.parent_path().filename() == label);
}

bool CollectionFilter::is_empty() const {
  return glob.empty() && label.empty() && min_scale == 0.0 &&
         max_scale == std::numeric_limits<double>::infinity();
}

}  // namespace mdbd
