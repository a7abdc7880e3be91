#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collection/discover.h"
#include "collection/model_job.h"
#include "collection/process_pool.h"
#include "store/shape_store.h"

namespace mdbd {

struct IndexOptions {
  std::size_t jobs = 1;  ///< models computed at the same time, each in a process of its own
  ProcessLimits limits;  ///< of one model
  bool force = false;    ///< compute every model again, even if its file is unchanged
  bool prune = false;    ///< remove the records of files that are gone
  /// Each solid of a CAD file of several is a model, by its solid_path(). Not given: as the store
  /// has it, which is so if it has a solid.
  std::optional<bool> is_per_solid = std::nullopt;
};

/// A model that could not be read or decomposed.
struct IndexFailure {
  std::string path;
  std::string reason;
  bool is_old = false;  ///< known from an earlier run and not tried again
};

/// What became of a model, where that changed something.
struct IndexChange {
  enum class Kind { indexed, moved, removed, gone };
  Kind kind = Kind::indexed;
  std::string path;
  std::string old_path;  ///< of a model that moved
};

/// What a run did. Every model found counts once, as indexed, unchanged, moved or failed.
struct IndexSummary {
  std::size_t indexed = 0;    ///< new or changed, and in the store now
  std::size_t unchanged = 0;  ///< same content at the same path
  std::size_t moved = 0;      ///< same content at another path than before
  std::size_t removed = 0;    ///< records removed: their files, or solids of these, are gone
  std::size_t gone = 0;       ///< records kept although their files are gone
  std::size_t left = 0;       ///< models not looked at, if the run was interrupted
  std::size_t completed = 0;  ///< models that gained the signature mdbd-fused from their balls
  bool is_interrupted = false;
  double seconds = 0.0;                ///< since the search for files began
  std::vector<IndexFailure> failures;  ///< old and new, ordered by path
};

/// Hears about a run while it goes on, and can end it.
class IndexObserver {
 public:
  virtual ~IndexObserver() = default;
  virtual void on_start(std::size_t models) = 0;  ///< models that are not plainly unchanged
  /// A file, itself counted and done, has so many solids that are models.
  virtual void on_more_models(std::size_t /*models*/) {}
  virtual void on_model_done(bool has_failed) = 0;
  virtual void on_failure(const IndexFailure& failure) = 0;  ///< new ones only
  virtual void on_change(const IndexChange& /*change*/) {}
  virtual void on_wait() = 0;  ///< about ten times a second
  /// True ends the run: models in flight are finished and stored, no other is started.
  virtual bool is_interrupted() = 0;
};

/// Brings a store up to date with what was found at and below some paths.
///
/// A file of the size and time that are stored costs nothing more. Otherwise its content is hashed:
/// content that the store has under the same ending is not computed again but noted as unchanged,
/// moved (its old file, also at or below the paths, is gone) or copied. Everything else goes to
/// `describe`, in a process of its own. A failure is stored with its reason. Failures of content,
/// budget and crashes are tried again when the content changes, or with `force`; unreadable files
/// at every run. Only records of files at or below the paths are touched.
///
/// Per solid, the solids of a file that is not plainly unchanged are counted first; each is then
/// treated as a file is. Records of a file that are none of its models any more, such as that of
/// the whole, are removed.
///
/// Each model is stored as soon as it is computed, so that a killed run loses only the models in
/// flight. Records do not depend on the number of jobs, but the ids of new ones may.
///
/// At the end all models of the store that have no mdbd-fused, such as those of a database made
/// before there was one, gain it from their stored balls.
/// @throws IoError if no process can be started
/// @throws StoreError if the store fails
IndexSummary run_index(const Discovery& found, const IndexOptions& options,
                       const DescribeFunction& describe, ShapeStore& store,
                       IndexObserver& observer);

}  // namespace mdbd
