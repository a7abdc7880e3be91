#include "store/sqlite_shape_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "store/blob_codec.h"
#include "store/sqlite_diagnosis.h"
#include "store/sqlite_schema.h"

namespace mdbd {
namespace {

constexpr std::string_view select_shapes =
    "SELECT id, path, content_hash, file_size, modified_ns, format, representation, statistics,"
    " scale, status, failure, reason, walk_is_defined, seconds, indexed_at FROM shapes ";

constexpr std::string_view upsert_shape =
    "INSERT INTO shapes (path, content_hash, file_size, modified_ns, format, representation,"
    " statistics, scale, status, failure, reason, walk_is_defined, seconds, indexed_at)"
    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))"
    " ON CONFLICT (path) DO UPDATE SET content_hash = excluded.content_hash,"
    " file_size = excluded.file_size, modified_ns = excluded.modified_ns,"
    " format = excluded.format, representation = excluded.representation,"
    " statistics = excluded.statistics, scale = excluded.scale, status = excluded.status,"
    " failure = excluded.failure, reason = excluded.reason,"
    " walk_is_defined = excluded.walk_is_defined, seconds = excluded.seconds,"
    " indexed_at = excluded.indexed_at RETURNING id";

constexpr std::array statuses = {ShapeStatus::indexed, ShapeStatus::failed};
constexpr std::array failure_kinds = {FailureKind::none, FailureKind::content,
                                      FailureKind::unreadable, FailureKind::budget,
                                      FailureKind::crash};

template <typename Enum, std::size_t count>
std::optional<Enum> from_string(const std::array<Enum, count>& values, const std::string& text) {
  for (const Enum value : values) {
    if (to_string(value) == text) return value;
  }
  return std::nullopt;
}

bool is_finite(const Ball& ball) { return ball.center.allFinite() && std::isfinite(ball.radius); }

bool all_finite(const std::vector<Ball>& balls) {
  return std::all_of(balls.begin(), balls.end(), is_finite);
}

bool all_finite(std::span<const float> values) {
  return std::all_of(values.begin(), values.end(),
                     [](float value) { return std::isfinite(value); });
}

}  // namespace

SqliteShapeStore::SqliteShapeStore(Database database)
    : database_(std::move(database)), recipe_(read_recipe(database_)) {}

std::vector<ShapeRecord> SqliteShapeStore::shapes() const { return select("ORDER BY path"); }

