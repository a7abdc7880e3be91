// After the ".ZIP File Format Specification" (APPNOTE) of PKWARE.
#include "features/shape_io/zip_archive.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <zlib.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr std::size_t largest_entry = std::size_t{1} << 30;  // bytes
constexpr std::size_t end_size = 22;                         // of the record that ends an archive
constexpr std::size_t longest_comment = 0xffff;              // behind it
constexpr std::size_t header_size = 46;                      // of an entry in the directory
constexpr std::size_t local_size = 30;                       // of an entry before its data

[[noreturn]] void refuse() { throw InvalidInput("the zip archive is damaged or truncated"); }

std::string_view part(std::string_view bytes, std::size_t start, std::size_t size) {
  if (start > bytes.size() || size > bytes.size() - start) refuse();
  return bytes.substr(start, size);
}

/// A little-endian number of two or four bytes.
std::uint32_t number(std::string_view bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = size; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  }
  return value;
}

std::string_view end_record(std::string_view archive) {
  const std::size_t most = std::min(archive.size(), end_size + longest_comment);
  const std::string_view tail = archive.substr(archive.size() - most);
  const std::size_t at = tail.rfind("PK\5\6");
  if (at == tail.npos) throw InvalidInput("no zip archive, or one without its end");
  return part(tail, at, end_size);
}

/// What stands behind the local header that an entry of the directory refers to.
std::string_view packed_data(std::string_view archive, std::string_view header) {
  const std::size_t start = number(header, 42, 4);
  const std::string_view local = part(archive, start, local_size);
  if (!local.starts_with("PK\3\4")) refuse();
  const std::size_t names = number(local, 26, 2) + number(local, 28, 2);
  return part(archive, start + local_size + names, number(header, 20, 4));
}

}  // namespace

std::vector<ZipEntry> list_zip(std::string_view archive) {
  const std::string_view end = end_record(archive);
  std::size_t at = number(end, 16, 4);
  std::vector<ZipEntry> entries;
  for (std::uint32_t left = number(end, 10, 2); left > 0; --left) {
    const std::string_view header = part(archive, at, header_size);
    if (!header.starts_with("PK\1\2")) refuse();
    const std::size_t name_size = number(header, 28, 2);
    entries.push_back({.name = part(archive, at + header_size, name_size),
                       .packed = packed_data(archive, header),
                       .size = number(header, 24, 4),
                       .method = static_cast<int>(number(header, 10, 2))});
    at += header_size + name_size + number(header, 30, 2) + number(header, 32, 2);
  }
  return entries;
}

std::string unpack(const ZipEntry& entry) {
  if (entry.method == 0) return std::string(entry.packed);
  if (entry.method != Z_DEFLATED) throw InvalidInput("the zip archive is packed in an unknown way");
  if (entry.size > largest_entry) throw InvalidInput("a file in the zip archive is above 1 GiB");
  z_stream stream = {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(entry.packed.data()));
  stream.avail_in = static_cast<uInt>(entry.packed.size());
  std::string bytes(entry.size, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw InvalidInput("zlib cannot begin to unpack");
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END || stream.avail_out != 0) refuse();
  return bytes;
}

}  // namespace mdbd
