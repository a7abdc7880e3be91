#include "indexer/indexer.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <unordered_map>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "collection/discover.h"
#include "features/brep/solid_path.h"
#include "features/descriptor/fused_signature.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

constexpr std::chrono::milliseconds wait_interval{100};

bool is_gone(const std::string& path) {
  std::error_code ignored;
  return fs::status(split_solid_path(path).file, ignored).type() == fs::file_type::not_found;
}

/// A record of the same content for another file.
ShapeRecord with_file(ShapeRecord record, const FoundFile& file) {
  record.id = 0;
  record.path = file.path;
  record.file_size = file.size;
  record.modified_ns = file.modified_ns;
  return record;
}

bool is_solid(const ShapeRecord& record) { return split_solid_path(record.path).solid > 0; }

/// How many solids the file of a record has, as far as the record tells.
std::optional<std::size_t> solids_of(const ShapeRecord& record) {
  const auto statistics = nlohmann::json::parse(record.statistics, nullptr, false);
  const auto solids = statistics.find("solids");
  if (solids == statistics.end() || !solids->is_number_unsigned()) return std::nullopt;
  return solids->get<std::size_t>();
}

/// What a failed record of a CAD file tells solids_of(); 0 if it is not known.
std::string note_solids(std::size_t solids) { return nlohmann::json{{"solids", solids}}.dump(); }

/// One run.
class IndexRun {
 public:
  IndexRun(const Discovery& found, const IndexOptions& options, const DescribeFunction& describe,
           ShapeStore& store, IndexObserver& observer)
      : found_(found),
        options_(options),
        describe_(describe),
        store_(store),
        observer_(observer),
        pool_(options.jobs, options.limits) {}

  IndexSummary run() {
    load_records();
    set_unchanged_aside();
    observer_.on_start(pending_.size() + found_.unusable.size());
    for (const UnusablePath& unusable : found_.unusable) store_unusable(unusable);
    process_pending();
    if (!summary_.is_interrupted) treat_vanished();
    if (!summary_.is_interrupted) complete_signatures();
    std::ranges::sort(summary_.failures, {}, &IndexFailure::path);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - found_.started;
    summary_.seconds = elapsed.count();
    return std::move(summary_);
  }

 private:
  struct Job {
    FoundFile file;             ///< its path may be that of a solid
    bool must_compute = false;  ///< even if the content is known
    std::size_t solids = 0;     ///< of the file, if it was divided
  };

  void load_records() {
    std::vector<ShapeRecord> shapes = store_.shapes();
    is_per_solid_ = options_.is_per_solid.value_or(std::ranges::any_of(shapes, is_solid));
    for (ShapeRecord& record : shapes) {
      remember(record);
      std::string path = record.path;
      records_.emplace(std::move(path), std::move(record));
    }
  }

  void tell(IndexChange::Kind kind, const std::string& path, const std::string& old_path = {}) {
    observer_.on_change({.kind = kind, .path = path, .old_path = old_path});
  }

  void remember(const ShapeRecord& record) {
    if (!record.content_hash.empty() && is_model(record)) {
      known_keys_.insert(content_key(record.content_hash, record.path));
    }
  }

  const ShapeRecord* find_record(const std::string& path) const {
    const auto found = records_.find(path);
    return found == records_.end() ? nullptr : &found->second;
  }

  /// Whether a record is a model in this run: a file of several solids is none if these are.
  bool is_model(const ShapeRecord& record) const {
    return !is_per_solid_ || !is_brep_file(record.path) || solids_of(record).value_or(2) < 2;
  }

  const ShapeRecord* find_unchanged(const FoundFile& file) const {
    const ShapeRecord* record = find_record(file.path);
    const bool is_unchanged = record != nullptr && record->file_size == file.size &&
                              record->modified_ns == file.modified_ns &&
                              record->failure != FailureKind::unreadable;
    return is_unchanged && !options_.force && is_model(*record) ? record : nullptr;
  }

  /// @returns false if the model may have changed
  bool pass_over(const FoundFile& file) {
    const ShapeRecord* record = find_unchanged(file);
    if (record == nullptr) return false;
    models_.insert(file.path);
    count_known(*record, summary_.unchanged);
    return true;
  }

