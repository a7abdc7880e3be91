#include "features/modules/module.h"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include "features/core/errors.h"

namespace mdbd {

const void* find_module(const char* name) {
  void* const library = dlopen((std::string(name) + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const functions = library != nullptr ? dlsym(library, "mdbd_module") : nullptr;
  if (functions == nullptr) {
    throw IoError(fmt::format("needs the module {}, which cannot be loaded: {}", name, dlerror()));
  }
  return functions;
}

}  // namespace mdbd
