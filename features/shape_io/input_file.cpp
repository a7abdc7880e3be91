#include "features/shape_io/input_file.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr std::uint64_t largest_file = std::uint64_t{1} << 31;  // bytes

[[noreturn]] void fail(const std::error_code& error) {
  throw IoError("cannot be read: " + error.message());
}

}  // namespace

std::ifstream open_input_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw IoError("no such file");
  if (error) fail(error);
  if (status.type() == fs::file_type::directory) throw IoError("is a directory, not a file");
  if (status.type() != fs::file_type::regular) throw IoError("is not a regular file");

  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail({errno != 0 ? errno : EIO, std::generic_category()});
  return stream;
}

std::string read_input_file(const std::filesystem::path& path) {
  std::ifstream stream = open_input_file(path);
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) fail(error);
  if (size > largest_file) throw InvalidInput("the file is larger than 2 GiB");

  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (stream.bad()) throw IoError("cannot be read: reading stopped with an error");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) throw InvalidInput("the file is empty");
  return bytes;
}

std::string read_beginning(const std::filesystem::path& path, std::size_t size) {
  std::ifstream stream = open_input_file(path);
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (stream.bad()) throw IoError("cannot be read: reading stopped with an error");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace mdbd
