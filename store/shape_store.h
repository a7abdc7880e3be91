#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/core/recipe.h"
#include "store/shape_record.h"

namespace mdbd {

/// The collection: shapes, their vectors and balls, and the recipe they were computed with. An
/// interface, so that other databases than SQLite can stand behind it. Not thread-safe; several
/// processes may have one database open.
/// Every function throws StoreError when the database cannot do what is asked.
class ShapeStore {
 public:
  virtual ~ShapeStore() = default;

  /// The recipe of every vector in the store.
  virtual const Recipe& recipe() const = 0;

  virtual std::vector<ShapeRecord> shapes() const = 0;  ///< ordered by path
  virtual std::optional<ShapeRecord> find(std::int64_t id) const = 0;
  virtual std::optional<ShapeRecord> find_by_path(const std::string& path) const = 0;
  /// All records with this content, ordered by path.
  virtual std::vector<ShapeRecord> find_by_hash(const std::string& content_hash) const = 0;

  /// Stores a model with its data in one transaction, in place of what was stored for its path. The
  /// id of a path that is there is kept. A failed model has no data.
  /// @returns the id
  virtual std::int64_t put(const ShapeRecord& record, const ShapeData& data) = 0;

  /// Notes that a file is unchanged although its size or time was not what is stored.
  virtual void touch(std::int64_t id, std::uint64_t file_size, std::int64_t modified_ns) = 0;

  /// Notes that a file was moved: everything but the path and the time stays.
  virtual void move(std::int64_t id, const std::string& path, std::int64_t modified_ns) = 0;

  virtual void remove(std::int64_t id) = 0;

  /// Vector and balls of one model; empty vectors if it failed.
  virtual ShapeData data(std::int64_t id) const = 0;

  /// All vectors of a signature, ordered by path.
  virtual std::vector<StoredVector> vectors(std::string_view signature) const = 0;
};

/// Opens the SQLite database at a path for reading and writing, and creates it with this recipe if
/// it does not exist; without a recipe a new database gets the default one, an existing one keeps
/// its own.
/// @throws StoreError if the file is no database, truncated, foreign, of a newer schema, of another
///         recipe, locked for too long or in a place that cannot be written; the message says what
///         to do
std::unique_ptr<ShapeStore> open_store(const std::filesystem::path& path,
                                       const std::optional<Recipe>& recipe = std::nullopt);

/// Opens an existing SQLite database for reading only; works in read-only places.
/// @throws StoreError as open_store, and if the file does not exist
std::unique_ptr<const ShapeStore> open_store_read_only(const std::filesystem::path& path);

}  // namespace mdbd
