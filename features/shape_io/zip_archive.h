#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdbd {

/// A file in a zip archive, still packed. Views into the archive.
struct ZipEntry {
  std::string_view name;
  std::string_view packed;
  std::size_t size = 0;  ///< bytes, unpacked
  int method = 0;        ///< 0 stored, 8 deflated
};

/// The files of a zip archive, in the order of its directory; neither encrypted nor in the form for
/// more than 4 GiB (zip64).
/// @throws InvalidInput if the bytes are no such archive or damaged
std::vector<ZipEntry> list_zip(std::string_view archive);

/// @throws InvalidInput if the entry is damaged, packed in another way or larger than 1 GiB
std::string unpack(const ZipEntry& entry);

}  // namespace mdbd
