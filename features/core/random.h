#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

namespace mdbd {

/// Random numbers that are the same on every platform: the bits of std::mt19937_64, which the
/// standard fixes, without its distributions, which it does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1): one of 2^53 equally spaced numbers.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Uniform in [low, high); rounding may give `high` itself.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 … count - 1, every number exactly as likely as the others.
  /// @pre count > 0
  std::size_t index(std::size_t count) {
    const std::uint64_t n = count;
    const std::uint64_t surplus = (0 - n) % n;  // 2^64 mod n: so many draws are thrown away
    std::uint64_t bits = engine_();
    while (bits < surplus) bits = engine_();
    return static_cast<std::size_t>(bits % n);
  }

 private:
  std::mt19937_64 engine_;
};

/// A seed for one thing among many, say a model by its name, that does not depend on the others:
/// FNV-1a over the bytes of the text, begun with the seed, both spread by the finalizer of
/// SplitMix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t derive_seed(std::uint64_t seed, std::string_view text) {
  const auto spread = [](std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  };
  std::uint64_t hash = spread(seed);
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return spread(hash);
}

}  // namespace mdbd
