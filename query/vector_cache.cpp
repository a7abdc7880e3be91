#include "query/vector_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

static_assert(std::endian::native == std::endian::little, "caches are little-endian");

namespace mdbd {
namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 8> magic = {'M', 'D', 'B', 'D', 'V', 'E', 'C', '2'};
constexpr std::size_t alignment = 64;
constexpr std::size_t front_size = 3 * alignment;
constexpr std::uint64_t largest_count = std::uint64_t{1} << 40;

using Digest = std::array<std::uint64_t, 2>;

Digest digest_of(XXH128_hash_t hash) { return {hash.low64, hash.high64}; }

struct Header {
  std::array<char, 8> magic = {};
  Digest key = {};
  Digest sections = {};  ///< checksum of all that follows the header
  std::uint64_t rows = 0;
  std::uint64_t dimension = 0;
  std::uint64_t path_bytes = 0;
  std::uint64_t sketch_size = 0;
  std::uint64_t is_l1 = 0;
  double largest_weight = 0.0;
  double largest_magnitude = 0.0;
  double largest_number = 0.0;
  double step = 0.0;           ///< of the quantiser
  double largest_error = 0.0;  ///< of the sketches
  std::uint64_t checksum = 0;  ///< of the header up to here
};
static_assert(sizeof(Header) <= front_size);

std::uint64_t checksum_of(const Header& header) {
  return XXH3_64bits(&header, offsetof(Header, checksum));
}

std::size_t padded(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

/// The bytes of each section, in the order of the file.
struct Sections {
  explicit Sections(const Header& header)
      : axes(header.sketch_size * (header.dimension + 1) * sizeof(double)),
        corner(header.sketch_size * sizeof(double)),
        groups(SketchList::grouped_size(header.rows, header.sketch_size)),
        values(header.rows * header.dimension * sizeof(float)),
        ids(header.rows * sizeof(std::int64_t)),
        scales(header.rows * sizeof(double)),
        path_ends(header.rows * sizeof(std::uint64_t)),
        paths(header.path_bytes) {}

  std::size_t total() const {
    std::size_t sum = 0;
    for (const std::size_t size : {axes, corner, groups, values, ids, scales, path_ends, paths}) {
      sum += padded(size);
    }
    return sum;
  }

  std::size_t axes, corner, groups, values, ids, scales, path_ends, paths;
};

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

  bool write(const void* data, std::size_t size) const {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t written = ::write(descriptor_, next, size);
      if (written <= 0) return false;
      next += written;
      size -= static_cast<std::size_t>(written);
    }
    return true;
  }

 private:
  int descriptor_;
};

