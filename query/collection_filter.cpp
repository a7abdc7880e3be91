#include "query/collection_filter.h"

#include <fnmatch.h>

namespace mdbd {
namespace {

/// The part of a path behind the last slash; takes it off.
std::string_view take_name(std::string_view& path) {
  const std::size_t slash = path.rfind('/');
  const bool has_slash = slash != std::string_view::npos;
  const std::string_view name = has_slash ? path.substr(slash + 1) : path;
  path = has_slash ? path.substr(0, slash) : std::string_view();
  return name;
}

bool matches_glob(const std::string& glob, std::string_view path) {
  const bool is_for_path = glob.find('/') != std::string::npos;
  const std::string text(is_for_path ? path : take_name(path));
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

bool is_in_folder(const std::string& label, std::string_view path) {
  take_name(path);
  return take_name(path) == label;
}

}  // namespace

bool CollectionFilter::accepts(std::string_view path, double scale) const {
  return scale >= min_scale && scale <= max_scale && (glob.empty() || matches_glob(glob, path)) &&
         (label.empty() || is_in_folder(label, path));
}

bool CollectionFilter::is_empty() const {
  return glob.empty() && label.empty() && min_scale == 0.0 &&
         max_scale == std::numeric_limits<double>::infinity();
}

}  // namespace mdbd
