#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "features/core/signature.h"
#include "features/describe.h"
#include "query/exact_search.h"
#include "store/shape_store.h"

namespace mdbd {

/// What is asked for.
struct QueryOptions {
  std::size_t count = 10;  ///< how many models, at least 1
  SignatureKind signature = SignatureKind::mdbd_100;
  bool has_chirality =
      false;  ///< mirrored shapes are told apart, at the price of reading all balls
  std::size_t differences = 0;  ///< how many of the numbers that differ the most are told
};

/// A query by the path it is known by, with its answer.
struct QueryAnswer {
  std::string query;  ///< the path of the file or of the indexed model
  SearchResult result;
  /// Models whose vector was computed from their balls: the database is older than the signature.
  std::size_t completed = 0;
};

/// Describes a file by a recipe; throws as describe_file() does.
using DescribeQuery = std::function<ShapeDescription(const std::filesystem::path&, const Recipe&)>;

/// The models of a collection that look most like a shape file. The file is described by the recipe
/// of the collection, so that an indexed file finds itself at distance 0.
/// @throws IoError or InvalidInput, with the path in front of the reason, if the file cannot be
/// used
/// @throws StoreError if the collection cannot be read
/// @param describe does it in a process of its own if the file is not to be trusted
QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          const QueryOptions& options = {},
                          const DescribeQuery& describe = describe_file);

/// The models of a collection that look most like one of its own, which is among them. Needs no
/// file: vector and balls are the stored ones.
/// @throws InvalidInput if there is no such model or it failed when it was indexed
/// @throws StoreError if the collection cannot be read
QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, const QueryOptions& options = {});

}  // namespace mdbd
