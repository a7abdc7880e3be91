#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mdbd {

/// Values by number, in blocks that are never moved. Numbers are used again.
template <typename Value>
class BlockPool {
 public:
  Value& operator[](std::uint32_t index) { return blocks_[index / block_size][index % block_size]; }

  std::uint32_t add(const Value& value) {
    if (!free_.empty()) {
      const std::uint32_t index = free_.back();
      free_.pop_back();
      (*this)[index] = value;
      return index;
    }
    if (blocks_.empty() || blocks_.back().size() == block_size) {
      blocks_.emplace_back().reserve(block_size);
    }
    blocks_.back().push_back(value);
    return static_cast<std::uint32_t>((blocks_.size() - 1) * block_size + blocks_.back().size() -
                                      1);
  }

  void remove(std::uint32_t index) { free_.push_back(index); }

  /// How many are in use.
  std::size_t size() const {
    if (blocks_.empty()) return 0;
    return (blocks_.size() - 1) * block_size + blocks_.back().size() - free_.size();
  }

  void prefetch(std::uint32_t index) {
    const auto* bytes = reinterpret_cast<const char*>(&(*this)[index]);
    for (std::size_t offset = 0; offset < sizeof(Value); offset += 64)
      __builtin_prefetch(bytes + offset);
  }

 private:
  static constexpr std::uint32_t block_size = 1024;

  std::vector<std::vector<Value>> blocks_;
  std::vector<std::uint32_t> free_;
};

}  // namespace mdbd
