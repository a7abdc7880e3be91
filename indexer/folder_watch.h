#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>

namespace mdbd {

/// What happened at and below watched paths since it was last asked for.
struct FolderChanges {
  /// Files and folders to look at, whether they are there or not; absolute and lexically normal.
  std::set<std::string> paths;
  bool is_everything = false;  ///< more may have happened: look at all

  bool empty() const { return paths.empty() && !is_everything; }
};

/// Hears from the system (Linux inotify) what happens to files and folders. Folders that appear are
/// watched from then on and are among the changes, so that what they hold already is not missed.
/// Nothing that happens while nobody asks is lost: the system keeps it or, if it is too much, says
/// so. Hidden folders and links to folders are left out, as discover() does.
class FolderWatch {
 public:
  /// @param roots absolute and lexically normal; of a file its folder is watched
  explicit FolderWatch(std::span<const std::string> roots);
  ~FolderWatch();
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  /// Waits for something to happen, this long at most; ends at a signal, too.
  /// @returns whether something has happened
  bool wait(std::chrono::milliseconds most);

  /// What has happened to models and folders.
  FolderChanges take_changes();

  /// Tries again to watch what could not be watched. Look at everything after that.
  void watch_again();

  /// Why not everything is heard of: a root is missing or on a network, or the system has no more
  /// watches. Empty if everything is.
  const std::string& limit() const;

 private:
  class Watches;
  std::unique_ptr<Watches> watches_;
};

}  // namespace mdbd
