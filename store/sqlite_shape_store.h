#pragma once

#include "store/shape_store.h"
#include "store/sqlite_database.h"

namespace mdbd {

/// The store in a SQLite database whose schema is current. Open it with open_store() or
/// open_store_read_only(): only they look at what the file is.
class SqliteShapeStore : public ShapeStore {
 public:
  /// @throws StoreError if the recipe in the database is damaged
  explicit SqliteShapeStore(Database database);

  const Recipe& recipe() const override { return recipe_; }
  std::vector<ShapeRecord> shapes() const override;
  std::optional<ShapeRecord> find(std::int64_t id) const override;
  std::optional<ShapeRecord> find_by_path(const std::string& path) const override;
  std::vector<ShapeRecord> find_by_hash(const std::string& content_hash) const override;
  std::int64_t put(const ShapeRecord& record, const ShapeData& data) override;
  void touch(std::int64_t id, std::uint64_t file_size, std::int64_t modified_ns) override;
  void move(std::int64_t id, const std::string& path, std::int64_t modified_ns) override;
  void remove(std::int64_t id) override;
  void put_vector(std::int64_t id, std::string_view signature,
                  std::span<const float> values) override;
  std::vector<std::int64_t> shapes_without(std::string_view signature) const override;
  ShapeData data(std::int64_t id) const override;
  VectorTable vectors(std::string_view signature) const override;
  std::string revision() const override;

 private:
  template <typename... Values>
  std::vector<ShapeRecord> select(std::string_view condition, const Values&... values) const;
  ShapeRecord read_record(const Statement& row) const;
  std::vector<float> read_vector(std::span<const std::byte> bytes, const std::string& path) const;
  void append(VectorTableBuilder& table, const StoredVector& vector) const;
  std::vector<float> read_signature(std::span<const std::byte> bytes,
                                    const std::string& path) const;
  std::vector<Ball> read_balls(std::span<const std::byte> bytes, const std::string& path) const;
  void check_can_be_stored(const ShapeRecord& record, const ShapeData& data) const;
  std::int64_t put_record(const ShapeRecord& record);
  void put_data(std::int64_t id, const ShapeData& data);
  std::string thumbnail(std::int64_t id) const;
  void insert_vector(std::int64_t id, std::string_view signature, std::span<const float> values);
  void require_changed(std::int64_t id) const;
  void require_in_place() const;
  [[noreturn]] void fail_damaged(const std::string& what) const;
  std::size_t signature_size() const;

  Database database_;
  Recipe recipe_;
};

}  // namespace mdbd
