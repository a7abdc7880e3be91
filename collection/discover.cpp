#include "collection/discover.h"

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include "features/brep/solid_path.h"
#include "features/core/errors.h"
#include "features/shape_io/shape_files.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

std::string reason_of(int error) {
  return fmt::format("cannot be read: {}", std::generic_category().message(error));
}

/// Why something that is neither a file nor a folder is no model.
std::string describe_kind(mode_t mode) {
  if (S_ISDIR(mode)) return "is a directory, not a model file";
  if (S_ISFIFO(mode)) return "is a named pipe, not a model file";
  if (S_ISSOCK(mode)) return "is a socket, not a model file";
  return "is a device, not a model file";
}

std::string absolute_normal(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal.string() : normal.parent_path().string();
}

/// One search; the folders still to be read are kept on a stack.
class Search {
 public:
  Search() { found_.started = std::chrono::steady_clock::now(); }

  void start(const std::string& root) {
    struct stat status {};
    const fs::path file = split_solid_path(root).file;
    if (::stat(file.c_str(), &status) != 0) {
      const int error = errno;
      throw IoError(fmt::format("{}: {}", root, std::generic_category().message(error)));
    }
    if (S_ISREG(status.st_mode) && !has_shape_extension(file)) {
      found_.unusable.push_back({root, fmt::format("unsupported ending; models end in {}",
                                                   fmt::join(shape_file_extensions(), ", "))});
    } else if (S_ISDIR(status.st_mode)) {
      folders_.push_back(root);
    } else {
      add_model(root, status);
    }
    search_folders();
  }

  void look_at(const std::string& path) {
    visit(path);
    search_folders();
  }

  Discovery finish(std::vector<std::string> roots) {
    const auto tidy = [](auto& items) {
      std::ranges::sort(
          items, {}, [](const auto& item) -> auto& { return item.path; });
      const auto same = [](const auto& a, const auto& b) { return a.path == b.path; };
      items.erase(std::unique(items.begin(), items.end(), same), items.end());
    };
    tidy(found_.files);
    tidy(found_.unusable);
    found_.roots = std::move(roots);
    return std::move(found_);
  }

 private:
  void search_folders() {
    while (!folders_.empty()) search_next_folder();
  }

  void search_next_folder() {
    const std::string folder = std::move(folders_.back());
    folders_.pop_back();
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
      const fs::path name = entry->path().filename();
      if (name.native().front() != '.') visit(entry->path());
    }
    if (error) add_closed_folder(folder, error.value());
  }

  /// A folder whose entries cannot be listed, or not be looked at: one may be readable and yet not
  /// searchable.
  void add_closed_folder(const fs::path& folder, int error) {
    found_.unusable.push_back({folder.string(), "folder " + reason_of(error)});
  }

  void visit(const fs::path& path) {
    struct stat status {};
    struct stat link {};
    if (::lstat(path.c_str(), &link) != 0) {
      // ENOENT: gone since its folder was read.
      if (const int error = errno; error != ENOENT) add_closed_folder(path.parent_path(), error);
      return;
    }
    if (S_ISDIR(link.st_mode)) folders_.push_back(path.string());
    if (!is_shape_file(path)) return;
    if (::stat(path.c_str(), &status) == 0) {
      add_model(path.string(), status);
    } else {
      const int error = errno;
      found_.unusable.push_back(
          {path.string(), error == ENOENT ? "is a link to nothing" : reason_of(error)});
    }
  }

  void add_model(const std::string& path, const struct stat& status) {
    if (!S_ISREG(status.st_mode)) {
      found_.unusable.push_back({path, describe_kind(status.st_mode)});
      return;
    }
    constexpr std::int64_t second = 1'000'000'000;
    found_.files.push_back({path, static_cast<std::uint64_t>(status.st_size),
                            status.st_mtim.tv_sec * second + status.st_mtim.tv_nsec});
  }

  Discovery found_;
  std::vector<std::string> folders_;
};

std::vector<std::string> to_roots(std::span<const fs::path> paths) {
  std::vector<std::string> roots;
  for (const fs::path& path : paths) roots.push_back(absolute_normal(path));
  std::ranges::sort(roots);
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

}  // namespace

Discovery discover(std::span<const fs::path> paths) {
  Search search;
  std::vector<std::string> roots = to_roots(paths);
  for (const std::string& root : roots) search.start(root);
  return search.finish(std::move(roots));
}

Discovery discover_existing(std::span<const fs::path> paths) {
  std::vector<fs::path> existing;
  std::error_code ignored;
  std::ranges::copy_if(paths, std::back_inserter(existing),
                       [&](const fs::path& path) { return fs::exists(path, ignored); });
  return discover(existing);
}

Discovery discover_changed(std::span<const fs::path> paths) {
  Search search;
  std::vector<std::string> roots = to_roots(paths);
  for (const std::string& root : roots) search.look_at(root);
  return search.finish(std::move(roots));
}

bool is_within(const std::string& path, std::span<const std::string> roots) {
  return std::ranges::any_of(roots, [&](const std::string& root) {
    const bool ends_in_slash = root.ends_with('/');
    return path == root || path.starts_with(ends_in_slash ? root : root + '/') ||
           (path.starts_with(root + '#') && split_solid_path(path).file == root);
  });
}

}  // namespace mdbd
