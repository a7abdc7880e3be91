#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "features/core/errors.h"

/// Files that are mapped into memory, of which nothing is believed that is not what was written:
/// there is a checksum for each block, compared before the block is first read. So a program that
/// needs little of a large file reads little of it.
///
/// Little-endian: a front with the checksum of a table; the table, the XXH3 (64 bits) of each
/// block; then the sections, each at the beginning of a block and filled up with zeros.
namespace mdbd {

/// What was read is not what was written.
class DamagedFile : public StoreError {
 public:
  using StoreError::StoreError;
};

/// What kind of file it is, in which version.
using FileMagic = std::array<char, 8>;

/// A checked file in memory. What other programs write to it is not kept out, and one that shortens
/// it in place kills this one. Thread-safe.
class CheckedFile {
 public:
  static constexpr std::size_t block_size = 4096;

  /// How much of the file a section takes.
  static constexpr std::size_t padded(std::size_t bytes) {
    return (bytes + block_size - 1) / block_size * block_size;
  }

  /// @returns nothing if there is no such file, it is of another kind, has not its full length, or
  ///          its front or table is damaged
  static std::shared_ptr<const CheckedFile> open(const std::filesystem::path& path,
                                                 const FileMagic& magic);

  ~CheckedFile();
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;

  /// The sections, not to be read before check().
  std::span<const std::byte> content() const { return content_; }

  /// Compares what was not compared yet.
  /// @param bytes a part of the content
  /// @throws DamagedFile if a block of it is not what was written
  void check(std::span<const std::byte> bytes) const {
    if (!is_checked(bytes)) compare(bytes);
  }

  /// Has the system read what will be checked soon, if it was not yet.
  void prefetch(std::span<const std::byte> bytes) const;

 private:
  explicit CheckedFile(std::span<const std::byte> mapped) : mapped_(mapped) {}
  bool read_table(const FileMagic& magic);
  bool is_checked(std::span<const std::byte> bytes) const;
  void compare(std::span<const std::byte> bytes) const;

  std::size_t first_block(std::span<const std::byte> bytes) const {
    return static_cast<std::size_t>(bytes.data() - content_.data()) / block_size;
  }
  std::size_t end_block(std::span<const std::byte> bytes) const {
    const auto end = static_cast<std::size_t>(bytes.data() - content_.data()) + bytes.size();
    return (end + block_size - 1) / block_size;
  }

  std::span<const std::byte> mapped_;
  std::span<const std::byte> content_;
  std::span<const std::uint64_t> checksums_;
  std::unique_ptr<std::atomic<bool>[]> are_checked_;
};

/// How many bytes a file of sections takes.
std::size_t checked_file_size(std::span<const std::span<const std::byte>> sections);

/// Writes a checked file, in place of any there; there is never half of one.
/// @returns whether it worked: not in a read-only folder, while another program writes it, or if
///          less would be left on the disk than the file takes
bool write_checked_file(const std::filesystem::path& path, const FileMagic& magic,
                        std::span<const std::span<const std::byte>> sections);

inline bool CheckedFile::is_checked(std::span<const std::byte> bytes) const {
  // Nothing is ever written to what a flag stands for, so that no order is needed.
  if (bytes.empty()) return true;
  for (std::size_t block = first_block(bytes); block < end_block(bytes); ++block) {
    if (!are_checked_[block].load(std::memory_order_relaxed)) return false;
  }
  return true;
}

}  // namespace mdbd
