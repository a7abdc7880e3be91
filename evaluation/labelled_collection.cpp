#include "evaluation/labelled_collection.h"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "evaluation/counted.h"
#include "features/core/errors.h"
#include "features/core/random.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

using Classes = std::map<std::string, std::vector<LabelledModel>>;

constexpr std::size_t names_in_note = 3;

/// "a, b, c and 4 more"
std::string join_some(std::span<const std::string> names) {
  std::string text;
  for (const std::string& name : names.first(std::min(names.size(), names_in_note))) {
    text += (text.empty() ? "" : ", ") + name;
  }
  if (names.size() > names_in_note) {
    text += fmt::format(" and {} more", names.size() - names_in_note);
  }
  return text;
}

Discovery discover_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw IoError(
        fmt::format("{}: is no folder; a collection is a folder with one folder for each "
                    "class",
                    folder.string()));
  }
  return discover(std::span(&folder, 1));
}

/// The path of a file relative to the root it was found below.
std::string relative_path(const std::string& path, const std::string& root) {
  return path.substr(root.ends_with('/') ? root.size() : root.size() + 1);
}

/// The models by class, each class ordered by name. The key "" holds those without a class.
Classes sort_into_classes(const Discovery& found) {
  Classes classes;
  for (const FoundFile& file : found.files) {
    const std::string name = relative_path(file.path, found.roots.front());
    const std::size_t slash = name.find('/');
    const std::string label = slash == std::string::npos ? "" : name.substr(0, slash);
    classes[label].push_back({file, name, label});
  }
  for (auto& [label, models] : classes) std::ranges::sort(models, {}, &LabelledModel::name);
  return classes;
}

/// Each class is drawn from by itself, so that the sample of one does not depend on the others.
void draw_sample(std::vector<LabelledModel>& models, std::size_t count, std::uint64_t seed) {
  if (models.size() <= count) return;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(models[i], models[i + random.index(models.size() - i)]);
  }
  models.resize(count);
  std::ranges::sort(models, {}, &LabelledModel::name);
}

[[noreturn]] void refuse(const fs::path& folder, std::size_t models) {
  const std::string found =
      models == 0 ? "holds no models"
                  : "holds " + counted(models, "model") + " but no folders of classes";
  throw InvalidInput(fmt::format("{}: {}; a collection has one folder for each class: {}",
                                 folder.string(), found, (folder / "chair" / "1.off").string()));
}

void note_unlabelled(std::span<const LabelledModel> models, std::vector<std::string>& notes) {
  if (models.empty()) return;
  std::vector<std::string> names;
  for (const LabelledModel& model : models) names.push_back(model.name);
  notes.push_back(fmt::format("{} in no folder of a class, left out: {}.",
                              counted(models.size(), "model"), join_some(names)));
}

void note_unusable(const Discovery& found, std::vector<std::string>& notes) {
  if (found.unusable.empty()) return;
  std::vector<std::string> texts;
  for (const UnusablePath& unusable : found.unusable) {
    texts.push_back(fmt::format("{} ({})", unusable.path, unusable.reason));
  }
  notes.push_back(
      fmt::format("{} that cannot be used: {}.", counted(texts.size(), "path"), join_some(texts)));
}

void note_single_models(const Classes& classes, std::vector<std::string>& notes) {
  std::vector<std::string> labels;
  for (const auto& [label, models] : classes) {
    if (models.size() == 1) labels.push_back(label);
  }
  if (labels.empty()) return;
  notes.push_back(
      fmt::format("{} of one model: {}. Such a model cannot be queried; it stays as a distractor.",
                  counted(labels.size(), "class", "es"), join_some(labels)));
}

}  // namespace

LabelledCollection find_labelled_models(const fs::path& folder, std::size_t sample_size,
                                        std::uint64_t seed) {
  Discovery found = discover_folder(folder);
  LabelledCollection collection;
  collection.folder = found.roots.front();
  Classes classes = sort_into_classes(found);
  const auto unlabelled = classes.extract("");
  if (classes.empty()) refuse(folder, found.files.size());
  if (unlabelled) note_unlabelled(unlabelled.mapped(), collection.notes);
  note_unusable(found, collection.notes);
  if (sample_size > 0) {
    for (auto& [label, models] : classes)
      draw_sample(models, sample_size, derive_seed(seed, label));
    collection.notes.push_back(
        fmt::format("A sample: at most {} of each class, drawn with seed {}.",
                    counted(sample_size, "model"), seed));
  }
  note_single_models(classes, collection.notes);
  for (auto& [label, models] : classes) {
    std::ranges::move(models, std::back_inserter(collection.models));
  }
  collection.unusable = std::move(found.unusable);
  return collection;
}

}  // namespace mdbd
