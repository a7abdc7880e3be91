#include "indexer/folder_watch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <linux/magic.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "collection/discover.h"
#include "features/shape_io/shape_files.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

constexpr std::uint32_t events_heard = IN_CREATE | IN_MODIFY | IN_CLOSE_WRITE | IN_ATTRIB |
                                       IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_DELETE_SELF |
                                       IN_MOVE_SELF | IN_ONLYDIR | IN_DONT_FOLLOW | IN_EXCL_UNLINK;

bool is_folder(const fs::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

/// What others do to files on a network the system does not hear of.
bool is_on_network(const fs::path& folder) {
  struct statfs status {};
  if (::statfs(folder.c_str(), &status) != 0) return false;
  constexpr std::array<std::uint32_t, 6> networks = {NFS_SUPER_MAGIC,  SMB_SUPER_MAGIC,
                                                     0xFF534D42,       0xFE534D42,  // CIFS, SMB2
                                                     FUSE_SUPER_MAGIC, V9FS_MAGIC};
  for (const std::uint32_t network : networks) {
    if (static_cast<std::uint32_t>(status.f_type) == network) return true;
  }
  return false;
}

}  // namespace

class FolderWatch::Watches {
 public:
  explicit Watches(std::span<const std::string> roots)
      : roots_(roots.begin(), roots.end()), inotify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    watch_roots();
  }
  ~Watches() {
    if (inotify_ >= 0) ::close(inotify_);
  }
  Watches(const Watches&) = delete;
  Watches& operator=(const Watches&) = delete;

  bool wait(std::chrono::milliseconds most) {
    pollfd events{.fd = inotify_, .events = POLLIN, .revents = 0};
    return ::poll(&events, 1, static_cast<int>(most.count())) > 0;
  }

  FolderChanges take_changes() {
    read_events();
    return std::exchange(changes_, {});
  }

  const std::string& limit() const { return limit_; }

  void watch_roots() {
    limit_.clear();
    if (inotify_ < 0)
      limit_ = std::string("the system reports no changes: ") + std::strerror(errno);
    for (const std::string& root : roots_) {
      std::error_code ignored;
      const fs::file_status status = fs::status(root, ignored);
      if (!fs::exists(status)) {
        limit_ = root + " is not there";
      } else if (is_on_network(root)) {
        limit_ = root + " is on a file system that does not report all changes";
      } else if (fs::is_directory(status)) {
        watch_tree(root);
      } else {
        watch_folder(fs::path(root).parent_path().string());
      }
    }
  }

 private:
  /// Watches a folder before its entries are read, so that none is missed in between.
  void watch_tree(const std::string& top) {
    std::vector<std::string> folders = {top};
    while (!folders.empty()) {
      const std::string folder = std::move(folders.back());
      folders.pop_back();
      if (!watch_folder(folder)) continue;
      std::error_code error;
      for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
           entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.front() != '.' && is_folder(entry->path())) folders.push_back(entry->path());
      }
    }
  }

  bool watch_folder(const std::string& folder) {
    if (inotify_ < 0) return false;
    const bool is_link = fs::is_symlink(folder);  // a root may be one
    const std::uint32_t mask = is_link ? events_heard & ~IN_DONT_FOLLOW : events_heard;
    const int watch = ::inotify_add_watch(inotify_, folder.c_str(), mask);
    if (watch >= 0) {
      folders_[watch] = folder;
      return true;
    }
    if (errno == ENOSPC) {
      limit_ = "the system has no more watches (fs.inotify.max_user_watches)";
    } else if (errno != ENOENT && errno != ENOTDIR) {
      limit_ = fmt::format("{} cannot be watched: {}", folder, std::strerror(errno));
    }
    return false;
  }

  void read_events() {
    alignas(inotify_event) std::array<char, 1 << 16> buffer;
    while (inotify_ >= 0) {
      const ssize_t size = ::read(inotify_, buffer.data(), buffer.size());
      if (size <= 0) {
        if (size < 0 && errno == EINTR) continue;
        return;
      }
      for (const char* at = buffer.data(); at < buffer.data() + size;) {
        const auto* event = reinterpret_cast<const inotify_event*>(at);
        take(*event, event->len > 0 ? event->name : "");
        at += sizeof(inotify_event) + event->len;
      }
    }
  }

  void take(const inotify_event& event, const std::string& name) {
    if ((event.mask & IN_Q_OVERFLOW) != 0) {
      changes_.is_everything = true;
      watch_roots();  // the creation of a folder may be among what was lost
      return;
    }
    const auto folder = folders_.find(event.wd);
    if (folder == folders_.end()) return;  // of a folder that moved; its new place is looked at
    if ((event.mask & IN_IGNORED) != 0) {
      folders_.erase(folder);
      return;
    }
    if ((event.mask & (IN_DELETE_SELF | IN_MOVE_SELF)) != 0) {
      if (is_root(folder->second)) limit_ = folder->second + " is not there";
      return;  // of other folders the folder above tells the same
    }
    if (name.empty() || name.front() == '.') return;
    const std::string path = (fs::path(folder->second) / name).string();
    if (!is_within(path, roots_)) return;  // beside a root that is a file
    const bool is_of_folder = (event.mask & IN_ISDIR) != 0;
    if (is_of_folder || has_shape_extension(path)) changes_.paths.insert(path);
    if (!is_of_folder) return;
    if ((event.mask & IN_MOVED_FROM) != 0) forget_tree(path);
    if ((event.mask & (IN_CREATE | IN_MOVED_TO)) != 0) watch_tree(path);
  }

  bool is_root(const std::string& path) const {
    return std::find(roots_.begin(), roots_.end(), path) != roots_.end();
  }

  /// A folder that moved is watched under its old name until it is forgotten.
  void forget_tree(const std::string& top) {
    const std::array tops = {top};
    std::erase_if(folders_, [&](const auto& entry) {
      if (!is_within(entry.second, tops)) return false;
      ::inotify_rm_watch(inotify_, entry.first);
      return true;
    });
  }

  std::vector<std::string> roots_;
  int inotify_;
  std::unordered_map<int, std::string> folders_;  ///< by the system's number of the watch
  FolderChanges changes_;
  std::string limit_;
};

FolderWatch::FolderWatch(std::span<const std::string> roots)
    : watches_(std::make_unique<Watches>(roots)) {}

FolderWatch::~FolderWatch() = default;

bool FolderWatch::wait(std::chrono::milliseconds most) { return watches_->wait(most); }

FolderChanges FolderWatch::take_changes() { return watches_->take_changes(); }

void FolderWatch::watch_again() { watches_->watch_roots(); }

const std::string& FolderWatch::limit() const { return watches_->limit(); }

}  // namespace mdbd