/// A file in memory; what other programs write to it is not kept out.
class Mapping {
 public:
  explicit Mapping(const fs::path& path) {
    const OpenFile file(path, O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (!file.is_open() || ::fstat(file.get(), &status) != 0 || status.st_size <= 0) return;
    const auto size = static_cast<std::size_t>(status.st_size);
    void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file.get(), 0);
    if (address == MAP_FAILED) return;
    bytes_ = {static_cast<const std::byte*>(address), size};
  }
  ~Mapping() {
    if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

/// Takes sections off the front of bytes.
class SectionReader {
 public:
  explicit SectionReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename Value>
  std::span<const Value> take(std::size_t size) {
    const std::span<const Value> section(reinterpret_cast<const Value*>(bytes_.data()),
                                         size / sizeof(Value));
    bytes_ = bytes_.subspan(padded(size));
    return section;
  }

 private:
  std::span<const std::byte> bytes_;
};

bool is_possible(const Header& header) {
  const auto is_count = [](std::uint64_t count) { return count < largest_count; };
  return is_count(header.rows) && header.dimension < (1U << 20) && is_count(header.path_bytes) &&
         header.sketch_size <= SketchList::largest_dimension;
}

/// The header of a cache that is whole and was made from what the key names.
std::optional<Header> read_header(std::span<const std::byte> bytes, std::string_view key) {
  Header header;
  if (bytes.size() < front_size) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof(Header));
  if (header.magic != magic || header.checksum != checksum_of(header) || !is_possible(header) ||
      header.key != digest_of(XXH3_128bits(key.data(), key.size()))) {
    return std::nullopt;
  }
  const std::span<const std::byte> sections = bytes.subspan(front_size);
  if (sections.size() != Sections(header).total() ||
      header.sections != digest_of(XXH3_128bits(sections.data(), sections.size()))) {
    return std::nullopt;
  }
  return header;
}

/// Axes as a matrix: for each its offset and a coefficient for each number of a vector.
std::vector<double> to_matrix(std::span<const MetricSketch::Axis> axes, std::size_t dimension) {
  std::vector<double> matrix;
  for (const MetricSketch::Axis& axis : axes) {
    const std::size_t first = matrix.size();
    matrix.resize(first + 1 + dimension, 0.0);
    matrix[first] = axis.offset;
    for (const auto& term : axis.terms) matrix[first + 1 + term.index] = term.coefficient;
  }
  return matrix;
}

std::vector<MetricSketch::Axis> to_axes(std::span<const double> matrix, std::size_t dimension) {
  std::vector<MetricSketch::Axis> axes;
  for (; !matrix.empty(); matrix = matrix.subspan(1 + dimension)) {
    MetricSketch::Axis axis{.terms = {}, .offset = matrix[0]};
    for (std::size_t i = 0; i < dimension; ++i) {
      if (matrix[1 + i] != 0.0) axis.terms.push_back({i, matrix[1 + i]});
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

std::vector<std::span<const std::byte>> list_sections(const std::vector<double>& axes,
                                                      const Sketches& sketches,
                                                      const VectorArrays& arrays) {
  return {std::as_bytes(std::span(axes)),
          std::as_bytes(sketches.list.quantiser().corner()),
          std::as_bytes(sketches.list.groups()),
          std::as_bytes(arrays.values),
          std::as_bytes(arrays.ids),
          std::as_bytes(arrays.scales),
          std::as_bytes(arrays.path_ends),
          std::as_bytes(std::span(arrays.paths))};
}

std::span<const std::byte> padding_of(std::span<const std::byte> section) {
  static constexpr std::array<std::byte, alignment> zeros{};
  return std::span(zeros).first(padded(section.size()) - section.size());
}

struct HashStateDeleter {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

Digest checksum_of(std::span<const std::span<const std::byte>> sections) {
  const std::unique_ptr<XXH3_state_t, HashStateDeleter> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  for (const std::span<const std::byte> section : sections) {
    for (const std::span<const std::byte> part : {section, padding_of(section)}) {
      XXH3_128bits_update(state.get(), part.data(), part.size());
    }
  }
  return digest_of(XXH3_128bits_digest(state.get()));
}

bool has_room(const fs::path& path, std::size_t bytes) {
  std::error_code error;
  const fs::space_info space = fs::space(path.has_parent_path() ? path.parent_path() : ".", error);
  return !error && space.available / 2 > bytes;
}

// Whoever has the lock of an unfinished file may write it; one left by a killed program has none.
// What was opened may have become the cache of another program before it was locked.
bool lock(const OpenFile& file, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 &&
         ::fstat(file.get(), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

bool write_sections(const OpenFile& file, const Header& header,
                    std::span<const std::span<const std::byte>> sections) {
  std::array<std::byte, front_size> front{};
  std::memcpy(front.data(), &header, sizeof(Header));
  bool is_written = ::ftruncate(file.get(), 0) == 0 && file.write(front.data(), front.size());
  for (const std::span<const std::byte> section : sections) {
    const std::span<const std::byte> padding = padding_of(section);
    is_written = is_written && file.write(section.data(), section.size()) &&
                 file.write(padding.data(), padding.size());
  }
  return is_written;
}

}  // namespace

fs::path vector_cache_path(const fs::path& database, SignatureKind signature) {
  return fs::path(database) += "." + std::string(to_string(signature)) + ".vectors";
}

std::string vector_cache_key(const ShapeStore& store, SignatureKind signature) {
  std::string key = store.revision();
  if (key.empty()) return key;
  key.append("\n").append(stored_name(signature));
  for (const auto& [name, value] : to_entries(store.recipe())) {
    key.append("\n").append(name).append(" ").append(value);
  }
  return key;
}

std::optional<CachedVectors> read_vector_cache(const fs::path& path, std::string_view key) {
  const auto mapping = std::make_shared<const Mapping>(path);
  const std::optional<Header> header = read_header(mapping->bytes(), key);
  if (!header) return std::nullopt;
  const Sections sections(*header);
  SectionReader reader(mapping->bytes().subspan(front_size));
  const PointNorm norm = header->is_l1 != 0 ? PointNorm::l1 : PointNorm::l2;
  MetricSketch map(to_axes(reader.take<double>(sections.axes), header->dimension), norm,
                   header->largest_weight);
  const std::span<const double> corner = reader.take<double>(sections.corner);
  SketchList list(ScalarQuantiser(header->step, {corner.begin(), corner.end()}),
                  header->largest_error, reader.take<std::uint8_t>(sections.groups), header->rows,
                  norm, mapping);
  VectorArrays arrays;
  arrays.dimension = header->dimension;
  arrays.largest_number = static_cast<float>(header->largest_number);
  arrays.largest_magnitude = header->largest_magnitude;
  arrays.values = reader.take<float>(sections.values);
  arrays.ids = reader.take<std::int64_t>(sections.ids);
  arrays.scales = reader.take<double>(sections.scales);
  arrays.path_ends = reader.take<std::uint64_t>(sections.path_ends);
  const std::span<const char> paths = reader.take<char>(sections.paths);
  arrays.paths = {paths.data(), paths.size()};
  return CachedVectors{VectorTable(arrays, mapping), {std::move(map), std::move(list)}};
}

bool write_vector_cache(const fs::path& path, std::string_view key, const VectorTable& table,
                        const Sketches& sketches) {
  const VectorArrays& arrays = table.arrays();
  const std::vector<double> axes = to_matrix(sketches.map.axes(), arrays.dimension);
  const auto sections = list_sections(axes, sketches, arrays);
  Header header{.magic = magic,
                .key = digest_of(XXH3_128bits(key.data(), key.size())),
                .sections = checksum_of(sections),
                .rows = table.size(),
                .dimension = arrays.dimension,
                .path_bytes = arrays.paths.size(),
                .sketch_size = sketches.map.size(),
                .is_l1 = sketches.map.norm() == PointNorm::l1 ? 1U : 0U,
                .largest_weight = sketches.map.largest_weight(),
                .largest_magnitude = arrays.largest_magnitude,
                .largest_number = arrays.largest_number,
                .step = sketches.list.quantiser().step(),
                .largest_error = sketches.list.largest_error()};
  header.checksum = checksum_of(header);
  if (!has_room(path, Sections(header).total())) return false;
  const fs::path unfinished = fs::path(path) += ".unfinished";
  const OpenFile file(unfinished, O_WRONLY | O_CREAT | O_CLOEXEC);
  if (!lock(file, unfinished)) return false;
  std::error_code error;
  if (write_sections(file, header, sections)) {
    fs::rename(unfinished, path, error);
    if (!error) return true;
  }
  fs::remove(unfinished, error);
  return false;
}

}  // namespace mdbd
