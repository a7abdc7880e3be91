#include "features/shape_io/content_hash.h"

#include <memory>
#include <new>
#include <vector>

#include <xxhash.h>

#include "features/core/errors.h"
#include "features/shape_io/input_file.h"

namespace mdbd {
namespace {

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

std::string to_hexadecimal(const XXH128_canonical_t& hash) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : hash.digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string content_hash(const std::filesystem::path& path) {
  std::ifstream stream = open_input_file(path);
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  if (state == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state.get());

  std::vector<char> buffer(1 << 20);
  do {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    XXH3_128bits_update(state.get(), buffer.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) throw IoError("cannot be read: reading stopped with an error");

  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
  return to_hexadecimal(canonical);
}

}  // namespace mdbd
