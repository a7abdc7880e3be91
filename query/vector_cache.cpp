#include "query/vector_cache.h"

#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <xxhash.h>

#include "store/checked_file.h"

static_assert(std::endian::native == std::endian::little, "caches are little-endian");

namespace mdbd {
namespace {

namespace fs = std::filesystem;

constexpr FileMagic magic = {'M', 'D', 'B', 'D', 'V', 'E', 'C', '2'};
constexpr std::uint64_t largest_count = std::uint64_t{1} << 40;

using Digest = std::array<std::uint64_t, 2>;

Digest digest_of(std::string_view key) {
  const XXH128_hash_t hash = XXH3_128bits(key.data(), key.size());
  return {hash.low64, hash.high64};
}

/// The first section.
struct Header {
  Digest key = {};
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
};

/// The bytes of the other sections, in the order of the file.
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
      sum += CheckedFile::padded(size);
    }
    return sum;
  }

  std::size_t axes, corner, groups, values, ids, scales, path_ends, paths;
};

/// Takes sections off the front of the content.
class SectionReader {
 public:
  explicit SectionReader(std::span<const std::byte> content) : content_(content) {}

  template <typename Value>
  std::span<const Value> take(std::size_t size) {
    const std::span<const Value> section(reinterpret_cast<const Value*>(content_.data()),
                                         size / sizeof(Value));
    content_ = content_.subspan(CheckedFile::padded(size));
    return section;
  }

 private:
  std::span<const std::byte> content_;
};

bool is_possible(const Header& header) {
  const auto is_count = [](std::uint64_t count) { return count < largest_count; };
  return is_count(header.rows) && header.dimension < (1U << 20) && is_count(header.path_bytes) &&
         header.sketch_size <= SketchList::largest_dimension;
}

/// The header of a cache that was made from what the key names.
std::optional<Header> read_header(const CheckedFile& file, std::string_view key) {
  Header header;
  if (file.content().size() < CheckedFile::padded(sizeof(Header))) return std::nullopt;
  file.check(file.content().first(sizeof(Header)));
  std::memcpy(&header, file.content().data(), sizeof(Header));
  if (header.key != digest_of(key) || !is_possible(header) ||
      file.content().size() != CheckedFile::padded(sizeof(Header)) + Sections(header).total()) {
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

VectorTable read_table(const Header& header, SectionReader& reader,
                       std::shared_ptr<const CheckedFile> file) {
  const Sections sections(header);
  VectorArrays arrays;
  arrays.dimension = header.dimension;
  arrays.largest_number = static_cast<float>(header.largest_number);
  arrays.largest_magnitude = header.largest_magnitude;
  arrays.values = reader.take<float>(sections.values);
  arrays.ids = reader.take<std::int64_t>(sections.ids);
  arrays.scales = reader.take<double>(sections.scales);
  arrays.path_ends = reader.take<std::uint64_t>(sections.path_ends);
  const std::span<const char> paths = reader.take<char>(sections.paths);
  arrays.paths = {paths.data(), paths.size()};
  return VectorTable(arrays, std::move(file));
}

/// Sketches are read as a whole by every search, so they are checked at once.
template <typename Value>
std::span<const Value> take_checked(SectionReader& reader, std::size_t size,
                                    const CheckedFile& file) {
  const std::span<const Value> section = reader.take<Value>(size);
  file.check(std::as_bytes(section));
  return section;
}

Sketches read_sketches(const Header& header, SectionReader& reader,
                       std::shared_ptr<const CheckedFile> file) {
  const Sections sections(header);
  const PointNorm norm = header.is_l1 != 0 ? PointNorm::l1 : PointNorm::l2;
  MetricSketch map(to_axes(take_checked<double>(reader, sections.axes, *file), header.dimension),
                   norm, header.largest_weight);
  const auto corner = take_checked<double>(reader, sections.corner, *file);
  const auto groups = take_checked<std::uint8_t>(reader, sections.groups, *file);
  SketchList list(ScalarQuantiser(header.step, {corner.begin(), corner.end()}),
                  header.largest_error, groups, header.rows, norm, std::move(file));
  return {std::move(map), std::move(list)};
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
  const std::shared_ptr<const CheckedFile> file = CheckedFile::open(path, magic);
  if (!file) return std::nullopt;
  try {
    const std::optional<Header> header = read_header(*file, key);
    if (!header) return std::nullopt;
    SectionReader reader(file->content().subspan(CheckedFile::padded(sizeof(Header))));
    Sketches sketches = read_sketches(*header, reader, file);
    return CachedVectors{read_table(*header, reader, file), std::move(sketches)};
  } catch (const DamagedFile&) {
    return std::nullopt;
  }
}

bool write_vector_cache(const fs::path& path, std::string_view key, const VectorTable& table,
                        const Sketches& sketches) {
  const VectorArrays& arrays = table.arrays();
  const std::vector<double> axes = to_matrix(sketches.map.axes(), arrays.dimension);
  const Header header{.key = digest_of(key),
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
  const std::array sections = {std::as_bytes(std::span(&header, 1)),
                               std::as_bytes(std::span(axes)),
                               std::as_bytes(sketches.list.quantiser().corner()),
                               std::as_bytes(sketches.list.groups()),
                               std::as_bytes(arrays.values),
                               std::as_bytes(arrays.ids),
                               std::as_bytes(arrays.scales),
                               std::as_bytes(arrays.path_ends),
                               std::as_bytes(std::span(arrays.paths))};
  return write_checked_file(path, magic, sections);
}

}  // namespace mdbd
