#pragma once

#include <memory>

#include "store/shape_store.h"

namespace mdbd {

/// Shows an existing store, or an empty one, and forgets everything that is written to it: a run on
/// it tells what a real run would do.
class DryRunStore final : public ShapeStore {
 public:
  /// @param store may be null: an empty store
  DryRunStore(std::unique_ptr<const ShapeStore> store, const Recipe& recipe)
      : store_(std::move(store)), recipe_(recipe) {}

  const Recipe& recipe() const override { return recipe_; }
  std::vector<ShapeRecord> shapes() const override {
    return store_ ? store_->shapes() : std::vector<ShapeRecord>{};
  }
  std::optional<ShapeRecord> find(std::int64_t id) const override {
    return store_ ? store_->find(id) : std::nullopt;
  }
  std::optional<ShapeRecord> find_by_path(const std::string& path) const override {
    return store_ ? store_->find_by_path(path) : std::nullopt;
  }
  std::vector<ShapeRecord> find_by_hash(const std::string& content_hash) const override {
    return store_ ? store_->find_by_hash(content_hash) : std::vector<ShapeRecord>{};
  }
  ShapeData data(std::int64_t id) const override { return store_ ? store_->data(id) : ShapeData{}; }
  VectorTable vectors(std::string_view signature) const override {
    return store_ ? store_->vectors(signature) : VectorTable();
  }
  std::string revision() const override { return store_ ? store_->revision() : std::string(); }
  std::vector<std::int64_t> shapes_without(std::string_view signature) const override {
    return store_ ? store_->shapes_without(signature) : std::vector<std::int64_t>{};
  }

  std::int64_t put(const ShapeRecord&, const ShapeData&) override { return 0; }
  void touch(std::int64_t, std::uint64_t, std::int64_t) override {}
  void move(std::int64_t, const std::string&, std::int64_t) override {}
  void remove(std::int64_t) override {}
  void put_vector(std::int64_t, std::string_view, std::span<const float>) override {}

 private:
  std::unique_ptr<const ShapeStore> store_;
  Recipe recipe_;
};

}  // namespace mdbd
