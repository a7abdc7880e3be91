#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collection/discover.h"

namespace mdbd {

/// A model file with its class.
struct LabelledModel {
  FoundFile file;
  std::string name;   ///< the path relative to the collection: "chair/12.off"
  std::string label;  ///< the class: the name of the folder below the collection that holds it
};

/// A folder of models with one folder for each class.
struct LabelledCollection {
  std::filesystem::path folder;
  std::vector<LabelledModel> models;  ///< ordered by class, then by name
  std::vector<UnusablePath> unusable;
  std::vector<std::string> notes;  ///< what a reader of a report must know about the collection
};

/// Finds the models below a folder; the first folder on the way to a model is its class. Models
/// that lie in the folder itself have no class and are left out, with a note.
/// @param sample_size at most so many models of each class, drawn with `seed`; 0 takes all
/// @throws IoError if the folder does not exist or is no folder
/// @throws InvalidInput if no model lies in a folder of a class
LabelledCollection find_labelled_models(const std::filesystem::path& folder,
                                        std::size_t sample_size, std::uint64_t seed);

}  // namespace mdbd
