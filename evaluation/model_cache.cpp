#include "evaluation/model_cache.h"

#include <algorithm>
#include <deque>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>
#include <xxhash.h>

#include "collection/model_job.h"
#include "features/core/errors.h"
#include "features/describe.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

constexpr std::chrono::milliseconds wait_interval{100};

/// What follows a file's path in the paths of the store. No absolute and normal path holds two
/// slashes in a row, so that file and stage cannot be confused, whatever files are called.
constexpr std::string_view separator = "//";

std::string stage_suffix(const Variant& variant) {
  return variant.name.empty() ? "" : fmt::format("{}variant {}", separator, variant.name);
}

std::string stage_suffix(const FileSignature& signature) {
  return fmt::format("{}signature {}", separator, signature.name);
}

fs::path database_path(const fs::path& folder, const Recipe& recipe) {
  std::string text;
  for (const auto& [name, value] : to_entries(recipe)) text += name + '=' + value + '\n';
  return folder / fmt::format("mdbd-{:016x}.db", XXH3_64bits(text.data(), text.size()));
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) {
    throw IoError(
        fmt::format("{}: the folder of the cache cannot be created: {}; the folder above "
                    "it must exist and be writable",
                    folder.string(), error.message()));
  }
}

std::unique_ptr<ShapeStore> open_cache(const fs::path& folder, const Recipe& recipe) {
  create_folder(folder);
  Recipe stored = recipe;
  stored.walk_weight = Recipe{}.walk_weight;  // it changes no number that is stored
  return open_store(database_path(folder, stored), stored);
}

/// Whether a record still says what computing it again would say.
bool is_current(const ShapeRecord& record, const FoundFile& file) {
  return record.file_size == file.size && record.modified_ns == file.modified_ns &&
         record.failure != FailureKind::unreadable;
}

/// The records of one stage: a variant or the failures of a signature.
class StageRecords {
 public:
  StageRecords(ShapeStore& store, std::string suffix) : store_(store), suffix_(std::move(suffix)) {
    for (ShapeRecord& record : store_.shapes()) {
      const std::size_t end = std::min(record.path.find(separator), record.path.size());
      if (std::string_view(record.path).substr(end) == suffix_) remember(std::move(record));
    }
  }

  const ShapeRecord* find(const FoundFile& file) const {
    const auto found = records_.find(file.path + suffix_);
    return found == records_.end() ? nullptr : &found->second;
  }

  bool is_current(const FoundFile& file) const {
    const ShapeRecord* record = find(file);
    return record != nullptr && mdbd::is_current(*record, file);
  }

  const std::unordered_set<std::string>& known_keys() const { return known_keys_; }

  /// Stores what a job found out about a file.
  void put(const FoundFile& file, ShapeRecord record, const ShapeData& data) {
    record.path = file.path + suffix_;
    record.file_size = file.size;
    record.modified_ns = file.modified_ns;
    record.id = store_.put(record, data);
    remember(std::move(record));
  }

  /// Stores what is known of a file's content under the name of the file.
  /// @returns false if it is known no more: another program changed the store
  bool put_known(const FoundFile& file, const std::string& content_hash) {
    const std::string key = content_key(content_hash, file.path);
    const auto source = find_content(content_hash, key, file);
    if (!source) {
      known_keys_.erase(key);
      return false;
    }
    if (source->path == file.path + suffix_) {
      store_.touch(source->id, file.size, file.modified_ns);
      remember(*source);
    } else {
      put(file, *source, store_.data(source->id));
    }
    return true;
  }

 private:
  /// The record of a content, the file's own if there are several.
  std::optional<ShapeRecord> find_content(const std::string& content_hash, const std::string& key,
                                          const FoundFile& file) const {
    std::optional<ShapeRecord> found;
    for (ShapeRecord& record : store_.find_by_hash(content_hash)) {
      if (key_of(record) != key) continue;
      const bool is_own = record.path == file.path + suffix_;
      if (is_own || !found) found = std::move(record);
      if (is_own) break;
    }
    return found;
  }

