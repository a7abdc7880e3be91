#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mdbd::bench {

/// The folder of the shared sets of real models: $MDBD_DATA, else mdbd-data in the user's cache
/// folder. It need not exist.
std::filesystem::path shared_data_folder();

/// Every `stride`-th model file of a shared set, by path; none if the set is not there.
/// @pre stride >= 1
std::vector<std::filesystem::path> find_shared_models(const std::string& set, std::size_t stride);

}  // namespace mdbd::bench
