#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/core/recipe.h"
#include "store/shape_record.h"
#include "store/vector_table.h"

namespace mdbd {

/// The collection: shapes, their vectors and balls, and the recipe they were computed with. An
/// interface, so that other databases than SQLite can stand behind it. Not thread-safe; several
/// processes may have one database open.
///
/// Every function throws StoreError when the database cannot do what is asked or is found damaged;
/// the message begins with the path of the database. Changes are durable when a function returns:
/// neither a kill nor a loss of power loses one or leaves half a model.
class ShapeStore {
 public:
  virtual ~ShapeStore() = default;

  /// The recipe of every vector in the store.
  virtual const Recipe& recipe() const = 0;

  virtual std::vector<ShapeRecord> shapes() const = 0;  ///< ordered by path
  virtual std::optional<ShapeRecord> find(std::int64_t id) const = 0;
  virtual std::optional<ShapeRecord> find_by_path(const std::string& path) const = 0;
  /// All records with this content, ordered by path; none for an empty hash.
  virtual std::vector<ShapeRecord> find_by_hash(const std::string& content_hash) const = 0;

  /// Stores a model with its data in one transaction, in place of what was stored for its path. The
  /// id of a path that is there is kept; the id and the time in the record are ignored. Data of a
  /// failed model is dropped.
  /// @pre status and failure kind agree; the signature of an indexed model has the recipe's k + m
  ///      numbers; all numbers are finite
  /// @returns the id
  /// @throws StoreError also if a precondition does not hold
  virtual std::int64_t put(const ShapeRecord& record, const ShapeData& data) = 0;

  /// Notes that a file is unchanged although its size or time was not what is stored.
  virtual void touch(std::int64_t id, std::uint64_t file_size, std::int64_t modified_ns) = 0;

  /// Notes that a file was moved: everything but the path and the time stays. As when a file is
  /// renamed, what was stored for the new path is replaced.
  virtual void move(std::int64_t id, const std::string& path, std::int64_t modified_ns) = 0;

  /// Removes a model with its data; does nothing if it is not there.
  virtual void remove(std::int64_t id) = 0;

  /// Vectors and balls of one model; all empty if it failed.
  virtual ShapeData data(std::int64_t id) const = 0;

  /// Stores one more signature of an indexed model, in place of what was stored under its name and,
  /// if that has a "/", under every name that begins with the same up to there, such as
  /// "mdbd-fused/1" for "mdbd-fused/2". It goes when the model is put again.
  /// @pre the signature is not mdbd-100, which put() stores; all numbers are finite
  /// @throws StoreError also if a precondition does not hold or there is no such model
  virtual void put_vector(std::int64_t id, std::string_view signature,
                          std::span<const float> values) = 0;

  /// The indexed models that have no vector of a signature, ordered by path.
  virtual std::vector<std::int64_t> shapes_without(std::string_view signature) const = 0;

  /// All vectors of a signature, ordered by path; of one state of the collection, even if another
  /// process writes meanwhile.
  /// @throws StoreError also if they are not all of one dimension
  virtual VectorTable vectors(std::string_view signature) const = 0;

  /// Names the state of the vectors of all signatures with their paths and scales: another one
  /// after every change, whoever makes it, and never the same for two states, also of two databases
  /// one of which was copied from the other. Empty if the store cannot tell.
  virtual std::string revision() const = 0;
};

/// Opens the SQLite database at a path for reading and writing, and creates it with this recipe if
/// it does not exist; without a recipe a new database gets the default one, an existing one keeps
/// its own. A database of an older schema is brought up to date.
/// @throws StoreError if the file is no database, truncated, foreign, of a newer schema, of another
///         recipe, locked for too long or in a place that cannot be written; the message says what
///         to do
std::unique_ptr<ShapeStore> open_store(const std::filesystem::path& path,
                                       const std::optional<Recipe>& recipe = std::nullopt);

/// As open_store(), but a recipe of its own that an existing database has is no error. What a
/// killed program left before it wrote anything, an empty file, is a new database.
std::unique_ptr<ShapeStore> open_or_create_store(const std::filesystem::path& path,
                                                 const Recipe& recipe_if_new);

/// Opens an existing SQLite database for reading only, also one of an older schema; works in
/// read-only places. Nothing is created that stays.
/// @throws StoreError as open_store, and if the file does not exist
std::unique_ptr<const ShapeStore> open_store_read_only(const std::filesystem::path& path);

}  // namespace mdbd