  /// The content's key if the record is of this stage.
  std::optional<std::string> key_of(const ShapeRecord& record) const {
    const std::string_view path = record.path;
    const std::size_t end = std::min(path.find(separator), path.size());
    if (path.substr(end) != suffix_ || record.content_hash.empty()) return std::nullopt;
    return content_key(record.content_hash, path.substr(0, end));
  }

  void remember(ShapeRecord record) {
    if (const auto key = key_of(record)) known_keys_.insert(*key);
    std::string path = record.path;
    records_.insert_or_assign(std::move(path), std::move(record));
  }

  ShapeStore& store_;
  std::string suffix_;
  std::unordered_map<std::string, ShapeRecord> records_;
  std::unordered_set<std::string> known_keys_;
};

/// Runs a job for each pending model until all are done or the observer ends it.
/// @param work computes a model in a process of its own
/// @param finish takes what came of it; false: the model must be computed again
template <typename Work, typename Finish>
void run_jobs(std::deque<std::size_t> pending, const CacheOptions& options,
              EvaluationProgress& progress, const Work& work, const Finish& finish) {
  ProcessPool pool(options.jobs, options.limits);
  while (true) {
    const bool is_interrupted = !pending.empty() && progress.is_interrupted();
    while (!is_interrupted && !pending.empty() && !pool.is_full()) {
      const std::size_t model = pending.front();
      pending.pop_front();
      pool.start(model, [&](const SendOutput& send) { work(model, send); });
    }
    if (pool.is_empty()) break;
    for (const ProcessOutcome& outcome : pool.wait(wait_interval)) {
      if (!finish(outcome)) pending.push_front(outcome.job);
    }
    progress.on_wait();
  }
  if (!pending.empty()) throw Interrupted();
}

void report(EvaluationProgress& progress, const std::string& stage, const LabelledModel& model,
            const ShapeRecord& record) {
  const bool has_failed = record.status == ShapeStatus::failed;
  if (has_failed) progress.on_failure(stage, model.name, record.reason);
  progress.on_model_done(has_failed);
}

}  // namespace

Variant clean_variant() { return {.name = "", .load = load_shape}; }

ModelCache::ModelCache(const CacheOptions& options, const Recipe& recipe,
                       EvaluationProgress& progress)
    : options_(options),
      recipe_(recipe),
      store_(open_cache(options.folder, recipe)),
      progress_(progress) {}

DescribedModels ModelCache::describe(std::span<const LabelledModel> models,
                                     const Variant& variant) {
  StageRecords records(*store_, stage_suffix(variant));
  std::deque<std::size_t> pending;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (records.is_current(models[i].file)) continue;
    preload_reader(models[i].file.path);
    pending.push_back(i);
  }
  if (!pending.empty()) {
    progress_.on_stage(variant.name.empty() ? "clean models" : variant.name, pending.size());
  }
  const auto describe = [&](const fs::path& path) {
    return describe_shape(variant.load(path, recipe()), recipe());
  };
  const auto work = [&](std::size_t i, const SendOutput& send) {
    run_model_job(models[i].file.path, records.known_keys(), describe, send);
  };
  const auto finish = [&](const ProcessOutcome& outcome) {
    const LabelledModel& model = models[outcome.job];
    const ModelResult result = read_model_result(outcome);
    if (!result.is_known) {
      records.put(model.file, result.record, result.data);
    } else if (!records.put_known(model.file, result.record.content_hash)) {
      return false;
    }
    report(progress_, variant.name, model, *records.find(model.file));
    return true;
  };
  run_jobs(std::move(pending), options_, progress_, work, finish);

  DescribedModels described(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const ShapeRecord& record = *records.find(models[i].file);
    if (record.status == ShapeStatus::failed) {
      add_failure({variant.name, models[i].name, record.reason});
      continue;
    }
    ShapeData data = store_->data(record.id);
    described[i] = {std::move(data.balls), std::move(data.signature), record.scale,
                    record.statistics};
  }
  return described;
}