std::optional<ShapeRecord> SqliteShapeStore::find(std::int64_t id) const {
  std::vector<ShapeRecord> found = select("WHERE id = ?", id);
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

std::optional<ShapeRecord> SqliteShapeStore::find_by_path(const std::string& path) const {
  std::vector<ShapeRecord> found = select("WHERE path = ?", std::string_view(path));
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

std::vector<ShapeRecord> SqliteShapeStore::find_by_hash(const std::string& content_hash) const {
  if (content_hash.empty()) return {};
  return select("WHERE content_hash = ? ORDER BY path", std::string_view(content_hash));
}

std::int64_t SqliteShapeStore::put(const ShapeRecord& record, const ShapeData& data) {
  check_can_be_stored(record, data);
  Transaction transaction(database_, Transaction::Kind::writing);
  const std::int64_t id = put_record(record);
  Statement(database_, "DELETE FROM vectors WHERE shape_id = ?").bind(id).run();
  Statement(database_, "DELETE FROM balls WHERE shape_id = ?").bind(id).run();
  Statement(database_, "DELETE FROM thumbnails WHERE shape_id = ?").bind(id).run();
  if (record.status == ShapeStatus::indexed) put_data(id, data);
  transaction.commit();
  require_in_place();
  return id;
}

void SqliteShapeStore::touch(std::int64_t id, std::uint64_t file_size, std::int64_t modified_ns) {
  Statement(database_, "UPDATE shapes SET file_size = ?, modified_ns = ? WHERE id = ?")
      .bind(static_cast<std::int64_t>(file_size), modified_ns, id)
      .run();
  require_changed(id);
  require_in_place();
}

void SqliteShapeStore::move(std::int64_t id, const std::string& path, std::int64_t modified_ns) {
  Transaction transaction(database_, Transaction::Kind::writing);
  Statement(database_, "DELETE FROM shapes WHERE path = ? AND id <> ?")
      .bind(std::string_view(path), id)
      .run();
  Statement(database_, "UPDATE shapes SET path = ?, modified_ns = ? WHERE id = ?")
      .bind(std::string_view(path), modified_ns, id)
      .run();
  require_changed(id);
  transaction.commit();
  require_in_place();
}

void SqliteShapeStore::remove(std::int64_t id) {
  Statement(database_, "DELETE FROM shapes WHERE id = ?").bind(id).run();
  require_in_place();
}

void SqliteShapeStore::put_vector(std::int64_t id, std::string_view signature,
                                  std::span<const float> values) {
  if (signature == signature_mdbd_100) {
    throw StoreError(database_.path().string() + ": mdbd-100 is stored with its model only");
  }
  if (!all_finite(values)) {
    throw StoreError(database_.path().string() + ": a number of a vector of " +
                     std::string(signature) + " is not finite");
  }
  const Blob vector = encode_floats(values);
  Transaction transaction(database_, Transaction::Kind::writing);
  Statement(database_,
            "INSERT OR REPLACE INTO vectors (shape_id, signature, \"values\")"
            " SELECT id, ?, ? FROM shapes WHERE id = ? AND status = ?")
      .bind(signature, std::span<const std::byte>(vector), id, to_string(ShapeStatus::indexed))
      .run();
  require_changed(id);
  Statement(database_,
            "DELETE FROM vectors WHERE shape_id = ? AND signature <> ?"
            " AND instr(?, '/') > 0 AND instr(signature, substr(?, 1, instr(?, '/'))) = 1")
      .bind(id, signature, signature, signature, signature)
      .run();
  transaction.commit();
  require_in_place();
}

ShapeData SqliteShapeStore::data(std::int64_t id) const {
  const Transaction reading(database_, Transaction::Kind::reading);
  Statement row(database_,
                "SELECT s.path, s.status, v.\"values\", b.\"values\", f.\"values\" FROM shapes s"
                " LEFT JOIN vectors v ON v.shape_id = s.id AND v.signature = ?"
                " LEFT JOIN vectors f ON f.shape_id = s.id AND f.signature = ?"
                " LEFT JOIN balls b ON b.shape_id = s.id WHERE s.id = ?");
  row.bind(signature_mdbd_100, stored_mdbd_fused, id);
  if (!row.step()) {
    throw StoreError(database_.path().string() + ": holds no model " + std::to_string(id));
  }
  if (row.text(1) != to_string(ShapeStatus::indexed)) return {};
  const std::string path = row.text(0);
  return {read_balls(row.bytes(3), path), read_signature(row.bytes(2), path),
          read_vector(row.bytes(4), path), thumbnail(id)};
}

// A database of schema 1 has no pictures.
std::string SqliteShapeStore::thumbnail(std::int64_t id) const {
  Statement table(database_, "SELECT 1 FROM sqlite_schema WHERE name = 'thumbnails'");
  if (!table.step()) return {};
  Statement row(database_, "SELECT png FROM thumbnails WHERE shape_id = ?");
  row.bind(id);
  if (!row.step()) return {};
  const std::span<const std::byte> png = row.bytes(0);
  return {reinterpret_cast<const char*>(png.data()), png.size()};
}

std::vector<std::int64_t> SqliteShapeStore::shapes_without(std::string_view signature) const {
  std::vector<std::int64_t> result;
  Statement row(database_,
                "SELECT id FROM shapes WHERE status = ? AND NOT EXISTS (SELECT 1 FROM vectors"
                " WHERE shape_id = shapes.id AND signature = ?) ORDER BY path");
  row.bind(to_string(ShapeStatus::indexed), signature);
  while (row.step()) result.push_back(row.integer(0));
  return result;
}

// One statement sees one state of the database, however long it runs and whoever writes meanwhile.
VectorTable SqliteShapeStore::vectors(std::string_view signature) const {
  VectorTableBuilder table;
  Statement row(database_,
                "SELECT s.id, s.path, s.scale, v.\"values\" FROM shapes s"
                " JOIN vectors v ON v.shape_id = s.id"
                " WHERE s.status = ? AND v.signature = ? ORDER BY s.path");
  row.bind(to_string(ShapeStatus::indexed), signature);
  while (row.step()) {
    const std::string path = row.text(1);
    const std::vector<float> values = signature == signature_mdbd_100
                                          ? read_signature(row.bytes(3), path)
                                          : read_vector(row.bytes(3), path);
    append(table, {row.integer(0), path, row.real(2), values});
  }
  return table.take();
}

void SqliteShapeStore::append(VectorTableBuilder& table, const StoredVector& vector) const {
  try {
    table.append(vector);
  } catch (const InvalidInput& error) {
    fail_damaged(error.what());
  }
}

std::string SqliteShapeStore::revision() const { return read_revision(database_); }

template <typename... Values>
std::vector<ShapeRecord> SqliteShapeStore::select(std::string_view condition,
                                                  const Values&... values) const {
  std::vector<ShapeRecord> records;
  Statement row(database_, std::string(select_shapes).append(condition));
  row.bind(values...);
  while (row.step()) records.push_back(read_record(row));
  return records;
}

ShapeRecord SqliteShapeStore::read_record(const Statement& row) const {
  ShapeRecord record;
  record.id = row.integer(0);
  record.path = row.text(1);
  record.content_hash = row.text(2);
  record.file_size = static_cast<std::uint64_t>(row.integer(3));
  record.modified_ns = row.integer(4);
  record.format = row.text(5);
  record.representation = row.text(6);
  record.statistics = row.text(7);
  record.scale = row.real(8);
  const auto status = from_string(statuses, row.text(9));
  const auto failure = from_string(failure_kinds, row.text(10));
  if (!status || !failure) fail_damaged("status of " + record.path);
  record.status = *status;
  record.failure = *failure;
  record.reason = row.text(11);
  record.walk_is_defined = row.integer(12) != 0;
  record.seconds = row.real(13);
  record.indexed_at = row.text(14);
  return record;
}

std::vector<float> SqliteShapeStore::read_signature(std::span<const std::byte> bytes,
                                                    const std::string& path) const {
  const std::size_t expected = signature_size() * bytes_per_float;
  if (bytes.size() != expected) {
    fail_damaged("vector of " + path + ": " + std::to_string(bytes.size()) + " bytes instead of " +
                 std::to_string(expected));
  }
  return read_vector(bytes, path);
}

std::vector<float> SqliteShapeStore::read_vector(std::span<const std::byte> bytes,
                                                 const std::string& path) const {
  if (bytes.size() % bytes_per_float != 0) {
    fail_damaged("vector of " + path + ": " + std::to_string(bytes.size()) +
                 " bytes, no multiple of " + std::to_string(bytes_per_float));
  }
  std::vector<float> values = decode_floats(bytes);
  if (!all_finite(values)) fail_damaged("vector of " + path + ": a number is not finite");
  return values;
}

std::vector<Ball> SqliteShapeStore::read_balls(std::span<const std::byte> bytes,
                                               const std::string& path) const {
  if (bytes.size() % bytes_per_ball != 0) {
    fail_damaged("balls of " + path + ": " + std::to_string(bytes.size()) +
                 " bytes, no multiple of " + std::to_string(bytes_per_ball));
  }
  std::vector<Ball> balls = decode_balls(bytes);
  if (!all_finite(balls)) fail_damaged("balls of " + path + ": a number is not finite");
  return balls;
}

void SqliteShapeStore::check_can_be_stored(const ShapeRecord& record, const ShapeData& data) const {
  const auto refuse = [&](const std::string& why) {
    throw StoreError(database_.path().string() + ": " + record.path + " cannot be stored: " + why);
  };
  const bool is_indexed = record.status == ShapeStatus::indexed;
  if (is_indexed != (record.failure == FailureKind::none)) refuse("status and failure disagree");
  if (!std::isfinite(record.scale) || !std::isfinite(record.seconds)) {
    refuse("scale or time is not finite");
  }
  if (!is_indexed) return;
  if (data.signature.size() != signature_size()) {
    refuse("its vector has " + std::to_string(data.signature.size()) + " numbers instead of " +
           std::to_string(signature_size()));
  }
  if (!all_finite(data.signature) || !all_finite(data.fused)) {
    refuse("a number of its vector is not finite");
  }
  if (!all_finite(data.balls)) refuse("a number of its balls is not finite");
}

std::int64_t SqliteShapeStore::put_record(const ShapeRecord& record) {
  const auto text = [](const std::string& value) { return std::string_view(value); };
  Statement statement(database_, upsert_shape);
  statement.bind(text(record.path), text(record.content_hash),
                 static_cast<std::int64_t>(record.file_size), record.modified_ns,
                 text(record.format), text(record.representation), text(record.statistics),
                 record.scale, to_string(record.status), to_string(record.failure),
                 text(record.reason), std::int64_t{record.walk_is_defined}, record.seconds);
  statement.step();
  const std::int64_t id = statement.integer(0);
  statement.run();
  return id;
}

void SqliteShapeStore::put_data(std::int64_t id, const ShapeData& data) {
  insert_vector(id, signature_mdbd_100, data.signature);
  if (!data.fused.empty()) insert_vector(id, stored_mdbd_fused, data.fused);
  const Blob balls = encode_balls(data.balls);
  Statement(database_, "INSERT INTO balls (shape_id, \"values\") VALUES (?, ?)")
      .bind(id, std::span<const std::byte>(balls))
      .run();
  if (data.thumbnail.empty()) return;
  Statement(database_, "INSERT INTO thumbnails (shape_id, png) VALUES (?, ?)")
      .bind(id, std::as_bytes(std::span(data.thumbnail)))
      .run();
}

void SqliteShapeStore::insert_vector(std::int64_t id, std::string_view signature,
                                     std::span<const float> values) {
  const Blob vector = encode_floats(values);
  Statement(database_, "INSERT INTO vectors (shape_id, signature, \"values\") VALUES (?, ?, ?)")
      .bind(id, signature, std::span<const std::byte>(vector))
      .run();
}

void SqliteShapeStore::require_changed(std::int64_t id) const {
  if (database_.changes() == 1) return;
  throw StoreError(database_.path().string() + ": holds no model " + std::to_string(id));
}

// SQLite goes on writing to a file that has no name any more.
void SqliteShapeStore::require_in_place() const {
  if (!database_.has_moved()) return;
  throw StoreError(database_.path().string() +
                   ": was moved, replaced or removed while it was in use; run the same command "
                   "again");
}

void SqliteShapeStore::fail_damaged(const std::string& what) const {
  throw StoreError(explain_damage(database_.path(), what));
}

std::size_t SqliteShapeStore::signature_size() const {
  return static_cast<std::size_t>(recipe_.descriptor_balls) +
         static_cast<std::size_t>(recipe_.walk_steps);
}

}  // namespace mdbd
