#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace mdbd {

/// Which models of a collection are searched. The others are as if they were not there, so that as
/// many matches come back as were asked for whenever there are so many.
struct CollectionFilter {
  /// A shell pattern (POSIX fnmatch: *, ?, [a-z]) for the file's name or, if it has a slash, for
  /// the whole path, in which * stands for slashes, too. Empty: any.
  std::string glob = {};
  std::string label = {};  ///< the class: the name of the folder that holds the file. Empty: any
  double min_scale = 0.0;  ///< of R, in object units
  double max_scale = std::numeric_limits<double>::infinity();

  bool accepts(std::string_view path, double scale) const;
  bool is_empty() const;
};

}  // namespace mdbd
