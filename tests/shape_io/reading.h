#pragma once

#include <string>
#include <string_view>

#include "features/core/errors.h"
#include "features/shape_io/read_mesh.h"
#include "tests/support/temporary_directory.h"

namespace mdbd::test {

/// Reads content as a file of this ending.
inline MeshFile read_content(std::string_view extension, std::string_view content) {
  const TemporaryDirectory directory;
  return read_mesh(directory.write("model" + std::string(extension), content));
}

/// Why content cannot be read as a file of this ending; empty if it can.
inline std::string reason_against(std::string_view extension, std::string_view content) {
  try {
    read_content(extension, content);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace mdbd::test