  void set_unchanged_aside() {
    for (const FoundFile& file : found_.files) {
      if (pass_over(file)) continue;
      if (const std::size_t solids = unchanged_solids(file); solids > 0) {
        divide({file}, solids);
      } else {
        pending_.push_back({file, options_.force});
      }
    }
  }

  /// How many solids a file has that is plainly unchanged; 0 if that is not known.
  std::size_t unchanged_solids(const FoundFile& file) const {
    if (!is_per_solid_) return 0;
    const ShapeRecord* first = find_unchanged(solid_of(file, 1));
    return first == nullptr ? 0 : solids_of(*first).value_or(0);
  }

  static FoundFile solid_of(FoundFile file, std::size_t solid) {
    file.path = solid_path(file.path, solid);
    return file;
  }

  /// Makes jobs of the solids of a file, but for those that are unchanged.
  void divide(const Job& job, std::size_t solids) {
    for (std::size_t solid = solids; solid > 0; --solid) {
      const FoundFile model = solid_of(job.file, solid);
      if (!pass_over(model)) pending_.push_front({model, job.must_compute, solids});
    }
  }

  /// Counts a model of which nothing was computed; a failed one stays a failure.
  void count_known(const ShapeRecord& record, std::size_t& counter) {
    if (record.status == ShapeStatus::failed) {
      summary_.failures.push_back({record.path, record.reason, true});
    } else {
      ++counter;
    }
  }

  /// Keeps what is stored of a file that vanished, here during the run or behind a link.
  void store_failure(const ShapeRecord& record) {
    const ShapeRecord* old = find_record(record.path);
    const bool has_data = old != nullptr && old->status == ShapeStatus::indexed;
    if (!has_data || !is_gone(record.path)) store_.put(record, {});
    summary_.failures.push_back({record.path, record.reason, false});
    observer_.on_failure(summary_.failures.back());
  }

  void store_unusable(const UnusablePath& unusable) {
    ShapeRecord record;
    record.path = unusable.path;
    record.status = ShapeStatus::failed;
    record.failure = FailureKind::unreadable;
    record.reason = unusable.reason;
    models_.insert(record.path);
    store_failure(record);
    observer_.on_model_done(true);
  }

  void process_pending() {
    while (true) {
      summary_.is_interrupted = !pending_.empty() && observer_.is_interrupted();
      while (!summary_.is_interrupted && !pending_.empty() && !pool_.is_full()) start_next_job();
      if (pool_.is_empty()) break;
      for (const ProcessOutcome& outcome : pool_.wait(wait_interval)) finish_job(outcome);
      observer_.on_wait();
    }
    summary_.left = pending_.size();
  }

  void start_next_job() {
    const std::size_t number = next_job_++;
    const Job& job = running_[number] = std::move(pending_.front());
    pending_.pop_front();
    static const std::unordered_set<std::string> nothing;
    const auto& known = job.must_compute ? nothing : known_keys_;
    preload_reader(job.file.path);
    pool_.start(number, [&](const SendOutput& send) {
      run_model_job(job.file.path, known, describe_, send, is_per_solid_);
    });
  }

  void finish_job(const ProcessOutcome& outcome) {
    const Job job = std::move(running_.extract(outcome.job).mapped());
    const std::size_t failures_before = summary_.failures.size();
    ModelResult result = read_model_result(outcome);
    if (result.solids > 1) {
      const std::size_t pending_before = pending_.size();
      divide(job, result.solids);
      observer_.on_more_models(pending_.size() - pending_before);
      observer_.on_model_done(false);
      return;
    }
    models_.insert(job.file.path);
    if (!result.is_known) {
      result.record = with_file(std::move(result.record), job.file);
      if (is_per_solid_ && result.record.status == ShapeStatus::failed) {
        result.record.statistics = note_solids(job.solids);
      }
      store_computed(result);
    } else if (!use_known(job.file, result.record.content_hash)) {
      // What was known when the job started has been replaced since.
      pending_.push_front({job.file, true, job.solids});
      return;
    }
    observer_.on_model_done(summary_.failures.size() > failures_before);
  }

