// Feeds a reader of CAD files whatever libFuzzer comes up with. It must refuse it with a reason or
// make a sound boundary representation of it. MDBD_ENDING is the ending of the format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "features/brep/read_brep.h"
#include "features/core/errors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                            ("mdbd-fuzz-" + std::to_string(getpid()) + MDBD_ENDING);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const mdbd::Brep brep = mdbd::read_brep(path).brep;
    for (const mdbd::Triangle& triangle : brep.mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= brep.mesh.vertices.size()) std::abort();
      }
    }
  } catch (const mdbd::InvalidInput& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
