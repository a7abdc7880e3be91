#pragma once

#include <stdexcept>

/// The exceptions that the libraries throw. Each stands on a std base, so that a caller who does
/// not know them still catches them; a program maps them to exit codes.
namespace mdbd {

/// The content of a file or an argument cannot be used: damaged, absurd, empty, not a solid.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A file cannot be read or written: missing, a directory, no permission, disk full.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The database cannot be opened or used: foreign, damaged, locked, of another recipe or schema.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mdbd
