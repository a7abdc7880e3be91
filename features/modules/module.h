#pragma once

/// Modules: shared libraries of this project that hold what needs large libraries of others, loaded
/// when they are first needed. A module exports one object, `mdbd_module`: an aggregate of pointers
/// to its functions with a static member `module_name`, which both sides know.
namespace mdbd {

/// Makes a module's object visible to find_module(): MDBD_MODULE const Functions mdbd_module = {…};
#define MDBD_MODULE extern "C" [[gnu::visibility("default")]]

/// Loads a module, from where the program has been told to look for libraries (its RUNPATH).
/// @returns its object
/// @throws IoError with the reason if it cannot be loaded
const void* find_module(const char* name);

/// The functions of a module. It is loaded at the first call, and stays.
/// @throws IoError as find_module()
template <typename Functions>
const Functions& load_module() {
  static const void* const functions = find_module(Functions::module_name);
  return *static_cast<const Functions*>(functions);
}

}  // namespace mdbd