SignatureVectors ModelCache::compute_signature(std::span<const LabelledModel> models,
                                               const FileSignature& signature) {
  const StageRecords clean(*store_, stage_suffix(clean_variant()));
  StageRecords failed(*store_, stage_suffix(signature));
  std::unordered_map<std::int64_t, std::vector<float>> vectors;
  const VectorTable stored = store_->vectors(signature.name);
  for (const StoredVector vector : stored) {
    vectors.emplace(vector.shape_id, std::vector(vector.values.begin(), vector.values.end()));
  }
  const auto id_of = [&](std::size_t i) { return clean.find(models[i].file)->id; };

  std::deque<std::size_t> pending;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const ShapeRecord* record = clean.find(models[i].file);
    if (record == nullptr || record->status == ShapeStatus::failed) continue;
    if (vectors.contains(record->id) || failed.is_current(models[i].file)) continue;
    preload_reader(models[i].file.path);
    pending.push_back(i);
  }
  if (!pending.empty()) progress_.on_stage(signature.name, pending.size());

  // The vector travels as the descriptor of a shape without balls.
  const auto describe = [&](const fs::path& path) {
    ShapeDescription description;
    description.descriptor.values = signature.compute(path);
    return description;
  };
  const auto work = [&](std::size_t i, const SendOutput& send) {
    run_model_job(models[i].file.path, {}, describe, send);
  };
  const auto finish = [&](const ProcessOutcome& outcome) {
    const LabelledModel& model = models[outcome.job];
    ModelResult result = read_model_result(outcome);
    if (result.record.status == ShapeStatus::failed) {
      failed.put(model.file, result.record, {});
    } else {
      const std::int64_t id = id_of(outcome.job);
      store_->put_vector(id, signature.name, result.data.signature);
      vectors.emplace(id, std::move(result.data.signature));
    }
    report(progress_, signature.name, model, result.record);
    return true;
  };
  run_jobs(std::move(pending), options_, progress_, work, finish);

  SignatureVectors found(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const ShapeRecord* record = clean.find(models[i].file);
    if (record == nullptr || record->status == ShapeStatus::failed) continue;
    const auto vector = vectors.find(record->id);
    if (vector != vectors.end()) {
      found[i] = vector->second;
    } else {
      add_failure({signature.name, models[i].name, failed.find(models[i].file)->reason});
    }
  }
  return found;
}

std::vector<std::optional<std::string>> ModelCache::run(
    const std::string& stage, std::span<const std::string> names,
    const std::function<std::string(std::size_t)>& work) {
  progress_.on_stage(stage, names.size());
  std::deque<std::size_t> pending;
  for (std::size_t i = 0; i < names.size(); ++i) pending.push_back(i);

  // The first byte says whether a result or a reason follows.
  constexpr char done = '+';
  constexpr char failed = '-';
  const auto work_and_send = [&](std::size_t i, const SendOutput& send) {
    std::string output(1, done);
    try {
      output += work(i);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      output = failed + std::string(error.what());
    }
    send(output);
  };
  std::vector<std::optional<std::string>> results(names.size());
  const auto finish = [&](const ProcessOutcome& outcome) {
    const bool has_finished = outcome.end == ProcessEnd::finished;
    const bool has_failed = !has_finished || outcome.output.front() == failed;
    if (has_failed) {
      const std::string reason = has_finished ? outcome.output.substr(1) : outcome.reason;
      progress_.on_failure(stage, names[outcome.job], reason);
      add_failure({stage, names[outcome.job], reason});
    } else {
      results[outcome.job] = outcome.output.substr(1);
    }
    progress_.on_model_done(has_failed);
    return true;
  };
  run_jobs(std::move(pending), options_, progress_, work_and_send, finish);
  return results;
}

void ModelCache::add_failure(EvaluationFailure failure) {
  const bool is_known = std::ranges::any_of(failures_, [&](const EvaluationFailure& known) {
    return known.stage == failure.stage && known.model == failure.model;
  });
  if (!is_known) failures_.push_back(std::move(failure));
}

}  // namespace mdbd
