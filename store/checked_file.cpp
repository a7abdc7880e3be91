#include "store/checked_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

static_assert(std::endian::native == std::endian::little, "checked files are little-endian");

namespace mdbd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = CheckedFile::block_size;

struct Front {
  FileMagic magic = {};
  std::uint64_t blocks = 0;
  std::array<std::uint64_t, 2> table = {};  ///< checksum
  std::uint64_t checksum = 0;               ///< of the front up to here
};

std::uint64_t checksum_of(const Front& front) {
  return XXH3_64bits(&front, offsetof(Front, checksum));
}

std::array<std::uint64_t, 2> checksum_of(std::span<const std::uint64_t> table) {
  const XXH128_hash_t hash = XXH3_128bits(table.data(), table.size_bytes());
  return {hash.low64, hash.high64};
}

/// Where the content begins.
std::size_t front_size(std::size_t blocks) {
  return CheckedFile::padded(sizeof(Front) + blocks * sizeof(std::uint64_t));
}

/// A file that is open.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags) : descriptor_(::open(path.c_str(), flags, 0666)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }

  bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// Fills up the last block of what was written.
  bool pad(std::size_t written) const {
    static constexpr std::array<std::byte, block_size> zeros{};
    return write(std::span(zeros).first(CheckedFile::padded(written) - written));
  }

 private:
  int descriptor_;
};

/// A whole file in memory, or nothing. The system reads no more of it than is asked for: what is
/// read of a large file is scattered.
std::span<const std::byte> map_file(const fs::path& path) {
  const OpenFile file(path, O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.get(), &status) != 0 || status.st_size <= 0) return {};
  const auto size = static_cast<std::size_t>(status.st_size);
  void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (address == MAP_FAILED) return {};
  ::madvise(address, size, MADV_RANDOM);
  return {static_cast<const std::byte*>(address), size};
}

/// Has the system read a part of a mapping. It takes no more of one request than its read-ahead,
/// which is 128 KiB on most systems.
void have_read(std::span<const std::byte> mapped, std::span<const std::byte> part) {
  constexpr std::size_t request = std::size_t{128} << 10;
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto first = static_cast<std::size_t>(part.data() - mapped.data());
  const std::size_t end = first + part.size();
  for (std::size_t start = first / page * page; start < end; start += request) {
    ::madvise(const_cast<std::byte*>(mapped.data()) + start, std::min(request, end - start),
              MADV_WILLNEED);
  }
}

std::vector<std::uint64_t> make_table(std::span<const std::span<const std::byte>> sections) {
  std::vector<std::uint64_t> table;
  for (std::span<const std::byte> section : sections) {
    for (; section.size() >= block_size; section = section.subspan(block_size)) {
      table.push_back(XXH3_64bits(section.data(), block_size));
    }
    if (section.empty()) continue;
    std::array<std::byte, block_size> last{};
    std::ranges::copy(section, last.begin());
    table.push_back(XXH3_64bits(last.data(), block_size));
  }
  return table;
}

bool has_room(const fs::path& path, std::size_t bytes) {
  std::error_code error;
  const fs::space_info space = fs::space(path.has_parent_path() ? path.parent_path() : ".", error);
  return !error && space.available / 2 > bytes;
}

// Whoever has the lock of an unfinished file may write it; one left by a killed program has none.
// What was opened may have become the finished file of another program before it was locked.
bool lock(const OpenFile& file, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 &&
         ::fstat(file.get(), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

bool write_file(const OpenFile& file, const FileMagic& magic,
                std::span<const std::span<const std::byte>> sections) {
  const std::vector<std::uint64_t> table = make_table(sections);
  Front front{.magic = magic, .blocks = table.size(), .table = checksum_of(table)};
  front.checksum = checksum_of(front);
  bool is_written = ::ftruncate(file.get(), 0) == 0 &&
                    file.write(std::as_bytes(std::span(&front, 1))) &&
                    file.write(std::as_bytes(std::span(table))) &&
                    file.pad(sizeof(Front) + std::span(table).size_bytes());
  for (const std::span<const std::byte> section : sections) {
    is_written = is_written && file.write(section) && file.pad(section.size());
  }
  return is_written;
}

}  // namespace

std::shared_ptr<const CheckedFile> CheckedFile::open(const fs::path& path, const FileMagic& magic) {
  const std::shared_ptr<CheckedFile> file(new CheckedFile(map_file(path)));
  return file->read_table(magic) ? file : nullptr;
}

CheckedFile::~CheckedFile() {
  if (!mapped_.empty()) ::munmap(const_cast<std::byte*>(mapped_.data()), mapped_.size());
}

bool CheckedFile::read_table(const FileMagic& magic) {
  Front front;
  if (mapped_.size() < sizeof(Front)) return false;
  std::memcpy(&front, mapped_.data(), sizeof(Front));
  if (front.magic != magic || front.checksum != checksum_of(front) ||
      front.blocks > mapped_.size() / block_size ||
      mapped_.size() != front_size(front.blocks) + front.blocks * block_size) {
    return false;
  }
  content_ = mapped_.subspan(front_size(front.blocks));
  have_read(mapped_, mapped_.first(front_size(front.blocks)));
  checksums_ = {reinterpret_cast<const std::uint64_t*>(mapped_.data() + sizeof(Front)),
                front.blocks};
  are_checked_ = std::make_unique<std::atomic<bool>[]>(front.blocks);
  return front.table == checksum_of(checksums_);
}

void CheckedFile::compare(std::span<const std::byte> bytes) const {
  if (bytes.size() > block_size) prefetch(bytes);
  for (std::size_t block = first_block(bytes); block < end_block(bytes); ++block) {
    if (are_checked_[block].load(std::memory_order_relaxed)) continue;
    if (XXH3_64bits(content_.data() + block * block_size, block_size) != checksums_[block]) {
      throw DamagedFile("a file beside the database is damaged");
    }
    are_checked_[block].store(true, std::memory_order_relaxed);
  }
}

void CheckedFile::prefetch(std::span<const std::byte> bytes) const {
  if (!is_checked(bytes)) have_read(mapped_, bytes);
}

std::size_t checked_file_size(std::span<const std::span<const std::byte>> sections) {
  std::size_t content = 0;
  for (const auto& section : sections) content += CheckedFile::padded(section.size());
  return front_size(content / block_size) + content;
}

bool write_checked_file(const fs::path& path, const FileMagic& magic,
                        std::span<const std::span<const std::byte>> sections) {
  if (!has_room(path, checked_file_size(sections))) return false;
  const fs::path unfinished = fs::path(path) += ".unfinished";
  const OpenFile file(unfinished, O_WRONLY | O_CREAT | O_CLOEXEC);
  if (!lock(file, unfinished)) return false;
  std::error_code error;
  if (write_file(file, magic, sections)) {
    fs::rename(unfinished, path, error);
    if (!error) return true;
  }
  fs::remove(unfinished, error);
  return false;
}

}  // namespace mdbd
