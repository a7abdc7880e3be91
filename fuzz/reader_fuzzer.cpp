// Feeds a reader whatever libFuzzer comes up with. It must refuse it with a reason or make a sound
// mesh of it. MDBD_PLAIN names the function that examines the format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "features/core/errors.h"
#include "features/shape_io/clean_mesh.h"
#include "features/shape_io/openmesh_reader.h"
#include "features/shape_io/plain_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const mdbd::TriangleMesh mesh =
        mdbd::clean_mesh(mdbd::read_with_openmesh(mdbd::MDBD_PLAIN(bytes))).mesh;
    for (const mdbd::Triangle& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= mesh.vertices.size() || !mesh.vertices[corner].allFinite()) std::abort();
      }
    }
  } catch (const mdbd::InvalidInput& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