  void store_computed(const ModelResult& result) {
    const ShapeRecord& record = result.record;
    if (record.status == ShapeStatus::failed) {
      store_failure(record);
    } else {
      store_.put(record, result.data);
      ++summary_.indexed;
      tell(IndexChange::Kind::indexed, record.path);
    }
    remember(record);
  }

  /// Brings the record of a file up to date whose content the store has, read in the same way.
  /// @returns false if it has it no more
  bool use_known(const FoundFile& file, const std::string& content_hash) {
    std::vector<ShapeRecord> known = store_.find_by_hash(content_hash);
    const std::string key = content_key(content_hash, file.path);
    std::erase_if(known, [&](const ShapeRecord& record) {
      return content_key(content_hash, record.path) != key || !is_model(record);
    });
    if (known.empty()) return false;
    const auto own = std::ranges::find(known, file.path, &ShapeRecord::path);
    if (own != known.end()) {
      store_.touch(own->id, file.size, file.modified_ns);
      count_known(*own, summary_.unchanged);
      return true;
    }
    const auto moved = std::ranges::find_if(known, [&](const ShapeRecord& record) {
      return find_record(record.path) != nullptr && is_gone(record.path) &&
             is_within(record.path, found_.roots);
    });
    if (moved != known.end()) {
      store_.move(moved->id, file.path, file.modified_ns);
      records_.erase(moved->path);
      tell(IndexChange::Kind::moved, file.path, moved->path);
      count_known(with_file(*moved, file), summary_.moved);
    } else {
      ModelResult copy;
      copy.record = with_file(known.front(), file);
      copy.data = store_.data(known.front().id);
      store_computed(copy);
    }
    return true;
  }

  /// Counts, or removes, what the store has of files that are gone. Removed with them are failures
  /// that are none any more, such as that of a folder that can be read again. What is not a model
  /// of its file any more, such as a solid that is gone, is removed.
  void treat_vanished() {
    std::unordered_set<std::string> found;
    for (const FoundFile& file : found_.files) found.insert(file.path);
    for (const UnusablePath& unusable : found_.unusable) found.insert(unusable.path);
    for (const auto& [path, record] : records_) {
      if (models_.contains(path) || !is_within(path, found_.roots)) continue;
      const bool is_replaced =
          !is_gone(path) && found.contains(split_solid_path(path).file.string());
      const bool is_obsolete = is_gone(path) || record.status == ShapeStatus::failed;
      if (is_replaced || (options_.prune && is_obsolete)) {
        store_.remove(record.id);
        ++summary_.removed;
        tell(IndexChange::Kind::removed, path);
      } else if (is_gone(path)) {
        ++summary_.gone;
        tell(IndexChange::Kind::gone, path);
      }
    }
  }

  /// What is done is stored at once, as with the models.
  void complete_signatures() {
    for (const std::int64_t id : store_.shapes_without(stored_mdbd_fused)) {
      summary_.is_interrupted = observer_.is_interrupted();
      if (summary_.is_interrupted) return;
      const std::optional<ShapeRecord> record = store_.find(id);
      if (!record) continue;
      store_.put_vector(id, stored_mdbd_fused, compute_fused_signature(store_.data(id).balls));
      ++summary_.completed;
      observer_.on_wait();
    }
  }

  const Discovery& found_;
  const IndexOptions& options_;
  const DescribeFunction& describe_;
  ShapeStore& store_;
  IndexObserver& observer_;
  ProcessPool pool_;
  std::unordered_map<std::string, ShapeRecord> records_;  ///< as they were at the start, by path
  std::unordered_set<std::string> known_keys_;
  bool is_per_solid_ = false;
  std::unordered_set<std::string> models_;  ///< paths of what the files found hold
  std::deque<Job> pending_;
  std::unordered_map<std::size_t, Job> running_;  ///< by number
  std::size_t next_job_ = 0;
  IndexSummary summary_;
};

}  // namespace

IndexSummary run_index(const Discovery& found, const IndexOptions& options,
                       const DescribeFunction& describe, ShapeStore& store,
                       IndexObserver& observer) {
  return IndexRun(found, options, describe, store, observer).run();
}

}  // namespace mdbd
