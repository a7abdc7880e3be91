#include "query/answer_query.h"

#include <utility>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/describe.h"

namespace mdbd {
namespace {

Descriptor describe_query(const std::filesystem::path& file, const Recipe& recipe) {
  try {
    return describe_file(file, recipe).descriptor;
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

SearchResult search(const ShapeStore& store, std::span<const float> query, std::size_t count) {
  const Recipe& recipe = store.recipe();
  const ExactSearch collection(store.vectors(signature_mdbd_100), recipe.descriptor_balls,
                               recipe.walk_weight);
  return collection.search(query, count);
}

}  // namespace

QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          std::size_t count) {
  const Descriptor descriptor = describe_query(file, store.recipe());
  return {file.string(), search(store, descriptor.values, count)};
}

QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, std::size_t count) {
  const std::optional<ShapeRecord> record = store.find(id);
  if (!record) {
    throw InvalidInput(fmt::format("no model of the database has id {}; --json shows the ids", id));
  }
  if (record->status == ShapeStatus::failed) {
    throw InvalidInput(
        fmt::format("model {} ({}) could not be indexed: {}", id, record->path, record->reason));
  }
  return {record->path, search(store, store.data(id).signature, count)};
}

}  // namespace mdbd
