#include "features/shape_io/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include <unistd.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw IoError("cannot write " + path.string() + ": " + reason);
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view content) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) fail(path, error.message());
  if (std::filesystem::exists(target, error) && !std::filesystem::is_regular_file(target, error)) {
    fail(path, "it exists and is no ordinary file");
  }
  const std::filesystem::path partial =
      target.parent_path() / (".mdbd-" + std::to_string(getpid()) + ".partial");
  std::filesystem::remove(partial, error);  // left by a killed process of the same number
  std::FILE* stream = std::fopen(partial.c_str(), "wx");
  if (stream == nullptr) fail(path, std::strerror(errno));
  const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  const bool is_closed = std::fclose(stream) == 0;
  if (!is_written || !is_closed || std::rename(partial.c_str(), target.c_str()) != 0) {
    const std::string reason = std::strerror(errno);
    std::filesystem::remove(partial, error);
    fail(path, reason);
  }
}

}  // namespace mdbd
